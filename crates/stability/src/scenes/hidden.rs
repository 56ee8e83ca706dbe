//! Which of several triangles is seen.

use crate::inputs::classes::triangle;
use crate::inputs::rng::Rng;
use crate::judge::{Judge, Outcome, place};
use crate::oracle::coverage::{Vertex, area2, covers, near_boundary, sample_point};
use crate::oracle::depth::{depth, numerators};

const SIZE: [u32; 2] = [64, 64];

/// A snapped triangle and the depths of its vertices.
type Deep = ([Vertex; 3], [f32; 3]);

/// Draws triangles together: each pixel must show the nearest that covers it.
///
/// Where another one is nearer than 2⁻²⁰ to that, relative, either may be seen: a depth may be wrong by 5·2⁻²⁴.
fn shows_nearest(judge: &mut Judge<'_>, all: &[Deep]) -> Outcome {
    let v: Vec<_> = all.iter().flat_map(|(t, z)| [0, 1, 2].map(|k| place(t[k], SIZE, z[k]))).collect();
    let triangles: Vec<_> = (0..all.len() as u32).map(|k| [3 * k, 3 * k + 1, 3 * k + 2]).collect();
    let drawn = judge.draw(SIZE, &v, &triangles)?;
    for (pixel, &id) in drawn.ids.iter().enumerate() {
        let (i, j) = (pixel as i64 % 64, pixel as i64 / 64);
        let p = sample_point(i, j, judge.sample);
        if all.iter().any(|(t, _)| judge.may_differ(t, p)) {
            continue;
        }
        let deep = |k: usize| {
            let (t, z) = &all[k];
            covers(t, i, j, judge.sample).then(|| depth(t, *z, i, j, judge.sample))
        };
        let nearest = (0..all.len()).filter_map(deep).fold(0.0, f64::max);
        let right = match (id as usize).checked_sub(1) {
            None => (0..all.len()).all(|k| deep(k).is_none()),
            Some(k) if k < all.len() => {
                deep(k).is_some_and(|z| z >= nearest * (1.0 - 1.0 / f64::from(1 << 20)))
            }
            Some(_) => false,
        };
        judge.check(right);
    }
    Ok(())
}

/// Draws them in this order and in the reverse one.
fn shows_nearest_both_ways(judge: &mut Judge<'_>, mut all: Vec<Deep>) -> Outcome {
    shows_nearest(judge, &all)?;
    all.reverse();
    shows_nearest(judge, &all)
}

/// One triangle with depth 10/16 at its first vertex and 0 at the others goes through one at 3/16. It must be in
/// front exactly where its first weight is above 0.3.
pub(super) fn switch(judge: &mut Judge<'_>) -> Outcome {
    let t: [Vertex; 3] = [[32 * 256, 3 * 256], [60 * 256, 56 * 256], [2 * 256, 49 * 256]];
    let deep = [[10.0 / 16.0, 0.0, 0.0], [3.0 / 16.0; 3]];
    for tilted in [0, 1] {
        let v: Vec<_> = [deep[tilted], deep[1 - tilted]]
            .iter()
            .flat_map(|z| [0, 1, 2].map(|k| place(t[k], SIZE, z[k])))
            .collect();
        let drawn = judge.draw(SIZE, &v, &[[0, 1, 2], [3, 4, 5]])?;
        for (pixel, &id) in drawn.ids.iter().enumerate() {
            let (i, j) = (pixel as i64 % 64, pixel as i64 / 64);
            if judge.may_differ(&t, sample_point(i, j, judge.sample)) {
                continue;
            }
            let n = numerators(&t, i, j, judge.sample)[0] * area2(&t).signum();
            let (ten, three) = (10 * n, 3 * area2(&t).abs()); // The weight against 0.3, exactly.
            let front = if ten > three { tilted } else { 1 - tilted } as u32 + 1;
            let inside = covers(&t, i, j, judge.sample);
            let tie = (ten - three).abs() << 21 < three; // Nearer than 5·2⁻²⁴: either may be rounded in front.
            judge.check(if inside { id == front || (tie && (id == 1 || id == 2)) } else { id == 0 });
        }
    }
    Ok(())
}

/// Forty levels, each drawn twice: wherever a level is the nearest, it is seen, and always its first or always its
/// second copy, in whatever order the levels are drawn.
pub(super) fn doubled(judge: &mut Judge<'_>) -> Outcome {
    let mut r = Rng::new(100);
    let levels: Vec<[Vertex; 3]> =
        (0..40).map(|_| [(); 3].map(|()| [256 * r.range(-12, 76), 256 * r.range(-12, 76)])).collect();
    let depth = |level: usize| (level + 1) as f32 / 64.0;
    let v: Vec<_> =
        levels.iter().enumerate().flat_map(|(k, t)| t.map(|corner| place(corner, SIZE, depth(k)))).collect();
    let mut order: Vec<usize> = (0..80).map(|k| k / 2).collect();
    let mut copies = [0_usize; 2];
    for _ in 0..8 {
        let triangles: Vec<_> =
            order.iter().map(|&k| [3 * k, 3 * k + 1, 3 * k + 2].map(|k| k as u32)).collect();
        let drawn = judge.draw(SIZE, &v, &triangles)?;
        for (pixel, &id) in drawn.ids.iter().enumerate() {
            let (i, j) = (pixel as i64 % 64, pixel as i64 / 64);
            let p = sample_point(i, j, judge.sample);
            if levels.iter().any(|t| judge.may_differ(t, p)) {
                continue;
            }
            let nearest = (0..40).rev().find(|&k| covers(&levels[k], i, j, judge.sample));
            let seen = (id as usize).checked_sub(1);
            judge.check(seen.map(|k| order.get(k).copied()) == nearest.map(Some));
            if let Some(k) = seen.filter(|&k| k < order.len()) {
                copies[usize::from(order[..k].contains(&order[k]))] += 1;
            }
        }
        r.shuffle(&mut order);
    }
    judge.wrong(copies[0].min(copies[1]));
    Ok(())
}

