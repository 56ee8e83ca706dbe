//! S1's camera: a location, a direction, and up.
//!
//! ```text
//!   v = u × direction                u, v and n are the rows of the view matrix, none normalised:
//!        │                           |u| = |v| = sin(angle between direction and up), if these two
//!        │   direction               have length 1
//!        │ ╱
//!        o──────── u = direction × up
//!       location         n = −direction
//! ```
//!
//! Depth runs from −1 at the near plane to 1 at the far one. The picture's y runs down after [`viewport`], as here
//! elsewhere. There is no clipping: what lies behind the eye is divided by its negative w and comes out mirrored.
//!
//! π in the seed is mistyped, 3·10⁻⁵ off; that is not kept.

use super::Fault;
use crate::reference::algebra::{Real, Rows, cross, dot, length, normalized, product, project};

/// What is done about axes that are not of unit length.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, Default)]
pub enum Axes {
    /// Nothing, as in the seed.
    #[default]
    Printed,
    /// Each is divided by its length: the obvious mending, which leaves nothing to divide by where direction and up
    /// are parallel.
    Normalized,
}

/// S1's camera.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Camera<T> {
    location: [T; 3],
    direction: [T; 3],
    parallel: bool,
    axes: Axes,
    size: [T; 2],
    view: Rows<T, 4>,
    view_projection: Rows<T, 4>,
}

/// Distance of the near plane.
const NEAR: f64 = 1.0;
/// Distance of the far plane.
const FAR: f64 = 1000.0;
/// The angle between the picture's left and right side: 70°.
const FOV: f64 = 70.0 / 180.0 * core::f64::consts::PI;

impl<T: Real> Camera<T> {
    /// At (0, 0, 10), looking along −Z with +Y up, 70° across, for a picture of this size in pixels.
    #[must_use]
    pub fn new(width: u32, height: u32) -> Self {
        let zero = T::of(0.0);
        let mut camera = Self {
            location: [zero, zero, T::of(10.0)],
            direction: [zero, zero, T::of(-1.0)],
            parallel: false,
            axes: Axes::Printed,
            size: [T::of(width.into()), T::of(height.into())],
            view: [[zero; 4]; 4],
            view_projection: [[zero; 4]; 4],
        };
        camera.refresh();
        camera
    }

    /// The same camera, mended or as printed.
    #[must_use]
    pub fn with_axes(mut self, axes: Axes) -> Self {
        self.axes = axes;
        self.refresh();
        self
    }

    /// The same camera, its numbers as they are, computed in `f64`.
    #[must_use]
    pub fn widened(&self) -> Camera<f64> {
        let mut camera = Camera {
            location: self.location.map(T::to_f64),
            direction: self.direction.map(T::to_f64),
            parallel: self.parallel,
            axes: self.axes,
            size: self.size.map(T::to_f64),
            view: [[0.0; 4]; 4],
            view_projection: [[0.0; 4]; 4],
        };
        camera.refresh();
        camera
    }

    /// Where it stands.
    #[must_use]
    pub const fn location(&self) -> [T; 3] {
        self.location
    }

    /// Where it looks.
    #[must_use]
    pub const fn direction(&self) -> [T; 3] {
        self.direction
    }

    /// Whether it projects in parallel.
    #[must_use]
    pub const fn parallel(&self) -> bool {
        self.parallel
    }

    /// Moves it. View and view-projection are renewed.
    pub fn set_location(&mut self, location: [T; 3]) {
        self.location = location;
        self.refresh();
    }

    /// Turns it. View and view-projection are renewed. The direction is meant to have length 1, and is taken as it is.
    pub fn set_direction(&mut self, direction: [T; 3]) {
        self.direction = direction;
        self.refresh();
    }

    /// Changes the projection. **View-projection is not renewed** before the camera is moved or turned: the seed's
    /// trap.
    pub const fn set_parallel(&mut self, parallel: bool) {
        self.parallel = parallel;
    }

    fn refresh(&mut self) {
        self.view = self.computed_view();
        self.view_projection = product(&self.projection(), &self.view);
    }

    fn axis(&self, v: [T; 3]) -> [T; 3] {
        match self.axes {
            Axes::Printed => v,
            Axes::Normalized => normalized(v),
        }
    }

    /// u: direction × up, up being (0, 1, 0).
    #[must_use]
    pub fn right(&self) -> [T; 3] {
        self.axis(cross(self.direction, [0.0, 1.0, 0.0].map(T::of)))
    }

    /// v: u × direction.
    #[must_use]
    pub fn up(&self) -> [T; 3] {
        self.axis(cross(self.right(), self.direction))
    }

    /// The rows (u, −u·location), (v, −v·location), (n, −n·location).
    fn computed_view(&self) -> Rows<T, 4> {
        let n = self.axis(self.direction.map(|x| -x));
        let [u, v, n] = [self.right(), self.up(), n].map(|axis| {
            let [x, y, z] = axis;
            [x, y, z, -dot(axis, self.location)]
        });
        [u, v, n, [0.0, 0.0, 0.0, 1.0].map(T::of)]
    }

