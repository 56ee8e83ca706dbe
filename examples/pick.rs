//! From the world to a pixel and back: where an object is seen, and which object is seen at a pixel.
#![expect(clippy::print_stdout, reason = "says what was found")]

use std::error::Error;

use polosa_math::glam::DVec3;
use polosa_scene::{Camera, Object, World, shape};

const WIDTH: u32 = 640;
const HEIGHT: u32 = 480;

fn main() -> Result<(), Box<dyn Error>> {
    let mut world = World::new();
    let mesh = world.add_mesh(shape::torus(48, 24)?);
    let near = world.add(Object::new(mesh).at(DVec3::new(0.0, 0.0, 2.0)))?;
    let far = world.add(Object::new(mesh).at(DVec3::new(0.8, 0.0, -2.0)))?;

    let mut camera = Camera::new();
    camera.set_position(DVec3::new(0.0, 3.0, 10.0))?;
    camera.look_at(DVec3::ZERO)?;

    for (object, name) in [(near, "near"), (far, "far")] {
        // A point on the ring, nearest to the camera: halfway through the tube, seen from the middle of the hole.
        let on_it = world.center(object).ok_or("it is there")? + DVec3::new(0.0, 0.25, 0.7);
        let seen = camera.project_point(on_it, WIDTH, HEIGHT).ok_or("in view")?;
        let ray = camera.pick_ray([seen.x, seen.y], WIDTH, HEIGHT).ok_or("a pixel of the picture")?;
        let hit = world.pick(&ray).ok_or("the ray meets something")?;
        println!("{name}: at ({:.2}, {:.2}), {:.3} units away", seen.x, seen.y, hit.distance);

        assert!(hit.object == object || object == far, "what is near hides what is far");
        let off = (on_it - ray.origin).cross(ray.direction).length();
        assert!(off < 1e-9, "the ray goes through the point that was projected, not {off} beside it");
    }
    let corner = camera.pick_ray([0.5, 0.5], WIDTH, HEIGHT).ok_or("a pixel of the picture")?;
    assert!(world.pick(&corner).is_none(), "nothing in the corner");
    Ok(())
}
