//! Spheres and hues as the seeds make them, each error asserted as that of the way that has it.

use std::collections::HashSet;

use polosa_math::glam::DVec3;
use polosa_scene::reference::Sphere;
use polosa_scene::reference::hue::{from_hsv, longitude, pseudo_longitude, whole};
use polosa_scene::reference::sphere::radial_error;
use polosa_scene::shape::{self, Solid};
use polosa_scene::{Camera, Color, Mesh, ShapeError};
use proptest::prelude::*;

fn error(sphere: Sphere, level: u32) -> f64 {
    radial_error(&sphere.mesh(level).unwrap(), 1.0)
}

// Spheres

#[test]
fn for_equal_error_the_tetrahedron_needs_twice_the_triangles_of_the_octahedron() {
    for level in 0..=6 {
        let (tetrahedron, octant) = (error(Sphere::Tetrahedron, level + 1), error(Sphere::Octant, level));
        assert!((tetrahedron - octant).abs() < 1e-6, "level {level}: {tetrahedron} is not {octant}");
        assert_eq!(Sphere::Tetrahedron.triangles(level + 1), Sphere::Octant.triangles(level).map(|n| 2 * n));
    }
}

#[test]
fn errors_fall_to_a_quarter_from_level_to_level() {
    for (sphere, factor) in [(Sphere::Tetrahedron, 4.0), (Sphere::Octant, 1.0), (Sphere::Icosahedron, 0.292)]
    {
        for level in 3..=6 {
            let bound = factor * 0.25_f64.powi(level as i32);
            let error = error(sphere, level);
            assert!(0.9 * bound < error && error < bound, "{sphere} {level}: {error} of {bound}");
        }
    }
}

#[test]
fn a_sphere_of_200_pixels_is_right_to_a_pixel_with_these_many_triangles() {
    for (sphere, level, triangles, pixels) in [
        (Sphere::Octant, 4, 2048, 0.777),
        (Sphere::Tetrahedron, 5, 4096, 0.777),
        (Sphere::Icosahedron, 3, 1280, 0.906),
    ] {
        let mesh = sphere.mesh(level).unwrap();
        assert_eq!(mesh.triangles().len(), triangles);
        let error = 200.0 * radial_error(&mesh, 1.0);
        assert!((error - pixels).abs() < 1e-3, "{sphere}: {error} px");
        assert!(200.0 * self::error(sphere, level - 1) > 3.0, "one level less is not");
    }
}

/// The triangles as sets of corners, to 10⁻⁶.
fn corners(mesh: &Mesh) -> HashSet<[[i32; 3]; 3]> {
    let corner = |&i: &u32| mesh.positions()[i as usize].map(|x| (x * 1e6).round() as i32);
    let sorted = |t: &[u32; 3]| {
        let mut t = [corner(&t[0]), corner(&t[1]), corner(&t[2])];
        t.sort_unstable();
        t
    };
    mesh.triangles().iter().map(sorted).collect()
}

#[test]
fn the_seeds_spheres_are_those_of_the_shapes() {
    for (sphere, solid) in [(Sphere::Tetrahedron, Solid::Tetrahedron), (Sphere::Octant, Solid::Octahedron)] {
        for level in 0..=4 {
            let (theirs, ours) = (sphere.mesh(level).unwrap(), shape::sphere(solid, level).unwrap());
            assert_eq!(theirs.triangles().len(), ours.triangles().len());
            assert_eq!(theirs.triangles().len() as u64, sphere.triangles(level).unwrap());
            assert_eq!(corners(&theirs), corners(&ours), "{sphere} {level}");
        }
    }
}

/// How many triangles are counter-clockwise seen from outside.
fn outward(mesh: &Mesh) -> usize {
    let at = |i: u32| DVec3::from_array(mesh.positions()[i as usize].map(f64::from));
    let outward = |t: &&[u32; 3]| {
        let [a, b, c] = t.map(at);
        (b - a).cross(c - a).dot(a + b + c) > 0.0
    };
    mesh.triangles().iter().filter(outward).count()
}

