//! Depth and weights inside a triangle, from exact edge values.

use super::coverage::{CENTRE, Vertex, area2, edge, sample_point};

/// The exact barycentric numerators of a pixel's sample; their sum is the (signed) double area.
#[must_use]
pub fn numerators(t: &[Vertex; 3], i: i64, j: i64, sample: [i64; 2]) -> [i128; 3] {
    let p = sample_point(i, j, sample);
    [edge(t[1], t[2], p), edge(t[2], t[0], p), edge(t[0], t[1], p)]
}

/// A depth as an integer multiple of 2⁻⁶⁴, if it is one and is not larger than 4.
fn fixed(z: f32) -> Option<i128> {
    let scaled = f64::from(z) * 18_446_744_073_709_551_616.0;
    (scaled.fract() == 0.0 && scaled.abs() < 73_786_976_294_838_206_464.0).then_some(scaled as i128)
}

/// The plane through the vertex depths at a pixel: its value times the double area, in 2⁻⁶⁴, and that area.
fn plane(t: &[Vertex; 3], z: [f32; 3], i: i64, j: i64, sample: [i64; 2]) -> [i128; 2] {
    let n = numerators(t, i, j, sample);
    let z = z.map(|z| fixed(z).expect("depths below 4 that are multiples of 2⁻⁶⁴"));
    [(0..3).map(|k| n[k] * z[k]).sum(), area2(t)]
}

/// The depth of the rational plane through the vertex depths `z` at the pixel (i, j), rounded once.
///
/// # Panics
///
/// Where a vertex depth is 4 or more or no multiple of 2⁻⁶⁴.
#[must_use]
pub fn depth(t: &[Vertex; 3], z: [f32; 3], i: i64, j: i64, sample: [i64; 2]) -> f64 {
    let [plane, area] = plane(t, z, i, j, sample);
    plane as f64 / area as f64 / 18_446_744_073_709_551_616.0
}

/// How far `got` is from the rational plane through the vertex depths `z`, relative to it, in units of 2⁻²⁴;
/// infinite if `got` is not finite.
///
/// With depths in 2⁻⁶⁴ and numerators below 2⁵⁰ the difference is an exact integer below 2¹¹⁸; only its quotient is
/// rounded, to `f64`.
///
/// # Panics
///
/// Where a vertex depth is 4 or more or no multiple of 2⁻⁶⁴.
#[must_use]
pub fn depth_units(t: &[Vertex; 3], z: [f32; 3], i: i64, j: i64, got: f32) -> f64 {
    depth_units_at(t, z, i, j, CENTRE, got)
}

/// [`depth_units`] at another sample position.
///
/// # Panics
///
/// As [`depth_units`].
#[must_use]
pub fn depth_units_at(t: &[Vertex; 3], z: [f32; 3], i: i64, j: i64, sample: [i64; 2], got: f32) -> f64 {
    let [plane, area] = plane(t, z, i, j, sample);
    let relative = match fixed(got) {
        Some(got) if got * area == plane => 0.0,
        Some(got) => (got * area - plane).unsigned_abs() as f64 / plane.unsigned_abs() as f64,
        // Finer than 2⁻⁶⁴, or larger than any depth: no rounding to f64 matters to so wrong an answer.
        None => (f64::from(got) / depth(t, z, i, j, sample) - 1.0).abs(),
    };
    if relative.is_nan() { f64::INFINITY } else { relative * 16_777_216.0 }
}

/// The perspective-correct weights of a pixel's sample: λ/w, divided by their sum.
#[must_use]
pub fn weights(t: &[Vertex; 3], w: [f32; 3], i: i64, j: i64, sample: [i64; 2]) -> [f64; 3] {
    let n = numerators(t, i, j, sample);
    let scaled = [0, 1, 2].map(|k| n[k] as f64 / f64::from(w[k]));
    let sum: f64 = scaled.iter().sum();
    scaled.map(|s| s / sum)
}
