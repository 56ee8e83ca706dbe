//! Pictures as files: the format from the extension, the bytes row by row.
//!
//! PNG goes through the `png` crate directly, so that rows are made, filtered, compressed and written one at a
//! time and the picture never exists twice. The other formats are those that `image` writes without a library of
//! its own; they are put together in memory first.
//!
//! The same picture gives the same bytes, always: no time stamps, no threads, fixed settings.

use std::ffi::OsStr;
use std::fmt;
use std::io::{self, Write};
use std::path::Path;

use image::codecs::{bmp, jpeg, pnm, qoi, tga};
use image::{ExtendedColorType, ImageEncoder as _};
use polosa_scene::Picture;

use crate::error::Error;
use crate::output::Destination;

/// The quality of JPEG files, of 100: edges of flat areas stay clean at this one.
const JPEG_QUALITY: u8 = 95;

/// How hard PNG is compressed, and how its rows are prepared for that.
///
/// Measured on pictures of 1920×1080 of a dense mesh plain, with 16 samples, and with its edges: level 1 takes
/// 8 to 12 ms and gives 313, 232 and 421 kB; the fastest compressor takes 4 to 8 ms and gives 393, 276 and 1013 kB;
/// level 2 takes twice the time for a fifth less. Among the filters none is best everywhere; this one is never bad.
const PNG_LEVEL: png::DeflateCompression = png::DeflateCompression::Level(1);
const PNG_FILTER: png::Filter = png::Filter::Sub;

/// A picture format that can be written.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[non_exhaustive]
pub enum ImageFormat {
    /// PNG, 24 bits, 32 with transparency.
    Png,
    /// Windows bitmap.
    Bmp,
    /// Truevision TGA, run-length encoded.
    Tga,
    /// Quite OK Image.
    Qoi,
    /// Portable pixmap, binary (P6). No transparency.
    Ppm,
    /// JPEG. No transparency, and not the exact colours.
    Jpeg,
}

/// A file name whose extension names no [`ImageFormat`].
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct UnknownFormat(Option<String>);

impl fmt::Display for UnknownFormat {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match &self.0 {
            Some(extension) => write!(f, "no picture format has the extension .{extension}")?,
            None => f.write_str("the name has no extension that says which picture format it is")?,
        }
        let known: Vec<String> =
            ImageFormat::ALL.iter().flat_map(|format| format.extensions()).map(|e| format!(".{e}")).collect();
        write!(f, ": use {}", known.join(", "))
    }
}

impl std::error::Error for UnknownFormat {}

impl ImageFormat {
    /// All formats.
    pub const ALL: [Self; 6] = [Self::Png, Self::Bmp, Self::Tga, Self::Qoi, Self::Ppm, Self::Jpeg];

    /// The extensions that name the format, in lower case.
    #[must_use]
    pub const fn extensions(self) -> &'static [&'static str] {
        match self {
            Self::Png => &["png"],
            Self::Bmp => &["bmp"],
            Self::Tga => &["tga"],
            Self::Qoi => &["qoi"],
            Self::Ppm => &["ppm", "pnm"],
            Self::Jpeg => &["jpg", "jpeg"],
        }
    }

    /// The format that a file's extension names, upper or lower case.
    ///
    /// # Errors
    ///
    /// When it names none; the error lists all.
    pub fn from_path(path: &Path) -> Result<Self, UnknownFormat> {
        let Some(extension) = path.extension().map(OsStr::to_string_lossy) else {
            return Err(UnknownFormat(None));
        };
        Self::ALL
            .into_iter()
            .find(|format| format.extensions().iter().any(|known| known.eq_ignore_ascii_case(&extension)))
            .ok_or_else(|| UnknownFormat(Some(crate::error::one_line(&extension))))
    }

    /// Whether the format keeps transparency.
    #[must_use]
    pub const fn has_alpha(self) -> bool {
        matches!(self, Self::Png | Self::Bmp | Self::Tga | Self::Qoi)
    }

    /// Whether the format keeps every colour as it is.
    #[must_use]
    pub const fn is_lossless(self) -> bool {
        !matches!(self, Self::Jpeg)
    }
}

/// Makes a picture and writes it where it is to go: whole, or not at all. What would prevent the writing is found out
/// before anything is drawn.
///
/// # Errors
///
/// What `make` returns, and [`Error::Write`].
pub fn save_picture(
    to: &Destination,
    format: ImageFormat,
    make: impl FnOnce() -> Result<Picture, Error>,
) -> Result<(), Error> {
    to.check()?;
    let picture = make()?;
    let mut output = to.create()?;
    output.fill(|out| write_picture(out, format, &picture))?;
    output.commit()
}

