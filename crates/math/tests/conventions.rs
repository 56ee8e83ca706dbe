//! Each sentence of the crate's conventions as a test, and the known faults of naive cameras as claims.

use core::f64::consts::{FRAC_PI_2, FRAC_PI_3, PI};

use polosa_math::{
    Basis, Placement, Planes, SUB_PIXELS, Viewport, axis_angle, clip_from_model,
    glam::{DMat4, DVec3, DVec4},
    heading_pitch_roll, orthographic, orthographic_planes, perspective_horizontal, perspective_planes,
    perspective_vertical,
};

const OFF_CENTRE: Planes = Planes { left: -1.0, right: 3.0, bottom: -2.0, top: 0.5, near: 2.0, far: 20.0 };

fn divided(matrix: &DMat4, x: f64, y: f64, z: f64) -> DVec3 {
    let clip = *matrix * DVec4::new(x, y, z, 1.0);
    clip.truncate() / clip.w
}

#[track_caller]
fn assert_close(a: DVec3, b: DVec3) {
    assert!((a - b).abs().max_element() < 1e-14, "{a} is not {b}");
}

// World and camera

#[test]
fn the_world_is_right_handed_with_y_up_and_the_camera_looks_down_its_own_minus_z() {
    let basis = Basis::looking(DVec3::NEG_Z, DVec3::Y);
    assert_eq!((basis.right(), basis.up(), basis.back()), (DVec3::X, DVec3::Y, DVec3::Z));
    assert_eq!(basis.forward(), DVec3::NEG_Z);
    assert_eq!(basis.rotation(), DMat4::IDENTITY);
}

#[test]
fn u_v_n_are_right_up_and_backward() {
    let basis = Basis::looking(DVec3::new(-3.0, -4.0, -8.0), DVec3::Y);
    assert_close(basis.right().cross(basis.up()), basis.back());
    assert!(basis.up().y > 0.0 && basis.back().dot(DVec3::new(3.0, 4.0, 8.0)) > 0.0);
    // Seen from the front right, the world's +X goes right and its +Z left.
    assert!(basis.right().x > 0.0 && basis.right().z < 0.0);
}

#[test]
fn the_view_puts_the_eye_at_the_origin_and_what_is_ahead_on_minus_z() {
    let eye = DVec3::new(3.0, 4.0, 8.0);
    let view = Basis::looking(-eye, DVec3::Y).view(eye);
    assert_close((view * eye.extend(1.0)).truncate(), DVec3::ZERO);
    let origin = (view * DVec4::W).truncate();
    assert_close(origin, DVec3::new(0.0, 0.0, -eye.length()));
}

#[test]
fn matrices_are_for_column_vectors_and_compose_as_projection_view_model() {
    let (eye, model) = (DVec3::new(1.0, 2.0, 9.0), Placement::at(DVec3::new(0.5, -1.0, 2.0)));
    let basis = Basis::looking(DVec3::new(0.1, 0.2, -1.0), DVec3::Y);
    let projection = perspective_vertical(1.0, 1.5, 0.5, 80.0).unwrap();
    let p = DVec4::new(0.25, 0.5, 0.75, 1.0);
    let stepwise = projection * (basis.view(eye) * (model.matrix() * p));
    let composed = clip_from_model(&projection, &basis.rotation(), eye, &model);
    for row in 0..4 {
        let sum: f64 = (0..4).map(|column| f64::from(composed[column][row]) * p[column]).sum();
        assert!((sum - stepwise[row]).abs() < 1e-5, "row {row}: {sum} against {}", stepwise[row]);
    }
    // The translation is in the last column.
    assert_eq!(model.matrix().w_axis.truncate(), model.translation);
}

// Clip space

#[test]
fn clip_space_has_x_to_the_right_and_y_up() {
    for matrix in [
        perspective_vertical(1.0, 1.5, 0.5, 80.0).unwrap(),
        perspective_horizontal(1.0, 1.5, 0.5, f64::INFINITY).unwrap(),
        orthographic(3.0, 1.5, 0.5, 80.0).unwrap(),
    ] {
        assert!(divided(&matrix, 0.1, 0.0, -1.0).x > 0.0 && divided(&matrix, 0.0, 0.1, -1.0).y > 0.0);
    }
}

