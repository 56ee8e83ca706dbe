//! Pictures of worlds by methods for comparison.

use polosa_math::Placement;
use polosa_math::glam::DVec3;
use polosa_raster::TargetError;
use polosa_raster::reference::{Coverage, Hidden};
use polosa_scene::reference::{Methods, Shading};
use polosa_scene::{
    Camera, Color, Light, Object, Picture, PictureSettings, Renderer, Show, Style, World, shape,
};

const SIZE: [u32; 2] = [200, 150];

/// A cube in front of a torus and of a tetrahedron with colours of its own, one wire and one that is not shown.
fn scene() -> (World, Camera) {
    let mut world = World::new();
    let at = |x: f64, y: f64, z: f64| Placement { translation: DVec3::new(x, y, z), ..Placement::IDENTITY };
    let meshes = [shape::torus(24, 12).unwrap(), shape::cube(), shape::seed_tetrahedron(1).unwrap()]
        .map(|mesh| world.add_mesh(mesh));
    let mut add = |mesh, change: &dyn Fn(&mut Object)| {
        let mut object = Object::new(mesh);
        change(&mut object);
        world.add(object).unwrap();
    };
    add(meshes[0], &|torus| torus.placement = at(0.3, 0.0, 0.0));
    add(meshes[1], &|cube| {
        cube.placement = at(1.2, 0.2, 1.0);
        cube.color = Some(Color::new(200, 90, 30));
    });
    add(meshes[2], &|_| {});
    add(meshes[1], &|wire| wire.show = Show::Wire);
    add(meshes[1], &|unseen| unseen.visible = false);
    let mut camera = Camera::new();
    camera.set_aspect(f64::from(SIZE[0]) / f64::from(SIZE[1])).unwrap();
    camera.frame(&world.bounds(), DVec3::new(1.0, 0.6, 0.4), DVec3::Y, 0.05).unwrap();
    (world, camera)
}

fn by(methods: Methods) -> Picture {
    let (world, camera) = scene();
    methods.picture(&world, &camera, &Light::default(), &Style::default(), SIZE, Color::WHITE).unwrap()
}

/// Pixels that are not background.
fn drawn(pixels: &[u32]) -> usize {
    pixels.iter().filter(|pixel| **pixel != 0xff_ffff).count()
}

#[test]
fn by_default_it_is_the_exact_picture() {
    let (mut world, camera) = scene();
    let wires: Vec<_> =
        world.objects().filter(|(_, object)| object.show == Show::Wire).map(|(id, _)| id).collect();
    for wire in wires {
        world.remove(wire);
    }
    let settings = PictureSettings {
        width: SIZE[0],
        height: SIZE[1],
        background: Some(Color::WHITE),
        ..Default::default()
    };
    let exact = Picture::render(
        &mut Renderer::new(),
        &world,
        &camera,
        &Light::default(),
        &Style::default(),
        &settings,
    )
    .unwrap();
    assert_eq!(by(Methods::default()), exact);
    assert!(exact.pixels.iter().any(|pixel| *pixel != 0xff_ffff));
}

#[test]
fn each_part_can_be_chosen_and_changes_the_picture() {
    let exact = by(Methods::default()).pixels;
    let differing = |methods| by(methods).pixels.iter().zip(&exact).filter(|(a, b)| a != b).count();
    let drawn = drawn(&exact);
    assert!(differing(Methods { coverage: Coverage::WholePixels, ..Methods::default() }) > drawn / 50);
    assert!(differing(Methods { hidden: Hidden::Order, ..Methods::default() }) > drawn / 50);
    // All but what is in full light or in none.
    assert!(differing(Methods { shading: Shading::Naive, ..Methods::default() }) > drawn / 2);
    assert_eq!(differing(Methods { coverage: Coverage::Edges, ..Methods::default() }), 0);
}

#[test]
fn every_pair_draws_what_the_exact_one_does_but_for_edges() {
    let exact = drawn(&by(Methods::default()).pixels);
    assert!(exact > 4_000, "{exact}");
    for &coverage in Coverage::ALL {
        for &hidden in Hidden::ALL {
            let drawn = drawn(&by(Methods { coverage, hidden, ..Methods::default() }).pixels);
            assert!(drawn.abs_diff(exact) < exact / 10, "{coverage} {hidden}: {drawn}, not about {exact}");
        }
    }
}

#[test]
fn impossible_sizes_are_refused_before_memory_is_taken() {
    let (world, camera) = scene();
    for size in [[0, 5], [5, 0], [16_385, 1], [u32::MAX, u32::MAX]] {
        let (light, style) = (Light::default(), Style::default());
        let refused = Methods::default().picture(&world, &camera, &light, &style, size, Color::BLACK);
        assert!(matches!(refused, Err(TargetError::Size { .. })), "{size:?}");
    }
}
