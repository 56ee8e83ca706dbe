//! Claim: a frame is, to the last bit of colour and depth, what drawing its triangles one by one gives: at every
//! level of vector instructions, for 1, 2, 3 and 8 threads, in both formats of depth, in whatever order draws come.
#![cfg(feature = "alloc")]

mod support;

use polosa_raster::{
    Clip, Columns, Cull, Depth, DepthTest, Frame, Level, PerTriangle, Rect, Sample, Space, State, Stats,
    StoredDepth, Target, Triangles, Vertices, transform,
};
use support::rng::Rng;

/// One draw call.
#[derive(Clone, Debug)]
struct Call {
    state: State,
    order: u32,
    vertices: Vec<Clip>,
    triangles: Vec<[u32; 3]>,
}

impl Call {
    fn value(&self, triangle: usize) -> u32 {
        (self.order + 1) << 20 | triangle as u32
    }
}

/// Colours, depths as `u32` bits, and counts.
type Drawn = (Vec<u32>, Vec<u32>, Stats);

fn stored(depth: &[f32], depth16: &[u16], format: StoredDepth) -> Vec<u32> {
    match format {
        StoredDepth::F32(_) => depth.iter().map(|z| z.to_bits()).collect(),
        StoredDepth::U16(_) => depth16.iter().map(|&z| z.into()).collect(),
    }
}

/// What the immediate path makes of the calls, in their order.
fn one_by_one(calls: &[Call], [width, height]: [u32; 2], clear: StoredDepth) -> Drawn {
    let pixels = (width * height) as usize;
    let (mut color, mut f32s, mut u16s) = (vec![7; pixels], vec![0.0; pixels], vec![0; pixels]);
    let depth = match clear {
        StoredDepth::F32(z) => {
            f32s.fill(z);
            Depth::F32(&mut f32s)
        }
        StoredDepth::U16(z) => {
            u16s.fill(z);
            Depth::U16(&mut u16s)
        }
    };
    let mut target = Target::new(&mut color, depth, width, height, width as usize).unwrap();
    let mut calls: Vec<&Call> = calls.iter().collect();
    calls.sort_by_key(|call| call.order);
    let stats = calls.iter().fold(Stats::default(), |stats, call| {
        let shade = PerTriangle(|k: usize| call.value(k));
        stats + target.triangles(&call.state, &call.vertices, &call.triangles, &shade)
    });
    (color, stored(&f32s, &u16s, clear), stats)
}

/// What a frame makes of them.
fn in_a_frame(calls: &[Call], [width, height]: [u32; 2], clear: StoredDepth, frame: &mut Frame) -> Drawn {
    let pixels = (width * height) as usize;
    let (mut color, mut f32s, mut u16s) = (vec![1; pixels], vec![0.5; pixels], vec![5; pixels]);
    frame.begin([width, height], 7, clear).unwrap();
    let mut stats = Stats::default();
    for call in calls {
        let consecutive = call.triangles.iter().flatten().copied().eq(0..call.vertices.len() as u32);
        let triangles =
            if consecutive { Triangles::Consecutive } else { Triangles::Indexed(&call.triangles) };
        let vertices = Vertices::Clip(&call.vertices);
        stats += frame.draw(&call.state, call.order, vertices, triangles, |k| call.value(k));
    }
    let depth = match clear {
        StoredDepth::F32(_) => Depth::F32(&mut f32s),
        StoredDepth::U16(_) => Depth::U16(&mut u16s),
    };
    let mut target = Target::new(&mut color, depth, width, height, width as usize).unwrap();
    frame.finish(&mut target).unwrap();
    (color, stored(&f32s, &u16s, clear), stats)
}

#[track_caller]
fn assert_same(calls: &[Call], size: [u32; 2], clear: StoredDepth, what: &str) {
    let expected = one_by_one(calls, size, clear);
    for level in Level::available() {
        for threads in [1, 2, 3, 8] {
            let mut frame = Frame::with(level, threads);
            let got = in_a_frame(calls, size, clear, &mut frame);
            assert_eq!(got.2, expected.2, "{what}, {level}, {threads} threads");
            let differ = |a: &[u32], b: &[u32]| (0..a.len()).find(|&k| a[k] != b[k]);
            for (name, got, expected) in [("colour", &got.0, &expected.0), ("depth", &got.1, &expected.1)] {
                if let Some(at) = differ(got, expected) {
                    panic!(
                        "{what}, {level}, {threads} threads: {name} {:#x}, not {:#x}, at {}, {} of {size:?}",
                        got[at],
                        expected[at],
                        at % size[0] as usize,
                        at / size[0] as usize
                    );
                }
            }
        }
    }
}

