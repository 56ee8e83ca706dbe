//! What does each formula for depth cost, and which do slivers break?
//!
//! Every way to hide that computes a depth for each pixel, over exact strips, so that nothing but depth differs. Error:
//! the largest distance from the rational plane through the depths of the corners, relative to it, in units of 2⁻²⁴: for
//! triangles of a common shape, and for slivers a thousand pixels long and up to a pixel thick. What is judged is what
//! is stored: `strip-linear` and `barycentric` store `f64`, twice the memory.
//!
//! Time: 8,000 triangles of 512 px in random places and depths, colour and depth cleared and written, in nanoseconds a
//! pixel that is tested: 0.5 is two gigapixels in a second. The reference methods are handed a row by a call.
//!
//! Not here: draw order and the painter's method have no depth at a pixel, `sum` and `strip-printed` keep a number there
//! that is none.

use polosa_benches::ours::Picture;
use polosa_benches::workloads::{HEIGHT, WIDTH};
use polosa_raster::reference::{Corner, Coverage, Hidden, Methods, ZBuffer, draw_screen};
use polosa_raster::{Clip, DepthTest, Frame, PerTriangle, Space, State, StoredDepth, Triangles, Vertices};
use polosa_stability::inputs::rng::Rng;
use polosa_stability::oracle::coverage::{CENTRE, area2, row_span};
use polosa_stability::oracle::depth::depth;

use crate::chart::{Axis, Drawings, Figure, Line, Mark, Panel, Point, Series};
use crate::coverage::corpora::{Corners, random, sliver};
use crate::csv::Row;
use crate::measure::{Effort, interleaved};
use crate::style;

const NAME: &str = "depth";
const METRIC: &str = "largest error in 2^-24 of the depth";
/// What the default promises, in that unit.
const BOUND: f64 = 5.0;
/// The picture in which errors are measured.
const SIZE: [u32; 2] = [1024, 128];

/// Who draws; it keeps its working memory.
struct Contestant {
    way: Way,
    picture: Picture,
}

enum Way {
    Frame(Frame),
    Immediate,
    Reference(Hidden, ZBuffer),
}

/// Triangles with depths at their corners.
struct Soup {
    corners: Vec<[Corner; 3]>,
    vertices: Vec<Clip>,
    indices: Vec<[u32; 3]>,
    value: Vec<u32>,
}

impl Soup {
    fn new(triangles: &[(Corners, [f32; 3])]) -> Self {
        let mut soup =
            Self { corners: Vec::new(), vertices: Vec::new(), indices: Vec::new(), value: Vec::new() };
        for ((t, z), k) in triangles.iter().zip(0..) {
            let place = |c: i64| c as f64 / 256.0;
            soup.corners.push([0, 1, 2].map(|i| [place(t[i][0]), place(t[i][1]), z[i].into()]));
            soup.vertices
                .extend([0, 1, 2].map(|i| [place(t[i][0]) as f32, place(t[i][1]) as f32, z[i], 1.0]));
            soup.indices.push([3 * k, 3 * k + 1, 3 * k + 2]);
            soup.value.push(k + 1);
        }
        soup
    }
}

impl Contestant {
    fn all(size: [u32; 2]) -> Vec<Self> {
        let measured = [
            Hidden::Exact,
            Hidden::StripLinear,
            Hidden::Barycentric,
            Hidden::PlaneF32Origin,
            Hidden::PlaneF32Vertex,
            Hidden::PlaneF64,
        ];
        let ways = [Way::Frame(Frame::new()), Way::Immediate].into_iter();
        let ways = ways.chain(measured.map(|hidden| Way::Reference(hidden, ZBuffer::new())));
        ways.map(|way| Self { way, picture: Picture::new(size) }).collect()
    }

