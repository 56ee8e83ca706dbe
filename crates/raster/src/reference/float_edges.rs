//! Edge functions in `f32` on vertices that were not snapped, with the top-left rule: what a compute shader does that
//! imitates the hardware.
//!
//! The rule decides ties rightly, but which points are ties is decided by rounding: E of a side and of the same side
//! seen from the neighbour are rounded differently, and both may come out negative. The longer the side, the more
//! holes.

use super::grid::{Grid, runs};
use super::{Corner, Visit};

type Point = [f32; 2];

#[inline]
#[expect(clippy::cast_possible_truncation, reason = "the method's precision")]
pub(super) fn narrow(corner: &Corner) -> [f32; 3] {
    corner.map(|v| v as f32)
}

#[derive(Clone, Copy)]
struct Side {
    from: Point,
    step: Point,
    is_top_left: bool,
}

impl Side {
    fn new(from: Point, to: Point) -> Self {
        let [dx, dy] = [to[0] - from[0], to[1] - from[1]];
        Self { from, step: [dx, dy], is_top_left: dy < 0.0 || (dy == 0.0 && dx > 0.0) }
    }

    #[inline]
    fn value(&self, [x, y]: Point) -> f32 {
        self.step[0] * (y - self.from[1]) - self.step[1] * (x - self.from[0])
    }

    #[inline]
    fn covers(&self, point: Point) -> bool {
        let e = self.value(point);
        e > 0.0 || (e == 0.0 && self.is_top_left)
    }
}

pub(super) fn cover(grid: &Grid, corners: &[Corner; 3], visit: &mut (impl Visit + ?Sized)) {
    let [a, mut b, mut c] = corners.each_ref().map(|corner| {
        let [x, y, _] = narrow(corner);
        [x, y]
    });
    let area = Side::new(a, b).value(c);
    if area < 0.0 {
        core::mem::swap(&mut b, &mut c);
    } else if area == 0.0 {
        return;
    }
    let sides = [Side::new(a, b), Side::new(b, c), Side::new(c, a)];
    let [columns, rows] = grid.bounds(corners);
    for j in rows {
        let y = single(grid.y(j));
        runs(j, columns.clone(), visit, |i| {
            let point = [single(grid.x(i)), y];
            sides.iter().all(|side| side.covers(point))
        });
    }
}

/// A sample's coordinate: exact, 14 bits before the point and 8 behind.
#[inline]
#[expect(clippy::cast_possible_truncation, reason = "22 bits")]
pub(super) const fn single(value: f64) -> f32 {
    value as f32
}
