//! Numbers that are none, zeros of either sign, the smallest there are.

use crate::inputs::classes::permuted;
use crate::judge::{ALONE, Judge, Outcome, place};

const SIZE: [u32; 2] = [32, 32];

/// The three corners of a triangle in sub-pixels, and in clip space.
const PLAIN: [[i64; 2]; 3] = [[4 * 256, 28 * 256], [28 * 256, 27 * 256], [13 * 256, 3 * 256]];

/// Each bad number in each coordinate of each vertex; beside it, a good triangle must be drawn as ever.
pub(super) fn not_finite(judge: &mut Judge<'_>) -> Outcome {
    let good = PLAIN.map(|v| place(v, SIZE, 0.5));
    let alone = judge.draw(SIZE, &good, &ALONE)?;
    for bad in [f32::NAN, f32::INFINITY, f32::NEG_INFINITY] {
        for at in 0..12 {
            let mut v = good;
            v[at / 4][at % 4] = bad;
            let drawn = judge.draw(SIZE, &v, &[[0, 1, 2], [2, 1, 0]])?;
            judge.wrong(drawn.ids.iter().filter(|&&id| id != 0).count());

            let drawn = judge.draw(SIZE, &[v, good].concat(), &[[0, 1, 2], [3, 4, 5], [2, 1, 0]])?;
            let differs = alone
                .ids
                .iter()
                .zip(&drawn.ids)
                .filter(|&(&alone, &id)| id != if alone == 0 { 0 } else { 2 });
            judge.wrong(differs.count());
        }
    }
    Ok(())
}

/// −0 is 0, a denormal is next to it, and of denormals alone x/w and y/w count, as of any numbers.
pub(super) fn ordinary(judge: &mut Judge<'_>) -> Outcome {
    let half = 16 * 256;
    // No sample lies on an edge.
    let t = [[0, half], [2 * half, half], [half, half + half / 8 * 7]];
    let plain = [0, 1, 2].map(|k| place(t[k], SIZE, [0.5, 0.5, 0.0][k]));
    let tiny = f32::from_bits(1);
    let zero_as = |zero: f32| plain.map(|v| v.map(|c| if c == 0.0 { zero } else { c }));
    let mut pictures =
        vec![plain, zero_as(-0.0), zero_as(tiny), plain.map(|v| v.map(|c| c * f32::MIN_POSITIVE))];
    pictures.push(plain.map(|v| v.map(|c| c * (8.0 * tiny))));
    pictures.push(plain.map(|v| v.map(|c| c * 1e38)));
    for (k, v) in pictures.into_iter().enumerate() {
        let order = permuted(&[0, 1, 2], k);
        let drawn = judge.draw(SIZE, &order.map(|k| v[k]), &ALONE)?;
        judge.covers(SIZE, &order.map(|k| t[k]), &drawn.ids);
    }
    Ok(())
}

/// All of w ≤ 0: nothing there lies in 0 ≤ z ≤ w but the eye itself.
pub(super) fn behind(judge: &mut Judge<'_>) -> Outcome {
    for w in [0.0, -0.0, -1.0, -1e-30] {
        for z in [0.0, 0.5, -0.5, -1.0] {
            let v = [[-1.0, -1.0, z, w], [1.0, -1.0, z, w], [0.0, 1.0, z, w]];
            let drawn = judge.draw(SIZE, &v, &ALONE)?;
            judge.wrong(drawn.ids.iter().filter(|&&id| id != 0).count());
        }
    }
    Ok(())
}
