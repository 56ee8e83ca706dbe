//! What the drawing of a world promises, looked at in finished pictures.

use polosa_math::Placement;
use polosa_math::glam::DVec3;
use polosa_raster::{Cull, TargetError};
use polosa_scene::{
    Camera, Color, Colors, Light, LightSpace, Mesh, Object, Picture, PictureSettings, Projection, Renderer,
    Samples, Shading, Shape, Show, Style, World,
};

const BACKGROUND: u32 = 0x2b2b2b;

/// A camera with one world unit to a pixel, the world's origin in the middle of the picture.
fn pixel_camera(size: u32) -> Camera {
    let mut camera = Camera::new();
    camera.set_aspect(1.0).unwrap();
    camera.set_position(DVec3::new(0.0, 0.0, 500.0)).unwrap();
    let height = f64::from(size);
    camera.set_projection(Projection::Orthographic { height, near: 1.0, far: 1000.0 }).unwrap();
    camera
}

/// A square around the origin in the plane z = 0, turned towards +Z.
fn square(side: f32) -> Mesh {
    let h = side / 2.0;
    let corners = vec![[-h, -h, 0.0], [h, -h, 0.0], [h, h, 0.0], [-h, h, 0.0]];
    Mesh::new(corners, vec![[0, 1, 2], [0, 2, 3]])
        .and_then(|mesh| mesh.with_edges(vec![[0, 1], [1, 2], [2, 3], [3, 0]]))
        .unwrap()
}

struct Scene {
    world: World,
    camera: Camera,
    light: Light,
    style: Style,
    settings: PictureSettings,
}

impl Scene {
    fn new(size: u32) -> Self {
        Self {
            world: World::new(),
            camera: pixel_camera(size),
            light: Light::default(),
            style: Style::default(),
            settings: PictureSettings { width: size, height: size, ..PictureSettings::default() },
        }
    }

    fn with(mut self, mesh: Mesh, object: impl FnOnce(Object) -> Object) -> Self {
        let key = self.world.add_mesh(mesh);
        self.world.add(object(Object::new(key))).unwrap();
        self
    }

    fn render(&self) -> Picture {
        let mut renderer = Renderer::new();
        Picture::render(&mut renderer, &self.world, &self.camera, &self.light, &self.style, &self.settings)
            .unwrap()
    }
}

fn at(picture: &Picture, x: u32, y: u32) -> usize {
    (y * picture.width + x) as usize
}

#[test]
fn colours_are_written_unchanged_when_unlit() {
    let codes = [0x000001, 0x010203, 0x7f8081, 0xfefdfc, 0xffffff];
    for code in codes {
        let color = Color::from_u32(code);
        let plain = square(8.0);
        let face = square(8.0).with_colors(Colors::Face(vec![color; 2])).unwrap();
        let vertex = square(8.0).with_colors(Colors::Vertex(vec![color; 4])).unwrap();
        for (mesh, own) in [(plain, Some(color)), (face, None), (vertex, None)] {
            let mut scene =
                Scene::new(8).with(mesh, |object| own.map_or(object, |color| object.colored(color)));
            scene.style.shading = Shading::Unlit;
            assert_eq!(scene.render().pixels, [code; 64]);
        }
    }
}

#[test]
fn an_objects_colour_goes_before_its_meshs_and_those_before_the_styles() {
    let red = square(8.0).with_colors(Colors::Face(vec![Color::from_u32(0xff0000); 2])).unwrap();
    for (mesh, own, expected) in
        [(red.clone(), Some(Color::WHITE), 0xffffff), (red, None, 0xff0000), (square(8.0), None, 0x00ff00)]
    {
        let mut scene = Scene::new(8).with(mesh, |object| own.map_or(object, |color| object.colored(color)));
        scene.style = Style { shading: Shading::Unlit, color: Color::from_u32(0x00ff00), ..scene.style };
        assert_eq!(scene.render().pixels[0], expected);
    }
}

/// The shade of a square turned away from the light by an angle, in the curve as the standard prints it.
fn expected(code: u8, cosine: f64, ambient: f64) -> f64 {
    let c = f64::from(code) / 255.0;
    let linear = if c <= 0.04045 { c / 12.92 } else { ((c + 0.055) / 1.055).powf(2.4) };
    let light = linear * (ambient + (1.0 - ambient) * cosine.max(0.0));
    255.0 * if light <= 0.003_130_8 { 12.92 * light } else { 1.055 * light.powf(1.0 / 2.4) - 0.055 }
}

