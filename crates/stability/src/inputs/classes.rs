//! Ten classes of triangles, each with its own way to be wrong.

use super::circle::{part, rational, turn, turns};
use super::rng::Rng;
use crate::oracle::coverage::Vertex;

/// The classes by name.
pub const CLASSES: [&str; 10] = [
    "random",
    "sliver",
    "on-grid",
    "half-grid",
    "tiny",
    "huge",
    "guard-band",
    "needle-fan",
    "degenerate",
    "off-screen",
];

/// The furthest coordinate that must not be clipped: 32,767 px.
pub const GUARD: i64 = 32_767 * 256;

fn point(r: &mut Rng, low: Vertex, high: Vertex) -> Vertex {
    [r.range(low[0], high[0]), r.range(low[1], high[1])]
}

/// A random triangle of the class with that name (any other name: the last class) around a picture of `width` × `height` px.
#[must_use]
pub fn triangle(class: &str, r: &mut Rng, width: i64, height: i64) -> [Vertex; 3] {
    let (w, h) = (256 * width, 256 * height);
    let around = |r: &mut Rng| point(r, [-w / 4, -h / 4], [w + w / 4, h + h / 4]);
    let within = |r: &mut Rng, d: i64| point(r, [-d, -d], [d, d]);
    match class {
        "random" => [around(r), around(r), around(r)],
        // The third vertex lies up to four sub-pixels beside the line through the others.
        "sliver" => {
            let (a, b, off) = (around(r), around(r), within(r, 4));
            let t = r.unit();
            let on = |k: usize| a[k] + ((b[k] - a[k]) as f64 * t) as i64 + off[k];
            [a, b, [on(0), on(1)]]
        }
        "on-grid" => [(); 3].map(|()| point(r, [-8, -8], [width + 8, height + 8]).map(|c| 256 * c)),
        "half-grid" => [(); 3].map(|()| point(r, [-8, -8], [width + 8, height + 8]).map(|c| 256 * c + 128)),
        "tiny" => {
            let (a, size) = (around(r), [16, 64, 256, 512][r.index(4)]);
            [(); 3].map(|()| {
                let d = within(r, size);
                [a[0] + d[0], a[1] + d[1]]
            })
        }
        "huge" => [(); 3].map(|()| within(r, 16_384 * 256)),
        // At least one vertex on the border of what need not be clipped.
        "guard-band" => {
            let mut t = [
                within(r, GUARD),
                within(r, GUARD),
                if r.index(2) == 0 { around(r) } else { within(r, GUARD) },
            ];
            t[0][r.index(2)] = if r.index(2) == 0 { GUARD } else { -GUARD };
            t
        }
        // Two neighbouring spokes, up to 32,000 px long and a few sub-pixels apart at the rim.
        "needle-fan" => {
            let apex = around(r);
            let length = f64::from(16 << r.index(11)) * r.real(1.0, 2.0) * 256.0 * 0.97;
            let angle = turns(part(2), r.range(0, 3) as u32);
            let angle = turn(angle, rational(r.unit()));
            let apart = r.real(0.25, 256.0) / length;
            let spoke = |a: [f64; 2]| {
                let end = |c: i64, d: f64| (c + (length * d) as i64).clamp(-GUARD, GUARD);
                [end(apex[0], a[0]), end(apex[1], a[1])]
            };
            [apex, spoke(angle), spoke(turn(angle, rational(apart / 2.0)))]
        }
        // Collinear, doubled, or a sub-pixel from it; on the grid or off it.
        "degenerate" => {
            let (a, step) = (around(r), within(r, 1024));
            let at = |k: i64| [a[0] + step[0] * k, a[1] + step[1] * k];
            let (k, l) = (r.range(-20, 20), r.range(-20, 20));
            let mut t = match r.index(4) {
                0 => [a, a, around(r)],
                1 => [a, a, a],
                2 => [a, [at(k)[0], a[1]], [at(l)[0], a[1]]],
                _ => [a, at(k), at(l)],
            };
            if r.index(4) == 0 {
                t[r.index(3)][r.index(2)] += 1;
            }
            if r.index(2) == 0 {
                t = t.map(|v| v.map(|c| c.div_euclid(256) * 256 + 128));
            }
            t
        }
        // Beside the picture by at most two widths, often touching its border.
        _ => {
            let (dx, dy) = (r.range(-2, 2) * w, r.range(-2, 2) * h);
            let border = [0, 128, 255, 256][r.index(4)];
            [(); 3].map(|()| {
                let p = point(r, [0, 0], [w, h]);
                let p = if r.index(3) == 0 { [border, p[1]] } else { p };
                [p[0] + dx, p[1] + dy]
            })
        }
    }
}

/// A triangle that covers more than 100,000 px of a picture of 1024 × 512 px, with ends beyond it.
#[must_use]
pub fn large(r: &mut Rng) -> [Vertex; 3] {
    let (w, h) = (1024 * 256, 512 * 256);
    [
        point(r, [-w / 2, -h / 2], [w / 4, h / 4]),
        point(r, [w * 9 / 10, -h / 2], [2 * w, h / 2]),
        point(r, [0, h], [w, 2 * h]),
    ]
}

/// Permutation `k` of 6: both windings, every first vertex.
#[must_use]
pub fn permuted<T: Copy>(t: &[T; 3], k: usize) -> [T; 3] {
    let [a, b, c] = [[0, 1, 2], [1, 2, 0], [2, 0, 1], [0, 2, 1], [2, 1, 0], [1, 0, 2]][k % 6];
    [t[a], t[b], t[c]]
}
