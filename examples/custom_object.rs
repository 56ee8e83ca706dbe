//! An object of your own from points, edges and triangles: the pyramid OABCD.
#![expect(clippy::print_stdout, reason = "says where the picture is")]

use std::error::Error;

use polosa_examples::save;
use polosa_math::glam::DVec3;
use polosa_scene::topology::Topology;
use polosa_scene::{
    Camera, Color, FieldOfView, Light, Object, Picture, PictureSettings, Projection, Renderer, Samples, Show,
    Style, World, shape,
};

fn main() -> Result<(), Box<dyn Error>> {
    //            O
    //           /|\            Five points, eight edges, five faces. The base takes two triangles;
    //          / | \           its diagonal A–C is no edge, and is not drawn.
    //        D/--|--\C
    //        /   |   \
    //       A---------B
    let points =
        vec![[0.0, 1.5, 0.0], [-1.0, 0.0, 1.0], [1.0, 0.0, 1.0], [1.0, 0.0, -1.0], [-1.0, 0.0, -1.0]];
    let [o, a, b, c, d] = [0, 1, 2, 3, 4];
    let edges = vec![[o, a], [o, b], [o, c], [o, d], [a, b], [b, c], [c, d], [d, a]];
    // Counter-clockwise as seen from outside.
    let triangles = vec![[o, a, b], [o, b, c], [o, c, d], [o, d, a], [a, d, c], [a, c, b]];
    let pyramid = shape::from_points(points, edges, triangles)?;

    let topology = Topology::of(&pyramid);
    assert!(topology.closed_outward(), "watertight, and no face is inside out");

    // What does not fit together is refused, with the place of the fault.
    let error = shape::from_points(vec![[0.0; 3]; 3], vec![], vec![[0, 1, 3]]).unwrap_err();
    assert_eq!(error.to_string(), "triangle 0 names vertex 3, but there are only 3");

    let mut world = World::new();
    let mesh = world.add_mesh(pyramid);
    let object = world.add(Object::new(mesh).colored(Color::new(216, 180, 68)).shown(Show::Both))?;
    assert_eq!(world.edges(object).map(|edges| edges.len()), Some(8));
    assert_eq!(world.faces(object).map(|faces| faces.len()), Some(6));

    let settings =
        PictureSettings { width: 400, height: 300, samples: Samples::Sixteen, ..PictureSettings::default() };
    let mut camera = Camera::new();
    let fov = FieldOfView::Vertical(30_f64.to_radians());
    camera.set_projection(Projection::Perspective { fov, near: 0.1, far: f64::INFINITY })?;
    camera.frame(&world.bounds(), DVec3::new(0.5, -0.6, 1.0), DVec3::Y, 0.05)?; // from below: the base shows
    let (light, style) = (Light::default(), Style::default());
    let picture = Picture::render(&mut Renderer::new(), &world, &camera, &light, &style, &settings)?;
    println!("{}", save("custom_object.png", &picture)?.display());
    Ok(())
}
