//! Strips: for each row of pixels, exactly those whose sample a triangle covers.
//!
//! ```text
//!                ●                       a sample on a left or top side belongs to the triangle,
//!              ··│··                     one on a right or bottom side to its neighbour
//!     row j  ──×─┼─×──×──×──             × samples
//!            ●   │xl     ▲ xr            the strip is xl .. xr
//! ```
//!
//! On row j (sample at y = 256j + s) a side from A down to B is crossed at
//! `x = A.x + (B.x − A.x)·(256j + s − A.y) / (B.y − A.y)`, and the first pixel at or right of it is
//!
//! ```text
//!     ⌈(dx·(256j + s.y − A.y) + (A.x − s.x)·dy) / (256·dy)⌉
//! ```
//!
//! That integer starts the strip of the triangle to the right of the side and ends the strip of the one to the
//! left, whatever else their shapes are: they share no pixel and leave none out. From row to row it changes by
//! `dx / dy`, kept as a quotient and a remainder; nothing is ever rounded. (An integer walker of this kind is
//! Bresenham's; the ceiling is the top-left rule.)

use core::ops::Range;

use crate::snap::PIXEL;
use crate::{Corner, Rect, Sample, Triangle};

/// One row of a triangle: the pixels `x0..x1` of row `y`, at least one.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct Strip {
    /// The row.
    pub y: u32,
    /// The first pixel.
    pub x0: u32,
    /// One past the last pixel.
    pub x1: u32,
}

impl Triangle {
    /// The rows inside `clip` whose samples the triangle reaches; empty for many a small one.
    #[inline]
    pub(crate) fn rows(&self, sample: Sample, clip: Rect) -> Range<i64> {
        let [top, _, bottom] = self.corners();
        first_at(top.y, sample.y).max(clip.y0.into())..first_at(bottom.y, sample.y).min(clip.y1.into())
    }

    /// The columns inside `clip` that the triangle's box reaches.
    #[cfg(feature = "alloc")]
    pub(crate) fn columns(&self, sample: Sample, clip: Rect) -> Range<i64> {
        let [a, b, c] = self.corners().map(|corner| corner.x);
        let (left, right) = (a.min(b).min(c), a.max(b).max(c));
        first_at(left, sample.x).max(clip.x0.into())..first_at(right, sample.x).min(clip.x1.into())
    }

    /// The strips of pixels inside `clip` whose sample the triangle covers, from top to bottom.
    ///
    /// `clip` must not reach beyond 16,384 pixels to the right or down.
    #[inline]
    #[must_use]
    pub fn strips(&self, sample: Sample, clip: Rect) -> Strips {
        let [top, middle, bottom] = self.corners();
        let Range { start: first, end } = self.rows(sample, clip);
        let turn = first_at(middle.y, sample.y).clamp(first, end.max(first));
        // The long side runs through; the other changes at the middle corner.
        let start = if first < turn { (top, middle) } else { (middle, bottom) };
        let long = Side::new(top, bottom, sample, first);
        let short = Side::new(start.0, start.1, sample, first);
        let next = Side::new(middle, bottom, sample, turn);
        let (left, right) = if self.middle_right() { (long, short) } else { (short, long) };
        Strips { clip, row: first, turn, end, left, right, next, next_right: self.middle_right() }
    }
}

/// The strips of a triangle; made by [`Triangle::strips`].
#[derive(Clone, Debug)]
pub struct Strips {
    clip: Rect,
    row: i64,
    turn: i64,
    end: i64,
    left: Side,
    right: Side,
    /// What replaces one side from row `turn` on.
    next: Side,
    next_right: bool,
}

impl Iterator for Strips {
    type Item = Strip;

    #[inline]
    fn next(&mut self) -> Option<Strip> {
        while self.row < self.end {
            if self.row == self.turn {
                *(if self.next_right { &mut self.right } else { &mut self.left }) = self.next;
            }
            let (x0, x1) = (self.left.x.max(self.clip.x0.into()), self.right.x.min(self.clip.x1.into()));
            let y = self.row;
            self.row += 1;
            self.left.step();
            self.right.step();
            if x0 < x1 {
                return Some(strip(y, x0, x1));
            }
        }
        None
    }
}

