//! Lines one pixel wide, with sub-pixel ends, tested against depth, and never lost to the faces they outline.
//!
//! **Which pixels.** Diamond-exit, as Direct3D and OpenGL have it: a line takes a pixel when it leaves the
//! diamond `|x − xc| + |y − yc| < ½` around that pixel's sample. Its start counts if it lies inside a diamond,
//! its end does not, so that a line strip takes each joint's pixel once.
//!
//! ```text
//!        ╱╲      ╱╲      ╱╲          flat lines take one pixel in each column whose centre they cross:
//!       ╱  ╲   _╱──╲────╱──╲──▶      the one that the line is nearest to; exactly between two,
//!      ╱ ●──╲─╱─    ╲  ╱    ╲        the lower (for steep lines the right) one
//! ```
//!
//! **Depth.** Linear between the ends' depths, at the point q where the line crosses the pixel's column (steep
//! lines: row), computed in `f64` and rounded once.
//!
//! **The faces it outlines.** The pixel's sample p lies up to half a pixel beside q, where a steep face that
//! holds the line can be a good deal nearer than the line is. So a pixel that fails the depth test is drawn all
//! the same when what hides it is a face around the line (its stored depth is *bit for bit* that face's, since
//! depth is one formula) which does not hide the point q itself: one that holds both ends of the line cannot,
//! and another one does only where it covers q. No bias, no slope factor; what lies really in front stays in
//! front.

use polosa_math::SUB_PIXELS;

use crate::depth::Stored;
use crate::edge::Edge;
use crate::setup::{Piece, Setup};
use crate::{Clip, Corner, Cull, Depth, DepthTest, Rect, State, Stats, Target};

const STEP: i64 = SUB_PIXELS as i64;

/// Faces around a line that are kept prepared; what exceeds it is prepared anew for each pixel.
const KEPT: usize = 16;

impl<P: Copy> Target<'_, P> {
    /// Draws lines, each a pair of indices into `vertices`, in order. Culling does not concern them.
    pub fn lines(&mut self, state: &State, vertices: &[Clip], lines: &[[u32; 2]], pixel: P) -> Stats {
        self.edges(state, vertices, lines, |_| [], pixel)
    }

    /// Draws lines that outline faces which were drawn before, with the same `state.space`, `state.sample` and
    /// vertices, into this target.
    ///
    /// For the line of the given number `around` names the faces that meet it: those that hold it and those
    /// that share an end of it, as triples of indices like those that were drawn.
    pub fn edges<F: IntoIterator<Item = [u32; 3]>>(
        &mut self,
        state: &State,
        vertices: &[Clip],
        lines: &[[u32; 2]],
        around: impl Fn(usize) -> F,
        pixel: P,
    ) -> Stats {
        let mut stats = Stats::default();
        let setup = Setup::new(state, self.width, self.height);
        let face_setup = Setup::new(&State { cull: Cull::None, ..*state }, self.width, self.height);
        let clip = self.clip(state.scissor);
        for (number, &line) in lines.iter().enumerate() {
            stats.submitted += 1;
            let [Some(a), Some(b)] = line.map(|k| vertices.get(k as usize)) else {
                stats.bad_index += 1;
                continue;
            };
            let Some(ends) = setup.line([a, b], &mut stats) else { continue };
            let faces = || around(number).into_iter();
            let faces = Faces { setup: &face_setup, state, vertices, line, faces, kept: None };
            self.line(state, clip, ends, faces, pixel);
        }
        stats
    }

    fn line<I: Iterator<Item = [u32; 3]>>(
        &mut self,
        state: &State,
        clip: Rect,
        ends: [Corner; 2],
        mut faces: Faces<'_, impl Fn() -> I>,
        pixel: P,
    ) {
        for point in Walk::new(ends, state, clip) {
            let at = self.span(point.x, point.y, point.x + 1).start;
            let draws = match &mut self.depth {
                Depth::None => true,
                Depth::F32(depth) => test(state, &mut depth[at], &point, &mut faces),
                Depth::U16(depth) => test(state, &mut depth[at], &point, &mut faces),
            };
            if draws {
                self.color[at] = pixel;
            }
        }
    }
}

/// Whether a point is drawn; leaves its depth if it passes the test itself.
fn test<S: Stored, I: Iterator<Item = [u32; 3]>>(
    state: &State,
    depth: &mut S,
    point: &Point,
    faces: &mut Faces<'_, impl Fn() -> I>,
) -> bool {
    let new = S::store(point.z);
    if state.test.passes(new, *depth) {
        if state.write {
            *depth = new;
        }
        return true;
    }
    state.test != DepthTest::Off && faces.only_seem_to_hide(point, *depth)
}

/// One pixel of a line.
struct Point {
    x: u32,
    y: u32,
    z: f32,
    /// The point q on the line itself, in sub-pixels times `scale`.
    q: [i64; 2],
    scale: i64,
}

/// The pixels of a line, along its longer axis (`major`) with pixel centres at multiples of 256.
struct Walk {
    state: State,
    clip: Rect,
    /// Whether the longer axis is y.
    steep: bool,
    /// Whether the line runs towards lesser coordinates on it, which is walked mirrored.
    mirrored: bool,
    /// Start and extent on both axes; the extent on the longer one is positive.
    start: [i64; 2],
    extent: [i64; 2],
    /// Depths of both ends.
    z: [f32; 2],
    columns: core::ops::Range<i64>,
}

