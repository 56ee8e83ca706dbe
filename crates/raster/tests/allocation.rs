//! Claim: drawing triangle by triangle never allocates, and a frame allocates nothing once it is warm: when the same,
//! or less, was drawn before.
//!
//! The counter counts what the calling thread allocates. Frames of several threads do the same work in pieces; what
//! rayon may allocate to hand it out is not counted here.
#![cfg(feature = "alloc")]

mod support;

use allocation_counter::measure;
use polosa_raster::{
    Clip, Columns, Depth, DepthTest, Frame, Level, PerTriangle, Rect, State, StoredDepth, Target, Triangles,
    Vertices,
};
use support::rng::Rng;

const SIZE: [u32; 2] = [500, 300];

/// Three draws, of what each part of a frame keeps memory for: fragments, small triangles and large ones, in lists of
/// all tiles; vertices behind the eye, which are clipped.
struct Scene {
    vertices: Vec<Clip>,
    indices: Vec<[u32; 3]>,
    matrix: Columns,
    positions: Vec<[f32; 3]>,
    states: [State; 3],
}

impl Scene {
    fn new(r: &mut Rng) -> Self {
        let mut vertices: Vec<Clip> = Vec::new();
        for k in 0..6_000 {
            let reach = [0.01, 0.03, 0.2, 0.7, 3.0][k % 5];
            let centre = [r.real(-1.1, 1.1), r.real(-1.1, 1.1)];
            for _ in 0..3 {
                let [x, y] = centre.map(|c| (c + r.real(-reach, reach)) as f32);
                let w = if r.index(50) == 0 { -0.5 } else { 1.0 };
                vertices.push([x * w, y * w, r.unit() as f32, w]);
            }
        }
        let mut corner = || r.index(vertices.len()) as u32;
        let mut indices: Vec<[u32; 3]> = (0..500).map(|_| [corner(), corner(), corner()]).collect();
        indices[77][1] = u32::MAX;
        let positions = vertices.iter().map(|&[x, y, z, _]| [x, y, z - 3.0]).collect();
        let matrix =
            [[2.0, 0.0, 0.0, 0.0], [0.0, 2.0, 0.0, 0.0], [0.0, 0.0, 0.0, -1.0], [0.0, 0.0, 1.0, 0.0]];
        let plain = State::default();
        let scissor = Some(Rect { x0: 20, y0: 30, x1: 400, y1: 250 });
        let states = [plain, State { scissor, ..plain }, State { write: false, ..plain }];
        Self { vertices, indices, matrix, positions, states }
    }

    /// A whole frame, its draws by `orders`.
    fn frame(&self, frame: &mut Frame, orders: [u32; 3], color: &mut [u32], depth: &mut [f32]) {
        let size @ [width, height] = frame_size(color.len());
        frame.begin(size, 7, StoredDepth::F32(0.0)).unwrap();
        let clip = Vertices::Clip(&self.vertices);
        let model = Vertices::Model { matrix: &self.matrix, positions: &self.positions };
        let value = |k: usize| k as u32;
        let mut stats = frame.draw(&self.states[0], orders[0], clip, Triangles::Consecutive, value);
        stats += frame.draw(&self.states[1], orders[1], clip, Triangles::Indexed(&self.indices), value);
        stats += frame.draw(&self.states[2], orders[2], model, Triangles::Indexed(&self.indices), value);
        stats += frame.draw(&self.states[0], orders[2], model, Triangles::Consecutive, value);
        assert!(stats.drawn > 5_000 && stats.clipped > 0 && stats.bad_index > 0, "{stats:?}");
        let mut target = Target::new(color, Depth::F32(depth), width, height, width as usize).unwrap();
        frame.finish(&mut target).unwrap();
    }
}

/// The whole picture, or half of its rows.
const fn frame_size(pixels: usize) -> [u32; 2] {
    [SIZE[0], pixels as u32 / SIZE[0]]
}

#[test]
fn the_counter_counts() {
    assert_eq!(measure(|| drop(std::hint::black_box(Box::new(7_u32)))).count_total, 1);
}

#[test]
fn a_warm_frame_allocates_nothing() {
    let scene = Scene::new(&mut Rng::new(0xA110C));
    let pixels = (SIZE[0] * SIZE[1]) as usize;
    for level in Level::available() {
        for orders in [[0, 1, 2], [2, 0, 1]] {
            let mut frame = Frame::with(level, 1);
            let (mut color, mut depth) = (vec![0; pixels], vec![0.0; pixels]);
            let cold = measure(|| scene.frame(&mut frame, orders, &mut color, &mut depth));
            assert!(cold.count_total > 0, "the first frame has to allocate");
            let first = color.clone();
            for turn in ["second", "third"] {
                let warm = measure(|| scene.frame(&mut frame, orders, &mut color, &mut depth));
                assert_eq!(warm.count_total, 0, "{turn} frame, {level}, {orders:?}: {warm:?}");
                assert!(color == first, "another picture");
            }
        }
    }
}

/// Nothing is given back either: what a larger picture left serves smaller ones, and the larger one again.
#[test]
fn what_was_large_serves_what_is_smaller() {
    let scene = Scene::new(&mut Rng::new(0x5A11));
    let pixels = (SIZE[0] * SIZE[1]) as usize;
    let mut frame = Frame::new();
    let (mut color, mut depth) = (vec![0; pixels], vec![0.0; pixels]);
    let mut whole = |frame: &mut Frame| scene.frame(frame, [0, 1, 2], &mut color, &mut depth);
    let mut few_rows = vec![0; SIZE[0] as usize];
    let clip = Vertices::Clip(&scene.vertices[..3_000]);
    let mut small = |frame: &mut Frame| {
        frame.begin([SIZE[0], 1], 0, StoredDepth::U16(0)).unwrap();
        frame.draw(&State::default(), 9, clip, Triangles::Consecutive, |k| k as u32);
        let mut target = Target::new(&mut few_rows, Depth::None, SIZE[0], 1, SIZE[0] as usize).unwrap();
        frame.finish(&mut target).unwrap();
    };
    whole(&mut frame);
    let counts = measure(|| {
        small(&mut frame);
        whole(&mut frame);
        small(&mut frame);
    });
    assert_eq!((counts.count_total, counts.count_current), (0, 0), "{counts:?}");
}

#[test]
fn triangle_by_triangle_nothing_is_ever_allocated() {
    let scene = Scene::new(&mut Rng::new(0x1EAF));
    let pixels = (SIZE[0] * SIZE[1]) as usize;
    let (mut color, mut depth) = (vec![0; pixels], vec![0.0; pixels]);
    let counts = measure(|| {
        let mut target =
            Target::new(&mut color, Depth::F32(&mut depth), SIZE[0], SIZE[1], SIZE[0] as usize).unwrap();
        target.clear(7, DepthTest::Greater);
        for state in &scene.states {
            target.triangles(state, &scene.vertices, &scene.indices, &PerTriangle(|k: usize| k as u32));
            target.lines(state, &scene.vertices, &[[0, 1], [1, 2], [7, 99]], 3);
        }
    });
    assert_eq!(counts.count_total, 0, "{counts:?}");
    assert!(color.iter().any(|&pixel| pixel != 7), "something was drawn");
}
