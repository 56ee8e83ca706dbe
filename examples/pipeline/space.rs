//! Clipping, depth, perspective and edges: small scenes, drawn.

use std::error::Error;

use polosa_examples::picture;
use polosa_math::glam::DVec3;
use polosa_math::{Placement, axis_angle};
use polosa_raster::{Clip, Depth, DepthTest, Fragment, PerTriangle, State, Target, transform};
use polosa_scene::{
    Camera, Color, FieldOfView, Light, Object, Picture, PictureSettings, Projection, Renderer, Samples, Show,
    Style, World, shape,
};

use crate::kit::{BLUE, Canvas, FAINT, GREEN, INK, ORANGE, PAPER, RED, between};

const PAPER_COLOR: Color = Color::from_u32(PAPER);

/// Left: a triangle that crosses the near plane, from the side. Right: a floor that does, as it is drawn.
pub(crate) fn clip() -> Result<Picture, Box<dyn Error>> {
    let mut canvas = Canvas::new(800, 300);
    // The diagram: the eye on the left, the near plane at x = 150, what is visible to the right of it.
    let (eye, near) = ([30.0, 150.0], 150.0);
    for y in [20.0, 280.0] {
        canvas.line(eye, between(eye, [400.0, y], 1.0), 1.5, FAINT)?;
    }
    canvas.line([near, 20.0], [near, 280.0], 2.5, INK)?;
    let corners = [[85.0, 225.0], [340.0, 195.0], [260.0, 75.0]];
    canvas.outline(&corners, 1.5, FAINT)?;
    let cut = |inside: [f32; 2], outside: [f32; 2]| {
        between(inside, outside, (inside[0] - near) / (inside[0] - outside[0]))
    };
    let (low, high) = (cut(corners[1], corners[0]), cut(corners[2], corners[0]));
    canvas.polygon(&[low, corners[1], corners[2]], ORANGE)?;
    canvas.polygon(&[low, corners[2], high], 0x8f_b8dc)?;
    canvas.outline(&[low, corners[1], corners[2], high], 2.0, INK)?;
    // From the inside end to the outside one, on both sides.
    for (inside, at) in [(corners[1], low), (corners[2], high)] {
        canvas.arrow(between(inside, at, 0.35), between(inside, at, 0.93), 3.0, RED)?;
    }
    canvas.dot(eye, 6.0, INK)?;
    canvas.ring(corners[0], 6.0, RED, PAPER)?;
    for point in [corners[1], corners[2]] {
        canvas.dot(point, 6.0, INK)?;
    }
    for point in [low, high] {
        canvas.ring(point, 6.0, BLUE, PAPER)?;
    }

    // The floor: two triangles that reach from behind the eye to far away, near plane five units off.
    let mut camera = Camera::new();
    let fov = FieldOfView::Vertical(60_f64.to_radians());
    camera.set_projection(Projection::Perspective { fov, near: 5.0, far: f64::INFINITY })?;
    camera.set_position(DVec3::new(0.0, 3.0, 0.0))?;
    camera.look_at(DVec3::new(0.0, 1.6, -8.0))?;
    let floor = [[-6.0, 0.0, 4.0], [6.0, 0.0, 4.0], [6.0, 0.0, -40.0], [-6.0, 0.0, -40.0]];
    let mut vertices = [[0.0; 4]; 4];
    transform(&camera.clip_from_model(&Placement::IDENTITY), &floor, &mut vertices);
    let (width, height) = (380, 285);
    let mut color = vec![0xe9_eef2; width * height];
    let mut target = Target::new(&mut color, Depth::None, width as u32, height as u32, width)?;
    let shades = [0x8f_b8dc, 0xf0_b46a];
    let stats = target.triangles(
        &State::default(),
        &vertices,
        &[[0, 1, 2], [0, 2, 3]],
        &PerTriangle(|index: usize| shades[index]),
    );
    assert_eq!((stats.drawn, stats.clipped), (2, 2), "both are cut, both are drawn");
    canvas.paste([412, 8], &picture(width as u32, height as u32, color), 1);
    Ok(canvas.finish())
}

/// A ring that a twenty-sided solid pierces, and their depth.
pub(crate) fn depth() -> Result<Picture, Box<dyn Error>> {
    let mut world = World::new();
    let ring = world.add_mesh(shape::torus(96, 48)?);
    let solid = world.add_mesh(shape::icosahedron());
    let turn = axis_angle(DVec3::new(1.0, 0.2, 0.3), 0.9).ok_or("an axis has a length")?;
    let at = DVec3::new(0.75, -0.15, 0.3);
    let leaning = Placement { translation: DVec3::ZERO, rotation: turn, scale: DVec3::splat(1.25) };
    world.add(Object::new(ring).placed(leaning).colored(Color::new(217, 128, 50)))?;
    let small = Placement { translation: at, scale: DVec3::splat(0.75), ..Placement::IDENTITY };
    world.add(Object::new(solid).placed(small).colored(Color::new(74, 127, 193)))?;
    let mut camera = Camera::new();
    frame(&mut camera, &world, DVec3::new(0.3, 0.4, 1.0))?;
    let settings = PictureSettings {
        width: 400,
        height: 300,
        background: Some(PAPER_COLOR),
        samples: Samples::Sixteen,
        distances: true,
        ..PictureSettings::default()
    };
    let (light, style) = (Light::default(), Style::default());
    let drawn = Picture::render(&mut Renderer::new(), &world, &camera, &light, &style, &settings)?;

    let distances = drawn.distances.as_deref().ok_or("they were asked for")?;
    let seen = || distances.iter().copied().filter(|d| d.is_finite());
    let (nearest, farthest) = (seen().fold(f32::INFINITY, f32::min), seen().fold(0.0, f32::max));
    assert!(nearest < farthest);
    let grey = distances.iter().map(|&d| {
        if d.is_infinite() {
            return PAPER;
        }
        let code = (235.0 - 200.0 * (d - nearest) / (farthest - nearest)) as u8;
        Color::new(code, code, code).to_u32()
    });
    let mut canvas = Canvas::new(800, 300);
    canvas.paste([400, 0], &picture(400, 300, grey.collect()), 1);
    canvas.paste([0, 0], &drawn, 1);
    Ok(canvas.finish())
}

