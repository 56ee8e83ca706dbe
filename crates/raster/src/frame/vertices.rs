//! Vertices to the sub-pixel grid, eight at a time.
//!
//! The same expression in the same order as `snap` and `transform`, in lanes, for vertices that lie *plainly*
//! inside all clip planes: a comparison in `f32` that is sure. The others are marked, and their triangles take the
//! scalar way through the clipper.

use fearless_simd::prelude::*;
use fearless_simd::{Simd, f32x4, f32x8, f64x4, i32x4, i32x8, i64x4};
use polosa_math::Viewport;
use polosa_math::viewport::sub_pixels;

use super::each::{four, two};
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

    /// Some of them from `first` on, if they need no transform and all are there: no copy, which the loads of
    /// vectors would have to wait for.
    #[inline(always)]
    pub(crate) fn lent<const N: usize>(&self, first: usize) -> Option<&[Clip; N]> {
        match self {
            Self::Clip(vertices) => vertices.get(first..)?.first_chunk(),
            Self::Model { .. } => None,
        }
    }

    /// Some of them from `first` on, as many as there are; the rest as NaN, which nothing is drawn of.
    #[inline(always)]
    pub(crate) fn made<const N: usize>(&self, first: usize) -> [Clip; N] {
        let mut made = [[f32::NAN; 4]; N];
        match self {
            Self::Clip(vertices) => {
                for (to, from) in made.iter_mut().zip(vertices.get(first..).unwrap_or_default()) {
                    *to = *from;
                }
            }
            Self::Model { matrix, positions } => {
                for (to, &from) in made.iter_mut().zip(positions.get(first..).unwrap_or_default()) {
                    *to = transform_point(matrix, from);
                }
            }
        }
        made
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
pub(crate) fn lanes<L: Simd>(simd: L, vertices: [[Snapped; 2]; 4]) -> [i32x8<L>; 4] {
    let half = two(
        #[inline(always)]
        |h| {
            i32x4::load_four_interleaved(
                simd,
                four(
                    #[inline(always)]
                    |k| vertices[k][h],
                )
                .as_flattened(),
            )
        },
    );
    four(
        #[inline(always)]
        |k| half[0][k].combine(half[1][k]),
    )
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
        let clip: &[Clip; LANES] = match vertices.lent(first) {
            Some(lent) => lent,
            None => &vertices.made(first),
        };
        let clip = four(
            #[inline(always)]
            |k| [clip[k], clip[4 + k]],
        );
        let [x, y, z, mark] = self.lanes(simd, clip);
        let mut snapped = [[0; 4]; LANES];
        let (low, high) = snapped.as_flattened_mut().split_at_mut(4 * LANES / 2);
        let [x, y, z, mark] = [x.split(), y.split(), z.split(), mark.split()];
        i32x4::store_four_interleaved([x.0, y.0, z.0, mark.0], low);
        i32x4::store_four_interleaved([x.1, y.1, z.1, mark.1], high);
        snapped
    }

    /// Snaps eight vertices: the first and the fifth, the second and the sixth, and so on.
    #[inline(always)]
    pub(crate) fn lanes<L: Simd>(&self, simd: L, clip: [[Clip; 2]; 4]) -> [i32x8<L>; 4] {
        // Below and above these, products of w with a bound could leave the range of normal numbers.
        const LEAST_W: f32 = 1e-30;
        const MOST_W: f32 = 1e30;
        let half = two(
            #[inline(always)]
            |h| {
                f32x4::load_four_interleaved(
                    simd,
                    four(
                        #[inline(always)]
                        |k| clip[k][h],
                    )
                    .as_flattened(),
                )
            },
        );
        let [x, y, z, w] = four(
            #[inline(always)]
            |k| half[0][k].combine(half[1][k]),
        );
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
        let (x, y, z) = if (scale.simd_eq(one)).all_true() {
            (self.place(simd, x, None, 0), self.place(simd, y, None, 1), z + 0.0)
        } else {
            let (low, high) = z.widen();
            let w = scale.widen();
            let z = (low / w.0 + 0.0).narrow(high / w.1 + 0.0);
            (self.place(simd, x, Some(w), 0), self.place(simd, y, Some(w), 1), z)
        };
        let mark = plain.select(i32x8::splat(simd, PLAIN), i32x8::splat(simd, UNSURE));
        [x, y, z.bitcast(), mark]
    }

    /// Where eight coordinates land; without w it is 1.
    #[inline(always)]
    fn place<L: Simd>(&self, simd: L, v: f32x8<L>, w: Option<(f64x4<L>, f64x4<L>)>, axis: usize) -> i32x8<L> {
        let scale = f64x4::splat(simd, self.viewport.scale[axis]);
        let offset = f64x4::splat(simd, self.viewport.offset[axis]);
        let (low, high) = v.widen();
        let (low, high) = match w {
            None => (low * scale + offset, high * scale + offset),
            Some(w) => (sub_pixels(low, w.0, scale, offset), sub_pixels(high, w.1, scale, offset)),
        };
        (low + ROUND).bitcast::<i64x4<L>>().narrow((high + ROUND).bitcast())
    }
}
