//! The nearest sub-pixel, by rational arithmetic.
//!
//! ```text
//!   X = 128·W·(x + w) / w        Y = 128·H·(w − y) / w        in 1/256 px, y down
//! ```
//!
//! An `f32` is an integer times a power of two. With x, y and w as integers over one power of two both quotients
//! are exact; they are rounded once, to the nearest integer, ties to even.

use super::coverage::Vertex;

/// Beyond this many binary digits between the largest and the smallest number the products leave `i128`.
const REACH: i32 = 40;

/// The number as (m, e): m·2ᵉ, exactly. `None` if it is not finite.
fn parts(value: f32) -> Option<(i128, i32)> {
    let bits = value.to_bits();
    let (exponent, fraction) = ((bits >> 23 & 0xFF).cast_signed(), i128::from(bits & 0x7F_FFFF));
    let magnitude = match exponent {
        255 => return None,
        0 => (fraction, -149),
        _ => (fraction | 0x80_0000, exponent - 150),
    };
    Some(if bits >> 31 == 1 { (-magnitude.0, magnitude.1) } else { magnitude })
}

/// n / d to the nearest integer, ties to even; d > 0.
fn nearest_even(n: i128, d: i128) -> i128 {
    let (quotient, twice) = (n.div_euclid(d), 2 * n.rem_euclid(d));
    quotient + i128::from(twice > d || (twice == d && quotient % 2 != 0))
}

/// The sub-pixel of a vertex (x, y, z, w) in clip space, in a picture of `width` × `height` pixels.
///
/// `None` where w ≤ 0, where a number is not finite, where the numbers differ by more than 2⁴⁰ in size, or where the
/// result leaves `i64`.
#[must_use]
pub fn snap(v: [f32; 4], width: u32, height: u32) -> Option<Vertex> {
    let [x, y, w] = [parts(v[0])?, parts(v[1])?, parts(v[3])?];
    let used = [x, y, w].map(|(m, e)| if m == 0 { w.1 } else { e });
    let least = used.into_iter().min()?;
    if w.0 <= 0 || used.into_iter().max()? - least > REACH {
        return None;
    }
    let [x, y, w] = [x, y, w].map(|(m, e)| if m == 0 { 0 } else { m << (e - least) });
    let [x, y] = [
        nearest_even(128 * i128::from(width) * (x + w), w),
        nearest_even(128 * i128::from(height) * (w - y), w),
    ];
    Some([i64::try_from(x).ok()?, i64::try_from(y).ok()?])
}

#[cfg(test)]
mod tests {
    use super::snap;

    #[test]
    fn corners_and_middle_are_where_they_belong() {
        assert_eq!(snap([-1.0, 1.0, 0.0, 1.0], 640, 480), Some([0, 0]));
        assert_eq!(snap([2.5, -2.5, 0.0, 2.5], 640, 480), Some([640 * 256, 480 * 256]));
        assert_eq!(snap([0.0, -0.0, 0.0, 7.0], 640, 480), Some([320 * 256, 240 * 256]));
    }

    #[test]
    fn a_third_of_a_picture_is_rounded_to_the_nearest_and_ties_go_to_even() {
        assert_eq!(snap([1.0, 1.0, 0.0, 3.0], 1, 1), Some([171, 85])); // 170.67 and 85.33
        // With one pixel a sub-pixel is 2⁻⁷: 0.5 and 1.5 sub-pixels from the left.
        let half = |n: f32| snap([n / 256.0 - 1.0, 0.0, 0.0, 1.0], 1, 1).map(|v| v[0]);
        assert_eq!([half(1.0), half(3.0), half(5.0)], [Some(0), Some(2), Some(2)]);
    }

    #[test]
    fn what_has_no_place_has_none() {
        for w in [0.0, -0.0, -1.0, f32::NAN, f32::INFINITY, 1e-30] {
            assert_eq!(snap([1.0, 1.0, 0.5, w], 64, 64), None, "w {w}");
        }
        assert_eq!(snap([f32::NAN, 0.0, 0.0, 1.0], 64, 64), None);
        let tiny = f32::from_bits(1);
        assert_eq!(snap([tiny, tiny, tiny, tiny], 64, 64), Some([64 * 256, 0]), "denormals are numbers");
    }
}
