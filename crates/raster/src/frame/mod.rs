//! Whole frames, in tiles: the same picture as drawing triangle by triangle, several times sooner.
//!
//! ```text
//!   draw ─▶ vertices ─▶ batches of 8 ─▶ bins, a list for each tile of 64 × 64 pixels
//!           (vertices)  (batch, large)  (bins)          │
//!                                                       ▼
//!   your picture ◀─ rows ◀─ band of tiles ◀─ tile: depths and values in the nearest cache
//!                           (finish)         (tile, kernel)
//! ```
//!
//! [`Target::triangles`](crate::Target::triangles) touches the whole picture's memory in the order of the triangles,
//! and prepares them one by one. A [`Frame`] prepares eight at a time, sorts what is left by place, and then each
//! tile draws its own into memory that stays in the cache. It knows all triangles before it draws the first, so it
//! passes over those that a nearer one hides in the whole tile. Threads share the triangles, then the tiles.
//!
//! None of this can be seen in the picture: pixels, depths and ties are those of the immediate path, at every
//! [`Level`], for every number of threads. What a frame cannot do is to look at a pixel that is there (blending) or
//! to discard one: its values are opaque. A value is 32 bits, a colour perhaps, or the number of a triangle, to be
//! shaded when all is settled: once for each pixel that is seen, by [`Frame::resolve`].

mod batch;
mod bins;
mod each;
mod finish;
mod kernel;
mod large;
mod level;
mod tile;
mod vertices;
mod workers;

use alloc::vec::Vec;
use core::ops::Range;

use self::batch::Job;
use self::bins::{FRAGMENT_DRAWS, RECORDS, SIDE, Segment};
use self::finish::Hand;
pub use self::finish::Sampled;
pub use self::level::Level;
pub use self::vertices::Vertices;
use self::vertices::{LANES, Snapped, Snapper};
use crate::setup::Setup;
use crate::target::MAX_SIDE;
use crate::{DepthTest, Rect, State, Stats, StoredDepth, TargetError};

/// Which vertices make triangles.
#[derive(Clone, Copy, Debug)]
pub enum Triangles<'a> {
    /// Each triple of indices.
    Indexed(&'a [[u32; 3]]),
    /// Vertices 0, 1, 2, then 3, 4, 5, and so on; one or two that are left over make none.
    Consecutive,
}

/// A draw needs at least so many triangles for each thread that shares it, and no fewer than there are tiles: each
/// thread has a list for every tile.
const SHARE: usize = 2_048;
/// A draw is cut into pieces of so many triangles, so that no segment overflows.
const PIECE: usize = 1 << 23;

/// One draw call: how its triangles are tested, and which of equals wins.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
struct Drawn {
    state: State,
    order: u32,
}

/// A picture in the making. It keeps its memory from frame to frame: to draw the same again allocates nothing.
///
/// ```
/// use polosa_raster::{Depth, Frame, State, StoredDepth, Target, Triangles, Vertices};
///
/// let corners = [[-0.8, -0.8, 0.5, 1.0], [0.8, -0.8, 0.5, 1.0], [0.0, 0.9, 0.5, 1.0]];
/// let mut frame = Frame::new();
/// frame.begin([16, 8], u32::from(b'.'), StoredDepth::F32(0.0))?;
/// let stats = frame.draw(&State::default(), 0, Vertices::Clip(&corners), Triangles::Consecutive, |_| b'#'.into());
/// assert_eq!(stats.drawn, 1);
///
/// let mut picture = [b' '; 16 * 8];
/// let mut target = Target::new(&mut picture, Depth::None, 16, 8, 16)?;
/// frame.resolve(&mut target, |sampled| sampled.value as u8)?;
/// assert_eq!(target.color_at(8, 4), Some(b'#'));
/// assert_eq!(target.color_at(0, 0), Some(b'.'));
/// # Ok::<(), polosa_raster::TargetError>(())
/// ```
#[derive(Debug)]
pub struct Frame {
    level: Level,
    threads: usize,
    size: [u32; 2],
    /// Columns and rows of tiles.
    tiles: [u32; 2],
    value: u32,
    depth: StoredDepth,
    draws: Vec<Drawn>,
    /// Whether the draws came in their order.
    in_order: bool,
    /// The first `used` hold this frame.
    segments: Vec<Segment>,
    used: usize,
    snapped: Vec<Snapped>,
    hands: Vec<Hand>,
}

impl Default for Frame {
    fn default() -> Self {
        Self::new()
    }
}

impl Frame {
    /// A frame for one thread, at the best [`Level`] of the machine. It has no memory yet.
    #[must_use]
    pub fn new() -> Self {
        Self::with(Level::detect(), 1)
    }

