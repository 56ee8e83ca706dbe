//! What is left out of a drawing changes no pixel of it: both are drawn and compared, colour, depth and ids.

use fearless_simd::Level;
use polosa_math::glam::{DQuat, DVec3};
use polosa_math::{Bounds, Placement};
use polosa_raster::{Clip, Cull, Depth, DepthTest, PerTriangle, Sample, State, Stats, Target, transform};
use polosa_scene::occluder::{Occluders, Shadows};
use polosa_scene::{Camera, FieldOfView, Mesh, Projection, Shape};
use proptest::prelude::*;

const SIZE: [u32; 2] = [160, 120];

/// xorshift64*: the same views on every machine.
struct Random(u64);

impl Random {
    fn unit(&mut self) -> f64 {
        self.0 ^= self.0 >> 12;
        self.0 ^= self.0 << 25;
        self.0 ^= self.0 >> 27;
        (self.0.wrapping_mul(0x2545_f491_4f6c_dd1d) >> 11) as f64 / (1_u64 << 53) as f64
    }

    fn between(&mut self, low: f64, high: f64) -> f64 {
        low + (high - low) * self.unit()
    }

    fn direction(&mut self) -> DVec3 {
        loop {
            let v = DVec3::new(self.between(-1.0, 1.0), self.between(-1.0, 1.0), self.between(-1.0, 1.0));
            if (0.01..1.0).contains(&v.length()) {
                return v.normalize();
            }
        }
    }
}

fn shape(text: &str) -> Mesh {
    text.parse::<Shape>().unwrap().mesh().unwrap()
}

fn moved(mesh: &Mesh, map: impl Fn(DVec3) -> DVec3) -> Mesh {
    let map = |p: &[f32; 3]| map(DVec3::from_array(p.map(f64::from))).to_array().map(|c| c as f32);
    Mesh::new(mesh.positions().iter().map(map).collect(), mesh.triangles().to_vec()).unwrap()
}

fn joined(a: &Mesh, b: &Mesh) -> Mesh {
    let first = a.positions().len() as u32;
    let triangles = b.triangles().iter().map(|triangle| triangle.map(|vertex| vertex + first));
    Mesh::new(
        [a.positions(), b.positions()].concat(),
        a.triangles().iter().copied().chain(triangles).collect(),
    )
    .unwrap()
}

/// A camera somewhere outside of a ball around `bounds`, near or far, that looks more or less at it.
fn outside(random: &mut Random, bounds: &Bounds, placement: &Placement) -> Camera {
    let center = placement.to_world(bounds.center().unwrap());
    let radius = bounds.diagonal() / 2.0 * placement.scale.abs().max_element();
    let mut camera = Camera::new();
    camera.set_aspect(4.0 / 3.0).unwrap();
    let distance = radius * (1.01 + random.between(0.0, 3.0).exp() - 1.0);
    let near = (distance - radius) * 0.99;
    let far = if random.unit() < 0.5 { f64::INFINITY } else { distance + 1.5 * radius };
    let lens = if random.unit() < 0.7 {
        let fov = FieldOfView::Vertical(random.between(0.05, 1.5));
        Projection::Perspective { fov, near, far }
    } else {
        let height = radius * random.between(-2.0, 4.0).exp();
        Projection::Orthographic { height, near, far: distance + 1.5 * radius }
    };
    camera.set_projection(lens).unwrap();
    camera.set_position(center + random.direction() * distance).unwrap();
    camera.look_at(center + random.direction() * radius * 0.5).unwrap();
    camera.set_view_up(random.direction()).unwrap();
    camera
}

/// Ids and depths of the triangles that `keep` keeps.
fn draw(
    mesh: &Mesh,
    clip: &[Clip],
    state: &State,
    keep: impl Fn([u32; 3]) -> bool,
) -> (Vec<u32>, Vec<f32>, Stats) {
    let [width, height] = SIZE;
    let pixels = (width * height) as usize;
    let (mut ids, mut depth) = (vec![0; pixels], vec![0.0; pixels]);
    let mut target = Target::new(&mut ids, Depth::F32(&mut depth), width, height, width as usize).unwrap();
    target.clear(0, DepthTest::Greater);
    let kept: Vec<(u32, [u32; 3])> =
        (1..).zip(mesh.triangles().iter().copied()).filter(|&(_, triangle)| keep(triangle)).collect();
    let triangles: Vec<[u32; 3]> = kept.iter().map(|&(_, triangle)| triangle).collect();
    let stats = target.triangles(state, clip, &triangles, &PerTriangle(|index: usize| kept[index].0));
    (ids, depth, stats)
}

