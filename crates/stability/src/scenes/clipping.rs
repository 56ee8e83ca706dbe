//! Triangles that reach beyond the viewport, the near and far planes, and the eye.

use crate::inputs::circle::{part, turn, turns};
use crate::inputs::rng::Rng;
use crate::judge::{ALONE, Judge, Outcome, Times, place};
use crate::oracle::coverage::{Vertex, covers, near_boundary, sample_point};
use crate::oracle::homogeneous::{ALL, Homogeneous, SNAP};

const SIZE: [u32; 2] = [64, 64];

/// cos and sin of 6°.
const SIX_DEGREES: [f64; 2] = [0.994_521_895_368_273_3, 0.104_528_463_267_653_47];

/// A quad around the viewport in clip space, `half` as large as its side, turned by `steps` times 6°.
fn around(half: f64, steps: u32) -> [[f32; 4]; 4] {
    let angle = turns(SIX_DEGREES, steps);
    [[-1.0, -1.0], [1.0, -1.0], [1.0, 1.0], [-1.0, 1.0]].map(|corner| {
        let [x, y] = turn(corner, angle).map(|c| (half * c) as f32);
        [x, y, 0.5, 1.0]
    })
}

fn fills_the_viewport(judge: &mut Judge<'_>, v: &[[f32; 4]; 4]) -> Outcome {
    for cut in [[[0, 1, 2], [0, 2, 3]], [[1, 2, 3], [3, 0, 1]], [[2, 1, 0], [0, 2, 3]]] {
        judge.mesh(SIZE, v, &cut, |_| Times::Once)?;
    }
    Ok(())
}

/// Turned by 0°, 6°, … 84°: up to 28,800 px from the middle, less than Direct3D's 16.8 bits hold.
pub(super) fn full(judge: &mut Judge<'_>) -> Outcome {
    for half in [2.0, 100.0, 640.0] {
        for step in 0..15 {
            fills_the_viewport(judge, &around(half, step))?;
        }
    }
    Ok(())
}

/// The same far beyond any guard band.
pub(super) fn largest(judge: &mut Judge<'_>) -> Outcome {
    for half in [1e4, 1e6, 1e9, 1e18, 1e30] {
        for step in [0, 1, 7, 11] {
            fills_the_viewport(judge, &around(half, step))?;
        }
    }
    fills_the_viewport(judge, &around(f64::from(f32::MAX), 0))
}

/// Draws a convex quad of two triangles, 0 1 2 and 2 3 0, and compares each pixel with `lines` of both. The shared
/// edge is opposite vertex 1 of each; the planes' lines are the same on both sides of it only if the quad is flat.
///
/// Quads are made until neither half is seen edge-on, where there are no lines: so none is passed over.
fn compare_quad(judge: &mut Judge<'_>, mut quad: impl FnMut() -> [[i64; 4]; 4], lines: &[usize]) -> Outcome {
    let (halves, one, two) = loop {
        let v = quad();
        let halves = [[v[0], v[1], v[2]], [v[2], v[3], v[0]]];
        let oracles = halves.map(|half| Homogeneous::new(&half, SIZE[0].into(), SIZE[1].into()));
        if let [Some(one), Some(two)] = oracles {
            break (halves, one, two);
        }
    };
    let [a, b] = halves.map(|half| Homogeneous::clip(&half));
    judge.mesh(SIZE, &[a[0], a[1], a[2], b[1]], &[[0, 1, 2], [2, 3, 0]], |p| {
        let by = one.point_inside_by(lines, p).min(two.point_inside_by(lines, p));
        match by {
            _ if by < -SNAP => Times::Never,
            _ if by > SNAP => Times::Once,
            _ => Times::AtMostOnce,
        }
    })
}

/// A quad in perspective: w is 1/10 at one side, 4 at the other. Its diagonal is drawn once.
pub(super) fn projected(judge: &mut Judge<'_>) -> Outcome {
    let mut r = Rng::new(90);
    for _ in 0..40 {
        let corners = [(-0.9, -0.8, 410), (0.9, -0.7, 410), (0.8, 0.9, 16_384), (-0.7, 0.8, 16_384)];
        let quad = || {
            corners.map(|(x, y, w)| {
                let mut beside = |c: f64| ((c + r.real(-0.2, 0.2)) * f64::from(w)) as i64;
                [beside(x), beside(y), 200, i64::from(w)]
            })
        };
        compare_quad(judge, quad, &[0, 2])?;
    }
    Ok(())
}

/// Whole pixels up to ±2,000,000: exact in `f32`, and no rounding in the oracle either.
pub(super) fn beyond(judge: &mut Judge<'_>) -> Outcome {
    let mut r = Rng::new(91);
    for _ in 0..100 {
        let reach = [40_000, 200_000, 2_000_000][r.index(3)];
        let mut t: [Vertex; 3] =
            [(); 3].map(|()| [256 * r.range(-reach, reach), 256 * r.range(-reach, reach)]);
        if r.index(3) > 0 {
            t[r.index(3)] = [256 * r.range(-10, 80), 256 * r.range(-10, 80)];
        }
        let drawn = judge.draw(SIZE, &t.map(|v| place(v, SIZE, 0.5)), &ALONE)?;
        for (pixel, &id) in drawn.ids.iter().enumerate() {
            let (i, j) = (pixel as i64 % 64, pixel as i64 / 64);
            let same = id == u32::from(covers(&t, i, j, judge.sample));
            judge.check(same || (id <= 1 && near_boundary(&t, sample_point(i, j, judge.sample), 1)));
        }
    }
    Ok(())
}

