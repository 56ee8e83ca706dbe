//! The seeds' cameras, each fault asserted as a fault of the camera that has it, and each against itself in `f64`.

use polosa_math::glam::DVec3;
use polosa_math::reference::algebra::{dot, identity, length, product, project, transposed};
use polosa_math::reference::camera::Fault;
use polosa_math::reference::camera::angles::{self, Seed};
use polosa_math::reference::camera::s1::{self, Axes};
use polosa_math::reference::camera::s4::{self, Form};
use polosa_math::{Basis, Placement, Viewport, clip_from_model, perspective_horizontal};
use proptest::prelude::*;

/// The seed's demonstration: 400 × 300, from (3, 4, 8) towards the origin.
fn demo() -> s1::Camera<f64> {
    let mut camera = s1::Camera::new(400, 300);
    camera.set_location([3.0, 4.0, 8.0]);
    camera.set_direction([-3.0, -4.0, -8.0].map(|x: f64| x / 89_f64.sqrt()));
    camera
}

/// The same view in the way that polosa draws it.
fn ours(eye: [f64; 3], direction: [f64; 3], point: [f64; 3]) -> [f64; 2] {
    let (eye, direction) = (DVec3::from_array(eye), DVec3::from_array(direction));
    let lens = perspective_horizontal(70_f64.to_radians(), 4.0 / 3.0, 1.0, 1000.0).unwrap();
    let basis = Basis::looking(direction, DVec3::Y);
    let m = clip_from_model(&lens, &basis.rotation(), eye, &Placement::at(DVec3::from_array(point)));
    let [x, y, _, w] = m[3].map(f64::from);
    Viewport::new(400, 300).to_pixels(x, y, w)
}

// S1

#[test]
fn s1_shrinks_its_own_demonstration_by_9_4_per_cent() {
    let camera = demo();
    let sine = (73.0 / 89.0_f64).sqrt();
    assert!((0.9055..0.9065).contains(&sine), "0.906 is {sine}");
    for axis in [camera.right(), camera.up()] {
        assert!((length(axis) - sine).abs() < 1e-15);
    }
    let faults: Vec<_> = camera.faults().collect();
    assert!(matches!(faults[..], [Fault::Lengths { right, up }] if right < 0.91 && up < 0.91), "{faults:?}");
    assert!(faults[0].to_string().contains("0.906"), "{}", faults[0]);

    // So every point of the picture is 9.4 % too near to its middle; its depth is right.
    let mended = camera.with_axes(Axes::Normalized);
    assert_eq!(mended.faults().count(), 0);
    for point in [[1.0, 1.0, 1.0], [-1.0, 1.0, -1.0], [1.0, -1.0, -1.0]] {
        let (printed, right) = (camera.pixels(point), mended.pixels(point));
        for (i, middle) in [200.0, 150.0].into_iter().enumerate() {
            let [shrunk, whole] = [printed[i] - middle, right[i] - middle];
            assert!((shrunk - sine * whole).abs() < 1e-10, "{shrunk} of {whole}");
        }
        assert!((printed[2] - right[2]).abs() < 1e-15);
    }
}

#[test]
fn s1_with_a_direction_of_any_length_is_worse() {
    let mut camera = demo();
    camera.set_direction([-3.0, -4.0, -8.0]);
    assert!((length(camera.right()) - 73_f64.sqrt()).abs() < 1e-14, "8.54");
    assert!((length(camera.up()) - (73.0 * 89.0_f64).sqrt()).abs() < 1e-12, "80.6");
    assert_eq!(camera.with_axes(Axes::Normalized).faults().count(), 0);
}

#[test]
fn s1_looking_straight_down_sees_one_point_and_mended_by_normalising_none() {
    let mut camera = demo();
    camera.set_direction([0.0, -1.0, 0.0]);
    assert_eq!(camera.faults().collect::<Vec<_>>(), [Fault::Collapsed]);
    for point in [[1.0, -5.0, 1.0], [-1.0, 0.0, -1.0], [30.0, -20.0, -1.0]] {
        assert_eq!(camera.pixels(point)[..2], [200.0, 150.0], "all in the middle");
    }
    let mended = camera.with_axes(Axes::Normalized);
    assert_eq!(mended.faults().collect::<Vec<_>>(), [Fault::NotANumber]);
    assert!(mended.pixels([1.0, -5.0, 1.0])[..2].iter().all(|x| x.is_nan()));
    // Ours has a right and an up there.
    assert!(ours([3.0, 4.0, 8.0], [0.0, -1.0, 0.0], [4.0, -5.0, 8.0])[0] > 210.0);
}