#[test]
fn flat_shading_is_lamberts_cosine_in_linear_light_on_both_sides() {
    for degrees in (0..=180).step_by(5) {
        let angle = f64::from(degrees).to_radians();
        let turn = polosa_math::axis_angle(DVec3::Y, angle).unwrap();
        let color = Color::new(200, 100, 30);
        let mut scene = Scene::new(16)
            .with(square(200.0), |object| object.colored(color).placed(Placement::IDENTITY.turned(turn)));
        if degrees == 90 {
            continue; // seen edge on: nothing
        }
        scene.light.direction = DVec3::new(0.0, 3.0, 4.0);
        let Color { r, g, b } = Color::from_u32(scene.render().pixels[at(&scene.render(), 8, 8)]);
        let cosine = angle.cos().abs() * 0.8;
        for (code, got) in [(200, r), (100, g), (30, b)] {
            let exact = expected(code, cosine, 0.1);
            assert!((f64::from(got) - exact).abs() <= 0.5 + 1e-3, "{degrees}°: {got}, not {exact}");
        }
    }
}

#[test]
fn a_light_is_fixed_to_the_camera_or_to_the_world() {
    let sphere = || "sphere:4".parse::<Shape>().unwrap().mesh().unwrap();
    let render = |space, eye: DVec3| {
        let mut scene = Scene::new(32).with(sphere(), |object| object);
        scene.light = Light { direction: DVec3::X, space, ambient: 0.0 };
        scene.camera.frame(&scene.world.bounds(), eye, DVec3::Y, 0.05).unwrap();
        scene.render()
    };
    let bright = |picture: &Picture, x| picture.pixels[at(picture, x, 16)] & 0xff;
    for eye in [DVec3::Z, DVec3::NEG_Z] {
        let fixed = render(LightSpace::Camera, eye);
        assert!(bright(&fixed, 26) > 150 && bright(&fixed, 5) == 0);
    }
    assert!(bright(&render(LightSpace::World, DVec3::Z), 26) > 150);
    assert!(bright(&render(LightSpace::World, DVec3::NEG_Z), 26) == 0);
}

#[test]
fn a_grey_gradient_is_blended_in_linear_light() {
    let ends = [Color::BLACK, Color::WHITE];
    let mesh = square(64.0).with_colors(Colors::Vertex(vec![ends[0], ends[1], ends[1], ends[0]])).unwrap();
    let mut scene = Scene::new(64).with(mesh, |object| object);
    scene.style.shading = Shading::Unlit;
    let picture = scene.render();
    for x in 0..64 {
        let light = (f64::from(x) + 0.5) / 64.0;
        let exact =
            255.0 * if light <= 0.003_130_8 { 12.92 * light } else { 1.055 * light.powf(1.0 / 2.4) - 0.055 };
        let got = f64::from(picture.pixels[at(&picture, x, 20)] & 0xff);
        assert!((got - exact).abs() < 0.51, "column {x}: {got}, not {exact}");
    }
}

#[test]
fn samples_average_coverage_in_linear_light() {
    // A square that ends in the middle of a column of pixels: half of 4 and of 16 samples.
    let mut scene = Scene::new(8).with(square(5.0), |object| object.colored(Color::WHITE));
    scene.style.shading = Shading::Unlit;
    scene.settings.background = Some(Color::BLACK);
    for samples in [Samples::Four, Samples::Sixteen] {
        scene.settings.samples = samples;
        let picture = scene.render();
        let row: Vec<_> = (0..8).map(|x| picture.pixels[at(&picture, x, 4)]).collect();
        let half = 0xbcbcbc; // half the light, not half the code
        assert_eq!(row, [0, half, 0xffffff, 0xffffff, 0xffffff, 0xffffff, half, 0]);
    }
}

