//! Triangles beyond a few blocks: binned by an exact test of each tile, filled by the strips of the immediate path.
//!
//! ```text
//!      ┌────┬────┬────┐        outside: the tile does not hear of it
//!      │    │ ╱  │    │        crossed: strips say which pixels; whole vectors of eight are tested and chosen from
//!      ├────┼╱───┼────┤        inside:  every pixel, no question asked; and what is farther in this tile than
//!      │   ╱│ in │ in │                 the triangle's least depth will never be seen
//!      └──╱─┴────┴────┘
//! ```

use fearless_simd::prelude::*;
use fearless_simd::{Simd, f32x8, f64x4, i32x8};

use super::batch::Job;
use super::bins::{AREA, BLOCK, Large, SIDE, Segment};
use super::kernel::{Test, Tile, half_x, half_y};
use crate::depth::{DepthPlane, formula};
use crate::edge::Edge;
use crate::{Rect, Triangle};

/// Bins a triangle of any size.
pub(crate) fn bin(job: &Job<'_>, triangle: &Triangle, value: u32, segment: &mut Segment) {
    let sample = job.state.sample;
    let plane = triangle.depth(sample);
    segment.large.push(Large { triangle: *triangle, plane, clip: job.clip, draw: job.draw });
    let rows = triangle.rows(sample, job.clip);
    let columns = triangle.columns(sample, job.clip);
    if rows.is_empty() || columns.is_empty() {
        return;
    }
    let edges = [0, 1, 2].map(|k| Edge::opposite(triangle, k));
    let edges = edges.map(|edge| (edge.at_pixels(sample), edge.is_top_left()));
    let occludes = job.occludes();
    let tiles = |range: core::ops::Range<i64>| tile_of(range.start)..=tile_of(range.end - 1);
    for row in tiles(rows) {
        for column in tiles(columns.clone()) {
            let whole = tile_rect(column, row);
            let rect = whole.intersection(job.clip);
            let corners = [(rect.x0, rect.y0), (rect.x1 - 1, rect.y0), (rect.x0, rect.y1 - 1), (rect.x1 - 1, rect.y1 - 1)];
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
            segment.bin_large(tile, most, value);
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
    let splat = |v: f32| f32x8::splat(simd, v);
    let (c, q, most) = (splat(plane.c), plane.q.map(splat), splat(plane.most));
    let columns = half_x(simd);
    for row in blocks {
        let [a, b, c4, d] = [0, 1, 2, 3].map(|k| spans[(row * BLOCK + k) as usize % SIDE as usize]);
        let begin = a[0].min(b[0]).min(c4[0]).min(d[0]).cast_unsigned() / BLOCK;
        let end = a[1].max(b[1]).max(c4[1]).max(d[1]).cast_unsigned().div_ceil(BLOCK);
        let pair = |p: i32, q: i32| i32x8::simd_from(simd, [p, p, p, p, q, q, q, q]);
        let starts = [pair(a[0], b[0]), pair(c4[0], d[0])];
        let ends = [pair(a[1], b[1]), pair(c4[1], d[1])];
        let mut e = start.at(begin * BLOCK, row * BLOCK);
        let mut x = columns + (begin * BLOCK).cast_signed();
        for block in begin..end {
            let at = (row * (SIDE / BLOCK) + block) as usize;
            for half in [0, 1] {
                let z = formula(c, q, e.half(half)).min(most);
                let inside = x.simd_ge(starts[half]) & x.simd_lt(ends[half]);
                tile.put(simd, at, half, z, inside, value, test);
            }
            e = e.step();
            x += BLOCK.cast_signed();
        }
    }
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
        let first = plane.edges.map(|edge| edge.at(rect.x0, rect.y0) as i32);
        let (x, y) = (plane.edges.map(|edge| edge.x as i32), plane.edges.map(|edge| edge.y as i32));
        Self { e: [0, 1].map(|k: usize| half_x(simd) * x[k] + half_y(simd) * y[k] + first[k]), x, y }
    }
}

impl<L: Simd> Walk<L> for Narrow<L> {
    #[inline(always)]
    fn at(&self, x: u32, y: u32) -> Self {
        let [x, y] = [x, y].map(u32::cast_signed);
        let far = |k: usize| self.x[k].wrapping_mul(x).wrapping_add(self.y[k].wrapping_mul(y));
        Self { e: [self.e[0] + far(0), self.e[1] + far(1)], ..*self }
    }

    #[inline(always)]
    fn step(&self) -> Self {
        Self { e: [0, 1].map(|k: usize| self.e[k] + self.x[k].wrapping_mul(BLOCK.cast_signed())), ..*self }
    }

    #[inline(always)]
    fn half(&self, half: usize) -> [f32x8<L>; 2] {
        let down = |k: usize| if half == 0 { self.e[k] } else { self.e[k] + self.y[k].wrapping_mul(2) };
        [down(0).to_float(), down(1).to_float()]
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
        let first = plane.edges.map(|edge| edge.at(rect.x0, rect.y0) as f64);
        let (x, y) = (plane.edges.map(|edge| edge.x as f64), plane.edges.map(|edge| edge.y as f64));
        let columns = f64x4::simd_from(simd, [0.0, 1.0, 2.0, 3.0]);
        let e = [0, 1].map(|k: usize| {
            let upper = columns * x[k] + first[k];
            [upper, upper + y[k]]
        });
        Self { e, x, y }
    }
}

impl<L: Simd> Walk<L> for Wide<L> {
    #[inline(always)]
    fn at(&self, x: u32, y: u32) -> Self {
        let far = |k: usize| self.x[k] * f64::from(x) + self.y[k] * f64::from(y);
        Self { e: [0, 1].map(|k: usize| self.e[k].map(|e| e + far(k))), ..*self }
    }

    #[inline(always)]
    fn step(&self) -> Self {
        Self { e: [0, 1].map(|k: usize| self.e[k].map(|e| e + self.x[k] * f64::from(BLOCK))), ..*self }
    }

    #[inline(always)]
    fn half(&self, half: usize) -> [f32x8<L>; 2] {
        [0, 1].map(|k: usize| {
            let [upper, lower] = self.e[k];
            let down = if half == 0 { 0.0 } else { 2.0 * self.y[k] };
            (upper + down).narrow(lower + down)
        })
    }
}

const _: () = assert!(AREA == 4096);
