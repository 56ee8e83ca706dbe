//! Claim: a fragment's weights are perspective-correct, to 2⁻²⁰ relative, also where w varies a
//! hundredfold and where the triangle is clipped.
//!
//! Judge: exact edge values over w, in `f64` ([`support::plane`]); for clipped triangles the
//! homogeneous weights ([`support::homogeneous`]), taken anywhere within the snap of the pixel.

mod support;

use polosa_math::{Matrix, coordinates};
use polosa_raster::{Depth, Fragment, Sample, State, Target};
use support::classes::{CLASSES, permuted, triangle};
use support::homogeneous::{Homogeneous, SNAP};
use support::oracle::{CENTRE, Vertex};
use support::picture::{on_screen, screen};
use support::plane::weights;
use support::rng::Rng;

const WIDTH: usize = 48;
const HEIGHT: usize = 40;

/// Draws a triangle and returns the weights of its pixels.
fn drawn(state: &State, v: &[[f32; 4]; 3]) -> Vec<(i64, i64, [f32; 3])> {
    let mut pixels = vec![None; WIDTH * HEIGHT];
    let depth = Depth::None;
    let mut target = Target::new(&mut pixels, depth, WIDTH as u32, HEIGHT as u32, WIDTH).unwrap();
    target.triangles(state, v, &[[0, 1, 2]], &|f: &Fragment<'_>, p: &mut Option<_>| {
        *p = Some((i64::from(f.x()), i64::from(f.y()), f.weights()));
        true
    });
    pixels.into_iter().flatten().collect()
}

#[track_caller]
fn sums_to_one(w: [f32; 3]) {
    let sum: f64 = w.iter().map(|&w| f64::from(w)).sum();
    assert!((sum - 1.0).abs() <= 2_f64.powi(-22), "{w:?} add up to {sum}");
    assert!(w.iter().all(|w| (0.0..=1.0).contains(w)), "{w:?}");
}

#[track_caller]
fn equal_the_oracle(t: &[Vertex; 3], w: [f32; 3], sample: [i64; 2]) -> usize {
    let v = [0, 1, 2].map(|k| {
        let [x, y, z, _] = screen(t[k], 0.5);
        [x, y, z, w[k]]
    });
    let [x, y] = sample.map(|s| u8::try_from(s).unwrap());
    let pixels = drawn(&State { sample: Sample { x, y }, ..on_screen() }, &v);
    for &(i, j, got) in &pixels {
        sums_to_one(got);
        let exact = weights(t, w, i, j, sample);
        for k in 0..3 {
            let error = (f64::from(got[k]) - exact[k]).abs();
            assert!(error <= exact[k] * 2_f64.powi(-20), "{t:?} {w:?} at ({i}, {j}): {got:?}, not {exact:?}");
        }
    }
    pixels.len()
}

#[test]
fn weights_at_a_w_ratio_of_100_equal_the_oracle() {
    let mut r = Rng::new(110);
    let mut pixels = 0;
    for k in 0..3_000 {
        let t = permuted(&triangle(CLASSES[k % 10], &mut r, WIDTH as i64, HEIGHT as i64), k);
        let w = permuted(&[1.0, 100.0, 2_f64.powf(r.real(0.0, 6.6)) as f32], k / 6);
        pixels += equal_the_oracle(&t, w, CENTRE);
    }
    assert!(pixels > 200_000, "{pixels} px");
}

#[test]
fn weights_at_every_sample_position_equal_the_oracle() {
    let mut r = Rng::new(111);
    for k in 0..1_000 {
        let t = permuted(&triangle(CLASSES[k % 10], &mut r, WIDTH as i64, HEIGHT as i64), k);
        let w = [(); 3].map(|()| 2_f64.powf(r.real(-10.0, 10.0)) as f32);
        equal_the_oracle(&t, w, [r.range(0, 255), r.range(0, 255)]);
    }
}

#[test]
fn equal_w_gives_the_weights_of_the_screen() {
    let t: [Vertex; 3] = [[0, 0], [40 * 256, 0], [0, 40 * 256]];
    for w in [1e-30, 1.0, 1e30] {
        equal_the_oracle(&t, [w; 3], CENTRE);
    }
}

/// No ratio of w leads to a NaN or to weights that do not add up to one.
#[test]
fn extreme_ratios_of_w_leave_weights_that_add_up_to_one() {
    let t: [Vertex; 3] = [[0, 0], [40 * 256, 128], [300, 39 * 256]];
    let extremes = [f32::MIN_POSITIVE, f32::from_bits(1), 1e-30, 1.0, 1e30, f32::MAX];
    for a in extremes {
        for b in extremes {
            let v = [[0.0, 0.0, 0.0, a], [40.0, 0.5, 0.0, b], [300.0 / 256.0, 39.0, 0.0, 1.0]];
            let pixels = drawn(&on_screen(), &v);
            assert!(pixels.len() > 500, "{t:?}");
            for (_, _, w) in pixels {
                sums_to_one(w);
            }
        }
    }
}

