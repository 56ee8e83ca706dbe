//! How a value runs over a triangle: as the screen has it, or as space has it.
//!
//! ```text
//!      a ●━━━━━━━━━┿━━━━━━━━━● b        halfway on the screen is nearer to a in space,
//!         w = 1   screen   w = 4         when b is farther: there 1/w is the mean, not w
//! ```

use super::Corner;
use super::barycentric::Barycentric;
use super::names::methods;

methods! {
    /// A way to blend a value of three vertices.
    Attribute, "way to blend" {
        Perspective, "perspective", "linear in space: weights over w, divided by their sum; the default";
        Affine, "affine", "linear on the screen: off by up to (√r − 1)/(√r + 1) of the range where w differs by the factor r";
    }
}

impl Attribute {
    /// The weights of three vertices with these `w` (positive) at a point with these weights on the screen.
    ///
    /// ```
    /// use polosa_raster::reference::attribute::Attribute;
    ///
    /// let (middle, w) = ([0.5, 0.5, 0.0], [1.0, 4.0, 1.0]);
    /// assert_eq!(Attribute::Perspective.weights(middle, w), [0.8, 0.2, 0.0]);
    /// assert_eq!(Attribute::Affine.weights(middle, w), [0.5, 0.5, 0.0]);
    /// ```
    #[must_use]
    pub fn weights(self, on_screen: [f64; 3], w: [f64; 3]) -> [f64; 3] {
        match self {
            Self::Affine => on_screen,
            Self::Perspective => {
                let [a, b, c] = [0, 1, 2].map(|k| on_screen[k] / w[k]);
                let sum = a + b + c;
                [a / sum, b / sum, c / sum]
            }
        }
    }

    /// The value at that point.
    #[must_use]
    pub fn blend(self, on_screen: [f64; 3], w: [f64; 3], values: [f64; 3]) -> f64 {
        let [a, b, c] = self.weights(on_screen, w);
        a * values[0] + b * values[1] + c * values[2]
    }
}

/// The weights of a triangle's corners at a point on the screen, in pixels; infinite or NaN where it has no area.
#[must_use]
pub fn on_screen(corners: &[Corner; 3], [x, y]: [f64; 2]) -> [f64; 3] {
    Barycentric::new(corners).at(x, y)
}