#[test]
fn without_a_background_alpha_is_coverage_and_colours_are_straight() {
    let mut scene = Scene::new(8).with(square(5.0), |object| object.colored(Color::from_u32(0x123456)));
    scene.style.shading = Shading::Unlit;
    scene.settings.background = None;
    for (samples, edge) in [(Samples::One, None), (Samples::Four, Some(128))] {
        scene.settings.samples = samples;
        let picture = scene.render();
        let alpha = picture.alpha.as_ref().unwrap();
        assert_eq!((alpha[0], picture.pixels[0]), (0, 0));
        assert_eq!((alpha[at(&picture, 4, 4)], picture.pixels[at(&picture, 4, 4)]), (255, 0x123456));
        if let Some(edge) = edge {
            let at = at(&picture, 1, 4);
            assert_eq!((alpha[at], picture.pixels[at]), (edge, 0x123456));
        }
    }
}

#[test]
fn distances_and_numbers_are_those_of_the_nearest_triangle() {
    let mut scene = Scene::new(8)
        .with(square(4.0), |object| object.at(DVec3::new(0.0, 0.0, 100.0)))
        .with(square(8.0), |object| object);
    scene.settings = PictureSettings { distances: true, ids: true, ..scene.settings };
    for samples in [Samples::One, Samples::Four] {
        scene.settings.samples = samples;
        let picture = scene.render();
        let (distances, ids) = (picture.distances.as_ref().unwrap(), picture.ids.as_ref().unwrap());
        for (x, y, distance, id) in [(3, 5, 400.0, 1), (4, 2, 400.0, 2), (2, 7, 500.0, 3), (0, 0, 500.0, 4)] {
            let at = at(&picture, x, y);
            assert!((distances[at] - distance).abs() < 1e-3, "{} at {x}, {y}", distances[at]);
            if x != y {
                assert_eq!(ids[at], id, "at {x}, {y}");
            }
        }
    }
    scene.world.clear();
    let picture = scene.render();
    assert!(picture.distances.unwrap().iter().all(|d| *d == f32::INFINITY));
    assert!(picture.ids.unwrap().iter().all(|id| *id == 0));
}

#[test]
fn of_two_objects_in_one_place_the_first_that_was_added_is_seen() {
    let red = Color::from_u32(0xff0000);
    let mut scene =
        Scene::new(8).with(square(8.0), |object| object.colored(red)).with(square(8.0), |object| object);
    scene.style.shading = Shading::Unlit;
    assert_eq!(scene.render().pixels, [0xff0000; 64]);
}

#[test]
fn wire_surface_and_both_show_what_they_say() {
    let seen = |show, visible| {
        let mut scene = Scene::new(16).with(square(9.0), |mut object| {
            object.visible = visible;
            object.shown(show)
        });
        scene.style = Style { shading: Shading::Unlit, ..scene.style };
        let picture = scene.render();
        let count = |color: Color| picture.pixels.iter().filter(|&&p| p == color.to_u32()).count();
        (count(scene.style.color), count(scene.style.edge_color), picture.stats)
    };
    // 9 by 9 pixels; their sides run along half the pixels' width, so that edges take 36 pixels around them.
    let (surface, none, stats) = seen(Show::Surface, true);
    assert_eq!((surface, none, stats.triangles.drawn, stats.lines.drawn), (81, 0, 2, 0));
    let (wire, none, stats) = seen(Show::Wire, true);
    assert_eq!((wire, none, stats.triangles.drawn, stats.lines.drawn), (36, 0, 0, 4));
    let (surface, edges, stats) = seen(Show::Both, true);
    assert_eq!((edges, stats.triangles.drawn, stats.lines.drawn), (36, 2, 4));
    assert!((49..81).contains(&surface));
    assert_eq!(seen(Show::Both, false).0, 0);
}

#[test]
fn culling_leaves_out_the_side_it_names() {
    for (cull, front, back) in
        [(Cull::None, true, true), (Cull::Back, true, false), (Cull::Front, false, true)]
    {
        for (eye, seen) in [(DVec3::Z, front), (DVec3::NEG_Z, back)] {
            let mut scene = Scene::new(8).with(square(8.0), |object| object);
            scene.camera.frame(&scene.world.bounds(), eye, DVec3::Y, 0.0).unwrap();
            scene.style.cull = cull;
            assert_eq!(
                scene.render().pixels[at(&scene.render(), 4, 4)] != BACKGROUND,
                seen,
                "{cull:?} {eye}"
            );
        }
    }
}

