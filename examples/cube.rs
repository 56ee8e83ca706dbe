//! A turning cube in wire, one frame of it: the first demonstration of a camera in many a tutorial.
#![expect(clippy::print_stdout, reason = "says where the picture is")]

use std::error::Error;
use std::f64::consts::PI;

use polosa_examples::save;
use polosa_math::axis_angle;
use polosa_math::glam::DVec3;
use polosa_scene::{
    Camera, Color, Light, Object, Picture, PictureSettings, Renderer, Show, Style, World, shape,
};

fn main() -> Result<(), Box<dyn Error>> {
    let mut world = World::new();
    let mesh = world.add_mesh(shape::cube());
    let cube = world.add(Object::new(mesh).colored(Color::WHITE).shown(Show::Wire))?;

    // The camera stands at (0, 0, 10) and looks along −Z until it is told otherwise; 70° from left to right.
    let mut camera = Camera::new();
    camera.set_position(DVec3::new(3.0, 4.0, 8.0))?;
    camera.look_at(DVec3::ZERO)?;

    // An eighth of a second after the start, at half a turn a second.
    let by = axis_angle(DVec3::Y, -PI / 8.0).ok_or("an axis has a length")?;
    world.turn(cube, by)?;

    let settings = PictureSettings {
        width: 400,
        height: 300,
        background: Some(Color::BLACK),
        ..PictureSettings::default()
    };
    let (light, style) = (Light::default(), Style::default());
    let picture = Picture::render(&mut Renderer::new(), &world, &camera, &light, &style, &settings)?;

    // All twelve edges, none of the faces' diagonals; each corner is where the camera says.
    assert_eq!(picture.stats.lines.drawn, 12);
    for [end, _] in world.edges(cube).ok_or("the cube is there")? {
        let seen = camera.project_point(end, 400, 300).ok_or("every corner is in view")?;
        let near = |x: i64, y: i64| picture.pixels[(y * 400 + x) as usize] == 0xff_ffff;
        let (x, y) = (seen.x as i64, seen.y as i64);
        assert!((-1..=1).any(|dy| (-1..=1).any(|dx| near(x + dx, y + dy))), "a corner at {seen:?}");
    }
    println!("{}", save("cube.png", &picture)?.display());
    Ok(())
}
