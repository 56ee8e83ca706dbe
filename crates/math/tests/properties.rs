//! Promises of the documentation over many random inputs.

use polosa_math::{
    Basis, Bounds, Containment, Frustum, Matrix, Placement, Viewport, axis_angle, clip_from_model,
    clip_from_model_f64, coordinates,
    glam::{DMat3, DMat4, DQuat, DVec3, DVec4},
    heading_pitch_roll, normalized, orthographic, perspective_vertical, to_heading_pitch_roll, turn,
};
use proptest::prelude::*;

fn vector(range: f64) -> impl Strategy<Value = DVec3> {
    [-range..range, -range..range, -range..range].prop_map(DVec3::from_array)
}

fn wild() -> impl Strategy<Value = f64> {
    let special =
        prop::sample::select(vec![0.0, -0.0, 1.0, 1e-300, 5e-324, f64::MAX, f64::INFINITY, f64::NAN]);
    prop_oneof![-2.0..2.0, special, (-300..300).prop_map(|e| 10_f64.powi(e))]
}

fn wild_vector() -> impl Strategy<Value = DVec3> {
    [wild(), wild(), wild()].prop_map(DVec3::from_array)
}

fn rotation() -> impl Strategy<Value = DQuat> {
    (vector(1.0), -4.0..4.0).prop_map(|(axis, angle)| axis_angle(axis, angle).unwrap_or(DQuat::IDENTITY))
}

fn placement() -> impl Strategy<Value = Placement> {
    let factor = || prop_oneof![0.01..10.0, -10.0..-0.01];
    (vector(100.0), rotation(), [factor(), factor(), factor()]).prop_map(|(translation, rotation, scale)| {
        Placement { translation, rotation, scale: DVec3::from_array(scale) }
    })
}

/// How far `m` times its transpose is from the identity: the largest entry of the difference.
fn error(m: &DMat3) -> f64 {
    let d = *m * m.transpose() - DMat3::IDENTITY;
    d.to_cols_array().into_iter().fold(0.0, |a: f64, b| a.max(b.abs()))
}

/// The angle in which two rotations differ, at most; `q` and `−q` are the same.
fn apart(a: DQuat, b: DQuat) -> f64 {
    let b = if a.dot(b) < 0.0 { -b } else { b };
    (a - b).length() * 2.0
}

#[test]
fn a_million_turns_do_not_drift() {
    let mut rotation = DQuat::IDENTITY;
    let by = axis_angle(DVec3::new(1.0, 2.0, -0.5), 0.1234).unwrap();
    let also = axis_angle(DVec3::new(-0.3, 0.1, 1.0), 0.0021).unwrap();
    for i in 0..1_000_000 {
        rotation = turn(rotation, if i % 3 == 0 { also } else { by });
    }
    assert!(error(&DMat3::from_quat(rotation)) < 1e-15 * 4.0);

    // One axis only: the angle itself stays right, too, to the accumulated rounding of 10⁶ steps.
    let step = axis_angle(DVec3::Y, 1e-3).unwrap();
    let total = (0..1_000_000).fold(DQuat::IDENTITY, |q, _| turn(q, step));
    assert!(apart(total, axis_angle(DVec3::Y, 1e3).unwrap()) < 1e-9);
}

#[test]
fn the_poles_are_taken_with_roll_0() {
    for pitch in [core::f64::consts::FRAC_PI_2, -core::f64::consts::FRAC_PI_2] {
        let q = heading_pitch_roll(0.5, pitch, 0.25);
        let [heading, p, roll] = to_heading_pitch_roll(q);
        assert_eq!((p, roll), (pitch, 0.0));
        assert!(apart(heading_pitch_roll(heading, p, roll), q) < 1e-12);
    }
}

#[test]
fn ten_million_units_away_nothing_jitters() {
    // A quarter unit is far below f32's step of one unit there; in f64 all differences are exact.
    let projection = perspective_vertical(1.0, 1.5, 0.1, f64::INFINITY).unwrap();
    let turn = Basis::looking(DVec3::new(1.0, -0.5, -2.0), DVec3::Y).rotation();
    let offset = DVec3::new(1e7, -1e7, 1e7);
    for i in 0..64 {
        let eye = DVec3::new(0.25, 0.5, 3.0) * f64::from(i);
        let model =
            Placement { scale: DVec3::splat(0.5), ..Placement::at(eye + DVec3::new(0.5, -0.25, -4.0)) };
        let here = clip_from_model(&projection, &turn, eye, &model);
        assert_eq!(here, clip_from_model(&projection, &turn, eye + offset, &model.moved(offset)));
    }
}

