//! What a camera can see: the planes of its view volume, and safe answers about balls and boxes.
//!
//! The planes are read off the rows of the matrix to clip space (Gribb and Hartmann 2001): a point is inside the
//! left one where `x + w ≥ 0`, and so on around; inside the near one where `w − z ≥ 0`, the far one where `z ≥ 0`.
//!
//! ```text
//!       ╲  Outside   ╱          Outside: wholly beyond one of the planes, nothing of it can be drawn
//!        ╲   ○      ╱           Inside:  wholly within all of them, nothing of it need be clipped
//!      ○  ╲   ●    ╱            Crosses: everything else, also what is beyond two planes' common edge
//!          ╲      ◐  Crosses             without being beyond either
//!           ╲____╱
//! ```
//!
//! Both sure answers are conservative, and further by the rounding of an `f32` vertex transform: whatever is said
//! to be outside the frustum of a [`clip_from_model_f64`] matrix, in the model's own coordinates, also is outside
//! for the vertices that the rounded matrix makes. Culling by it can therefore change no pixel.
//!
//! [`clip_from_model_f64`]: crate::clip_from_model_f64

use glam::{DMat4, DVec3, DVec4};

use crate::{bounds::Bounds, view::unit};

/// Room for rounding, relative to the sum of the magnitudes of all terms. Rounding the matrix to `f32` and then
/// evaluating a row of it in `f32` errs by at most 5 · 2⁻²⁴ of that sum; a smaller figure would let a box be
/// culled whose vertices round into the picture.
const SLACK: f64 = 1.0 / (1_u32 << 21) as f64;

/// An answer of [`Frustum`].
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Containment {
    /// All of it is in the frustum.
    Inside,
    /// None of it is.
    Outside,
    /// Part of it may be, or it is too close to tell.
    Crosses,
}

/// A plane of a frustum. The inside is where `normal · p + offset ≥ 0`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Plane {
    /// Unit length, pointing into the frustum.
    pub normal: DVec3,
    /// Distance of the origin from the plane, positive inside.
    pub offset: f64,
    /// Magnitudes of the terms that a row of the matrix adds up, on the scale of `normal`.
    reach: DVec4,
}

impl Plane {
    /// The plane where the sum (or difference) of two rows is zero; none if it does not depend on the place.
    fn new(inside: DVec4, reach: DVec4) -> Option<Self> {
        let normal = unit(inside.truncate())?;
        let length = inside.truncate().dot(normal);
        let plane = Self { normal, offset: inside.w / length, reach: reach / length };
        (plane.offset.is_finite() && plane.reach.is_finite()).then_some(plane)
    }

    /// Distance of `point` from the plane, positive inside.
    #[must_use]
    pub fn distance(&self, point: DVec3) -> f64 {
        self.normal.dot(point) + self.offset
    }

    /// How uncertain a distance may be for points whose coordinates are at most `magnitude`.
    fn slack(&self, magnitude: DVec3) -> f64 {
        SLACK * (self.reach.truncate().dot(magnitude) + self.reach.w)
    }
}

/// The view volume of a matrix to clip space.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Frustum {
    planes: [Option<Plane>; 6],
}

impl Frustum {
    /// The frustum in the coordinates that `clip` maps to clip space: those of the model if it is the matrix from
    /// the model, of the world if it is the camera's.
    ///
    /// A plane at infinity bounds nothing and is left out, as is one that is not finite; so a senseless matrix
    /// culls nothing.
    #[must_use]
    pub fn from_clip(clip: &DMat4) -> Self {
        let [x, y, z, w] = [0, 1, 2, 3].map(|i| clip.row(i));
        let [ax, ay, az, aw] = [x, y, z, w].map(DVec4::abs);
        let planes = [
            Plane::new(w + x, aw + ax),
            Plane::new(w - x, aw + ax),
            Plane::new(w + y, aw + ay),
            Plane::new(w - y, aw + ay),
            Plane::new(w - z, aw + az),
            Plane::new(z, az),
        ];
        Self { planes }
    }

    /// Its planes, in the order left, right, bottom, top, near, far, without those that bound nothing.
    pub fn planes(&self) -> impl Iterator<Item = &Plane> {
        self.planes.iter().flatten()
    }

    /// Where a ball is. A negative radius counts as zero; not finite, the answer is `Crosses`.
    #[must_use]
    pub fn sphere(&self, center: DVec3, radius: f64) -> Containment {
        if !(center.is_finite() && radius.is_finite()) {
            return Containment::Crosses;
        }
        let radius = radius.max(0.0);
        let magnitude = center.abs() + DVec3::splat(radius);
        self.test(magnitude, |plane| {
            let distance = plane.distance(center);
            (distance - radius, distance + radius)
        })
    }

    /// Where a box is. An empty box is outside.
    #[must_use]
    pub fn bounds(&self, bounds: &Bounds) -> Containment {
        if bounds.is_empty() {
            return Containment::Outside;
        }
        let (min, max) = (bounds.min(), bounds.max());
        self.test(min.abs().max(max.abs()), |plane| {
            // The corners that lie deepest and least deep in the plane's own direction.
            let (a, b) = (plane.normal * min, plane.normal * max);
            (a.min(b).element_sum() + plane.offset, a.max(b).element_sum() + plane.offset)
        })
    }

    /// `range`: the least and the greatest distance from a plane.
    fn test(&self, magnitude: DVec3, range: impl Fn(&Plane) -> (f64, f64)) -> Containment {
        let mut answer = Containment::Inside;
        for plane in self.planes() {
            let ((least, greatest), slack) = (range(plane), plane.slack(magnitude));
            if greatest < -slack {
                return Containment::Outside;
            }
            // The negation takes in what is not a number.
            #[expect(clippy::neg_cmp_op_on_partial_ord, reason = "not a number must count as crossing")]
            if !(least > slack) {
                answer = Containment::Crosses;
            }
        }
        answer
    }
}