/// Writes a picture's colours, with its alpha channel if it has one and the format too.
///
/// # Errors
///
/// What `out` reports.
pub fn write_picture(out: &mut dyn Write, format: ImageFormat, picture: &Picture) -> io::Result<()> {
    let Picture { width, height, pixels, .. } = picture;
    let w = *width as usize;
    match picture.alpha.as_ref().filter(|_| format.has_alpha()) {
        None => {
            encode(out, format, [*width, *height], Bytes::Color, |y, row| put_rgb(&pixels[y * w..][..w], row))
        }
        Some(alpha) => encode(out, format, [*width, *height], Bytes::ColorAlpha, |y, row| {
            let pixels = pixels[y * w..][..w].iter().zip(&alpha[y * w..][..w]);
            for (rgba, (pixel, alpha)) in row.chunks_exact_mut(4).zip(pixels) {
                let [_, r, g, b] = pixel.to_be_bytes();
                rgba.copy_from_slice(&[r, g, b, *alpha]);
            }
        }),
    }
}

/// Writes `width` × `height` numbers below 2²⁴ as colours, `0xRRGGBB`: the picture of
/// [`Picture::ids`], from which a program reads back which triangle is seen where.
///
/// # Errors
///
/// What `out` reports; [`io::ErrorKind::InvalidInput`] for a wrong number of values or a format that does not keep
/// them.
pub fn write_ids(
    out: &mut dyn Write,
    format: ImageFormat,
    width: u32,
    height: u32,
    ids: &[u32],
) -> io::Result<()> {
    let w = width as usize;
    if w.checked_mul(height as usize) != Some(ids.len()) || !format.is_lossless() {
        let message = format!("{} numbers for {width}×{height} pixels of {format:?}", ids.len());
        return Err(io::Error::new(io::ErrorKind::InvalidInput, message));
    }
    encode(out, format, [width, height], Bytes::Numbers, |y, row| put_rgb(&ids[y * w..][..w], row))
}

fn put_rgb(pixels: &[u32], row: &mut [u8]) {
    for (rgb, pixel) in row.chunks_exact_mut(3).zip(pixels) {
        let [_, r, g, b] = pixel.to_be_bytes();
        rgb.copy_from_slice(&[r, g, b]);
    }
}

/// What the bytes of a row are.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Bytes {
    /// Red, green, blue.
    Color,
    /// Red, green, blue, alpha.
    ColorAlpha,
    /// As [`Bytes::Color`], but not to be looked at: nothing in the file says sRGB.
    Numbers,
}

/// Writes a picture whose row `y` is filled in by `fill(y, row)`.
fn encode(
    out: &mut dyn Write,
    format: ImageFormat,
    size: [u32; 2],
    bytes: Bytes,
    fill: impl Fn(usize, &mut [u8]),
) -> io::Result<()> {
    let [width, height] = size;
    let per_pixel = if bytes == Bytes::ColorAlpha { 4 } else { 3 };
    let stride = per_pixel * width as usize;
    if format == ImageFormat::Png {
        return encode_png(out, size, bytes, stride, fill);
    }

    let mut data = vec![0; stride * height as usize];
    for (y, row) in data.chunks_exact_mut(stride).enumerate() {
        fill(y, row);
    }
    let color = if per_pixel == 4 { ExtendedColorType::Rgba8 } else { ExtendedColorType::Rgb8 };
    let written = match format {
        ImageFormat::Bmp => bmp::BmpEncoder::new(&mut &mut *out).write_image(&data, width, height, color),
        ImageFormat::Tga => tga::TgaEncoder::new(out).write_image(&data, width, height, color),
        ImageFormat::Qoi => qoi::QoiEncoder::new(out).write_image(&data, width, height, color),
        ImageFormat::Png | ImageFormat::Ppm => pnm::PnmEncoder::new(out)
            .with_subtype(pnm::PnmSubtype::Pixmap(pnm::SampleEncoding::Binary))
            .write_image(&data, width, height, color),
        ImageFormat::Jpeg => {
            jpeg::JpegEncoder::new_with_quality(out, JPEG_QUALITY).write_image(&data, width, height, color)
        }
    };
    written.map_err(|error| match error {
        image::ImageError::IoError(error) => error,
        other => io::Error::other(other),
    })
}

