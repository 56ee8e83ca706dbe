//! The loop that no fill can beat: depth test and store over memory that stays in the nearest cache.
//!
//! A tile of 64×64 pixels, each a depth and an id, wholly covered by one triangle. What is left of filling is then
//! the depth formula of the exact path, one strict comparison, and two selects:
//!
//! ```text
//!   E1, E2 ── to f32 ──▶ z = min((c + E1·q1) + E2·q2, zmax) ──▶ z > depth? ──▶ depth, id
//!   i32, a step a pixel                                          strictly      selected, stored
//! ```
//!
//! No edge is tested, nothing is set up, no cache is missed: pixels per second here bound those of every fill that
//! keeps depth and ids as `f32` and `u32`. The loop is written once for the compiler to vectorise and once with
//! explicit lanes; both are run at the instruction sets that the machine has, and give the same bits.

use fearless_simd::{Level, Simd, dispatch, f32x8, i32x8, prelude::*, u32x8};

/// Pixels along a side of the tile.
pub const SIDE: usize = 64;

/// Depth and id of the pixels of a tile, row by row: 32 KiB together.
#[derive(Clone, Debug, PartialEq)]
pub struct Tile {
    /// Larger is nearer.
    pub depth: Vec<f32>,
    /// What was drawn.
    pub ids: Vec<u32>,
}

impl Default for Tile {
    /// Nothing drawn.
    fn default() -> Self {
        Self { depth: vec![0.0; SIDE * SIDE], ids: vec![0; SIDE * SIDE] }
    }
}

/// A triangle's depth over the tile, as the exact path has it.
#[derive(Clone, Copy, Debug)]
pub struct Plane {
    /// Edge values of two edges at the tile's first pixel.
    pub start: [i32; 2],
    /// What they gain from a pixel to the next.
    pub across: [i32; 2],
    /// What they gain from a row to the next.
    pub down: [i32; 2],
    /// The depth where both edge values are 0.
    pub c: f32,
    /// What each unit of an edge value adds.
    pub q: [f32; 2],
    /// The largest depth of the triangle's corners.
    pub zmax: f32,
}

impl Plane {
    /// A plane that falls and rises by some percent over the tile; `c` decides who is in front.
    #[must_use]
    pub const fn sample(c: f32) -> Self {
        Self { start: [1_200, 90_000], across: [37, -11], down: [-5, 29], c, q: [1.5e-5, 2.5e-7], zmax: 0.98 }
    }

    fn row(&self, y: usize) -> [i32; 2] {
        [0, 1].map(|k| self.start[k] + self.down[k] * y as i32)
    }
}

/// As one writes it first: the compiler vectorises it for what the build targets (SSE2 on x86-64).
pub fn plain(tile: &mut Tile, plane: &Plane, id: u32) {
    plain_here(tile, plane, id);
}

/// The same text, compiled for the instruction set of `level`.
pub fn plain_at(level: Level, tile: &mut Tile, plane: &Plane, id: u32) {
    dispatch!(level, simd => simd.vectorize(#[inline(always)] || plain_here(tile, plane, id)));
}

/// Eight lanes, said explicitly.
pub fn lanes(level: Level, tile: &mut Tile, plane: &Plane, id: u32) {
    dispatch!(level, simd => lanes_of(simd, tile, plane, id));
}

#[inline(always)]
fn plain_here(tile: &mut Tile, plane: &Plane, id: u32) {
    let Plane { across, c, q, zmax, .. } = *plane;
    let rows = tile.depth.chunks_exact_mut(SIDE).zip(tile.ids.chunks_exact_mut(SIDE));
    for (y, (depths, ids)) in rows.enumerate() {
        let [e1, e2] = plane.row(y);
        for (x, (depth, pixel)) in depths.iter_mut().zip(ids).enumerate() {
            let [e1, e2] = [e1 + across[0] * x as i32, e2 + across[1] * x as i32];
            let z = (c + e1 as f32 * q[0]) + e2 as f32 * q[1];
            let z = if z < zmax { z } else { zmax };
            let nearer = z > *depth;
            *depth = if nearer { z } else { *depth };
            *pixel = if nearer { id } else { *pixel };
        }
    }
}

#[inline(always)]
fn lanes_of<S: Simd>(simd: S, tile: &mut Tile, plane: &Plane, id: u32) {
    let [q1, q2] = plane.q.map(|q| f32x8::splat(simd, q));
    let (c, zmax, id) = (f32x8::splat(simd, plane.c), f32x8::splat(simd, plane.zmax), u32x8::splat(simd, id));
    let lane = i32x8::from_slice(simd, &[0, 1, 2, 3, 4, 5, 6, 7]);
    let first = plane.across.map(|a| lane * i32x8::splat(simd, a));
    let step = plane.across.map(|a| i32x8::splat(simd, 8 * a));
    let rows = tile.depth.chunks_exact_mut(SIDE).zip(tile.ids.chunks_exact_mut(SIDE));
    for (y, (depths, ids)) in rows.enumerate() {
        let [e1, e2] = plane.row(y);
        let (mut e1, mut e2) = (i32x8::splat(simd, e1) + first[0], i32x8::splat(simd, e2) + first[1]);
        for (depths, ids) in depths.chunks_exact_mut(8).zip(ids.chunks_exact_mut(8)) {
            let z = (c + e1.to_float::<f32x8<S>>() * q1) + e2.to_float::<f32x8<S>>() * q2;
            let z = z.min(zmax);
            let there = f32x8::from_slice(simd, depths);
            let nearer = z.simd_gt(there);
            nearer.select(z, there).store_slice(depths);
            nearer.select(id, u32x8::from_slice(simd, ids)).store_slice(ids);
            e1 += step[0];
            e2 += step[1];
        }
    }
}