/// Draws a triangle alone and compares it with its lines in homogeneous coordinates, which need no clipping.
fn compare(judge: &mut Judge<'_>, v: &[[i64; 4]; 3]) -> Outcome {
    let drawn = judge.draw(SIZE, &Homogeneous::clip(v), &ALONE)?;
    let oracle = Homogeneous::new(v, SIZE[0].into(), SIZE[1].into());
    for (pixel, &id) in drawn.ids.iter().enumerate() {
        let p = judge.sample_of(pixel, SIZE[0]);
        let by = oracle.as_ref().map_or(f64::NEG_INFINITY, |oracle| oracle.point_inside_by(&ALL, p));
        judge.check(id <= 1 && ((id == 1) == (by >= 0.0) || by.abs() <= SNAP));
    }
    Ok(())
}

/// A floor one unit below the eye from five units behind it to 1,000 ahead; then random floors and walls.
///
/// ```text
///   above the horizon: nothing (a bow-tie shows there if vertices behind the eye are divided by w)
///   ──────────────────────────────── horizon
///   below: the floor
/// ```
pub(super) fn floor(judge: &mut Judge<'_>) -> Outcome {
    let unit = 4096;
    let floor = |x: i64, w: i64| [x * unit, -unit, unit / 16, w * unit];
    let v = [floor(-7, -5), floor(2000, -5), floor(998, 1000), floor(-2000, 1000)];
    compare(judge, &[v[0], v[1], v[2]])?;
    compare(judge, &[v[0], v[2], v[3]])?;
    let mut r = Rng::new(92);
    for _ in 0..80 {
        let (turn, height) = (r.index(2), r.range(-40_000, 40_000));
        let v = [(); 3].map(|()| {
            let across = r.range(-100_000, 100_000);
            let [x, y] = if turn == 0 { [across, height] } else { [height, across] };
            [x, y, 400, r.range(-40_000, 80_000)]
        });
        compare(judge, &v)?;
    }
    Ok(())
}

/// Vertices before the near plane, behind the eye, beyond the far plane.
pub(super) fn vertices(judge: &mut Judge<'_>) -> Outcome {
    let mut r = Rng::new(93);
    for _ in 0..100 {
        let v = [(); 3].map(|()| {
            let w = [r.range(-4_096, 20_000), r.range(1, 20_000)][r.index(2)];
            let reach = 2 * w.abs() + 100;
            [r.range(-reach, reach), r.range(-reach, reach), r.range(-6_000, 20_000), w]
        });
        compare(judge, &v)?;
    }
    Ok(())
}

/// Parallelograms through the near plane, the far plane or beyond the guard band. Were the shared edge cut otherwise
/// from its two sides, holes and doubles would line it.
pub(super) fn both_sides(judge: &mut Judge<'_>) -> Outcome {
    let mut r = Rng::new(94);
    for round in 0..90 {
        let quad = || {
            let mut corner = |reach: i64| {
                let z = [r.range(-3_000, 30_000), 300][r.index(2)];
                [r.range(-reach, reach), r.range(-reach, reach), z, r.range(-20_000, 60_000)]
            };
            let reach = if round % 3 == 0 { 50_000 } else { 2_000_000 };
            let [mut a, mut b, mut c] = [corner(reach), corner(reach), corner(reach)];
            if round % 3 == 2 {
                // Only one of the two is cut, and the shared edge ends on the near plane or a hair inside of it.
                let mut at = |w: i64, reach: i64| [r.range(-reach, reach), r.range(-reach, reach), 300, w];
                (a, b, c) = (at(300 + round, 600), at(290 - 5 * round, 600), at(300 + round % 4, 300));
            }
            let d = [0, 1, 2, 3].map(|k| a[k] + c[k] - b[k]);
            [a, b, c, d]
        };
        compare_quad(judge, quad, &[0, 2, 3, 4])?;
    }
    Ok(())
}

/// A closed fan around a point in sight, its rim behind the eye: the whole picture, once.
pub(super) fn rim(judge: &mut Judge<'_>) -> Outcome {
    let mut r = Rng::new(95);
    for round in 0..30 {
        let halvings = 2 + round % 4;
        let spokes = 1 << halvings;
        let mut v = vec![[r.real(-0.5, 0.5) as f32, r.real(-0.5, 0.5) as f32, 0.01, 4.0]];
        for k in 0..spokes {
            let [x, y] = turns(part(halvings), k).map(|c| 4.0 * c as f32);
            v.push([x, y, 0.01, r.real(-1.0, -0.1) as f32]);
        }
        let triangles: Vec<_> = (0..spokes).map(|k| [0, 1 + k, 1 + (k + 1) % spokes]).collect();
        judge.mesh(SIZE, &v, &triangles, |_| Times::Once)?;
    }
    Ok(())
}
