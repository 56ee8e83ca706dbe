//! sRGB: 8-bit codes to linear light and back, correctly rounded both ways.
//!
//! The curve is IEC 61966-2-1's. It is evaluated with `libm`, the same bits everywhere, and only to make two
//! tables, once a process: what each code decodes to, and from which value on each code is the nearest one.
//! Encoding looks up a guess by the value's leading bits and compares with the next threshold, so that it is
//! exact for every `f32`.

use std::sync::LazyLock;

/// Bits of an `f32` that index the guesses: all of the exponent, seven of the mantissa.
const SHIFT: u32 = 16;

struct Tables {
    linear: [f32; 256],
    /// The least value whose code is greater than the index.
    above: [f32; 255],
    /// For the leading bits of a value, from those of `above[0]` on, the code of the least such value.
    guesses: Vec<u8>,
    first: u32,
}

static TABLES: LazyLock<Tables> = LazyLock::new(|| {
    let linear = std::array::from_fn(|code| decode_exact(code as f64 / 255.0) as f32);
    let above: [f32; 255] = std::array::from_fn(|code| {
        let threshold = decode_exact((code as f64 + 0.5) / 255.0);
        let nearest = threshold as f32;
        if f64::from(nearest) < threshold { nearest.next_up() } else { nearest }
    });
    let first = above[0].to_bits() >> SHIFT;
    let last = 1_f32.to_bits() >> SHIFT;
    let guesses = (first..last)
        .map(|bits| {
            u8::try_from(above.partition_point(|&t| t <= f32::from_bits(bits << SHIFT))).unwrap_or(255)
        })
        .collect();
    Tables { linear, above, guesses, first }
});

fn decode_exact(code: f64) -> f64 {
    if code <= 0.04045 { code / 12.92 } else { libm::pow((code + 0.055) / 1.055, 2.4) }
}

/// The linear light of an sRGB code, from 0 to 1.
#[inline]
#[must_use]
pub fn decode(code: u8) -> f32 {
    TABLES.linear[usize::from(code)]
}

/// The sRGB code nearest to a linear light; what is outside of 0 to 1 goes to the nearer end, NaN to 0.
///
/// ```
/// use polosa_scene::srgb::{decode, encode};
///
/// assert!((0..=255).all(|code| encode(decode(code)) == code));
/// assert_eq!(encode(0.5), 188);
/// ```
#[inline]
#[must_use]
pub fn encode(light: f32) -> u8 {
    let tables = &*TABLES;
    if light >= 1.0 {
        return 255;
    }
    let Some(index) = (light >= tables.above[0]).then(|| (light.to_bits() >> SHIFT) - tables.first) else {
        return 0;
    };
    let mut code = tables.guesses[index as usize];
    while code < 255 && light >= tables.above[usize::from(code)] {
        code += 1;
    }
    code
}

/// The least linear light whose code is greater than `code`, which is not 255.
pub(crate) fn least_above(code: u8) -> f32 {
    TABLES.above[usize::from(code)]
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The forward curve, as the standard prints it.
    fn encode_exact(light: f64) -> f64 {
        255.0 * if light <= 0.003_130_8 { 12.92 * light } else { 1.055 * light.powf(1.0 / 2.4) - 0.055 }
    }

    #[test]
    fn every_code_times_every_shade_is_the_nearest_code() {
        for code in 0..=255 {
            for shade in 0..=1000_u16 {
                let light = decode(code) * (f32::from(shade) / 1000.0);
                let exact = encode_exact(light.into());
                let error = (f64::from(encode(light)) - exact).abs();
                assert!(error <= 0.5 + 1e-6, "code {code}, shade {shade}: {error}");
            }
        }
    }

    #[test]
    fn thresholds_are_sharp_and_ends_are_clamped() {
        for code in 0..255_u8 {
            let above = TABLES.above[usize::from(code)];
            assert_eq!(encode(above), code + 1);
            assert_eq!(encode(above.next_down()), code);
        }
        for (light, code) in [(-1.0, 0), (0.0, 0), (f32::NAN, 0), (1.0, 255), (f32::INFINITY, 255)] {
            assert_eq!(encode(light), code, "{light}");
        }
    }
}
