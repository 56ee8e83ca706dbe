//! Depth at each pixel of a triangle, one formula a method.

use core::ops::Range;

use super::Corner;
use super::barycentric::Barycentric;
use super::exact::snapped;
use super::float_edges::{narrow, single};
use super::grid::Grid;
use super::vertical::Sorted;
use crate::{DepthPlane, Sample, Triangle};

/// A triangle's depth.
pub(super) trait Surface {
    /// The precision in which it is stored and compared.
    type Z: Copy + PartialOrd;

    /// At the sample of a pixel.
    fn at(&self, x: u32, y: u32) -> Self::Z;

    /// At the pixels of a row from `x` on, one for each item.
    #[inline]
    fn row<T>(&self, x: u32, y: u32, items: impl Iterator<Item = T>, mut each: impl FnMut(T, Self::Z)) {
        for (x, item) in (x..).zip(items) {
            each(item, self.at(x, y));
        }
    }

    /// At the pixels of a column whose strip has these ends.
    #[inline]
    fn column(&self, x: u32, rows: Range<u32>, ends: [f64; 2], mut each: impl FnMut(u32, Self::Z)) {
        let _ = ends;
        for y in rows {
            each(y, self.at(x, y));
        }
    }
}

/// One depth for all pixels.
pub(super) struct Constant(pub(super) f64);

impl Surface for Constant {
    type Z = f64;

    #[inline]
    fn at(&self, _: u32, _: u32) -> f64 {
        self.0
    }
}

/// From barycentric weights.
pub(super) struct Weighted {
    pub(super) grid: Grid,
    pub(super) weights: Barycentric,
}

impl Surface for Weighted {
    type Z = f64;

    #[inline]
    fn at(&self, x: u32, y: u32) -> f64 {
        self.weights.z(self.weights.at(self.grid.x(x), self.grid.y(y)))
    }
}

/// The crate's own depth, from exact edge values. Corners that have no area on the sub-pixel grid, or lie beyond the
/// guard band, have none; there other methods may draw pixels all the same, and get what the weights give or, without
/// area, the mean.
pub(super) enum Exact {
    Plane(DepthPlane),
    Weights(Weighted, f64),
}

impl Exact {
    pub(super) fn new(grid: &Grid, sample: Sample, corners: &[Corner; 3]) -> Self {
        match snapped(corners).and_then(Triangle::sorted) {
            Some(triangle) => Self::Plane(triangle.depth(sample)),
            None => {
                let weights = Weighted { grid: *grid, weights: Barycentric::new(corners) };
                Self::Weights(weights, (corners[0][2] + corners[1][2] + corners[2][2]) / 3.0)
            }
        }
    }
}

impl Surface for Exact {
    type Z = f32;

    #[inline]
    fn at(&self, x: u32, y: u32) -> f32 {
        match self {
            Self::Plane(plane) => plane.at(x, y),
            Self::Weights(weights, mean) => {
                let z = weights.at(x, y);
                rounded(if z.is_finite() { z } else { *mean })
            }
        }
    }

    #[inline]
    fn row<T>(&self, x: u32, y: u32, items: impl Iterator<Item = T>, mut each: impl FnMut(T, f32)) {
        match self {
            // Vector code does not pay for a few pixels, as in the crate's own fill; the values are the same.
            Self::Plane(plane) if items.size_hint().0 >= 16 => plane.long_row(x, y, items, each),
            Self::Plane(plane) => plane.row(x, y, items, each),
            Self::Weights(..) => (x..).zip(items).for_each(|(x, item)| each(item, self.at(x, y))),
        }
    }
}

/// Linear between the ends of the vertical strip through the pixel.
pub(super) struct Strip {
    pub(super) grid: Grid,
    pub(super) sorted: Sorted,
    /// Without the term `+ z(x, y_min)`, as the report prints the formula.
    pub(super) as_printed: bool,
}

impl Strip {
    /// Depth at the lower end of a strip, that end, and its length in depth and in y.
    #[inline]
    fn line(&self, x: u32, [low, high]: [f64; 2]) -> [f64; 4] {
        let x = self.grid.x(x);
        let [first, last] = [low, high].map(|y| self.sorted.z(x, y));
        [if self.as_printed { 0.0 } else { first }, low, last - first, high - low]
    }

