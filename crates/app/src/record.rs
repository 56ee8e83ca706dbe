//! Frames to a file: an animated GIF, or a numbered sequence of pictures.
//!
//! ```text
//!   drawn ─▶ Recorder::frame ─▶ clock ─▶ workers, several frames at once ─▶ in order again ─▶ file
//!            copies the pixels  delays   palette, compression                writes, renames
//! ```
//!
//! While a frame is being compressed the next one is drawn; when the drawing gets too far ahead it waits, so that memory
//! does not grow with the length of a recording. The same frames give the same bytes, by any number of threads.
//!
//! - **A GIF** repeats for ever. Frames store only what has changed. As long as no frame brings more than 256 colours
//!   every pixel is exact; else they are brought down to 256, without dithering, which would flicker. A pixel that does
//!   not change keeps its colour in any case. The file is complete or not there.
//! - **A sequence** is a file a frame, numbered from 1, as ffmpeg writes them and finds them by itself. Each is complete
//!   or not there. Files of an earlier, longer recording stay.
//!
//! ```
//! use polosa::record::{Options, Recorder, To};
//!
//! let folder = tempfile::tempdir()?;
//! let path = folder.path().join("blink.gif");
//! let mut recorder = Recorder::create(&To::path(&path)?, Options { fps: 2.0, threads: None })?;
//! for color in [0xff0000, 0x0000ff] {
//!     recorder.frame(&[color; 64 * 48], [64, 48])?;
//! }
//! recorder.finish()?;
//! assert!(std::fs::read(path)?.starts_with(b"GIF89a"));
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

mod clock;
mod gif;
mod name;
mod palette;
mod workers;

use core::num::NonZeroUsize;
use std::path::{Path, PathBuf};
use std::thread;
use std::time::Duration;

use polosa_scene::{DrawStats, Picture};

use self::gif::Animation;
pub use self::name::{Numbered, To};
use self::workers::Workers;
use crate::encode::write_picture;
use crate::error::Error;

/// The most frames a second that a GIF has: browsers show what is shorter than 1/50 s for 1/10 s.
pub const MOST_FPS: f64 = 50.0;

/// The fewest frames a second: one in a quarter of an hour.
pub const LEAST_FPS: f64 = 0.001;

/// Threads that encode, at most: more frames under way take more memory, and drawing is no faster.
const MOST_THREADS: usize = 16;

/// How it is recorded.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Options {
    /// Frames a second, from [`LEAST_FPS`] on. A GIF has 50 at most ([`MOST_FPS`]): of frames that come sooner some are left out,
    /// so that the time is right, to 1/50 s at the end. In a sequence each has its file.
    pub fps: f64,
    /// Threads that encode; `None`: as many as the machine runs at once. 16 at most.
    pub threads: Option<NonZeroUsize>,
}

impl Options {
    /// How many threads encode.
    pub(crate) fn threads(&self) -> NonZeroUsize {
        let threads = self.threads.or_else(|| thread::available_parallelism().ok());
        threads.unwrap_or(NonZeroUsize::MIN).min(NonZeroUsize::new(MOST_THREADS).unwrap_or(NonZeroUsize::MIN))
    }
}

/// A recording in the making.
///
/// Dropped without [`finish`](Self::finish), a GIF is not there; pictures of a sequence that are complete stay.
#[derive(Debug)]
pub struct Recorder {
    name: PathBuf,
    fps: f64,
    frames: u64,
    /// What all frames share: width, height, whether they have transparency.
    shape: Option<([u32; 2], bool)>,
    sink: Sink,
    failed: bool,
}

#[derive(Debug)]
enum Sink {
    Gif(Box<Animation>),
    Sequence(Numbered, Workers<()>),
}

impl Recorder {
    /// Begins a recording. Nothing is there before its first frame (of a sequence), or before it is finished (a GIF).
    ///
    /// # Errors
    ///
    /// [`Error::Usage`] for a frame rate that is none; [`Error::Write`] for what would prevent writing, such as a folder
    /// that is not there.
    pub fn create(to: &To, options: Options) -> Result<Self, Error> {
        let Options { fps, .. } = options;
        if !(LEAST_FPS..=f64::MAX).contains(&fps) {
            return Err(Error::Usage(format!("{fps} frames a second cannot be: write {LEAST_FPS} or more")));
        }
        to.check()?;
        let name = to.name().to_owned();
        let threads = options.threads();
        let sink = match to {
            To::Gif(to) => Sink::Gif(Box::new(Animation::create(to, threads)?)),
            To::Sequence(files) => Sink::Sequence(files.clone(), Workers::new(&name, threads)?),
        };
        Ok(Self { name, fps, frames: 0, shape: None, sink, failed: false })
    }

    /// How many frames it was given.
    #[must_use]
    pub const fn frames(&self) -> u64 {
        self.frames
    }

    /// Adds a frame of `width` × `height` pixels, `0x00RRGGBB`, row by row, that is shown for one frame's time.
    ///
    /// # Errors
    ///
    /// As [`picture`](Self::picture).
    pub fn frame(&mut self, pixels: &[u32], size: [u32; 2]) -> Result<(), Error> {
        self.picture(opaque(pixels, size))
    }