#[test]
fn inflation_turns_two_of_four_triangles_over_at_each_level() {
    for level in 0..=4 {
        // Half of the faces are wound inward to begin with, so half of the parts always are.
        let mesh = Sphere::Tetrahedron.mesh(level).unwrap();
        assert_eq!(2 * outward(&mesh), mesh.triangles().len());
        for sphere in [Sphere::Octant, Sphere::Icosahedron] {
            let mesh = sphere.mesh(level).unwrap();
            assert_eq!(outward(&mesh), mesh.triangles().len(), "{sphere}");
        }
    }
    // Of a face that is wound outward (PQS, the second), the parts 2 and 3 are not.
    let mesh = Sphere::Tetrahedron.mesh(1).unwrap();
    let part =
        |i: usize| outward(&Mesh::new(mesh.positions().to_vec(), vec![mesh.triangles()[4 + i]]).unwrap());
    assert_eq!([0, 1, 2, 3].map(part), [1, 0, 0, 1]);
}

#[test]
fn the_octants_are_mirror_images_to_the_last_bit() {
    let mesh = Sphere::Octant.mesh(5).unwrap();
    let points = |of: fn([f32; 3]) -> [f32; 3]| {
        mesh.positions().iter().map(|&p| of(p).map(|x| (x + 0.0).to_bits())).collect::<HashSet<_>>()
    };
    let all = points(|p| p);
    assert_eq!(all, points(|[x, y, z]| [-x, y, z]));
    assert_eq!(all, points(|[x, y, z]| [x, -y, z]));
    assert_eq!(all, points(|[x, y, z]| [x, y, -z]));
    assert_eq!(all.len(), 4098, "corners that meet have the same bits: 4·4⁵ + 2 of them");
}

#[test]
fn too_many_triangles_are_refused() {
    for (sphere, most) in [(Sphere::Tetrahedron, 11), (Sphere::Octant, 10), (Sphere::Icosahedron, 9)] {
        for level in [most + 1, 31, 32, u32::MAX] {
            assert!(matches!(sphere.mesh(level), Err(ShapeError::TooLarge { .. })), "{sphere} {level}");
        }
        assert!(sphere.triangles(most).unwrap() <= polosa_scene::subdivide::MOST_TRIANGLES);
    }
}

#[test]
fn the_radial_error_is_that_of_the_nearest_point_not_of_the_plane() {
    // An obtuse triangle whose plane is nearer to the origin than it is itself.
    let mesh = |a, b, c| Mesh::new(vec![a, b, c], vec![[0, 1, 2]]).unwrap();
    let beside = mesh([3.0, 0.0, 4.0], [6.0, 1.0, 4.0], [6.0, -1.0, 4.0]);
    assert_eq!(radial_error(&beside, 6.0), 1.0, "its corner at distance 5, not the plane at 4");
    let around = mesh([3.0, 0.0, 4.0], [-3.0, 3.0, 4.0], [-3.0, -3.0, 4.0]);
    assert_eq!(radial_error(&around, 6.0), 2.0);
    let flat = mesh([3.0, 0.0, 4.0], [3.0, 0.0, 4.0], [3.0, 0.0, 4.0]);
    assert_eq!(radial_error(&flat, 6.0), 1.0, "a point");
    assert!(radial_error(&mesh([f32::NAN; 3], [0.0; 3], [1.0; 3]), 1.0).is_nan());
    assert_eq!(radial_error(&Mesh::default(), 1.0), f64::NEG_INFINITY);
}

// Hues

fn around(degrees: f64) -> [f64; 3] {
    let (y, x) = degrees.to_radians().sin_cos();
    [x, y, 0.3]
}

