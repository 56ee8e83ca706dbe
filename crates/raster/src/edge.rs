//! Edge functions: on which side of a side a point lies, exactly.
//!
//! For the side from P to Q, `E(x, y) = dx·(y − P.y) − dy·(x − P.x)` in sub-pixels is twice the area of P, Q
//! and the point. The three edge functions of a triangle are positive inside it; divided by its area they are
//! the barycentric weights of the opposite corners.

use crate::snap::PIXEL;
use crate::{Corner, Sample, Triangle};

/// The edge function of one side: `x·X + y·Y + constant` at the sub-pixel (X, Y).
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Edge {
    x: i64,
    y: i64,
    constant: i64,
}

impl Edge {
    /// The side opposite to a sorted corner, positive inside.
    #[inline]
    pub(crate) fn opposite(triangle: &Triangle, corner: usize) -> Self {
        let [a, b, c] = triangle.corners();
        // Sorted and `middle_right`, the corners run clockwise on the screen: inside is positive.
        let (p, q) = match corner {
            0 => (b, c),
            1 => (c, a),
            _ => (a, b),
        };
        if triangle.middle_right() { Self::through(p, q) } else { Self::through(q, p) }
    }

    #[inline]
    fn through(p: &Corner, q: &Corner) -> Self {
        let [px, py, dx, dy] = [p.x, p.y, q.x - p.x, q.y - p.y].map(i64::from);
        Self { x: -dy, y: dx, constant: dy * px - dx * py }
    }

    /// Whether a point on the side itself counts as inside: only on a left or a top side.
    ///
    /// On a left side the inside lies to the right, so that E grows with x; on a top side below, with y.
    pub(crate) const fn is_top_left(&self) -> bool {
        self.x > 0 || (self.x == 0 && self.y > 0)
    }

    /// Whether the sub-pixel (x, y) counts as inside.
    pub(crate) const fn covers(&self, x: i64, y: i64) -> bool {
        let e = self.x * x + self.y * y + self.constant;
        e > 0 || (e == 0 && self.is_top_left())
    }

    /// The edge function at the point (x/d, y/d), in sub-pixels, times d.
    pub(crate) fn at(&self, [x, y]: [i64; 2], d: i64) -> i128 {
        let wide = i128::from;
        wide(self.x) * wide(x) + wide(self.y) * wide(y) + wide(self.constant) * wide(d)
    }

    /// The edge function at the sample of each pixel.
    #[inline]
    pub(crate) fn at_pixels(&self, sample: Sample) -> PixelEdge {
        let [x, y] = sample.sub_pixels().map(i64::from);
        let first = self.x * x + self.y * y + self.constant;
        PixelEdge { x: self.x, y: self.y, first: first.div_euclid(PIXEL), rest: first.rem_euclid(PIXEL) }
    }
}

/// An edge function at the sample of each pixel, split as `E = 256·E′ + rest`.
///
/// A step of one pixel changes E by a multiple of 256, so that the rest is the same at every pixel, and E′
/// steps by the side's own extent. Inside the triangle `0 <= E′ <= area / 256`.
#[derive(Clone, Copy, Debug)]
pub(crate) struct PixelEdge {
    pub(crate) x: i64,
    pub(crate) y: i64,
    first: i64,
    pub(crate) rest: i64,
}

impl PixelEdge {
    /// E′ at a pixel.
    #[inline]
    pub(crate) fn at(&self, x: u32, y: u32) -> i64 {
        self.x * i64::from(x) + self.y * i64::from(y) + self.first
    }

    /// E at a pixel.
    #[inline]
    pub(crate) fn whole(&self, x: u32, y: u32) -> i64 {
        self.at(x, y) * PIXEL + self.rest
    }
}
