//! Whether a file is there to its end.
//!
//! The decoders forgive what is missing once they have their pixels, or paint grey what they lack. A golden image that
//! is cut short is damaged all the same, and must not pass for the same nor for another picture. Two formats end
//! with a mark that their decoders do not ask for:
//!
//! ```text
//!   PNG    signature │ length, type, data, checksum │ … │ 0, IEND, nothing, checksum
//!   JPEG   SOI │ FF marker, length, data │ … │ FF SOS, length, data, scan of codes │ … │ FF EOI
//! ```
//!
//! The others say how much their pixels fill, to which the decoders hold them. What comes after the end is no part
//! of the picture.

use image::ImageFormat;

/// Whether the file has the mark of its format's end where it belongs.
pub(super) fn is_complete(bytes: &[u8], format: ImageFormat) -> bool {
    match format {
        ImageFormat::Png => png(bytes).is_some(),
        ImageFormat::Jpeg => jpeg(bytes).is_some(),
        _ => true,
    }
}

/// The last chunk, with all of its checksum: that of no data is always the same.
const PNG_END: &[u8] = b"\0\0\0\0IEND\xae\x42\x60\x82";

/// Walks over the chunks to the last.
fn png(bytes: &[u8]) -> Option<()> {
    let mut rest = bytes.get(8..)?;
    while !rest.starts_with(PNG_END) {
        let length = u32::from_be_bytes(*rest.first_chunk()?);
        rest = rest.get(usize::try_from(length).ok()?.checked_add(12)?..)?;
    }
    Some(())
}

/// Walks over the segments, and over the codes of the scans, to the end of the image.
fn jpeg(bytes: &[u8]) -> Option<()> {
    let mut rest = bytes;
    loop {
        // To the next marker. Among codes a byte FF is followed by 00, and markers may be preceded by more FF.
        let at = rest.windows(2).position(|pair| pair[0] == 0xff && !matches!(pair[1], 0 | 0xff))?;
        let marker = rest[at + 1];
        rest = &rest[at + 2..];
        match marker {
            // The end of the image.
            0xd9 => return Some(()),
            // The beginning of the image, restarts among codes, and what is reserved: no length, no data.
            0xd0..=0xd8 | 0x01 => {}
            // The length counts itself. What a segment holds, such as a small picture of its own, is no marker.
            _ => rest = rest.get(usize::from(u16::from_be_bytes(*rest.first_chunk()?))..)?,
        }
    }
}