#[test]
fn s1_keeps_the_old_projection_when_parallel_is_set() {
    let mut camera = demo();
    let before = camera.view_projection();
    camera.set_parallel(true);
    assert_eq!(camera.view_projection(), before, "the trap");
    assert!(camera.faults().any(|fault| fault == Fault::Stale));
    assert_ne!(camera.projection(), demo().projection());
    camera.set_location(camera.location());
    assert_ne!(camera.view_projection(), before);
    assert!(!camera.faults().any(|fault| fault == Fault::Stale));
}

#[test]
fn s1_mirrors_what_is_behind_the_eye() {
    let camera = s1::Camera::<f64>::new(400, 300);
    // Above and to the right, in front of the eye at z = 10 and as far behind it.
    let [front, behind] = [camera.pixels([1.0, 1.0, 0.0]), camera.pixels([1.0, 1.0, 20.0])];
    assert!(front[0] > 200.0 && front[1] < 150.0);
    for (a, b, middle) in [(front[0], behind[0], 200.0), (front[1], behind[1], 150.0)] {
        assert!((a + b - 2.0 * middle).abs() < 1e-12, "point-mirrored in the middle");
    }
    assert!(camera.pixels([1.0, 1.0, 10.0])[0].is_infinite(), "and infinite beside it");
}

#[test]
fn s1_mended_is_the_camera_in_use_to_a_thousandth_of_a_pixel() {
    let camera = demo().with_axes(Axes::Normalized);
    for point in [[1.0, 1.0, 1.0], [-1.0, 1.0, -1.0], [0.0, -1.0, 2.0]] {
        let [x, y, _] = camera.pixels(point);
        let [a, b] = ours(camera.location(), camera.direction(), point);
        assert!((x - a).abs() < 1e-3 && (y - b).abs() < 1e-3, "{x} {y} is not {a} {b}");
    }
}

#[test]
fn s1_in_f32_jitters_far_from_the_origin_where_ours_does_not() {
    // The same view of a point, here and moved by a whole number of units that an f32 holds.
    let off = |far: f32| {
        let mut camera = s1::Camera::<f32>::new(400, 300).with_axes(Axes::Normalized);
        camera.set_direction([0.6, -0.0, -0.8]);
        camera.set_location([far, 0.0, far]);
        let point = [far + 2.0, 0.5, far - 2.0];
        let [x, y, _] = camera.pixels(point);
        let [a, b, _] = camera.widened().pixels(point.map(f64::from));
        let [c, d] = ours([far, 0.0, far].map(f64::from), [0.6, 0.0, -0.8], point.map(f64::from));
        let ours = (c - a).abs().max((d - b).abs());
        ((f64::from(x) - a).abs().max((f64::from(y) - b).abs()), ours)
    };
    let (near, _) = off(4.0);
    assert!(near < 1e-3, "{near} px beside the origin");
    for (far, least) in [(65_536.0, 0.05), (4_194_304.0, 5.0)] {
        let (error, ours) = off(far);
        assert!(error > least, "{error} px at {far}");
        assert!(ours < 1e-3, "{ours} px at {far}");
    }
}

#[test]
fn s1s_perspectives_put_the_planes_at_minus_1_and_1_and_agree() {
    let (fov, aspect, near, far) = (70_f64.to_radians(), 4.0 / 3.0, 1.0, 1000.0);
    let by_angle = s1::perspective(fov, aspect, near, far);
    let (x, y) = ((fov / 2.0).tan(), (fov / 2.0).tan() / aspect);
    let by_planes = s1::perspective_planes([-x, x], [-y, y], near, far);
    let endless = s1::perspective_infinite(fov, aspect, near);
    let parallel = s1::orthographic([-0.5, 0.5], [-0.5, 0.5], near, far);
    for m in [by_angle, by_planes, parallel] {
        assert!((project(&m, [0.0, 0.0, -near])[2] + 1.0).abs() < 1e-12);
        assert!((project(&m, [0.0, 0.0, -far])[2] - 1.0).abs() < 1e-12);
    }
    for (a, b) in by_angle.as_flattened().iter().zip(by_planes.as_flattened()) {
        assert!((a - b).abs() < 1e-14);
    }
    assert_eq!(project(&endless, [0.0, 0.0, -near])[2], -1.0);
    assert!(project(&endless, [0.0, 0.0, -1e9])[2] < 1.0);
    // A window beside the axis: the terms are missing, its left edge should come to −1.
    let beside = s1::perspective_planes([0.0, 2.0], [-1.0, 1.0], near, far);
    assert_eq!(project(&beside, [0.0, 0.0, -near])[0], 0.0);
}

