//! Where a recording goes, from a name.
//!
//! ```text
//!   OUT.gif         an animation
//!   OUT_%04d.png    OUT_0001.png, OUT_0002.png, …       %d: without zeros before it
//!   50%%_%d.png     50%_1.png, …                        %%: a percent sign
//! ```
//!
//! The names are printf's, as ffmpeg and others have them. Only the last part of a path is looked at: folders, and the
//! names of animations, are taken as they are.

use std::path::{Path, PathBuf};

use crate::encode::ImageFormat;
use crate::error::{Error, one_line};
use crate::output::{Destination, is_special};

/// The most digits that a number is filled up to.
const MOST_DIGITS: usize = 9;

/// Where a recording goes.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum To {
    /// An animated GIF.
    Gif(Destination),
    /// A picture a frame.
    Sequence(Numbered),
}

/// Files that are told apart by a number in their names.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Numbered {
    /// As it was given, for messages.
    path: PathBuf,
    before: String,
    digits: usize,
    after: String,
    format: ImageFormat,
}

impl To {
    /// What a path stands for: `.gif`, or what has no extension to go by (a device, a pipe), is an animation; any other
    /// format a sequence, whose name has a place for the number, `%d` or `%04d`.
    ///
    /// # Errors
    ///
    /// [`Error::Usage`], which says how names are written.
    pub fn path(path: &Path) -> Result<Self, Error> {
        let gif = path.extension().is_some_and(|extension| extension.eq_ignore_ascii_case("gif"));
        if gif || is_special(path) {
            return Ok(Self::Gif(Destination::File(path.to_owned())));
        }
        Numbered::new(path).map(Self::Sequence)
    }

    /// The name in messages.
    #[must_use]
    pub fn name(&self) -> &Path {
        match self {
            Self::Gif(to) => to.name(),
            Self::Sequence(files) => &files.path,
        }
    }

    /// Finds out, before any work is done, what would prevent writing.
    ///
    /// # Errors
    ///
    /// [`Error::Write`], as [`Destination::check`]; of a sequence it is said of the first file.
    pub fn check(&self) -> Result<(), Error> {
        match self {
            Self::Gif(to) => to.check(),
            Self::Sequence(files) => files.file(1).check(),
        }
    }

    /// Whether frames keep their transparency there.
    #[must_use]
    pub fn has_alpha(&self) -> bool {
        match self {
            Self::Gif(_) => true,
            Self::Sequence(files) => files.format.has_alpha(),
        }
    }
}

impl Numbered {
    fn new(path: &Path) -> Result<Self, Error> {
        let shown = one_line(&path.to_string_lossy());
        let usage = |what: String| Err(Error::Usage(format!("{shown}: {what}")));
        let format = match ImageFormat::from_path(path) {
            Ok(format) => format,
            Err(error) => return usage(format!("{error}, with %04d before it, or .gif")),
        };
        let Some(name) = path.file_name().and_then(|name| name.to_str()) else {
            return usage("a name with a number in it must be Unicode: choose another".to_owned());
        };
        let (mut texts, mut digits) = (vec![String::new()], 0);
        let mut rest = name;
        while let Some((text, place)) = rest.split_once('%') {
            let text_of = |texts: &mut Vec<String>, more: &str| {
                if let Some(last) = texts.last_mut() {
                    *last += more;
                }
            };
            text_of(&mut texts, text);
            if let Some(after) = place.strip_prefix('%') {
                text_of(&mut texts, "%");
                rest = after;
                continue;
            }
            let width = place.len() - place.trim_start_matches(|c: char| c.is_ascii_digit()).len();
            let (number, after) = place.split_at(width);
            let filled = match number.strip_prefix('0') {
                None if number.is_empty() => Some(0),
                None => None,
                Some(number) => number.parse().ok().filter(|digits| (1..=MOST_DIGITS).contains(digits)),
            };
            let (Some(filled), Some(after)) = (filled, after.strip_prefix('d')) else {
                return usage(format!(
                    "a percent sign that says no number: write %d or %04d, up to %0{MOST_DIGITS}d, for the frame's number, \
                     and %% for a percent sign"
                ));
            };
            digits = filled;
            texts.push(String::new());
            rest = after;
        }
        if let Some(last) = texts.last_mut() {
            *last += rest;
        }
        match <[String; 2]>::try_from(texts) {
            Ok([before, after]) => Ok(Self { path: path.to_owned(), before, digits, after, format }),
            Err(texts) if texts.len() == 1 => usage(
                "a recording has many frames: use .gif for an animation, or write %04d where their numbers go".to_owned(),
            ),
            Err(_) => usage("two places for one number: leave one, and write %% for a percent sign".to_owned()),
        }
    }

