//! From the world to a pixel and back: where an object is seen, and which object is seen at a pixel.
#![expect(clippy::print_stdout, reason = "says what was found")]

use std::error::Error;

use polosa_math::glam::DVec3;
use polosa_scene::{Camera, Object, ObjectKey, Ray, World, shape};

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
        let (picked, distance) = pick(&world, &ray).ok_or("the ray meets something")?;
        println!("{name}: at ({:.2}, {:.2}), {distance:.3} units away", seen.x, seen.y);

        assert!(picked == object || object == far, "what is near hides what is far");
        let off = (on_it - ray.origin).cross(ray.direction).length();
        assert!(off < 1e-9, "the ray goes through the point that was projected, not {off} beside it");
    }
    let corner = camera.pick_ray([0.5, 0.5], WIDTH, HEIGHT).ok_or("a pixel of the picture")?;
    assert!(pick(&world, &corner).is_none(), "nothing in the corner");
    Ok(())
}

/// The nearest object that a ray meets, and how far away.
fn pick(world: &World, ray: &Ray) -> Option<(ObjectKey, f64)> {
    let hits = world.objects().flat_map(|(key, _)| {
        let faces = world.faces(key).into_iter().flatten();
        faces.filter_map(move |face| Some((key, distance(ray, face)?)))
    });
    hits.min_by(|a, b| a.1.total_cmp(&b.1))
}

/// How far along a ray a triangle lies, if they meet (Möller and Trumbore, 1997).
fn distance(ray: &Ray, [a, b, c]: [DVec3; 3]) -> Option<f64> {
    let (ab, ac, to) = (b - a, c - a, ray.origin - a);
    let (p, q) = (ray.direction.cross(ac), to.cross(ab));
    let d = ab.dot(p);
    let (u, v, t) = (to.dot(p) / d, ray.direction.dot(q) / d, ac.dot(q) / d);
    (u >= 0.0 && v >= 0.0 && u + v <= 1.0 && t > 0.0).then_some(t)
}
