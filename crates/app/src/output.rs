//! Files that are there as a whole or not at all.
//!
//! A picture is written to a temporary file in the same folder and renamed when it is complete, so that nobody
//! ever sees half a picture, and a failure leaves the old one as it was. What is no regular file (`/dev/null`, a
//! pipe, a terminal) cannot be replaced and is written directly. A link is followed, whether its target is there
//! yet or not: the temporary file lies beside the target and takes its name; the link stays.

use std::fs::{self, File};
use std::io::{self, BufWriter, Write};
use std::path::{Path, PathBuf};

use tempfile::NamedTempFile;

use crate::error::Error;

/// Bytes that are collected before the system is asked to write them.
const BUFFER: usize = 1 << 16;

/// Where a picture goes.
#[derive(Clone, Debug, PartialEq, Eq, Hash)]
pub enum Destination {
    /// Standard output.
    Stdout,
    /// A file.
    File(PathBuf),
}

impl Destination {
    /// The name in messages.
    #[must_use]
    pub fn name(&self) -> &Path {
        match self {
            Self::Stdout => Path::new("standard output"),
            Self::File(path) => path,
        }
    }

    /// Finds out, before any work is done, what would prevent writing: no such folder, a folder in its place, a
    /// file that is write-protected.
    ///
    /// # Errors
    ///
    /// [`Error::Write`].
    pub fn check(&self) -> Result<(), Error> {
        let Self::File(path) = self else { return Ok(()) };
        let refuse = |kind: io::ErrorKind| Err(Error::write(path, kind.into()));
        match fs::metadata(path) {
            Ok(found) if found.is_dir() => return refuse(io::ErrorKind::IsADirectory),
            // Renaming would replace it all the same; whoever protected it wants it kept.
            Ok(found) if found.is_file() && found.permissions().readonly() => {
                return Err(Error::file(path, "is write-protected: choose another name, or allow writing"));
            }
            Ok(_) => return Ok(()),
            Err(error) if error.kind() == io::ErrorKind::NotFound => {}
            Err(error) => return Err(Error::write(path, error)),
        }
        // A link that leads nowhere yet: what matters is the folder of its target.
        let target = followed(path).map_err(|error| Error::write(path, error))?;
        match fs::metadata(folder(&target)) {
            Ok(found) if found.is_dir() => Ok(()),
            Ok(_) => refuse(io::ErrorKind::NotADirectory),
            Err(error) => Err(Error::write(path, error)),
        }
    }

    /// Opens it for writing.
    ///
    /// # Errors
    ///
    /// [`Error::Write`].
    pub fn create(&self) -> Result<Output, Error> {
        let sink = match self {
            Self::Stdout => Ok(Sink::Stdout(io::stdout())),
            Self::File(path) => open(path),
        };
        match sink {
            Ok(sink) => {
                Ok(Output { name: self.name().to_owned(), writer: BufWriter::with_capacity(BUFFER, sink) })
            }
            Err(error) => Err(Error::write(self.name(), error)),
        }
    }
}

/// A file in the making. Dropped without [`commit`](Self::commit), it leaves nothing behind.
#[derive(Debug)]
pub struct Output {
    name: PathBuf,
    writer: BufWriter<Sink>,
}

#[derive(Debug)]
enum Sink {
    Stdout(io::Stdout),
    Direct(File),
    Temporary(NamedTempFile, PathBuf),
}

impl Write for Sink {
    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        match self {
            Self::Stdout(out) => out.write(bytes),
            Self::Direct(out) => out.write(bytes),
            Self::Temporary(out, _) => out.write(bytes),
        }
    }

    fn flush(&mut self) -> io::Result<()> {
        match self {
            Self::Stdout(out) => out.flush(),
            Self::Direct(out) => out.flush(),
            Self::Temporary(out, _) => out.flush(),
        }
    }
}

impl Output {
    /// Has `write` write the content.
    ///
    /// # Errors
    ///
    /// [`Error::Write`] with what `write` or the system reported.
    pub fn fill(&mut self, write: impl FnOnce(&mut dyn Write) -> io::Result<()>) -> Result<(), Error> {
        let mut witness = Witness { out: &mut self.writer, seen: None };
        let written = write(&mut witness).and_then(|()| witness.flush());
        let seen = witness.seen;
        written.map_err(|error| Error::write(&self.name, seen.unwrap_or(error)))
    }

    /// Gives the complete file its name.
    ///
    /// # Errors
    ///
    /// [`Error::Write`]; then what had the name before is still there.
    pub fn commit(self) -> Result<(), Error> {
        let sink = self.writer.into_inner().map_err(|error| Error::write(&self.name, error.into_error()))?;
        match sink {
            Sink::Stdout(_) | Sink::Direct(_) => Ok(()),
            Sink::Temporary(file, target) => {
                file.persist(target).map(drop).map_err(|error| Error::write(&self.name, error.error))
            }
        }
    }
}

/// Remembers what went wrong first. Encoders wrap the errors that they meet, and the kind, by which a user is told
/// what to do, is lost.
struct Witness<'a> {
    out: &'a mut dyn Write,
    seen: Option<io::Error>,
}

impl Witness<'_> {
    fn note<T>(&mut self, result: io::Result<T>) -> io::Result<T> {
        result.map_err(|error| {
            let same = io::Error::from(error.kind());
            // Interrupted writes are tried again.
            if error.kind() != io::ErrorKind::Interrupted && self.seen.is_none() {
                self.seen = Some(error);
            }
            same
        })
    }
}

impl Write for Witness<'_> {
    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        let result = self.out.write(bytes);
        self.note(result)
    }

    fn flush(&mut self) -> io::Result<()> {
        let result = self.out.flush();
        self.note(result)
    }
}

