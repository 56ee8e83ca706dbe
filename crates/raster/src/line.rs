//! Lines one pixel wide, with sub-pixel ends, tested against depth, and never lost to the faces they outline.
//!
//! **Which pixels.** Diamond-exit, as Direct3D and OpenGL have it: a line takes a pixel when it leaves the
//! diamond `|x − xc| + |y − yc| < ½` around that pixel's sample. Its start counts if it lies inside a diamond,
//! its end does not, so that a line strip takes each joint's pixel once. The diamond's top and left corners
//! belong to it, as the tie below has it (for lines down to the right, or back, at exactly 45°, the top one only).
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
//! **The faces it outlines** do not hide it: see `outline`.

use crate::depth::Stored;
use crate::outline::Faces;
use crate::setup::Setup;
use crate::snap::PIXEL;
use crate::{Clip, Corner, Cull, Depth, DepthTest, Rect, State, Stats, Target};

impl<P: Copy> Target<'_, P> {
    /// Draws lines, each a pair of indices into `vertices`, in order. Culling does not concern them.
    pub fn lines(&mut self, state: &State, vertices: &[Clip], lines: &[[u32; 2]], pixel: P) -> Stats {
        self.edges(state, vertices, lines, |_| [], pixel)
    }

    /// Draws lines that outline faces which were drawn before, with the same `state.space`, `state.sample` and
    /// vertices, into this target.
    ///
    /// For the line of the given number `around` names the faces that meet it, as triples of indices like those
    /// that were drawn: first those that hold it, then those that share an end of it. At most 32 are looked at.
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
            if beside(ends, clip) {
                continue;
            }
            let faces = || around(number).into_iter();
            let faces = Faces::new(&face_setup, state, vertices, line, faces);
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

/// Whether a line's rows are sure to lie above or below all that may be drawn on: no pixel of it is walked then.
fn beside(ends: [Corner; 2], clip: Rect) -> bool {
    let [a, b] = ends.map(|end| i64::from(end.y).div_euclid(PIXEL));
    // A line takes no pixel whose diamond it does not touch.
    a.max(b) + 1 < i64::from(clip.y0) || a.min(b) - 1 > i64::from(clip.y1)
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
pub(crate) struct Point {
    pub(crate) x: u32,
    pub(crate) y: u32,
    pub(crate) z: f32,
    /// The point q on the line itself, in sub-pixels times `scale`.
    pub(crate) q: [i64; 2],
    pub(crate) scale: i64,
    /// Depth at q, not rounded.
    pub(crate) depth: f64,
    /// Whether q is the line's start, or its end.
    pub(crate) is_end: [bool; 2],
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
        let extent = [end[0] - start[0], end[1] - start[1]];
        let columns = 0..0;
        let mut walk = Self { state: *state, clip, steep, mirrored, start, extent, z: [a.z, b.z], columns };
        // The first centre at or after the start, the last one at or before the end. A start just past the
        // centre of a diamond still leaves it; an end inside one does not.
        let first = (start[0] + PIXEL - 1).div_euclid(PIXEL);
        let first = first - i64::from(walk.in_diamond(start, first - 1, nearest(start[1], 1)));
        let last = end[0].div_euclid(PIXEL);
        let last = last - i64::from(walk.in_diamond(end, last, walk.row(last)));
        // Only those in the picture.
        let (low, high) = if steep { (clip.y0, clip.y1) } else { (clip.x0, clip.x1) };
        let (low, high) = (i64::from(low), i64::from(high) - 1);
        let (low, high) = if mirrored { (-high, -low) } else { (low, high) };
        walk.columns = first.max(low)..last.min(high) + 1;
        walk
    }

    /// How far along the line it crosses a column's centre, in sub-pixels on the longer axis; its start, where
    /// that lies past the centre already. (No column that is asked for lies past the end.)
    fn along(&self, column: i64) -> i64 {
        (column * PIXEL - self.start[0]).max(0)
    }

    /// The line's place on the shorter axis there, times the extent on the longer one.
    fn place(&self, column: i64) -> i64 {
        self.start[1] * self.extent[0] + self.extent[1] * self.along(column)
    }

    /// The row that it takes in a column.
    fn row(&self, column: i64) -> i64 {
        nearest(self.place(column), self.extent[0])
    }

    /// Whether a place lies inside the diamond of a column and a row.
    fn in_diamond(&self, place: [i64; 2], column: i64, row: i64) -> bool {
        let off = [place[0] - column * PIXEL, place[1] - row * PIXEL];
        // The top and the left corner: one lies towards lesser places on the longer axis, before mirroring.
        // A line from left corner to top corner, down at 45°, would take two pixels in each column: not the left.
        let corner = if self.mirrored { PIXEL / 2 } else { -PIXEL / 2 };
        let down = self.extent[1].abs() == self.extent[0] && (self.extent[1] < 0) == self.mirrored;
        off[0].abs() + off[1].abs() < PIXEL / 2 || off == [0, -PIXEL / 2] || (off == [corner, 0] && !down)
    }

    /// Depth at a distance from the start, in sub-pixels along the longer axis, from the farther end on: not
    /// rounded to `f32`, and rounded.
    #[expect(clippy::cast_precision_loss, clippy::cast_possible_truncation, reason = "rounded once")]
    fn depth(&self, along: i64) -> (f64, f32) {
        let [a, b] = self.z;
        let (low, high, way) = if a <= b { (a, b, along) } else { (b, a, self.extent[0] - along) };
        let z = f64::from(low) + (f64::from(high) - f64::from(low)) * (way as f64) / (self.extent[0] as f64);
        (z, (z as f32).min(high))
    }
}

impl Iterator for Walk {
    type Item = Point;

    fn next(&mut self) -> Option<Point> {
        loop {
            let column = self.columns.next()?;
            let (along, place, row, scale) =
                (self.along(column), self.place(column), self.row(column), self.extent[0]);
            let on_longer = (self.start[0] + along) * scale * if self.mirrored { -1 } else { 1 };
            let major = if self.mirrored { -column } else { column };
            let ([x, y], [qx, qy]) = if self.steep {
                ([row, major], [place, on_longer])
            } else {
                ([major, row], [on_longer, place])
            };
            let inside =
                |v: i64, low: u32, high: u32| u32::try_from(v).ok().filter(|v| (low..high).contains(v));
            let (Some(x), Some(y)) =
                (inside(x, self.clip.x0, self.clip.x1), inside(y, self.clip.y0, self.clip.y1))
            else {
                continue;
            };
            let [sx, sy] = self.state.sample.sub_pixels().map(i64::from);
            let (depth, z) = self.depth(along);
            let (q, is_end) = ([qx + sx * scale, qy + sy * scale], [along == 0, along == scale]);
            return Some(Point { x, y, z, q, scale, depth, is_end });
        }
    }
}

/// The row nearest to a place that is given times `scale`; exactly between two, the greater.
const fn nearest(place: i64, scale: i64) -> i64 {
    (place + PIXEL / 2 * scale).div_euclid(PIXEL * scale)
}
