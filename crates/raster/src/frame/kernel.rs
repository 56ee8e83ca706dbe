//! Eight pixels at a time: the depth test and the choice, in a tile's memory.

use fearless_simd::prelude::*;
use fearless_simd::{Simd, f32x8, i32x8, mask32x8, u32x8};

use super::bins::{AREA, BLOCK, SIDE, Small};
use super::each::{three, two};
use crate::DepthTest;
use crate::depth::formula;

/// A tile's memory: depths and values, block by block.
#[derive(Debug)]
pub(crate) struct Tile<'a> {
    pub(crate) depths: &'a mut [f32; AREA],
    pub(crate) values: &'a mut [u32; AREA],
}

/// The columns of half a block: two rows of four.
#[inline(always)]
pub(crate) fn half_x<L: Simd>(simd: L) -> i32x8<L> {
    i32x8::simd_from(simd, [0, 1, 2, 3, 0, 1, 2, 3])
}

/// The rows of half a block.
#[inline(always)]
pub(crate) fn half_y<L: Simd>(simd: L) -> i32x8<L> {
    i32x8::simd_from(simd, [0, 0, 0, 0, 1, 1, 1, 1])
}

/// What becomes of a depth and a stored one.
pub(crate) trait Test: Copy {
    /// The depth to store, and which pixels take the new value: none but those that are `inside`.
    fn lanes<L: Simd>(
        self,
        simd: L,
        new: f32x8<L>,
        inside: mask32x8<L>,
        old: f32x8<L>,
    ) -> (f32x8<L>, mask32x8<L>);

    /// The same for one pixel.
    fn one(self, new: f32, old: f32) -> (f32, bool, bool);

    /// Whether what is nowhere nearer than `z` is hidden where everything is at least as near as `bound`.
    fn is_hidden(self, z: f32, bound: f32) -> bool;
}

/// The nearer, stored as it is: what nearly every draw asks for. No stored depth may be NaN.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Nearer;

impl Test for Nearer {
    /// By the greater of two numbers, not by choice: compilers make masked stores of choices, which are slow.
    #[inline(always)]
    fn lanes<L: Simd>(
        self,
        simd: L,
        new: f32x8<L>,
        inside: mask32x8<L>,
        old: f32x8<L>,
    ) -> (f32x8<L>, mask32x8<L>) {
        let new = inside.select(new, f32x8::splat(simd, f32::NEG_INFINITY));
        (new.max(old), new.simd_gt(old))
    }

    #[inline(always)]
    fn one(self, new: f32, old: f32) -> (f32, bool, bool) {
        (new, new > old, new > old)
    }

    #[inline(always)]
    fn is_hidden(self, z: f32, bound: f32) -> bool {
        z < bound
    }
}

/// Any test, any format.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Any {
    pub(crate) test: DepthTest,
    pub(crate) write: bool,
    /// Whether depths are compared as `u16` values, which a tile holds as whole `f32` numbers.
    pub(crate) quantised: bool,
}

impl Test for Any {
    #[inline(always)]
    fn lanes<L: Simd>(
        self,
        simd: L,
        new: f32x8<L>,
        inside: mask32x8<L>,
        old: f32x8<L>,
    ) -> (f32x8<L>, mask32x8<L>) {
        let new = if self.quantised {
            let (low, high) = new.widen();
            let steps = f64::from(u16::MAX - 1);
            ((low * steps).trunc() + 1.0).narrow((high * steps).trunc() + 1.0)
        } else {
            new
        };
        let passes = match self.test {
            DepthTest::Greater => new.simd_gt(old),
            DepthTest::Less => new.simd_lt(old),
            DepthTest::Off => mask32x8::splat(simd, true),
        } & inside;
        let writes = passes & mask32x8::splat(simd, self.write);
        (writes.select(new, old), passes)
    }

    #[inline(always)]
    fn one(self, new: f32, old: f32) -> (f32, bool, bool) {
        let new = self.stored(new);
        let passes = self.test.passes(new, old);
        (new, passes, passes && self.write)
    }

    /// As they are stored: a nearer depth may be stored as the same number, and then the first drawn wins.
    #[inline(always)]
    fn is_hidden(self, z: f32, bound: f32) -> bool {
        bound >= 0.0 && self.stored(z) < self.stored(bound)
    }
}

