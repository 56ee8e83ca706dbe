//! Depth: the one formula, and the formats in which it is stored.
//!
//! Depth is linear over the screen, so it is the weighted mean of the corners' depths. Written as the depth of
//! one corner, the *anchor*, plus the differences Δ to the other two,
//!
//! ```text
//!     z = z_a + (E1·Δ1 + E2·Δ2) / area,        E = 256·E′ + r  (see `edge`)
//!       = c + E′1·q1 + E′2·q2                  c  = z_a + (r1·Δ1 + r2·Δ2) / area
//!                                              qi = 256·Δi / area
//! ```
//!
//! c and q are computed in `f64` and rounded once to `f32`; the rest is `f32`, in this order, at every pixel
//! anew. With the *least* corner as the anchor no term is negative: nothing cancels, and the error stays within
//! 5·2⁻²⁴ of the value however thin or steep the triangle is. Plane equations lose thousands of times more on
//! slivers, and any other anchor a thousand times more on a floor that runs to the horizon.

use core::ops::{Add, Div, Mul};

use crate::edge::{Edge, PixelEdge};
use crate::snap::PIXEL;
use crate::{Sample, Triangle};

/// The formula before the clamp, for numbers and for lanes of them alike.
#[inline(always)]
pub(crate) fn formula<T>(c: T, q: [T; 2], e: [T; 2]) -> T
where
    T: Copy + Add<Output = T> + Mul<Output = T>,
{
    (c + e[0] * q[0]) + e[1] * q[1]
}

/// c and q before they are rounded; `pixel` is 256. Numbers or lanes of `f64`.
#[inline(always)]
pub(crate) fn coefficients<T>(anchor: T, delta: [T; 2], rest: [T; 2], area: T, pixel: T) -> (T, [T; 2])
where
    T: Copy + Add<Output = T> + Mul<Output = T> + Div<Output = T>,
{
    let q = [pixel * delta[0] / area, pixel * delta[1] / area];
    (anchor + (rest[0] * delta[0] + rest[1] * delta[1]) / area, q)
}

/// A triangle's depth at every pixel it covers.
#[derive(Clone, Copy, Debug)]
pub struct DepthPlane {
    pub(crate) c: f32,
    pub(crate) q: [f32; 2],
    pub(crate) most: f32,
    pub(crate) edges: [PixelEdge; 2],
    /// Whether E′ fits an `i32` all over the triangle.
    pub(crate) narrow: bool,
}

impl Triangle {
    /// The triangle's depth at the sample of each pixel.
    #[inline]
    #[must_use]
    pub fn depth(&self, sample: Sample) -> DepthPlane {
        let z = self.corners().map(|corner| corner.z);
        // The least, the first of the sorted corners on a tie; and the other two, sorted.
        let (anchor, others) = if z[0] <= z[1] && z[0] <= z[2] {
            (0, [1, 2])
        } else if z[1] <= z[2] {
            (1, [0, 2])
        } else {
            (2, [0, 1])
        };
        let edges = others.map(|k| Edge::opposite(self, k).at_pixels(sample));
        let delta = others.map(|k| f64::from(z[k]) - f64::from(z[anchor]));
        let area = to_f64(self.area());
        let rest = edges.map(|edge| to_f64(edge.rest));
        let (c, q) = coefficients(f64::from(z[anchor]), delta, rest, area, to_f64(PIXEL));
        DepthPlane {
            c: to_f32(c),
            q: q.map(to_f32),
            most: z[0].max(z[1]).max(z[2]),
            edges,
            narrow: self.area() >> 8 <= i64::from(i32::MAX),
        }
    }
}

impl DepthPlane {
    /// The depth at a pixel that the triangle covers.
    #[inline]
    #[must_use]
    pub fn at(&self, x: u32, y: u32) -> f32 {
        self.value(self.edges.map(|edge| wide_to_f32(edge.at(x, y))))
    }

