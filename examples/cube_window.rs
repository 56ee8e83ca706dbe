//! A turning cube in a window, in ten lines. Drag to look around; Esc ends it.
use polosa::Application;
use polosa::math::{axis_angle, glam::DVec3};
use polosa::scene::{Color, Object, shape};

fn main() -> Result<std::process::ExitCode, Box<dyn std::error::Error>> {
    let mut app = Application::new();
    let mesh = app.world.add_mesh(shape::cube());
    let cube = app.world.add(Object::new(mesh).colored(Color::new(0xd9, 0x80, 0x32)))?;
    app.camera.set_position(DVec3::new(2.0, 2.0, 4.0))?;
    app.camera.look_at(DVec3::ZERO)?;
    let turning = move |app: &mut Application, step: std::time::Duration| {
        let turn = axis_angle(DVec3::Y, step.as_secs_f64());
        turn.and_then(|turn| app.world.turn(cube, turn).ok());
    };
    // With a window alone: `app.run(&mut turning)?`.
    Ok(polosa_examples::run(app, turning, ""))
}