/// Triangles of about `reach` pixels across somewhere in or around a picture; some indexed, some with bad indices.
fn soup(r: &mut Rng, size: [u32; 2], count: usize, reach: f64, space: Space) -> (Vec<Clip>, Vec<[u32; 3]>) {
    let grid = [0.0, 1.0 / 256.0, 0.25, 0.5, 1.0][r.index(5)];
    let snap = |v: f64| if grid > 0.0 { (v / grid).round() * grid } else { v };
    let depths = r.index(3);
    let vertices = (0..count).flat_map(|_| {
        let centre = [0, 1].map(|k: usize| r.real(-0.1, 1.1) * f64::from(size[k]));
        let flat = r.unit();
        [(); 3].map(|()| {
            let [x, y] = centre.map(|c| snap(c + r.real(-0.5, 0.5) * reach));
            let z = match depths {
                0 => r.unit(),
                1 => flat,
                _ => [0.0, 0.25, 1.0][r.index(3)],
            };
            match space {
                Space::Screen => [x as f32, y as f32, z as f32, 1.0],
                Space::Clip => {
                    let w = if depths == 1 { 1.0 } else { r.real(0.1, 3.0) };
                    let place = [2.0 * x / f64::from(size[0]) - 1.0, 1.0 - 2.0 * y / f64::from(size[1])];
                    [place[0] * w, place[1] * w, z * w, w].map(|v| v as f32)
                }
            }
        })
    });
    let vertices: Vec<Clip> = vertices.collect();
    let consecutive = (0..count as u32).map(|k| [3 * k, 3 * k + 1, 3 * k + 2]);
    let triangles = if r.index(2) == 0 {
        consecutive.collect()
    } else {
        let mut indices: Vec<_> =
            consecutive.map(|t| if r.index(20) == 0 { [t[0], t[1], u32::MAX] } else { t }).collect();
        r.shuffle(&mut indices);
        indices
    };
    (vertices, triangles)
}

/// What the clipper must look at, or refuse.
fn spoil(r: &mut Rng, vertices: &mut [Clip]) {
    for vertex in vertices {
        if r.index(9) == 0 {
            let k = r.index(4);
            vertex[k] = match r.index(8) {
                0 => f32::NAN,
                1 => f32::INFINITY,
                2 => -vertex[k],
                3 => vertex[k] * 3000.0,
                4 => -0.0,
                5 => f32::MIN_POSITIVE / 8.0,
                6 => vertex[k] * 1e30,
                _ => 1.5,
            };
        }
    }
}

fn state(r: &mut Rng, plain: bool, size: [u32; 2]) -> State {
    let space = [Space::Clip, Space::Screen][r.index(2)];
    let cull = [Cull::None, Cull::None, Cull::Back, Cull::Front][r.index(4)];
    let state = State { space, cull, ..State::default() };
    if plain {
        return state;
    }
    let mut side = |k: usize| r.range(0, i64::from(size[k]) + 4) as u32;
    let scissor = Rect { x0: side(0), y0: side(1), x1: side(0), y1: side(1) };
    State {
        test: [DepthTest::Greater, DepthTest::Less, DepthTest::Off][r.index(3)],
        write: r.index(3) > 0,
        scissor: (r.index(3) == 0).then_some(scissor),
        sample: [Sample::CENTER, Sample { x: r.index(256) as u8, y: r.index(256) as u8 }][r.index(2)],
        ..state
    }
}

fn calls(r: &mut Rng, size: [u32; 2], plain: bool) -> Vec<Call> {
    let reaches = [0.7, 2.0, 5.0, 20.0, 90.0, 200.0, 2_000.0, 60_000.0];
    (0..1 + r.index(4) as u32)
        .map(|order| {
            let state = state(r, plain, size);
            let most = [20, 300][r.index(2)];
            let count = 1 + r.index(most);
            let reach = reaches[r.index(reaches.len())];
            let (mut vertices, triangles) = soup(r, size, count, reach, state.space);
            if r.index(3) == 0 {
                spoil(r, &mut vertices);
            }
            Call { state, order, vertices, triangles }
        })
        .collect()
}