    /// A frame for so many threads (at least one) at some level. Neither changes a byte of a picture.
    ///
    /// With the feature `parallel` the work is cut into so many pieces for rayon's threads; without it, one thread
    /// does them all.
    #[must_use]
    pub fn with(level: Level, threads: usize) -> Self {
        Self {
            level,
            threads: threads.clamp(1, 256),
            size: [0; 2],
            tiles: [0; 2],
            value: 0,
            depth: StoredDepth::F32(0.0),
            draws: Vec::new(),
            in_order: true,
            segments: Vec::new(),
            used: 0,
            snapped: Vec::new(),
            hands: Vec::new(),
        }
    }

    /// The level of vector instructions.
    #[must_use]
    pub const fn level(&self) -> Level {
        self.level
    }

    /// Into how many pieces the work is cut.
    #[must_use]
    pub const fn threads(&self) -> usize {
        self.threads
    }

    /// Width and height of the picture.
    #[must_use]
    pub const fn size(&self) -> [u32; 2] {
        self.size
    }

    /// Starts a picture of `size` (width, height): forgets the last one, and says what a pixel holds that nothing
    /// covers, in which format depths are compared, and what they are tested against first (0 for
    /// [`DepthTest::Greater`], infinity or 65535 for [`DepthTest::Less`]).
    ///
    /// # Errors
    ///
    /// When a side is 0 or more than [`MAX_SIDE`]; the last picture is then still there.
    pub fn begin(&mut self, size: [u32; 2], value: u32, depth: StoredDepth) -> Result<(), TargetError> {
        let [width, height] = size;
        if !(1..=MAX_SIDE).contains(&width) || !(1..=MAX_SIDE).contains(&height) {
            return Err(TargetError::Size { width, height });
        }
        self.size = size;
        self.tiles = size.map(|side| side.div_ceil(SIDE));
        (self.value, self.depth) = (value, depth);
        self.draws.clear();
        self.in_order = true;
        self.used = 0;
        Ok(())
    }

    /// Adds triangles to the picture; `value` says what the pixels of each hold, by its place in the call, and is
    /// asked at most once for each, only for those that may be seen.
    ///
    /// Where depths are equal the lesser `order` wins, whichever was drawn first; among equal ones the first drawn.
    /// (With [`DepthTest::Off`]: the greater, and the last.) Draws that come in their order cost nothing extra.
    ///
    /// An index that is out of range, or a vertex that is not finite, costs its triangle and is counted; nothing
    /// panics. Without [`begin`](Self::begin) nothing is drawn.
    pub fn draw(
        &mut self,
        state: &State,
        order: u32,
        vertices: Vertices<'_>,
        triangles: Triangles<'_>,
        value: impl Fn(usize) -> u32 + Sync,
    ) -> Stats {
        self.draw_eights(state, order, vertices, triangles, |first, asked, values| {
            let mut asked = asked;
            while asked != 0 {
                let lane = asked.trailing_zeros() as usize % LANES;
                asked &= asked - 1;
                values[lane] = value(first + lane);
            }
        })
    }

    /// The same for values that are sooner found for eight triangles at a time: `values` gets the place of the first
    /// of up to eight in a row, a bit for each whose value is asked for (the lowest for the first), and where to put
    /// them.
    ///
    /// ```
    /// # use polosa_raster::{Frame, State, StoredDepth, Triangles, Vertices};
    /// # let corners = [[-0.8, -0.8, 0.5, 1.0], [0.8, -0.8, 0.5, 1.0], [0.0, 0.9, 0.5, 1.0]];
    /// # let mut frame = Frame::new();
    /// # frame.begin([16, 8], 0, StoredDepth::F32(0.0))?;
    /// frame.draw_eights(&State::default(), 0, Vertices::Clip(&corners), Triangles::Consecutive, |first, asked, values| {
    ///     assert_eq!((first, asked), (0, 0b1));
    ///     *values = core::array::from_fn(|lane| (first + lane) as u32);
    /// });
    /// # Ok::<(), polosa_raster::TargetError>(())
    /// ```
    pub fn draw_eights(
        &mut self,
        state: &State,
        order: u32,
        vertices: Vertices<'_>,
        triangles: Triangles<'_>,
        values: impl Fn(usize, u32, &mut [u32; 8]) + Sync,
    ) -> Stats {
        let count = match triangles {
            Triangles::Indexed(triangles) => triangles.len(),
            Triangles::Consecutive => vertices.len() / 3,
        };
        let [width, height] = self.size;
        if count == 0 || width == 0 {
            return Stats { submitted: count as u64, outside: count as u64, ..Stats::default() };
        }
        let draw = self.number(Drawn { state: *state, order });
        let picture = Rect { x0: 0, y0: 0, x1: width, y1: height };
        let clip = state.scissor.map_or(picture, |scissor| scissor.intersection(picture));
        let setup = Setup::new(state, width, height);
        let snapper = Snapper::new(state.space, state.space.viewport(width, height));
        let empty = Rect { x0: 0, y0: 0, x1: 0, y1: 0 };
        let job = Job {
            setup: &setup,
            snapper: &snapper,
            state,
            vertices,
            triangles,
            clip: if clip.x0 < clip.x1 && clip.y0 < clip.y1 { clip } else { empty },
            picture,
            draw,
            fragments: draw < FRAGMENT_DRAWS,
            columns: self.tiles[0],
        };
        if let Triangles::Indexed(_) = triangles {
            self.snap(&snapper, &vertices);
        }
        let tiles = self.tiles[0] as usize * self.tiles[1] as usize;
        let mut stats = Stats::default();
        for first in (0..count).step_by(PIECE) {
            let piece = first..count.min(first + PIECE);
            let threads = (piece.len() / SHARE.max(tiles)).clamp(1, self.threads);
            let level = self.level.inner();
            let (segments, snapped) = self.segments(threads, piece.len());
            let binned = workers::shared(segments, &|number, segment| {
                let part = |k: usize| piece.start + piece.len() * k / threads;
                let part = part(number)..part(number + 1);
                bin(level, &job, snapped, part, &values, segment)
            });
            stats += binned;
        }
        stats
    }