#[test]
fn depth_is_1_at_near_and_0_at_far_in_every_projection() {
    let planes = Planes { near: 0.5, far: 80.0, ..OFF_CENTRE };
    for matrix in [
        perspective_vertical(1.0, 1.5, 0.5, 80.0),
        perspective_horizontal(1.0, 1.5, 0.5, 80.0),
        perspective_planes(&planes),
        orthographic(3.0, 1.5, 0.5, 80.0),
        orthographic_planes(&planes),
    ] {
        let matrix = matrix.unwrap();
        assert!((divided(&matrix, 0.0, 0.0, -0.5).z - 1.0).abs() < 1e-15);
        assert!(divided(&matrix, 0.0, 0.0, -80.0).z.abs() < 1e-15);
        let between = divided(&matrix, 0.0, 0.0, -1.0).z;
        assert!(0.0 < between && between < 1.0);
        assert!(divided(&matrix, 0.0, 0.0, -2.0).z < between, "larger is nearer");
    }
}

#[test]
fn with_an_infinite_far_plane_depth_is_near_over_distance() {
    for matrix in [
        perspective_vertical(1.0, 1.5, 0.5, f64::INFINITY).unwrap(),
        perspective_planes(&Planes { near: 0.5, far: f64::INFINITY, ..OFF_CENTRE }).unwrap(),
    ] {
        for distance in [0.5, 1.0, 3.0, 1e6, 1e300] {
            assert_eq!(divided(&matrix, 0.0, 0.0, -distance).z, 0.5 / distance);
        }
    }
    // And is where ever farther planes tend to.
    let far = perspective_vertical(1.0, 1.5, 0.5, 1e308).unwrap();
    assert!((divided(&far, 0.0, 0.0, -3.0).z - 0.5 / 3.0).abs() < 1e-15);
}

#[test]
fn behind_the_eye_w_is_negative() {
    let matrix = perspective_vertical(1.0, 1.0, 0.5, 80.0).unwrap();
    assert_eq!((matrix * DVec4::new(0.0, 0.0, 3.0, 1.0)).w, -3.0);
}

// Projections

#[test]
fn the_vertical_field_of_view_reaches_from_the_lower_to_the_upper_edge() {
    let matrix = perspective_vertical(FRAC_PI_2, 2.0, 1.0, 9.0).unwrap();
    assert_close(divided(&matrix, 6.0, 3.0, -3.0).with_z(0.0), DVec3::new(1.0, 1.0, 0.0));
}

#[test]
fn the_horizontal_field_of_view_reaches_from_the_left_to_the_right_edge() {
    let matrix = perspective_horizontal(FRAC_PI_2, 2.0, 1.0, 9.0).unwrap();
    assert_close(divided(&matrix, 3.0, 1.5, -3.0).with_z(0.0), DVec3::new(1.0, 1.0, 0.0));
}

#[test]
fn the_window_of_six_planes_lies_on_the_near_plane_its_off_centre_terms_included() {
    let Planes { left, right, bottom, top, near, .. } = OFF_CENTRE;
    for (matrix, spread) in
        [(perspective_planes(&OFF_CENTRE).unwrap(), 3.0), (orthographic_planes(&OFF_CENTRE).unwrap(), 1.0)]
    {
        for (x, y, seen) in [(left, bottom, -1.0), (right, top, 1.0)] {
            assert_close(divided(&matrix, x, y, -near), DVec3::new(seen, seen, 1.0));
            // Further off the window has grown with the distance, or not at all.
            let far = divided(&matrix, spread * x, spread * y, -3.0 * near);
            assert_close(far.with_z(0.0), DVec3::new(seen, seen, 0.0));
        }
    }
}

#[test]
fn centred_planes_and_angles_agree() {
    let (t, aspect) = ((FRAC_PI_3 / 2.0).tan(), 1.5);
    let planes = Planes { left: -t * aspect, right: t * aspect, bottom: -t, top: t, near: 1.0, far: 70.0 };
    let by_planes = perspective_planes(&planes).unwrap();
    let by_angle = perspective_vertical(FRAC_PI_3, aspect, 1.0, 70.0).unwrap();
    assert!(by_planes.abs_diff_eq(by_angle, 1e-14));
}

