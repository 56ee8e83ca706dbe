//! PFM, the portable float map: one `f32` a pixel, for distances.
//!
//! ```text
//! Pf            one channel
//! 640 480       width, height
//! -1.0          negative: little-endian
//! ..........    rows from the bottom up, each from left to right, four bytes a pixel
//! ```

use std::cmp::Ordering;
use std::io::{self, Write};

/// What is wrong with a file that should be PFM.
#[derive(Clone, Copy, Debug, PartialEq, Eq, thiserror::Error)]
#[non_exhaustive]
pub enum PfmError {
    /// It does not begin with `Pf`, a width, a height and a scale.
    #[error("does not begin with Pf, width, height and scale")]
    Header,
    /// It has three channels.
    #[error("has three channels (PF): only one (Pf) is read")]
    Color,
    /// It has no pixels, or more than memory has room for.
    #[error("has {width}×{height} pixels, which is no possible picture")]
    Size {
        /// As the file has it.
        width: u32,
        /// As the file has it.
        height: u32,
    },
    /// It ends before its last value.
    #[error("ends too early: {found} of {expected} bytes of pixels")]
    Short {
        /// Bytes after the header.
        found: usize,
        /// Bytes that the size asks for.
        expected: usize,
    },
    /// It goes on after its last value: its values may not be where they seem to be.
    #[error("has {found} bytes of pixels, its size asks for {expected}: it is damaged")]
    Long {
        /// Bytes after the header.
        found: usize,
        /// Bytes that the size asks for.
        expected: usize,
    },
    /// There is no memory for its values.
    #[error("needs {bytes} bytes of memory, which are not free")]
    Memory {
        /// Bytes of its values.
        bytes: usize,
    },
}

/// Reads a PFM of one channel, of either byte order: width, height, and the values, rows from top to bottom. The size
/// of the scale, of which the sign is the byte order, is ignored. Lines of the header end with any one white space, or
/// all with CR LF.
///
/// # Errors
///
/// When the bytes are no such file, or are more or fewer than its size asks for, or there is no memory for its
/// values. No more memory is taken than those fill.
pub fn read(bytes: &[u8]) -> Result<(u32, u32, Vec<f32>), PfmError> {
    let header = Header::of(bytes)?;
    let [width, height] = header.size();
    Ok((width, height, header.values()?))
}

/// What a file says of itself, and the bytes after that.
#[derive(Debug)]
pub(crate) struct Header<'a> {
    width: u32,
    height: u32,
    little_endian: bool,
    pixels: &'a [u8],
}

impl<'a> Header<'a> {
    /// What is before the pixels, by which a size can be refused before memory is taken.
    pub(crate) fn of(bytes: &'a [u8]) -> Result<Self, PfmError> {
        let mut rest = bytes;
        let mut word = || {
            let text = rest.trim_ascii_start();
            let end = text.iter().position(u8::is_ascii_whitespace)?;
            let (word, after) = text.split_at(end);
            // One white space ends a word; after the last, the pixels begin, which may look like some.
            rest = &after[1..];
            Some((str::from_utf8(word).ok()?, after.starts_with(b"\r\n")))
        };
        let two_bytes_end_lines = match word() {
            Some(("Pf", crlf)) => crlf,
            Some(("PF", _)) => return Err(PfmError::Color),
            _ => return Err(PfmError::Header),
        };
        let mut side = || word().and_then(|(word, _)| word.parse::<u32>().ok()).ok_or(PfmError::Header);
        let (width, height) = (side()?, side()?);
        let (scale, crlf) = word().ok_or(PfmError::Header)?;
        let scale: f32 = scale.parse().map_err(|_| PfmError::Header)?;
        // Only where the first line ends so as well: a first value may begin with the code of LF.
        let pixels = if two_bytes_end_lines && crlf { &rest[1..] } else { rest };
        Ok(Self { width, height, little_endian: scale.is_sign_negative(), pixels })
    }

    /// Width and height.
    pub(crate) const fn size(&self) -> [u32; 2] {
        [self.width, self.height]
    }

    /// The values, rows from top to bottom.
    pub(crate) fn values(&self) -> Result<Vec<f32>, PfmError> {
        let (width, height) = (self.width, self.height);
        let size = (width as usize).checked_mul(height as usize).and_then(|pixels| pixels.checked_mul(4));
        let expected = size.filter(|size| *size > 0).ok_or(PfmError::Size { width, height })?;
        let found = self.pixels.len();
        match found.cmp(&expected) {
            Ordering::Less => return Err(PfmError::Short { found, expected }),
            Ordering::Greater => return Err(PfmError::Long { found, expected }),
            Ordering::Equal => {}
        }
        let value = if self.little_endian { f32::from_le_bytes } else { f32::from_be_bytes };
        let mut values = Vec::new();
        values.try_reserve_exact(expected / 4).map_err(|_| PfmError::Memory { bytes: expected })?;
        for row in self.pixels.chunks_exact(4 * width as usize).rev() {
            values.extend(row.as_chunks::<4>().0.iter().map(|bytes| value(*bytes)));
        }
        Ok(values)
    }
}

