//! Barycentric weights at every pixel of the box around a triangle (the Java viewer): three divisions a pixel.
//!
//! ```text
//!     area = (y1 − y3)(x2 − x3) + (y2 − y3)(x3 − x1)
//!     b1 = ((y − y3)(x2 − x3) + (y2 − y3)(x3 − x)) / area
//!     b2 = ((y − y1)(x3 − x1) + (y3 − y1)(x1 − x)) / area          inside: all of them from 0 to 1
//!     b3 = ((y − y2)(x1 − x2) + (y1 − y2)(x2 − x)) / area
//! ```
//!
//! A pixel on a side belongs to the triangles on both sides of it. A triangle without area divides by zero; no NaN
//! and no infinity is from 0 to 1, so that it covers nothing.

use super::grid::{Grid, runs};
use super::{Corner, Visit};

/// The weights of one triangle.
#[derive(Clone, Copy, Debug)]
pub(super) struct Barycentric {
    corners: [Corner; 3],
    area: f64,
}

impl Barycentric {
    pub(super) fn new(corners: &[Corner; 3]) -> Self {
        let [[x1, y1, _], [x2, y2, _], [x3, y3, _]] = *corners;
        let area = (y1 - y3) * (x2 - x3) + (y2 - y3) * (x3 - x1);
        Self { corners: *corners, area }
    }

    /// The three corners' weights at a point, in pixels; NaN or infinite where there is no area.
    #[inline]
    pub(super) fn at(&self, x: f64, y: f64) -> [f64; 3] {
        let [[x1, y1, _], [x2, y2, _], [x3, y3, _]] = self.corners;
        [
            ((y - y3) * (x2 - x3) + (y2 - y3) * (x3 - x)) / self.area,
            ((y - y1) * (x3 - x1) + (y3 - y1) * (x1 - x)) / self.area,
            ((y - y2) * (x1 - x2) + (y1 - y2) * (x2 - x)) / self.area,
        ]
    }

    /// The depth that the weights give.
    #[inline]
    pub(super) fn z(&self, b: [f64; 3]) -> f64 {
        b[0] * self.corners[0][2] + b[1] * self.corners[1][2] + b[2] * self.corners[2][2]
    }
}

#[inline]
fn inside(b: [f64; 3]) -> bool {
    b.iter().all(|b| (0.0..=1.0).contains(b))
}

pub(super) fn cover(grid: &Grid, corners: &[Corner; 3], visit: &mut (impl Visit + ?Sized)) {
    let weights = Barycentric::new(corners);
    let [columns, rows] = grid.bounds(corners);
    for j in rows {
        let y = grid.y(j);
        runs(j, columns.clone(), visit, |i| inside(weights.at(grid.x(i), y)));
    }
}

/// The same pixels, each with its depth: the weights that decided the one give the other, as in the seed.
#[inline]
pub(super) fn with_depth(grid: &Grid, corners: &[Corner; 3], mut visit: impl FnMut(u32, u32, f64)) {
    let weights = Barycentric::new(corners);
    let [columns, rows] = grid.bounds(corners);
    for j in rows {
        let y = grid.y(j);
        for i in columns.clone() {
            let b = weights.at(grid.x(i), y);
            if inside(b) {
                visit(i, j, weights.z(b));
            }
        }
    }
}
