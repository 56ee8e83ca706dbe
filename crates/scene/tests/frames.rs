//! Claim: a frame is, to the last bit of colour and depth, what drawing over a cleared target gives, for every number of
//! threads; and so are pictures.

use polosa_math::Placement;
use polosa_math::glam::{DQuat, DVec3};
use polosa_raster::{Cull, Depth, DepthTest, Rect, Sample, Target};
use polosa_scene::{
    Camera, Color, Colors, DrawStats, FieldOfView, Light, Mesh, Object, Picture, PictureSettings, Projection,
    Renderer, Samples, Shading, Shape, Show, Style, World,
};
use proptest::prelude::*;

const BACKGROUND: Color = Color::new(3, 5, 7);
const THREADS: [usize; 4] = [1, 2, 3, 8];

/// xorshift64*: the same worlds on every machine.
struct Random(u64);

impl Random {
    fn next(&mut self) -> u64 {
        self.0 ^= self.0 >> 12;
        self.0 ^= self.0 << 25;
        self.0 ^= self.0 >> 27;
        self.0.wrapping_mul(0x2545_f491_4f6c_dd1d) >> 11
    }

    fn below(&mut self, count: u64) -> u64 {
        self.next() % count
    }

    fn between(&mut self, low: f64, high: f64) -> f64 {
        low + (high - low) * (self.next() as f64 / (1_u64 << 53) as f64)
    }

    fn color(&mut self) -> Color {
        Color::from_u32(self.below(1 << 24) as u32)
    }

    fn vector(&mut self, reach: f64) -> DVec3 {
        DVec3::from_array([(); 3].map(|()| self.between(-reach, reach)))
    }
}

fn mesh(random: &mut Random, shape: &str, colors: u64) -> Mesh {
    let mesh = shape.parse::<Shape>().unwrap().mesh().unwrap();
    let (faces, vertices) = (mesh.triangles().len(), mesh.positions().len());
    let colors = match colors {
        0 => Colors::None,
        1 => Colors::Face((0..faces).map(|_| random.color()).collect()),
        _ => Colors::Vertex((0..vertices).map(|_| random.color()).collect()),
    };
    mesh.with_colors(colors).unwrap()
}

/// Objects of all kinds around the origin; some in the same place, some twice.
fn world(random: &mut Random, objects: usize) -> World {
    let shapes = ["cube", "torus:24:12", "uv-sphere:64:40", "teapot:4", "tetrahedron", "cone:9"];
    let mut world = World::new();
    for _ in 0..objects {
        let (shape, colors) = (shapes[random.below(6) as usize], random.below(4));
        let key = world.add_mesh(mesh(random, shape, colors));
        for _ in 0..1 + random.below(2) {
            let mut object = Object::new(key);
            object.placement = Placement {
                translation: random.vector(1.5),
                rotation: DQuat::from_array([(); 4].map(|()| random.between(-1.0, 1.0))).normalize(),
                scale: random.vector(1.5),
            };
            if random.below(4) == 0 {
                object.placement = Placement::IDENTITY;
            }
            object.color = (random.below(4) == 0).then(|| random.color());
            object.show = [Show::Surface, Show::Surface, Show::Both, Show::Wire][random.below(4) as usize];
            object.visible = random.below(8) > 0;
            world.add(object).unwrap();
        }
    }
    world
}

/// Near enough that the near plane cuts, or beside or far away.
fn camera(random: &mut Random, [width, height]: [u32; 2]) -> Camera {
    let mut camera = Camera::new();
    camera.set_aspect(f64::from(width) / f64::from(height)).unwrap();
    let far = if random.below(2) == 0 { f64::INFINITY } else { 6.0 };
    let fov = FieldOfView::Vertical(random.between(0.3, 2.0));
    camera
        .set_projection(match random.below(4) {
            0 => Projection::Orthographic { height: 4.0, near: 0.1, far: 6.0 },
            _ => Projection::Perspective { fov, near: 0.1, far },
        })
        .unwrap();
    let reach = [0.7, 2.0, 5.0][random.below(3) as usize];
    camera.set_position(random.vector(reach)).unwrap();
    camera.look_at(random.vector(0.5) + DVec3::new(0.0, 0.0, 1e-3)).unwrap();
    camera
}