#[inline]
#[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "inside the clip rectangle")]
const fn strip(y: i64, x0: i64, x1: i64) -> Strip {
    Strip { y: y as u32, x0: x0 as u32, x1: x1 as u32 }
}

/// One side of a triangle, at one row of samples.
#[derive(Clone, Copy, Debug)]
struct Side {
    /// The first pixel at or right of the side.
    x: i64,
    /// How far the side lies past that, in 1/`height` pixel.
    rest: i64,
    /// What a row adds to both.
    step: i64,
    step_rest: i64,
    /// Of the side, in sub-pixels.
    height: i64,
}

impl Side {
    /// The side from `a` down to `b` at a row of samples. A level side is crossed by no row; anything will do.
    #[inline]
    fn new(a: &Corner, b: &Corner, sample: Sample, row: i64) -> Self {
        let [ax, ay, dx, dy] = [a.x, a.y, b.x - a.x, b.y - a.y].map(i64::from);
        if dy == 0 {
            return Self { x: 0, rest: 0, step: 0, step_rest: 0, height: 1 };
        }
        let [sx, sy] = sample.sub_pixels().map(i64::from);
        // ⌈n / 256·dy⌉ = ⌈⌈n / 256⌉ / dy⌉, and the row's own part of n is a multiple of 256.
        let first = dx * (sy - ay) + (ax - sx) * dy;
        let whole = dx * row + (first + PIXEL - 1).div_euclid(PIXEL) + dy - 1;
        Self {
            x: whole.div_euclid(dy),
            rest: whole.rem_euclid(dy),
            step: dx.div_euclid(dy),
            step_rest: dx.rem_euclid(dy),
            height: dy,
        }
    }

    #[inline]
    const fn step(&mut self) {
        self.x += self.step;
        self.rest += self.step_rest;
        if self.rest >= self.height {
            self.rest -= self.height;
            self.x += 1;
        }
    }
}

/// The first row whose sample lies at or below a place.
#[inline]
fn first_at(place: i32, sample: u8) -> i64 {
    (i64::from(place) - i64::from(sample) + PIXEL - 1).div_euclid(PIXEL)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::Corner;
    use crate::edge::Edge;

    #[test]
    #[expect(clippy::cast_precision_loss, reason = "20 bits")]
    fn strips_rows_and_points_agree() {
        let mut seed = 7_u32;
        let mut next = |range: u32| {
            seed = seed.wrapping_mul(747_796_405).wrapping_add(2_891_336_453);
            (seed >> 8) % range
        };
        let clip = Rect { x0: 0, y0: 0, x1: 40, y1: 30 };
        for _ in 0..2_000 {
            let corners = [0; 3].map(|_| {
                let (x, y) = (next(10_000), next(8_000));
                let z = (next(1 << 20) as f32) / (1 << 20) as f32;
                Corner { x: x.cast_signed(), y: y.cast_signed(), z, w: 1.0 }
            });
            let Some(triangle) = Triangle::new(corners) else { continue };
            let sample = Sample::CENTER;
            let depth = triangle.depth(sample);
            let sides = [0, 1, 2].map(|k| Edge::opposite(&triangle, k));
            let mut seen = [[None; 40]; 30];
            for strip in triangle.strips(sample, clip) {
                let row = &mut seen[strip.y as usize][strip.x0 as usize..strip.x1 as usize];
                depth.row(strip.x0, strip.y, row.iter_mut(), |place, z| *place = Some(z));
            }
            for (y, row) in (0..).zip(&seen) {
                for (x, &z) in (0..).zip(row) {
                    let covered =
                        sides.iter().all(|s| s.covers(i64::from(x) * 256 + 128, i64::from(y) * 256 + 128));
                    assert_eq!(covered, z.is_some(), "{triangle:?} at {x}, {y}");
                    if let Some(z) = z {
                        assert_eq!(z.to_bits(), depth.at(x, y).to_bits(), "{triangle:?} at {x}, {y}");
                    }
                }
            }
        }
    }
}
