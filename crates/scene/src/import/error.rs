//! Why a file could not be read: one line that says where, what, and what to do.

use core::fmt;

/// A place in a file.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum Place {
    /// A line of a text file, from 1.
    Line(u64),
    /// A byte of a binary file, from 0.
    Byte(u64),
    /// An item of the file's own numbering, from 0, such as a mesh of a glTF file.
    Item(&'static str, u64),
}

impl fmt::Display for Place {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Line(line) => write!(f, "line {line}"),
            Self::Byte(byte) => write!(f, "byte {byte}"),
            Self::Item(what, number) => write!(f, "{what} {number}"),
        }
    }
}

/// Why a model could not be read. Its text is one line: the file, the place in it where that is known, what is
/// wrong, and what to do about it.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct ImportError {
    file: String,
    fault: Fault,
}

impl ImportError {
    pub(super) fn new(file: &str, fault: Fault) -> Self {
        Self { file: quote(file.as_bytes(), 400), fault }
    }

    /// The file's name, as it was given.
    #[must_use]
    pub fn file(&self) -> &str {
        &self.file
    }

    /// The place in the file, where one is known.
    #[must_use]
    pub const fn place(&self) -> Option<Place> {
        self.fault.place
    }

    /// What is wrong and what to do, without file and place.
    #[must_use]
    pub fn message(&self) -> &str {
        &self.fault.message
    }
}

impl fmt::Display for ImportError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self.fault.place {
            Some(place) => write!(f, "{}: {place}: {}", self.file, self.fault.message),
            None => write!(f, "{}: {}", self.file, self.fault.message),
        }
    }
}

impl core::error::Error for ImportError {}

/// An [`ImportError`] that does not know its file yet.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) struct Fault {
    place: Option<Place>,
    message: String,
}

/// What the readers return.
pub(super) type Parsed<T> = Result<T, Fault>;

impl Fault {
    pub(super) fn new(message: impl Into<String>) -> Self {
        Self { place: None, message: message.into() }
    }

    /// The same fault at a place, unless it has one already.
    #[cfg_attr(
        not(any(feature = "obj", feature = "stl", feature = "ply", feature = "gltf")),
        expect(dead_code, reason = "readers know places")
    )]
    pub(super) fn at(mut self, place: Place) -> Self {
        self.place = self.place.or(Some(place));
        self
    }
}

impl From<crate::MeshError> for Fault {
    fn from(error: crate::MeshError) -> Self {
        Self::new(error.to_string())
    }
}

/// Bytes from a file as a text for a message: one line, no control characters, `most` characters at most.
pub(super) fn quote(bytes: &[u8], most: usize) -> String {
    let text = String::from_utf8_lossy(&bytes[..bytes.len().min(4 * most)]);
    let mut quoted: String = text
        .chars()
        .take(most)
        .map(|c| if c.is_control() || c == '\u{2028}' || c == '\u{2029}' { '\u{fffd}' } else { c })
        .collect();
    if text.chars().count() > most || bytes.len() > 4 * most {
        quoted.push('…');
    }
    quoted
}

#[cfg(test)]
mod tests {
    use super::{Fault, ImportError, Place, quote};

    #[test]
    fn an_error_is_one_line_whatever_the_file_holds() {
        let message = format!("`{}` is not a number", quote(b"1\n2\x1b[31m\xff", 40));
        let error = ImportError::new("a\nb.obj", Fault::new(message).at(Place::Line(7)));
        assert_eq!(
            error.to_string(),
            "a\u{fffd}b.obj: line 7: `1\u{fffd}2\u{fffd}[31m\u{fffd}` is not a number"
        );
    }

    #[test]
    fn a_long_quotation_is_cut() {
        assert_eq!(quote(&[b'x'; 1000], 4), "xxxx…");
        assert_eq!(quote(b"xxxx", 4), "xxxx");
    }
}
