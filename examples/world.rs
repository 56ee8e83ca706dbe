//! A small animation: objects are created, moved, turned, recoloured and removed between the frames.
#![expect(clippy::print_stdout, reason = "says where the pictures are")]

use std::error::Error;

use polosa_examples::save;
use polosa_math::axis_angle;
use polosa_math::glam::DVec3;
use polosa_scene::{
    Camera, Color, Light, Object, Picture, PictureSettings, Renderer, Show, Style, World, shape,
};

fn main() -> Result<(), Box<dyn Error>> {
    let mut world = World::new();
    // One mesh, many objects.
    let cube = world.add_mesh(shape::cube());
    let ball = world.add_mesh(shape::sphere(shape::Solid::Icosahedron, 1)?);
    let left =
        world.add(Object::new(cube).at(DVec3::new(-2.5, 0.0, 0.0)).colored(Color::new(220, 80, 60)))?;
    let right =
        world.add(Object::new(cube).at(DVec3::new(2.5, 0.0, 0.0)).colored(Color::new(70, 130, 200)))?;

    let settings = PictureSettings { width: 320, height: 180, ..PictureSettings::default() };
    let mut camera = Camera::new();
    camera.set_aspect(16.0 / 9.0)?;
    camera.set_position(DVec3::new(0.0, 3.0, 7.0))?;
    camera.look_at(DVec3::ZERO)?;
    let (light, style, mut renderer) = (Light::default(), Style::default(), Renderer::new());

    let quarter = axis_angle(DVec3::new(1.0, 1.0, 0.0), 0.25).ok_or("an axis has a length")?;
    let mut middle = None;
    let mut frames = Vec::new();
    for number in 0..12 {
        world.turn(left, quarter)?; // about its own centre
        world.turn_about(right, quarter, DVec3::ZERO)?; // about any point
        match number {
            3 => middle = Some(world.add(Object::new(ball).shown(Show::Both))?),
            5 => world.recolor(left, Some(Color::new(90, 170, 90)))?,
            7 => world.move_by(right, DVec3::new(0.0, 0.0, -2.0))?,
            9 => drop(middle.and_then(|key| world.remove(key))),
            _ => {}
        }
        let frame = Picture::render(&mut renderer, &world, &camera, &light, &style, &settings)?;
        assert_eq!(frame.stats.objects, if (3..9).contains(&number) { 3 } else { 2 });
        save(&format!("world-{number:02}.png"), &frame)?;
        frames.push(frame);
    }

    assert!(frames.windows(2).all(|pair| pair[0] != pair[1]), "something moves in every frame");
    let gone = middle.ok_or("it was added")?;
    assert!(world.get(gone).is_none(), "a handle of what was removed names nothing");
    assert!(world.recolor(gone, None).is_err(), "and changing it is an error, not a panic");
    println!("{} frames, the last in {}", frames.len(), save("world-11.png", &frames[11])?.display());
    Ok(())
}