/// Draws a mesh with and without what it hides from a number of places outside; the share that was left out.
///
/// Each triangle has an id of its own, which stands for any colour that it may have.
fn hidden_share(name: &str, mesh: &Mesh, placement: &Placement, views: usize, seed: u64) -> f64 {
    let mut random = Random(seed);
    let occluders = Occluders::of(mesh);
    let (bounds, _) = Bounds::from_points(mesh.positions().iter().copied());
    let (mut hidden, mut all) = (0, 0);
    let mut marks = Vec::new();
    for view in 0..views {
        let camera = outside(&mut random, &bounds, placement);
        all += mesh.triangles().len();
        let Some(shadows) = occluders.shadows(&camera, placement, &bounds, SIZE) else { continue };
        let mut clip = vec![[0.0; 4]; mesh.positions().len()];
        transform(&camera.clip_from_model(placement), mesh.positions(), &mut clip);
        shadows.mark(Level::new(), &clip, &mut marks);
        let place = |k: f64| (k * 256.0) as u8;
        let sample = Sample { x: place(random.unit()), y: place(random.unit()) };
        let sample = if view % 2 == 0 { Sample::CENTER } else { sample };
        let state = State { sample, ..State::default() };
        let whole = draw(mesh, &clip, &state, |_| true);
        let seen = draw(mesh, &clip, &state, |triangle| !Shadows::hides(&marks, triangle));
        assert!(whole.0 == seen.0, "{name}, view {view}: ids differ");
        assert!(whole.1 == seen.1, "{name}, view {view}: depths differ");
        hidden += mesh.triangles().iter().filter(|&&triangle| Shadows::hides(&marks, triangle)).count();
    }
    hidden as f64 / all as f64
}

#[test]
fn a_dense_round_mesh_hides_nearly_half_of_itself_and_no_pixel_changes() {
    for name in ["uv-sphere:128:64", "sphere:5"] {
        let share = hidden_share(name, &shape(name), &Placement::IDENTITY, 60, 1);
        assert!((0.35..0.75).contains(&share), "{name}: {share}");
    }
}

#[test]
fn standard_shapes_hide_parts_of_themselves_and_no_pixel_changes() {
    let mut hidden = 0.0;
    for info in Shape::all() {
        let mesh = shape(info.name);
        hidden += hidden_share(info.name, &mesh, &Placement::IDENTITY, 40, 2);
    }
    hidden += hidden_share("torus", &shape("torus:128:64"), &Placement::IDENTITY, 60, 3);
    assert!(hidden > 0.5, "something was hidden at all");
}

#[test]
fn thin_walls_change_no_pixel_though_leaving_out_back_faces_would() {
    let (ball, ring) = (shape("uv-sphere:96:48"), shape("torus:96:48"));
    for thickness in [0.3, 0.1, 1e-2, 1e-3, 1e-4, 1e-5] {
        for mesh in [&ball, &ring] {
            let flat = moved(mesh, |v| v * DVec3::new(1.0, thickness, 1.0));
            hidden_share(&format!("flat {thickness}"), &flat, &Placement::IDENTITY, 25, 4);
        }
    }
    // What the module's documentation says of back faces: else all this would be for nothing.
    let thin = moved(&ball, |v| v * DVec3::new(1.0, 1e-5, 1.0));
    let (bounds, _) = Bounds::from_points(thin.positions().iter().copied());
    let mut random = Random(5);
    let changed = (0..20).filter(|_| {
        let camera = outside(&mut random, &bounds, &Placement::IDENTITY);
        let mut clip = vec![[0.0; 4]; thin.positions().len()];
        transform(&camera.clip_from_model(&Placement::IDENTITY), thin.positions(), &mut clip);
        let both = draw(&thin, &clip, &State::default(), |_| true).0;
        both != draw(&thin, &clip, &State { cull: Cull::Back, ..State::default() }, |_| true).0
    });
    assert!(changed.count() > 0);
}