    /// Bounds on the depth over a rectangle of pixels with these corners. The formula never decreases with E′, in
    /// any of its steps, and E′ is linear, so that it is least, and greatest, in a corner; the depth *at* the corners
    /// is no bound, as the two E′ have their extremes in different ones.
    #[cfg(feature = "alloc")]
    pub(crate) fn range(&self, corners: [(u32, u32); 4]) -> [f32; 2] {
        let values = self.edges.map(|edge| corners.map(|(x, y)| edge.at(x, y)));
        let all = |of: fn(i64, i64) -> i64| values.map(|[a, b, c, d]| wide_to_f32(of(of(a, b), of(c, d))));
        [self.value(all(i64::min)), self.value(all(i64::max))]
    }

    /// The formula. The comparison is written so that it becomes one instruction, the same in every lane.
    #[inline]
    fn value(&self, e: [f32; 2]) -> f32 {
        let z = formula(self.c, self.q, e);
        if z < self.most { z } else { self.most }
    }

    /// Hands the depths of the pixels from x on, along row y, to `visit`, one for each item.
    #[inline]
    pub(crate) fn row<T>(
        &self,
        x: u32,
        y: u32,
        items: impl Iterator<Item = T>,
        mut visit: impl FnMut(T, f32),
    ) {
        let mut e = self.edges.map(|edge| edge.at(x, y));
        for item in items {
            visit(item, self.value(e.map(wide_to_f32)));
            e = [e[0] + self.edges[0].x, e[1] + self.edges[1].x];
        }
    }

    /// The same for many items and a `visit` without branches: where E′ fits an `i32` all over the triangle the loop
    /// runs on those, with the same values, which compilers turn into vector code.
    #[inline]
    pub(crate) fn long_row<T>(
        &self,
        x: u32,
        y: u32,
        items: impl Iterator<Item = T>,
        mut visit: impl FnMut(T, f32),
    ) {
        if !self.narrow {
            self.row(x, y, items, visit);
            return;
        }
        let mut e = self.edges.map(|edge| narrow(edge.at(x, y)));
        let step = self.edges.map(|edge| narrow(edge.x));
        for item in items {
            visit(item, self.value(e.map(narrow_to_f32)));
            // The step past the end of the row may leave the range; it is not used.
            e = [e[0].wrapping_add(step[0]), e[1].wrapping_add(step[1])];
        }
    }
}

#[inline]
#[expect(clippy::cast_precision_loss, reason = "the formula's conversion, correctly rounded")]
const fn wide_to_f32(e: i64) -> f32 {
    e as f32
}

#[inline]
#[expect(clippy::cast_precision_loss, reason = "the formula's conversion, correctly rounded")]
const fn narrow_to_f32(e: i32) -> f32 {
    e as f32
}

#[inline]
#[expect(clippy::cast_possible_truncation, reason = "the caller knows that it fits")]
const fn narrow(e: i64) -> i32 {
    e as i32
}

#[inline]
#[expect(clippy::cast_precision_loss, reason = "below 2⁵³: exact")]
const fn to_f64(value: i64) -> f64 {
    value as f64
}

#[inline]
#[expect(clippy::cast_possible_truncation, reason = "the one rounding of each coefficient")]
const fn to_f32(value: f64) -> f32 {
    value as f32
}

/// A format in which depth is stored and compared.
pub(crate) trait Stored: Copy + PartialOrd {
    /// What is stored for a depth from 0 to 1; never decreasing.
    fn store(z: f32) -> Self;
}

impl Stored for f32 {
    #[inline]
    fn store(z: f32) -> Self {
        z
    }
}

impl Stored for u16 {
    /// 0 is what was cleared, so that visible depth starts at 1. The product is exact in `f64`.
    #[inline]
    #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "from 0 to 65534")]
    fn store(z: f32) -> Self {
        (f64::from(z) * 65534.0) as Self + 1
    }
}