fn encode_png(
    out: &mut dyn Write,
    [width, height]: [u32; 2],
    bytes: Bytes,
    stride: usize,
    fill: impl Fn(usize, &mut [u8]),
) -> io::Result<()> {
    let mut encoder = png::Encoder::new(out, width, height);
    encoder.set_color(if bytes == Bytes::ColorAlpha { png::ColorType::Rgba } else { png::ColorType::Rgb });
    encoder.set_depth(png::BitDepth::Eight);
    encoder.set_deflate_compression(PNG_LEVEL);
    encoder.set_filter(PNG_FILTER);
    if bytes != Bytes::Numbers {
        encoder.set_source_srgb(png::SrgbRenderingIntent::Perceptual);
    }
    let mut writer = encoder.write_header()?;
    let mut rows = writer.stream_writer_with_size(1 << 16)?;
    let mut row = vec![0; stride];
    for y in 0..height as usize {
        fill(y, &mut row);
        rows.write_all(&row)?;
    }
    rows.finish()?;
    writer.finish()?;
    Ok(())
}

#[cfg(test)]
mod tests {
    use std::path::Path;

    use polosa_scene::{DrawStats, Picture};
    use proptest::prelude::*;

    use super::{ImageFormat, write_ids, write_picture};

    fn decode(format: ImageFormat, bytes: &[u8]) -> image::RgbaImage {
        let format = image::ImageFormat::from_extension(format.extensions()[0]).unwrap();
        image::load_from_memory_with_format(bytes, format).unwrap().into_rgba8()
    }

    fn picture(width: u32, height: u32, pixels: Vec<u32>, alpha: Option<Vec<u8>>) -> Picture {
        let stats = DrawStats::default();
        Picture { width, height, pixels, alpha, distances: None, ids: None, stats }
    }

    fn pixels() -> impl Strategy<Value = (u32, u32, Vec<u32>, Vec<u8>)> {
        (1..20_u32, 1..20_u32).prop_flat_map(|(width, height)| {
            let size = (width * height) as usize;
            let pixels = proptest::collection::vec(0..=0xff_ffff_u32, size);
            (Just(width), Just(height), pixels, proptest::collection::vec(any::<u8>(), size))
        })
    }

    proptest! {
        #[test]
        fn lossless_formats_keep_every_pixel((width, height, colors, alpha) in pixels()) {
            for format in ImageFormat::ALL.into_iter().filter(|format| format.is_lossless()) {
                let mut plain = Vec::new();
                write_picture(&mut plain, format, &picture(width, height, colors.clone(), None)).unwrap();
                let mut numbers = Vec::new();
                write_ids(&mut numbers, format, width, height, &colors).unwrap();
                for bytes in [plain, numbers] {
                    let back = decode(format, &bytes);
                    prop_assert_eq!(back.dimensions(), (width, height));
                    for (pixel, color) in back.pixels().zip(&colors) {
                        let [_, r, g, b] = color.to_be_bytes();
                        prop_assert_eq!(pixel.0, [r, g, b, 255]);
                    }
                }
                if format.has_alpha() {
                    let mut bytes = Vec::new();
                    write_picture(&mut bytes, format, &picture(width, height, colors.clone(), Some(alpha.clone()))).unwrap();
                    for ((pixel, color), alpha) in decode(format, &bytes).pixels().zip(&colors).zip(&alpha) {
                        let [_, r, g, b] = color.to_be_bytes();
                        prop_assert_eq!(pixel.0, [r, g, b, *alpha]);
                    }
                }
            }
        }
    }

    #[test]
    fn extensions_name_formats_in_either_case_and_others_are_refused_with_a_list() {
        assert_eq!(ImageFormat::from_path(Path::new("a/b.c.PnG")), Ok(ImageFormat::Png));
        assert_eq!(ImageFormat::from_path(Path::new("x.JPEG")), Ok(ImageFormat::Jpeg));
        for name in ["png", "x.", "x.xyz", ".png", "x.pn\ng"] {
            let text = ImageFormat::from_path(Path::new(name)).unwrap_err().to_string();
            assert!(text.contains(".png") && text.contains(".ppm") && !text.contains('\n'), "{text}");
        }
    }

    #[test]
    fn a_wrong_number_of_ids_or_a_format_that_changes_them_is_refused() {
        assert!(write_ids(&mut Vec::new(), ImageFormat::Png, 2, 2, &[1, 2, 3]).is_err());
        assert!(write_ids(&mut Vec::new(), ImageFormat::Jpeg, 1, 1, &[1]).is_err());
    }
}
