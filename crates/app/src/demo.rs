//! The built-in scene: what `polosa` draws when it is not told what.
//!
//! ```text
//!      icosahedron          torus, leaning           cone
//!                 sphere             cylinder
//!        TEAPOT, on a chequered floor, in perspective
//!          pyramid    tetrahedron      cube, in wire
//! ```

use std::path::{Path, PathBuf};

use polosa_math::glam::{DQuat, DVec3};
use polosa_math::{Placement, axis_angle};
use polosa_scene::{
    Camera, Color, Colors, FieldOfView, Light, LightSpace, Mesh, Object, Picture, PictureSettings,
    Projection, Renderer, Samples, Shape, Show, Style, World,
};

use crate::encode::{ImageFormat, save_picture};
use crate::error::Error;
use crate::output::Destination;

/// Where the picture goes, in the current folder.
pub const FILE: &str = "polosa.png";

/// The colour behind it.
pub(crate) const BACKGROUND: Color = Color::new(0x16, 0x1b, 0x22);

/// Draws the scene and writes it to `path` as PNG; the absolute path.
///
/// # Errors
///
/// When it cannot be written.
pub fn write(path: &Path) -> Result<PathBuf, Error> {
    let destination = Destination::File(path.to_owned());
    save_picture(&destination, ImageFormat::Png, || picture(1280, 720, Samples::Sixteen))?;
    Ok(std::path::absolute(path).unwrap_or_else(|_| path.to_owned()))
}

/// The picture of the scene.
///
/// # Errors
///
/// When a side is 0 or more than 16,384 pixels.
pub fn picture(width: u32, height: u32, samples: Samples) -> Result<Picture, Error> {
    let failed = |what: String| Error::file(FILE, what);
    let world = world().map_err(|error| failed(error.to_string()))?;
    let camera = camera(width, height).map_err(|error| failed(error.to_string()))?;
    let light = light();
    let style = Style { edge_color: Color::new(0x10, 0x18, 0x20), ..Style::default() };
    let settings = PictureSettings {
        width,
        height,
        background: Some(BACKGROUND),
        samples,
        ..PictureSettings::default()
    };
    Picture::render(&mut Renderer::new(), &world, &camera, &light, &style, &settings)
        .map_err(|error| failed(error.to_string()))
}

/// The light on it.
pub(crate) fn light() -> Light {
    Light { direction: DVec3::new(-0.6, 1.0, 0.75), space: LightSpace::World, ambient: 0.16 }
}

/// How it is looked at.
pub(crate) fn camera(width: u32, height: u32) -> Result<Camera, polosa_scene::CameraError> {
    let mut camera = Camera::new();
    camera.set_projection(Projection::Perspective {
        fov: FieldOfView::Vertical(29_f64.to_radians()),
        near: 0.1,
        far: f64::INFINITY,
    })?;
    camera.set_aspect(f64::from(width) / f64::from(height.max(1)))?;
    camera.set_position(DVec3::new(3.2, 3.9, 10.6))?;
    camera.look_at(DVec3::new(0.1, 0.55, -0.4))?;
    Ok(camera)
}

/// The objects, farther ones first.
pub(crate) fn world() -> Result<World, Box<dyn std::error::Error>> {
    let mut world = World::new();
    let floor = world.add_mesh(floor()?);
    world.add(Object::new(floor))?;

    let mut put = |shape: &str, color: Option<u32>, show: Show, placement: Placement| {
        let mesh = world.add_mesh(shape.parse::<Shape>()?.mesh()?);
        let mut object = Object::new(mesh).placed(placement).shown(show);
        object.color = color.map(Color::from_u32);
        world.add(object)?;
        Ok::<(), Box<dyn std::error::Error>>(())
    };
    let surface = Show::Surface;
    put(
        "torus:96:48",
        Some(0xd9_8032),
        surface,
        place([0.6, 1.23, -3.4], turn([1.0, 0.25, 0.0], 68.0), 0.95),
    )?;
    put(
        "icosahedron",
        Some(0x5c_b8a4),
        Show::Both,
        place([-4.0, 0.88, -2.2], turn([0.3, 1.0, 0.1], 25.0), 1.05),
    )?;
    put("cone:72", Some(0xc9_4f5b), surface, place([3.9, 1.1, -2.3], DQuat::IDENTITY, 1.1))?;
    put("sphere:icosahedron:5", Some(0x4a_7fc1), surface, place([-2.3, 0.9, -0.2], DQuat::IDENTITY, 0.9))?;
    put("cylinder:72", Some(0x8a_6fb5), surface, place([2.9, 0.62, 0.3], DQuat::IDENTITY, 0.62))?;
    put("teapot:16", Some(0xe8_e0d0), surface, place([0.35, 1.0, 0.35], turn([0.0, 1.0, 0.0], -25.0), 1.0))?;
    put("pyramid", Some(0xd8_b444), Show::Both, place([-2.5, 0.51, 2.2], turn([0.0, 1.0, 0.0], 30.0), 0.5))?;
    put("seed-tetrahedron", None, surface, place([-0.6, 0.46, 3.3], turn([0.0, 1.0, 0.0], -24.0), 0.0045))?;
    put("cube", None, Show::Wire, place([2.0, 0.46, 2.9], turn([0.0, 1.0, 0.0], 20.0), 0.42))?;
    Ok(world)
}

fn place([x, y, z]: [f64; 3], rotation: DQuat, size: f64) -> Placement {
    Placement { translation: DVec3::new(x, y, z), rotation, scale: DVec3::splat(size) }
}

/// A turn about an axis, in degrees.
fn turn(axis: [f64; 3], degrees: f64) -> DQuat {
    axis_angle(DVec3::from_array(axis), degrees.to_radians()).unwrap_or(DQuat::IDENTITY)
}

/// A chequered square of 14 by 14 fields of one unit, its top at height 0.
fn floor() -> Result<Mesh, polosa_scene::MeshError> {
    const FIELDS: u32 = 14;
    let side = FIELDS + 1;
    let half = FIELDS as f32 / 2.0;
    let positions =
        (0..side * side).map(|i| [(i % side) as f32 - half, 0.0, (i / side) as f32 - half]).collect();
    let mut triangles = Vec::new();
    let mut colors = Vec::new();
    for (z, x) in (0..FIELDS).flat_map(|z| (0..FIELDS).map(move |x| (z, x))) {
        let a = z * side + x;
        let (b, c, d) = (a + side, a + side + 1, a + 1);
        triangles.extend([[a, b, c], [a, c, d]]);
        let color = if (x + z) % 2 == 0 { 0x6b_7480 } else { 0x3c_444e };
        colors.extend([Color::from_u32(color); 2]);
    }
    Mesh::new(positions, triangles)?.with_colors(Colors::Face(colors))
}
