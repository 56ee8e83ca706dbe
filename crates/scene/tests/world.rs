//! What the world's documentation says, as claims.

use polosa_math::glam::{DMat3, DMat4, DQuat, DVec3};
use polosa_math::{Bounds, Placement, axis_angle};
use polosa_scene::{Color, Mesh, Object, ObjectKey, Show, World, WorldError, shape};
use proptest::prelude::*;

fn turn_of(axis: DVec3, angle: f64) -> DQuat {
    axis_angle(axis, angle).unwrap()
}

fn with_cube() -> (World, ObjectKey) {
    let mut world = World::new();
    let cube = world.add_mesh(shape::cube());
    let key = world.add(Object::new(cube)).unwrap();
    (world, key)
}

#[test]
fn objects_share_a_mesh_that_is_stored_once() {
    let mut world = World::new();
    let cube = world.add_mesh(shape::cube());
    for i in 0..100 {
        world.add(Object::new(cube).at(DVec3::X * f64::from(i))).unwrap();
    }
    assert_eq!((world.meshes().count(), world.objects().len()), (1, 100));
    let old = world.replace_mesh(cube, shape::pyramid()).unwrap();
    assert_eq!(old, shape::cube());
    assert!(world.objects().all(|(key, _)| world.edges(key).unwrap().len() == 8));
}

#[test]
fn a_mesh_in_use_is_not_removed_and_an_unused_one_is() {
    let (mut world, key) = with_cube();
    let cube = world.get(key).unwrap().mesh();
    assert_eq!(world.remove_mesh(cube), Err(WorldError::MeshInUse { objects: 1 }));
    assert!(world.remove(key).is_some());
    assert_eq!(world.remove_mesh(cube), Ok(shape::cube()));
    assert_eq!(world.remove_mesh(cube), Err(WorldError::NoMesh));
    assert_eq!(world.add(Object::new(cube)), Err(WorldError::NoMesh));
}

#[test]
fn stale_handles_name_nothing_even_when_their_place_is_used_again() {
    let (mut world, old) = with_cube();
    let cube = world.get(old).unwrap().mesh();
    let removed = world.remove(old).unwrap();
    let new = world.add(removed).unwrap();
    assert_ne!(old, new);
    assert!(world.remove(old).is_none() && world.get(old).is_none() && world.get_mut(old).is_none());
    assert!(world.edges(old).is_none() && world.faces(old).is_none());
    assert!(world.object_bounds(old).is_none() && world.center(old).is_none());
    assert!(world.placement(old).is_none() && world.order(old).is_none());
    let by = turn_of(DVec3::Y, 1.0);
    for result in [
        world.move_by(old, DVec3::X),
        world.move_to(old, DVec3::X),
        world.turn(old, by),
        world.turn_about(old, by, DVec3::ONE),
        world.scale(old, DVec3::splat(2.0)),
        world.recolor(old, Some(Color::WHITE)),
        world.show(old, Show::Wire),
        world.set_placement(old, Placement::at(DVec3::X)),
        world.set_mesh(old, cube),
    ] {
        assert_eq!(result, Err(WorldError::NoObject));
    }
    assert_eq!(world.get(new), Some(&removed), "nothing of it reached the object in its place");
    world.clear();
    assert!(world.get(new).is_none() && world.mesh(cube).is_none() && world.mesh_bounds(cube).is_none());
    assert_eq!(world.replace_mesh(cube, shape::cube()), Err(WorldError::NoMesh));
    assert_eq!(world.set_mesh(new, cube), Err(WorldError::NoMesh));
}

#[test]
fn operations_change_what_they_say() {
    let (mut world, key) = with_cube();
    world.move_by(key, DVec3::new(1.0, 2.0, 3.0)).unwrap();
    let expected = Bounds::new(DVec3::new(0.0, 1.0, 2.0), DVec3::new(2.0, 3.0, 4.0));
    assert_eq!(world.object_bounds(key), Some(expected));
    world.scale(key, DVec3::new(2.0, 1.0, 0.5)).unwrap();
    assert_eq!(world.center(key), Some(DVec3::new(1.0, 2.0, 3.0)));
    assert_eq!(world.object_bounds(key).unwrap().size(), DVec3::new(4.0, 2.0, 1.0));
    world.move_to(key, DVec3::ZERO).unwrap();
    world.recolor(key, Some(Color::WHITE)).unwrap();
    world.show(key, Show::Both).unwrap();
    let object = world.get(key).unwrap();
    assert_eq!((object.color, object.show, object.visible), (Some(Color::WHITE), Show::Both, true));

    // The whole transform, read, changed as a matrix, and assigned.
    let matrix = DMat4::from_translation(DVec3::Z) * world.placement(key).unwrap().matrix();
    world.set_placement(key, Placement::from_matrix(&matrix).unwrap()).unwrap();
    assert_eq!(world.center(key), Some(DVec3::Z));
    world.get_mut(key).unwrap().visible = false;
    assert!(world.bounds().is_empty());
    world.recolor(key, None).unwrap();
    assert_eq!(world.get(key).unwrap().color, None);
    for (_, object) in world.objects_mut() {
        object.visible = true;
    }
    assert!(!world.bounds().is_empty());
}

