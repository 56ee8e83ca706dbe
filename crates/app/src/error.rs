//! Why something could not be done: one line that says where, what, and what to do.

use std::io;
use std::path::Path;

use polosa_scene::import::ImportError;

/// The errors of files, pictures and the command line.
///
/// [`Display`](core::fmt::Display) gives one line, `FILE: what: what to do`, whatever bytes the names hold.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum Error {
    /// Options that contradict each other or cannot be followed; nothing was done. Exit status 2.
    #[error("{0}; see --help")]
    Usage(String),
    /// A model that could not be read.
    #[error(transparent)]
    Import(#[from] ImportError),
    /// Something about a file, a model or a picture.
    #[error("{file}: {what}")]
    File {
        /// Its name, on one line.
        file: String,
        /// What is wrong and what to do.
        what: String,
    },
    /// An output that could not be written. It was left as it was.
    #[error("{file}: cannot be written: {}", advice(source))]
    Write {
        /// Its name, on one line.
        file: String,
        /// The system's reason.
        source: io::Error,
    },
    /// A window that cannot be opened or drawn into: what is missing, and what to do.
    #[error("{0}")]
    Window(String),
    /// A defect of this program or of a library, caught.
    #[error("{file}: stopped by a defect of the program ({message}): please report it with this file")]
    Panic {
        /// The file that was worked on, on one line.
        file: String,
        /// The panic's message, on one line.
        message: String,
    },
}

impl Error {
    /// Something about a file.
    pub fn file(file: impl AsRef<Path>, what: impl Into<String>) -> Self {
        Self::File { file: name(file.as_ref()), what: what.into() }
    }

    /// An output that could not be written.
    pub fn write(file: impl AsRef<Path>, source: io::Error) -> Self {
        Self::Write { file: name(file.as_ref()), source }
    }

    /// The program's exit status: 2 for wrong usage, else 1.
    #[must_use]
    pub const fn exit_status(&self) -> u8 {
        if matches!(self, Self::Usage(_)) { 2 } else { 1 }
    }
}

/// A file's name for a message; `-` is one of the standard streams and named by the caller.
fn name(path: &Path) -> String {
    one_line(&path.to_string_lossy())
}

/// A text on one line: control characters, such as a newline in a file's name, cannot break or colour a message.
#[must_use]
pub fn one_line(text: &str) -> String {
    let broken = |c: char| c.is_control() || c == '\u{2028}' || c == '\u{2029}';
    text.chars().map(|c| if broken(c) { '\u{fffd}' } else { c }).collect()
}

/// What the system says, and what to do about it.
fn advice(error: &io::Error) -> String {
    let advice = match error.kind() {
        io::ErrorKind::NotFound => "no such folder: create it first",
        io::ErrorKind::PermissionDenied => "no permission: choose another folder or name",
        io::ErrorKind::ReadOnlyFilesystem => "the file system is read-only: choose another folder",
        io::ErrorKind::NotADirectory => "a part of its path is no folder: check the path",
        io::ErrorKind::IsADirectory => "it is a folder: name a file in it",
        io::ErrorKind::StorageFull | io::ErrorKind::QuotaExceeded => "no space left: free some",
        io::ErrorKind::InvalidFilename => "the system allows no such name: choose another",
        io::ErrorKind::BrokenPipe => "the reader at the other end stopped reading",
        _ => return one_line(&error.to_string()),
    };
    advice.to_owned()
}

#[cfg(test)]
mod tests {
    use std::io;

    use super::Error;

    #[test]
    fn an_error_is_one_line_whatever_the_name_holds() {
        let error = Error::write("a\nb\u{1b}[31m.png", io::Error::from(io::ErrorKind::PermissionDenied));
        let text = error.to_string();
        assert!(!text.contains(|c: char| c.is_control()), "{text:?}");
        assert!(text.starts_with("a\u{fffd}b"), "{text}");
    }

    #[test]
    fn only_wrong_usage_exits_with_2() {
        assert_eq!(Error::Usage(String::new()).exit_status(), 2);
        assert_eq!(Error::file("x", "y").exit_status(), 1);
    }
}