#[test]
fn ten_million_units_away_the_picture_is_the_same() {
    let render = |offset: DVec3| {
        let mesh = "torus:24:12".parse::<Shape>().unwrap().mesh().unwrap();
        let mut scene = Scene::new(64).with(mesh, |object| object.at(offset).shown(Show::Both));
        scene.camera.set_projection(Camera::new().projection()).unwrap();
        scene.camera.set_position(offset + DVec3::new(2.0, 1.5, 3.0)).unwrap();
        scene.camera.set_direction(DVec3::new(-2.0, -1.5, -3.0)).unwrap();
        scene.render().pixels
    };
    let near = render(DVec3::ZERO);
    assert!(near.iter().any(|&p| p != BACKGROUND));
    for offset in [DVec3::new(1e7, -1e7, 1e7), DVec3::new(0.0, 3e9, 0.0)] {
        assert!(render(offset) == near, "{offset}");
    }
}

#[test]
fn a_picture_of_many_bands_is_the_picture() {
    // 3000 × 3000 pixels take three bands; its middle is the picture of the middle.
    let shape = || "teapot:3".parse::<Shape>().unwrap().mesh().unwrap();
    let scene = |size: u32| {
        let mut scene = Scene::new(size).with(shape(), |object| object.shown(Show::Both));
        let height = f64::from(size) / 1000.0;
        scene.camera.set_projection(Projection::Orthographic { height, near: 1.0, far: 1000.0 }).unwrap();
        scene.settings = PictureSettings { distances: true, ids: true, ..scene.settings };
        scene.render()
    };
    let (large, small) = (scene(3000), scene(1000));
    for y in 0..1000 {
        let (from, to) = (at(&large, 1000, 1000 + y), at(&small, 0, y));
        assert!(large.pixels[from..from + 1000] == small.pixels[to..to + 1000], "row {y}");
        let ids = [large.ids.as_ref().unwrap(), small.ids.as_ref().unwrap()];
        assert!(ids[0][from..from + 1000] == ids[1][to..to + 1000], "row {y}");
    }
}

#[test]
fn sizes_out_of_range_are_refused_before_anything_is_allocated() {
    for (width, height) in [(0, 1), (1, 0), (16_385, 1), (1, u32::MAX)] {
        let scene = Scene::new(8);
        let settings = PictureSettings { width, height, ..scene.settings };
        let result = Picture::render(
            &mut Renderer::new(),
            &scene.world,
            &scene.camera,
            &scene.light,
            &scene.style,
            &settings,
        );
        assert_eq!(result, Err(TargetError::Size { width, height }));
    }
}

#[test]
fn a_mesh_of_nonsense_draws_what_can_be_drawn() {
    let nan = f32::NAN;
    let corners = vec![[-4.0, -4.0, 0.0], [4.0, -4.0, 0.0], [4.0, 4.0, 0.0], [nan, 0.0, 0.0], [f32::MAX; 3]];
    let mesh = Mesh::new(corners, vec![[0, 1, 2], [0, 1, 3], [0, 1, 4], [0, 0, 1]]).unwrap();
    for show in [Show::Surface, Show::Wire, Show::Both] {
        let stats = Scene::new(8).with(mesh.clone(), |object| object.shown(show)).render().stats;
        if show != Show::Wire {
            assert_eq!(stats.triangles.submitted, 4);
            assert!(stats.triangles.not_finite >= 1 && stats.triangles.degenerate >= 1, "{stats:?}");
        }
    }
}

/// The faces at a hub are not all looked at for each pixel of each spoke: that took minutes.
#[test]
fn the_hub_of_ten_thousand_faces_is_outlined_in_no_time() {
    let rim = (0..10_000).map(|k| f64::from(k) * core::f64::consts::TAU / 10_000.0);
    let corners = rim.map(|angle| [60.0 * angle.cos() as f32, 60.0 * angle.sin() as f32, 0.0]);
    let corners: Vec<_> = [[0.0, 0.0, 20.0]].into_iter().chain(corners).collect();
    let triangles = (1..=10_000).map(|k| [0, k, k % 10_000 + 1]).collect();
    let mut scene =
        Scene::new(128).with(Mesh::new(corners, triangles).unwrap(), |object| object.shown(Show::Both));
    scene.style.edge_color = Color::from_u32(0xff0000);
    let (began, picture) = (std::time::Instant::now(), scene.render());
    assert_eq!(picture.stats.lines.drawn, 20_000);
    assert_eq!(picture.pixels[at(&picture, 64 + 50, 64)], 0xff0000);
    assert!(began.elapsed().as_secs() < 20, "{:?}", began.elapsed());
}
