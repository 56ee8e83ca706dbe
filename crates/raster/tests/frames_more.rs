//! Claim: a frame is what drawing one by one gives also where its inner counters run over: more draws than fragments
//! can name, more triangles than fit a piece or a list, the longest sides, strides, and every kind of input.
#![cfg(feature = "alloc")]

mod support;

use std::sync::atomic::{AtomicU8, Ordering};

use polosa_raster::{
    Clip, Columns, Cull, Depth, DepthTest, Flat, Frame, Level, MAX_SIDE, PerTriangle, State, Stats,
    StoredDepth, Target, Triangles, Vertices, transform,
};
use support::picture::on_screen;
use support::rng::Rng;

/// What must stay as it is between the rows and behind the last.
const KEPT: u32 = 0xDEAD_BEEF;
const KEPT_DEPTH: f32 = 0.625;
const KEPT_DEPTH16: u16 = 777;

/// A picture whose rows are `stride` apart, with depth in one format.
#[derive(Clone, Debug, PartialEq)]
struct Picture {
    size: [u32; 2],
    stride: usize,
    clear: StoredDepth,
    color: Vec<u32>,
    depth: Vec<f32>,
    depth16: Vec<u16>,
}

impl Picture {
    fn new(size: [u32; 2], stride: usize, clear: StoredDepth) -> Self {
        let length = stride * size[1] as usize + 3;
        let [wide, narrow] = if matches!(clear, StoredDepth::F32(_)) { [length, 0] } else { [0, length] };
        Self {
            size,
            stride,
            clear,
            color: vec![KEPT; length],
            depth: vec![KEPT_DEPTH; wide],
            depth16: vec![KEPT_DEPTH16; narrow],
        }
    }

    fn target(&mut self) -> Target<'_, u32> {
        let depth = match self.clear {
            StoredDepth::F32(_) => Depth::F32(&mut self.depth),
            StoredDepth::U16(_) => Depth::U16(&mut self.depth16),
        };
        Target::new(&mut self.color, depth, self.size[0], self.size[1], self.stride).unwrap()
    }

    /// Fails at the first pixel, or place between pixels, that differs.
    #[track_caller]
    fn assert_is(&self, expected: &Self, what: &str) {
        let at = |k: usize| format!("{}, {} of {:?}", k % self.stride, k / self.stride, self.size);
        let first = |differ: &dyn Fn(usize) -> bool, length: usize| (0..length).find(|&k| differ(k));
        if let Some(k) = first(&|k| self.color[k] != expected.color[k], self.color.len()) {
            panic!("{what}: colour {:#x}, not {:#x}, at {}", self.color[k], expected.color[k], at(k));
        }
        let differ = |k: usize| self.depth[k].to_bits() != expected.depth[k].to_bits();
        if let Some(k) = first(&differ, self.depth.len()) {
            panic!("{what}: depth {:e}, not {:e}, at {}", self.depth[k], expected.depth[k], at(k));
        }
        if let Some(k) = first(&|k| self.depth16[k] != expected.depth16[k], self.depth16.len()) {
            panic!("{what}: depth {}, not {}, at {}", self.depth16[k], expected.depth16[k], at(k));
        }
    }
}

/// The picture that the immediate path draws, triangle after triangle in the given sequence.
fn one_by_one(
    mut picture: Picture,
    state: &State,
    vertices: &[Clip],
    triangles: &[[u32; 3]],
) -> (Picture, Stats) {
    let mut target = picture.target();
    target.clear(7, DepthTest::Greater);
    let stats = target.triangles(state, vertices, triangles, &PerTriangle(value));
    (picture, stats)
}

fn value(triangle: usize) -> u32 {
    triangle as u32 + 1
}

/// One draw in a frame.
fn in_a_frame(
    mut picture: Picture,
    frame: &mut Frame,
    state: &State,
    vertices: Vertices<'_>,
    triangles: Triangles<'_>,
) -> (Picture, Stats) {
    frame.begin(picture.size, 7, picture.clear).unwrap();
    let stats = frame.draw(state, 0, vertices, triangles, value);
    frame.finish(&mut picture.target()).unwrap();
    (picture, stats)
}

