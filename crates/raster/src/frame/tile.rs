//! One tile: everything that was binned for it, in order, into its memory.

use alloc::vec::Vec;

use fearless_simd::Simd;

use super::bins::{AREA, Entry, Kind, NO_BOUND, SIDE, Segment};
use super::kernel::{Any, Nearer, Test, Tile};
use super::{Drawn, Frame, large};
use crate::StoredDepth;

/// An entry with what decides its turn: its draw's order, then its place among all.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Turn {
    key: (u32, u32),
    segment: u32,
    entry: Entry,
}

/// A frame that is drawn from.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Scene<'a> {
    pub(crate) frame: &'a Frame,
    pub(crate) segments: &'a [Segment],
    plain: bool,
    occludes: bool,
}

impl<'a> Scene<'a> {
    pub(crate) fn new(frame: &'a Frame) -> Self {
        let segments = &frame.segments[..frame.used];
        Self { frame, segments, plain: frame.is_plain(), occludes: frame.occludes() }
    }

    /// Draws a tile; `false`, and nothing, if there is nothing to draw. `turns` is working memory.
    #[inline(always)]
    pub(crate) fn tile<L: Simd>(
        &self,
        simd: L,
        place: [u32; 2],
        tile: &mut Tile<'_>,
        turns: &mut Vec<Turn>,
    ) -> bool {
        let index = (place[1] * self.frame.tiles[0] + place[0]) as usize;
        if self.segments.iter().all(|segment| segment.bins[index].entries.is_empty()) {
            return false;
        }
        let quantised = matches!(self.frame.depth, StoredDepth::U16(_));
        tile.depths.fill(self.frame.cleared());
        tile.values.fill(self.frame.value);
        let any = |drawn: &Drawn| Any { test: drawn.state.test, write: drawn.state.write, quantised };
        if self.plain && self.frame.in_order {
            self.in_order(simd, place, index, tile, |_| Nearer);
        } else if self.frame.in_order {
            self.in_order(simd, place, index, tile, any);
        } else {
            self.by_order(simd, place, index, tile, any, turns);
        }
        true
    }

    /// The greatest depth that nothing in the tile ends up below.
    fn bound(&self, index: usize) -> f32 {
        if !self.occludes {
            return NO_BOUND;
        }
        self.segments.iter().map(|segment| segment.bins[index].bound).fold(NO_BOUND, f32::max)
    }

    /// Draws the entries as they were binned.
    #[inline(always)]
    fn in_order<L: Simd, T: Test>(
        &self,
        simd: L,
        place: [u32; 2],
        index: usize,
        tile: &mut Tile<'_>,
        test: impl Fn(&Drawn) -> T,
    ) {
        let bound = self.bound(index);
        for segment in self.segments {
            for entry in &segment.bins[index].entries {
                self.entry(simd, place, tile, (segment, index), entry, bound, &test);
            }
        }
    }

    /// Draws the entries by the order that their draws ask for.
    #[inline(always)]
    fn by_order<L: Simd, T: Test>(
        &self,
        simd: L,
        place: [u32; 2],
        index: usize,
        tile: &mut Tile<'_>,
        test: impl Fn(&Drawn) -> T,
        turns: &mut Vec<Turn>,
    ) {
        turns.clear();
        for (number, segment) in (0..).zip(self.segments) {
            for entry in &segment.bins[index].entries {
                let draw = match (entry.as_fragment(), entry.kind()) {
                    (Some((_, draw)), _) => draw,
                    (None, Kind::Small(at)) => segment.bins[index].small[at].draw(),
                    (None, Kind::Large(at)) => segment.large[at].draw,
                };
                let sequence = u32::try_from(turns.len()).unwrap_or(u32::MAX);
                let key = (self.frame.draws[draw as usize].order, sequence);
                turns.push(Turn { key, segment: number, entry: *entry });
            }
        }
        turns.sort_unstable_by_key(|turn| turn.key);
        let bound = self.bound(index);
        for turn in &*turns {
            let segment = &self.segments[turn.segment as usize];
            self.entry(simd, place, tile, (segment, index), &turn.entry, bound, &test);
        }
    }

    #[inline(always)]
    #[expect(clippy::too_many_arguments, reason = "inlined")]
    fn entry<L: Simd, T: Test>(
        &self,
        simd: L,
        place: [u32; 2],
        tile: &mut Tile<'_>,
        (segment, index): (&Segment, usize),
        entry: &Entry,
        bound: f32,
        test: &impl Fn(&Drawn) -> T,
    ) {
        let draws = &self.frame.draws;
        if let Some((at, draw)) = entry.as_fragment() {
            let test = test(&draws[draw as usize]);
            let (depth, value) = (&mut tile.depths[at % AREA], &mut tile.values[at % AREA]);
            let (new, takes, writes) = test.one(entry.z, *depth);
            *depth = if writes { new } else { *depth };
            *value = if takes { entry.value } else { *value };
            return;
        }
        match entry.kind() {
            Kind::Small(at) => {
                let small = &segment.bins[index].small[at];
                let test = test(&draws[small.draw() as usize]);
                if !test.is_hidden(entry.z, bound) {
                    tile.small(simd, place.map(|k| k * SIDE), small, entry.value, test);
                }
            }
            Kind::Large(at) => {
                let large = &segment.large[at];
                let drawn = &draws[large.draw as usize];
                let test = test(drawn);
                if !test.is_hidden(entry.z, bound) {
                    large::fill(simd, tile, place, large, drawn.state.sample, entry.value, test);
                }
            }
        }
    }
}
