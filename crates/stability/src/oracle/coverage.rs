//! Which pixels a triangle covers, from the definition alone.
//!
//! Vertices are integers in 1/256 px, y down. With the winding made positive, an edge from `a` to
//! `b` has the half-plane
//!
//! ```text
//!   E(p) = (b.x − a.x)·(p.y − a.y) − (b.y − a.y)·(p.x − a.x)
//!
//!      a ───▶ b       top edge: to the right, the inside below it       E = 0 is in
//!      ▲      │       left edge: upwards, the inside to its right       E = 0 is in
//!      │      ▼       right and bottom edges                            E = 0 is out
//!      d ◀─── c
//! ```
//!
//! and a pixel is covered where its sample lies in all three. Everything is `i128`: no overflow to
//! think about, and nothing in common with the integer widths of the crate under test.

use std::ops::Range;

/// A snapped vertex, in 1/256 px.
pub type Vertex = [i64; 2];

/// The sample at the pixel's centre, in 1/256 px.
pub const CENTRE: [i64; 2] = [128, 128];

/// E of the edge from `a` to `b` at `p`: twice the signed area of the triangle `a b p`.
#[must_use]
pub fn edge(a: Vertex, b: Vertex, p: Vertex) -> i128 {
    let [ax, ay, bx, by, px, py] = [a[0], a[1], b[0], b[1], p[0], p[1]].map(i128::from);
    (bx - ax) * (py - ay) - (by - ay) * (px - ax)
}

/// Twice the signed area; negative for a front face, counter-clockwise to the eye.
#[must_use]
pub fn area2(t: &[Vertex; 3]) -> i128 {
    edge(t[0], t[1], t[2])
}

/// The triangle with positive area, or `None` if it has none.
fn positive(t: &[Vertex; 3]) -> Option<[Vertex; 3]> {
    match area2(t).signum() {
        1 => Some(*t),
        -1 => Some([t[0], t[2], t[1]]),
        _ => None,
    }
}

/// The least E that is inside: 0 on a top or left edge, 1 elsewhere.
fn least(a: Vertex, b: Vertex) -> i128 {
    let (dx, dy) = (b[0] - a[0], b[1] - a[1]);
    i128::from(!(dy < 0 || (dy == 0 && dx > 0)))
}

/// Where pixel (i, j) is sampled, in 1/256 px.
#[must_use]
pub const fn sample_point(i: i64, j: i64, sample: [i64; 2]) -> Vertex {
    [256 * i + sample[0], 256 * j + sample[1]]
}

/// Whether the triangle covers the pixel (i, j): the definition itself.
#[must_use]
pub fn covers(t: &[Vertex; 3], i: i64, j: i64, sample: [i64; 2]) -> bool {
    let p = sample_point(i, j, sample);
    positive(t).is_some_and(|t| (0..3).all(|k| edge(t[k], t[(k + 1) % 3], p) >= least(t[k], t[(k + 1) % 3])))
}

/// The pixels of row `j` that the triangle covers, within `0..width`.
///
/// Along a row each half-plane is `e − 256·dy·i ≥ least`, a bound on `i` by one exact division;
/// the span is what the three leave over. ([`covers`] judges this function in its own test.)
#[must_use]
pub fn row_span(t: &[Vertex; 3], j: i64, sample: [i64; 2], width: usize) -> Range<usize> {
    let (mut low, mut high) = (0_i128, width as i128); // low..high
    let Some(t) = positive(t) else { return 0..0 };
    let y = sample_point(0, j, sample)[1];
    if t.iter().all(|v| v[1] < y) || t.iter().all(|v| v[1] > y) {
        return 0..0;
    }
    for k in 0..3 {
        let (a, b) = (t[k], t[(k + 1) % 3]);
        let spare = edge(a, b, sample_point(0, j, sample)) - least(a, b);
        let step = 256 * i128::from(b[1] - a[1]);
        match step.signum() {
            1 => high = high.min(spare.div_euclid(step) + 1),
            -1 => low = low.max(-(spare.div_euclid(-step))),
            _ if spare < 0 => return 0..0,
            _ => {}
        }
    }
    if low < high { usize::try_from(low).unwrap()..usize::try_from(high).unwrap() } else { 0..0 }
}

/// Whether `p` lies within √2/512 px of the boundary of an *unsnapped* triangle, exactly.
///
/// Coordinates are integers in 1/(256·`fine`) px. A vertex moves at most half a sub-pixel in x and
/// in y when it is snapped, so that only such a pixel may change sides.
#[must_use]
pub fn near_boundary(t: &[Vertex; 3], p: Vertex, fine: i64) -> bool {
    // √2/512 px is `fine`/√2 in these coordinates: 2·distance² ≤ fine².
    let limit = i128::from(fine) * i128::from(fine);
    (0..3).any(|k| {
        let (a, b) = (t[k], t[(k + 1) % 3]);
        let dot = |u: [i128; 2], v: [i128; 2]| u[0] * v[0] + u[1] * v[1];
        let to = |from: Vertex, to: Vertex| [0, 1].map(|c| i128::from(to[c] - from[c]));
        let (ab, ap, bp) = (to(a, b), to(a, p), to(b, p));
        if dot(ab, ap) <= 0 {
            2 * dot(ap, ap) <= limit
        } else if dot(ab, bp) >= 0 {
            2 * dot(bp, bp) <= limit
        } else {
            let e = edge(a, b, p);
            2 * e * e <= limit * dot(ab, ab)
        }
    })
}