#[test]
fn an_object_turns_about_its_own_centre_though_its_origin_is_elsewhere() {
    let mut world = World::new();
    let away = Mesh::new(vec![[10.0, 0.0, 0.0], [12.0, 0.0, 0.0], [10.0, 2.0, 0.0]], vec![[0, 1, 2]]);
    let mesh = world.add_mesh(away.unwrap());
    let key = world.add(Object::new(mesh)).unwrap();
    assert_eq!(world.center(key), Some(DVec3::new(11.0, 1.0, 0.0)));
    world.turn(key, turn_of(DVec3::Z, std::f64::consts::FRAC_PI_2)).unwrap();
    let corners = world.faces(key).unwrap().next().unwrap();
    for (corner, expected) in corners.into_iter().zip([[12.0, 0.0, 0.0], [12.0, 2.0, 0.0], [10.0, 0.0, 0.0]])
    {
        assert!((corner - DVec3::from_array(expected)).length() < 1e-14, "{corner}");
    }
}

#[test]
fn another_revision_tells_of_every_change_and_of_nothing_else() {
    let (mut world, key) = with_cube();
    let mesh = world.get(key).unwrap().mesh();
    let other = world.add_mesh(shape::cube());
    let mut last = world.revision();
    let copy = world.clone();
    assert_eq!(copy.revision(), last, "the same content");
    let mut changed = |world: &World, what: &str| {
        assert_ne!(world.revision(), last, "{what}");
        last = world.revision();
    };
    world.move_by(key, DVec3::X).unwrap();
    changed(&world, "moved");
    world.recolor(key, Some(Color::WHITE)).unwrap();
    changed(&world, "recoloured");
    world.get_mut(key).unwrap().visible = false;
    changed(&world, "hidden");
    world.objects_mut().for_each(|(_, object)| object.visible = true);
    changed(&world, "shown");
    world.set_mesh(key, other).unwrap();
    changed(&world, "another mesh");
    world.replace_mesh(other, shape::tetrahedron()).unwrap();
    changed(&world, "a replaced mesh");
    world.remove_mesh(mesh).unwrap();
    changed(&world, "a mesh less");
    let second = world.add(Object::new(other)).unwrap();
    changed(&world, "an object more");
    world.remove(second).unwrap();
    changed(&world, "an object less");
    let now = world.revision();
    let _ = (world.bounds(), world.objects().count());
    assert!(world.remove(second).is_none() && world.move_by(second, DVec3::X).is_err());
    assert_eq!(world.revision(), now, "looking, and what is refused, changes nothing");
    world.clear();
    assert!(![now, copy.revision()].contains(&world.revision()));
}

#[test]
fn a_million_turns_do_not_drift() {
    let mut world = World::new();
    let mesh = world.add_mesh(shape::teapot(2).unwrap());
    let key = world.add(Object::new(mesh).at(DVec3::new(5.0, -3.0, 2.0))).unwrap();
    let center = world.center(key).unwrap();
    let axis = DVec3::new(1.0, 2.0, 3.0);
    let step = turn_of(axis, 0.01);
    for _ in 0..1_000_000 {
        world.turn(key, step).unwrap();
    }
    let placement = world.placement(key).unwrap();
    let m = DMat3::from_quat(placement.rotation);
    let error = m * m.transpose() - DMat3::IDENTITY;
    let norm = error.to_cols_array().iter().map(|x| x * x).sum::<f64>().sqrt();
    assert!(norm < 1e-14, "{norm}");
    let moved = (world.center(key).unwrap() - center).length();
    assert!(moved < 1e-9, "{moved}");
    assert_eq!(placement.scale, DVec3::ONE);
    // And it is where one turn by the whole angle leads.
    let once = DMat3::from_quat(turn_of(axis, 0.01 * 1e6));
    let apart = (m * DVec3::X - once * DVec3::X).length();
    assert!(apart < 1e-8, "{apart}");
}

#[test]
fn edges_and_faces_are_in_world_coordinates() {
    let mut world = World::new();
    let pyramid = world.add_mesh(shape::pyramid());
    let key = world.add(Object::new(pyramid).at(DVec3::new(1e7, 0.0, 0.0))).unwrap();
    let edges: Vec<_> = world.edges(key).unwrap().collect();
    assert_eq!((edges.len(), world.faces(key).unwrap().count()), (8, 6));
    assert_eq!(edges[0], [DVec3::new(1e7, 1.0, 0.0), DVec3::new(1e7 - 1.0, -1.0, 1.0)]);
    // A mesh without edges of its own shows the sides of its triangles.
    let bare = Mesh::new(vec![[0.0; 3], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]], vec![[0, 1, 2]]).unwrap();
    let bare = world.add_mesh(bare);
    world.set_mesh(key, bare).unwrap();
    assert_eq!(world.edges(key).unwrap().len(), 3);
}

