//! What counts as a wrong pixel.
//!
//! - A triangle *alone* (all corpora but the mesh): a pixel whose centre is strictly inside and which is not drawn, one
//!   whose centre is strictly outside and which is, one drawn twice. A centre *on* a side is right by the top-left rule
//!   for methods that promise it; for those with a rule of their own (the closed ones, S4's mended strips) it is right
//!   either way.
//! - A *mesh*: a pixel that is not drawn exactly once, whatever the rule: that is what rules are for.
//!
//! The oracle is the suite's, in `i128`, and shares nothing with what it judges.

use std::cell::RefCell;
use std::ops::{AddAssign, Range};

use polosa_raster::reference::{Coverage, Visit};
use polosa_raster::{
    Depth, DepthTest, Fragment, Frame, Rect, Sample, Space, State, StoredDepth, Target, Triangles as Indices,
    Vertices,
};
use polosa_stability::oracle::coverage::{CENTRE, area2, edge, row_span, sample_point};

use super::corpora::{Corners, SIZE, Triangles};

/// Triangles that a frame gets at once: few, so that they hide little of each other.
const AT_ONCE: usize = 16;

/// Columns of a row in which nothing is drawn: any column widens it to itself.
const NOWHERE: Range<u32> = Range { start: u32::MAX, end: 0 };

/// A method that fills.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Method {
    Frame,
    Immediate,
    Reference(Coverage),
}

impl Method {
    /// Whether no pixel may be wrong.
    pub(crate) const fn is_exact(self) -> bool {
        matches!(self, Self::Frame | Self::Immediate | Self::Reference(Coverage::Strips | Coverage::Edges))
    }

    /// Whether centres on a side fall as the top-left rule has it.
    const fn is_top_left(self) -> bool {
        use Coverage::{Barycentric, SameSide, VerticalStrips, VerticalStripsClosed};
        !matches!(self, Self::Reference(Barycentric | SameSide | VerticalStrips | VerticalStripsClosed))
    }
}

/// Wrong pixels, of so many that should be drawn.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(crate) struct Wrong {
    pub(crate) pixels: u64,
    pub(crate) of: u64,
}

impl AddAssign for Wrong {
    fn add_assign(&mut self, other: Self) {
        self.pixels += other.pixels;
        self.of += other.of;
    }
}

/// Counts the wrong pixels of a method.
pub(crate) fn judge(method: Method, triangles: &Triangles) -> Wrong {
    if method == Method::Frame {
        return frames(triangles);
    }
    let mut sheet = Sheet::new();
    let mut wrong = Wrong::default();
    let mut expected =
        if triangles.mesh { Sheet::new() } else { Sheet { counts: Vec::new(), rows: Vec::new() } };
    for corners in &triangles.corners {
        fill(method, corners, &mut sheet);
        if triangles.mesh {
            for (j, span) in spans(corners) {
                expected.row(j, span);
            }
        } else {
            wrong += sheet.compare(corners, method.is_top_left());
            sheet.clear();
        }
    }
    if triangles.mesh {
        // By the half-planes each pixel has as many triangles as there are sheets over it.
        wrong.of = expected.counts.iter().map(|&count| u64::from(count)).sum();
        let pairs = sheet.counts.iter().zip(&expected.counts);
        wrong.pixels = pairs.map(|(found, there)| u64::from(found.abs_diff(*there))).sum();
    }
    wrong
}

/// Draws one triangle.
fn fill(method: Method, corners: &Corners, sheet: &mut Sheet) {
    let [width, height] = SIZE;
    match method {
        Method::Reference(coverage) => {
            let all = Rect { x0: 0, y0: 0, x1: width, y1: height };
            let corners = corners.map(|[x, y]| [x as f64 / 256.0, y as f64 / 256.0, 0.5]);
            coverage.visit(all, Sample::CENTER, &corners, sheet);
        }
        Method::Immediate | Method::Frame => {
            let sheet = RefCell::new(sheet);
            let shade = |f: &Fragment<'_>, (): &mut ()| {
                sheet.borrow_mut().pixel(f.x(), f.y());
                true
            };
            // Values of no size: a slice of any length, without memory.
            let mut none = vec![(); width as usize * height as usize];
            let mut target = Target::new(&mut none, Depth::None, width, height, width as usize)
                .expect("the size is in range");
            target.triangles(&on_screen(), &vertices(corners), &[[0, 1, 2]], &shade);
        }
    }
}