#[test]
fn a_height_of_256_makes_a_unit_a_pixel_exactly() {
    let matrix = orthographic(256.0, 1.0, 0.0, 10.0).unwrap();
    assert_eq!((matrix.x_axis.x, matrix.y_axis.y), (2.0 / 256.0, 2.0 / 256.0));
    let screen = Viewport::new(256, 256);
    for (x, y) in [(0.0, 0.0), (-128.0, 128.0), (0.5, -0.25)] {
        let at = matrix * DVec4::new(x, y, -5.0, 1.0);
        assert_eq!(screen.to_pixels(at.x, at.y, at.w), [128.0 + x, 128.0 - y]);
    }
}

#[test]
fn what_is_no_projection_is_refused() {
    let (nan, inf) = (f64::NAN, f64::INFINITY);
    for fov in [0.0, -1.0, PI, 7.0, nan, inf] {
        assert_eq!(perspective_vertical(fov, 1.0, 1.0, 2.0), None, "{fov}");
        assert_eq!(perspective_horizontal(fov, 1.0, 1.0, 2.0), None, "{fov}");
    }
    for aspect in [0.0, -0.0, -1.0, nan, inf] {
        assert_eq!(perspective_vertical(1.0, aspect, 1.0, 2.0), None, "{aspect}");
        assert_eq!(perspective_horizontal(1.0, aspect, 1.0, 2.0), None, "{aspect}");
        assert_eq!(orthographic(1.0, aspect, 1.0, 2.0), None, "{aspect}");
    }
    for (near, far) in [(0.0, 1.0), (-1.0, 1.0), (1.0, 1.0), (2.0, 1.0), (nan, 1.0), (1.0, nan), (inf, inf)] {
        assert_eq!(perspective_vertical(1.0, 1.0, near, far), None, "{near} {far}");
        assert_eq!(perspective_planes(&Planes { near, far, ..OFF_CENTRE }), None, "{near} {far}");
    }
    for (near, far) in [(1.0, 1.0), (2.0, 1.0), (nan, 1.0), (1.0, nan), (1.0, inf), (-inf, 1.0)] {
        assert_eq!(orthographic(1.0, 1.0, near, far), None, "{near} {far}");
        assert_eq!(orthographic_planes(&Planes { near, far, ..OFF_CENTRE }), None, "{near} {far}");
    }
    for (left, right) in [(1.0, 1.0), (1.0, -1.0), (nan, 1.0), (-inf, 1.0), (0.0, inf)] {
        assert_eq!(perspective_planes(&Planes { left, right, ..OFF_CENTRE }), None, "{left} {right}");
        assert_eq!(orthographic_planes(&Planes { left, right, ..OFF_CENTRE }), None, "{left} {right}");
        let (bottom, top) = (left, right);
        assert_eq!(orthographic_planes(&Planes { bottom, top, ..OFF_CENTRE }), None, "{left} {right}");
    }
    for height in [0.0, -1.0, nan, inf, 1e-320] {
        assert_eq!(orthographic(height, 1.0, 1.0, 2.0), None, "{height}");
    }
}

// Screen

#[test]
fn the_screens_origin_is_at_the_top_left_with_y_down() {
    let screen = Viewport::new(640, 480);
    assert_eq!(screen.to_pixels(-1.0, 1.0, 1.0), [0.0, 0.0]);
    assert_eq!(screen.to_pixels(1.0, -1.0, 1.0), [640.0, 480.0]);
    assert_eq!(screen.to_pixels(0.0, 0.0, 3.0), [320.0, 240.0]);
}

#[test]
fn the_centre_of_a_pixel_is_half_a_pixel_from_its_corner() {
    // A picture of 2 × 2 pixels: the centres are at ±½ in clip space, whatever w.
    let screen = Viewport::new(2, 2);
    for (x, y, pixel) in [(-0.5, 0.5, [0.5, 0.5]), (0.5, 0.5, [1.5, 0.5]), (-0.5, -0.5, [0.5, 1.5])] {
        assert_eq!(screen.to_pixels(x * 3.0, y * 3.0, 3.0), pixel);
        assert_eq!(screen.from_pixels(pixel), [x, y]);
    }
}

