//! What a ray meets first, against what the faces in the world's coordinates say one by one.

use polosa_math::glam::{DQuat, DVec3};
use polosa_math::{Placement, normalized};
use polosa_scene::{Camera, Mesh, Object, ObjectKey, Ray, Show, World, shape};
use proptest::prelude::*;

/// The nearest face that a ray meets, and how far away it is (Möller and Trumbore, 1997).
fn oracle(world: &World, ray: &Ray) -> Option<(ObjectKey, usize, f64)> {
    let mut nearest = None;
    for (key, _) in world.objects().filter(|(_, object)| object.visible && object.show != Show::Wire) {
        for (number, [a, b, c]) in world.faces(key).into_iter().flatten().enumerate() {
            let (ab, ac, to) = (b - a, c - a, ray.origin - a);
            let (p, q) = (ray.direction.cross(ac), to.cross(ab));
            let d = ab.dot(p);
            let (u, v, t) = (to.dot(p) / d, ray.direction.dot(q) / d, ac.dot(q) / d);
            let met = u >= 0.0 && v >= 0.0 && u + v <= 1.0 && t > 0.0;
            if met && nearest.is_none_or(|(_, _, distance)| t < distance) {
                nearest = Some((key, number, t));
            }
        }
    }
    nearest
}

fn placement() -> impl Strategy<Value = Placement> {
    let scale = prop_oneof![9 => 0.1..2.0_f64, 3 => -2.0..-0.1_f64, 1 => Just(0.0)];
    let vectors = (prop::array::uniform3(-4.0..4.0_f64), prop::array::uniform3(scale));
    (vectors, prop::array::uniform4(-1.0..1.0_f64)).prop_map(|((place, scale), turn)| Placement {
        translation: DVec3::from_array(place),
        rotation: normalized(DQuat::from_array(turn)),
        scale: DVec3::from_array(scale),
    })
}

fn object() -> impl Strategy<Value = (usize, Placement, Show, bool)> {
    let show = prop_oneof![4 => Just(Show::Surface), 1 => Just(Show::Both), 1 => Just(Show::Wire)];
    (0..4_usize, placement(), show, proptest::bool::weighted(0.9))
}

fn meshes() -> [Mesh; 4] {
    [shape::cube(), shape::torus(16, 8).unwrap(), shape::plane(3).unwrap(), shape::icosahedron()]
}

proptest! {
    #[test]
    fn the_nearest_face_of_all_is_met(
        objects in prop::collection::vec(object(), 0..6),
        from in prop::array::uniform3(-6.0..6.0_f64),
        to in prop::array::uniform3(-3.0..3.0_f64),
    ) {
        let mut world = World::new();
        let meshes = meshes().map(|mesh| world.add_mesh(mesh));
        for (mesh, placement, show, visible) in objects {
            let mut object = Object::new(meshes[mesh]).placed(placement).shown(show);
            object.visible = visible;
            world.add(object).unwrap();
        }
        let origin = DVec3::from_array(from);
        let Some(direction) = polosa_math::unit(DVec3::from_array(to) - origin) else { return Ok(()) };
        let ray = Ray { origin, direction };
        match (world.pick(&ray), oracle(&world, &ray)) {
            (None, None) => {}
            (Some(hit), Some((_, _, distance))) => {
                // Two faces within rounding of each other may be taken for one another.
                prop_assert!((hit.distance - distance).abs() <= 1e-9, "{hit:?} instead of {distance}");
                prop_assert!((hit.point - (origin + direction * distance)).length() <= 1e-9);
                let face = world.faces(hit.object).unwrap().nth(hit.triangle).unwrap();
                let normal = (face[1] - face[0]).cross(face[2] - face[0]);
                prop_assert!(normal.dot(hit.point - face[0]).abs() <= 1e-9, "the point is on that very face");
            }
            (hit, oracle) => prop_assert!(false, "{hit:?}, but {oracle:?}"),
        }
    }

    /// A closed surface from inside: there is no way out between two triangles, least of all through a corner.
    #[test]
    fn no_ray_slips_through_between_two_triangles(triangle in 0..80_usize, side in 0..3_usize, share in 0.0..=1.0_f64) {
        let mut world = World::new();
        let mesh = world.add_mesh(shape::sphere(shape::Solid::Icosahedron, 1).unwrap());
        let key = world.add(Object::new(mesh)).unwrap();
        let corners = world.faces(key).unwrap().nth(triangle % 80).unwrap();
        let on_edge = corners[side] * share + corners[(side + 1) % 3] * (1.0 - share);
        for direction in [on_edge, corners[side]] {
            let ray = Ray { origin: DVec3::new(0.01, 0.02, -0.03), direction };
            prop_assert!(world.pick(&ray).is_some());
            let ray = Ray { origin: DVec3::ZERO, direction };
            prop_assert!(world.pick(&ray).is_some());
        }
    }
}

