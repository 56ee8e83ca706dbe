//! Triangles beyond a few blocks: binned by an exact test of each tile, filled by the strips of the immediate path.
//!
//! ```text
//!      ┌────┬────┬────┐        outside: the tile does not hear of it
//!      │    │ ╱  │    │        crossed: strips say which pixels; whole vectors of eight are tested and chosen from
//!      ├────┼╱───┼────┤        inside:  strips as wide as the tile; and what is farther in this tile than
//!      │   ╱│ in │ in │                 the triangle's least depth will never be seen
//!      └──╱─┴────┴────┘
//! ```

use fearless_simd::prelude::*;
use fearless_simd::{Simd, f32x8, f64x4, i32x4, i32x8};

use super::batch::Job;
use super::bins::{BLOCK, Large, SIDE, Segment};
use super::each::{four, two};
use super::kernel::{Test, Tile, half_x, half_y};
use crate::depth::{DepthPlane, formula};
use crate::edge::Edge;
use crate::{Rect, Triangle};

/// Bins a triangle of any size.
pub(crate) fn bin(job: &Job<'_>, triangle: &Triangle, value: u32, segment: &mut Segment) {
    let sample = job.state.sample;
    let rows = triangle.rows(sample, job.clip);
    let columns = triangle.columns(sample, job.clip);
    if rows.is_empty() || columns.is_empty() {
        return;
    }
    let plane = triangle.depth(sample);
    segment.large.push(Large { triangle: *triangle, plane, clip: job.clip, draw: job.draw });
    let edges = [0, 1, 2].map(|k| Edge::opposite(triangle, k));
    let edges = edges.map(|edge| (edge.at_pixels(sample), edge.is_top_left()));
    let occludes = job.occludes();
    let tiles = |range: core::ops::Range<i64>| tile_of(range.start)..=tile_of(range.end - 1);
    for row in tiles(rows) {
        for column in tiles(columns.clone()) {
            let whole = tile_rect(column, row);
            let rect = whole.intersection(job.clip);
            let corners = [
                (rect.x0, rect.y0),
                (rect.x1 - 1, rect.y0),
                (rect.x0, rect.y1 - 1),
                (rect.x1 - 1, rect.y1 - 1),
            ];
            let mut inside = true;
            let mut outside = false;
            for (edge, top_left) in &edges {
                // E is linear: over the tile it is least, and greatest, in a corner.
                let covered = corners.map(|(x, y)| {
                    let e = edge.whole(x, y);
                    e > 0 || (e == 0 && *top_left)
                });
                inside &= covered == [true; 4];
                outside |= covered == [false; 4];
            }
            if outside {
                continue;
            }
            let [least, most] = plane.range(corners);
            let tile = (row * job.columns + column) as usize;
            // What is not inside the clip rectangle is not covered either.
            if inside && occludes && rect == whole.intersection(job.picture) {
                let bound = &mut segment.bins[tile].bound;
                *bound = bound.max(least);
            }
            let large = segment.large.len() - 1;
            segment.bins[tile].push_large(large, most, value);
        }
    }
}

#[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "pixels of a picture")]
const fn tile_of(pixel: i64) -> u32 {
    pixel as u32 / SIDE
}

/// The pixels of a tile.
pub(crate) const fn tile_rect(column: u32, row: u32) -> Rect {
    let (x0, y0) = (column * SIDE, row * SIDE);
    Rect { x0, y0, x1: x0 + SIDE, y1: y0 + SIDE }
}

