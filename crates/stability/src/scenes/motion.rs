//! What must not depend on the order of vertices, and what must follow a motion.

use crate::inputs::classes::permuted;
use crate::inputs::rng::Rng;
use crate::judge::{Judge, Outcome};
use crate::oracle::coverage::Vertex;

const SIZE: [u32; 2] = [64, 64];

/// The six orders of a triangle's vertices, and the first one again: the same pixels, the same bits of depth.
///
/// A picture in between keeps whatever is not cleared from going unseen.
pub(super) fn orders(judge: &mut Judge<'_>) -> Outcome {
    let mut r = Rng::new(120);
    for round in 0..60 {
        // Every other one through the near plane, if that is not too much to ask.
        let least = if round % 2 == 1 && judge.abilities.clips { -1.0 } else { 0.5 };
        let v = [(); 3].map(|()| {
            let [x, y] = [r.real(-2.0, 2.0) as f32, r.real(-2.0, 2.0) as f32];
            [x, y, r.unit() as f32 * 0.5, r.real(least, 3.0) as f32]
        });
        let first = judge.draw(SIZE, &v, &[[0, 1, 2]])?;
        for k in 1..7 {
            let again = judge.draw(SIZE, &v, &[permuted(&[0, 1, 2], k)])?;
            let bits =
                |depth: &Option<Vec<f32>>, pixel: usize| depth.as_ref().map(|depth| depth[pixel].to_bits());
            let differs = |pixel: &usize| {
                let (a, b) = (first.ids[*pixel], again.ids[*pixel]);
                a != b || (a != 0 && bits(&first.depth, *pixel) != bits(&again.depth, *pixel))
            };
            judge.wrong((0..first.ids.len()).filter(differs).count());
        }
    }
    Ok(())
}

/// A small triangle and a large one move by 1/16 px a picture, over, down and along a slope: with each step the
/// pixels change that the motion has reached, and no others.
pub(super) fn slow(judge: &mut Judge<'_>) -> Outcome {
    let small: [Vertex; 3] = [[2570, 2600], [3300, 2810], [2750, 3500]];
    let large: [Vertex; 3] = [[600, 900], [13_700, 5_100], [4_100, 14_900]];
    for t in [small, large] {
        for direction in [[16, 0], [0, 16], [16, -16], [-16, 32]] {
            for step in 0..16 {
                let moved = t.map(|v| [v[0] + step * direction[0], v[1] + step * direction[1]]);
                judge.compare(SIZE, &moved, [0.5; 3])?;
            }
        }
    }
    Ok(())
}
