//! Scan conversion in `f32`: for each row the two sides' x, stepped from row to row by adding a slope (a digital
//! differential analyser), as many small rasterisers do.
//!
//! ```text
//!             ● top                    long side: top to bottom, in one go
//!            ╱ ╲                       other side: top to middle, then from the middle anew
//!           ╱───● middle
//!          ╱ ╱
//!         ● bottom                     x += slope   a rounding a row
//! ```
//!
//! The errors of the steps add up, so that two triangles that share a side reach different ends of it; neighbours
//! leave pixels out or share them.

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
    let [ux, uy, vx, vy] = [middle[0] - top[0], middle[1] - top[1], bottom[0] - top[0], bottom[1] - top[1]];
    let middle_right = ux * vy - uy * vx > 0.0;
    let mut long = None;
    for (a, b) in [(top, middle), (middle, bottom)] {
        let rows = grid.rows(a[1].into(), b[1].into());
        let y = single(grid.y(rows.start));
        let mut short = Walk::new(a, b, y);
        for j in rows {
            let through = long.get_or_insert_with(|| Walk::new(top, bottom, y));
            let (left, right) = if middle_right { (through.x, short.x) } else { (short.x, through.x) };
            let columns = grid.columns(left.into(), right.into());
            if !columns.is_empty() {
                visit.row(j, columns);
            }
            through.x += through.slope;
            short.x += short.slope;
        }
    }
}
