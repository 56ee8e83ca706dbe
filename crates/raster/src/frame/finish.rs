//! From tiles to the picture: bands of tiles are drawn into memory of their own, then leave it row by row.
//!
//! A band is one row of tiles, 64 rows of the picture. Tiles of a row-major picture cannot be split between threads,
//! bands can; and memory likes whole rows better than the short pieces of one tile.

use alloc::vec::Vec;
use core::ops::Range;

use fearless_simd::prelude::*;
use fearless_simd::{Simd, f32x4, u32x4};

use super::bins::{AREA, BLOCK, SIDE};
use super::kernel::Tile;
use super::tile::{Scene, Turn};
use super::{Frame, workers};
use crate::{Depth, StoredDepth, Target, TargetError};

/// What is settled of a pixel.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Sampled {
    /// Its column.
    pub x: u32,
    /// Its row in the picture.
    pub y: u32,
    /// What is seen there.
    pub value: u32,
    /// Its depth as it is stored; a `u16` as the same number.
    pub depth: f32,
}

/// The working memory of one thread.
#[derive(Clone, Debug, Default)]
pub(crate) struct Hand {
    depths: Vec<Apart<f32>>,
    values: Vec<Apart<u32>>,
    /// Whether anything was drawn in a tile.
    live: Vec<bool>,
    turns: Vec<Turn>,
    /// A row of what pixels hold where nothing was drawn.
    no_depths: Vec<f32>,
    no_values: Vec<u32>,
}

/// A tile's memory, and room behind it: were tiles a power of two apart, the same rows of all tiles would share a few
/// sets of the nearest cache, which then holds none of them until the next row is written.
#[derive(Clone, Copy, Debug)]
struct Apart<T> {
    tile: [T; AREA],
    _room: [T; AREA / 16],
}

impl<T: Copy> Apart<T> {
    const fn new(value: T) -> Self {
        Self { tile: [value; AREA], _room: [value; AREA / 16] }
    }
}

impl Frame {
    /// Writes the picture, every pixel of it, and its depth if the target keeps one. A target that is a band of rows
    /// gets those rows; a frame may be finished into any number of targets.
    ///
    /// # Errors
    ///
    /// When the target is of a picture of another size, or keeps depth in another format than the frame.
    pub fn finish(&mut self, target: &mut Target<'_, u32>) -> Result<(), TargetError> {
        self.write(target, |_, values, _, pixels| pixels.copy_from_slice(values))
    }

    /// The same, with a pixel made of each settled value. `pixel` is cloned for each row of tiles, and asked from left
    /// to right, row by row: what it keeps for neighbours changes no other thread's.
    ///
    /// # Errors
    ///
    /// As for [`finish`](Self::finish).
    pub fn resolve<P: Copy + Send>(
        &mut self,
        target: &mut Target<'_, P>,
        mut pixel: impl FnMut(Sampled) -> P + Clone + Sync,
    ) -> Result<(), TargetError> {
        self.write(target, move |[x, y], values, depths, pixels| {
            for (x, (to, (&value, &depth))) in (x..).zip(pixels.iter_mut().zip(values.iter().zip(depths))) {
                *to = pixel(Sampled { x, y, value, depth });
            }
        })
    }

    /// Writes the picture: `put` makes some pixels of a row, from the first one's place, values and depths; it is cloned
    /// for each row of tiles.
    fn write<P: Copy + Send>(
        &mut self,
        target: &mut Target<'_, P>,
        put: impl FnMut([u32; 2], &[u32], &[f32], &mut [P]) + Clone + Sync,
    ) -> Result<(), TargetError> {
        if self.size != [target.width, target.height] {
            return Err(TargetError::Frame { frame: self.size, target: [target.width, target.height] });
        }
        if matches!(
            (&target.depth, self.depth),
            (Depth::F32(_), StoredDepth::U16(_)) | (Depth::U16(_), StoredDepth::F32(_))
        ) {
            return Err(TargetError::Format);
        }
        let mut hands = core::mem::take(&mut self.hands);
        hands.resize_with(self.threads, Hand::default);
        let scene = Scene::new(self);
        let bands = Bands::new(target);
        let level = self.level.inner();
        workers::taken_in_turn(&mut hands, bands, &|hand: &mut Hand, band: Band<'_, P>| {
            hand.draw_band(level, &scene, band.row);
            fearless_simd::dispatch!(level, simd => hand.write(simd, &scene, band, put.clone()));
        });
        self.hands = hands;
        Ok(())
    }
}

impl Hand {
    /// Draws the tiles of a band. Not generic, so that the kernels are compiled here, once, and not with every program.
    fn draw_band(&mut self, level: fearless_simd::Level, scene: &Scene<'_>, row: u32) {
        fearless_simd::dispatch!(level, simd => self.draw(simd, scene, row));
    }

