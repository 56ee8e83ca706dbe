//! Shading afterwards: a triangle's weights at the pixels where it turned out to be seen.
//!
//! While a picture is drawn, a pixel's value may be no colour but the number of a triangle. Once all is settled, each
//! pixel that is seen is shaded, and no other. For that the triangle must be prepared anew, as it was drawn:
//!
//! ```text
//!     pixel ─▶ its triangle's number ─▶ vertices ─▶ clip, snap, sort ─▶ the piece that is seen ─▶ weights
//! ```
//!
//! What the near plane cuts is drawn in several pieces, and snapping can make them overlap by a pixel. The one that
//! is seen there is the first of those whose depth is the one that was left behind.

use crate::clip::MOST as CORNERS;
use crate::depth::Stored;
use crate::setup::Setup;
use crate::target::MAX_SIDE;
use crate::{Clip, DepthPlane, Rect, State, Stats, StoredDepth, Triangle, Weights};

/// A polygon of so many corners is drawn in so many pieces at most.
const MOST: usize = CORNERS - 2;

/// Prepares triangles as a draw call does, to tell their weights at pixels where they are seen.
///
/// ```
/// use polosa_raster::{Deferred, Depth, Flat, State, StoredDepth, Target};
///
/// let corners = [[-1.0, -1.0, 0.5, 1.0], [1.0, -1.0, 0.5, 1.0], [0.0, 1.0, 0.5, 1.0]];
/// let (mut color, mut depth) = ([0_u32; 64], [0.0; 64]);
/// let mut target = Target::new(&mut color, Depth::F32(&mut depth), 8, 8, 8)?;
/// target.triangles(&State::default(), &corners, &[[0, 1, 2]], &Flat(1));
/// let left_behind = target.depth_at(4, 4).unwrap();
///
/// let mut deferred = Deferred::new(&State::default(), [8, 8]);
/// assert!(deferred.prepare(corners.each_ref()));
/// let weights = deferred.weights(4, 4, left_behind);
/// assert_eq!(weights, Some([0.21875, 0.34375, 0.4375]));
/// # Ok::<(), polosa_raster::TargetError>(())
/// ```
#[derive(Clone, Debug)]
pub struct Deferred {
    setup: Setup,
    state: State,
    /// The first `count` are the triangle that was prepared last.
    pieces: [Option<Piece>; MOST],
    count: usize,
}

/// One piece of a triangle.
#[derive(Clone, Copy, Debug)]
struct Piece {
    triangle: Triangle,
    depth: DepthPlane,
    weights: Weights,
}

impl Deferred {
    /// For triangles that are drawn with `state` into a picture of `size` (width, height).
    #[must_use]
    pub fn new(state: &State, [width, height]: [u32; 2]) -> Self {
        Self { setup: Setup::new(state, width, height), state: *state, pieces: [None; MOST], count: 0 }
    }

    /// Prepares a triangle in the place of the one before; whether anything of it is drawn.
    #[inline]
    pub fn prepare(&mut self, vertices: [&Clip; 3]) -> bool {
        let Self { setup, state, pieces, count } = self;
        *count = 0;
        setup.triangle(vertices, &mut Stats::default(), |piece| {
            if let Some(place) = pieces.get_mut(*count) {
                let triangle = piece.triangle;
                let depth = triangle.depth(state.sample);
                let weights = triangle.weights(state.sample, piece.clip.as_ref());
                *place = Some(Piece { triangle, depth, weights });
                *count += 1;
            }
        });
        *count > 0
    }

    /// The weights of the prepared triangle's vertices at a pixel where it is seen, the same bits as
    /// [`Fragment::weights`](crate::Fragment::weights) gives; `depth` is the one that is stored there. `None`: nothing
    /// of it is drawn, or the pixel is in no picture.
    ///
    /// It holds for draws that test and write depth; else what is seen cannot be told from what is stored.
    #[inline]
    #[must_use]
    pub fn weights(&self, x: u32, y: u32, depth: StoredDepth) -> Option<[f32; 3]> {
        if x >= MAX_SIDE || y >= MAX_SIDE {
            return None;
        }
        let pieces = self.pieces[..self.count].iter().flatten();
        let mut candidates = pieces.clone();
        let piece = if self.count == 1 {
            candidates.next()
        } else {
            let pixel = Rect { x0: x, y0: y, x1: x + 1, y1: y + 1 };
            let covers = |piece: &&Piece| piece.triangle.strips(self.state.sample, pixel).next().is_some();
            let is_seen = |piece: &&Piece| {
                let z = piece.depth.at(x, y);
                match depth {
                    StoredDepth::F32(depth) => f32::store(z) == depth,
                    StoredDepth::U16(depth) => u16::store(z) == depth,
                }
            };
            candidates.find(|piece| covers(piece) && is_seen(piece)).or_else(|| pieces.clone().find(covers))
        };
        piece.map(|piece| piece.weights.at(x, y))
    }
}