/// Fills a large triangle's part of a tile.
#[inline(always)]
pub(crate) fn fill<L: Simd, T: Test>(
    simd: L,
    tile: &mut Tile<'_>,
    [column, row]: [u32; 2],
    large: &Large,
    sample: crate::Sample,
    value: u32,
    test: T,
) {
    let rect = tile_rect(column, row);
    // Where nothing is covered the strip is empty. One more than a tile is wide fits, too.
    let mut spans = [[SIDE.cast_signed(), 0]; SIDE as usize];
    let (mut first, mut end) = (SIDE, 0);
    for strip in large.triangle.strips(sample, rect.intersection(large.clip)) {
        let y = strip.y - rect.y0;
        spans[y as usize % SIDE as usize] = [strip.x0 - rect.x0, strip.x1 - rect.x0].map(u32::cast_signed);
        first = first.min(y);
        end = y + 1;
    }
    if first >= end {
        return;
    }
    let blocks = first / BLOCK..end.div_ceil(BLOCK);
    if large.plane.narrow {
        rows(simd, tile, &spans, blocks, Narrow::new(simd, &large.plane, rect), &large.plane, value, test);
    } else {
        rows(simd, tile, &spans, blocks, Wide::new(simd, &large.plane, rect), &large.plane, value, test);
    }
}

/// Fills the blocks that the strips touch, row of blocks by row of blocks.
#[inline(always)]
#[expect(clippy::too_many_arguments, reason = "inlined")]
fn rows<L: Simd, E: Walk<L>, T: Test>(
    simd: L,
    tile: &mut Tile<'_>,
    spans: &[[i32; 2]; SIDE as usize],
    blocks: core::ops::Range<u32>,
    start: E,
    plane: &DepthPlane,
    value: u32,
    test: T,
) {
    let (c, most) = (f32x8::splat(simd, plane.c), f32x8::splat(simd, plane.most));
    let q = two(
        #[inline(always)]
        |k| f32x8::splat(simd, plane.q[k]),
    );
    let columns = half_x(simd);
    for row in blocks {
        let first = (row * BLOCK) as usize % SIDE as usize;
        let four = four(
            #[inline(always)]
            |k| spans[(first + k) % SIDE as usize],
        );
        let [begin, end] = extent(four);
        let [starts, ends] = two(
            #[inline(always)]
            |side| {
                two(
                    #[inline(always)]
                    |half| pair(simd, four[2 * half][side], four[2 * half + 1][side]),
                )
            },
        );
        let mut e = start.at(begin * BLOCK, row * BLOCK);
        let mut x = columns + (begin * BLOCK).cast_signed();
        for block in begin..end {
            let at = (row * (SIDE / BLOCK) + block) as usize;
            let inside = two(
                #[inline(always)]
                |half| x.simd_ge(starts[half]) & x.simd_lt(ends[half]),
            );
            tile.put(simd, at, 0, formula(c, q, e.half(0)).min(most), inside[0], value, test);
            tile.put(simd, at, 1, formula(c, q, e.half(1)).min(most), inside[1], value, test);
            e = e.step();
            x += BLOCK.cast_signed();
        }
    }
}

/// The first block that four rows touch, and one past the last.
#[inline(always)]
fn extent([a, b, c, d]: [[i32; 2]; 4]) -> [u32; 2] {
    let begin = a[0].min(b[0]).min(c[0]).min(d[0]).cast_unsigned() / BLOCK;
    [begin, a[1].max(b[1]).max(c[1]).max(d[1]).cast_unsigned().div_ceil(BLOCK)]
}

/// A value for each of the two rows of half a block.
#[inline(always)]
fn pair<L: Simd>(simd: L, upper: i32, lower: i32) -> i32x8<L> {
    i32x4::splat(simd, upper).combine(i32x4::splat(simd, lower))
}

/// The two edge values of the depth formula at the pixels of a block.
trait Walk<L: Simd>: Copy {
    /// At the block whose first pixel is (x, y) of the tile.
    fn at(&self, x: u32, y: u32) -> Self;
    /// One block to the right.
    fn step(&self) -> Self;
    /// Of the upper or the lower two rows, as the formula wants them.
    fn half(&self, half: usize) -> [f32x8<L>; 2];
}

/// In `i32`: right wherever the triangle covers a pixel; elsewhere they may wrap, and nobody looks.
#[derive(Clone, Copy)]
struct Narrow<L: Simd> {
    e: [i32x8<L>; 2],
    x: [i32; 2],
    y: [i32; 2],
}