/// Nothing hides anything.
pub(crate) fn on_screen() -> State {
    State { space: Space::Screen, test: DepthTest::Off, write: false, ..State::default() }
}

/// Exact: at most 24 bits.
pub(crate) fn vertices(corners: &Corners) -> [[f32; 4]; 3] {
    corners.map(|[x, y]| [x as f32 / 256.0, y as f32 / 256.0, 0.5, 1.0])
}

/// The rows of the picture that a triangle may cover, each with the pixels that it does.
pub(crate) fn spans(corners: &Corners) -> impl Iterator<Item = (u32, Range<u32>)> + '_ {
    let row = |v: i64| v.div_euclid(256).clamp(0, SIZE[1].into()) as u32;
    let [first, last] =
        [corners.iter().map(|v| v[1]).min(), corners.iter().map(|v| v[1]).max()].map(|y| row(y.unwrap_or(0)));
    (first..(last + 1).min(SIZE[1])).map(|j| {
        let span = row_span(corners, j.into(), CENTRE, SIZE[0] as usize);
        (j, span.start as u32..span.end as u32)
    })
}

/// Frames with the last drawn on top, against the same painted by the oracle.
fn frames(triangles: &Triangles) -> Wrong {
    let mut frame = Frame::new();
    let pixels = SIZE[0] as usize * SIZE[1] as usize;
    let (mut found, mut expected) = (vec![0_u32; pixels], vec![0_u32; pixels]);
    let mut wrong = Wrong::default();
    let at_once = if triangles.mesh { triangles.corners.len().max(1) } else { AT_ONCE };
    for some in triangles.corners.chunks(at_once) {
        expected.fill(0);
        for (corners, id) in some.iter().zip(1..) {
            for (j, span) in spans(corners) {
                wrong.of += u64::from(span.end - span.start);
                let first = (j * SIZE[0]) as usize;
                expected[first + span.start as usize..first + span.end as usize].fill(id);
            }
        }
        let vertices: Vec<[f32; 4]> = some.iter().flat_map(vertices).collect();
        frame.begin(SIZE, 0, StoredDepth::F32(0.0)).expect("the size is in range");
        frame.draw(&on_screen(), 0, Vertices::Clip(&vertices), Indices::Consecutive, |k| k as u32 + 1);
        let mut target =
            Target::new(&mut found, Depth::None, SIZE[0], SIZE[1], SIZE[0] as usize).expect("in range");
        frame.finish(&mut target).expect("frame and picture are alike");
        wrong.pixels +=
            found.iter().zip(&expected).filter(|(found, expected)| found != expected).count() as u64;
    }
    wrong
}

/// How often each pixel was drawn, and where in each row.
struct Sheet {
    counts: Vec<u8>,
    rows: Vec<Range<u32>>,
}

impl Sheet {
    fn new() -> Self {
        Self { counts: vec![0; SIZE[0] as usize * SIZE[1] as usize], rows: vec![NOWHERE; SIZE[1] as usize] }
    }

    fn at(x: u32, y: u32) -> usize {
        (y * SIZE[0] + x) as usize
    }

    /// Holds one triangle against the half-planes.
    fn compare(&self, t: &Corners, top_left: bool) -> Wrong {
        let mut wrong = Wrong::default();
        let mut spans = spans(t).peekable();
        for (j, drawn) in (0..).zip(&self.rows) {
            let span = spans.next_if(|span| span.0 == j).map_or(0..0, |span| span.1);
            wrong.of += u64::from(span.end - span.start);
            let all = if span.is_empty() {
                drawn.clone()
            } else {
                span.start.min(drawn.start)..span.end.max(drawn.end)
            };
            for i in all {
                let count = self.counts[Self::at(i, j)];
                if count != u8::from(span.contains(&i)) && (top_left || count > 1 || !is_on_side(t, i, j)) {
                    wrong.pixels += 1;
                }
            }
        }
        wrong
    }

