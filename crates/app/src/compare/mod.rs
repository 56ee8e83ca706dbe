//! How far two pictures are from each other: figures for golden images.
//!
//! ```text
//!   A ─┐  row by row, widened to one depth    codes or distances ─▶ differing, largest, mean, PSNR
//!      ├─▶  [r, g, b, a] beside [r, g, b, a] ─┤
//!   B ─┘                                      └ what is not background ─▶ outlines ─▶ silhouette distance
//! ```
//!
//! Nothing here knows of files: pictures are slices ([`Pixels`]) that the caller has, be it from
//! [`decode`](crate::decode), from a [`Picture`] or from a frame buffer.
//!
//! ```
//! use polosa::compare::{Image, Pixels, Settings, compare};
//!
//! let golden = [[0, 0, 0, 255], [200, 100, 50, 255], [0, 0, 0, 255]];
//! let mut made = golden;
//! made[1][2] = 53;
//! let [golden, made] = [&golden, &made].map(|pixels| Image::new(3, 1, Pixels::Rgba8(pixels)));
//!
//! let figures = compare(&golden?, &made?, &Settings { threshold: 2.0, ..Settings::default() })?;
//! assert!(!figures.same);
//! assert_eq!((figures.differing, figures.max_difference, figures.max_at), (1, 3.0, Some([1, 0])));
//! assert_eq!(figures.silhouette_px, Some(0.0));
//! # Ok::<(), polosa::compare::CompareError>(())
//! ```
//!
//! # The figures
//!
//! - The *difference* of two pixels is the largest of the differences of their channels' codes, alpha included;
//!   codes are taken as they are stored, without regard to what is visible of them.
//! - The *mean* difference and the *PSNR*, `10·log₁₀(largest code² / mean squared difference)`, go over all channels
//!   of all pixels: red, green and blue, and alpha if any pixel of either picture is not opaque.
//! - A picture of 8 bits a channel and one of 16 are compared at 16: codes times 257, by which 255 becomes 65,535.
//! - Distances ([`Pixels::Distances`]) are compared as they are, in their own unit. Two infinities of one sign do
//!   not differ, and neither do two NaN; from everything else they differ infinitely. There is no largest value,
//!   hence no PSNR.
//! - The *silhouette distance* is the Hausdorff distance of the outlines: the farthest that one has to go from a pixel
//!   of either outline to the nearest of the other's, in pixels. An outline is made of the pixels that show something
//!   and have, above, below, to the left or to the right, a neighbour that is [`Background`]. Beyond its edges
//!   nothing is known of a picture: what is cut off by them has no outline there.

mod difference;
mod figures;
mod rows;
mod silhouette;

use polosa_scene::{Color, Picture};

pub use self::difference::difference_picture;
pub use self::figures::compare;

/// The most pixels that a picture may have here: those of the largest picture that is drawn.
///
/// More, and the squares of distances between pixels would leave 64 bits.
pub const MAX_PIXELS: usize = 1 << 28;

/// The pixels of a picture, rows from top to bottom without gaps.
#[derive(Clone, Copy, Debug)]
#[non_exhaustive]
pub enum Pixels<'a> {
    /// Colours as polosa draws them, `0x00RRGGBB`.
    Rgb {
        /// One a pixel.
        colors: &'a [u32],
        /// One a pixel; without, all are opaque.
        alpha: Option<&'a [u8]>,
    },
    /// Red, green, blue, alpha, 8 bits each; alpha is straight.
    Rgba8(&'a [[u8; 4]]),
    /// Red, green, blue, alpha, 16 bits each; alpha is straight.
    Rgba16(&'a [[u16; 4]]),
    /// Distances from the viewer, not finite where nothing is.
    Distances(&'a [f32]),
}

impl Pixels<'_> {
    /// The number of pixels.
    #[must_use]
    pub const fn len(&self) -> usize {
        match self {
            Self::Rgb { colors, .. } => colors.len(),
            Self::Rgba8(pixels) => pixels.len(),
            Self::Rgba16(pixels) => pixels.len(),
            Self::Distances(values) => values.len(),
        }
    }

    /// Whether there is none.
    #[must_use]
    pub const fn is_empty(&self) -> bool {
        self.len() == 0
    }

    /// The largest code of a channel; distances have none.
    #[must_use]
    pub const fn largest_code(&self) -> Option<u16> {
        match self {
            Self::Rgb { .. } | Self::Rgba8(_) => Some(u8::MAX as u16),
            Self::Rgba16(_) => Some(u16::MAX),
            Self::Distances(_) => None,
        }
    }
}

/// A picture to be compared.
///
/// # Guarantees
///
/// There are `width` × `height` pixels, at least one and at most [`MAX_PIXELS`].
#[derive(Clone, Copy, Debug)]
pub struct Image<'a> {
    width: u32,
    height: u32,
    pixels: Pixels<'a>,
}

impl<'a> Image<'a> {
    /// A picture of so many pixels from left to right and from top to bottom.
    ///
    /// # Errors
    ///
    /// When the slices do not have `width` × `height` pixels, or those are none or more than [`MAX_PIXELS`].
    pub fn new(width: u32, height: u32, pixels: Pixels<'a>) -> Result<Self, CompareError> {
        let size = (width as usize).checked_mul(height as usize);
        let size = size.filter(|size| (1..=MAX_PIXELS).contains(size));
        let size = size.ok_or(CompareError::Size { width, height })?;
        let alpha = match pixels {
            Pixels::Rgb { alpha: Some(alpha), .. } => alpha.len(),
            _ => size,
        };
        match [pixels.len(), alpha].into_iter().find(|given| *given != size) {
            Some(given) => Err(CompareError::Length { width, height, given }),
            None => Ok(Self { width, height, pixels }),
        }
    }

