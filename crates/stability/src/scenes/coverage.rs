//! Which pixels a triangle covers, whatever its shape and place.

use crate::inputs::classes::{CLASSES, GUARD, permuted, triangle};
use crate::inputs::rng::Rng;
use crate::judge::{ALONE, Judge, Outcome, place};
use crate::oracle::coverage::{Vertex, covers, edge, near_boundary};

const SIZE: [u32; 2] = [64, 64];

/// Pixels to sub-pixels.
fn px(quad: [[f64; 2]; 4]) -> [Vertex; 4] {
    quad.map(|v| v.map(|c| (c * 256.0) as i64))
}

/// The square (1, 1)–(7, 7): its diagonal runs through six pixel centres.
pub(super) fn quad(judge: &mut Judge<'_>) -> Outcome {
    let v = px([[1.0, 1.0], [7.0, 1.0], [7.0, 7.0], [1.0, 7.0]]);
    for cut in
        [[[0, 1, 2], [0, 2, 3]], [[1, 2, 3], [1, 3, 0]], [[2, 1, 0], [0, 2, 3]], [[0, 2, 1], [3, 2, 0]]]
    {
        judge.rectangle([8, 8], (&v, &cut), v[0], v[2])?;
    }
    Ok(())
}

/// (0, 0), (50, 50), (100, 100): on a line, in each order.
pub(super) fn collinear(judge: &mut Judge<'_>) -> Outcome {
    for k in 0..6 {
        let t = permuted(&[[0, 0], [50 * 256, 50 * 256], [100 * 256, 100 * 256]], k);
        judge.compare([128, 128], &t, [0.5; 3])?;
    }
    Ok(())
}

/// Quads along the axes and turned, on pixel centres and off them, cut along either diagonal, wound either way.
pub(super) fn quads(judge: &mut Judge<'_>) -> Outcome {
    let straight = [[10.0, 10.0], [50.5, 10.0], [50.5, 40.25], [10.0, 40.25]];
    let centres = [[10.5, 10.5], [40.5, 10.5], [40.5, 40.5], [10.5, 40.5]];
    let diamond = [[32.5, 2.5], [60.5, 30.5], [32.5, 58.5], [4.5, 30.5]];
    let turned = [[20.0, 5.0], [58.0, 21.0], [42.0, 59.0], [4.0, 43.0]];
    for q in [straight, centres, diamond, turned].map(px) {
        let v = q.map(|v| place(v, SIZE, 0.5));
        for cut in [[[0_u32, 1, 2], [0, 2, 3]], [[1, 2, 3], [1, 3, 0]]] {
            for reverse in [false, true] {
                let cut = if reverse { cut.map(|[a, b, c]| [c, b, a]) } else { cut };
                let times = judge.times(SIZE, &v, &cut)?;
                for (k, &times) in times.iter().enumerate() {
                    let p = judge.sample_of(k, SIZE[0]);
                    let (i, j) = (k as i64 % 64, k as i64 / 64);
                    // The whole quad, each half-plane by the same rule: whichever way it is cut.
                    let halves = [[0, 1, 2], [0, 2, 3]].map(|t| t.map(|k: usize| q[k]));
                    let inside = halves.iter().any(|t| covers(t, i, j, judge.sample));
                    let on_border = (0..4).any(|k| edge(q[k], q[(k + 1) % 4], p) == 0);
                    let free = !judge.abilities.top_left && on_border;
                    judge.check(times == u32::from(inside) || (free && times <= 1));
                }
            }
        }
    }
    Ok(())
}

/// Vertices as far off as need not be clipped, thin and thick.
pub(super) fn guard(judge: &mut Judge<'_>) -> Outcome {
    let far = GUARD;
    let all: [[Vertex; 3]; 4] = [
        [[-far, -far], [far, -far], [0, far]],
        [[-far, -far], [far, far], [far, far - 1]],
        [[-far, 20 * 256], [far, 21 * 256], [far, 20 * 256]],
        [[far, far], [-far, far - 256 * 11], [40 * 256, -far]],
    ];
    let mut r = Rng::new(70);
    let random = (0..60).map(|_| triangle("guard-band", &mut r, 64, 64));
    for (k, t) in all.into_iter().chain(random).enumerate() {
        judge.compare(SIZE, &permuted(&t, k), [0.5; 3])?;
    }
    Ok(())
}

/// Forty triangles of each class but the one of [`guard`].
pub(super) fn classes(judge: &mut Judge<'_>) -> Outcome {
    let mut r = Rng::new(71);
    for class in CLASSES.iter().filter(|&&class| class != "guard-band") {
        for k in 0..40 {
            let t = triangle(class, &mut r, 64, 64);
            judge.compare(SIZE, &permuted(&t, k), [0.5; 3])?;
        }
    }
    Ok(())
}

/// Vertices at 1/65,536 px, so that they must be snapped or kept: only pixels beside a true edge may differ.
pub(super) fn unsnapped(judge: &mut Judge<'_>) -> Outcome {
    let mut r = Rng::new(72);
    let side: i64 = 1 << 22; // The side of the picture in 1/65,536 px: clip space is 2x/side − 1.
    for k in 0..80 {
        let t = permuted(&triangle("random", &mut r, 64, 64), k);
        let t = t.map(|v| v.map(|c| 256 * c + r.range(-128, 128)));
        let v = t.map(|[x, y]| {
            [(2 * x - side) as f32 / side as f32, (side - 2 * y) as f32 / side as f32, 0.5, 1.0]
        });
        let drawn = judge.draw(SIZE, &v, &ALONE)?;
        for (pixel, &id) in drawn.ids.iter().enumerate() {
            let p = judge.sample_of(pixel, SIZE[0]).map(|c| 256 * c);
            let e = [0, 1, 2].map(|k| edge(t[k], t[(k + 1) % 3], p));
            let inside = e.iter().all(|&e| e >= 0) || e.iter().all(|&e| e <= 0);
            judge.check(id == u32::from(inside) || (id <= 1 && near_boundary(&t, p, 256)));
        }
    }
    Ok(())
}

/// Pictures of one column, one row, one pixel; and a picture of no triangle.
pub(super) fn narrow(judge: &mut Judge<'_>) -> Outcome {
    let mut r = Rng::new(73);
    for size in [[1, 1], [1, 64], [64, 1], [2, 1024], [1024, 2]] {
        let drawn = judge.draw(size, &[], &[])?;
        judge.wrong(drawn.ids.iter().filter(|&&id| id != 0).count());
        for k in 0..20 {
            let t = triangle(["random", "half-grid"][k % 2], &mut r, size[0].into(), size[1].into());
            judge.compare(size, &permuted(&t, k), [0.5; 3])?;
        }
    }
    Ok(())
}
