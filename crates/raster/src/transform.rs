//! Positions to clip space, by the one expression that every path uses.

use crate::Clip;

/// A matrix as its four columns, as `glam::Mat4::to_cols_array_2d` gives it.
pub type Columns = [[f32; 4]; 4];

/// Transforms one position (its w is 1): `((m0·x + m1·y) + m2·z) + m3`, rounded after each step.
///
/// Matrix libraries pick another order, or a fused one, from target to target; this one does not.
#[inline]
#[must_use]
pub fn transform_point(matrix: &Columns, [x, y, z]: [f32; 3]) -> Clip {
    let [m0, m1, m2, m3] = matrix;
    core::array::from_fn(|k| ((m0[k] * x + m1[k] * y) + m2[k] * z) + m3[k])
}

/// Transforms `positions` into `out`, one for one; the shorter of the two says how many.
///
/// ```
/// let shift = [[1.0, 0.0, 0.0, 0.0], [0.0, 1.0, 0.0, 0.0], [0.0, 0.0, 1.0, 0.0], [5.0, 6.0, 7.0, 1.0]];
/// let mut out = [[0.0; 4]; 1];
/// polosa_raster::transform(&shift, &[[1.0, 2.0, 3.0]], &mut out);
/// assert_eq!(out, [[6.0, 8.0, 10.0, 1.0]]);
/// ```
pub fn transform(matrix: &Columns, positions: &[[f32; 3]], out: &mut [Clip]) {
    for (to, &from) in out.iter_mut().zip(positions) {
        *to = transform_point(matrix, from);
    }
}
