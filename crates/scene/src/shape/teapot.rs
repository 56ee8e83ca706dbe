//! The Utah teapot, tessellated.
//!
//! Each patch becomes a grid of n × n quadrilaterals. Neighbouring patches share their vertices: a border's
//! points depend on the border's four control points only, and come out the same to the last bit whichever
//! patch computes them and in which direction:
//!
//! ```text
//!   weights of i/n:  w0 = (n−i)³/n³   w1 = 3i(n−i)²/n³   w2 = 3i²(n−i)/n³   w3 = i³/n³
//!   point:           (w0·p0 + w3·p3) + (w1·p1 + w2·p2)
//! ```
//!
//! The numerators are whole numbers, so i and n − i exchange the weights exactly, and the sum is symmetric under
//! that exchange. At the poles (the knob's top, the middle of the bottom) a row of the grid is one point, and its
//! quadrilaterals are triangles.

use std::collections::HashMap;

use super::build::{Builder, Corner};
use super::error::{ShapeError, within};
use super::teapot_patches::{Patch, parts};
use crate::Mesh;
use crate::subdivide::to_f32;

pub(super) fn count(segments: u32) -> Result<u64, ShapeError> {
    // With one segment a tube has two sides, which fall into one plane.
    within("teapot", "SEGMENTS", segments, 2..=559)?;
    let n = u64::from(segments);
    // Eight patches have a pole, where n of their triangles vanish.
    Ok(32 * 2 * n * n - 8 * n)
}

/// The Utah teapot from its 32 patches, each in `segments` × `segments` quadrilaterals: 64 n² − 8 n triangles.
/// It stands upright between y = −1 and 1, with the spout to +X and the handle to −X.
///
/// Its normals are those of the patches, smooth everywhere. Its edges are the sides of the quadrilaterals. It is the original teapot, not a solid: the lid lies in the rim without touching it, handle
/// and spout end inside the body, and the spout's mouth is open.
///
/// # Errors
///
/// When `segments` is less than 2, or more than 559, which is
/// [`MOST_TRIANGLES`](crate::subdivide::MOST_TRIANGLES).
pub fn teapot(segments: u32) -> Result<Mesh, ShapeError> {
    count(segments)?;
    let n = segments;
    let basis: Vec<Basis> = (0..=n).map(|i| Basis::new(i, n)).collect();
    let mut weld = Weld::default();
    for patches in parts() {
        // Parts run into each other; a vertex that two of them happen to share is two vertices.
        weld.known.clear();
        for patch in &patches {
            let mut upper: Vec<Corner> = Vec::new();
            for (j, v) in basis.iter().enumerate() {
                let row: Vec<Corner> = basis.iter().map(|u| weld.corner(patch, u, v)).collect();
                if j > 0 {
                    for (below, above) in row.windows(2).zip(upper.windows(2)) {
                        weld.build.polygon([below[0], below[1], above[1], above[0]]);
                    }
                }
                upper = row;
            }
        }
    }
    Ok(weld.build.finish())
}

/// The four cubic Bernstein polynomials at i/n, and their derivatives.
struct Basis {
    value: [f64; 4],
    slope: [f64; 4],
}

impl Basis {
    fn new(i: u32, n: u32) -> Self {
        let (t, s, n) = (f64::from(i), f64::from(n - i), f64::from(n));
        let (cube, square) = (n * n * n, n * n);
        Self {
            value: [s * s * s, 3.0 * t * s * s, 3.0 * t * t * s, t * t * t].map(|w| w / cube),
            slope: [-3.0 * s * s, 3.0 * s * s - 6.0 * s * t, 6.0 * s * t - 3.0 * t * t, 3.0 * t * t]
                .map(|w| w / square),
        }
    }
}

/// Σ wᵢ·pᵢ, in the order that does not see the direction.
fn mix(w: &[f64; 4], p: &[[f64; 3]; 4]) -> [f64; 3] {
    std::array::from_fn(|axis| {
        (w[0] * p[0][axis] + w[3] * p[3][axis]) + (w[1] * p[1][axis] + w[2] * p[2][axis])
    })
}

fn evaluate(patch: &Patch, u: &[f64; 4], v: &[f64; 4]) -> [f64; 3] {
    mix(v, &patch.map(|row| mix(u, &row)))
}

/// The outward normal ∂S/∂v × ∂S/∂u, normalised.
fn outward(patch: &Patch, u: &Basis, v: &Basis) -> [f64; 3] {
    let dv = evaluate(patch, &u.value, &v.slope);
    let mut du = evaluate(patch, &u.slope, &v.value);
    if du == [0.0; 3] {
        // A pole: the row is one point. Close to it ∂S/∂u is v (or, at the far end, v − 1) times ∂²S/∂u∂v,
        // whose direction is what counts.
        let far = v.value[3] == 1.0;
        du = evaluate(patch, &u.slope, &v.slope).map(|x| if far { -x } else { x });
    }
    let n = [dv[1] * du[2] - dv[2] * du[1], dv[2] * du[0] - dv[0] * du[2], dv[0] * du[1] - dv[1] * du[0]];
    let length = (n[0] * n[0] + n[1] * n[1] + n[2] * n[2]).sqrt();
    n.map(|x| x / length)
}

/// From Newell's axes, z up, to ours, y up.
fn upright([x, y, z]: [f64; 3]) -> [f64; 3] {
    [x, z, 0.0 - y]
}

/// Half of the teapot's height in Newell's units.
const HALF_HEIGHT: f64 = 1.575;

/// Finds the vertex that another patch has made. Its normal serves both: all joins are smooth, which a test of
/// the control points checks.
#[derive(Default)]
struct Weld {
    build: Builder,
    /// The vertices of this part, by the bits of their positions.
    known: HashMap<[u32; 3], Corner>,
}

impl Weld {
    fn corner(&mut self, patch: &Patch, u: &Basis, v: &Basis) -> Corner {
        let [x, y, z] = upright(evaluate(patch, &u.value, &v.value));
        // 0 + p makes one zero of the two.
        let position = [x, y - HALF_HEIGHT, z].map(|p| 0.0 + p / HALF_HEIGHT);
        *self
            .known
            .entry(to_f32(position).map(f32::to_bits))
            .or_insert_with(|| self.build.smooth_vertex(position, upright(outward(patch, u, v))))
    }
}