fn style(random: &mut Random, [width, height]: [u32; 2]) -> Style {
    let mut side = |most: u32| random.below(u64::from(most) + 3) as u32;
    let scissor = Rect { x0: side(width / 2), y0: side(height / 2), x1: side(width), y1: side(height) };
    Style {
        shading: [Shading::Flat, Shading::Flat, Shading::Unlit][random.below(3) as usize],
        cull: [Cull::None, Cull::None, Cull::Back, Cull::Front][random.below(4) as usize],
        scissor: (random.below(4) == 0).then_some(scissor),
        sample: if random.below(2) == 0 {
            Sample::CENTER
        } else {
            Sample { x: random.below(256) as u8, y: 9 }
        },
        color: random.color(),
        edge_color: random.color(),
    }
}

/// What is drawn, and how.
struct Scene {
    world: World,
    camera: Camera,
    light: Light,
    style: Style,
    size: [u32; 2],
}

/// The memory of a picture, not as it should be.
struct Memory {
    color: Vec<u32>,
    f32s: Vec<f32>,
    u16s: Vec<u16>,
}

impl Scene {
    fn random(seed: u64, objects: usize) -> Self {
        let mut random = Random(seed | 1);
        let size = [1 + random.below(170) as u32, 1 + random.below(150) as u32];
        Self {
            world: world(&mut random, objects),
            camera: camera(&mut random, size),
            light: Light { direction: random.vector(1.0), ..Light::default() },
            style: style(&mut random, size),
            size,
        }
    }

    fn memory(&self) -> Memory {
        let pixels = ((self.size[0] + 3) * self.size[1]) as usize;
        Memory { color: vec![0xdead; pixels], f32s: vec![0.5; pixels], u16s: vec![9; pixels] }
    }

    /// Calls `draw` with a target whose depth has 0, 16 or 32 bits.
    fn onto<R>(&self, memory: &mut Memory, bits: u32, draw: impl FnOnce(&mut Target<'_, u32>) -> R) -> R {
        let depth = match bits {
            0 => Depth::None,
            16 => Depth::U16(&mut memory.u16s),
            _ => Depth::F32(&mut memory.f32s),
        };
        let [width, height] = self.size;
        draw(&mut Target::new(&mut memory.color, depth, width, height, width as usize + 3).unwrap())
    }

    fn drawn(&self, bits: u32) -> (Memory, DrawStats) {
        let mut memory = self.memory();
        let stats = self.onto(&mut memory, bits, |target| {
            target.clear(BACKGROUND.to_u32(), DepthTest::Greater);
            Renderer::with_threads(1).draw(&self.world, &self.camera, &self.light, &self.style, target)
        });
        (memory, stats)
    }

    fn framed(&self, renderer: &mut Renderer, bits: u32) -> (Memory, DrawStats) {
        let mut memory = self.memory();
        let Self { world, camera, light, style, .. } = self;
        let stats = self.onto(&mut memory, bits, |target| {
            renderer.frame(world, camera, light, style, Some(BACKGROUND), target).unwrap()
        });
        (memory, stats)
    }

    fn check(&self, renderers: &mut [Renderer], what: &str) {
        for bits in [32, 16] {
            let (expected, stats) = self.drawn(bits);
            for renderer in &mut *renderers {
                let what = format!("{what}, {bits} bits, {} threads", renderer.threads());
                let (got, got_stats) = self.framed(renderer, bits);
                assert!(got.color == expected.color, "{what}: colours");
                let same = got.f32s.iter().zip(&expected.f32s).all(|(a, b)| a.to_bits() == b.to_bits());
                assert!(same && got.u16s == expected.u16s, "{what}: depths");
                assert_eq!(got_stats, stats, "{what}");
                if bits == 32 {
                    let (flat, flat_stats) = self.framed(renderer, 0);
                    assert!(flat.color == expected.color, "{what}: colours without depth");
                    assert_eq!(flat_stats, stats, "{what}, without depth");
                }
            }
        }
    }

    /// The numbers of triangles, drawn over a cleared target and as a frame.
    fn check_ids(&self, renderers: &mut [Renderer]) {
        let mut expected = self.memory();
        let stats = self.onto(&mut expected, 32, |target| {
            target.clear(0, DepthTest::Greater);
            Renderer::new().draw_ids(&self.world, &self.camera, &self.style, target)
        });
        for renderer in renderers {
            for bits in [32, 0] {
                let mut got = self.memory();
                let got_stats = self.onto(&mut got, bits, |target| {
                    renderer.frame_ids(&self.world, &self.camera, &self.style, target).unwrap()
                });
                assert!(got.color == expected.color, "ids, {bits} bits, {} threads", renderer.threads());
                assert_eq!(got_stats, stats);
            }
        }
    }
}

fn renderers() -> Vec<Renderer> {
    THREADS.map(Renderer::with_threads).into()
}

#[test]
fn a_frame_is_what_drawing_over_a_cleared_target_gives() {
    let mut renderers = renderers();
    for seed in 0..60 {
        let scene = Scene::random(0xf4a3e * (seed + 1), 1 + seed as usize % 5);
        scene.check(&mut renderers, &format!("seed {seed}"));
        scene.check_ids(&mut renderers);
    }
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(40))]

    #[test]
    fn whatever_the_world(seed: u64, objects in 0_usize..6) {
        let scene = Scene::random(seed, objects);
        scene.check(&mut [Renderer::with_threads(1 + seed as usize % 9)], &format!("seed {seed}"));
    }
}