    fn clear(&mut self) {
        for (j, drawn) in (0..).zip(&mut self.rows) {
            if drawn.start < drawn.end {
                self.counts[Self::at(drawn.start, j)..Self::at(drawn.end, j)].fill(0);
                *drawn = NOWHERE;
            }
        }
    }
}

impl Visit for Sheet {
    fn pixel(&mut self, x: u32, y: u32) {
        self.row(y, x..x + 1);
    }

    fn row(&mut self, y: u32, columns: Range<u32>) {
        if columns.is_empty() {
            return;
        }
        let drawn = &mut self.rows[y as usize];
        *drawn = drawn.start.min(columns.start)..drawn.end.max(columns.end);
        for count in &mut self.counts[Self::at(columns.start, y)..Self::at(columns.end, y)] {
            *count = count.saturating_add(1);
        }
    }
}

/// Whether a pixel's centre lies on a side: on the line through it, and not outside of the others.
fn is_on_side(t: &Corners, i: u32, j: u32) -> bool {
    let p = sample_point(i.into(), j.into(), CENTRE);
    let sign = area2(t).signum();
    let e = [0, 1, 2].map(|k| sign * edge(t[k], t[(k + 1) % 3], p));
    e.iter().all(|&e| e >= 0) && e.contains(&0)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::coverage::corpora::Corpus;
    use crate::measure::Effort;

    #[test]
    fn exact_methods_have_no_wrong_pixel_in_any_corpus() {
        for corpus in Corpus::ALL {
            for area in [2, 50, 512, 5_000, 80_000] {
                let triangles = corpus.triangles(area, Effort::Quick);
                for method in [Method::Frame, Method::Immediate]
                    .into_iter()
                    .chain([Coverage::Strips, Coverage::Edges].map(Method::Reference))
                {
                    let wrong = judge(method, &triangles);
                    assert_eq!(wrong.pixels, 0, "{method:?} {corpus:?} {area}");
                    assert!(wrong.of > 0, "{corpus:?} {area}: nothing to be drawn");
                }
            }
        }
    }

    #[test]
    fn methods_are_held_to_their_own_rule_alone_and_to_one_in_a_mesh() {
        let wrong = |coverage, corpus: Corpus| {
            judge(Method::Reference(coverage), &corpus.triangles(50, Effort::Quick)).pixels
        };
        assert_eq!(wrong(Coverage::Barycentric, Corpus::PixelCentre), 0, "on a side is inside");
        assert!(wrong(Coverage::Barycentric, Corpus::Mesh) > 0, "and so drawn twice");
        assert_eq!(wrong(Coverage::VerticalStrips, Corpus::Mesh), 0, "another rule, but each pixel once");
        assert!(wrong(Coverage::WholePixels, Corpus::Random) > 0);
    }

    #[test]
    fn a_pixel_too_few_too_many_or_elsewhere_is_wrong() {
        let square = [[256, 256], [256 * 9, 256], [256, 256 * 9]];
        let mut sheet = Sheet::new();
        fill(Method::Immediate, &square, &mut sheet);
        let right = sheet.compare(&square, true);
        assert_eq!((right.pixels, right.of), (0, 28));
        sheet.pixel(1, 1);
        sheet.pixel(700, 400);
        sheet.counts[Sheet::at(2, 1)] = 0;
        assert_eq!(sheet.compare(&square, true).pixels, 3);
        assert_eq!(sheet.compare(&square, false).pixels, 3, "none of them lies on a side");
        sheet.clear();
        assert_eq!(sheet.compare(&square, false).pixels, 28);
    }
}
