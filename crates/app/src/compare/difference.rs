//! A picture of where two pictures differ.
//!
//! What is the same is the first picture in dark greys, to see where one is; what differs has a colour that nothing
//! grey can be taken for.

use polosa_scene::{DrawStats, Picture};

use super::figures::check_kinds;
use super::rows::{Rgba, code_limit, colors, common_depth, difference, gap};
use super::{CompareError, Image, MAX_PIXELS, Pixels};

/// A pixel that only one of the pictures has.
const OUTSIDE: u32 = 0xff_00_ff;

/// A pixel that differs, but not beyond the threshold.
const WITHIN: u32 = 0x30_60_ff;

/// What is the same is no brighter than this, of 255.
const DIM: u64 = 85;

/// A picture of where two pictures differ, for [`write_picture`](crate::encode::write_picture).
///
/// | pixels | colour |
/// |---|---|
/// | that are the same | the first picture's, grey, at a third of its brightness; distances: near bright, far dark |
/// | that differ, by no more than `threshold` | blue |
/// | that differ by more | from red, for the least, to yellow, for the largest possible (of distances: found) |
/// | that only one picture has, where sizes differ | magenta |
///
/// The picture is as wide as the wider one and as high as the higher one; both begin at its upper left corner.
///
/// # Errors
///
/// When one has colours and the other distances, or when so large a picture has too many pixels.
pub fn difference_picture(a: &Image<'_>, b: &Image<'_>, threshold: f64) -> Result<Picture, CompareError> {
    check_kinds(a, b)?;
    let [width, height] = [0, 1].map(|side| a.size()[side].max(b.size()[side]));
    let size = u64::from(width) * u64::from(height);
    let size = usize::try_from(size).ok().filter(|size| *size <= MAX_PIXELS);
    let mut pixels = vec![OUTSIDE; size.ok_or(CompareError::Size { width, height })?];
    let shared = [0, 1].map(|side| a.size()[side].min(b.size()[side]) as usize);
    let rows = pixels.chunks_exact_mut(width as usize).map(|row| &mut row[..shared[0]]).take(shared[1]);
    match (a.pixels, b.pixels, common_depth(a, b)) {
        (Pixels::Distances(values_a), Pixels::Distances(values_b), _) => {
            let paint = Distances::new(values_a, values_b, threshold);
            for ((row, a), b) in
                rows.zip(values_a.chunks_exact(a.width as usize)).zip(values_b.chunks_exact(b.width as usize))
            {
                for (pixel, (a, b)) in row.iter_mut().zip(a.iter().zip(b)) {
                    *pixel = paint.pixel(*a, *b);
                }
            }
        }
        (_, _, Some(largest)) => {
            let mut rgba = [a, b].map(|image| vec![[0; 4]; image.width as usize]);
            for (y, row) in rows.enumerate() {
                for (image, rgba) in [a, b].into_iter().zip(&mut rgba) {
                    colors(image, y, largest, rgba);
                }
                for (pixel, (a, b)) in row.iter_mut().zip(rgba[0].iter().zip(&rgba[1])) {
                    *pixel = color(*a, *b, largest, code_limit(threshold));
                }
            }
        }
        (_, _, None) => return Err(CompareError::Kinds),
    }
    let stats = DrawStats::default();
    Ok(Picture { width, height, pixels, alpha: None, distances: None, ids: None, stats })
}

fn color(a: Rgba, b: Rgba, largest: u16, limit: u16) -> u32 {
    match difference(a, b) {
        0 => {
            // Rec. 709's weights, of codes, not of light: good enough to recognise things.
            let [r, g, b, alpha] = a.map(u64::from);
            let largest = u64::from(largest);
            grey((2126 * r + 7152 * g + 722 * b) * alpha * DIM / (10_000 * largest * largest))
        }
        difference if difference <= limit => WITHIN,
        difference => hot(f64::from(difference) / f64::from(largest)),
    }
}

/// A grey of this code.
fn grey(code: u64) -> u32 {
    code.min(DIM) as u32 * 0x01_01_01
}

/// Red for 0, yellow for 1.
fn hot(share: f64) -> u32 {
    // The conversion keeps to 0..=255.
    u32::from_be_bytes([0, 255, (share * 255.0).round() as u8, 0])
}

/// How distances are shown.
struct Distances {
    near: f64,
    far: f64,
    largest: f64,
    threshold: f64,
}

