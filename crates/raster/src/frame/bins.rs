//! What waits for its tile: a list for each tile, in the order of drawing.
//!
//! ```text
//!   tile (3, 1):  fragment  fragment  triangle  fragment  …       12 bytes each
//!                                        │
//!                                        ▼
//!                 small triangles, prepared, a copy for each tile     large ones, once for all
//! ```
//!
//! A triangle of a few pixels is settled before it is binned: its *fragments* go to the tile. Others are prepared
//! and named by every tile that they may touch, with a depth that they do not exceed there, so that a tile can pass over what
//! is hidden without looking at it. A tile reads its lists from front to back, as memory likes it.

use alloc::vec::Vec;

use crate::depth::DepthPlane;
use crate::{Rect, Triangle};

/// Pixels along a side of a tile: its depths and values, 32 KiB, stay in the nearest cache.
pub(crate) const SIDE: u32 = 64;
/// Pixels of a tile.
pub(crate) const AREA: usize = (SIDE * SIDE) as usize;
/// Pixels along a side of a block. The 16 pixels of a block lie side by side: a cache line of depths.
pub(crate) const BLOCK: u32 = 4;

/// Where in a tile's memory a pixel lies: block after block from the top left, each row after row.
#[inline(always)]
pub(crate) const fn place(x: u32, y: u32) -> u32 {
    const { assert!(SIDE.is_power_of_two() && BLOCK == 4) };
    const BLOCKS: u32 = SIDE - BLOCK;
    (y & BLOCKS) * SIDE + (x & BLOCKS) * BLOCK + (y % BLOCK) * BLOCK + x % BLOCK
}

/// One thing for a tile to draw.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Entry {
    /// What it is: see [`Kind`].
    pub(crate) key: u32,
    /// A fragment's depth, or one that a triangle does not exceed in the tile.
    pub(crate) z: f32,
    pub(crate) value: u32,
}

/// The most draws whose fragments are told apart; triangles of later draws are all prepared.
pub(crate) const FRAGMENT_DRAWS: u32 = 1 << 18;
const FRAGMENT_BITS: u32 = AREA.trailing_zeros();
const SMALL: u32 = 1 << 31;
const LARGE: u32 = 3 << 30;
/// The most prepared triangles of each kind in a segment.
pub(crate) const RECORDS: usize = 1 << 30;

/// What an entry is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Kind {
    Small(usize),
    Large(usize),
}

impl Entry {
    #[inline(always)]
    pub(crate) const fn fragment(draw: u32, place: u32, z: f32, value: u32) -> Self {
        Self { key: draw << FRAGMENT_BITS | place, z, value }
    }

    /// The place in the tile and the draw, if it is a fragment.
    #[inline(always)]
    pub(crate) const fn as_fragment(&self) -> Option<(usize, u32)> {
        if self.key & SMALL == 0 { Some((self.key as usize % AREA, self.key >> FRAGMENT_BITS)) } else { None }
    }

    /// Which prepared triangle it names, if it is not a fragment.
    #[inline(always)]
    pub(crate) const fn kind(&self) -> Kind {
        let index = (self.key & !LARGE) as usize;
        if self.key & LARGE == LARGE { Kind::Large(index) } else { Kind::Small(index) }
    }
}

/// A triangle of less than 128 pixels' extent: all of its edge values fit an `i32`. A cache line.
///
/// Its three edges stand in the order in which the depth formula takes them: the two that count, then the one
/// opposite to the anchor.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Small {
    /// ⌊(E + bias) / 256⌋ at the sample of the pixel (x0, y0), where the bias is −1 for right and bottom sides:
    /// a pixel is covered where none of the three is negative.
    pub(crate) e: [i32; 3],
    /// What a step to the right adds.
    pub(crate) x: [i32; 3],
    /// What a step down adds.
    pub(crate) y: [i32; 3],
    pub(crate) c: f32,
    pub(crate) q: [f32; 2],
    pub(crate) most: f32,
    /// The pixels that it may cover: x0, y0, x1, y1.
    pub(crate) extent: [u16; 4],
    /// The draw, and in the two highest bits whether E′ of the first two edges is one more than `e` says.
    draw: u32,
}

