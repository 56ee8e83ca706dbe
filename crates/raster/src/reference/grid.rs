//! The pixels that are asked about, and where each is sampled.

use core::ops::Range;

use polosa_math::SUB_PIXELS;

use super::{Corner, Visit};
use crate::{MAX_SIDE, Rect, Sample};

/// A rectangle of pixels, each sampled at the same place inside of it.
#[derive(Clone, Copy, Debug)]
pub(super) struct Grid {
    pub(super) rect: Rect,
    pub(super) sample: Sample,
    /// The sample of pixel (0, 0), in pixels.
    pub(super) offset: [f64; 2],
}

impl Grid {
    pub(super) fn new(rect: Rect, sample: Sample) -> Self {
        let all = Rect { x0: 0, y0: 0, x1: MAX_SIDE, y1: MAX_SIDE };
        let cut = rect.intersection(all);
        let empty = cut.x0 >= cut.x1 || cut.y0 >= cut.y1;
        let rect = if empty { Rect { x1: 0, y1: 0, ..all } } else { cut };
        Self { rect, sample, offset: sample.sub_pixels().map(|s| f64::from(s) / f64::from(SUB_PIXELS)) }
    }

    /// Where column `i` is sampled, in pixels.
    #[inline]
    pub(super) fn x(&self, i: u32) -> f64 {
        f64::from(i) + self.offset[0]
    }

    /// Where row `j` is sampled, in pixels.
    #[inline]
    pub(super) fn y(&self, j: u32) -> f64 {
        f64::from(j) + self.offset[1]
    }

    /// The columns whose samples lie from `low` to `high`, both ends included; none if one is NaN.
    pub(super) fn columns_closed(&self, low: f64, high: f64) -> Range<u32> {
        closed(low - self.offset[0], high - self.offset[0], self.rect.x0..self.rect.x1)
    }

    /// The rows whose samples lie from `low` to `high`, both ends included; none if one is NaN.
    #[inline]
    pub(super) fn rows_closed(&self, low: f64, high: f64) -> Range<u32> {
        closed(low - self.offset[1], high - self.offset[1], self.rect.y0..self.rect.y1)
    }

    /// The columns whose samples lie from `low` on, and before `high`; none if one is NaN.
    #[inline]
    pub(super) fn columns(&self, low: f64, high: f64) -> Range<u32> {
        half_open(low - self.offset[0], high - self.offset[0], self.rect.x0..self.rect.x1)
    }

    /// The rows whose samples lie from `low` on, and before `high`; none if one is NaN.
    #[inline]
    pub(super) fn rows(&self, low: f64, high: f64) -> Range<u32> {
        half_open(low - self.offset[1], high - self.offset[1], self.rect.y0..self.rect.y1)
    }

    /// Columns and rows of the box around three corners, its border included.
    pub(super) fn bounds(&self, [a, b, c]: &[Corner; 3]) -> [Range<u32>; 2] {
        let least = |k: usize| a[k].min(b[k]).min(c[k]);
        let most = |k: usize| a[k].max(b[k]).max(c[k]);
        [self.columns_closed(least(0), most(0)), self.rows_closed(least(1), most(1))]
    }
}

#[inline]
fn closed(low: f64, high: f64, within: Range<u32>) -> Range<u32> {
    if low <= high { clamp(ceil(low), floor(high).saturating_add(1), within) } else { 0..0 }
}

#[inline]
fn half_open(low: f64, high: f64, within: Range<u32>) -> Range<u32> {
    if low < high { clamp(ceil(low), ceil(high), within) } else { 0..0 }
}

/// Always a range that can be iterated and cut from a slice: `start <= end`.
#[inline]
#[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "clamped to a range of u32")]
fn clamp(low: i64, high: i64, within: Range<u32>) -> Range<u32> {
    let (least, most) = (i64::from(within.start), i64::from(within.end));
    let start = low.clamp(least, most);
    start as u32..high.clamp(start, most) as u32
}

/// The least integer that is not less; saturates.
#[inline]
#[expect(clippy::cast_possible_truncation, clippy::cast_precision_loss, reason = "exact below 2⁵³")]
const fn ceil(value: f64) -> i64 {
    let whole = value as i64;
    if (whole as f64) < value { whole.saturating_add(1) } else { whole }
}

/// The greatest integer that is not greater; saturates.
#[inline]
#[expect(clippy::cast_possible_truncation, clippy::cast_precision_loss, reason = "exact below 2⁵³")]
const fn floor(value: f64) -> i64 {
    let whole = value as i64;
    if (whole as f64) > value { whole.saturating_sub(1) } else { whole }
}

/// Hands over the pixels of a row that are inside, run by run: one call a row for a whole triangle.
#[inline]
pub(super) fn runs(
    y: u32,
    columns: Range<u32>,
    visit: &mut (impl Visit + ?Sized),
    inside: impl Fn(u32) -> bool,
) {
    let Range { start: mut x, end } = columns;
    while x < end {
        if !inside(x) {
            x += 1;
            continue;
        }
        let x0 = x;
        x += 1;
        while x < end && inside(x) {
            x += 1;
        }
        visit.row(y, x0..x);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn rounding_holds_for_any_number() {
        for (value, up, down) in [
            (1.5, 2, 1),
            (-1.5, -1, -2),
            (3.0, 3, 3),
            (-0.0, 0, 0),
            (1e300, i64::MAX, i64::MAX),
            (f64::NEG_INFINITY, i64::MIN, i64::MIN),
        ] {
            assert_eq!((ceil(value), floor(value)), (up, down), "{value}");
        }
    }

    #[test]
    fn ranges_stay_inside_the_rectangle_and_hold_no_sample_of_nan() {
        let grid = Grid::new(Rect { x0: 3, y0: 4, x1: 9, y1: 8 }, Sample::CENTER);
        assert_eq!(grid.columns_closed(3.5, 5.5), 3..6);
        assert_eq!(grid.columns(3.5, 5.5), 3..5);
        assert_eq!(grid.rows_closed(-1e300, f64::INFINITY), 4..8);
        assert!(grid.columns_closed(f64::NAN, 5.0).is_empty() && grid.columns(0.0, f64::NAN).is_empty());
        assert!(grid.columns(100.0, 200.0).is_empty() && grid.rows(-9.0, -8.0).is_empty());
        let none = Grid::new(Rect { x0: 20_000, y0: 0, x1: 30_000, y1: 5 }, Sample::CENTER);
        assert!(none.columns(0.0, 1e9).is_empty() && none.rows(0.0, 1e9).is_empty());
    }
}
