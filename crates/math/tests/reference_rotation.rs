//! Ways to turn by a million steps, each failure asserted as a failure of the way that has it.

use std::f64::consts::PI;

use polosa_math::glam::{DMat3, DQuat, DVec3};
use polosa_math::reference::algebra::{Rows, product, transposed};
use polosa_math::reference::rotation::{Turned, Turning, apart, orthogonality};
use polosa_math::{axis_angle, turn};
use proptest::prelude::*;

const MILLION: u32 = 1_000_000;

/// Steps that an `f32` holds, so that only what accumulates is seen: about one axis, and about two.
const ONE: [f64; 2] = [1.0 / 64.0, 0.0];
const TWO: [f64; 2] = [1.0 / 64.0, 1.0 / 128.0];

/// Asserts both what a million steps do to a method at least, and at most: ‖MMᵀ−1‖ and radians.
#[track_caller]
fn drifts(turning: Turning, [dx, dy]: [f64; 2], orthogonality: [f64; 2], angle: [f64; 2]) {
    let drift = turning.drift(dx, dy, MILLION);
    for (what, x, [least, most]) in
        [("‖MMᵀ−1‖", drift.orthogonality, orthogonality), ("angle", drift.angle, angle)]
    {
        assert!(least <= x && x <= most, "{turning}: {what} is {x:e}, not {least:e} to {most:e}");
    }
}

#[test]
fn scene_21_a_million_steps_of_the_default_keep_a_rotation() {
    assert_eq!(Turning::default(), Turning::Quaternion);
    for [dx, dy] in [ONE, TWO, [0.0, 1e-3], [PI / 180.0; 2], [2.0, -3.0]] {
        let drift = Turning::default().drift(dx, dy, MILLION);
        // The claim is 10⁻⁵; what is kept is ten decimal digits better.
        assert!(drift.orthogonality < 4e-15, "{dx} {dy}: {}", drift.orthogonality);
        assert!(drift.angle < 1e-9, "{dx} {dy}: {}", drift.angle);
    }
}

#[test]
fn the_default_is_the_turn_that_objects_are_turned_by() {
    let mut turned = Turned::new(Turning::default());
    let mut rotation = DQuat::IDENTITY;
    for i in 0..1000 {
        let (dx, dy) = (f64::from(i) * 1e-3, 0.01);
        turned.step(dx, dy);
        let y = axis_angle(DVec3::Y, -dx).unwrap();
        let x = axis_angle(DVec3::X, dy).unwrap();
        rotation = turn(y.mul_quat(x), rotation);
        assert_eq!(transposed(&turned.matrix()), DMat3::from_quat(rotation).to_cols_array_2d());
    }
}

#[test]
fn absolute_angles_do_not_drift() {
    for [dx, dy] in [ONE, TWO, [PI / 180.0; 2]] {
        drifts(Turning::Angles, [dx, dy], [0.0, 1e-15], [0.0, 1e-11]);
    }
}

#[test]
fn matrices_in_f32_shrink_by_a_hundredth() {
    drifts(Turning::MatrixF32, ONE, [6.5e-3, 7.5e-3], [2.5e-4, 3.5e-4]);
    drifts(Turning::MatrixF32, TWO, [1.1e-2, 1.3e-2], [1.4e-3, 1.7e-3]);
}

#[test]
fn matrices_in_f64_drift_too_a_hundred_million_times_less() {
    drifts(Turning::MatrixF64, ONE, [8e-11, 1e-10], [0.0, 1e-11]);
    drifts(Turning::MatrixF64, TWO, [1.4e-10, 1.8e-10], [0.0, 1e-11]);
}

#[test]
fn axes_in_f32_stay_near_a_rotation_and_point_elsewhere() {
    drifts(Turning::AxesF32, ONE, [5e-8, 2e-7], [2.5e-4, 3e-4]);
    // About two axes the second is bent at each step, and the wandering is a hundredfold: 2.6 degrees.
    drifts(Turning::AxesF32, TWO, [4e-6, 6e-6], [4.2e-2, 4.8e-2]);
}

#[test]
fn quaternions_in_f32_stay_a_rotation_and_point_elsewhere() {
    drifts(Turning::QuaternionF32, ONE, [1e-8, 5e-7], [2.5e-4, 3e-4]);
    drifts(Turning::QuaternionF32, TWO, [1e-8, 5e-7], [6e-3, 7e-3]);
}

