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

/// How many pieces of faces around a line are looked at.
///
/// It bounds what a pixel of a line can cost: at a vertex of ten thousand faces the work would grow with the square
/// of their number. Fewer than the faces around an ordinary edge (ten or so) would lose pixels where they meet.
pub(crate) const MOST: usize = 32;

/// The faces around a line, prepared when the first pixel asks for them.
pub(crate) struct Faces<'a, F> {
    setup: &'a Setup,
    state: &'a State,
    vertices: &'a [Clip],
    line: [u32; 2],
    faces: F,
    /// From the least to the greatest depth of the faces.
    range: Option<[f32; 2]>,
    near: Option<[Option<Near>; MOST]>,
}

/// A piece of a face, and where among the face's corners the line's ends are.
#[derive(Clone, Copy)]
struct Near {
    piece: Piece,
    ends: [Option<usize>; 2],
}

impl<'a, I: Iterator<Item = [u32; 3]>, F: Fn() -> I> Faces<'a, F> {
    pub(crate) const fn new(
        setup: &'a Setup,
        state: &'a State,
        vertices: &'a [Clip],
        line: [u32; 2],
        faces: F,
    ) -> Self {
        Self { setup, state, vertices, line, faces, range: None, near: None }
    }

    /// Whether what is stored at the pixel is a face around the line, and none of them hides the line's own
    /// point. A face of the other facing than that one may have been culled: it hides nothing.
    pub(crate) fn only_seem_to_hide<S: Stored>(&mut self, point: &Point, stored: S) -> bool {
        // Most lines that are hidden are so by something far before them: no need to prepare a face for those.
        let [least, greatest] = match self.range {
            Some(range) => range,
            None => *self.range.insert(self.depths()),
        };
        if stored < S::store(least) || stored > S::store(greatest) {
            return false;
        }
        let near = match &self.near {
            Some(near) => near,
            None => &*self.near.insert(self.prepared()),
        };
        let near = || near.iter().flatten();
        let seems =
            |near: &&Near| near.is_stored(self.state, point, stored) && !near.hides(self.state, point, true);
        near().find(seems).is_some_and(|seen| {
            let facing = seen.piece.triangle.facing();
            let same = |near: &&Near| near.piece.triangle.facing() == facing;
            !near().filter(same).any(|near| near.hides(self.state, point, !seen.holds_line()))
        })
    }

    /// The faces that are there, as their three vertices.
    fn faces(&self) -> impl Iterator<Item = ([u32; 3], [&'a Clip; 3])> {
        let vertices = self.vertices;
        (self.faces)().take(MOST).filter_map(move |face| {
            let [Some(a), Some(b), Some(c)] = face.map(|k| vertices.get(k as usize)) else { return None };
            Some((face, [a, b, c]))
        })
    }

    /// The least and the greatest depth of the faces; of one that is cut, anything.
    fn depths(&self) -> [f32; 2] {
        self.faces().flat_map(|(_, corners)| corners).fold([1.0, 0.0], |[least, greatest], corner| match self
            .setup
            .depth(corner)
        {
            Some(depth) => [depth.min(least), depth.max(greatest)],
            None => [0.0, 1.0],
        })
    }

    fn prepared(&self) -> [Option<Near>; MOST] {
        let mut prepared = [None; MOST];
        let mut places = prepared.iter_mut();
        for (face, corners) in self.faces() {
            let ends = self.line.map(|end| face.iter().position(|&corner| corner == end));
            self.setup.triangle(corners, &mut Stats::default(), |piece| {
                if let Some(place) = places.next() {
                    *place = Some(Near { piece: *piece, ends });
                }
            });
        }
        prepared
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
