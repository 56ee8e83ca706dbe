//! Pictures read back: every format that [`encode`](crate::encode) and [`pfm`] write.
//!
//! The content decides what a file is, not its name. TGA, which begins with no mark of its own, is taken for what has
//! a header that makes sense as such. Codes come as they are stored: no colour profile, no gamma is applied. Pictures
//! of 16 bits a channel keep them; grey ones and those with a palette become red, green and blue.

use std::fs::File;
use std::io::{Cursor, Read};
use std::path::Path;

use image::{DynamicImage, ImageDecoder as _, ImageError, ImageFormat, ImageReader, Limits};

use crate::compare::{CompareError, Image, MAX_PIXELS, Pixels};
use crate::error::{Error, one_line};
use crate::pfm;

mod complete;

/// The largest file that is read, in bytes: room for the largest picture, uncompressed.
pub const MAX_FILE: u64 = 1 << 31;

/// Bytes at the beginning from which a format is known. No more of a file is read before that is settled, so that
/// what never ends (`/dev/zero`) is refused.
const HEAD: u64 = 18;

/// A picture that was read.
#[derive(Clone, Debug)]
pub struct Decoded {
    width: u32,
    height: u32,
    format: &'static str,
    stored: Stored,
}

#[derive(Clone, Debug)]
enum Stored {
    /// Four a pixel.
    Bytes(Vec<u8>),
    /// Four a pixel.
    Words(Vec<u16>),
    Distances(Vec<f32>),
}

impl Decoded {
    /// Reads a file.
    ///
    /// # Errors
    ///
    /// [`Error::File`] when it cannot be read, is of no known format, is damaged, or has more than [`MAX_PIXELS`] or
    /// more than there is memory for.
    pub fn load(path: &Path) -> Result<Self, Error> {
        let failed = |error: std::io::Error| {
            let what = match error.kind() {
                std::io::ErrorKind::NotFound => "no such file: check the path".to_owned(),
                std::io::ErrorKind::PermissionDenied => "no permission to read it".to_owned(),
                _ => format!("cannot be read: {}", one_line(&error.to_string())),
            };
            Error::file(path, what)
        };
        let file = File::open(path).map_err(failed)?;
        if file.metadata().map_err(failed)?.is_dir() {
            return Err(Error::file(path, "is a folder: name a file in it"));
        }
        Self::read(file, path)
    }

    /// Reads what a reader has, to its end; `name` is for messages.
    ///
    /// # Errors
    ///
    /// As [`Decoded::load`].
    pub fn read(mut from: impl Read, name: &Path) -> Result<Self, Error> {
        let mut bytes = Vec::new();
        let mut up_to = |most: u64, bytes: &mut Vec<u8>| {
            let read = (&mut from).take(most - bytes.len() as u64).read_to_end(bytes);
            read.map_err(|error| {
                Error::file(name, format!("cannot be read: {}", one_line(&error.to_string())))
            })
        };
        up_to(HEAD, &mut bytes)?;
        let Some(kind) = Kind::of(&bytes) else {
            let what = if bytes.is_empty() {
                "is empty"
            } else {
                "is no picture that is known here: use PNG, BMP, TGA, QOI, PPM, JPEG or PFM"
            };
            return Err(Error::file(name, what));
        };
        up_to(MAX_FILE + 1, &mut bytes)?;
        if bytes.len() as u64 > MAX_FILE {
            let most = MAX_FILE >> 30;
            return Err(Error::file(name, format!("is larger than {most} GiB, the most that is read")));
        }
        match kind {
            Kind::Pfm => distances(&bytes, name),
            Kind::Image(format, label) => colors(&bytes, format, label, name),
        }
    }

    /// Pixels from left to right, and from top to bottom.
    #[must_use]
    pub const fn size(&self) -> [u32; 2] {
        [self.width, self.height]
    }

    /// What the file was: `PNG`, `PFM`, …
    #[must_use]
    pub const fn format(&self) -> &'static str {
        self.format
    }

    /// The picture, to be compared.
    ///
    /// # Errors
    ///
    /// None that is known of: the size was checked when the picture was read.
    pub fn image(&self) -> Result<Image<'_>, CompareError> {
        let pixels = match &self.stored {
            Stored::Bytes(codes) => Pixels::Rgba8(codes.as_chunks().0),
            Stored::Words(codes) => Pixels::Rgba16(codes.as_chunks().0),
            Stored::Distances(values) => Pixels::Distances(values),
        };
        Image::new(self.width, self.height, pixels)
    }
}

/// What a file is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Kind {
    Pfm,
    Image(ImageFormat, &'static str),
}