#[test]
fn axes_mend_themselves_by_large_steps_and_not_by_small_ones() {
    // What rounding adds to X·Y, each step multiplies by cos dx.
    let not_square = |steps: u32, dx: f64, dy: f64| {
        let mut turned = Turned::new(Turning::AxesF32);
        (0..steps).for_each(|_| turned.step(dx, dy));
        orthogonality(&turned.matrix())
    };
    let worst = (1..=64).map(|n| not_square(n * 1000, 0.5, 0.25)).fold(0.0, f64::max);
    assert!(worst < 1e-6, "{worst:e}: by large steps it stays where one rounding brings it");
    let worst = (1..=64).map(|n| not_square(n * 1000, 1e-3, 5e-4)).fold(0.0, f64::max);
    assert!(worst > 1e-6, "{worst:e}: by small ones it grows");
}

#[test]
fn absolute_angles_lock_where_the_others_turn_on() {
    // Nose straight up: what was a turn about Y is now one about the line of sight.
    let after = |turning| {
        let mut turned = Turned::new(turning);
        turned.step(0.0, PI / 2.0);
        let before = turned.matrix();
        turned.step(0.1, 0.0);
        let step = product(&transposed(&before), &turned.matrix());
        // The part of the step that is about the thing's own Y.
        step[2][0]
    };
    assert!(after(Turning::Angles).abs() < 1e-15);
    for turning in Turning::ALL.iter().copied().filter(|&t| t != Turning::Angles) {
        assert!((after(turning) - 0.1_f64.sin()).abs() < 1e-6, "{turning}");
    }
}

#[test]
fn names_are_those_of_the_command_line() {
    for turning in Turning::ALL {
        assert!(turning.name().chars().all(|c| c.is_ascii_lowercase() || c.is_ascii_digit() || c == '-'));
        assert!(!turning.about().contains('\n') && turning.about().len() > 20);
        assert_eq!(turning.to_string(), turning.name());
        assert_eq!(Turning::ALL.iter().filter(|t| t.name() == turning.name()).count(), 1);
    }
    assert_eq!(Turning::ALL[0], Turning::default());
}

fn is_close(a: &Rows<f64, 3>, b: &Rows<f64, 3>, error: f64) -> bool {
    a.as_flattened().iter().zip(b.as_flattened()).all(|(a, b)| (a - b).abs() <= error)
}

proptest! {
    #[test]
    fn one_step_is_the_same_turn_in_all_ways(dx in -3.0..3.0_f64, dy in -1.5..1.5_f64) {
        let exact = Turning::Quaternion.exact(dx, dy, 1);
        for &turning in Turning::ALL {
            let mut turned = Turned::new(turning);
            turned.step(dx, dy);
            let m = turned.matrix();
            prop_assert!(is_close(&m, &exact, 1e-6), "{}: {:?} is not {:?}", turning, m, exact);
            prop_assert!(is_close(&turning.exact(dx, dy, 1), &exact, 1e-14));
        }
    }

    #[test]
    fn several_steps_are_where_the_exact_ones_are(dx in -0.5..0.5_f64, dy in -0.5..0.5_f64, steps in 0..200_u32) {
        for &turning in Turning::ALL {
            let drift = turning.drift(dx, dy, steps);
            prop_assert!(drift.angle < 2e-4, "{}: {:?}", turning, drift);
        }
        prop_assert!(Turning::MatrixF64.drift(dx, dy, steps).angle < 1e-12);
    }

    #[test]
    fn the_angle_apart_is_the_angle(angle in 0.0..3.1_f64, scale in 0.1..10.0_f64) {
        let (sin, cos) = angle.sin_cos();
        let a = [[scale, 0.0, 0.0], [0.0, scale, 0.0], [0.0, 0.0, scale]];
        let b = [[cos, 0.0, -sin], [0.0, 1.0, 0.0], [sin, 0.0, cos]];
        prop_assert!((apart(&a, &b) - angle).abs() < 1e-12);
        let off = (scale * scale - 1.0).abs() * 3_f64.sqrt();
        prop_assert!((orthogonality(&a) - off).abs() < 1e-12);
    }

    #[test]
    fn no_angle_panics(dx in any::<f64>(), dy in any::<f64>()) {
        for &turning in Turning::ALL {
            let _ = turning.drift(dx, dy, 3);
        }
    }
}