#[test]
fn weights_of_clipped_triangles_are_those_of_the_whole() {
    let mut r = Rng::new(112);
    let (mut pixels, mut close) = (0, 0);
    for _ in 0..1_500 {
        let v = [(); 3].map(|()| {
            let w = r.range(-10_000, 40_000);
            [r.range(-60_000, 60_000), r.range(-60_000, 60_000), 300, w]
        });
        let Some(oracle) = Homogeneous::new(&v, WIDTH as i64, HEIGHT as i64) else { continue };
        if !v.iter().any(|v| v[3] < 300) {
            continue;
        }
        for (i, j, got) in drawn(&State::default(), &Homogeneous::clip(&v)) {
            sums_to_one(got);
            // The pixel has the weights of a point of the true triangle within the snap of it; these
            // are quotients of linear functions, extreme on the border of that neighbourhood.
            let (x, y) = (i as f64 + 0.5, j as f64 + 0.5);
            let exact = oracle.weights(x, y);
            let mut spread = [0.0_f64; 3];
            for step in 0..16 {
                let (sin, cos) = (std::f64::consts::TAU * f64::from(step) / 16.0).sin_cos();
                // 1.03: sixteen points come this near to a circle.
                let beside = oracle.weights(x + 1.03 * SNAP * cos, y + 1.03 * SNAP * sin);
                spread = [0, 1, 2].map(|k| spread[k].max((beside[k] - exact[k]).abs()));
            }
            for k in 0..3 {
                let error = (f64::from(got[k]) - exact[k]).abs();
                // A pixel beside the true edge has its weights clamped to the snapped one.
                let outside = (-exact[k]).max(0.0);
                assert!(
                    error <= spread[k] + outside + 2_f64.powi(-20),
                    "{v:?} at ({i}, {j}): {got:?}, not {exact:?} ± {spread:?}"
                );
                close += usize::from(error < 1e-4);
            }
            pixels += 1;
        }
    }
    assert!(pixels > 100_000 && close > 2 * pixels, "{pixels} px, {close} weights within 1e-4");
}

/// Cut exactly on the sub-pixel grid, nothing is moved by the snap: the same 2⁻²⁰.
#[test]
fn weights_of_a_triangle_cut_on_the_grid_keep_the_bound() {
    // A floor, 40 px below the eye at w = 1, through the near plane at w = 1: the picture is 48 × 40.
    // x/w = −1, 1 and y/w = −1 at the cut, so that its ends lie on the picture's lower corners.
    let floor = |x: f32, w: f32| [x, -1.0, 1.0, w];
    // Both cuts are at t = ½, on (−1, −1, 1, 1) and (1, −1, 1, 1).
    let v = [floor(-3.0, -2.0), floor(1.0, 4.0), floor(1.0, -2.0)];
    let pixels = drawn(&State::default(), &v);
    let unit = |v: [f32; 4]| v.map(|c| (f64::from(c) * 4096.0) as i64);
    let oracle = Homogeneous::new(&v.map(unit), WIDTH as i64, HEIGHT as i64).unwrap();
    assert!(pixels.len() > 300, "{} px", pixels.len());
    for (i, j, got) in pixels {
        let exact = oracle.weights(i as f64 + 0.5, j as f64 + 0.5);
        for k in 0..3 {
            let error = (f64::from(got[k]) - exact[k]).abs();
            assert!(error <= exact[k].abs() * 2_f64.powi(-20), "({i}, {j}): {got:?}, not {exact:?}");
        }
    }
}

/// Another judge, by linear algebra alone: in clip space a pixel is a direction (x, y, 1), and its coordinates in the
/// basis of the vertices' (x, y, w) are the weights, but for a factor (Olano and Greer, 1997).
#[test]
fn weights_are_a_pixels_coordinates_in_the_basis_of_the_vertices() {
    const SIDE: u32 = 64;
    let mut rng = Rng::new(23);
    let mut seen = 0;
    for _ in 0..400 {
        // On the sub-pixel grid of a picture of 64 × 64, and w a power of two: snapping moves nothing.
        let v = [0; 3].map(|_| {
            let [x, y] = [0; 2].map(|_| (rng.bits() % (1 << 14)) as f32 / (1 << 13) as f32 - 1.0);
            let w = (1_u32 << (rng.bits() % 7)) as f32;
            [x * w, y * w, 0.5 * w, w]
        });
        let basis = Matrix::from_columns(v.map(|[x, y, _, w]| [x, y, w].map(f64::from)));
        let mut pixels = vec![None; (SIDE * SIDE) as usize];
        let mut target = Target::new(&mut pixels, Depth::None, SIDE, SIDE, SIDE as usize).unwrap();
        let keep = |f: &Fragment<'_>, p: &mut Option<_>| {
            *p = Some((f.x(), f.y(), f.weights()));
            true
        };
        target.triangles(&State::default(), &v, &[[0, 1, 2]], &keep);
        for (x, y, got) in pixels.into_iter().flatten() {
            let [x, y] = [x, y].map(|k| (f64::from(k) + 0.5) / 32.0);
            let exact = coordinates(&basis, [x - 1.0, 1.0 - y, 1.0]).expect("drawn, so it has an area");
            let sum: f64 = exact.iter().sum();
            for (got, exact) in got.into_iter().zip(exact) {
                assert!(
                    (f64::from(got) - exact / sum).abs() < 2_f64.powi(-20),
                    "{v:?}: {got}, not {}",
                    exact / sum
                );
            }
            seen += 1;
        }
    }
    assert!(seen > 50_000, "{seen}");
}