#[test]
fn of_two_surfaces_in_one_place_the_first_is_met_as_it_is_the_one_that_is_seen() {
    let mut world = World::new();
    let mesh = world.add_mesh(shape::cube());
    let first = world.add(Object::new(mesh)).unwrap();
    let second = world.add(Object::new(mesh)).unwrap();
    let ray = Ray { origin: DVec3::new(0.1, 0.2, 9.0), direction: DVec3::NEG_Z };
    assert_eq!(world.pick(&ray).unwrap().object, first);
    world.get_mut(first).unwrap().visible = false;
    assert_eq!(world.pick(&ray).unwrap().object, second);
    assert_eq!(world.pick(&ray).unwrap().distance, 8.0);
}

#[test]
fn what_is_not_finite_meets_nothing_and_hides_nothing() {
    let mut world = World::new();
    let cube = world.add_mesh(shape::cube());
    let (nan, inf) = (f32::NAN, f32::INFINITY);
    let bad = vec![[nan; 3], [-1.0, -1.0, 5.0], [1.0, -1.0, 5.0], [0.0, inf, 5.0], [0.0, 1.0, -inf]];
    let bad = Mesh::new(bad, vec![[0, 1, 2], [1, 2, 3], [1, 2, 4], [1, 1, 2], [0, 0, 0]]).unwrap();
    let bad = world.add_mesh(bad);
    world.add(Object::new(bad)).unwrap();
    for value in [f64::NAN, f64::INFINITY, 1e308, -1e-308, 0.0] {
        let placement = Placement {
            translation: DVec3::splat(value),
            rotation: DQuat::from_array([value; 4]),
            scale: DVec3::splat(value),
        };
        world.add(Object::new(cube).placed(placement)).unwrap();
    }
    let object = world.add(Object::new(cube)).unwrap();
    let ray = Ray { origin: DVec3::new(0.1, 0.0, 9.0), direction: DVec3::NEG_Z };
    // The cube squashed to a point at the origin, and those beyond all numbers, are in nobody's way.
    let hit = world.pick(&ray).unwrap();
    assert_eq!((hit.object, hit.distance), (object, 8.0));
    for value in [f64::NAN, f64::INFINITY, 0.0] {
        assert_eq!(world.pick(&Ray { direction: DVec3::splat(value), ..ray }), None);
        if value != 0.0 {
            assert_eq!(world.pick(&Ray { origin: DVec3::splat(value), ..ray }), None);
        }
    }
}

#[test]
fn far_from_the_origin_it_is_as_exact_as_there() {
    let mut world = World::new();
    let mesh = world.add_mesh(shape::torus(48, 24).unwrap());
    let away = DVec3::new(1e7, -1e7, 1e7);
    let key = world.add(Object::new(mesh).at(away)).unwrap();
    let mut camera = Camera::new();
    camera.frame(&world.bounds(), DVec3::new(1.0, 2.0, 1.5), DVec3::Y, 0.05).unwrap();
    let mut at_origin = world.clone();
    at_origin.move_by(key, -away).unwrap();
    for (x, y) in (0..32).flat_map(|y| (0..40).map(move |x| (f64::from(x) * 10.0, f64::from(y) * 10.0))) {
        let ray = camera.pick_ray([x, y], 400, 300).unwrap();
        let near = Ray { origin: ray.origin - away, ..ray };
        let [far, near] = [world.pick(&ray), at_origin.pick(&near)];
        assert_eq!(far.map(|hit| (hit.triangle, hit.distance)), near.map(|hit| (hit.triangle, hit.distance)));
    }
}