impl Any {
    /// A depth as a tile stores it.
    #[inline]
    pub(crate) fn stored(self, z: f32) -> f32 {
        use crate::depth::Stored;
        if self.quantised { f32::from(<u16 as Stored>::store(z)) } else { z }
    }
}

impl Tile<'_> {
    /// Puts a value where a triangle is inside and passes, in one half of a block.
    #[inline(always)]
    #[expect(clippy::too_many_arguments, reason = "inlined")]
    pub(crate) fn put<L: Simd, T: Test>(
        &mut self,
        simd: L,
        block: usize,
        half: usize,
        z: f32x8<L>,
        inside: mask32x8<L>,
        value: u32,
        test: T,
    ) {
        let at = (block * 2 + half) % (AREA / 8);
        let depths = &mut self.depths.as_chunks_mut::<8>().0[at];
        let values = &mut self.values.as_chunks_mut::<8>().0[at];
        let old = f32x8::load_array_ref(simd, depths);
        let (depth, draws) = test.lanes(simd, z, inside, old);
        depth.store_array(depths);
        let there = u32x8::load_array_ref(simd, values);
        draws.select(u32x8::splat(simd, value), there).store_array(values);
    }

    /// Fills a small triangle's part of the tile whose first pixel is (x, y).
    #[inline(always)]
    pub(crate) fn small<L: Simd, T: Test>(
        &mut self,
        simd: L,
        [x, y]: [u32; 2],
        small: &Small,
        value: u32,
        test: T,
    ) {
        let [x0, y0, x1, y1] = small.extent.map(u32::from);
        // The blocks of the tile that the triangle's box touches.
        let first = |from: u32, origin: u32| from.saturating_sub(origin) / BLOCK;
        let end = |to: u32, origin: u32| (to - origin).min(SIDE).div_ceil(BLOCK);
        let (columns, rows) = (first(x0, x)..end(x1, x), first(y0, y)..end(y1, y));
        let dx = (x + columns.start * BLOCK).wrapping_sub(x0).cast_signed();
        let dy = (y + rows.start * BLOCK).wrapping_sub(y0).cast_signed();
        let (c, most) = (f32x8::splat(simd, small.c), f32x8::splat(simd, small.most));
        let q = two(
            #[inline(always)]
            |k| f32x8::splat(simd, small.q[k]),
        );
        let more = two(
            #[inline(always)]
            |k| i32x8::splat(simd, small.more()[k]),
        );
        let (half_x, half_y) = (half_x(simd), half_y(simd));
        let mut row = three(
            #[inline(always)]
            |k| {
                let far = small.x[k].wrapping_mul(dx).wrapping_add(small.y[k].wrapping_mul(dy));
                half_x * small.x[k] + half_y * small.y[k] + small.e[k].wrapping_add(far)
            },
        );
        let right = three(
            #[inline(always)]
            |k| i32x8::splat(simd, small.x[k].wrapping_mul(BLOCK.cast_signed())),
        );
        let down = three(
            #[inline(always)]
            |k| i32x8::splat(simd, small.y[k].wrapping_mul(2)),
        );
        for y in rows {
            let mut upper = row;
            let mut lower = three(
                #[inline(always)]
                |k| row[k] + down[k],
            );
            row = three(
                #[inline(always)]
                |k| lower[k] + down[k],
            );
            for x in columns.clone() {
                let block = (y * (SIDE / BLOCK) + x) as usize;
                self.half(simd, block, 0, upper, more, (c, q, most), value, test);
                self.half(simd, block, 1, lower, more, (c, q, most), value, test);
                upper = three(
                    #[inline(always)]
                    |k| upper[k] + right[k],
                );
                lower = three(
                    #[inline(always)]
                    |k| lower[k] + right[k],
                );
            }
        }
    }

    /// Half a block of a small triangle, from its edge values.
    #[inline(always)]
    #[expect(clippy::too_many_arguments, reason = "inlined")]
    fn half<L: Simd, T: Test>(
        &mut self,
        simd: L,
        block: usize,
        half: usize,
        e: [i32x8<L>; 3],
        more: [i32x8<L>; 2],
        (c, q, most): (f32x8<L>, [f32x8<L>; 2], f32x8<L>),
        value: u32,
        test: T,
    ) {
        let inside = (e[0] | e[1] | e[2]).simd_ge(0);
        let z = formula(c, q, [(e[0] + more[0]).to_float(), (e[1] + more[1]).to_float()]);
        self.put(simd, block, half, z.min(most), inside, value, test);
    }
}