#[test]
fn frames_are_what_one_by_one_gives() {
    let mut r = Rng::new(0xF4A3E5);
    for round in 0..150 {
        let size = [1 + r.index(300) as u32, 1 + r.index(200) as u32];
        let calls = calls(&mut r, size, true);
        assert_same(&calls, size, StoredDepth::F32(0.0), &format!("round {round}"));
    }
}

#[test]
fn so_they_are_with_every_state() {
    let mut r = Rng::new(0x57A7E);
    for round in 0..150 {
        let size = [1 + r.index(200) as u32, 1 + r.index(150) as u32];
        let calls = calls(&mut r, size, false);
        let clear = [
            StoredDepth::F32(0.0),
            StoredDepth::F32(f32::INFINITY),
            StoredDepth::U16(0),
            StoredDepth::U16(u16::MAX),
        ][r.index(4)];
        assert_same(&calls, size, clear, &format!("round {round}"));
    }
}

#[test]
fn so_they_are_when_threads_share_the_triangles() {
    let mut r = Rng::new(0x5EA7);
    for round in 0..24 {
        let size = [1 + r.index(200) as u32, 1 + r.index(150) as u32];
        let calls: Vec<Call> = (0..3)
            .map(|order| {
                let state = state(&mut r, false, size);
                let reach = [1.0, 4.0, 15.0][r.index(3)];
                let (mut vertices, triangles) = soup(&mut r, size, 5_000, reach, state.space);
                spoil(&mut r, &mut vertices);
                Call { state, order: order * 7 % 3, vertices, triangles }
            })
            .collect();
        let clear = [StoredDepth::F32(0.0), StoredDepth::U16(0), StoredDepth::F32(0.5)][r.index(3)];
        assert_same(&calls, size, clear, &format!("round {round}"));
    }
}

#[test]
fn draws_in_any_sequence_obey_their_order() {
    let mut r = Rng::new(0x0BE1);
    for round in 0..60 {
        let size = [1 + r.index(150) as u32, 1 + r.index(150) as u32];
        let mut calls: Vec<Call> = calls(&mut r, size, round % 2 == 0);
        // The same again and again: only the order decides who is seen.
        let copies: Vec<Call> =
            calls.iter().map(|call| Call { order: call.order + 5, ..call.clone() }).collect();
        calls.extend(copies);
        r.shuffle(&mut calls);
        assert_same(&calls, size, StoredDepth::F32(0.0), &format!("round {round}"));
    }
}

#[test]
fn enough_triangles_for_several_threads() {
    let mut r = Rng::new(0x7EA35);
    let size = [320, 240];
    let calls: Vec<Call> = [(30_000, 3.0), (9_000, 12.0), (40, 300.0), (20_000, 1.0)]
        .into_iter()
        .zip(0..)
        .map(|((count, reach), order)| {
            let state = State::default();
            let (vertices, triangles) = soup(&mut r, size, count, reach, state.space);
            Call { state, order, vertices, triangles }
        })
        .collect();
    assert_same(&calls, size, StoredDepth::F32(0.0), "threads");
    let backwards: Vec<Call> = calls.into_iter().rev().collect();
    assert_same(&backwards, size, StoredDepth::U16(0), "threads, backwards");
}

#[test]
fn what_is_hidden_in_a_whole_tile_changes_no_pixel() {
    let mut r = Rng::new(0x0CC1);
    for round in 0..40 {
        let size = [256, 192];
        let mut order = 0..;
        let mut call = |r: &mut Rng, count: usize, reach: f64, plain: bool| {
            let state = State { space: Space::Clip, ..state(r, plain, size) };
            let (vertices, triangles) = soup(r, size, count, reach, state.space);
            Call { state, order: order.next().unwrap(), vertices, triangles }
        };
        let plain = round % 4 != 3;
        let calls = [
            call(&mut r, 200, 6.0, true),
            call(&mut r, 6, 1_500.0, true),
            call(&mut r, 100, 60.0, plain),
            call(&mut r, 4, 900.0, plain),
            call(&mut r, 200, 30.0, true),
        ];
        let clear = [StoredDepth::F32(0.0), StoredDepth::U16(0)][round % 2];
        assert_same(&calls, size, clear, &format!("round {round}"));
    }
}