/// Triangles on the screen, in turn of a few pixels and of all sizes up to several pictures; some corners are on
/// the grid of pixels, some depths are equal.
fn soup(r: &mut Rng, size: [u32; 2], count: usize) -> (Vec<Clip>, Vec<[u32; 3]>) {
    let reaches = [1.5, 4.0, 30.0, 70.0, 140.0, 900.0, 30_000.0];
    let vertices = (0..count).flat_map(|k| {
        let reach = reaches[k % reaches.len()];
        let centre = size.map(|side| r.real(-2.0, f64::from(side) + 2.0));
        let (grid, flat) = (r.index(3) == 0, r.unit());
        [(); 3].map(|()| {
            let [x, y] = centre.map(|c| c + r.real(-0.5, 0.5) * reach);
            let [x, y] = if grid { [x.round(), y.round()] } else { [x, y] };
            let z = if r.index(2) == 0 { flat } else { r.unit() };
            [x as f32, y as f32, z as f32, 1.0]
        })
    });
    (vertices.collect(), (0..count as u32).map(|k| [3 * k, 3 * k + 1, 3 * k + 2]).collect())
}

/// Entries of tiles name the draw of a fragment up to 2¹⁸, and have bits for 2¹⁹; later draws are prepared in another
/// way.
#[test]
fn there_may_be_more_draws_than_fragments_can_name() {
    const DRAWS: u32 = (1 << 19) + 4_000;
    let mut r = Rng::new(0xD4A35);
    let size = [96_u32, 80];
    // What was drawn long ago ends up behind: else the last draws would hardly be seen. Few depths, many ties.
    let near = |k: u32| (k / 600) as f32 / 1024.0;
    let corners: Vec<[Clip; 3]> = (0..DRAWS)
        .map(|k| {
            let [x, y] = size.map(|side| r.real(0.0, f64::from(side)));
            let reach = if k % 8 == 0 { 9.0 } else { 2.5 };
            [(); 3]
                .map(|()| [x, y].map(|c| (c + r.real(-reach, reach)) as f32))
                .map(|[x, y]| [x, y, near(k) + r.index(3) as f32 / 1024.0, 1.0])
        })
        .collect();
    let mut expected = Picture::new(size, 96, StoredDepth::F32(0.0));
    let mut target = expected.target();
    target.clear(7, DepthTest::Greater);
    for (corners, order) in corners.iter().zip(0..) {
        target.triangles(&on_screen(), corners, &[[0, 1, 2]], &Flat(order));
    }
    let late = expected.color.iter().filter(|&&pixel| (1 << 19..DRAWS).contains(&pixel)).count();
    assert!(late > 1_000, "the last draws are seen: {late} pixels");

    let draws: Vec<(u32, &[Clip; 3])> = (0..).zip(&corners).collect();
    for backwards in [false, true] {
        let mut frame = Frame::with(Level::detect(), 2);
        frame.begin(size, 7, StoredDepth::F32(0.0)).unwrap();
        let mut draw = |&(order, corners): &(u32, &[Clip; 3])| {
            frame.draw(&on_screen(), order, Vertices::Clip(corners), Triangles::Consecutive, |_| order);
        };
        if backwards {
            draws.iter().rev().for_each(&mut draw);
        } else {
            draws.iter().for_each(&mut draw);
        }
        let mut picture = Picture::new(size, 96, StoredDepth::F32(0.0));
        frame.finish(&mut picture.target()).unwrap();
        picture.assert_is(&expected, if backwards { "the last first" } else { "in order" });
    }
}

/// Draws are cut into pieces of 2²³ triangles, and a list of prepared triangles ends before 2³⁰ are possible. Nearly
/// all triangles here have no area: they are nothing to draw, but are counted like others.
#[test]
fn draws_may_have_more_triangles_than_a_piece() {
    const PIECE: usize = 1 << 23;
    let mut r = Rng::new(0x91ECE);
    let size = [200, 150];
    let (vertices, live) = soup(&mut r, size, 700);
    let mut triangles = vec![[0; 3]; PIECE + 2_000];
    // At both ends, and on both sides of the cut.
    let mut places: Vec<usize> = (0..200).chain(PIECE - 150..PIECE + 150).collect();
    places.extend(triangles.len() - 200..triangles.len());
    for (&place, &triangle) in places.iter().zip(&live) {
        triangles[place] = triangle;
    }
    let picture = || Picture::new(size, 200, StoredDepth::F32(0.0));
    let expected = one_by_one(picture(), &on_screen(), &vertices, &triangles);
    assert_eq!(expected.1.submitted, triangles.len() as u64);
    for threads in [1, 3] {
        let mut frame = Frame::with(Level::detect(), threads);
        let (vertices, triangles) = (Vertices::Clip(&vertices), Triangles::Indexed(&triangles));
        let got = in_a_frame(picture(), &mut frame, &on_screen(), vertices, triangles);
        assert_eq!(got.1, expected.1, "{threads} threads");
        got.0.assert_is(&expected.0, &format!("{threads} threads"));
    }

    // Nineteen of them: 7 · 19 · 2²³ records would be more than 2³⁰. The first wins all ties.
    let mut frame = Frame::new();
    frame.begin(size, 7, StoredDepth::F32(0.0)).unwrap();
    for _ in 0..19 {
        let (vertices, triangles) = (Vertices::Clip(&vertices), Triangles::Indexed(&triangles));
        assert_eq!(frame.draw(&on_screen(), 0, vertices, triangles, value), expected.1);
    }
    let mut got = picture();
    frame.finish(&mut got.target()).unwrap();
    got.assert_is(&expected.0, "nineteen times the same");
}