// S4

fn s4_at(near: f64, far: f64) -> s4::Camera<f64> {
    s4::Camera {
        position: [3.0, 4.0, 8.0],
        axes: [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, -1.0]],
        nearest: [-0.5, -0.5, near],
        farthest: [0.5, 0.5, far],
        size: [640.0, 480.0],
    }
}

/// A point of the box's corner ray at a distance, in the world.
fn corner(camera: &s4::Camera<f64>, distance: f64) -> [f64; 3] {
    let grown = distance / camera.nearest[2];
    [3.0 + 0.5 * grown, 4.0 + 0.5 * grown, 8.0 - distance]
}

#[test]
fn s4_as_printed_is_right_at_n_1_only() {
    for (near, far) in [(0.1, 100.0), (0.5, 20.0), (1.0, 100.0), (2.0, 50.0), (10.0, 11.0)] {
        let camera = s4_at(near, far);
        for distance in [near, (near * far).sqrt(), far] {
            let mended = camera.pixels(Form::Mended, corner(&camera, distance));
            // The corner ray goes to the corner, with pixel centres at whole numbers: half a pixel beyond the last.
            assert!((mended[0] - 639.5).abs() < 1e-9 && (mended[1] - 479.5).abs() < 1e-9, "{mended:?}");
            let printed = camera.pixels(Form::Printed, corner(&camera, distance));
            let off = (printed[0] - mended[0]).abs();
            assert_eq!(off < 1e-9, near == 1.0, "{off} px at n = {near}");
            // x about the middle is divided by n once too often.
            let [wrong, right] = [printed[0] - 319.5, mended[0] - 319.5];
            assert!((wrong * near - right).abs() < 1e-9);
        }
        assert!((camera.pixels(Form::Mended, corner(&camera, near))[2] - 1.0).abs() < 1e-9, "1 near");
        assert!((camera.pixels(Form::Mended, corner(&camera, far))[2] + 1.0).abs() < 1e-9, "−1 far");
        assert_eq!(camera.faults(Form::Mended).count(), 0);
        let printed: Vec<_> = camera.faults(Form::Printed).collect();
        assert_eq!(printed, if near == 1.0 { vec![] } else { vec![Fault::LastRow { near }] });
    }
}

#[test]
fn s4_as_printed_has_depth_from_0_98_to_minus_19_at_n_a_tenth() {
    let camera = s4_at(0.1, 100.0);
    let depth = |distance| camera.pixels(Form::Printed, corner(&camera, distance))[2];
    assert!((0.981..0.983).contains(&depth(0.1)), "{}", depth(0.1));
    assert!((-19.1..-18.9).contains(&depth(100.0)), "{}", depth(100.0));
}

#[test]
fn s4s_depth_falls_with_the_distance_so_the_nearest_is_the_largest() {
    let camera = s4_at(1.0, 100.0);
    for form in [Form::Printed, Form::Mended] {
        let depths = [1.0, 2.0, 5.0, 20.0, 100.0].map(|d| camera.pixels(form, corner(&camera, d))[2]);
        assert!(depths.is_sorted_by(|a, b| a > b), "{depths:?}");
    }
}

#[test]
fn s4_in_f32_is_a_hundredth_of_a_pixel_off_near_the_origin_and_pixels_far_from_it() {
    let off = |far: f32| {
        let camera = s4::Camera::<f32> {
            position: [far, 4.0, far],
            axes: [[0.8, 0.0, 0.6], [0.0, 1.0, 0.0], [0.6, 0.0, -0.8]],
            nearest: [-0.5, -0.5, 0.5],
            farthest: [0.5, 0.5, 100.0],
            size: [640.0, 480.0],
        };
        let point = [far + 2.0, 4.5, far - 2.0];
        let a = camera.pixels(Form::Mended, point).map(f64::from);
        let b = camera.widened().pixels(Form::Mended, point.map(f64::from));
        (a[0] - b[0]).abs().max((a[1] - b[1]).abs())
    };
    assert!(off(4.0) < 1e-2, "{}", off(4.0));
    assert!(off(65_536.0) > 0.05, "{}", off(65_536.0));
    assert!(off(4_194_304.0) > 5.0, "{}", off(4_194_304.0));
}

// S0, S3