#[test]
fn a_pixel_has_256_sub_pixels() {
    assert_eq!(SUB_PIXELS, 256);
    assert_eq!(Viewport::new(4, 4).to_sub_pixels(0.5, 0.5, 1.0), [768.0, 256.0]);
    assert_eq!(Viewport::SCREEN.to_sub_pixels(1.5, 2.0, 1.0), [384.0, 512.0]);
}

// Angles

#[test]
fn angles_turn_by_the_right_hand_rule() {
    let quarter = |axis| axis_angle(axis, FRAC_PI_2).unwrap();
    assert_close(quarter(DVec3::X) * DVec3::Y, DVec3::Z);
    assert_close(quarter(DVec3::Y) * DVec3::Z, DVec3::X);
    assert_close(quarter(DVec3::Z * 7.0) * DVec3::X, DVec3::Y);
}

#[test]
fn heading_turns_left_pitch_raises_the_nose_and_roll_leans_left() {
    let (nose, wing) = (DVec3::NEG_Z, DVec3::X);
    assert_close(heading_pitch_roll(FRAC_PI_2, 0.0, 0.0) * nose, DVec3::NEG_X);
    assert_close(heading_pitch_roll(0.0, FRAC_PI_2, 0.0) * nose, DVec3::Y);
    assert_close(heading_pitch_roll(0.0, 0.0, FRAC_PI_2) * wing, DVec3::Y);
    // Rolled first, then pitched, then headed.
    assert_close(heading_pitch_roll(FRAC_PI_2, FRAC_PI_2, 0.0) * nose, DVec3::Y);
    assert_close(heading_pitch_roll(FRAC_PI_2, 0.0, FRAC_PI_2) * wing, DVec3::Y);
}

// What goes wrong in the usual first camera

#[test]
fn right_is_normalised_though_direction_and_up_are_not_perpendicular() {
    // direction × up has length 0.906 here, and shrank the picture by 9.4 %.
    let direction = DVec3::new(-3.0, -4.0, -8.0).normalize();
    assert!((direction.cross(DVec3::Y).length() - 0.906).abs() < 1e-3);
    let basis = Basis::looking(direction, DVec3::Y);
    for axis in [basis.right(), basis.up(), basis.back()] {
        assert!((axis.length() - 1.0).abs() < 1e-15);
    }
}

#[test]
fn up_parallel_to_the_direction_has_a_defined_result() {
    let down = Basis::looking(DVec3::NEG_Y, DVec3::Y);
    assert_eq!((down.right(), down.up()), (DVec3::X, DVec3::NEG_Z), "a map with north up");
    let up = Basis::looking(DVec3::Y * 5.0, DVec3::NEG_Y);
    assert_eq!((up.up(), up.forward()), (DVec3::NEG_Z, DVec3::Y));
    let z_up = Basis::looking(DVec3::Z, DVec3::Z);
    assert_eq!((z_up.up(), z_up.forward()), (DVec3::Y, DVec3::Z));
}

#[test]
fn zero_and_not_a_number_have_a_defined_result() {
    let default = Basis::looking(DVec3::NEG_Z, DVec3::Y);
    for bad in [DVec3::ZERO, DVec3::NAN, DVec3::INFINITY, DVec3::new(0.0, f64::NAN, 1.0)] {
        assert_eq!(Basis::looking(bad, DVec3::Y), default);
        assert_eq!(Basis::looking(DVec3::NEG_Z, bad), default);
        assert_eq!(Basis::looking(bad, bad), default);
    }
}

#[test]
fn pi_is_not_mistyped() {
    // A π that is 3·10⁻⁵ off shows in the tangent of 45° and in a full turn.
    let matrix = perspective_vertical(90_f64.to_radians(), 1.0, 1.0, 2.0).unwrap();
    assert!((matrix.y_axis.y - 1.0).abs() < 1e-15);
    let once_round = axis_angle(DVec3::Y, 360_f64.to_radians()).unwrap();
    assert_close(once_round * DVec3::X, DVec3::X);
}