impl Walk {
    fn new([a, b]: [Corner; 2], state: &State, clip: Rect) -> Self {
        let [sx, sy] = state.sample.sub_pixels();
        let place = |corner: &Corner| [i64::from(corner.x - sx), i64::from(corner.y - sy)];
        let (mut start, mut end) = (place(&a), place(&b));
        let steep = (end[1] - start[1]).abs() > (end[0] - start[0]).abs();
        if steep {
            start.swap(0, 1);
            end.swap(0, 1);
        }
        let mirrored = end[0] < start[0];
        if mirrored {
            (start[0], end[0]) = (-start[0], -end[0]);
        }
        // The first centre at or after the start, the last one at or before the end. A start just past the
        // centre of a diamond still leaves it; an end inside one does not.
        let first = (start[0] + STEP - 1).div_euclid(STEP);
        let first = first - i64::from(in_diamond(start, first - 1));
        let last = end[0].div_euclid(STEP);
        let last = last - i64::from(in_diamond(end, last));
        // Only those in the picture.
        let (low, high) = if steep { (clip.y0, clip.y1) } else { (clip.x0, clip.x1) };
        let (low, high) = (i64::from(low), i64::from(high) - 1);
        let (low, high) = if mirrored { (-high, -low) } else { (low, high) };
        let columns = first.max(low)..last.min(high) + 1;
        let extent = [end[0] - start[0], end[1] - start[1]];
        Self { state: *state, clip, steep, mirrored, start, extent, z: [a.z, b.z], columns }
    }

    /// Depth at a distance from the start, in sub-pixels along the longer axis, from the farther end on.
    #[expect(clippy::cast_precision_loss, clippy::cast_possible_truncation, reason = "rounded once")]
    fn depth(&self, along: i64) -> f32 {
        let along = along.clamp(0, self.extent[0]);
        let [a, b] = self.z;
        let (low, high, way) = if a <= b { (a, b, along) } else { (b, a, self.extent[0] - along) };
        let z = f64::from(low) + (f64::from(high) - f64::from(low)) * (way as f64) / (self.extent[0] as f64);
        (z as f32).min(high)
    }
}

impl Iterator for Walk {
    type Item = Point;

    fn next(&mut self) -> Option<Point> {
        loop {
            let column = self.columns.next()?;
            let ([_, minor], [major_extent, minor_extent]) = (self.start, self.extent);
            let along = column * STEP - self.start[0];
            // The line's place on the shorter axis, times the extent on the longer one; then the nearest row.
            let place = minor * major_extent + minor_extent * along;
            let row = (place + STEP / 2 * major_extent).div_euclid(STEP * major_extent);
            let major = if self.mirrored { -column } else { column };
            let ([x, y], [qx, qy]) = if self.steep {
                ([row, major], [place, major * STEP * major_extent])
            } else {
                ([major, row], [major * STEP * major_extent, place])
            };
            let inside =
                |v: i64, low: u32, high: u32| u32::try_from(v).ok().filter(|v| (low..high).contains(v));
            let (Some(x), Some(y)) =
                (inside(x, self.clip.x0, self.clip.x1), inside(y, self.clip.y0, self.clip.y1))
            else {
                continue;
            };
            let [sx, sy] = self.state.sample.sub_pixels().map(i64::from);
            let q = [qx + sx * major_extent, qy + sy * major_extent];
            return Some(Point { x, y, z: self.depth(along), q, scale: major_extent });
        }
    }
}

/// Whether a place lies inside the diamond of a column, in the row nearest to it.
const fn in_diamond(place: [i64; 2], column: i64) -> bool {
    let row = (place[1] + STEP / 2).div_euclid(STEP);
    (place[0] - column * STEP).abs() + (place[1] - row * STEP).abs() < STEP / 2
}

/// The faces around a line, prepared when the first pixel asks for them.
struct Faces<'a, F> {
    setup: &'a Setup,
    state: &'a State,
    vertices: &'a [Clip],
    line: [u32; 2],
    faces: F,
    kept: Option<Kept>,
}

/// A piece of a face, and whether that face holds both ends of the line.
type Near = (Piece, bool);

struct Kept {
    near: [Option<Near>; KEPT],
    all: bool,
}

impl<I: Iterator<Item = [u32; 3]>, F: Fn() -> I> Faces<'_, F> {
    /// Whether a face around the line is what is stored at the pixel, and does not cover the line's own point.
    fn only_seem_to_hide<S: Stored>(&mut self, point: &Point, stored: S) -> bool {
        if self.kept.is_none() {
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
        match &self.kept {
            Some(Kept { near, all: true }) => {
                near.iter().flatten().any(|near| self.seems_to_hide(near, point, stored))
            }
            _ => self.each(&mut |near| self.seems_to_hide(near, point, stored)),
        }
    }

    /// Hands the pieces of all faces to `visit` until it says yes.
    fn each(&self, visit: &mut impl FnMut(&Near) -> bool) -> bool {
        let mut found = false;
        for face in (self.faces)() {
            let [Some(a), Some(b), Some(c)] = face.map(|k| self.vertices.get(k as usize)) else { continue };
            let own = self.line.iter().all(|end| face.contains(end));
            self.setup.triangle([a, b, c], &mut Stats::default(), |piece| {
                found = found || visit(&(*piece, own));
            });
            if found {
                break;
            }
        }
        found
    }

    fn seems_to_hide<S: Stored>(&self, (piece, own): &Near, point: &Point, stored: S) -> bool {
        let triangle = &piece.triangle;
        let sides = [0, 1, 2].map(|k| Edge::opposite(triangle, k));
        let [sx, sy] = self.state.sample.sub_pixels().map(i64::from);
        let (x, y) = (i64::from(point.x) * STEP + sx, i64::from(point.y) * STEP + sy);
        sides.iter().all(|side| side.covers(x, y))
            && S::store(triangle.depth(self.state.sample).at(point.x, point.y)) == stored
            && (*own || !sides.iter().all(|side| side.holds(point.q, point.scale)))
    }
}
