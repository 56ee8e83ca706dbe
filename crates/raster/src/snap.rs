//! The only gate from floating point to sub-pixels.

use polosa_math::{SUB_PIXELS, Viewport};

/// A pixel in sub-pixels, wide enough for products.
pub(crate) const PIXEL: i64 = SUB_PIXELS as i64;

/// Snapped vertices stay within ± this many sub-pixels: 2²³ − 2, just inside Direct3D 11's 16.8 bits.
///
/// With it a difference of two coordinates is at most 2²⁴, a product of two differences 2⁴⁸, and an edge value
/// 2⁴⁹: exact in `i64`, and in the lanes of an `f64` as well. A larger band would need wider arithmetic in
/// every walker. The two sub-pixels that are missing to 2²³ absorb the rounding of the clipper's cuts.
pub(crate) const GUARD: i32 = (1 << 23) - 2;

/// 1.5 · 2⁵²: added to an `f64` of less than 2⁵¹, it leaves the nearest integer in the low bits.
pub(crate) const ROUND: f64 = 6_755_399_441_055_744.0;

/// A vertex on the sub-pixel grid.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Corner {
    /// To the right, in 1/256 pixel.
    pub x: i32,
    /// Down, in 1/256 pixel.
    pub y: i32,
    /// Depth, 0 (far) to 1 (near).
    pub z: f32,
    /// The clip-space w, positive.
    pub w: f64,
}

/// Snaps a point of clip space that lies inside all clip planes and has `w > 0`.
///
/// The division is the only one; the viewport map and the rounding follow it. Depth is `z / w` in `f64`,
/// rounded once.
#[inline]
pub(crate) fn snap(viewport: &Viewport, [x, y, z, w]: [f64; 4]) -> Corner {
    let [x, y] = viewport.to_sub_pixels(x, y, w);
    Corner { x: round(x), y: round(y), z: depth(z, w), w }
}

/// A vertex's depth. Inside the planes `z / w` is in 0..=1 already; what a cut's rounding adds is taken off, and so
/// is the sign of a negative zero.
#[inline]
#[expect(clippy::cast_possible_truncation, reason = "the one rounding of a vertex's depth")]
pub(crate) fn depth(z: f64, w: f64) -> f32 {
    ((z / w).clamp(0.0, 1.0) + 0.0) as f32
}

/// Rounds to the nearest integer, ties to even; the value must lie within ±2³¹.
#[inline]
#[expect(clippy::cast_possible_truncation, reason = "the low 32 bits are the integer, in two's complement")]
const fn round(value: f64) -> i32 {
    (value + ROUND).to_bits() as i32
}

#[cfg(test)]
mod tests {
    use super::round;

    #[test]
    fn ties_round_to_even() {
        for (value, expected) in [
            (0.5, 0),
            (1.5, 2),
            (-0.5, 0),
            (-1.5, -2),
            (2.5, 2),
            (0.499_999_99, 0),
            (-8_388_606.4, -8_388_606),
            (8_388_606.5, 8_388_606),
        ] {
            assert_eq!(round(value), expected, "{value}");
        }
    }
}