#[test]
fn a_shear_is_no_placement() {
    let mut shear = Placement::at(DVec3::X).matrix();
    shear.y_axis.x = 1e-6;
    assert_eq!(Placement::from_matrix(&shear), None);
    shear.y_axis.x = 1e-12;
    assert!(Placement::from_matrix(&shear).is_some());
    let mut projective = DMat4::IDENTITY;
    projective.z_axis.w = -1.0;
    assert_eq!(Placement::from_matrix(&projective), None);
    assert_eq!(Placement::from_matrix(&(DMat4::IDENTITY * f64::NAN)), None);
}

#[test]
fn flat_and_mirrored_matrices_are_placements() {
    for scale in
        [[1.0, 0.0, 2.0], [0.0, 0.0, 3.0], [0.0, 5.0, 0.0], [2.0, 0.0, 0.0], [0.0; 3], [1.0, -2.0, 3.0]]
    {
        let turned = Placement::at(DVec3::Y).turned(heading_pitch_roll(0.3, 0.2, 0.1));
        let matrix = turned.scaled(DVec3::from_array(scale)).matrix();
        let back = Placement::from_matrix(&matrix).unwrap();
        assert!(back.matrix().abs_diff_eq(matrix, 1e-12), "{scale:?}");
    }
}

#[test]
fn an_infinite_far_plane_is_no_plane() {
    let count = |far| Frustum::from_clip(&perspective_vertical(1.0, 1.0, 0.1, far).unwrap()).planes().count();
    assert_eq!((count(100.0), count(f64::INFINITY)), (6, 5));
    let beyond = Bounds::new(DVec3::splat(-1e6).with_z(-1e9), DVec3::splat(1e6).with_z(-1e9));
    let infinite = Frustum::from_clip(&perspective_vertical(1.0, 1.0, 0.1, f64::INFINITY).unwrap());
    assert_eq!(infinite.bounds(&beyond), Containment::Inside);
}

#[test]
fn the_frustum_answers_plainly_where_it_is_plain() {
    let frustum = Frustum::from_clip(&perspective_vertical(1.0, 1.0, 1.0, 100.0).unwrap());
    for (z, radius, answer) in [
        (-10.0, 1.0, Containment::Inside),
        (-10.0, 20.0, Containment::Crosses),
        (-0.5, 0.1, Containment::Outside),
        (-1.0, 0.1, Containment::Crosses),
        (10.0, 1.0, Containment::Outside),
        (-200.0, 1.0, Containment::Outside),
        (-100.0, 1.0, Containment::Crosses),
        (f64::NAN, 1.0, Containment::Crosses),
    ] {
        let center = DVec3::new(0.0, 0.0, z);
        assert_eq!(frustum.sphere(center, radius), answer, "{z}");
        let half = DVec3::splat(radius / 3_f64.sqrt());
        let cube = Bounds::new(center - half, center + half);
        if z.is_finite() {
            assert_eq!(frustum.bounds(&cube), answer, "{z}");
        }
    }
    assert_eq!(frustum.bounds(&Bounds::EMPTY), Containment::Outside);
    let senseless = Frustum::from_clip(&(DMat4::IDENTITY * f64::NAN));
    assert_eq!(senseless.planes().count(), 0);
}

#[test]
fn bounds_leave_out_what_is_not_finite_and_say_how_much() {
    let points = [[1.0, 2.0, 3.0], [f32::NAN, 0.0, 0.0], [-1.0, 0.0, 9.0], [0.0, f32::INFINITY, 0.0]];
    let (bounds, ignored) = Bounds::from_points(points);
    assert_eq!((bounds.min(), bounds.max()), (DVec3::new(-1.0, 0.0, 3.0), DVec3::new(1.0, 2.0, 9.0)));
    assert_eq!((ignored, bounds.center()), (2, Some(DVec3::new(0.0, 1.0, 6.0))));
    assert_eq!(bounds.diagonal(), DVec3::new(2.0, 2.0, 6.0).length());

    let (empty, ignored) = Bounds::from_points([[f32::NAN; 3]]);
    assert_eq!((empty, ignored), (Bounds::EMPTY, 1));
    assert_eq!((empty.center(), empty.size(), empty.diagonal()), (None, DVec3::ZERO, 0.0));
    assert_eq!(empty.union(&bounds), bounds);
    assert_eq!(empty.transformed(&DMat4::IDENTITY), Bounds::EMPTY);
    let point = Bounds::new(DVec3::ONE, DVec3::ONE);
    assert!(!point.is_empty() && point.size() == DVec3::ZERO && point.contains(DVec3::ONE));
    assert!(Bounds::new(DVec3::NAN, DVec3::ONE).is_empty());
}