#[test]
fn s0_and_s3_turn_their_heading_in_opposite_senses() {
    for (heading, pitch) in [(0.3, 0.0), (2.0, 0.5), (-1.0, 1.2)] {
        assert_eq!(angles::rotation(Seed::S0, heading, pitch), angles::rotation(Seed::S3, -heading, pitch));
    }
    // By a heading of 90° S0 brings what was nearest to the left, S3 to the right.
    let right = |seed| {
        let m = angles::rotation(seed, core::f64::consts::FRAC_PI_2, 0.0);
        angles::pixels(seed, &m, [0.0, 0.0, 100.0], 400, 400)[0]
    };
    assert!((right(Seed::S0) - 100.0).abs() < 1e-12 && (right(Seed::S3) - 300.0).abs() < 1e-12);
}

#[test]
fn s0_is_half_a_pixel_off_in_pictures_of_odd_size() {
    let m = angles::rotation(Seed::S0, 0.0, 0.0);
    let middle = |seed| angles::pixels(seed, &m, [0.0; 3], 401, 300);
    assert_eq!(middle(Seed::S0), [200.0, 150.0, 0.0]);
    assert_eq!(middle(Seed::S3), [200.5, 150.0, 0.0]);
    assert_eq!(angles::faults(Seed::S0, 401, 300).collect::<Vec<_>>(), [Fault::HalfPixel]);
    assert_eq!(angles::faults(Seed::S0, 400, 300).count() + angles::faults(Seed::S3, 401, 300).count(), 0);
}

#[test]
fn s3_takes_whole_degrees_from_the_pointer() {
    assert_eq!(angles::pointed(300, 300, 600, 600), [90, -90]);
    assert_eq!(angles::pointed(301, 302, 600, 600), [90, -90], "three pixels and more are one step");
    assert_eq!(angles::pointed(304, -4, 600, 600), [91, 1]);
    assert_eq!(angles::pointed(i32::MIN, i32::MAX, 0, 1), [0, -180 * i64::from(i32::MAX)]);
}

#[test]
fn heading_and_pitch_in_f32_are_good_to_a_thousandth_of_a_pixel() {
    for degrees in (0..360).step_by(7) {
        let [heading, pitch] = [f64::from(degrees), f64::from(degrees % 180 - 90)].map(f64::to_radians);
        let exact = angles::rotation(Seed::S3, heading, pitch);
        let rough = angles::rotation(Seed::S3, heading as f32, pitch as f32);
        let a = angles::pixels(Seed::S3, &rough, [100.0, -100.0, 100.0], 600, 600);
        let b = angles::pixels(Seed::S3, &exact, [100.0, -100.0, 100.0], 600, 600);
        assert!((0..3).all(|i| (f64::from(a[i]) - b[i]).abs() < 1e-3), "{degrees}: {a:?} is not {b:?}");
    }
}

proptest! {
    #[test]
    fn heading_and_pitch_make_a_rotation(heading in -10.0..10.0_f64, pitch in -10.0..10.0_f64) {
        for seed in [Seed::S0, Seed::S3] {
            let m = angles::rotation(seed, heading, pitch);
            let square = product(&m, &transposed(&m));
            let unit = identity::<f64, 3>();
            for (a, b) in square.as_flattened().iter().zip(unit.as_flattened()) {
                prop_assert!((a - b).abs() < 1e-14);
            }
        }
    }

    #[test]
    fn s1s_axes_are_as_long_as_the_sine_and_at_right_angles(d in prop::array::uniform3(-1.0..1.0_f64)) {
        let size = length(d);
        prop_assume!(size > 1e-3);
        let mut camera = s1::Camera::<f64>::new(400, 300);
        camera.set_direction(d.map(|x| x / size));
        let [x, _, z] = camera.direction();
        let sine = (x * x + z * z).sqrt();
        let (u, v) = (camera.right(), camera.up());
        prop_assert!((length(u) - sine).abs() < 1e-15 && (length(v) - sine).abs() < 1e-15);
        prop_assert!(dot(u, v).abs() < 1e-15 && dot(u, camera.direction()).abs() < 1e-15);
    }

    #[test]
    fn nothing_panics(place in prop::array::uniform3(any::<f32>()), to in prop::array::uniform3(any::<f32>()),
                      point in prop::array::uniform3(any::<f32>()), width in any::<u32>(), height in any::<u32>()) {
        for axes in [Axes::Printed, Axes::Normalized] {
            let mut camera = s1::Camera::<f32>::new(width, height).with_axes(axes);
            camera.set_location(place);
            camera.set_direction(to);
            camera.set_parallel(true);
            let _ = camera.pixels(point);
            let _ = camera.widened().pixels(point.map(f64::from));
            camera.faults().for_each(drop);
        }
        let camera = s4::Camera { position: place, axes: [to; 3], nearest: point, farthest: to, size: [1.0, 2.0] };
        let _ = camera.pixels(Form::Printed, point);
        camera.faults(Form::Printed).for_each(drop);
    }
}