#[test]
fn sides_may_be_as_long_as_they_can_be() {
    let mut r = Rng::new(0x51DE5);
    for size in [[MAX_SIDE, 3], [3, MAX_SIDE], [MAX_SIDE - 1, 70], [65, MAX_SIDE], [1, 1]] {
        for clear in [StoredDepth::F32(0.0), StoredDepth::U16(0)] {
            let count = if size[0].min(size[1]) < 10 { 6_000 } else { 350 };
            let (vertices, triangles) = soup(&mut r, size, count);
            let picture = || Picture::new(size, size[0] as usize, clear);
            let expected = one_by_one(picture(), &on_screen(), &vertices, &triangles);
            for level in Level::available() {
                for threads in [1, 3] {
                    let mut frame = Frame::with(level, threads);
                    let vertices = Vertices::Clip(&vertices);
                    let got =
                        in_a_frame(picture(), &mut frame, &on_screen(), vertices, Triangles::Consecutive);
                    assert_eq!(got.1, expected.1);
                    got.0.assert_is(&expected.0, &format!("{size:?}, {level}, {threads} threads"));
                }
            }
        }
    }
}

/// Colour and depth alike; what lies between the rows is the caller's.
#[test]
fn rows_may_be_farther_apart_than_they_are_long() {
    let mut r = Rng::new(0x5741DE);
    for round in 0..40 {
        let size = [1 + r.index(300) as u32, 1 + r.index(200) as u32];
        let stride = size[0] as usize + 1 + r.index(80);
        let clear = [StoredDepth::F32(0.0), StoredDepth::U16(0)][round % 2];
        let (vertices, triangles) = soup(&mut r, size, 1 + round * 20);
        let picture = || Picture::new(size, stride, clear);
        let expected = one_by_one(picture(), &on_screen(), &vertices, &triangles);
        let gaps = (0..stride * size[1] as usize).filter(|k| k % stride >= size[0] as usize);
        assert!(gaps.into_iter().all(|k| expected.0.color[k] == KEPT));
        for threads in [1, 2, 8] {
            let mut frame = Frame::with(Level::detect(), threads);
            let vertices = Vertices::Clip(&vertices);
            let got = in_a_frame(picture(), &mut frame, &on_screen(), vertices, Triangles::Consecutive);
            got.0.assert_is(&expected.0, &format!("round {round}, {threads} threads"));
        }
    }
}

/// What every kind of vertices and every kind of triangles give together; some vertices lie behind the eye.
#[test]
fn positions_and_clip_space_indexed_or_not_are_one() {
    let mut r = Rng::new(0xFFE45);
    let size = [230, 140];
    for round in 0..30 {
        let state = State { cull: [Cull::None, Cull::Back, Cull::Front][round % 3], ..State::default() };
        let matrix: Columns = [(); 4].map(|()| [(); 4].map(|()| r.real(-1.0, 1.0) as f32));
        // Not always a whole number of triangles, or of eights.
        let count = if round < 20 { 3 * r.index(40) + r.index(3) } else { 15_000 + r.index(3) };
        let reach = [2.0, 0.3][round % 2];
        let positions: Vec<[f32; 3]> = (0..count.div_ceil(3))
            .flat_map(|_| {
                let centre = [(); 3].map(|()| r.real(-2.0, 2.0));
                [(); 3].map(|()| centre.map(|c| (c + r.real(-reach, reach)) as f32))
            })
            .take(count)
            .collect();
        let mut clip = vec![[0.0; 4]; count];
        transform(&matrix, &positions, &mut clip);
        let indices: Vec<[u32; 3]> = (0..count as u32 / 3).map(|k| [3 * k, 3 * k + 1, 3 * k + 2]).collect();
        let picture = || Picture::new(size, 230, StoredDepth::F32(0.0));
        let expected = one_by_one(picture(), &state, &clip, &indices);
        let model = Vertices::Model { matrix: &matrix, positions: &positions };
        for level in Level::available() {
            for threads in [1, 2, 3] {
                let mut frame = Frame::with(level, threads);
                for vertices in [model, Vertices::Clip(&clip)] {
                    for triangles in [Triangles::Consecutive, Triangles::Indexed(&indices)] {
                        let got = in_a_frame(picture(), &mut frame, &state, vertices, triangles);
                        let what = format!("round {round}, {level}, {threads} threads");
                        assert_eq!(got.1, expected.1, "{what}");
                        got.0.assert_is(&expected.0, &what);
                    }
                }
            }
        }
    }
}

