//! The fill loop of the raster core: triangles of one size each, with depth, into a warm target.
//!
//! ```sh
//! cargo bench --bench fill
//! ```
//!
//! Every group draws the same random triangles (own generator, fixed seed) over and over; before it is timed,
//! its picture is drawn once more by asking for each fragment, and must be the same.

use std::hint::black_box;

use criterion::{BenchmarkId, Criterion, Throughput, criterion_group, criterion_main};
use polosa_raster::{Depth, DepthTest, Flat, Fragment, PerTriangle, Space, State, Target};

const WIDTH: u32 = 1920;
const HEIGHT: u32 = 1080;
const PIXELS: usize = (WIDTH * HEIGHT) as usize;

/// Areas in pixels, and how many triangles of each.
const SIZES: [(f32, usize); 5] =
    [(2.0, 100_000), (50.0, 20_000), (512.0, 4_000), (5_000.0, 400), (80_000.0, 40)];

/// Marsaglia's xorshift.
struct Random(u64);

impl Random {
    fn unit(&mut self) -> f32 {
        self.0 ^= self.0 << 13;
        self.0 ^= self.0 >> 7;
        self.0 ^= self.0 << 17;
        (self.0 >> 40) as f32 / (1 << 24) as f32
    }
}

/// Triangles of about one area, turned and placed at random, already in pixels.
fn triangles(area: f32, count: usize) -> (Vec<[f32; 4]>, Vec<[u32; 3]>) {
    let mut random = Random(0x9e37_79b9_7f4a_7c15);
    // Equilateral: area = 3√3/4 · radius².
    let radius = (area / 1.299).sqrt();
    let mut vertices = Vec::with_capacity(count * 3);
    for _ in 0..count {
        let (x, y) = (random.unit() * WIDTH as f32, random.unit() * HEIGHT as f32);
        let turn = random.unit() * std::f32::consts::TAU;
        for k in 0..3_u8 {
            let angle = turn + f32::from(k) * std::f32::consts::TAU / 3.0;
            vertices.push([x + radius * angle.cos(), y + radius * angle.sin(), random.unit(), 1.0]);
        }
    }
    let indices = (0..count as u32).map(|k| [3 * k, 3 * k + 1, 3 * k + 2]).collect();
    (vertices, indices)
}

fn fill(c: &mut Criterion) {
    let state = State { space: Space::Screen, ..State::default() };
    let (mut color, mut depth) = (vec![0_u32; PIXELS], vec![0_f32; PIXELS]);
    for (area, count) in SIZES {
        let (vertices, indices) = triangles(area, count);
        let value = |triangle: usize| triangle as u32 + 1;

        let mut draw = |shaded: bool| {
            let depth = Depth::F32(&mut depth);
            let mut target =
                Target::new(&mut color, depth, WIDTH, HEIGHT, WIDTH as usize).expect("sizes fit");
            target.clear(0, DepthTest::Greater);
            let stats = if shaded {
                let shade = |fragment: &Fragment<'_>, pixel: &mut u32| {
                    *pixel = value(fragment.triangle());
                    true
                };
                target.triangles(&state, &vertices, &indices, &shade)
            } else {
                target.triangles(&state, &vertices, &indices, &PerTriangle(value))
            };
            assert_eq!(stats.drawn, count as u64);
            color.clone()
        };
        assert!(draw(true) == draw(false), "a fragment at a time and strip by strip must give one picture");

        let mut group = c.benchmark_group("fill");
        group.sample_size(20).throughput(Throughput::Elements(count as u64));
        let depth = Depth::F32(&mut depth);
        let mut target = Target::new(&mut color, depth, WIDTH, HEIGHT, WIDTH as usize).expect("sizes fit");
        group.bench_function(BenchmarkId::new("strips", format!("{area} px")), |b| {
            b.iter(|| {
                target.clear(0, DepthTest::Greater);
                target.triangles(&state, black_box(&vertices), &indices, &PerTriangle(value))
            });
        });
        group.finish();
    }

    let mut group = c.benchmark_group("clear");
    group.throughput(Throughput::Bytes(PIXELS as u64 * 8));
    let mut target =
        Target::new(&mut color, Depth::F32(&mut depth), WIDTH, HEIGHT, WIDTH as usize).expect("sizes fit");
    group.bench_function("color and depth", |b| b.iter(|| target.clear(black_box(7), DepthTest::Greater)));
    let quad = [[0.0, 0.0], [0.0, 1080.0], [1920.0, 1080.0], [1920.0, 0.0]].map(|[x, y]| [x, y, 0.5, 1.0]);
    let off = State { test: DepthTest::Off, write: false, ..state };
    group.bench_function("a triangle pair without depth", |b| {
        b.iter(|| target.triangles(&off, black_box(&quad), &[[0, 1, 2], [0, 2, 3]], &Flat(7)));
    });
    group.finish();
}

criterion_group!(benches, fill);
criterion_main!(benches);
