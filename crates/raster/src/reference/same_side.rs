//! The same-side test (the English rewrite of the Java viewer): is the point on the third corner's side of each side?
//!
//! ```text
//!     for each side AB with the third corner C:   (AB × AC) · (AB × AP) ≥ 0
//! ```
//!
//! Without a division, yet with twice the products. When all corners lie on one line every AB × AC is zero, each
//! product is 0 ≥ 0, and the whole box counts as inside.

use super::grid::{Grid, runs};
use super::{Corner, Visit};

/// The cross product AB × AP.
#[inline]
pub(super) fn cross(a: &Corner, b: &Corner, [x, y]: [f64; 2]) -> f64 {
    (b[0] - a[0]) * (y - a[1]) - (b[1] - a[1]) * (x - a[0])
}

pub(super) fn cover(grid: &Grid, corners: &[Corner; 3], visit: &mut (impl Visit + ?Sized)) {
    let sides = [0, 1, 2].map(|k| {
        let [a, b, c] = [0, 1, 2].map(|step| corners[(k + step) % 3]);
        (a, b, cross(&a, &b, [c[0], c[1]]))
    });
    let [columns, rows] = grid.bounds(corners);
    for j in rows {
        let y = grid.y(j);
        runs(j, columns.clone(), visit, |i| {
            let p = [grid.x(i), y];
            sides.iter().all(|(a, b, third)| third * cross(a, b, p) >= 0.0)
        });
    }
}
