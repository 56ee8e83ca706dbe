//! Whole frames of the scene crate: transform, cull, light, fill, clear included.
//!
//! ```sh
//! cargo bench --bench frame -- mesh/
//! ```
//!
//! | group | what grows |
//! |---|---|
//! | `mesh` | triangles, from 1 thousand to 4 million, over two thirds of 1920×1080 |
//! | `overdraw` | shells inside each other, drawn from outside in, so that all but the first are hidden, and from inside out, so that each is seen before the next one hides it |
//! | `resolution` | pixels, from 320×240 to 3840×2160 |
//!
//! Every frame is drawn once before it is timed, and must show the mesh; all numbers of threads must give one picture.

use std::hint::black_box;
use std::time::Duration;

use criterion::measurement::WallTime;
use criterion::{BenchmarkGroup, BenchmarkId, Criterion, Throughput, criterion_group, criterion_main};
use polosa_benches::mesh::{RANGE, dented_ball};
use polosa_benches::ours::Picture;
use polosa_benches::workloads::{HEIGHT, WIDTH};
use polosa_math::Placement;
use polosa_math::glam::{DMat4, DVec3};
use polosa_raster::Stats;
use polosa_scene::{Camera, Color, Light, Mesh, Object, Renderer, Style, World};

/// Numbers of threads that draw.
const THREADS: [usize; 2] = [1, 2];

/// Shells, one inside the other.
const LAYERS: [usize; 5] = [1, 2, 4, 8, 16];

/// Pictures, from the smallest to the largest.
const SIZES: [[u32; 2]; 6] = [[320, 240], [640, 480], [1280, 720], [1920, 1080], [2560, 1440], [3840, 2160]];

fn brief() -> Criterion {
    Criterion::default()
        .warm_up_time(Duration::from_millis(300))
        .measurement_time(Duration::from_secs(1))
        .sample_size(10)
}

/// A world with the camera that sees it, and the picture that it is drawn into.
struct Scene {
    world: World,
    camera: Camera,
    picture: Picture,
}

impl Scene {
    /// Stretched and dented balls of `count` triangles each, of the given sizes, drawn in this order.
    fn new(count: u32, radii: impl IntoIterator<Item = f64>, size: [u32; 2]) -> Self {
        let ball = dented_ball(count);
        let mut world = World::new();
        let mesh = Mesh::new(ball.positions, ball.triangles).expect("the mesh's indices are in range");
        let mesh = world.add_mesh(mesh);
        for (index, radius) in (0..).zip(radii) {
            let matrix = DMat4::from_scale(DVec3::new(1.75, 1.0, 1.0) * radius);
            let placement = Placement::from_matrix(&matrix).expect("a scale is a placement");
            let color = Color::new(250 - 10 * index, 180, 40 + 10 * index);
            world.add(Object::new(mesh).placed(placement).colored(color)).expect("the mesh is there");
        }
        let mut camera = Camera::new();
        camera.set_aspect(f64::from(size[0]) / f64::from(size[1])).expect("the aspect is positive");
        camera
            .frame(&world.bounds(), DVec3::new(0.2, 0.3, 1.0), DVec3::Y, 0.0)
            .expect("the balls can be framed");
        Self { world, camera, picture: Picture::new(size) }
    }

    fn draw(&mut self, renderer: &mut Renderer) -> Stats {
        let (light, style) = (Light::default(), Style::default());
        let mut target = self.picture.target();
        let drawn = renderer.frame(&self.world, &self.camera, &light, &style, None, &mut target);
        drawn.expect("a frame fits a target of its size").triangles
    }

    /// Every number of threads draws the same picture, one that shows the mesh.
    fn check(&mut self) {
        let mut first: Option<Vec<u32>> = None;
        for threads in THREADS {
            let stats = self.draw(&mut Renderer::with_threads(threads));
            assert_eq!(stats.drawn + stats.degenerate + stats.culled, stats.submitted, "all is in view");
            let shown = self.picture.color.iter().filter(|&&pixel| pixel != 0).count();
            assert!(4 * shown > self.picture.color.len(), "the mesh fills the picture: {shown} pixels");
            let first = first.get_or_insert_with(|| self.picture.color.clone());
            assert!(*first == self.picture.color, "{threads} threads draw another picture");
        }
    }

    fn time(&mut self, group: &mut BenchmarkGroup<'_, WallTime>, name: &str) {
        self.check();
        for threads in THREADS {
            let mut renderer = Renderer::with_threads(threads);
            let id = BenchmarkId::new(name, format!("{threads} threads").replace("1 threads", "1 thread"));
            group.bench_function(id, |b| b.iter(|| black_box(self.draw(&mut renderer))));
        }
    }
}

fn mesh(c: &mut Criterion) {
    let mut group = c.benchmark_group("mesh");
    for count in RANGE {
        group.throughput(Throughput::Elements(count.into()));
        let mut scene = Scene::new(count, [1.0], [WIDTH, HEIGHT]);
        scene.time(&mut group, &format!("{count} triangles"));
    }
    group.finish();
}

fn overdraw(c: &mut Criterion) {
    let mut group = c.benchmark_group("overdraw");
    for layers in LAYERS {
        let radii = move || (0..layers).map(|layer| 1.0 - 0.02 * layer as f64);
        Scene::new(16_000, radii(), [WIDTH, HEIGHT]).time(&mut group, &format!("{layers} outside in"));
        Scene::new(16_000, radii().rev(), [WIDTH, HEIGHT]).time(&mut group, &format!("{layers} inside out"));
    }
    group.finish();
}

fn resolution(c: &mut Criterion) {
    let mut group = c.benchmark_group("resolution");
    for size @ [width, height] in SIZES {
        group.throughput(Throughput::Elements(u64::from(width) * u64::from(height)));
        Scene::new(64_000, [1.0], size).time(&mut group, &format!("{width}x{height}"));
    }
    group.finish();
}

criterion_group! { name = benches; config = brief(); targets = mesh, overdraw, resolution }
criterion_main!(benches);
