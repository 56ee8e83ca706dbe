//! Rows of two pictures at one depth: whatever they are stored as, they are compared as the same kind of number.

use super::{Image, Pixels};

/// Red, green, blue, alpha.
pub(super) type Rgba = [u16; 4];

/// What 8-bit codes are multiplied by to become 16-bit ones: 255 · 257 = 65,535.
const WIDEN: u16 = 257;

/// The largest code at which two pictures of colours are compared: that of the deeper one. `None` when one has
/// distances.
pub(super) fn common_depth(a: &Image<'_>, b: &Image<'_>) -> Option<u16> {
    Some(a.pixels.largest_code()?.max(b.pixels.largest_code()?))
}

/// Fills `row`, as wide as the picture, with row `y`, codes up to `largest`. Distances have no codes and leave it.
pub(super) fn colors(image: &Image<'_>, y: usize, largest: u16, row: &mut [Rgba]) {
    let width = image.width as usize;
    let start = y * width;
    let widen = if largest == u16::MAX { WIDEN } else { 1 };
    match image.pixels {
        Pixels::Rgb { colors, alpha } => {
            for (rgba, color) in row.iter_mut().zip(&colors[start..][..width]) {
                let [_, r, g, b] = color.to_be_bytes();
                *rgba = [r, g, b, u8::MAX].map(|code| u16::from(code) * widen);
            }
            for (rgba, alpha) in row.iter_mut().zip(alpha.map_or(&[][..], |alpha| &alpha[start..][..width])) {
                rgba[3] = u16::from(*alpha) * widen;
            }
        }
        Pixels::Rgba8(pixels) => {
            for (rgba, pixel) in row.iter_mut().zip(&pixels[start..][..width]) {
                *rgba = pixel.map(|code| u16::from(code) * widen);
            }
        }
        Pixels::Rgba16(pixels) => row.copy_from_slice(&pixels[start..][..width]),
        Pixels::Distances(_) => {}
    }
}

/// The difference of two pixels: the largest of their channels'.
pub(super) fn difference(a: Rgba, b: Rgba) -> u16 {
    let [r, g, b, alpha] = [0, 1, 2, 3].map(|c: usize| a[c].abs_diff(b[c]));
    r.max(g).max(b).max(alpha)
}

/// The difference of two distances: 0 for what is equal or both not a number, infinite where one has no finite
/// difference from the other.
pub(super) fn gap(a: f32, b: f32) -> f64 {
    // Infinities of one sign are equal; their difference would be no number.
    if a == b || (a.is_nan() && b.is_nan()) {
        return 0.0;
    }
    let gap = (f64::from(a) - f64::from(b)).abs();
    if gap.is_nan() { f64::INFINITY } else { gap }
}

/// The largest difference of codes that a threshold lets pass.
pub(super) fn code_limit(threshold: f64) -> u16 {
    // The conversion rounds down, and makes 0 of NaN and of what is below it; no difference exceeds 65,535.
    threshold as u16
}

#[cfg(test)]
mod tests {
    use super::super::{Image, Pixels};
    use super::{code_limit, colors, common_depth, difference, gap};

    #[test]
    fn a_picture_has_the_same_row_however_it_is_stored() {
        let words = [0x00_01_02_03, 0xff_80_ff_00];
        let bytes = [[1, 2, 3, 255], [128, 255, 0, 7]];
        let wide = bytes.map(|pixel| pixel.map(|code: u8| u16::from(code) * 257));
        let all = [
            Pixels::Rgb { colors: &words, alpha: Some(&[255, 7]) },
            Pixels::Rgba8(&bytes),
            Pixels::Rgba16(&wide),
        ];
        for pixels in all {
            let image = Image::new(1, 2, pixels).unwrap();
            let mut row = [[0; 4]];
            colors(&image, 1, 65_535, &mut row);
            assert_eq!(row, [[128 * 257, 65_535, 0, 7 * 257]], "{pixels:?}");
        }
        let [a, b, c] = all.map(|pixels| Image::new(2, 1, pixels).unwrap());
        assert_eq!((common_depth(&a, &b), common_depth(&b, &c)), (Some(255), Some(65_535)));
        let far = Image::new(2, 1, Pixels::Distances(&[1.0, 2.0])).unwrap();
        assert_eq!(common_depth(&a, &far), None);
    }

    #[test]
    fn the_farthest_channel_is_the_difference() {
        assert_eq!(difference([5, 9, 1, 255], [7, 0, 1, 255]), 9);
        assert_eq!(difference([0, 0, 0, 255], [0, 0, 0, 0]), 255);
    }

    #[test]
    fn what_is_no_number_differs_from_numbers_alone() {
        let (inf, nan) = (f32::INFINITY, f32::NAN);
        for (a, b, expected) in [
            (1.5, 1.0, 0.5),
            (0.0, -0.0, 0.0),
            (inf, inf, 0.0),
            (nan, -nan, 0.0),
            (inf, 1.0, f64::INFINITY),
            (inf, -inf, f64::INFINITY),
            (nan, 1.0, f64::INFINITY),
            (nan, inf, f64::INFINITY),
            (f32::MAX, -f32::MAX, 2.0 * f64::from(f32::MAX)),
        ] {
            assert_eq!((gap(a, b), gap(b, a)), (expected, expected), "{a} {b}");
        }
    }

    #[test]
    fn thresholds_are_whole_codes_and_never_below_none() {
        let limits = [2.0, 2.9, -1.0, f64::NAN, f64::INFINITY].map(code_limit);
        assert_eq!(limits, [2, 2, 0, 0, 65_535]);
    }
}
