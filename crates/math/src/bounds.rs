//! Boxes with faces parallel to the axes.

use glam::{DMat4, DVec3};

/// The smallest box with faces parallel to the axes around some points; empty around none.
///
/// # Guarantees
///
/// Not empty, its corners are finite and `min <= max` in every coordinate.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Bounds {
    min: DVec3,
    max: DVec3,
}

impl Default for Bounds {
    fn default() -> Self {
        Self::EMPTY
    }
}

impl Bounds {
    /// Around nothing. Any union with it is the other box.
    pub const EMPTY: Self = Self { min: DVec3::INFINITY, max: DVec3::NEG_INFINITY };

    /// The box between two opposite corners, given in any order; empty if one is not finite.
    #[must_use]
    pub fn new(a: DVec3, b: DVec3) -> Self {
        let mut bounds = Self::EMPTY;
        if a.is_finite() && b.is_finite() {
            bounds.insert(a);
            bounds.insert(b);
        }
        bounds
    }

    /// The box around `points`, and how many of them were left out because a coordinate was not finite.
    pub fn from_points(points: impl IntoIterator<Item = [f32; 3]>) -> (Self, usize) {
        let mut bounds = Self::EMPTY;
        let mut ignored = 0;
        for point in points {
            if !bounds.insert(DVec3::from_array(point.map(f64::from))) {
                ignored += 1;
            }
        }
        (bounds, ignored)
    }

    /// Grows the box to hold `point`. A point that is not finite is left out: then the answer is `false`.
    pub fn insert(&mut self, point: DVec3) -> bool {
        let finite = point.is_finite();
        if finite {
            self.min = self.min.min(point);
            self.max = self.max.max(point);
        }
        finite
    }

    /// Whether there is no point in it. A box around a single point is not empty, though its size is zero.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.min.x > self.max.x
    }

    /// The corner with the least coordinates; +∞ if empty.
    #[must_use]
    pub const fn min(&self) -> DVec3 {
        self.min
    }

    /// The corner with the greatest coordinates; −∞ if empty.
    #[must_use]
    pub const fn max(&self) -> DVec3 {
        self.max
    }

    /// The smallest box around both.
    #[must_use]
    pub fn union(&self, other: &Self) -> Self {
        Self { min: self.min.min(other.min), max: self.max.max(other.max) }
    }

    /// The point in the middle; `None` if empty.
    #[must_use]
    pub fn center(&self) -> Option<DVec3> {
        // Halved before they are added, so that the largest coordinates do not overflow.
        (!self.is_empty()).then(|| self.min * 0.5 + self.max * 0.5)
    }

    /// Its extents along x, y and z; zero if empty.
    #[must_use]
    pub fn size(&self) -> DVec3 {
        if self.is_empty() { DVec3::ZERO } else { self.max - self.min }
    }

    /// The distance between opposite corners; zero if empty.
    #[must_use]
    pub fn diagonal(&self) -> f64 {
        self.size().length()
    }

    /// Whether `point` lies inside or on a face.
    #[must_use]
    pub fn contains(&self, point: DVec3) -> bool {
        self.min.cmple(point).all() && point.cmple(self.max).all()
    }

    /// The eight corners; corner `i` takes the greater x, y or z where bit 0, 1 or 2 of `i` is set. If empty, they
    /// are not finite.
    #[must_use]
    pub fn corners(&self) -> [DVec3; 8] {
        core::array::from_fn(|i| {
            let pick = |bit: usize, axis: usize| if i & bit == 0 { self.min[axis] } else { self.max[axis] };
            DVec3::new(pick(1, 0), pick(2, 1), pick(4, 2))
        })
    }

    /// The box around the eight corners after the affine map `matrix` (its last row is taken for 0 0 0 1).
    ///
    /// Corners that the map sends out of `f64`'s range are left out; an empty box stays empty.
    #[must_use]
    pub fn transformed(&self, matrix: &DMat4) -> Self {
        let mut bounds = Self::EMPTY;
        if !self.is_empty() {
            for corner in self.corners() {
                bounds.insert((*matrix * corner.extend(1.0)).truncate());
            }
        }
        bounds
    }
}