    const fn name(&self) -> &'static str {
        match self.way {
            Way::Frame(_) => "frame",
            Way::Immediate => "immediate",
            Way::Reference(hidden, _) => hidden.name(),
        }
    }

    /// Clears colour and depth, and draws.
    fn draw(&mut self, soup: &Soup) {
        let state = State { space: Space::Screen, ..State::default() };
        let value = |k: usize| soup.value[k];
        let size = self.picture.size;
        match &mut self.way {
            Way::Frame(frame) => {
                frame.begin(size, 0, StoredDepth::F32(0.0)).expect("the size is in range");
                frame.draw(&state, 0, Vertices::Clip(&soup.vertices), Triangles::Consecutive, value);
                frame.finish(&mut self.picture.target()).expect("frame and picture are alike");
            }
            Way::Immediate => {
                let mut target = self.picture.target();
                target.clear(0, DepthTest::Greater);
                target.triangles(&state, &soup.vertices, &soup.indices, &PerTriangle(value));
            }
            Way::Reference(hidden, depth) => {
                self.picture.color.fill(0);
                let methods = Methods { coverage: Coverage::Strips, hidden: *hidden };
                let mut target = self.picture.colors();
                draw_screen(&mut target, depth, methods, &state, &soup.corners, |k| soup.value[k as usize]);
            }
        }
    }

    /// What is stored at a pixel.
    fn at(&self, x: u32, y: u32) -> f64 {
        match &self.way {
            Way::Reference(_, depth) => depth.at(x, y).unwrap_or(f64::NAN),
            _ => self.picture.depth[(y * self.picture.size[0] + x) as usize].into(),
        }
    }

    /// The largest error over the pixels of a triangle that is drawn alone.
    fn error(&mut self, t: &Corners, z: [f32; 3]) -> f64 {
        self.draw(&Soup::new(&[(*t, z)]));
        let mut most = 0.0_f64;
        for j in 0..SIZE[1] {
            for i in row_span(t, j.into(), CENTRE, SIZE[0] as usize) {
                let exact = depth(t, z, i as i64, j.into(), CENTRE);
                let error = ((self.at(i as u32, j) - exact) / exact).abs() * 16_777_216.0;
                most = most.max(if error.is_nan() { f64::INFINITY } else { error });
            }
        }
        most
    }
}

/// Depths of corners: anywhere, far away, or close together.
fn depths(r: &mut Rng) -> [f32; 3] {
    let kind = r.index(3);
    [(); 3].map(|()| match kind {
        0 => r.real(0.05, 0.95) as f32,
        1 => [1.0, 1e-3, 1e-6][r.index(3)],
        _ => 0.5 + r.range(-4, 4) as f32 / 16_777_216.0,
    })
}

/// Triangles to be judged, of two kinds.
fn judged(thin: bool, effort: Effort) -> Vec<(Corners, [f32; 3])> {
    let mut r = Rng::new(7 + u64::from(thin));
    let [width, height] = SIZE.map(|side| 256 * i64::from(side));
    let mut triangles = Vec::new();
    while triangles.len() < effort.either(150, 4_000) {
        let place = [r.range(0, width), r.range(0, height)];
        let t = if thin {
            // Nearly level, so that the picture holds all of it: from one sub-pixel of thickness to a whole pixel.
            let y = r.range(0, 40) * 256 + 128;
            let rise = r.range(-3, 3) * 128;
            if r.index(2) == 0 {
                [[6 * 256, y], [1006 * 256, y + rise], [r.range(6, 1006) * 256, y + rise + r.range(1, 256)]]
            } else {
                sliver(&mut r, 500.0, place)
            }
        } else {
            random(&mut r, 512.0, place)
        };
        if area2(&t) != 0 {
            triangles.push((t, depths(&mut r)));
        }
    }
    triangles
}