fn open(path: &Path) -> io::Result<Sink> {
    let target = followed(path)?;
    let found = fs::metadata(&target).ok();
    if found.as_ref().is_some_and(|found| !found.is_file()) {
        return Ok(Sink::Direct(File::options().write(true).open(&target)?));
    }
    let mut builder = tempfile::Builder::new();
    builder.prefix(".polosa-").suffix(".tmp");
    #[cfg(unix)]
    let normal = {
        use std::os::unix::fs::PermissionsExt as _;
        // What any new file asks for; the system takes away what the user's mask forbids.
        fs::Permissions::from_mode(0o666)
    };
    #[cfg(unix)]
    builder.permissions(normal);
    let file = builder.tempfile_in(folder(&target))?;
    if let Some(found) = found {
        // A file that is written anew keeps its permissions. Where the system does not allow that, it has those of
        // a new file, which is no reason to fail.
        let _ = file.as_file().set_permissions(found.permissions());
    }
    Ok(Sink::Temporary(file, target))
}

/// Whether something is there that is neither file nor folder, such as `/dev/null` or a pipe.
pub(crate) fn is_special(path: &Path) -> bool {
    path.metadata().is_ok_and(|found| !found.is_file() && !found.is_dir())
}

/// What a name stands for in the end: links are followed, also one that leads to nothing yet, so that what it points
/// to is made or replaced and never the link itself.
///
/// # Errors
///
/// When a link cannot be read, or links lead in a circle.
pub(crate) fn followed(path: &Path) -> io::Result<PathBuf> {
    let mut path = path.to_owned();
    for _ in 0..MOST_LINKS {
        if !fs::symlink_metadata(&path).is_ok_and(|found| found.is_symlink()) {
            return Ok(path);
        }
        // Where the link is not absolute, it counts from its own folder.
        path = folder(&path).join(fs::read_link(&path)?);
    }
    Err(io::Error::other("its links lead in a circle"))
}

/// Links that are followed one after the other, as many as Linux follows.
const MOST_LINKS: usize = 40;

/// The folder that a file is in.
pub(crate) fn folder(path: &Path) -> &Path {
    path.parent().filter(|folder| !folder.as_os_str().is_empty()).unwrap_or(Path::new("."))
}

#[cfg(test)]
mod tests {
    use std::fs;

    use super::Destination;

    #[test]
    fn a_file_appears_only_when_it_is_complete() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("x.png");
        let to = Destination::File(path.clone());

        let mut output = to.create().unwrap();
        output.fill(|out| out.write_all(b"half")).unwrap();
        assert!(!path.exists());
        drop(output);
        assert_eq!(fs::read_dir(folder.path()).unwrap().count(), 0, "nothing may be left behind");

        let mut output = to.create().unwrap();
        output.fill(|out| out.write_all(b"whole")).unwrap();
        output.commit().unwrap();
        assert_eq!(fs::read(&path).unwrap(), b"whole");
        assert_eq!(fs::read_dir(folder.path()).unwrap().count(), 1);
    }

    #[cfg(unix)]
    #[test]
    fn a_link_is_followed_and_permissions_stay() {
        use std::os::unix::fs::{PermissionsExt as _, symlink};

        let folder = tempfile::tempdir().unwrap();
        let (real, link) = (folder.path().join("real.png"), folder.path().join("link.png"));
        fs::write(&real, b"old").unwrap();
        fs::set_permissions(&real, fs::Permissions::from_mode(0o640)).unwrap();
        symlink(&real, &link).unwrap();

        let mut output = Destination::File(link.clone()).create().unwrap();
        output.fill(|out| out.write_all(b"new")).unwrap();
        output.commit().unwrap();
        assert!(fs::symlink_metadata(&link).unwrap().is_symlink());
        assert_eq!(fs::read(&real).unwrap(), b"new");
        assert_eq!(fs::metadata(&real).unwrap().permissions().mode() & 0o777, 0o640);
    }

    #[cfg(unix)]
    #[test]
    fn a_link_to_nothing_yet_is_followed_too() {
        use std::os::unix::fs::symlink;

        let folder = tempfile::tempdir().unwrap();
        let path = |name: &str| folder.path().join(name);
        fs::create_dir(path("sub")).unwrap();
        symlink("sub/second.png", path("first.png")).unwrap();
        symlink("../real.png", path("sub/second.png")).unwrap();
        let to = Destination::File(path("first.png"));
        to.check().unwrap();
        let mut output = to.create().unwrap();
        output.fill(|out| out.write_all(b"new")).unwrap();
        output.commit().unwrap();
        for link in ["first.png", "sub/second.png"] {
            assert!(fs::symlink_metadata(path(link)).unwrap().is_symlink(), "{link}");
        }
        assert_eq!(fs::read(path("real.png")).unwrap(), b"new");

        symlink("gone/x.png", path("nowhere.png")).unwrap();
        let error = Destination::File(path("nowhere.png")).check().unwrap_err().to_string();
        assert!(error.contains("no such folder"), "{error}");
        symlink("round.png", path("round.png")).unwrap();
        assert!(Destination::File(path("round.png")).check().is_err());
        assert!(Destination::File(path("round.png")).create().is_err());
    }

    #[test]
    fn what_prevents_writing_is_found_before_the_work() {
        let folder = tempfile::tempdir().unwrap();
        for (name, substance) in [("", "is a folder"), ("none/x.png", "no such folder")] {
            let error = Destination::File(folder.path().join(name)).check().unwrap_err();
            assert!(error.to_string().contains(substance), "{error}");
        }
    }
}