    /// Draws the tiles of a band.
    #[inline(always)]
    fn draw<L: Simd>(&mut self, simd: L, scene: &Scene<'_>, row: u32) {
        let columns = scene.frame.tiles[0] as usize;
        self.depths.resize(columns, Apart::new(0.0));
        self.values.resize(columns, Apart::new(0));
        self.live.clear();
        self.no_values.clear();
        self.no_values.resize(columns * SIDE as usize, scene.frame.value);
        self.no_depths.clear();
        self.no_depths.resize(columns * SIDE as usize, scene.frame.cleared());
        for (column, (depths, values)) in (0..).zip(self.depths.iter_mut().zip(&mut self.values)) {
            let mut tile = Tile { depths: &mut depths.tile, values: &mut values.tile };
            let live = scene.tile(simd, [column, row], &mut tile, &mut self.turns);
            self.live.push(live);
        }
    }

    /// Writes the rows of a band, sixteen pixels at a time: a store of a whole cache line need not fetch what it
    /// overwrites, which halves the traffic.
    #[inline(always)]
    fn write<L: Simd, P: Copy>(
        &self,
        simd: L,
        scene: &Scene<'_>,
        band: Band<'_, P>,
        mut put: impl FnMut([u32; 2], &[u32], &[f32], &mut [P]),
    ) {
        let width = scene.frame.size[0] as usize;
        let Band { rows, stride, color, mut depth, .. } = band;
        for (k, y) in rows.enumerate() {
            let line = k * stride..k * stride + width;
            let row = Row::new(y);
            for (live, run) in self.runs(width) {
                let pixels = &mut color[line.start + run.start..line.start + run.end];
                if !live {
                    let (values, depths) = (&self.no_values[..run.len()], &self.no_depths[..run.len()]);
                    put([column(run.start), y], values, depths, pixels);
                    continue;
                }
                row.write(run, pixels, |tile, x, to| {
                    let values = row.blocks(&self.values[tile].tile);
                    let depths = row.blocks(&self.depths[tile].tile);
                    for ((to, x), (values, depths)) in
                        lines(to).zip((x..).step_by(LINE)).zip(values.iter().zip(depths))
                    {
                        let values = row.values(simd, values);
                        let depths = row.depths(simd, depths);
                        match to.as_chunks_mut::<LINE>() {
                            ([line], []) => put([column(x), y], &values, &depths, line),
                            _ => put([column(x), y], &values[..to.len()], &depths[..to.len()], to),
                        }
                    }
                });
            }
            match &mut depth {
                Depth::None => {}
                Depth::F32(depth) => {
                    self.write_depth(simd, &row, &mut depth[line], |depths, to| to.copy_from_slice(depths));
                }
                Depth::U16(depth) => self.write_depth(simd, &row, &mut depth[line], |depths, to| {
                    to.iter_mut().zip(depths).for_each(|(to, &z)| *to = whole(z));
                }),
            }
        }
    }

    /// Writes the depths of a row, as they are stored.
    #[inline(always)]
    fn write_depth<L: Simd, D: Copy>(
        &self,
        simd: L,
        row: &Row,
        line: &mut [D],
        store: impl Fn(&[f32], &mut [D]),
    ) {
        for (live, run) in self.runs(line.len()) {
            let to = &mut line[run.clone()];
            if !live {
                store(&self.no_depths[..run.len()], to);
                continue;
            }
            row.write(run, to, |tile, _, to| {
                for (to, depths) in lines(to).zip(row.blocks(&self.depths[tile].tile)) {
                    let depths = row.depths(simd, depths);
                    match to.as_chunks_mut::<LINE>() {
                        ([line], []) => store(&depths, line),
                        _ => store(&depths[..to.len()], to),
                    }
                }
            });
        }
    }

    /// The pixels of a row in runs of tiles in which something was drawn, or nothing.
    fn runs(&self, width: usize) -> impl Iterator<Item = (bool, Range<usize>)> {
        let mut tile = 0;
        self.live.chunk_by(|a, b| a == b).map(move |run| {
            let first = tile * SIDE as usize;
            tile += run.len();
            (run[0], first..width.min(tile * SIDE as usize))
        })
    }
}

/// Pixels that are written at a time.
const LINE: usize = 16;

/// Cuts a tile's part of a row into lines; the last one of a picture may be shorter.
#[inline(always)]
fn lines<P>(row: &mut [P]) -> impl Iterator<Item = &mut [P]> {
    row.chunks_mut(LINE)
}

/// Where a row of pixels lies in a tile's memory: four pixels in each block of a row of blocks.
struct Row {
    /// Among the rows of blocks.
    blocks: usize,
    /// In each of the blocks.
    four: usize,
}