#[test]
fn positions_are_transformed_as_transform_does() {
    let mut r = Rng::new(0x3A7);
    let size = [200, 120];
    for round in 0..30 {
        let matrix: Columns = [(); 4].map(|()| [(); 4].map(|()| r.real(-1.0, 1.0) as f32));
        let positions: Vec<[f32; 3]> = (0..900).map(|_| [(); 3].map(|()| r.real(-2.0, 2.0) as f32)).collect();
        let mut vertices = vec![[0.0; 4]; positions.len()];
        transform(&matrix, &positions, &mut vertices);
        let triangles: Vec<[u32; 3]> = (0..300).map(|_| [(); 3].map(|()| r.index(900) as u32)).collect();
        let call = Call { state: State::default(), order: 0, vertices, triangles };
        let expected = one_by_one(std::slice::from_ref(&call), size, StoredDepth::F32(0.0));
        for level in Level::available() {
            let mut frame = Frame::with(level, 1);
            frame.begin(size, 7, StoredDepth::F32(0.0)).unwrap();
            let vertices = Vertices::Model { matrix: &matrix, positions: &positions };
            let triangles = Triangles::Indexed(&call.triangles);
            let stats = frame.draw(&call.state, 0, vertices, triangles, |k| call.value(k));
            let mut color = vec![0; 200 * 120];
            let mut target = Target::new(&mut color, Depth::None, 200, 120, 200).unwrap();
            frame.finish(&mut target).unwrap();
            assert_eq!((stats, &color), (expected.2, &expected.0), "round {round}, {level}");
        }
    }
}

#[test]
fn a_frame_goes_to_any_number_of_targets() {
    let mut r = Rng::new(0xBA2D);
    let size = [150, 200];
    let calls = calls(&mut r, size, true);
    let expected = one_by_one(&calls, size, StoredDepth::F32(0.0));
    let mut frame = Frame::new();
    // Twice: a frame starts afresh, whatever it held.
    for _ in 0..2 {
        let got = in_a_frame(&calls, size, StoredDepth::F32(0.0), &mut frame);
        assert_eq!(got, expected);
    }
    let stride = 160;
    let mut color = vec![99; stride * 200];
    for rows in [0..1, 1..63, 63..70, 70..128, 128..200] {
        let first = rows.start as usize * stride;
        let mut band = Target::band(&mut color[first..], Depth::None, size, stride, rows).unwrap();
        frame.finish(&mut band).unwrap();
    }
    for (y, row) in color.chunks(stride).enumerate() {
        assert_eq!(row[..150], expected.0[y * 150..][..150], "row {y}");
        assert_eq!(row[150..], [99; 10], "between the rows, row {y}");
    }
    // A pixel of any kind may be made of a value, a place and a depth.
    let mut pixels = vec![(0, 0, 0, 0); 150 * 200];
    let mut target = Target::new(&mut pixels, Depth::None, 150, 200, 150).unwrap();
    frame.resolve(&mut target, |s| (s.x, s.y, s.value, s.depth.to_bits())).unwrap();
    for (k, &(x, y, value, depth)) in pixels.iter().enumerate() {
        assert_eq!((x, y), (k as u32 % 150, k as u32 / 150));
        assert_eq!((value, depth), (expected.0[k], expected.1[k]));
    }
}

#[test]
fn what_does_not_fit_is_refused() {
    let mut frame = Frame::new();
    let error = frame.begin([0, 9], 0, StoredDepth::F32(0.0)).unwrap_err();
    assert_eq!(error.to_string(), "a picture of 0×9 pixels: each side must be from 1 to 16384");
    frame.begin([8, 8], 0, StoredDepth::F32(0.0)).unwrap();
    let (mut color, mut depth) = ([0; 80], [0; 80]);
    let mut target = Target::new(&mut color, Depth::None, 10, 8, 10).unwrap();
    let error = frame.finish(&mut target).unwrap_err();
    assert_eq!(
        error.to_string(),
        "a frame of 8×8 pixels for a picture of 10×8: begin it with the picture's size"
    );
    let mut target = Target::new(&mut color, Depth::U16(&mut depth), 8, 8, 8).unwrap();
    let error = frame.finish(&mut target).unwrap_err();
    assert_eq!(
        error.to_string(),
        "the target keeps depth in another format than the frame: begin it with the target's"
    );
    let nothing = Frame::new().draw(
        &State::default(),
        0,
        Vertices::Clip(&[[0.0; 4]; 3]),
        Triangles::Consecutive,
        |_| unreachable!("nothing is drawn"),
    );
    assert_eq!((nothing.submitted, nothing.drawn), (1, 0));
}