/// Pairs of steep surfaces in perspective, one a hair nearer than the other at each vertex, with the same x/w and y/w.
///
/// Near plane at 1/10; far plane at 10³, 10⁵ and infinity. x/w and y/w are powers of two, so that the products are
/// exact and nothing but depth decides.
pub(super) fn nested(judge: &mut Judge<'_>) -> Outcome {
    const PLACES: [f64; 9] = [-4.0, -2.0, -1.0, -0.5, 0.0, 0.5, 1.0, 2.0, 4.0];
    let mut r = Rng::new(101);
    let vertex = |[x, y]: [f64; 2], w: f64, far: f64| {
        let w = f64::from(w as f32);
        let z = if far.is_finite() { 0.1 * (far - w) / (far - 0.1) } else { 0.1 };
        [x * w, y * w, z.min(w), w].map(|c| c as f32)
    };
    for far in [1e3, 1e5, f64::INFINITY] {
        for apart in [1e-3, 1e-4, 1e-5, 1e-6] {
            for _ in 0..3 {
                let places = [(); 3].map(|()| [PLACES[r.index(9)], PLACES[r.index(9)]]);
                let t = places.map(|[x, y]| [8192 + (8192.0 * x) as i64, 8192 - (8192.0 * y) as i64]);
                let w = [r.real(200.0, 900.0), r.real(0.11, 0.2), r.real(0.11, 900.0)];
                let behind = [0, 1, 2].map(|k| vertex(places[k], w[k], far));
                let before = [0, 1, 2].map(|k| vertex(places[k], w[k] * (1.0 - apart), far));
                for first in [0, 1] {
                    let [a, b] = if first == 0 { [before, behind] } else { [behind, before] };
                    let drawn = judge.draw(SIZE, &[a, b].concat(), &[[0, 1, 2], [3, 4, 5]])?;
                    for (pixel, &id) in drawn.ids.iter().enumerate() {
                        let (i, j) = (pixel as i64 % 64, pixel as i64 / 64);
                        // Along the edges whatever rounds x/w decides, and that is not the question.
                        if !near_boundary(&t, sample_point(i, j, judge.sample), 1) {
                            let inside = covers(&t, i, j, judge.sample);
                            judge.check(id == if inside { first + 1 } else { 0 });
                        }
                    }
                }
            }
        }
    }
    Ok(())
}

/// Three bars, each over the next and under the one before: no order of drawing is right.
///
/// ```text
///        ╱╲
///   ────╱──╲────
///      ╱    ╲        each runs from near to far
/// ```
pub(super) fn cycle(judge: &mut Judge<'_>) -> Outcome {
    let px = |t: [[i64; 2]; 3]| t.map(|v| v.map(|c| 256 * c));
    let bars = [
        px([[2, 44], [62, 50], [62, 56]]),
        px([[58, 62], [26, 4], [34, 2]]),
        px([[38, 2], [4, 62], [12, 62]]),
    ];
    shows_nearest_both_ways(judge, bars.map(|t| (t, [0.75, 0.25, 0.25])).to_vec())?;
    shows_nearest_both_ways(judge, bars.map(|t| (t, [0.25, 0.75, 0.75])).to_vec())
}

/// Planes of depth 5/16 and 9/16, then tilted ones that are parallel.
pub(super) fn parallel(judge: &mut Judge<'_>) -> Outcome {
    let px = |t: [[i64; 2]; 3]| t.map(|v| v.map(|c| 256 * c));
    let (one, two) = (px([[4, 6], [60, 12], [20, 60]]), px([[58, 2], [44, 62], [2, 34]]));
    shows_nearest_both_ways(judge, vec![(one, [5.0 / 16.0; 3]), (two, [9.0 / 16.0; 3])])?;
    // Depth rises by 1/128 a pixel to the right and 1/256 down.
    let tilted = |t: &[Vertex; 3], at: f32| t.map(|v| at + v[0] as f32 / 32_768.0 + v[1] as f32 / 65_536.0);
    let (far, near) = (tilted(&one, 0.0625), tilted(&two, 0.125));
    shows_nearest_both_ways(judge, vec![(one, far), (two, near)])?;
    shows_nearest_both_ways(judge, vec![(one, tilted(&one, 0.125)), (two, tilted(&two, 0.0625))])
}

/// Random triangles at random depths, through one another.
pub(super) fn soup(judge: &mut Judge<'_>) -> Outcome {
    let mut r = Rng::new(102);
    for _ in 0..3 {
        let all = (0..30).map(|_| {
            let t = triangle("random", &mut r, 64, 64);
            (t, [(); 3].map(|()| r.range(1, 1 << 20) as f32 / 1_048_576.0))
        });
        let all: Vec<Deep> = all.collect();
        shows_nearest(judge, &all)?;
    }
    Ok(())
}