/// Vertex colours alone, cut by the near plane right before the eye.
#[test]
fn vertex_colours_are_blended_in_a_frame_as_while_drawing() {
    let mut renderers = renderers();
    for seed in 0..30 {
        let mut random = Random(0x7e47 + 2 * seed);
        let mut scene = Scene::random(seed + 99, 0);
        for shape in ["cube", "plane:1", "plane:7", "uv-sphere:90:50"] {
            let key = scene.world.add_mesh(mesh(&mut random, shape, 2));
            scene.world.add(Object::new(key).at(random.vector(0.3))).unwrap();
        }
        scene.camera.set_position(random.vector(0.6)).unwrap();
        scene.check(&mut renderers, &format!("seed {seed}"));
    }
}

#[test]
fn of_surfaces_in_one_place_the_first_that_was_added_is_seen_in_frames_too() {
    let mut random = Random(77);
    let mut scene = Scene::random(5, 0);
    scene.camera = camera(&mut random, scene.size);
    for colors in [1, 2, 0, 2, 1] {
        let key = scene.world.add_mesh(mesh(&mut random, "torus:40:30", colors));
        scene.world.add(Object::new(key).shown(Show::Both)).unwrap();
    }
    scene.check(&mut renderers(), "ties");
}

/// A frame's tiles, several to a side, and more triangles than one thread takes.
#[test]
fn large_frames_are_the_same_with_any_number_of_threads() {
    let mut random = Random(11);
    let mut scene = Scene::random(9, 2);
    scene.size = [397, 301];
    scene.camera = Camera::new();
    for colors in [0, 2] {
        let key = scene.world.add_mesh(mesh(&mut random, "uv-sphere:200:120", colors));
        scene.world.add(Object::new(key).at(random.vector(0.5)).shown(Show::Both)).unwrap();
    }
    let bounds = scene.world.bounds();
    scene.camera.frame(&bounds, DVec3::new(1.0, 0.4, 0.7), DVec3::Y, 0.0).unwrap();
    scene.style = Style::default();
    scene.check(&mut renderers(), "large");
}

/// Once somebody has asked for the balls inside a mesh, what they hide is left out.
#[test]
fn what_a_mesh_hides_behind_itself_is_left_out_and_no_pixel_changes() {
    let mut renderers = renderers();
    let mut hidden = 0;
    for seed in 0..24 {
        let mut random = Random(0x41d + 2 * seed);
        let mut scene = Scene::random(seed + 999, 2);
        for shape in ["uv-sphere:60:40", "torus:64:40", "sphere:4"] {
            let key = scene.world.add_mesh(mesh(&mut random, shape, seed % 4));
            let size = DVec3::splat(random.between(0.5, 2.0));
            let placement = Placement { scale: size, translation: random.vector(2.0), ..Placement::IDENTITY };
            scene.world.add(Object::new(key).placed(placement)).unwrap();
        }
        scene.camera = Camera::new();
        scene.camera.frame(&scene.world.bounds(), random.vector(1.0), DVec3::Y, 0.0).unwrap();
        if seed % 6 != 0 {
            scene.style.cull = Cull::None;
        }
        let keys: Vec<_> = scene.world.meshes().map(|(key, _)| key).collect();
        for key in keys {
            assert!(scene.world.occluders(key).is_some());
        }
        let (expected, stats) = scene.drawn(32);
        for renderer in &mut renderers {
            let (got, got_stats) = scene.framed(renderer, 32);
            assert!(got.color == expected.color && got.f32s == expected.f32s, "seed {seed}");
            assert_eq!(got_stats.triangles.submitted + got_stats.hidden, stats.triangles.submitted);
            assert!(got_stats.hidden == 0 || scene.style.cull == Cull::None);
            hidden += got_stats.hidden;
        }
    }
    assert!(hidden > 100_000, "{hidden}");
}