impl Kind {
    fn of(head: &[u8]) -> Option<Self> {
        let begins = |mark: &[u8]| head.starts_with(mark);
        let kind = match head {
            _ if begins(b"\x89PNG\r\n\x1a\n") => Self::Image(ImageFormat::Png, "PNG"),
            _ if begins(b"\xff\xd8\xff") => Self::Image(ImageFormat::Jpeg, "JPEG"),
            _ if begins(b"qoif") => Self::Image(ImageFormat::Qoi, "QOI"),
            _ if begins(b"BM") => Self::Image(ImageFormat::Bmp, "BMP"),
            [b'P', b'f' | b'F', after, ..] if after.is_ascii_whitespace() => Self::Pfm,
            [b'P', b'1'..=b'7', after, ..] if after.is_ascii_whitespace() || *after == b'#' => {
                Self::Image(ImageFormat::Pnm, "PNM")
            }
            // Colour map or not, what kind of pixels, five bytes about the map, ..., bits a pixel.
            [_, 0 | 1, 1..=3 | 9..=11, .., 8 | 15 | 16 | 24 | 32, _] if head.len() == HEAD as usize => {
                Self::Image(ImageFormat::Tga, "TGA")
            }
            _ => return None,
        };
        Some(kind)
    }
}

fn distances(bytes: &[u8], name: &Path) -> Result<Decoded, Error> {
    let failed = |error: pfm::PfmError| Error::file(name, format!("this PFM {error}"));
    let header = pfm::Header::of(bytes).map_err(failed)?;
    let [width, height] = header.size();
    check_size(width, height, name)?;
    let values = header.values().map_err(failed)?;
    Ok(Decoded { width, height, format: "PFM", stored: Stored::Distances(values) })
}

fn colors(bytes: &[u8], format: ImageFormat, label: &'static str, name: &Path) -> Result<Decoded, Error> {
    let failed = |error: ImageError| {
        let what = match error {
            // The decoders wrap what they met; that it ended is all that there is to it.
            ImageError::IoError(error) if error.kind() == std::io::ErrorKind::UnexpectedEof => {
                format!("this {label} ends too early: it is damaged")
            }
            ImageError::Limits(_) => format!("this {label} needs more memory than pictures may have"),
            other => format!("this {label} cannot be read: {}", one_line(&other.to_string())),
        };
        Error::file(name, what)
    };
    if !complete::is_complete(bytes, format) {
        return Err(Error::file(name, format!("this {label} ends too early: it is damaged")));
    }
    let mut reader = ImageReader::with_format(Cursor::new(bytes), format);
    let mut limits = Limits::no_limits();
    // Four channels of 16 bits, and as much again for what decoders keep besides.
    limits.max_alloc = Some(16 * MAX_PIXELS as u64);
    reader.limits(limits);
    let decoder = reader.into_decoder().map_err(failed)?;
    let (width, height) = decoder.dimensions();
    check_size(width, height, name)?;
    // The picture as the decoder makes it, and that with four channels made of it.
    let deep = decoder.color_type().bytes_per_pixel() / decoder.color_type().channel_count() > 1;
    let made = decoder.total_bytes() + u64::from(width) * u64::from(height) * if deep { 8 } else { 4 };
    reserve(made, SMALLER, name)?;
    let stored = match DynamicImage::from_decoder(decoder).map_err(failed)? {
        picture if deep => Stored::Words(picture.into_rgba16().into_raw()),
        picture => Stored::Bytes(picture.into_rgba8().into_raw()),
    };
    Ok(Decoded { width, height, format: label, stored })
}

/// Refuses sizes of which no picture can be compared.
fn check_size(width: u32, height: u32, name: &Path) -> Result<(), Error> {
    if (1..=MAX_PIXELS as u64).contains(&(u64::from(width) * u64::from(height))) {
        return Ok(());
    }
    Err(Error::file(name, format!("has {width}×{height} pixels: there must be 1 to {MAX_PIXELS} in all")))
}

/// What to do where pictures that are read do not fit.
pub(crate) const SMALLER: &str = "use smaller pictures";

/// Asks whether there is memory for so many bytes, since running out of it on the way would end the program without
/// a word.
/// `advice` says what to do where there is none.
pub(crate) fn reserve(bytes: u64, advice: &str, name: &Path) -> Result<(), Error> {
    let room = usize::try_from(bytes).unwrap_or(usize::MAX);
    Vec::<u8>::new().try_reserve_exact(room).map_err(|_| {
        Error::file(name, format!("needs {} MiB of memory, which are not free: {advice}", bytes >> 20))
    })
}

#[cfg(test)]
mod tests {
    use std::path::Path;

    use polosa_scene::{DrawStats, Picture};
    use proptest::prelude::*;

    use super::{Decoded, MAX_PIXELS};
    use crate::compare::{Image, Pixels, Settings, compare};
    use crate::encode::{ImageFormat, write_picture};

    fn read(bytes: &[u8]) -> Result<Decoded, String> {
        Decoded::read(bytes, Path::new("x")).map_err(|error| error.to_string())
    }