/// No row follows, so nothing is ever that far away.
#[test]
fn a_frame_of_one_row_goes_to_a_target_of_any_stride() {
    let mut r = Rng::new(0x10E0);
    let size = [700, 1];
    let (vertices, triangles) = soup(&mut r, size, 500);
    let expected =
        one_by_one(Picture::new(size, 700, StoredDepth::F32(0.0)), &on_screen(), &vertices, &triangles).0;
    for threads in [1, 2, 8] {
        let mut frame = Frame::with(Level::detect(), threads);
        frame.begin(size, 7, StoredDepth::F32(0.0)).unwrap();
        frame.draw(&on_screen(), 0, Vertices::Clip(&vertices), Triangles::Consecutive, value);
        for stride in [701, 1 << 40, usize::MAX / 2 + 1, usize::MAX] {
            let (mut color, mut depth) = (vec![KEPT; 703], vec![KEPT_DEPTH; 703]);
            let mut target = Target::new(&mut color, Depth::F32(&mut depth), 700, 1, stride).unwrap();
            frame.finish(&mut target).unwrap();
            assert!(color == expected.color && depth == expected.depth, "stride {stride}");
        }
    }
}

/// One row of a taller picture, likewise.
#[test]
fn so_does_one_row_of_a_taller_frame() {
    let mut r = Rng::new(0xAB0B);
    let size = [300, 150];
    let (vertices, triangles) = soup(&mut r, size, 500);
    let expected =
        one_by_one(Picture::new(size, 300, StoredDepth::U16(0)), &on_screen(), &vertices, &triangles).0;
    let mut frame = Frame::new();
    frame.begin(size, 7, StoredDepth::U16(0)).unwrap();
    frame.draw(&on_screen(), 0, Vertices::Clip(&vertices), Triangles::Consecutive, value);
    for row in 0..150 {
        let (mut color, mut depth) = (vec![KEPT; 300], vec![KEPT_DEPTH16; 300]);
        let depths = Depth::U16(&mut depth);
        let mut target = Target::band(&mut color, depths, size, usize::MAX, row..row + 1).unwrap();
        frame.finish(&mut target).unwrap();
        let first = row as usize * 300;
        assert_eq!(color, expected.color[first..first + 300], "row {row}");
        assert_eq!(depth, expected.depth16[first..first + 300], "row {row}");
    }
}

/// `draw` says so: at most once for each, and only for those that may be seen.
#[test]
fn values_are_asked_at_most_once_and_not_for_what_is_rejected() {
    let mut r = Rng::new(0xA5CED);
    let size = [260, 190];
    let state = State { cull: Cull::Back, ..on_screen() };
    let (mut vertices, triangles) = soup(&mut r, size, 9_000);
    for vertex in vertices.iter_mut().step_by(41) {
        vertex[0] = f32::NAN;
    }
    for threads in [1, 3] {
        let asked: Vec<AtomicU8> = triangles.iter().map(|_| AtomicU8::new(0)).collect();
        let mut frame = Frame::with(Level::detect(), threads);
        frame.begin(size, 0, StoredDepth::F32(0.0)).unwrap();
        let ask = |k: usize| u32::from(asked[k].fetch_add(1, Ordering::Relaxed)) + 1;
        let stats = frame.draw(&state, 0, Vertices::Clip(&vertices), Triangles::Consecutive, ask);
        let times: Vec<u8> = asked.iter().map(|times| times.load(Ordering::Relaxed)).collect();
        assert_eq!(times.iter().max(), Some(&1));
        let total = times.iter().filter(|&&times| times == 1).count() as u64;
        assert!(total > 0 && total <= stats.drawn, "{total} of {}", stats.drawn);
        for (triangle, times) in triangles.iter().zip(times) {
            let finite = triangle.iter().all(|&k| vertices[k as usize][0].is_finite());
            assert!(finite || times == 0, "asked for a triangle that is not finite");
        }
    }
}