#[test]
fn meshes_that_cross_touch_or_hold_themselves_change_no_pixel() {
    let (ball, ring, cube) = (shape("uv-sphere:96:48"), shape("torus:96:48"), shape("cube"));
    let turned =
        Mesh::new(ball.positions().to_vec(), ball.triangles().iter().map(|&[a, b, c]| [a, c, b]).collect())
            .unwrap();
    let cases = [
        ("crossing", joined(&ball, &moved(&ball, |v| v + DVec3::new(0.7, 0.1, 0.3)))),
        ("nested", joined(&ball, &moved(&ball, |v| v * 0.999))),
        ("hollow", joined(&ball, &moved(&turned, |v| v * 0.9))),
        ("inside out", turned.clone()),
        ("cancelled", joined(&ball, &turned)),
        ("twice the same", joined(&ball, &ball)),
        ("face to face", joined(&cube, &moved(&cube, |v| v + DVec3::new(2.0, 0.0, 0.0)))),
        ("twisted", moved(&ball, |v| DVec3::new(v.x, v.y * (1.0 - 1.8 * (0.5 - v.x).max(0.0)), v.z))),
        ("wavy", moved(&ring, |v| v * (1.0 + 0.2 * (20.0 * v.x).sin() * (20.0 * v.z).sin()))),
        ("needles", moved(&ball, |v| v * (0.3 + (v.x * 7919.0).sin().powi(8)))),
    ];
    for (name, mesh) in cases {
        let share = hidden_share(name, &mesh, &Placement::IDENTITY, 25, 6);
        match name {
            "cancelled" => assert_eq!(Occluders::of(&mesh).balls(), [], "its winding number is 0 everywhere"),
            "crossing" | "inside out" | "twice the same" => assert!(share > 0.1, "{name}: {share}"),
            _ => {}
        }
    }
}

#[test]
fn an_open_mesh_hides_nothing() {
    let ball = shape("uv-sphere:32:16");
    let open = Mesh::new(ball.positions().to_vec(), ball.triangles()[1..].to_vec()).unwrap();
    assert_eq!(Occluders::of(&open).balls(), []);
    assert_eq!(Occluders::of(&shape("plane:8")).balls(), []);
    let mut positions = ball.positions().to_vec();
    positions[9][1] = f32::NAN;
    assert_eq!(Occluders::of(&Mesh::new(positions, ball.triangles().to_vec()).unwrap()).balls(), []);
}

#[test]
fn nothing_is_hidden_where_a_clip_plane_may_cut() {
    let mesh = shape("uv-sphere:32:16");
    let occluders = Occluders::of(&mesh);
    let (bounds, _) = Bounds::from_points(mesh.positions().iter().copied());
    let shadows = |z: f64| {
        let mut camera = Camera::new();
        camera.set_position(DVec3::new(0.0, 0.0, z)).unwrap();
        occluders.shadows(&camera, &Placement::IDENTITY, &bounds, SIZE).is_some()
    };
    assert!(shadows(2.1) && shadows(900.0));
    assert!(!shadows(1.9), "the near plane at 1 touches the box");
    assert!(!shadows(0.0), "inside");
    assert!(!shadows(999.5), "the far plane at 1000 touches the box");
    assert!(!shadows(-20.0), "behind the camera");
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(60))]

    /// Anywhere, turned, squeezed and mirrored, and of any size.
    #[test]
    fn no_placement_changes_a_pixel(
        seed in 1_u64..,
        scale in prop::array::uniform3(-3.0..3.0_f64),
        turn in prop::array::uniform4(-1.0..1.0_f64),
        place in prop::array::uniform3(-1e4..1e4_f64),
        bumps in 0.0..0.3_f64,
    ) {
        let mesh = moved(&shape("uv-sphere:48:24"), |v| v * (1.0 + bumps * (v.x * 9.0).sin() * (v.y * 7.0).sin()));
        let placement = Placement {
            translation: DVec3::from_array(place),
            rotation: DQuat::from_array(turn).normalize(),
            scale: DVec3::from_array(scale.map(|s| s.signum() * 10_f64.powf(s.abs() - 1.5))),
        };
        hidden_share("placed", &mesh, &placement, 4, seed);
    }
}