impl Row {
    const fn new(y: u32) -> Self {
        Self { blocks: (y % SIDE / BLOCK) as usize, four: (y % BLOCK) as usize }
    }

    /// Writes a run of pixels, tile by tile; `put` gets the tile, the column of its first pixel, and its pixels.
    #[inline(always)]
    fn write<P>(&self, run: Range<usize>, pixels: &mut [P], mut put: impl FnMut(usize, usize, &mut [P])) {
        let (tiles, rest) = pixels.as_chunks_mut::<{ SIDE as usize }>();
        let mut x = run.start;
        for to in tiles {
            // Of a length that the compiler knows.
            put(x / SIDE as usize, x, to);
            x += SIDE as usize;
        }
        if !rest.is_empty() {
            put(x / SIDE as usize, x, rest);
        }
    }

    /// The blocks of the row, by fours: what makes a line each.
    #[inline(always)]
    fn blocks<'a, T>(&self, tile: &'a [T; AREA]) -> &'a [[[T; 16]; 4]] {
        const BLOCKS: usize = (SIDE / BLOCK) as usize;
        let rows = tile.as_chunks::<16>().0.as_chunks::<BLOCKS>().0;
        rows[self.blocks % rows.len()].as_chunks::<4>().0
    }

    /// Sixteen values.
    #[inline(always)]
    fn values<L: Simd>(&self, simd: L, [a, b, c, d]: &[[u32; 16]; 4]) -> [u32; LINE] {
        let [a, b, c, d] = [self.four(a), self.four(b), self.four(c), self.four(d)];
        let low = u32x4::load_array_ref(simd, a).combine(u32x4::load_array_ref(simd, b));
        *low.combine(u32x4::load_array_ref(simd, c).combine(u32x4::load_array_ref(simd, d)))
    }

    /// Sixteen depths.
    #[inline(always)]
    fn depths<L: Simd>(&self, simd: L, [a, b, c, d]: &[[f32; 16]; 4]) -> [f32; LINE] {
        let [a, b, c, d] = [self.four(a), self.four(b), self.four(c), self.four(d)];
        let low = f32x4::load_array_ref(simd, a).combine(f32x4::load_array_ref(simd, b));
        *low.combine(f32x4::load_array_ref(simd, c).combine(f32x4::load_array_ref(simd, d)))
    }

    /// The row's pixels in a block.
    #[inline(always)]
    fn four<'a, T>(&self, block: &'a [T; 16]) -> &'a [T; 4] {
        &block.as_chunks::<4>().0[self.four % 4]
    }
}

/// A column of a picture.
#[expect(clippy::cast_possible_truncation, reason = "up to 16,384")]
const fn column(x: usize) -> u32 {
    x as u32
}

/// A depth that a tile holds as a whole number.
#[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "from 0 to 65535")]
const fn whole(depth: f32) -> u16 {
    depth as u16
}

/// The rows of a target that one row of tiles fills.
struct Band<'a, P> {
    /// The row of tiles.
    row: u32,
    /// The rows of the picture.
    rows: Range<u32>,
    stride: usize,
    color: &'a mut [P],
    depth: Depth<'a>,
}

/// A target cut into bands.
struct Bands<'a, P> {
    rows: Range<u32>,
    stride: usize,
    color: &'a mut [P],
    depth: Depth<'a>,
}

impl<'a, P: Copy> Bands<'a, P> {
    fn new(target: &'a mut Target<'_, P>) -> Self {
        let depth = match &mut target.depth {
            Depth::None => Depth::None,
            Depth::F32(depth) => Depth::F32(depth),
            Depth::U16(depth) => Depth::U16(depth),
        };
        Self { rows: target.rows.clone(), stride: target.stride, color: target.color, depth }
    }
}

impl<'a, P> Iterator for Bands<'a, P> {
    type Item = Band<'a, P>;

    fn next(&mut self) -> Option<Band<'a, P>> {
        let y = self.rows.start;
        if self.rows.is_empty() {
            return None;
        }
        let row = y / SIDE;
        let rows = y..self.rows.end.min((row + 1) * SIDE);
        self.rows.start = rows.end;
        let length = rows.len() * self.stride;
        let color = cut(&mut self.color, length);
        let depth = match &mut self.depth {
            Depth::None => Depth::None,
            Depth::F32(depth) => Depth::F32(cut(depth, length)),
            Depth::U16(depth) => Depth::U16(cut(depth, length)),
        };
        Some(Band { row, rows, stride: self.stride, color, depth })
    }
}

/// Takes the first items off a slice, as many as there are.
fn cut<'a, T>(slice: &mut &'a mut [T], length: usize) -> &'a mut [T] {
    let length = length.min(slice.len());
    slice.split_off_mut(..length).unwrap_or_default()
}