#[test]
fn the_pseudo_longitude_is_18_9_degrees_off_and_right_on_the_axes() {
    let worst = |hue: fn([f64; 3]) -> f64| {
        let off = (0..36_000).map(|i| {
            let direction = around(f64::from(i) / 100.0);
            (hue(direction) - longitude(direction).unwrap()).abs()
        });
        off.fold(0.0, f64::max)
    };
    let off = worst(pseudo_longitude);
    assert!((18.94..18.95).contains(&off), "{off}");
    let cut = worst(|direction| whole(pseudo_longitude(direction)));
    assert!((19.9..19.95).contains(&cut), "{cut}: as the seed cuts it off");
    for (direction, hue) in [
        ([1.0, 0.0, 0.0], 360.0),
        ([0.0, 1.0, 0.0], 270.0),
        ([-1.0, 0.0, 5.0], 180.0),
        ([0.0, -1.0, 0.0], 90.0),
    ] {
        assert_eq!(pseudo_longitude(direction), hue);
        assert_eq!(longitude(direction), Some(hue));
    }
}

#[test]
fn at_the_poles_the_pseudo_longitude_is_not_a_number() {
    for direction in [[0.0; 3], [0.0, 0.0, 1.0], [-0.0, 0.0, -1.0]] {
        assert!(pseudo_longitude(direction).is_nan());
        assert_eq!(longitude(direction), None);
        assert_eq!(whole(pseudo_longitude(direction)), 0.0);
    }
}

#[test]
fn hues_have_their_colours() {
    for (hue, rgb) in [
        (0.0, 0xff_0000),
        (60.0, 0xff_ff00),
        (120.0, 0x00_ff00),
        (180.0, 0x00_ffff),
        (240.0, 0x00_00ff),
        (300.0, 0xff_00ff),
        (360.0, 0xff_0000),
        (-120.0, 0x00_00ff),
        (30.0, 0xff_8000),
    ] {
        assert_eq!(from_hsv(hue, 1.0, 1.0), Color::from_u32(rgb), "{hue}");
    }
    assert_eq!(from_hsv(200.0, 0.0, 0.5), Color::new(128, 128, 128));
    assert_eq!(from_hsv(200.0, 1.0, 0.0), Color::BLACK);
    assert_eq!(from_hsv(f64::NAN, f64::NAN, f64::NAN), Color::BLACK);
}

// The camera that is in use

#[test]
fn a_million_turns_of_the_camera_keep_its_axes_at_right_angles() {
    let mut camera = Camera::new();
    for _ in 0..1_000_000 {
        camera.azimuth(1.0 / 64.0, DVec3::ZERO).unwrap();
    }
    let (u, v, n) = (camera.basis().right(), camera.basis().up(), camera.basis().back());
    for (a, b, product) in [(u, u, 1.0), (v, v, 1.0), (n, n, 1.0), (u, v, 0.0), (v, n, 0.0), (n, u, 0.0)] {
        assert!((a.dot(b) - product).abs() < 1e-14);
    }
    assert!((camera.position().length() - 10.0).abs() < 1e-8, "{}", camera.position());
}

proptest! {
    #[test]
    fn the_pseudo_longitude_is_never_more_than_that_off(x in -1.0..1.0_f64, y in -1.0..1.0_f64) {
        prop_assume!(x != 0.0 || y != 0.0);
        let (hue, exact) = (pseudo_longitude([x, y, 0.0]), longitude([x, y, 0.0]).unwrap());
        prop_assert!((0.0..=360.0).contains(&hue) && (0.0..=360.0).contains(&exact));
        prop_assert!((hue - exact).abs() < 18.95);
    }

    #[test]
    fn no_number_panics(hue in any::<f64>(), saturation in any::<f64>(), value in any::<f64>()) {
        let _ = from_hsv(hue, saturation, value);
        let _ = longitude([hue, saturation, value]);
        let _ = whole(pseudo_longitude([hue, saturation, value]));
    }
}
