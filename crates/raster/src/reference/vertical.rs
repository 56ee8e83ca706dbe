//! Vertical strips of a triangle whose corners are sorted (the C++ report), in `f64`.
//!
//! ```text
//!               C ●               A  leftmost
//!              ╱ │ ╲              B, C  so that (B − A) × (C − A) ≥ 0
//!            ╱   │   ╲
//!        A ●     │     ╲          the strip at x: from AB, after B.x from BC,
//!            ╲   │       ╲                        to AC, after C.x from CB
//!              ╲ │ ─ ─ ─ ─ ● B
//!                ▲ x
//! ```
//!
//! One division a bound and no test inside the strip: the ancestor of our horizontal ones. The report includes both
//! ends of everything, so that neighbours share the pixels between them, and where a side stands upright it divides
//! zero by zero and loses a column. *Mended*, a strip contains its lower end and not its upper one, and each side is
//! evaluated from its left end to its right one, so that neighbours compute the same number: every pixel once, but a
//! pixel centre on a side goes to the left and the *lower y*, by columns, which is not the top-left rule.

use super::grid::Grid;
use super::same_side::cross;
use super::{Corner, Visit};

/// A triangle, sorted for strips.
#[derive(Clone, Copy, Debug)]
pub(super) struct Sorted {
    a: Corner,
    b: Corner,
    c: Corner,
    area: f64,
}

impl Sorted {
    pub(super) fn new(corners: &[Corner; 3]) -> Self {
        let [mut a, mut b, mut c] = *corners;
        for other in [&mut b, &mut c] {
            if (other[0], other[1]) < (a[0], a[1]) {
                core::mem::swap(&mut a, other);
            }
        }
        let area = cross(&a, &b, [c[0], c[1]]);
        if area < 0.0 { Self { a, b: c, c: b, area: -area } } else { Self { a, b, c, area } }
    }

    /// From where to where the strip at x reaches.
    #[inline]
    pub(super) fn ends(&self, x: f64) -> [f64; 2] {
        let Self { a, b, c, .. } = self;
        let low = if x < b[0] { on(a, b, x) } else { on(b, c, x) };
        let high = if x < c[0] { on(a, c, x) } else { on(c, b, x) };
        [low, high]
    }

    /// The depth of the plane at a point: (x, y) in the basis AB, AC.
    #[inline]
    pub(super) fn z(&self, x: f64, y: f64) -> f64 {
        let Self { a, b, c, area } = self;
        let p = -cross(a, c, [x, y]) / area;
        let q = cross(a, b, [x, y]) / area;
        a[2] + p * (b[2] - a[2]) + q * (c[2] - a[2])
    }

    const fn right(&self) -> f64 {
        self.b[0].max(self.c[0])
    }
}

/// Where the line from p to q is crossed at x.
#[inline]
fn on(p: &Corner, q: &Corner, x: f64) -> f64 {
    p[1] + (q[1] - p[1]) * (x - p[0]) / (q[0] - p[0])
}

/// The strips as mended: half-open.
pub(super) fn cover(grid: &Grid, corners: &[Corner; 3], visit: &mut (impl Visit + ?Sized)) {
    let sorted = Sorted::new(corners);
    for i in grid.columns(sorted.a[0], sorted.right()) {
        let ends = sorted.ends(grid.x(i));
        let rows = grid.rows(ends[0], ends[1]);
        if !rows.is_empty() {
            visit.column(i, rows, ends);
        }
    }
}

/// The strips as in the report: both ends included.
pub(super) fn cover_closed(grid: &Grid, corners: &[Corner; 3], visit: &mut (impl Visit + ?Sized)) {
    let sorted = Sorted::new(corners);
    for i in grid.columns_closed(sorted.a[0], sorted.right()) {
        let ends = sorted.ends(grid.x(i));
        let rows = grid.rows_closed(ends[0], ends[1]);
        if !rows.is_empty() {
            visit.column(i, rows, ends);
        }
    }
}
