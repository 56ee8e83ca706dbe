//! PFM, the portable float map: one `f32` a pixel, for distances.
//!
//! ```text
//! Pf            one channel
//! 640 480       width, height
//! -1.0          negative: little-endian
//! ..........    rows from the bottom up, each from left to right, four bytes a pixel
//! ```

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
}

/// Reads a PFM of one channel, of either byte order: width, height, and the values, rows from top to bottom. The size
/// of the scale, of which the sign is the byte order, is ignored; so are bytes after the last value.
///
/// # Errors
///
/// When the bytes are no such file. No more memory is taken than they fill.
pub fn read(bytes: &[u8]) -> Result<(u32, u32, Vec<f32>), PfmError> {
    let mut rest = bytes;
    let mut word = || {
        let text = rest.trim_ascii_start();
        let end = text.iter().position(u8::is_ascii_whitespace)?;
        let (word, after) = text.split_at(end);
        // One white space ends a word; after the last, the pixels begin, which may look like some.
        rest = &after[1..];
        str::from_utf8(word).ok()
    };
    match word() {
        Some("Pf") => {}
        Some("PF") => return Err(PfmError::Color),
        _ => return Err(PfmError::Header),
    }
    let mut side = || word().and_then(|word| word.parse::<u32>().ok()).ok_or(PfmError::Header);
    let (width, height) = (side()?, side()?);
    let scale: f32 = word().and_then(|word| word.parse().ok()).ok_or(PfmError::Header)?;
    let size = (width as usize).checked_mul(height as usize).and_then(|pixels| pixels.checked_mul(4));
    let size = size.filter(|size| *size > 0).ok_or(PfmError::Size { width, height })?;
    let pixels = rest.get(..size).ok_or(PfmError::Short { found: rest.len(), expected: size })?;
    let value = if scale.is_sign_negative() { f32::from_le_bytes } else { f32::from_be_bytes };
    let rows = pixels.chunks_exact(4 * width as usize).rev();
    let values = rows.flat_map(|row| row.as_chunks::<4>().0).map(|bytes| value(*bytes));
    Ok((width, height, values.collect()))
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
        let big = b"Pf 2 2 1 \x40\0\0\0\x40\x80\0\0\x3f\x80\0\0\x7f\x80\0\0and more";
        let expected = Ok((2, 2, vec![1.0, f32::INFINITY, 2.0, 4.0]));
        assert_eq!((read(little), read(big)), (expected.clone(), expected));
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