impl Distances {
    fn new(a: &[f32], b: &[f32], threshold: f64) -> Self {
        let finite = a.iter().filter(|value| value.is_finite()).map(|value| f64::from(*value));
        let (near, far) = finite
            .fold((f64::INFINITY, f64::NEG_INFINITY), |(near, far), value| (near.min(value), far.max(value)));
        let gaps = a.iter().zip(b).map(|(a, b)| gap(*a, *b)).filter(|gap| gap.is_finite());
        Self { near, far, largest: gaps.fold(0.0, f64::max), threshold: threshold.max(0.0) }
    }

    fn pixel(&self, a: f32, b: f32) -> u32 {
        let gap = gap(a, b);
        if gap == 0.0 {
            // Near is bright, far a third of that, nothing black.
            let depth = (f64::from(a) - self.near) / (self.far - self.near);
            let depth = if depth.is_finite() { depth } else { 0.0 };
            return if a.is_finite() { grey((DIM as f64 * (1.0 - depth * 2.0 / 3.0)) as u64) } else { 0 };
        }
        if gap <= self.threshold {
            return WITHIN;
        }
        hot(if gap.is_finite() { gap / self.largest } else { 1.0 })
    }
}

#[cfg(test)]
mod tests {
    use super::super::{CompareError, Image, Pixels};
    use super::difference_picture;

    #[test]
    fn what_is_the_same_is_dim_and_what_differs_is_not() {
        let a = [[255, 255, 255, 255], [255, 255, 255, 0], [10, 10, 10, 255], [0, 0, 0, 255], [9, 9, 9, 255]];
        let b =
            [[255, 255, 255, 255], [255, 255, 255, 0], [10, 12, 10, 255], [255, 0, 0, 255], [9, 9, 12, 255]];
        let [a, b] = [&a, &b].map(|pixels| Image::new(5, 1, Pixels::Rgba8(pixels)).unwrap());
        let picture = difference_picture(&a, &b, 2.0).unwrap();
        assert_eq!(picture.pixels, [0x55_55_55, 0, 0x30_60_ff, 0xff_ff_00, 0xff_03_00]);
        let strict = difference_picture(&a, &b, 0.0).unwrap();
        assert_eq!(strict.pixels[2], 0xff_02_00);
    }

    #[test]
    fn where_sizes_differ_what_one_alone_has_is_magenta() {
        let (wide, high) = ([0_u32; 3], [0_u32; 2]);
        let wide = Image::new(3, 1, Pixels::Rgb { colors: &wide, alpha: None }).unwrap();
        let high = Image::new(1, 2, Pixels::Rgb { colors: &high, alpha: None }).unwrap();
        let picture = difference_picture(&wide, &high, 0.0).unwrap();
        assert_eq!((picture.width, picture.height), (3, 2));
        let m = 0xff_00_ff;
        assert_eq!(picture.pixels, [0, m, m, m, m, m]);
    }

    #[test]
    fn a_picture_too_large_is_refused() {
        let row = vec![[0_u8; 4]; 100_000];
        let wide = Image::new(100_000, 1, Pixels::Rgba8(&row)).unwrap();
        let high = Image::new(1, 100_000, Pixels::Rgba8(&row)).unwrap();
        let error = difference_picture(&wide, &high, 0.0).unwrap_err();
        assert_eq!(error, CompareError::Size { width: 100_000, height: 100_000 });
    }

    #[test]
    fn distances_are_dim_by_depth_and_hot_by_difference() {
        let inf = f32::INFINITY;
        let a = [1.0, 3.0, inf, 2.0, 2.0, 2.0, 1.0];
        let b = [1.0, 3.0, inf, 2.5, 4.0, inf, 1.25];
        let [a, b] = [&a, &b].map(|values| Image::new(7, 1, Pixels::Distances(values)).unwrap());
        let picture = difference_picture(&a, &b, 0.25).unwrap();
        let expected = [0x55_55_55, 0x1c_1c_1c, 0, 0xff_40_00, 0xff_ff_00, 0xff_ff_00, 0x30_60_ff];
        assert_eq!(picture.pixels, expected);
        let flat = Image::new(1, 1, Pixels::Distances(&[5.0])).unwrap();
        assert_eq!(difference_picture(&flat, &flat, 0.0).unwrap().pixels, [0x55_55_55]);
        let one = [0_u32];
        let colors = Image::new(1, 1, Pixels::Rgb { colors: &one, alpha: None }).unwrap();
        assert_eq!(difference_picture(&flat, &colors, 0.0).unwrap_err(), CompareError::Kinds);
    }
}
