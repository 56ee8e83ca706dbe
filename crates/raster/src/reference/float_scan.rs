//! Scan conversion in `f32`: for each row the two sides' x, stepped from row to row by adding a slope (a digital
//! differential analyser), as many small rasterisers do.
//!
//! ```text
//!             ● top                    the long side is cut at the height of the middle corner,
//!            ╱ ╲                       so that each half is two sides between two level lines
//!      cut  ┼───● middle
//!          ╱ ╱                         x += slope   a rounding a row
//!         ● bottom
//! ```
//!
//! The place of the cut is rounded, and from there on the long side is another line than the one the neighbour sees,
//! which cuts it elsewhere or not at all; then the errors of the steps add up. Neighbours leave pixels out or share
//! them.

use super::float_edges::{narrow, single};
use super::grid::Grid;
use super::{Corner, Visit};

/// A side that is walked down.
#[derive(Clone, Copy)]
struct Walk {
    x: f32,
    slope: f32,
}

impl Walk {
    /// The side from `a` down to `b`, at the row that is sampled at `y`.
    fn new(a: [f32; 3], b: [f32; 3], y: f32) -> Self {
        let slope = (b[0] - a[0]) / (b[1] - a[1]);
        Self { x: a[0] + (y - a[1]) * slope, slope }
    }
}

pub(super) fn cover(grid: &Grid, corners: &[Corner; 3], visit: &mut (impl Visit + ?Sized)) {
    let mut sorted = corners.each_ref().map(narrow);
    for (i, j) in [(0, 1), (1, 2), (0, 1)] {
        if sorted[j][1] < sorted[i][1] {
            sorted.swap(i, j);
        }
    }
    let [top, middle, bottom] = sorted;
    let t = (middle[1] - top[1]) / (bottom[1] - top[1]);
    let cut = [top[0] + (bottom[0] - top[0]) * t, middle[1], 0.0];
    let (left, right) = if middle[0] < cut[0] { (middle, cut) } else { (cut, middle) };
    for [(a, b), (c, d)] in [[(top, left), (top, right)], [(left, bottom), (right, bottom)]] {
        let rows = grid.rows(a[1].into(), b[1].into());
        let y = single(grid.y(rows.start));
        let (mut left, mut right) = (Walk::new(a, b, y), Walk::new(c, d, y));
        for j in rows {
            let columns = grid.columns(left.x.into(), right.x.into());
            if !columns.is_empty() {
                visit.row(j, columns);
            }
            left.x += left.slope;
            right.x += right.slope;
        }
    }
}