    /// The same for a frame of a recording in real time: it is shown from `time` after the first frame on, until the
    /// next one. Times do not decrease; in a sequence they do not matter.
    ///
    /// # Errors
    ///
    /// As [`picture`](Self::picture).
    pub fn frame_at(&mut self, pixels: &[u32], size: [u32; 2], time: Duration) -> Result<(), Error> {
        self.add(opaque(pixels, size), time)
    }

    /// Adds a picture that is shown for one frame's time. Its alpha channel, if it has one, is kept; in a GIF what is
    /// covered by less than half is transparent, and the rest opaque.
    ///
    /// # Errors
    ///
    /// [`Error::File`] for a picture that is not like the first one in size, or in having transparency; it is left out,
    /// and the recording goes on without it. [`Error::Write`] when this frame, or one before it, cannot be written; the
    /// recording is over then.
    pub fn picture(&mut self, picture: Picture) -> Result<(), Error> {
        let time = self.time(self.frames);
        self.add(picture, time)
    }

    /// Completes the files.
    ///
    /// # Errors
    ///
    /// [`Error::Write`] when a frame, or the file, cannot be written; then a GIF is not there. [`Error::File`] when there
    /// was no frame.
    pub fn finish(self) -> Result<(), Error> {
        let end = self.time(self.frames);
        self.finish_at(end)
    }

    /// The same for a recording in real time: its last frame is shown until `time` after the first one.
    ///
    /// # Errors
    ///
    /// As [`finish`](Self::finish).
    pub fn finish_at(mut self, time: Duration) -> Result<(), Error> {
        self.check_alive()?;
        if self.frames == 0 {
            return Err(Error::file(&self.name, "nothing was recorded: there was no frame"));
        }
        match &mut self.sink {
            Sink::Gif(animation) => animation.finish(time),
            Sink::Sequence(_, workers) => workers.drain(0, &mut |()| Ok(())),
        }
    }

    /// When frame `n`, counted from 0, begins.
    fn time(&self, n: u64) -> Duration {
        Duration::try_from_secs_f64(n as f64 / self.fps).unwrap_or(Duration::MAX)
    }

    fn add(&mut self, picture: Picture, time: Duration) -> Result<(), Error> {
        self.check_alive()?;
        self.check_shape(&picture)?;
        self.frames += 1;
        let added = match &mut self.sink {
            Sink::Gif(animation) => animation.add(picture, time),
            Sink::Sequence(files, workers) => {
                let (to, format) = (files.file(self.frames), files.format());
                let encode = move || {
                    let mut output = to.create()?;
                    output.fill(|out| write_picture(out, format, &picture))?;
                    output.commit()
                };
                workers.push(encode, &mut |()| Ok(()))
            }
        };
        self.failed = added.is_err();
        added
    }

    fn check_alive(&self) -> Result<(), Error> {
        if self.failed {
            return Err(Error::file(&self.name, "the recording has failed before: begin a new one"));
        }
        Ok(())
    }

    /// Refuses pictures that are none, or not like the first.
    fn check_shape(&mut self, picture: &Picture) -> Result<(), Error> {
        let Picture { width, height, pixels, alpha, .. } = picture;
        let count = u64::from(*width) * u64::from(*height);
        let whole = |length: usize| length as u64 == count;
        let most = self.sink.most_side();
        if count == 0
            || *width.max(height) > most
            || !whole(pixels.len())
            || alpha.as_ref().is_some_and(|a| !whole(a.len()))
        {
            let what = format!(
                "{} pixels for a frame of {width}×{height}: sides must have 1 to {most}, and each pixel its colour",
                pixels.len()
            );
            return Err(Error::file(&self.name, what));
        }
        let ([w, h], transparent) = *self.shape.get_or_insert(([*width, *height], alpha.is_some()));
        if [w, h] != [*width, *height] {
            let what = format!(
                "a frame of {width}×{height} pixels does not fit into a recording of {w}×{h}: keep the size, or record \
                 to another file"
            );
            return Err(Error::file(&self.name, what));
        }
        if transparent != alpha.is_some() {
            let what = "frames with and without transparency do not go into one recording: make all alike";
            return Err(Error::file(&self.name, what));
        }
        Ok(())
    }
}

impl Sink {
    /// The longest side of a frame.
    const fn most_side(&self) -> u32 {
        match self {
            Self::Gif(_) => u16::MAX as u32,
            Self::Sequence(..) => polosa_raster::MAX_SIDE,
        }
    }
}

/// Pixels that somebody else goes on using, as a picture.
fn opaque(pixels: &[u32], [width, height]: [u32; 2]) -> Picture {
    let stats = DrawStats::default();
    Picture { width, height, pixels: pixels.to_vec(), alpha: None, distances: None, ids: None, stats }
}

/// Bytes of memory that a recording takes for each pixel of a frame: those that are under way, that which the next is
/// held against, and that whose delay is not known yet.
#[must_use]
pub(crate) fn bytes_a_pixel(threads: NonZeroUsize, alpha: bool) -> usize {
    // Colours, and alpha; while a GIF's frame is encoded, an index and less than two bytes of code.
    (if alpha { 5 } else { 4 } + 3) * (threads.get() + 3)
}

/// Begins a recording to a file named by a path.
///
/// # Errors
///
/// As [`To::path`] and [`Recorder::create`].
pub fn to(path: impl AsRef<Path>, options: Options) -> Result<Recorder, Error> {
    Recorder::create(&To::path(path.as_ref())?, options)
}

#[cfg(test)]
mod tests;
