//! A golden-image test: draws, and compares with the picture that is kept beside this file. A picture is the same bytes
//! on every machine, so nothing is let pass. After a change on purpose keep the new one:
//! `cargo run --example golden -- --headless examples/golden.png`.
#![expect(clippy::print_stdout, reason = "says what was found")]

use std::error::Error;
use std::path::Path;

use polosa::compare::{Image, Settings, compare};
use polosa::decode::Decoded;
use polosa_examples::save;
use polosa_math::glam::DVec3;
use polosa_scene::{
    Camera, Color, Light, Object, Picture, PictureSettings, Renderer, Samples, Show, Style, World, shape,
};

pub(crate) fn draw(color: Color) -> Result<Picture, Box<dyn Error>> {
    let mut world = World::new();
    let teapot = world.add_mesh(shape::teapot(8)?);
    let teapot = world.add(Object::new(teapot).colored(color).shown(Show::Both))?;
    let mut camera = Camera::new();
    let corners = world.faces(teapot).into_iter().flatten().flatten();
    camera.frame_points(corners, DVec3::new(0.4, 0.5, 1.0), DVec3::Y, 0.05)?;
    let samples = Samples::Four;
    let settings = PictureSettings { width: 240, height: 180, samples, ..PictureSettings::default() };
    let (light, style) = (Light::default(), Style::default());
    Ok(Picture::render(&mut Renderer::new(), &world, &camera, &light, &style, &settings)?)
}

fn main() -> Result<(), Box<dyn Error>> {
    let drawn = draw(Color::new(0x5c, 0xb8, 0xa4))?;
    let path = save("golden.png", &drawn)?;
    let kept = Decoded::load(&Path::new(env!("CARGO_MANIFEST_DIR")).join("golden.png"))?;
    let difference = compare(&Image::of(&drawn)?, &kept.image()?, &Settings::default())?;
    if !difference.same {
        let (pixels, most) = (difference.differing, difference.max_difference);
        return Err(format!("{}: {pixels} pixels differ, by up to {most}", path.display()).into());
    }

    // And a test that passes for anything is none: another colour by one code is found.
    let other = draw(Color::new(0x5c, 0xb8, 0xa5))?;
    let difference = compare(&Image::of(&other)?, &kept.image()?, &Settings::default())?;
    assert!(!difference.same && difference.max_difference <= 1.0);
    println!("{}: as it is kept; of another blue, {} pixels differ", path.display(), difference.differing);
    Ok(())
}
