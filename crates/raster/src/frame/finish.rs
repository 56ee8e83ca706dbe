//! From tiles to the picture: bands of tiles are drawn into memory of their own, then leave it row by row.
//!
//! A band is one row of tiles, 64 rows of the picture. Tiles of a row-major picture cannot be split between threads,
//! bands can; and memory likes whole rows better than the short pieces of one tile.

use alloc::vec::Vec;
use core::ops::Range;

use super::bins::{AREA, BLOCK, SIDE};
use super::kernel::Tile;
use super::tile::{Scene, Turn};
use super::{Frame, workers};
use crate::{Depth, Stats, StoredDepth, Target, TargetError};

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
    depths: Vec<[f32; AREA]>,
    values: Vec<[u32; AREA]>,
    /// Whether anything was drawn in a tile.
    live: Vec<bool>,
    turns: Vec<Turn>,
}

impl Frame {
    /// Writes the picture, every pixel of it, and its depth if the target keeps one. A target that is a band of rows
    /// gets those rows; a frame may be finished into any number of targets.
    ///
    /// # Errors
    ///
    /// When the target is of a picture of another size, or keeps depth in another format than the frame.
    pub fn finish(&mut self, target: &mut Target<'_, u32>) -> Result<(), TargetError> {
        self.resolve(target, |sampled| sampled.value)
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
        pixel: impl FnMut(Sampled) -> P + Clone + Sync,
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
        let draw = |band: Band<'_, P>, hand: &mut Hand| {
            fearless_simd::dispatch!(level, simd => {
                hand.draw(simd, &scene, band.row);
                hand.write(&scene, band, pixel.clone());
            });
        };
        #[cfg(feature = "parallel")]
        {
            let bands = workers::Queue::new(bands);
            workers::shared(&mut hands, &|_, hand| {
                while let Some(band) = bands.next() {
                    draw(band, hand);
                }
                Stats::default()
            });
        }
        #[cfg(not(feature = "parallel"))]
        for band in bands {
            draw(band, &mut hands[0]);
        }
        self.hands = hands;
        Ok(())
    }
}

impl Hand {
    /// Draws the tiles of a band.
    #[inline(always)]
    fn draw<L: fearless_simd::Simd>(&mut self, simd: L, scene: &Scene<'_>, row: u32) {
        let columns = scene.frame.tiles[0] as usize;
        self.depths.resize(columns, [0.0; AREA]);
        self.values.resize(columns, [0; AREA]);
        self.live.clear();
        for (column, (depths, values)) in (0..).zip(self.depths.iter_mut().zip(&mut self.values)) {
            let live = scene.tile(simd, [column, row], &mut Tile { depths, values }, &mut self.turns);
            self.live.push(live);
        }
    }

    /// Writes the rows of a band.
    #[inline(always)]
    fn write<P: Copy>(&self, scene: &Scene<'_>, band: Band<'_, P>, mut pixel: impl FnMut(Sampled) -> P) {
        let empty = (scene.frame.value, scene.frame.cleared());
        let width = scene.frame.size[0] as usize;
        let Band { rows, stride, color, mut depth, .. } = band;
        for (k, y) in rows.enumerate() {
            let line = k * stride..k * stride + width;
            let row = Row::new(y);
            let pieces = color[line.clone()].chunks_mut(SIDE as usize);
            for ((x, tile), piece) in (0..).step_by(SIDE as usize).zip(0..).zip(pieces) {
                if self.live[tile] {
                    let (values, depths) = (row.of(&self.values[tile]), row.of(&self.depths[tile]));
                    let make = |x: u32, value: u32, depth: f32| pixel(Sampled { x, y, value, depth });
                    row.put(x, piece, values, depths, make);
                } else {
                    for (x, to) in (x..).zip(piece) {
                        *to = pixel(Sampled { x, y, value: empty.0, depth: empty.1 });
                    }
                }
            }
            match &mut depth {
                Depth::None => {}
                Depth::F32(depth) => self.write_depth(&row, &mut depth[line], empty.1, |z| z),
                Depth::U16(depth) => self.write_depth(&row, &mut depth[line], empty.1, whole),
            }
        }
    }

    /// Writes the depths of a row, as they are stored.
    #[inline(always)]
    fn write_depth<D: Copy>(&self, row: &Row, line: &mut [D], empty: f32, stored: impl Fn(f32) -> D) {
        for (tile, piece) in line.chunks_mut(SIDE as usize).enumerate() {
            if self.live[tile] {
                let depths = row.of(&self.depths[tile]);
                row.put(0, piece, depths, depths, |_, depth, _| stored(depth));
            } else {
                piece.fill(stored(empty));
            }
        }
    }
}

/// Where a row of pixels lies in a tile's memory: four pixels in each block of a row of blocks.
struct Row {
    first: usize,
    four: usize,
}

impl Row {
    const fn new(y: u32) -> Self {
        let (block, four) = (y % SIDE / BLOCK, y % BLOCK);
        Self { first: (block * (SIDE / BLOCK)) as usize, four: four as usize }
    }

    /// The row of blocks.
    #[inline(always)]
    fn of<'a, T>(&self, tile: &'a [T; AREA]) -> &'a [[T; 16]] {
        &tile.as_chunks::<16>().0[self.first..self.first + (SIDE / BLOCK) as usize]
    }

    /// Makes the pixels from x on of what the blocks hold.
    #[inline(always)]
    fn put<V: Copy, D: Copy, P>(
        &self,
        x: u32,
        to: &mut [P],
        values: &[[V; 16]],
        depths: &[[D; 16]],
        mut make: impl FnMut(u32, V, D) -> P,
    ) {
        let (fours, rest) = to.as_chunks_mut::<4>();
        let mut x = x;
        let count = fours.len();
        for ((to, values), depths) in fours.iter_mut().zip(values).zip(depths) {
            let v = values.as_chunks::<4>().0[self.four % 4];
            let d = depths.as_chunks::<4>().0[self.four % 4];
            *to = [make(x, v[0], d[0]), make(x + 1, v[1], d[1]), make(x + 2, v[2], d[2]), make(x + 3, v[3], d[3])];
            x += BLOCK;
        }
        if let (Some(values), Some(depths)) = (values.get(count), depths.get(count)) {
            let v = values.as_chunks::<4>().0[self.four % 4];
            let d = depths.as_chunks::<4>().0[self.four % 4];
            for (x, ((to, v), d)) in (x..).zip(rest.iter_mut().zip(v).zip(d)) {
                *to = make(x, v, d);
            }
        }
    }
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