    /// The view matrix.
    #[must_use]
    pub const fn view(&self) -> Rows<T, 4> {
        self.view
    }

    /// The projection matrix: of 70° across, or of the box −½ … ½ if parallel.
    #[must_use]
    pub fn projection(&self) -> Rows<T, 4> {
        let [near, far, half] = [NEAR, FAR, 0.5].map(T::of);
        if self.parallel {
            orthographic([-half, half], [-half, half], near, far)
        } else {
            perspective(T::of(FOV), self.size[0] / self.size[1], near, far)
        }
    }

    /// Projection · view, as it was when the camera was last moved or turned.
    #[must_use]
    pub const fn view_projection(&self) -> Rows<T, 4> {
        self.view_projection
    }

    /// Where a point of the world comes to lie: x and y in pixels, y down, and its depth. The seed cuts x and y off to
    /// whole numbers, which is left to the caller here.
    #[must_use]
    pub fn pixels(&self, point: [T; 3]) -> [T; 3] {
        project(&product(&viewport(self.size), &self.view_projection), point)
    }

    /// What is wrong with it as it stands.
    pub fn faults(&self) -> impl Iterator<Item = Fault> + use<T> {
        let [right, up] = [self.right(), self.up()].map(|axis| length(axis).to_f64());
        // What rounding does to a length of 1, with room to spare; a length of 0 can be one of 10⁻⁷, too.
        let unit = |length: f64| (length - 1.0).abs() < 1e-6;
        let axes = if right.is_nan() || up.is_nan() {
            Some(Fault::NotANumber)
        } else if right < 1e-6 {
            Some(Fault::Collapsed)
        } else if !unit(right) || !unit(up) {
            Some(Fault::Lengths { right, up })
        } else {
            None
        };
        let now = product(&self.projection(), &self.view);
        let finite = now.as_flattened().iter().all(|x| x.to_f64().is_finite());
        let stale = finite && now != self.view_projection;
        [axes, stale.then_some(Fault::Stale)].into_iter().flatten()
    }
}

/// A perspective of `fov` radians across, for width / height = `aspect`.
#[must_use]
pub fn perspective<T: Real>(fov: T, aspect: T, near: T, far: T) -> Rows<T, 4> {
    let x = T::of(1.0) / (fov / T::of(2.0)).tan();
    let (a, b) = between(near, far);
    lens([x, x * aspect], a, b)
}

/// A perspective of the window `x[0]..x[1]` × `y[0]..y[1]` on the near plane, without the terms that a window beside
/// the axis needs: right only if its middle is on the axis.
#[must_use]
pub fn perspective_planes<T: Real>(x: [T; 2], y: [T; 2], near: T, far: T) -> Rows<T, 4> {
    let twice = T::of(2.0) * near;
    let (a, b) = between(near, far);
    lens([twice / (x[1] - x[0]), twice / (y[1] - y[0])], a, b)
}

/// A perspective of `fov` radians across without a far plane: depth tends to 1.
#[must_use]
pub fn perspective_infinite<T: Real>(fov: T, aspect: T, near: T) -> Rows<T, 4> {
    let x = T::of(1.0) / (fov / T::of(2.0)).tan();
    lens([x, x * aspect], T::of(-1.0), -(T::of(2.0) * near))
}

/// A parallel projection of the box `x[0]..x[1]` × `y[0]..y[1]` between two planes.
#[must_use]
pub fn orthographic<T: Real>(x: [T; 2], y: [T; 2], near: T, far: T) -> Rows<T, 4> {
    let (two, zero) = (T::of(2.0), T::of(0.0));
    let (width, height, depth) = (x[1] - x[0], y[1] - y[0], far - near);
    [
        [two / width, zero, zero, -(x[1] + x[0]) / width],
        [zero, two / height, zero, -(y[1] + y[0]) / height],
        [zero, zero, -(two / depth), -(far + near) / depth],
        [zero, zero, zero, T::of(1.0)],
    ]
}

/// From −1 … 1 to a picture of `size` pixels, y down.
#[must_use]
pub fn viewport<T: Real>([width, height]: [T; 2]) -> Rows<T, 4> {
    let (two, one, zero) = (T::of(2.0), T::of(1.0), T::of(0.0));
    [
        [width / two, zero, zero, width / two],
        [zero, -(height / two), zero, height / two],
        [zero, zero, one, zero],
        [zero, zero, zero, one],
    ]
}

/// −(f + n)/(f − n) and −2fn/(f − n).
fn between<T: Real>(near: T, far: T) -> (T, T) {
    let depth = far - near;
    (-((far + near) / depth), -(T::of(2.0) * far * near / depth))
}

fn lens<T: Real>([x, y]: [T; 2], a: T, b: T) -> Rows<T, 4> {
    let zero = T::of(0.0);
    [[x, zero, zero, zero], [zero, y, zero, zero], [zero, zero, a, b], [zero, zero, -T::of(1.0), zero]]
}