#[test]
fn singular_matrices_have_no_inverse() {
    assert_eq!(Matrix::from_rows([[1.0, 2.0], [3.0, 6.0]]).inverse(), None);
    assert_eq!(Matrix::from_rows([[1.0, 2.0, 3.0], [4.0, 5.0, 6.0], [7.0, 8.0, 9.0]]).inverse(), None);
    assert_eq!(Matrix::from_rows([[0.1, 0.3], [0.2, 0.6]]).inverse(), None, "but for rounding");
    assert_eq!(Matrix::from_rows([[f64::NAN]]).inverse(), None);
    assert_eq!(Matrix::<2, 2>::ZERO.inverse(), None);
    assert_eq!(coordinates(&Matrix::from_columns([[1.0, 1.0], [2.0, 2.0]]), [1.0, 0.0]), None);
}

#[test]
fn badly_scaled_matrices_have_an_inverse() {
    let a = Matrix::from_rows([[1e-200, 2e-200], [3e100, 7e100]]);
    // The rows differ by 300 orders of magnitude; from the left the inverse takes that away again.
    let product = a.inverse().unwrap() * a;
    assert!((product - Matrix::identity()).max_abs() < 1e-12);
    let swap = Matrix::from_rows([[0.0, 1.0], [1.0, 0.0]]);
    assert_eq!((swap.inverse(), swap.determinant()), (Some(swap), -1.0));
}

#[test]
fn matrices_reckon_in_any_size() {
    let a = Matrix::from_rows([[1.0, 2.0, 3.0], [4.0, 5.0, 6.0]]);
    let b = Matrix::from_columns([[1.0, 0.0, 2.0]]);
    assert_eq!(a * b, Matrix::from_rows([[7.0], [16.0]]));
    assert_eq!((a.transpose()[(2, 1)], a[(1, 2)]), (6.0, 6.0));
    assert_eq!(a + a - a * 2.0, Matrix::ZERO);
    assert_eq!(0.5 * (a + a) + -a, Matrix::ZERO);
    assert_eq!(Matrix::from_rows([[1.0, 2.0], [2.0, 2.0]]).determinant(), -2.0);
    assert_eq!(Matrix::<0, 0>::identity().determinant(), 1.0);
}