impl Small {
    pub(crate) const fn tag(draw: u32, more: [bool; 2]) -> u32 {
        draw | (more[0] as u32) << 30 | (more[1] as u32) << 31
    }

    pub(crate) const fn new(
        [e, x, y]: [[i32; 3]; 3],
        c: f32,
        q: [f32; 2],
        most: f32,
        extent: [u16; 4],
        tag: u32,
    ) -> Self {
        Self { e, x, y, c, q, most, extent, draw: tag }
    }

    pub(crate) const fn draw(&self) -> u32 {
        self.draw & ((1 << 30) - 1)
    }

    /// What is added to the first two edge values to make E′ of them.
    pub(crate) const fn more(&self) -> [i32; 2] {
        [(self.draw >> 30 & 1).cast_signed(), (self.draw >> 31).cast_signed()]
    }
}

/// Any other triangle, walked by its strips.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Large {
    pub(crate) triangle: Triangle,
    pub(crate) plane: DepthPlane,
    pub(crate) clip: Rect,
    pub(crate) draw: u32,
}

/// The entries of one tile.
#[derive(Clone, Debug)]
pub(crate) struct Bin {
    pub(crate) entries: Vec<Entry>,
    pub(crate) small: Vec<Small>,
    /// No pixel of the tile ends up with less than this depth.
    pub(crate) bound: f32,
}

impl Bin {
    const EMPTY: Self = Self { entries: Vec::new(), small: Vec::new(), bound: NO_BOUND };

    /// Adds a small triangle.
    #[inline(always)]
    pub(crate) fn push_small(&mut self, small: Small, value: u32) {
        self.entries.push(Entry { key: SMALL | index(self.small.len()), z: small.most, value });
        self.small.push(small);
    }

    /// Names a large triangle of the segment.
    #[inline]
    pub(crate) fn push_large(&mut self, large: usize, z: f32, value: u32) {
        self.entries.push(Entry { key: LARGE | index(large), z, value });
    }
}

/// Below every depth.
pub(crate) const NO_BOUND: f32 = -1.0;

/// What one thread bins of one draw, or of several draws in turn.
#[derive(Clone, Debug, Default)]
pub(crate) struct Segment {
    /// One for each tile, or more: of a larger picture that was.
    pub(crate) bins: Vec<Bin>,
    /// No list is longer than this.
    pub(crate) records: usize,
    pub(crate) large: Vec<Large>,
}

impl Segment {
    /// Empties it for a picture of so many tiles; the memory stays.
    pub(crate) fn clear(&mut self, tiles: usize) {
        for bin in &mut self.bins {
            bin.entries.clear();
            bin.small.clear();
            bin.bound = NO_BOUND;
        }
        if self.bins.len() < tiles {
            self.bins.resize_with(tiles, || Bin::EMPTY);
        }
        self.records = 0;
        self.large.clear();
    }
}

#[inline]
#[expect(clippy::cast_possible_truncation, reason = "segments hold at most `RECORDS`")]
const fn index(index: usize) -> u32 {
    index as u32
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn places_are_a_permutation_of_the_tile() {
        let mut seen = [false; AREA];
        for y in 0..SIDE {
            for x in 0..SIDE {
                let at = place(x + 3 * SIDE, y + SIDE) as usize;
                assert!(!core::mem::replace(&mut seen[at], true), "{x}, {y}");
                assert_eq!(at / 16, (y / 4 * 16 + x / 4) as usize);
            }
        }
    }

    #[test]
    fn entries_say_what_they_are() {
        let fragment = Entry::fragment(FRAGMENT_DRAWS - 1, 4095, 0.5, 7);
        assert_eq!(fragment.as_fragment(), Some((4095, FRAGMENT_DRAWS - 1)));
        let last = index(RECORDS - 1);
        for (key, kind) in
            [(SMALL | last, Kind::Small(RECORDS - 1)), (LARGE | last, Kind::Large(RECORDS - 1))]
        {
            let entry = Entry { key, z: 0.0, value: 0 };
            assert_eq!((entry.as_fragment(), entry.kind()), (None, kind));
        }
        assert_eq!(size_of::<Small>(), 64);
    }
}
