//! A picture without a window, in ten lines.
#![expect(clippy::print_stdout, reason = "says where the picture is")]

use polosa::Application;
use polosa::math::glam::DVec3;
use polosa::scene::{Color, Object, Samples, shape};

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let mut app = Application::new();
    let torus = app.world.add_mesh(shape::torus(96, 48)?);
    app.world.add(Object::new(torus).colored(Color::new(0xd9, 0x80, 0x32)))?;
    app.settings.samples = Samples::Sixteen;
    app.camera.set_position(DVec3::new(0.0, 1.8, 1.8))?;
    app.camera.look_at(DVec3::ZERO)?;
    let picture = app.picture()?;
    assert_eq!(picture.stats.triangles.submitted, 2 * 96 * 48);
    println!("{}", polosa_examples::save("headless.png", &picture)?.display());
    Ok(())
}