    /// The colours of a picture that was drawn, with its alpha if it has any.
    ///
    /// # Errors
    ///
    /// Those of [`Image::new`]; a picture from [`Picture::render`] has none.
    pub fn of(picture: &'a Picture) -> Result<Self, CompareError> {
        let pixels = Pixels::Rgb { colors: &picture.pixels, alpha: picture.alpha.as_deref() };
        Self::new(picture.width, picture.height, pixels)
    }

    /// Pixels from left to right, and from top to bottom.
    #[must_use]
    pub const fn size(&self) -> [u32; 2] {
        [self.width, self.height]
    }

    /// Its pixels.
    #[must_use]
    pub const fn pixels(&self) -> Pixels<'a> {
        self.pixels
    }
}

/// What counts as the same, and what as background.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Settings {
    /// The largest difference of two pixels that is let pass: in codes of the depth at which the pictures are
    /// compared, whose fractions change nothing, or in the distances' unit. What is below 0 or NaN counts as 0.
    pub threshold: f64,
    /// How many pixels may differ by more than that.
    pub allowed_pixels: u64,
    /// What is not part of the silhouettes.
    pub background: Background,
}

impl Default for Settings {
    /// Identical pictures; background is the colour of the first one's corner.
    fn default() -> Self {
        Self { threshold: 0.0, allowed_pixels: 0, background: Background::Corner }
    }
}

/// Which pixels show nothing. A pixel is background if it is no farther from it than the threshold, so that noise
/// that is let pass makes no silhouette.
///
/// In pictures of distances it is always those that are not finite.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
#[non_exhaustive]
pub enum Background {
    /// Those like the upper left corner of the *first* picture, in both pictures. If that is fully transparent, as
    /// [`Background::Transparent`].
    #[default]
    Corner,
    /// Those of alpha 0, whatever their colours.
    Transparent,
    /// Those of this colour, opaque.
    Color(Color),
}

/// How far two pictures are from each other; [the module](self) defines the figures.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub struct Comparison {
    /// Whether at most [`Settings::allowed_pixels`] differ by more than [`Settings::threshold`].
    pub same: bool,
    /// The width of both, in pixels.
    pub width: u32,
    /// The height of both, in pixels.
    pub height: u32,
    /// The largest code at the depth of the comparison, 255 or 65,535; `None`: distances.
    pub largest_code: Option<u16>,
    /// Pixels that differ at all.
    pub differing: u64,
    /// Pixels that differ by more than the threshold.
    pub beyond: u64,
    /// The largest difference, in codes or the distances' unit; infinite where a distance is in one picture only.
    pub max_difference: f64,
    /// The first pixel with this difference, from the left and from the top; `None`: none differs.
    pub max_at: Option<[u32; 2]>,
    /// The mean difference, in codes or the distances' unit.
    pub mean_difference: f64,
    /// The peak signal-to-noise ratio in decibels; `None`: no pixel differs, or distances.
    pub psnr_db: Option<f64>,
    /// The silhouette distance in pixels; `None`: one of the pictures, or both, have no outline.
    pub silhouette_px: Option<f64>,
}

impl Comparison {
    /// The number of pixels of each picture.
    #[must_use]
    pub const fn pixels(&self) -> u64 {
        self.width as u64 * self.height as u64
    }
}

/// Why pictures cannot be compared.
#[derive(Clone, Copy, Debug, PartialEq, Eq, thiserror::Error)]
#[non_exhaustive]
pub enum CompareError {
    /// A picture without pixels or with too many.
    #[error("{width}×{height} pixels: there must be 1 to {MAX_PIXELS} in all")]
    Size {
        /// Pixels from left to right.
        width: u32,
        /// Pixels from top to bottom.
        height: u32,
    },
    /// A slice that does not hold the pixels of the picture.
    #[error("{given} values are not the {width}×{height} of the picture")]
    Length {
        /// Pixels from left to right.
        width: u32,
        /// Pixels from top to bottom.
        height: u32,
        /// The slice's length.
        given: usize,
    },
    /// Pictures of two sizes.
    #[error("{}×{} and {}×{} pixels: only pictures of one size are compared", .a[0], .a[1], .b[0], .b[1])]
    Sizes {
        /// Width and height of the first.
        a: [u32; 2],
        /// Width and height of the second.
        b: [u32; 2],
    },
    /// Colours on one side and distances on the other.
    #[error("one holds colours and the other distances: they have nothing to compare")]
    Kinds,
}

#[cfg(test)]
mod tests {
    use super::{CompareError, Image, MAX_PIXELS, Pixels};

    #[test]
    fn slices_of_another_length_are_refused() {
        let (three, four) = ([0_u32; 3], [0_u8; 4]);
        let image = |width, height, alpha| {
            Image::new(width, height, Pixels::Rgb { colors: &three, alpha }).map(|image| image.size())
        };
        assert_eq!(image(3, 1, None), Ok([3, 1]));
        assert_eq!(image(2, 2, None), Err(CompareError::Length { width: 2, height: 2, given: 3 }));
        assert_eq!(image(3, 1, Some(&four)), Err(CompareError::Length { width: 3, height: 1, given: 4 }));
        assert_eq!(image(0, 3, None), Err(CompareError::Size { width: 0, height: 3 }));
        assert_eq!(
            image(u32::MAX, u32::MAX, None).map_err(|e| matches!(e, CompareError::Size { .. })),
            Err(true)
        );
        assert_eq!(MAX_PIXELS, polosa_raster::MAX_SIDE.pow(2) as usize);
    }
}