/// A chequered floor of two triangles: with weights that are linear on the screen, and with perspective.
pub(crate) fn weights() -> Result<Picture, Box<dyn Error>> {
    let mut canvas = Canvas::new(800, 250);
    let corners: [Clip; 4] =
        [[-0.95, -0.9, 0.5, 1.0], [0.95, -0.9, 0.5, 1.0], [0.95, 2.4, 0.5, 3.0], [-0.95, 2.4, 0.5, 3.0]];
    // The same places on the screen without perspective: w is 1.
    let flat = corners.map(|[x, y, z, w]| [x / w, y / w, z / w, 1.0]);
    let triangles = [[0, 1, 2], [0, 2, 3]];
    let texture = [[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]];
    for (number, vertices) in [flat, corners].iter().enumerate() {
        let mut color = vec![PAPER; 390 * 250];
        let mut target = Target::new(&mut color, Depth::None, 390, 250, 390)?;
        let chequer = |fragment: &Fragment<'_>, pixel: &mut u32| {
            let [a, b, c] = fragment.weights();
            let at = triangles[fragment.triangle()].map(|k: u32| texture[k as usize]);
            let [u, v] = [0, 1].map(|k| (a * at[0][k] + b * at[1][k] + c * at[2][k]) * 8.0);
            *pixel = if (u as u32 + v as u32).is_multiple_of(2) { 0xf0_b46a } else { 0x5a_4632 };
            true
        };
        assert_eq!(target.triangles(&State::default(), vertices, &triangles, &chequer).drawn, 2);
        canvas.paste([number as u32 * 410, 0], &picture(390, 250, color), 1);
    }
    Ok(canvas.finish())
}

/// Edges over the surface they outline: by the depth test alone, and with the rule of [`Target::edges`].
pub(crate) fn edges() -> Result<Picture, Box<dyn Error>> {
    const ZOOM: u32 = 4;
    let (width, height) = (98, 74);
    let mut world = World::new();
    let mesh = world.add_mesh(shape::torus(20, 10)?);
    let key = world.add(Object::new(mesh).colored(Color::from_u32(ORANGE)))?;
    let mut camera = Camera::new();
    camera.set_aspect(f64::from(width) / f64::from(height))?;
    frame(&mut camera, &world, DVec3::new(0.4, 0.95, 1.0))?;
    let style = Style { edge_color: Color::from_u32(INK), ..Style::default() };
    let light = Light::default();

    let mut canvas = Canvas::new(800, 300);
    let mut counts = [0; 2];
    for (number, show) in [Show::Surface, Show::Both].into_iter().enumerate() {
        world.show(key, show)?;
        let mut color = vec![0; (width * height) as usize];
        let mut depth = vec![0.0; color.len()];
        let mut target = Target::new(&mut color, Depth::F32(&mut depth), width, height, width as usize)?;
        target.clear(PAPER, DepthTest::Greater);
        Renderer::new().draw(&world, &camera, &light, &style, &mut target);
        if show == Show::Surface {
            let mesh = world.mesh(mesh).ok_or("it was added")?;
            let mut vertices = vec![[0.0; 4]; mesh.positions().len()];
            transform(&camera.clip_from_model(&Placement::IDENTITY), mesh.positions(), &mut vertices);
            target.lines(&State::default(), &vertices, &mesh.edges(), INK);
        }
        counts[number] = color.iter().filter(|&&pixel| pixel == INK).count();
        canvas.paste([number as u32 * 408, 2], &picture(width, height, color), ZOOM);
    }
    assert!(counts[0] < counts[1], "by depth alone, edges lose pixels to their own faces: {counts:?}");
    canvas.line([400.0, 0.0], [400.0, 300.0], 2.0, GREEN)?;
    Ok(canvas.finish())
}

/// Fits everything that the world shows into the picture, through a lens that does not distort much.
fn frame(camera: &mut Camera, world: &World, to_eye: DVec3) -> Result<(), Box<dyn Error>> {
    let fov = FieldOfView::Vertical(30_f64.to_radians());
    camera.set_projection(Projection::Perspective { fov, near: 1.0, far: f64::INFINITY })?;
    let faces = world.objects().filter_map(|(key, _)| world.faces(key)).flatten();
    Ok(camera.frame_points(faces.flatten(), to_eye, DVec3::Y, 0.04)?)
}
