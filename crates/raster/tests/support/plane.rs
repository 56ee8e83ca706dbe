//! Depth and weights inside a triangle, from exact edge values.

use super::oracle::{CENTRE, Vertex, area2, edge, sample_point};

/// The exact barycentric numerators of a pixel's sample; their sum is the (signed) double area.
pub(crate) fn numerators(t: &[Vertex; 3], i: i64, j: i64, sample: [i64; 2]) -> [i128; 3] {
    let p = sample_point(i, j, sample);
    [edge(t[1], t[2], p), edge(t[2], t[0], p), edge(t[0], t[1], p)]
}

/// A depth as an integer multiple of 2⁻⁶⁴. Exact, or the test is ill-posed.
fn fixed(z: f32) -> i128 {
    let scaled = f64::from(z) * 2_f64.powi(64);
    assert!(
        scaled.fract() == 0.0 && scaled.abs() < 2_f64.powi(66),
        "depth {z:e} is out of the oracle's range"
    );
    scaled as i128
}

/// How far `got` is from the rational plane through the vertex depths `z`, relative to it, in
/// units of 2⁻²⁴.
///
/// With depths in 2⁻⁶⁴ and numerators below 2⁵⁰ the difference is an exact integer below 2¹¹⁸;
/// only its quotient is rounded, to `f64`.
pub(crate) fn depth_units(t: &[Vertex; 3], z: [f32; 3], i: i64, j: i64, got: f32) -> f64 {
    depth_units_at(t, z, i, j, CENTRE, got)
}

/// [`depth_units`] at another sample position.
pub(crate) fn depth_units_at(
    t: &[Vertex; 3],
    z: [f32; 3],
    i: i64,
    j: i64,
    sample: [i64; 2],
    got: f32,
) -> f64 {
    let n = numerators(t, i, j, sample);
    let (area, plane) = (area2(t), (0..3).map(|k| n[k] * fixed(z[k])).sum::<i128>());
    let difference = (fixed(got) * area - plane).unsigned_abs();
    if difference == 0 { 0.0 } else { difference as f64 / plane.unsigned_abs() as f64 * 2_f64.powi(24) }
}

/// The perspective-correct weights of a pixel's sample: λ/w, divided by their sum.
pub(crate) fn weights(t: &[Vertex; 3], w: [f32; 3], i: i64, j: i64, sample: [i64; 2]) -> [f64; 3] {
    let n = numerators(t, i, j, sample);
    let scaled = [0, 1, 2].map(|k| n[k] as f64 / f64::from(w[k]));
    let sum: f64 = scaled.iter().sum();
    scaled.map(|s| s / sum)
}