    #[inline]
    fn on(&self, [first, low, depth, length]: [f64; 4], y: u32) -> f64 {
        let z = depth * (self.grid.y(y) - low) / length;
        // A strip of no length divides zero by zero: meant is the depth of its only point.
        if length == 0.0 && !self.as_printed { first } else { z + first }
    }
}

impl Surface for Strip {
    type Z = f64;

    #[inline]
    fn at(&self, x: u32, y: u32) -> f64 {
        self.on(self.line(x, self.sorted.ends(self.grid.x(x))), y)
    }

    #[inline]
    fn column(&self, x: u32, rows: Range<u32>, ends: [f64; 2], mut each: impl FnMut(u32, f64)) {
        let line = self.line(x, ends);
        for y in rows {
            each(y, self.on(line, y));
        }
    }
}

/// A plane in `f32` from the first corner: `(z + a·(x − x0)) + b·(y − y0)`.
pub(super) struct PlaneF32 {
    anchor: [f32; 3],
    slope: [f32; 2],
    grid: Grid,
}

impl PlaneF32 {
    pub(super) fn new(grid: &Grid, corners: &[Corner; 3]) -> Self {
        let [a, b, c] = corners.each_ref().map(narrow);
        let to = |p: [f32; 3]| [p[0] - a[0], p[1] - a[1], p[2] - a[2]];
        let [[ux, uy, uz], [vx, vy, vz]] = [to(b), to(c)];
        let area = ux * vy - uy * vx;
        let slope = [(uz * vy - vz * uy) / area, (ux * vz - vx * uz) / area];
        Self { anchor: a, slope, grid: *grid }
    }
}

impl Surface for PlaneF32 {
    type Z = f32;

    #[inline]
    fn at(&self, x: u32, y: u32) -> f32 {
        let [x0, y0, z] = self.anchor;
        let (dx, dy) = (single(self.grid.x(x)) - x0, single(self.grid.y(y)) - y0);
        (z + self.slope[0] * dx) + self.slope[1] * dy
    }
}

/// The same from the screen's upper left corner: `(c + a·x) + b·y`, two subtractions a pixel less.
pub(super) struct PlaneF32Origin {
    corner: f32,
    slope: [f32; 2],
    grid: Grid,
}

impl PlaneF32Origin {
    pub(super) fn new(grid: &Grid, corners: &[Corner; 3]) -> Self {
        let PlaneF32 { anchor: [x, y, z], slope, grid } = PlaneF32::new(grid, corners);
        Self { corner: z - slope[0] * x - slope[1] * y, slope, grid }
    }
}

impl Surface for PlaneF32Origin {
    type Z = f32;

    #[inline]
    fn at(&self, x: u32, y: u32) -> f32 {
        let (x, y) = (single(self.grid.x(x)), single(self.grid.y(y)));
        (self.corner + self.slope[0] * x) + self.slope[1] * y
    }
}

/// A plane in `f64` from the first corner, rounded to `f32` at the end.
pub(super) struct PlaneF64 {
    anchor: Corner,
    slope: [f64; 2],
    grid: Grid,
}

impl PlaneF64 {
    pub(super) fn new(grid: &Grid, [a, b, c]: &[Corner; 3]) -> Self {
        let to = |p: &Corner| [p[0] - a[0], p[1] - a[1], p[2] - a[2]];
        let [[ux, uy, uz], [vx, vy, vz]] = [to(b), to(c)];
        let area = ux * vy - uy * vx;
        let slope = [(uz * vy - vz * uy) / area, (ux * vz - vx * uz) / area];
        Self { anchor: *a, slope, grid: *grid }
    }
}

impl Surface for PlaneF64 {
    type Z = f32;

    #[inline]
    fn at(&self, x: u32, y: u32) -> f32 {
        let [x0, y0, z] = self.anchor;
        let (dx, dy) = (self.grid.x(x) - x0, self.grid.y(y) - y0);
        rounded((z + self.slope[0] * dx) + self.slope[1] * dy)
    }
}

#[inline]
#[expect(clippy::cast_possible_truncation, reason = "the one rounding")]
const fn rounded(z: f64) -> f32 {
    z as f32
}
