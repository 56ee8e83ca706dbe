//! All standard shapes on one sheet, with their edges, in the order of `SHEET`.
#![expect(clippy::print_stdout, reason = "says where the picture is")]

use std::error::Error;

use polosa_examples::{picture, save};
use polosa_math::glam::DVec3;
use polosa_scene::{
    Camera, Color, Colors, FieldOfView, Light, Object, Picture, PictureSettings, Projection, Renderer,
    Samples, Shape, Show, Style, World,
};

/// Row by row. The levels are low, so that the edges can be told apart.
const SHEET: [[&str; 4]; 4] = [
    ["tetrahedron", "cube", "octahedron", "icosahedron"],
    ["sphere:tetrahedron:3", "sphere:cube:3", "sphere:octahedron:3", "sphere:icosahedron:2"],
    ["uv-sphere:24:12", "torus:24:12", "cylinder:24", "cone:24"],
    ["teapot:4", "pyramid", "plane:6", "seed-tetrahedron"],
];
const COLORS: [u32; 4] = [0xd9_8032, 0x4a_7fc1, 0x5c_b8a4, 0xe0_d8c8];
const WIDTH: usize = 200;
const HEIGHT: usize = 150;

fn main() -> Result<(), Box<dyn Error>> {
    let names = SHEET.as_flattened();
    let is_shown = |name: &str| names.iter().any(|text| text.split(':').next() == Some(name));
    assert!(Shape::all().iter().all(|info| is_shown(info.name)), "every shape has its place");
    let columns = SHEET[0].len() * WIDTH;
    let mut sheet = vec![0; columns * SHEET.len() * HEIGHT];
    for (number, name) in names.iter().enumerate() {
        let (row, column) = (number / SHEET[0].len(), number % SHEET[0].len());
        for (y, line) in draw(name.parse()?, COLORS[row])?.pixels.chunks(WIDTH).enumerate() {
            let at = (row * HEIGHT + y) * columns + column * WIDTH;
            sheet[at..at + WIDTH].copy_from_slice(line);
        }
    }
    let sheet = picture(columns as u32, (SHEET.len() * HEIGHT) as u32, sheet);
    println!("{}", save("shapes.png", &sheet)?.display());
    Ok(())
}

fn draw(shape: Shape, color: u32) -> Result<Picture, Box<dyn Error>> {
    let (width, height, samples) = (WIDTH as u32, HEIGHT as u32, Samples::Four);
    let settings = PictureSettings { width, height, samples, ..PictureSettings::default() };
    let mut world = World::new();
    let mesh = shape.mesh()?;
    let own = *mesh.colors() != Colors::None;
    let object = Object::new(world.add_mesh(mesh)).shown(Show::Both);
    let key = world.add(if own { object } else { object.colored(Color::from_u32(color)) })?;
    let mut camera = Camera::new();
    let fov = FieldOfView::Vertical(28_f64.to_radians());
    camera.set_projection(Projection::Perspective { fov, near: 1.0, far: f64::INFINITY })?;
    let corners = world.faces(key).ok_or("it is there")?.flatten();
    camera.frame_points(corners, DVec3::new(0.5, 0.55, 1.0), DVec3::Y, 0.08)?;
    let style = Style { edge_color: Color::new(20, 24, 28), ..Style::default() };
    let picture =
        Picture::render(&mut Renderer::new(), &world, &camera, &Light::default(), &style, &settings)?;
    assert_eq!(picture.stats.triangles.submitted, shape.triangle_count()?);
    Ok(picture)
}