/// Writes `values`, rows from top to bottom without gaps, as PFM; infinities and NaN are kept.
///
/// # Errors
///
/// What `out` reports; [`io::ErrorKind::InvalidInput`] when there are not `width` × `height` values.
pub fn write(out: &mut dyn Write, width: u32, height: u32, values: &[f32]) -> io::Result<()> {
    let width_values = width as usize;
    if width == 0 || width_values.checked_mul(height as usize) != Some(values.len()) {
        let message = format!("{} values for {width}×{height} pixels", values.len());
        return Err(io::Error::new(io::ErrorKind::InvalidInput, message));
    }
    write!(out, "Pf\n{width} {height}\n-1.0\n")?;
    let mut bytes = Vec::with_capacity(4 * width_values);
    for row in values.chunks_exact(width_values).rev() {
        bytes.clear();
        bytes.extend(row.iter().flat_map(|value| value.to_le_bytes()));
        out.write_all(&bytes)?;
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::{PfmError, read, write};

    #[test]
    fn rows_go_from_the_bottom_up_in_little_endian() {
        let mut bytes = Vec::new();
        write(&mut bytes, 2, 2, &[1.0, 2.0, f32::INFINITY, 4.0]).unwrap();
        let expected = [
            b"Pf\n2 2\n-1.0\n".as_slice(),
            &[0, 0, 0x80, 0x7f, 0, 0, 0x80, 0x40],
            &[0, 0, 0x80, 0x3f, 0, 0, 0, 0x40],
        ];
        assert_eq!(bytes, expected.concat());
    }

    #[test]
    fn a_wrong_number_of_values_is_refused() {
        for (width, height, count) in [(2, 2, 3), (0, 1, 0), (u32::MAX, u32::MAX, 1)] {
            assert!(write(&mut Vec::new(), width, height, &vec![0.0; count]).is_err());
        }
    }

    #[test]
    fn both_byte_orders_are_read_and_rows_turned_back() {
        let little = b"Pf\n2 2\n-1.0\n\0\0\0\x40\0\0\x80\x40\0\0\x80\x3f\0\0\x80\x7f";
        let big = b"Pf 2 2 1 \x40\0\0\0\x40\x80\0\0\x3f\x80\0\0\x7f\x80\0\0";
        let expected = Ok((2, 2, vec![1.0, f32::INFINITY, 2.0, 4.0]));
        assert_eq!((read(little), read(big)), (expected.clone(), expected));
    }

    #[test]
    fn a_header_of_two_bytes_a_line_end_moves_no_value() {
        // The first value begins with the code of LF.
        let value = f32::from_le_bytes(*b"\n\0\x80?");
        for header in [&b"Pf\r\n1 1\r\n-1\r\n"[..], b"Pf\n1 1\n-1\n", b"Pf\n1 1\n-1\r", b"Pf 1 1 -1 "] {
            assert_eq!(read(&[header, b"\n\0\x80?"].concat()), Ok((1, 1, vec![value])), "{header:?}");
        }
    }

    #[test]
    fn what_is_no_such_file_is_refused_with_the_reason() {
        for (bytes, error) in [
            (&b""[..], PfmError::Header),
            (b"P6\n1 1\n255\n", PfmError::Header),
            (b"Pf\n1 1\n-1.0", PfmError::Header),
            (b"Pf\n-1 1\n-1.0\n", PfmError::Header),
            (b"Pf\n1 1\nbig\n", PfmError::Header),
            (b"PF\n1 1\n-1.0\n", PfmError::Color),
            (b"Pf\n0 7\n-1.0\n", PfmError::Size { width: 0, height: 7 }),
            (b"Pf\n1 2\n-1.0\n1234567", PfmError::Short { found: 7, expected: 8 }),
            (b"Pf\n1 2\n-1.0\n123456789", PfmError::Long { found: 9, expected: 8 }),
            (b"Pf\n1 2\n-1.0\r\n12345678", PfmError::Long { found: 9, expected: 8 }),
            (b"Pf\r\n1 2\r\n-1.0\r\n1234567", PfmError::Short { found: 7, expected: 8 }),
        ] {
            assert_eq!(read(bytes), Err(error), "{:?}", String::from_utf8_lossy(bytes));
        }
        assert!(read(b"Pf\n4294967295 4294967295\n-1\n1234").is_err());
    }

    proptest! {
        #[test]
        fn what_was_written_is_read_back_bit_by_bit(width in 1..9_u32, bits in proptest::collection::vec(any::<u32>(), 9)) {
            let values: Vec<f32> = bits[..width as usize].iter().map(|bits| f32::from_bits(*bits)).collect();
            let mut bytes = Vec::new();
            write(&mut bytes, width, 1, &values).unwrap();
            let (_, _, back) = read(&bytes).unwrap();
            prop_assert!(back.iter().zip(&values).all(|(a, b)| a.to_bits() == b.to_bits()));
        }

        #[test]
        fn no_bytes_make_reading_panic(bytes in proptest::collection::vec(any::<u8>(), 0..64)) {
            let _ = read(&bytes);
            let _ = read(&[b"Pf\n".as_slice(), &bytes].concat());
        }
    }
}