impl<L: Simd> Narrow<L> {
    #[inline(always)]
    #[expect(clippy::cast_possible_truncation, reason = "wraps where nothing is covered")]
    fn new(simd: L, plane: &DepthPlane, rect: Rect) -> Self {
        let [p, q] = &plane.edges;
        let (x, y) = ([p.x as i32, q.x as i32], [p.y as i32, q.y as i32]);
        let first = [p.at(rect.x0, rect.y0) as i32, q.at(rect.x0, rect.y0) as i32];
        let (half_x, half_y) = (half_x(simd), half_y(simd));
        Self {
            e: two(
                #[inline(always)]
                |k| half_x * x[k] + half_y * y[k] + first[k],
            ),
            x,
            y,
        }
    }
}

impl<L: Simd> Walk<L> for Narrow<L> {
    #[inline(always)]
    fn at(&self, x: u32, y: u32) -> Self {
        let [x, y] = [x.cast_signed(), y.cast_signed()];
        let far = [
            self.x[0].wrapping_mul(x).wrapping_add(self.y[0].wrapping_mul(y)),
            self.x[1].wrapping_mul(x).wrapping_add(self.y[1].wrapping_mul(y)),
        ];
        Self { e: [self.e[0] + far[0], self.e[1] + far[1]], ..*self }
    }

    #[inline(always)]
    fn step(&self) -> Self {
        let block = BLOCK.cast_signed();
        let e = [self.e[0] + self.x[0].wrapping_mul(block), self.e[1] + self.x[1].wrapping_mul(block)];
        Self { e, ..*self }
    }

    #[inline(always)]
    fn half(&self, half: usize) -> [f32x8<L>; 2] {
        let down = |k: usize| if half == 0 { 0 } else { self.y[k].wrapping_mul(2) };
        [(self.e[0] + down(0)).to_float(), (self.e[1] + down(1)).to_float()]
    }
}

/// In `f64`, where all edge values are whole numbers below 2⁵³: exact.
#[derive(Clone, Copy)]
struct Wide<L: Simd> {
    e: [[f64x4<L>; 2]; 2],
    x: [f64; 2],
    y: [f64; 2],
}

impl<L: Simd> Wide<L> {
    #[inline(always)]
    #[expect(clippy::cast_precision_loss, reason = "below 2⁵³")]
    fn new(simd: L, plane: &DepthPlane, rect: Rect) -> Self {
        let [p, q] = &plane.edges;
        let (x, y) = ([p.x as f64, q.x as f64], [p.y as f64, q.y as f64]);
        let first = [p.at(rect.x0, rect.y0) as f64, q.at(rect.x0, rect.y0) as f64];
        let columns = f64x4::simd_from(simd, [0.0, 1.0, 2.0, 3.0]);
        let upper = two(
            #[inline(always)]
            |k| columns * x[k] + first[k],
        );
        Self { e: [[upper[0], upper[0] + y[0]], [upper[1], upper[1] + y[1]]], x, y }
    }

    #[inline(always)]
    fn moved(&self, far: [f64; 2]) -> Self {
        let [p, q] = self.e;
        Self { e: [[p[0] + far[0], p[1] + far[0]], [q[0] + far[1], q[1] + far[1]]], ..*self }
    }
}

impl<L: Simd> Walk<L> for Wide<L> {
    #[inline(always)]
    fn at(&self, x: u32, y: u32) -> Self {
        let [x, y] = [f64::from(x), f64::from(y)];
        self.moved([self.x[0] * x + self.y[0] * y, self.x[1] * x + self.y[1] * y])
    }

    #[inline(always)]
    fn step(&self) -> Self {
        self.moved([self.x[0] * f64::from(BLOCK), self.x[1] * f64::from(BLOCK)])
    }

    #[inline(always)]
    fn half(&self, half: usize) -> [f32x8<L>; 2] {
        let [p, q] = if half == 0 { self.e } else { self.moved([2.0 * self.y[0], 2.0 * self.y[1]]).e };
        [p[0].narrow(p[1]), q[0].narrow(q[1])]
    }
}
