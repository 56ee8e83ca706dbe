//! Lines that are never lost to the faces they outline, without a bias.
//!
//! A line's pixel has its sample p up to half a pixel beside the line's own point q, and there a steep face that
//! holds the line can be a good deal nearer than the line is. So a pixel that fails the depth test is drawn all the
//! same when what hides it is a face around the line (its stored depth is *bit for bit* that face's, since depth
//! is one formula) and no such face hides the point q itself. One that holds both ends of the line cannot; one that
//! holds an end V can where it is nearer at q than the line, and covers q. Unless the stored face holds the line,
//! it does as well where q lies beyond its side opposite V: the line runs behind it, and what it runs behind from
//! there on, half a pixel off, is not known. No bias, no slope factor; what lies really in front stays in front.
//!
//! ```text
//!         V ●────────●                 V ●────────●
//!          ╱ ╲ face ╱ ·q                ╱ ╲ face ╱
//!         ╱ q ╲    ╱                   ╱   ╲·p ╱ ·q
//!        ╱  ·p ╲  ╱                   ╱     ╲ ╱
//!       ●───────●                    ●───────●
//!   beside the sector at V: in sight   inside it: behind
//! ```

use crate::depth::Stored;
use crate::edge::Edge;
use crate::line::Point;
use crate::setup::{Piece, Setup};
use crate::snap::PIXEL;
use crate::{Clip, DepthTest, State, Stats};

/// Faces around a line that are kept prepared; what exceeds it is prepared anew for each pixel.
const KEPT: usize = 16;

/// The faces around a line, prepared when the first pixel asks for them.
pub(crate) struct Faces<'a, F> {
    pub(crate) setup: &'a Setup,
    pub(crate) state: &'a State,
    pub(crate) vertices: &'a [Clip],
    pub(crate) line: [u32; 2],
    pub(crate) faces: F,
    pub(crate) kept: Option<Kept>,
}

/// A piece of a face, and where among the face's corners the line's ends are.
#[derive(Clone, Copy)]
struct Near {
    piece: Piece,
    ends: [Option<usize>; 2],
}

/// Prepared faces.
pub(crate) struct Kept {
    near: [Option<Near>; KEPT],
    all: bool,
}

impl<I: Iterator<Item = [u32; 3]>, F: Fn() -> I> Faces<'_, F> {
    /// Whether what is stored at the pixel is a face around the line, and none of them hides the line's own
    /// point. A face of the other facing than that one may have been culled: it hides nothing.
    pub(crate) fn only_seem_to_hide<S: Stored>(&mut self, point: &Point, stored: S) -> bool {
        self.keep();
        let mut stored_face = None;
        self.any(&mut |near| {
            let seems = near.is_stored(self.state, point, stored) && !near.hides(self.state, point, true);
            if seems {
                stored_face = Some((near.piece.triangle.facing(), near.holds_line()));
            }
            seems
        });
        stored_face.is_some_and(|(facing, own)| {
            !self.any(&mut |near| {
                near.piece.triangle.facing() == facing && near.hides(self.state, point, !own)
            })
        })
    }

    /// Prepares the faces, as many as there is room for.
    fn keep(&mut self) {
        if self.kept.is_some() {
            return;
        }
        let mut kept = Kept { near: [None; KEPT], all: true };
        let mut count = 0;
        self.each(&mut |near| {
            match kept.near.get_mut(count) {
                Some(place) => *place = Some(*near),
                None => kept.all = false,
            }
            count += 1;
            false
        });
        self.kept = Some(kept);
    }

    /// Whether `check` says yes to a piece of a face.
    fn any(&self, check: &mut impl FnMut(&Near) -> bool) -> bool {
        match &self.kept {
            Some(Kept { near, all: true }) => near.iter().flatten().any(check),
            _ => self.each(check),
        }
    }

    /// Hands the pieces of all faces to `visit` until it says yes.
    fn each(&self, visit: &mut impl FnMut(&Near) -> bool) -> bool {
        let mut found = false;
        for face in (self.faces)() {
            let [Some(a), Some(b), Some(c)] = face.map(|k| self.vertices.get(k as usize)) else { continue };
            let ends = self.line.map(|end| face.iter().position(|&corner| corner == end));
            self.setup.triangle([a, b, c], &mut Stats::default(), |piece| {
                found = found || visit(&Near { piece: *piece, ends });
            });
            if found {
                break;
            }
        }
        found
    }
}

impl Near {
    fn holds_line(&self) -> bool {
        self.ends.iter().all(Option::is_some)
    }

    /// Whether the stored depth is this face's.
    fn is_stored<S: Stored>(&self, state: &State, point: &Point, stored: S) -> bool {
        let triangle = &self.piece.triangle;
        let [sx, sy] = state.sample.sub_pixels().map(i64::from);
        let (x, y) = (i64::from(point.x) * PIXEL + sx, i64::from(point.y) * PIXEL + sy);
        (0..3).all(|k| Edge::opposite(triangle, k).covers(x, y))
            && S::store(triangle.depth(state.sample).at(point.x, point.y)) == stored
    }

    /// Whether this face covers the line's own point and is nearer there; `beyond`: or would, did it not end
    /// at the side opposite the end that it shares with the line. It does not where it holds the line, nor at
    /// the end that it shares: there they meet.
    #[expect(clippy::cast_precision_loss, reason = "a comparison of depths that differ, or meet in an end")]
    fn hides(&self, state: &State, point: &Point, beyond: bool) -> bool {
        if self.holds_line() || (0..2).any(|k| self.ends[k].is_some() && point.is_end[k]) {
            return false;
        }
        let triangle = &self.piece.triangle;
        // A cut piece's corners are not the face's.
        let apex = self.ends[0].or(self.ends[1]).filter(|_| beyond && self.piece.clip.is_none());
        let e = [0, 1, 2].map(|k| Edge::opposite(triangle, k).at(point.q, point.scale));
        if (0..3).any(|k| e[k] < 0 && Some(usize::from(triangle.given()[k])) != apex) {
            return false;
        }
        let sum: f64 = (0..3).map(|k| e[k] as f64 * f64::from(triangle.corners()[k].z)).sum();
        let depth = sum / (triangle.area() as f64 * point.scale as f64);
        match state.test {
            DepthTest::Greater => depth > point.depth,
            DepthTest::Less => depth < point.depth,
            DepthTest::Off => false,
        }
    }
}