#[test]
fn hostile_numbers_do_no_harm() {
    let mut world = World::new();
    let mesh = Mesh::new(vec![[f32::NAN; 3], [f32::INFINITY, 0.0, 0.0]], vec![[0, 1, 1]]).unwrap();
    let mesh = world.add_mesh(mesh);
    assert!(world.mesh_bounds(mesh).unwrap().is_empty());
    let key = world.add(Object::new(mesh)).unwrap();
    assert_eq!(world.center(key), Some(DVec3::ZERO));
    for value in [f64::NAN, f64::INFINITY, 0.0, 1e308] {
        world.scale(key, DVec3::splat(value)).unwrap();
        world.turn(key, DQuat::from_xyzw(value, value, value, value)).unwrap();
        world.turn_about(key, DQuat::from_xyzw(0.0, 0.0, 0.0, 0.0), DVec3::splat(value)).unwrap();
        world.move_by(key, DVec3::splat(value)).unwrap();
        world.move_to(key, DVec3::splat(value)).unwrap();
        let _ = (world.bounds(), world.faces(key).unwrap().count(), world.edges(key).unwrap().count());
    }
    // One bad object takes no bounds from the others.
    let cube = world.add_mesh(shape::cube());
    world.add(Object::new(cube)).unwrap();
    assert_eq!(world.bounds(), Bounds::new(DVec3::NEG_ONE, DVec3::ONE));
}

#[derive(Clone, Debug)]
enum Step {
    Add,
    Remove(usize),
    Recolor(usize),
}

fn step() -> impl Strategy<Value = Step> {
    prop_oneof![
        3 => Just(Step::Add),
        2 => (0..50_usize).prop_map(Step::Remove),
        1 => (0..50_usize).prop_map(Step::Recolor),
    ]
}

proptest! {
    /// Against a plain list: whatever is removed in between, what stays is in the order of adding.
    #[test]
    fn objects_stay_in_the_order_of_adding(steps in proptest::collection::vec(step(), 0..120)) {
        let mut world = World::new();
        let mesh = world.add_mesh(shape::cube());
        let mut list = Vec::new();
        for step in steps {
            match step {
                Step::Add => list.push(world.add(Object::new(mesh)).unwrap()),
                Step::Remove(i) if !list.is_empty() => {
                    let key = list.remove(i % list.len());
                    prop_assert!(world.remove(key).is_some());
                    prop_assert!(world.remove(key).is_none());
                }
                Step::Recolor(i) if !list.is_empty() => {
                    world.recolor(list[i % list.len()], Some(Color::BLACK)).unwrap();
                }
                _ => {}
            }
            prop_assert_eq!(world.objects().map(|(key, _)| key).collect::<Vec<_>>(), list.clone());
        }
        let orders: Vec<_> = list.iter().map(|&key| world.order(key).unwrap()).collect();
        prop_assert!(orders.is_sorted_by(|a, b| a < b));
    }

    #[test]
    fn turning_about_a_point_keeps_the_distance_to_it(
        point in prop::array::uniform3(-1e3..1e3),
        place in prop::array::uniform3(-1e3..1e3),
        axis in prop::array::uniform3(0.1..1.0),
        angle in -10.0..10.0,
    ) {
        let (mut world, key) = with_cube();
        let (point, place) = (DVec3::from_array(point), DVec3::from_array(place));
        world.move_by(key, place).unwrap();
        let before: Vec<_> = world.faces(key).unwrap().flatten().map(|p| p.distance(point)).collect();
        world.turn_about(key, turn_of(DVec3::from_array(axis), angle), point).unwrap();
        for (p, distance) in world.faces(key).unwrap().flatten().zip(before) {
            prop_assert!((p.distance(point) - distance).abs() < 1e-11);
        }
    }

    /// The box of an object holds all of it, however it is turned.
    #[test]
    fn bounds_hold_the_object(
        axis in prop::array::uniform3(0.1..1.0),
        angle in -10.0..10.0,
        scale in prop::array::uniform3(-3.0..3.0),
    ) {
        let (mut world, key) = with_cube();
        world.scale(key, DVec3::from_array(scale)).unwrap();
        world.turn(key, turn_of(DVec3::from_array(axis), angle)).unwrap();
        let bounds = world.bounds();
        let slack = DVec3::splat(1e-14);
        let bounds = Bounds::new(bounds.min() - slack, bounds.max() + slack);
        prop_assert!(world.faces(key).unwrap().flatten().all(|p| bounds.contains(p)));
    }
}