    /// The file of frame `number`, counted from 1.
    #[must_use]
    pub fn file(&self, number: u64) -> Destination {
        let Self { path, before, digits, after, .. } = self;
        Destination::File(path.with_file_name(format!("{before}{number:0digits$}{after}")))
    }

    /// The format of its pictures.
    #[must_use]
    pub const fn format(&self) -> ImageFormat {
        self.format
    }
}

#[cfg(test)]
mod tests {
    use std::path::{Path, PathBuf};

    use proptest::prelude::*;

    use super::To;
    use crate::output::Destination;

    fn file(name: &str, number: u64) -> PathBuf {
        match To::path(Path::new(name)).unwrap() {
            To::Sequence(files) => match files.file(number) {
                Destination::File(path) => path,
                Destination::Stdout => panic!("{name}"),
            },
            To::Gif(_) => panic!("{name}"),
        }
    }

    #[test]
    fn numbers_go_where_printf_puts_them() {
        assert_eq!(file("a/b_%04d.png", 1), Path::new("a/b_0001.png"));
        assert_eq!(file("b_%04d.png", 123_456), Path::new("b_123456.png"));
        assert_eq!(file("%d.JPG", 10), Path::new("10.JPG"));
        assert_eq!(
            file("100%%/50%%_%03d%%.png", 7),
            Path::new("100%%/50%_007%.png"),
            "folders stay as they are"
        );
        assert_eq!(file("%s/x%d.png", 2), Path::new("%s/x2.png"));
        let gif = |name: &str| To::path(Path::new(name)).unwrap();
        assert_eq!(gif("a%d.GIF"), To::Gif(Destination::File("a%d.GIF".into())), "animations have no number");
    }

    #[test]
    fn names_without_exactly_one_number_are_refused_and_told_how() {
        for (name, substance) in [
            ("a.png", "%04d"),
            ("%%.png", "%04d"),
            ("a%d.png/b.png", "%04d"),
            ("%d_%d.png", "two places"),
            ("%d_%d_%d.png", "two places"),
            ("%s.png", "%% for a percent sign"),
            ("%.png", "%% for a percent sign"),
            ("%4d.png", "%04d"),
            ("%0d.png", "%04d"),
            ("%010d.png", "%09d"),
            ("%99999999999999999999d.png", "%04d"),
            ("%-4d.png", "%04d"),
            ("a%d.xyz", ".gif"),
            ("a%d", ".gif"),
            ("%d.\npng", ".gif"),
        ] {
            let error = To::path(Path::new(name)).unwrap_err();
            assert_eq!(error.exit_status(), 2, "{name}");
            let text = error.to_string();
            assert!(text.contains(substance) && !text.contains('\n'), "{name}: {text}");
        }
    }

    #[cfg(unix)]
    #[test]
    fn folders_may_have_any_bytes_but_numbered_names_must_be_unicode() {
        use std::ffi::OsStr;
        use std::os::unix::ffi::OsStrExt as _;

        let path = |bytes: &'static [u8]| Path::new(OsStr::from_bytes(bytes));
        assert!(To::path(path(b"\xff/%d.png")).is_ok() && To::path(path(b"\xff.gif")).is_ok());
        assert!(To::path(path(b"\xff%d.png")).unwrap_err().to_string().contains("Unicode"));
    }

    proptest! {
        #[test]
        fn no_name_makes_it_panic_and_numbers_tell_files_apart(name in "[%0-9dsé]{0,9}(\\.png)?", n in 1..u64::MAX) {
            if let Ok(To::Sequence(files)) = To::path(Path::new(&name)) {
                prop_assert_ne!(files.file(n), files.file(n - 1));
            }
        }
    }
}