    /// The number of a draw; equal ones in a row share theirs.
    fn number(&mut self, drawn: Drawn) -> u32 {
        if self.draws.last() != Some(&drawn) {
            self.in_order &= self.draws.last().is_none_or(|last| last.order <= drawn.order);
            self.draws.push(drawn);
        }
        u32::try_from(self.draws.len() - 1).unwrap_or(u32::MAX)
    }

    /// Snaps all vertices of a draw.
    fn snap(&mut self, snapper: &Snapper, vertices: &Vertices<'_>) {
        let blocks = vertices.len().div_ceil(LANES);
        self.snapped.resize(blocks * LANES, [0; 4]);
        let threads = (vertices.len() / SHARE).clamp(1, self.threads);
        let length = blocks.div_ceil(threads) * LANES;
        let level = self.level.inner();
        workers::chunks(&mut self.snapped, length, &|number, chunk| {
            snap(level, snapper, vertices, number * length, chunk.as_chunks_mut().0);
        });
        self.snapped.truncate(vertices.len());
    }
}

/// What the pixels of up to eight triangles in a row hold: from the place of the first, and a bit for each that is
/// asked for. A call through a pointer costs a few cycles; to compile all of `batch` for each closure, at each level,
/// would cost every program minutes.
type Values<'a> = dyn Fn(usize, u32, &mut [u32; LANES]) + Sync + 'a;

/// Bins some of a draw's triangles.
fn bin(
    level: fearless_simd::Level,
    job: &Job<'_>,
    snapped: &[Snapped],
    range: Range<usize>,
    values: &Values<'_>,
    segment: &mut Segment,
) -> Stats {
    let mut stats = Stats::default();
    fearless_simd::dispatch!(level, simd => {
        for first in range.clone().step_by(LANES) {
            batch::bin(simd, job, snapped, first..range.end, values, segment, &mut stats);
        }
    });
    stats
}

/// Snaps the blocks of vertices from `first` on.
fn snap(
    level: fearless_simd::Level,
    snapper: &Snapper,
    vertices: &Vertices<'_>,
    first: usize,
    blocks: &mut [[Snapped; LANES]],
) {
    fearless_simd::dispatch!(level, simd => {
        for (block, first) in blocks.iter_mut().zip((first..).step_by(LANES)) {
            *block = snapper.block(simd, vertices, first);
        }
    });
}

impl Frame {
    /// Segments for so many threads to bin triangles into, after all that were binned before; and the vertices.
    fn segments(&mut self, threads: usize, triangles: usize) -> (&mut [Segment], &[Snapped]) {
        // Clipping makes seven pieces of a triangle at most.
        let records = 7 * triangles.div_ceil(threads);
        let goes_on =
            threads == 1 && self.used > 0 && self.segments[self.used - 1].records + records < RECORDS;
        let first = if goes_on { self.used - 1 } else { self.used };
        let tiles = self.tiles[0] as usize * self.tiles[1] as usize;
        while self.used < first + threads {
            if self.segments.len() == self.used {
                self.segments.push(Segment::default());
            }
            self.segments[self.used].clear(tiles);
            self.used += 1;
        }
        let segments = &mut self.segments[first..self.used];
        segments.iter_mut().for_each(|segment| segment.records += records);
        (segments, &self.snapped)
    }

    /// Whether a tile may pass over what its bound hides: where no draw lets a farther depth replace a nearer one.
    fn occludes(&self) -> bool {
        self.draws.iter().all(|draw| draw.state.test == DepthTest::Greater)
    }

    /// What depth is cleared to, as tiles store it.
    fn cleared(&self) -> f32 {
        match self.depth {
            StoredDepth::F32(depth) => depth,
            StoredDepth::U16(depth) => depth.into(),
        }
    }

    /// Whether every draw is of the plainest kind.
    fn is_plain(&self) -> bool {
        matches!(self.depth, StoredDepth::F32(cleared) if !cleared.is_nan())
            && self.draws.iter().all(|draw| draw.state.test == DepthTest::Greater && draw.state.write)
    }
}
