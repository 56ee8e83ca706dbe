//! Triangles about as small as a pixel, or smaller.

use crate::inputs::classes::permuted;
use crate::inputs::rng::Rng;
use crate::judge::{Judge, Outcome};
use crate::oracle::coverage::Vertex;

/// 36 triangles around a pixel's sample, and 600 with corners on a lattice of 1/4 px inside 2 × 2 px.
///
/// For each of twelve directions d, with n to its right:
///
/// ```text
///   an edge through the sample      a corner on it       an edge whose extension meets it
///
///   −d ──── P ──── d                P                    P     d ─── 2d
///     ╲           ╱                 │╲                          ╲    │
///       ╲       ╱                   │  ╲                          ╲  │
///           n                      d−n  d+n                        d+n
/// ```
pub(super) fn micro(judge: &mut Judge<'_>) -> Outcome {
    let p = judge.sample.map(|c| c + 256);
    let quarter = |a: i64, b: i64| [p[0] + 64 * a, p[1] + 64 * b];
    let mut number = 0;
    for (a, b) in (-2_i64..=2).flat_map(|a| (-2_i64..=2).map(move |b| (a, b))) {
        if ![4, 5].contains(&(a * a + b * b)) {
            continue; // Twelve remain: (±2, 0), (0, ±2), (±2, ±1), (±1, ±2).
        }
        let n = [-b, a];
        let side = quarter(a + n[0], b + n[1]);
        let triangles = [
            [quarter(-a, -b), quarter(a, b), quarter(n[0], n[1])],
            [p, side, quarter(a - n[0], b - n[1])],
            [quarter(a, b), quarter(2 * a, 2 * b), side],
        ];
        for t in triangles {
            judge.compare([4, 4], &permuted(&t, number), [0.5; 3])?;
            number += 1;
        }
    }
    let mut r = Rng::new(75);
    for k in 0..600 {
        let t = [(); 3].map(|()| [256 + 64 * r.range(0, 8), 256 + 64 * r.range(0, 8)]);
        judge.compare([4, 4], &permuted(&t, k), [0.5; 3])?;
    }
    Ok(())
}

/// Long triangles between two rows, two columns or two diagonals of samples: no sample is inside.
///
/// ```text
///   ·     ·     ·     ·     ·     ·        samples
///    ══════════════════════════════        1/256 to 255/256 px thick
///   ·     ·     ·     ·     ·     ·
/// ```
pub(super) fn between(judge: &mut Judge<'_>) -> Outcome {
    let mut r = Rng::new(76);
    for k in 0..120 {
        let [sx, sy] = judge.sample;
        let low = r.range(1, 254);
        let high = r.range(low + 1, 255);
        // Along a row from the left border of the picture to its right one, `v` sub-pixels below the samples.
        let row = 256 * r.range(4, 58);
        let along = |u: i64, v: i64| match k % 3 {
            0 => [u, row + sy + v],
            1 => [row + sx + v, u],
            // Along a diagonal the samples lie at whole multiples of 256 in x − y.
            _ => [u + sx, u + sy + v],
        };
        let t: [Vertex; 3] = [along(0, low), along(63 * 256, low), along(r.range(0, 63 * 256), high)];
        judge.compare([64, 64], &permuted(&t, k), [0.5; 3])?;
    }
    Ok(())
}
