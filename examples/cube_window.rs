//! A turning cube in a window, in ten lines. Drag to look around; Esc ends it.
use polosa::Application;
use polosa::math::{axis_angle, glam::DVec3};
use polosa::scene::{Object, shape};

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let mut app = Application::new();
    let mesh = app.world.add_mesh(shape::cube());
    let cube = app.world.add(Object::new(mesh))?;
    app.run(&mut move |app: &mut Application, step: std::time::Duration| {
        let turn = axis_angle(DVec3::Y, step.as_secs_f64());
        turn.and_then(|turn| app.world.turn(cube, turn).ok());
    })?;
    Ok(())
}
