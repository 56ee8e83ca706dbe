//! A cube after a million small turns: what is left of it, and where it points.

use polosa_math::reference::algebra::apply;
use polosa_math::reference::rotation::{Turned, Turning, apart, orthogonality};

use super::cameras::{corners, cube};
use super::kit::{Drawing, GREY, INK, Made, PAPER, Panel, RED, sheet};

const SIZE: [u32; 2] = [190, 190];
const STEPS: u32 = 1_000_000;
/// Radians a step, numbers that an `f32` holds.
const BY: [f64; 2] = [1.0 / 64.0, 1.0 / 128.0];

/// The cube by a way of turning, where it should be, and both around one corner, fourteen times as large.
fn after_a_million(turning: Turning) -> Made {
    let mut turned = Turned::new(turning);
    (0..STEPS).for_each(|_| turned.step(BY[0], BY[1]));
    let (m, right) = (turned.matrix(), turning.exact(BY[0], BY[1], STEPS));
    let mut used = Turned::new(Turning::default());
    (0..STEPS).for_each(|_| used.step(BY[0], BY[1]));
    assert!(orthogonality(&used.matrix()) < 1e-5 && apart(&used.matrix(), &right) < 1e-9);

    // Seen along z, in parallel.
    let places = |m: &[[f64; 3]; 3]| {
        corners().map(|p| {
            let [x, y, _] = apply(m, p);
            [95.0 + 52.0 * x, 95.0 - 52.0 * y]
        })
    };
    let (wrong, exact) = (places(&m), places(&right));
    let farthest = (0..8)
        .fold(0, |most, k| if off(wrong[k], exact[k]) > off(wrong[most], exact[most]) { k } else { most });
    let closer = |places: &[[f64; 2]; 8]| {
        places.map(|p| [0, 1].map(|axis| 95.0 + 14.0 * (p[axis] - exact[farthest][axis])))
    };
    let blank = || Panel::new(SIZE, |_, _| PAPER);
    let figures = format!(
        "{turning}: ‖MMᵀ − 1‖ = {:.1e}, an axis points {:.2}° beside its direction",
        orthogonality(&m),
        apart(&m, &right).to_degrees()
    );
    let panels = [
        cube(cube(blank(), &exact, GREY), &wrong, RED),
        cube(cube(blank(), &closer(&exact), INK), &closer(&wrong), RED),
        cube(blank(), &places(&used.matrix()), INK),
    ];
    Ok(Drawing { picture: sheet(&panels, 1)?, figures })
}

fn off([ax, ay]: [f64; 2], [bx, by]: [f64; 2]) -> f64 {
    (ax - bx) * (ax - bx) + (ay - by) * (ay - by)
}

/// The matrix times that of each step, in `f32`: no rotation any more.
pub(crate) fn matrix() -> Made {
    after_a_million(Turning::MatrixF32)
}

/// S2's two axes in `f32`: still a cube, elsewhere.
pub(crate) fn wander() -> Made {
    after_a_million(Turning::AxesF32)
}
