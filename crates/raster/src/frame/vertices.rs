//! Vertices to the sub-pixel grid, eight at a time.
//!
//! The same expression in the same order as `snap` and `transform`, in lanes, for vertices that lie *plainly*
//! inside all clip planes: a comparison in `f32` that is sure. The others are marked, and their triangles take the
//! scalar way through the clipper.

use fearless_simd::prelude::*;
use fearless_simd::{Simd, f32x4, f32x8, f64x4, i32x4, i32x8, i64x4};
use polosa_math::Viewport;
use polosa_math::viewport::sub_pixels;

use crate::snap::{GUARD, ROUND};
use crate::transform::transform_point;
use crate::{Clip, Columns, Space};

/// Lanes of a batch.
pub(crate) const LANES: usize = 8;

/// Where a frame's vertices come from.
#[derive(Clone, Copy, Debug)]
pub enum Vertices<'a> {
    /// They are in clip space (or on the screen: [`Space`](crate::Space)).
    Clip(&'a [Clip]),
    /// They are positions; [`transform_point`](crate::transform_point) takes them to clip space.
    Model {
        /// Model to clip space.
        matrix: &'a Columns,
        /// In model space.
        positions: &'a [[f32; 3]],
    },
}

impl Vertices<'_> {
    /// How many there are.
    #[must_use]
    pub const fn len(&self) -> usize {
        match self {
            Self::Clip(vertices) => vertices.len(),
            Self::Model { positions, .. } => positions.len(),
        }
    }

    /// Whether there are none.
    #[must_use]
    pub const fn is_empty(&self) -> bool {
        self.len() == 0
    }

    /// One of them in clip space.
    #[must_use]
    pub fn get(&self, index: usize) -> Option<Clip> {
        match self {
            Self::Clip(vertices) => vertices.get(index).copied(),
            Self::Model { matrix, positions } => positions.get(index).map(|&p| transform_point(matrix, p)),
        }
    }

    /// Eight of them from `first` on, as many as there are; the rest as NaN, which nothing is drawn of.
    #[inline(always)]
    fn block(&self, first: usize) -> [Clip; LANES] {
        let mut block = [[f32::NAN; 4]; LANES];
        match self {
            Self::Clip(vertices) => {
                let given = vertices.get(first..).unwrap_or_default();
                match given.first_chunk() {
                    Some(whole) => block = *whole,
                    None => block[..given.len()].copy_from_slice(given),
                }
            }
            Self::Model { matrix, positions } => {
                for (to, &from) in block.iter_mut().zip(positions.get(first..).unwrap_or_default()) {
                    *to = transform_point(matrix, from);
                }
            }
        }
        block
    }
}

/// A snapped vertex: x and y in sub-pixels, the bits of its depth, and whether it is [`PLAIN`].
pub(crate) type Snapped = [i32; 4];

/// Plainly inside all clip planes.
pub(crate) const PLAIN: i32 = 0;
/// Perhaps not: the clipper decides.
pub(crate) const UNSURE: i32 = 1;
/// Eight snapped vertices as lanes: x, y, the bits of depth, and the marks.
#[inline(always)]
pub(crate) fn lanes<L: Simd>(simd: L, vertices: &[Snapped; LANES]) -> [i32x8<L>; 4] {
    let (low, high) = vertices.as_flattened().split_at(4 * LANES / 2);
    let low = i32x4::load_four_interleaved(simd, low);
    let high = i32x4::load_four_interleaved(simd, high);
    [0, 1, 2, 3].map(|k: usize| low[k].combine(high[k]))
}

/// Not there.
pub(crate) const MISSING: i32 = 2;

/// What snapping needs to know of a picture.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Snapper {
    space: Space,
    viewport: Viewport,
    /// How far from the middle a plain vertex may be, in units of w (on the screen: in pixels).
    reach: [f32; 2],
}

impl Snapper {
    #[expect(clippy::cast_possible_truncation, reason = "a bound with room to spare")]
    pub(crate) fn new(space: Space, viewport: Viewport) -> Self {
        // Where |x| <= reach·w, |x/w·s| + o <= 0.99 of the guard band, far more than any rounding takes.
        let reach = |k: usize| {
            ((0.99 * f64::from(GUARD) - viewport.offset[k].abs()) / viewport.scale[k].abs()) as f32
        };
        Self { space, viewport, reach: [reach(0), reach(1)] }
    }

    /// Snaps the vertices from `first` on.
    #[inline(always)]
    pub(crate) fn block<L: Simd>(&self, simd: L, vertices: &Vertices<'_>, first: usize) -> [Snapped; LANES] {
        // Below and above these, products of w with a bound could leave the range of normal numbers.
        const LEAST_W: f32 = 1e-30;
        const MOST_W: f32 = 1e30;
        let block = vertices.block(first);
        let (low, high) = block.as_flattened().split_at(4 * LANES / 2);
        let low = f32x4::load_four_interleaved(simd, low);
        let high = f32x4::load_four_interleaved(simd, high);
        let [x, y, z, w] = [0, 1, 2, 3].map(|k: usize| low[k].combine(high[k]));
        let one = f32x8::splat(simd, 1.0);
        let (bound, scale) = match self.space {
            Space::Clip => (w, w),
            Space::Screen => (one, one),
        };
        let plain = z.simd_ge(0.0)
            & z.simd_le(bound)
            & w.simd_ge(LEAST_W)
            & w.simd_le(MOST_W)
            & x.abs().simd_le(bound * self.reach[0])
            & y.abs().simd_le(bound * self.reach[1]);
        // Division by 1 changes no bit; not to divide saves half of the time.
        let undivided = (scale.simd_eq(one)).all_true();
        let (w_low, w_high) = scale.widen();
        let place = |v: f32x8<L>, k: usize| {
            let [s, o] = [self.viewport.scale[k], self.viewport.offset[k]].map(|v| f64x4::splat(simd, v));
            let (low, high) = v.widen();
            let [low, high] = if undivided {
                [low * s + o, high * s + o]
            } else {
                [sub_pixels(low, w_low, s, o), sub_pixels(high, w_high, s, o)]
            };
            let bits = |v: f64x4<L>| (v + ROUND).bitcast::<i64x4<L>>();
            bits(low).narrow(bits(high))
        };
        let depth = if undivided {
            z + 0.0
        } else {
            let (low, high) = z.widen();
            (low / w_low + 0.0).narrow(high / w_high + 0.0)
        };
        let mark = plain.select(i32x8::splat(simd, PLAIN), i32x8::splat(simd, UNSURE));
        let mut snapped = [[0; 4]; LANES];
        let lanes = [place(x, 0), place(y, 1), depth.bitcast(), mark];
        let (low, high) = snapped.as_flattened_mut().split_at_mut(4 * LANES / 2);
        let halves = lanes.map(SimdSplit::split);
        i32x4::store_four_interleaved(halves.map(|half| half.0), low);
        i32x4::store_four_interleaved(halves.map(|half| half.1), high);
        snapped
    }
}