/// # Errors
///
/// When a default method is not within its bound.
pub(crate) fn measure(effort: Effort) -> Result<Vec<Row>, String> {
    let mut r = Rng::new(3);
    let timed: Vec<(Corners, [f32; 3])> = (0..effort.either(2_000, 8_000))
        .map(|_| {
            let place = [r.range(0, 256 * i64::from(WIDTH)), r.range(0, 256 * i64::from(HEIGHT))];
            (random(&mut r, 512.0, place), [(); 3].map(|()| r.real(0.05, 0.95) as f32))
        })
        .collect();
    let of_rows = |t: &Corners| -> usize {
        (0..i64::from(HEIGHT)).map(|j| row_span(t, j, CENTRE, WIDTH as usize).len()).sum()
    };
    let pixels: usize = timed.iter().map(|(t, _)| of_rows(t)).sum();
    let soup = Soup::new(&timed);
    let mut contestants = Contestant::all([WIDTH, HEIGHT]);
    let timings = interleaved(contestants.len(), effort, |k| contestants[k].draw(&soup));
    let mut rows = Vec::new();
    for (contestant, timing) in Contestant::all(SIZE).iter_mut().zip(timings) {
        for (kind, thin) in [("triangles", false), ("slivers", true)] {
            let judged = judged(thin, effort);
            let error = judged.iter().map(|(t, z)| contestant.error(t, *z)).fold(0.0, f64::max);
            if matches!(contestant.name(), "frame" | "immediate" | "exact") && error > BOUND {
                return Err(format!("{}: depth is {error} units of 2^-24 off in {kind}", contestant.name()));
            }
            rows.push(Row {
                chart: NAME.to_owned(),
                method: contestant.name().to_owned(),
                workload: format!("kind={kind} judged={} timed={pixels}", judged.len()),
                time_unit: "ns/pixel".to_owned(),
                time: timing.median / pixels as f64,
                error_metric: METRIC.to_owned(),
                error,
                spread: timing.spread / pixels as f64,
            });
        }
    }
    Ok(rows)
}

pub(crate) fn draw(rows: &[Row]) -> Result<Drawings, String> {
    let mut series = Vec::new();
    for row in rows {
        let (color, mark, name) = style::of(&row.method);
        let thin = row.workload.starts_with("kind=slivers ");
        let name = match row.method.as_str() {
            _ if thin => String::new(),
            "exact" => "exact edges".to_owned(),
            _ => name,
        };
        let mark = if thin { Mark::Ring } else { mark };
        let point = Point::new([row.time, row.error], [row.spread, 0.0]);
        series.push(Series { name, color, mark, line: Line::None, points: vec![point] });
    }
    // Filled marks over hollow ones, where these are the same.
    series.sort_by_key(|series| series.mark != Mark::Ring);
    let panel = Panel {
        title: "filled: triangles of a common shape; hollow: slivers".to_owned(),
        x: Axis::of("ns a pixel (0.5 is two gigapixels in a second)"),
        y: Axis::of("largest error, in units of 2⁻²⁴ of the depth"),
        series,
        guides: Vec::new(),
        front: true,
    };
    let figure = Figure {
        title: "Depth: time against the largest error".to_owned(),
        notes: vec![
            "Triangles of 512 px over exact strips at 1920×1080, cleared, tested".to_owned(),
            "and written. Slivers: 1000 px long, up to a pixel thick. The default promises 5.".to_owned(),
            "barycentric and strip-linear store f64, in twice the memory. Broad line: the".to_owned(),
            "Pareto front. Medians of rounds; bars: the median distance from them.".to_owned(),
        ],
        panels: vec![panel],
        columns: 1,
    };
    Ok(vec![(NAME, figure.svg()?)])
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn slivers_break_f32_planes_and_nothing_else() {
        for contestant in &mut Contestant::all(SIZE) {
            let slivers = judged(true, Effort::Quick);
            let error = slivers.iter().map(|(t, z)| contestant.error(t, *z)).fold(0.0, f64::max);
            let plane = contestant.name().starts_with("plane-f32");
            assert_eq!(error > 100.0, plane, "{}: {error}", contestant.name());
            assert!(plane || error <= BOUND, "{}: {error}", contestant.name());
        }
    }
}
