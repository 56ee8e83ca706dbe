//! PFM, the portable float map: one `f32` a pixel, for distances.
//!
//! ```text
//! Pf            one channel
//! 640 480       width, height
//! -1.0          negative: little-endian
//! ..........    rows from the bottom up, each from left to right, four bytes a pixel
//! ```

use std::io::{self, Write};

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
    use super::write;

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
}