    fn picture(alpha: Option<Vec<u8>>) -> Picture {
        let pixels = vec![0x01_02_03, 0xff_fe_fd, 0x80_00_ff, 0x00_ff_00, 0x12_34_56, 0];
        let stats = DrawStats::default();
        Picture { width: 3, height: 2, pixels, alpha, distances: None, ids: None, stats }
    }

    #[test]
    fn every_lossless_format_is_read_back_as_it_was_written() {
        for alpha in [None, Some(vec![0, 255, 1, 254, 7, 128])] {
            let picture = picture(alpha);
            for format in ImageFormat::ALL.into_iter().filter(|format| format.is_lossless()) {
                if picture.alpha.is_some() && !format.has_alpha() {
                    continue;
                }
                let mut bytes = Vec::new();
                write_picture(&mut bytes, format, &picture).unwrap();
                let decoded = read(&bytes).unwrap();
                let [a, b] = [Image::of(&picture), decoded.image()].map(Result::unwrap);
                let found = compare(&a, &b, &Settings::default()).unwrap();
                assert!(found.same, "{format:?} {found:?}");
            }
        }
    }

    #[test]
    fn sixteen_bits_are_kept_and_grey_has_three_equal_channels() {
        let deep = read(b"P6 1 1 65535 \x01\x02\xff\xff\x00\x00").unwrap();
        assert!(matches!(deep.image().unwrap().pixels(), Pixels::Rgba16(&[[0x0102, 0xffff, 0, 0xffff]])));
        let grey = read(b"P5 2 1 255 \x07\xff").unwrap();
        assert_eq!((grey.size(), grey.format()), ([2, 1], "PNM"));
        assert!(matches!(
            grey.image().unwrap().pixels(),
            Pixels::Rgba8(&[[7, 7, 7, 255], [255, 255, 255, 255]])
        ));
    }

    #[test]
    fn what_is_damaged_or_unknown_is_refused_in_one_line() {
        let mut png = Vec::new();
        write_picture(&mut png, ImageFormat::Png, &picture(None)).unwrap();
        let mut flipped = png.clone();
        let middle = flipped.len() / 2;
        flipped[middle] ^= 0x10;
        let cases: [(&[u8], &str); 8] = [
            (b"", "is empty"),
            (b"hello", "no picture that is known"),
            (&[0; 1000], "no picture that is known"),
            (&png[..png.len() - 20], "PNG"),
            (&flipped, "PNG"),
            (b"P6 2 2 255 \0\0\0", "PNM ends too early"),
            (b"Pf 2 2 -1 \0\0\0", "this PFM ends too early: 3 of 16 bytes"),
            (b"PF 2 2 -1 \0\0\0", "three channels"),
        ];
        for (bytes, substance) in cases {
            let error = read(bytes).unwrap_err();
            assert!(error.starts_with("x: ") && error.contains(substance), "{error}");
            assert_eq!(error.lines().count(), 1, "{error}");
        }
    }

    #[test]
    fn no_format_is_read_that_is_cut_short() {
        for format in ImageFormat::ALL {
            let mut bytes = Vec::new();
            write_picture(&mut bytes, format, &picture(None)).unwrap();
            assert!(read(&bytes).is_ok(), "{format:?}");
            for left in 0..bytes.len() {
                let found = read(&bytes[..left]);
                assert!(found.is_err(), "{format:?}: {left} of {} bytes", bytes.len());
            }
        }
    }

    #[test]
    fn huge_sizes_in_small_files_are_refused_before_memory_is_taken() {
        let mut qoi = b"qoif\xff\xff\xff\xff\xff\xff\xff\xff\x03\x00".to_vec();
        qoi.extend([0; 20]);
        for bytes in [b"P6 4000000000 4000000000 255 \0\0\0".as_slice(), b"P6 20000 20000 255 \0\0\0", &qoi] {
            let error = read(bytes).unwrap_err();
            assert!(error.contains(&MAX_PIXELS.to_string()) || error.contains("cannot be read"), "{error}");
        }
    }

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(512))]
        #[test]
        fn no_change_of_a_files_bytes_makes_reading_panic(
            which in 0..ImageFormat::ALL.len(),
            changes in proptest::collection::vec((any::<prop::sample::Index>(), any::<u8>()), 1..6),
            cut in any::<prop::sample::Index>(),
        ) {
            let mut bytes = Vec::new();
            write_picture(&mut bytes, ImageFormat::ALL[which], &picture(None)).unwrap();
            for (at, byte) in changes {
                let at = at.index(bytes.len());
                bytes[at] = byte;
            }
            let _ = read(&bytes);
            bytes.truncate(cut.index(bytes.len() + 1));
            let _ = read(&bytes);
        }
    }
}