proptest! {
    #[test]
    fn a_basis_is_orthonormal_and_right_handed_for_every_input(
        direction in wild_vector(), up in wild_vector(), tiny in -1e-8..1e-8,
    ) {
        // The second up is nearly parallel to the direction, where the naive cross product is mostly rounding.
        let unit = polosa_math::unit(direction).unwrap_or(DVec3::Z);
        for up in [up, unit + DVec3::new(tiny, 0.0, tiny * 0.3)] {
            let basis = Basis::looking(direction, up);
            let m = DMat3::from_cols(basis.right(), basis.up(), basis.back());
            prop_assert!(error(&m) < 4e-15, "{basis:?}");
            prop_assert!(m.determinant() > 0.0);
            if let Some(direction) = polosa_math::unit(direction) {
                prop_assert_eq!(basis.forward(), direction);
            }
        }
    }

    #[test]
    fn camera_axes_there_and_back(direction in vector(1.0), v in vector(100.0)) {
        let basis = Basis::looking(direction, DVec3::Y);
        prop_assert!((basis.to_world(basis.to_camera(v)) - v).length() < 1e-12);
    }

    #[test]
    fn heading_pitch_roll_there_and_back(q in rotation(), near_pole in -1e-6..1e-6) {
        let [h, p, r] = to_heading_pitch_roll(q);
        prop_assert!(apart(heading_pitch_roll(h, p, r), q) < 1e-14);
        let q = heading_pitch_roll(h, core::f64::consts::FRAC_PI_2 + near_pole, r);
        let [h, p, r] = to_heading_pitch_roll(q);
        prop_assert!(apart(heading_pitch_roll(h, p, r), q) < 1e-11);
    }

    #[test]
    fn a_turn_is_a_rotation_for_every_input(a in [wild(), wild(), wild(), wild()], b in [wild(), wild(), wild(), wild()]) {
        let q = turn(DQuat::from_array(a), DQuat::from_array(b));
        prop_assert!((q.length() - 1.0).abs() < 1e-15, "{q}");
        prop_assert!((normalized(DQuat::from_array(a)).length() - 1.0).abs() < 1e-15);
    }

    #[test]
    fn an_axis_angle_is_a_rotation_or_none(axis in wild_vector(), angle in wild()) {
        match axis_angle(axis, angle) {
            Some(q) => prop_assert!((q.length() - 1.0).abs() < 1e-15),
            None => prop_assert!(!axis.is_finite() || axis == DVec3::ZERO || !angle.is_finite()),
        }
    }

    #[test]
    fn a_placement_comes_back_from_its_matrix(p in placement()) {
        let back = Placement::from_matrix(&p.matrix()).unwrap();
        prop_assert!(back.matrix().abs_diff_eq(p.matrix(), 1e-12));
        prop_assert_eq!(back.translation, p.translation);
    }

    #[test]
    fn turning_and_scaling_about_a_point_keep_the_point(p in placement(), q in rotation(), at in vector(50.0)) {
        let local = p.matrix().inverse() * at.extend(1.0);
        for moved in [p.turned_about(q, at), p.scaled_about(1.75, at)] {
            prop_assert!((moved.to_world(local.truncate()) - at).length() < 1e-9);
        }
        prop_assert_eq!(p.turned(q).translation, p.translation);
        let other = DVec3::new(1.0, 2.0, 3.0);
        let by_matrix = at + q * (p.to_world(other) - at);
        prop_assert!((p.turned_about(q, at).to_world(other) - by_matrix).length() < 1e-9);
    }

    #[test]
    fn pixels_there_and_back(x in -5e3..5e3, y in -5e3..5e3, width in 1_u32..16384, height in 1_u32..16384) {
        let screen = Viewport::new(width, height);
        let [cx, cy] = screen.from_pixels([x, y]);
        let [bx, by] = screen.to_pixels(cx, cy, 1.0);
        prop_assert!((bx - x).abs() < 1e-9 && (by - y).abs() < 1e-9);
    }

    #[test]
    fn the_frustum_is_right_about_every_point_even_after_rounding_to_f32(
        p in placement(), eye in vector(20.0), direction in vector(1.0), half in [0.0..3.0, 0.0..3.0, 0.0..3.0],
        at in vector(20.0), parallel: bool, far in prop_oneof![Just(f64::INFINITY), 5.0..50.0],
        samples in prop::collection::vec([0.0..=1.0, 0.0..=1.0, 0.0..=1.0], 24),
    ) {
        let projection = if parallel {
            orthographic(9.0, 1.5, 0.5, far.min(1e3)).unwrap()
        } else {
            perspective_vertical(1.0, 1.5, 0.5, far).unwrap()
        };
        let turn = Basis::looking(direction, DVec3::Y).rotation();
        let exact = clip_from_model_f64(&projection, &turn, eye, &p);
        let rounded = clip_from_model(&projection, &turn, eye, &p);
        let frustum = Frustum::from_clip(&exact);
        let half = DVec3::from_array(half);
        let bounds = Bounds::new(at - half, at + half);
        let (as_box, as_ball) = (frustum.bounds(&bounds), frustum.sphere(at, half.length()));
        let mut inside_plane = [false; 6];
        for s in samples.iter().copied().chain([[0.0; 3], [1.0; 3], [0.0, 1.0, 0.0], [1.0, 0.0, 1.0]]) {
            let p = (bounds.min() + bounds.size() * DVec3::from_array(s)).min(bounds.max()).as_vec3();
            // f32 vertices may leave the box by their own rounding; take only those within it.
            if !bounds.contains(p.as_dvec3()) { continue; }
            let clip: [f32; 4] =
                core::array::from_fn(|r| ((rounded[0][r] * p.x + rounded[1][r] * p.y) + rounded[2][r] * p.z) + rounded[3][r]);
            let [x, y, z, w] = clip.map(f64::from);
            let signs = [w + x, w - x, w + y, w - y, w - z, z];
            for (seen, sign) in inside_plane.iter_mut().zip(signs) { *seen |= sign >= 0.0; }
            for answer in [as_box, as_ball] {
                if answer == Containment::Inside {
                    prop_assert!(signs.iter().all(|&s| s >= 0.0), "said inside: {clip:?}");
                }
            }
        }
        // Outside means: all of it beyond one and the same plane.
        if as_box == Containment::Outside || as_ball == Containment::Outside {
            prop_assert!(inside_plane.iter().any(|seen| !seen), "said outside");
        }
    }

    #[test]
    fn on_the_very_planes_the_frustum_does_not_contradict_f32(
        p in placement(), eye in vector(20.0), direction in vector(1.0), at in vector(20.0), which in 0_usize..5,
    ) {
        let projection = perspective_vertical(1.0, 1.5, 0.5, f64::INFINITY).unwrap();
        let turn = Basis::looking(direction, DVec3::Y).rotation();
        let rounded = clip_from_model(&projection, &turn, eye, &p);
        let frustum = Frustum::from_clip(&clip_from_model_f64(&projection, &turn, eye, &p));
        // Onto the plane, then to the nearest f32: as close a call as a vertex can be.
        let plane = frustum.planes().nth(which).unwrap();
        let vertex = (at - plane.normal * plane.distance(at)).as_vec3();
        let [x, y, z, w] = core::array::from_fn(|r| {
            f64::from(((rounded[0][r] * vertex.x + rounded[1][r] * vertex.y) + rounded[2][r] * vertex.z) + rounded[3][r])
        });
        let signs = [w + x, w - x, w + y, w - y, w - z];
        let point = vertex.as_dvec3();
        for answer in [frustum.bounds(&Bounds::new(point, point)), frustum.sphere(point, 0.0)] {
            match answer {
                Containment::Inside => prop_assert!(signs.iter().all(|&s| s >= 0.0)),
                Containment::Outside => prop_assert!(signs.iter().any(|&s| s < 0.0)),
                Containment::Crosses => {}
            }
        }
    }

    #[test]
    fn bounds_hold_their_points_before_and_after_a_map(
        points in prop::collection::vec([-1e3_f32..1e3, -1e3_f32..1e3, -1e3_f32..1e3], 1..20), p in placement(),
    ) {
        let (bounds, ignored) = Bounds::from_points(points.iter().copied());
        prop_assert_eq!(ignored, 0);
        let moved = bounds.transformed(&p.matrix());
        for point in points {
            let point = DVec3::from_array(point.map(f64::from));
            prop_assert!(bounds.contains(point));
            let near = p.to_world(point);
            let room = DVec3::splat(1e-9);
            prop_assert!(Bounds::new(moved.min() - room, moved.max() + room).contains(near));
        }
    }

    #[test]
    fn an_inverse_undoes(rows: [[i8; 4]; 4]) {
        let a = Matrix::from_rows(rows.map(|row| row.map(f64::from)));
        // Entries are integers: a determinant of magnitude 1 and more is not zero, and zero is.
        match a.inverse() {
            Some(inverse) => {
                let size = a.max_abs() * inverse.max_abs();
                prop_assert!((a * inverse - Matrix::identity()).max_abs() <= 1e-14 * size.max(1.0));
                prop_assert!(a.determinant().abs() > 0.5);
            }
            None => prop_assert!(a.determinant().abs() < 0.5),
        }
    }

    #[test]
    fn coordinates_give_the_vector_back(columns in [vector(1.0), vector(1.0), vector(1.0)], v in vector(1.0)) {
        let basis = Matrix::from_columns(columns.map(|c| c.to_array()));
        prop_assume!(basis.determinant().abs() > 1e-3);
        let c = coordinates(&basis, v.to_array()).unwrap();
        let again = columns[0] * c[0] + columns[1] * c[1] + columns[2] * c[2];
        prop_assert!((again - v).length() < 1e-10);
    }

    #[test]
    fn general_matrices_agree_with_glams(a in placement(), b in placement()) {
        let ours = |m: DMat4| Matrix::from_columns(m.to_cols_array_2d());
        let (a, b) = (a.matrix(), b.matrix());
        let product = ours(a) * ours(b) - ours(a * b);
        prop_assert!(product.max_abs() < 1e-9);
        let det = a.determinant();
        prop_assert!((ours(a).determinant() - det).abs() <= 1e-12 * det.abs().max(1.0));
        prop_assert!((a * DVec4::W).w == 1.0);
    }
}