#[test]
fn a_band_of_a_frame_is_those_rows_of_it() {
    for seed in 0..10 {
        let scene = Scene::random(300 + seed, 4);
        let (expected, _) = scene.drawn(32);
        let [width, height] = scene.size;
        let stride = width as usize + 3;
        let mut memory = scene.memory();
        let mut renderer = Renderer::with_threads(2);
        for first in (0..height).step_by(37) {
            let rows = first..height.min(first + 37);
            let at = first as usize * stride..rows.end as usize * stride;
            let depth = Depth::F32(&mut memory.f32s[at.clone()]);
            let mut target = Target::band(&mut memory.color[at], depth, scene.size, stride, rows).unwrap();
            let Scene { world, camera, light, style, .. } = &scene;
            renderer.frame(world, camera, light, style, Some(BACKGROUND), &mut target).unwrap();
        }
        assert!(memory.color == expected.color && memory.f32s == expected.f32s, "seed {seed}");
    }
}

/// Pictures of one sample are checked against drawing; of several, numbers of threads against each other.
#[test]
fn pictures_are_the_same_whoever_draws_them() {
    for seed in 0..12 {
        let mut scene = Scene::random(700 + seed, 4);
        scene.style.sample = Sample::CENTER;
        let (expected, stats) = scene.drawn(32);
        let [width, height] = scene.size;
        for samples in [Samples::One, Samples::Four] {
            for (background, distances, ids) in
                [(Some(BACKGROUND), false, false), (None, true, true), (Some(BACKGROUND), true, false)]
            {
                let settings =
                    PictureSettings { width, height, background, samples, distances, ids, threads: None };
                let render = |renderer: &mut Renderer, threads: Option<usize>| {
                    let threads = threads.and_then(|threads| threads.try_into().ok());
                    let Scene { world, camera, light, style, .. } = &scene;
                    let settings = PictureSettings { threads, ..settings };
                    Picture::render(renderer, world, camera, light, style, &settings).unwrap()
                };
                let first = render(&mut Renderer::with_threads(1), None);
                assert_eq!(first.stats, stats);
                if samples == Samples::One && background.is_some() {
                    let rows = expected.color.chunks(width as usize + 3).map(|row| &row[..width as usize]);
                    assert!(first.pixels.chunks(width as usize).eq(rows), "seed {seed}");
                }
                for threads in [2, 3, 8] {
                    assert!(render(&mut Renderer::with_threads(threads), None) == first, "seed {seed}");
                }
                for threads in [1, 2, 400] {
                    assert!(render(&mut Renderer::new(), Some(threads)) == first, "seed {seed}");
                }
            }
        }
    }
}

#[test]
fn a_renderer_has_as_many_threads_as_it_was_told() {
    assert!(Renderer::new().threads() >= 1);
    for (threads, expected) in [(0, 1), (1, 1), (3, 3), (256, 256), (1000, 256)] {
        assert_eq!(Renderer::with_threads(threads).threads(), expected);
        assert_eq!(Renderer::with_threads(threads).clone().threads(), expected);
    }
}

#[test]
fn timings_are_those_of_the_last_picture() {
    let scene = Scene::random(42, 5);
    let mut renderer = Renderer::with_threads(1);
    assert_eq!(renderer.timings(), polosa_scene::Timings::default());
    scene.framed(&mut renderer, 32);
    let timings = renderer.timings();
    assert!(timings.setup.as_nanos() > 0 && timings.fill.as_nanos() > 0, "{timings:?}");
    let nothing = Scene { world: World::new(), ..scene };
    nothing.framed(&mut renderer, 32);
    assert!(renderer.timings().setup < timings.setup, "an empty world: {:?}", renderer.timings());
}
