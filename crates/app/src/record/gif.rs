//! An animated GIF, of what changes from frame to frame.
//!
//! ```text
//!   first frame      second frame: the rectangle around what has changed,
//!   ┌──────────┐     ┌──────────┐   in it what has not is transparent, and shows
//!   │  ▲       │     │ ┌╌╌╌┐    │   what was there before
//!   │ ▲▲▲      │     │ ╎ ▲ ╎    │
//!   └──────────┘     └─└╌╌╌┘────┘
//! ```
//!
//! Pictures with transparency cannot be made of changes, since nothing in a GIF takes a pixel away: each of their frames
//! is stored as far as it is opaque, and cleared before the next.

use core::num::NonZeroUsize;
use std::borrow::Cow;
use std::collections::HashMap;
use std::io;
use std::sync::Arc;
use std::time::Duration;

use gif::{DisposalMethod, Encoder, EncodingError, Frame, Repeat};
use polosa_scene::Picture;

use super::clock::Clock;
use super::palette::{Counted, Nearest, palette};
use super::workers::Workers;
use crate::error::Error;
use crate::output::{Destination, Output};

/// What of a pixel's area must be covered for it to be opaque, of 255.
const OPAQUE: u8 = 128;

/// The longest that a frame is shown: a day, in hundredths of a second. An animation that stands still for longer is a
/// mistake, and would be stored as many frames.
const LONGEST: u64 = 24 * 60 * 60 * 100;

/// Entries of a palette.
const MOST_COLORS: usize = 256;

/// An animation in the making.
#[derive(Debug)]
pub(super) struct Animation {
    file: File,
    clock: Clock<Picture>,
    /// The frame before the one that is held back.
    before: Option<Arc<Picture>>,
    workers: Workers<(Frame<'static>, u64)>,
}

/// The file, as far as it is written.
struct File {
    output: Option<Output>,
    /// Writes into memory, from where it is taken after each frame; `None` before the first frame.
    encoder: Option<Encoder<Vec<u8>>>,
    size: [u16; 2],
}

impl core::fmt::Debug for File {
    fn fmt(&self, f: &mut core::fmt::Formatter<'_>) -> core::fmt::Result {
        f.debug_struct("File").field("output", &self.output).field("size", &self.size).finish_non_exhaustive()
    }
}

impl Animation {
    pub(super) fn create(to: &Destination, threads: NonZeroUsize) -> Result<Self, Error> {
        let workers = Workers::new(to.name(), threads)?;
        let file = File { output: Some(to.create()?), encoder: None, size: [0; 2] };
        Ok(Self { file, clock: Clock::new(), before: None, workers })
    }

    /// Adds a frame that begins at a time. All are of one size, at most 65,535 pixels a side.
    pub(super) fn add(&mut self, picture: Picture, time: Duration) -> Result<(), Error> {
        if let Some((picture, delay)) = self.clock.next(picture, time) {
            self.encode(picture, delay)?;
        }
        Ok(())
    }

    /// Completes the file; the last frame ends at a time.
    pub(super) fn finish(&mut self, time: Duration) -> Result<(), Error> {
        if let Some((picture, delay)) = self.clock.end(time) {
            self.encode(picture, delay)?;
        }
        let file = &mut self.file;
        self.workers.drain(0, &mut |(frame, delay)| file.frame(frame, delay))?;
        file.finish()
    }

    fn encode(&mut self, picture: Picture, delay: u64) -> Result<(), Error> {
        // The recorder has seen to it that sides are no longer.
        self.file.size = [picture.width, picture.height].map(|side| side as u16);
        let now = Arc::new(picture);
        let before = self.before.replace(Arc::clone(&now));
        let file = &mut self.file;
        let encode = move || Ok((encode(before.as_deref(), &now), delay));
        self.workers.push(encode, &mut |(frame, delay)| file.frame(frame, delay))
    }
}

impl File {
    /// Writes a frame that is shown so long.
    fn frame(&mut self, mut frame: Frame<'static>, delay: u64) -> Result<(), Error> {
        let mut delay = delay.min(LONGEST);
        loop {
            frame.delay = u16::try_from(delay).unwrap_or(u16::MAX);
            delay -= u64::from(frame.delay);
            self.write(|encoder| encoder.write_lzw_pre_encoded_frame(&frame))?;
            if delay == 0 {
                return Ok(());
            }
            // Eleven minutes are the most that a frame has; then it is shown again.
            if frame.dispose == DisposalMethod::Keep {
                frame = nothing(DisposalMethod::Keep);
            }
        }
    }

    fn write(
        &mut self,
        write: impl FnOnce(&mut Encoder<Vec<u8>>) -> Result<(), EncodingError>,
    ) -> Result<(), Error> {
        let Self { output: Some(output), encoder, size } = self else { return Ok(()) };
        output.fill(|out| {
            let encoder = match encoder {
                Some(encoder) => encoder,
                none => {
                    let mut new = Encoder::new(Vec::new(), size[0], size[1], &[]).map_err(failed)?;
                    new.set_repeat(Repeat::Infinite).map_err(failed)?;
                    none.insert(new)
                }
            };
            write(encoder).map_err(failed)?;
            let bytes = encoder.get_mut();
            out.write_all(bytes)?;
            bytes.clear();
            Ok(())
        })
    }

    fn finish(&mut self) -> Result<(), Error> {
        let (Some(mut output), Some(encoder)) = (self.output.take(), self.encoder.take()) else {
            return Ok(());
        };
        output.fill(|out| out.write_all(&encoder.into_inner().map_err(failed)?))?;
        output.commit()
    }
}

fn failed(error: EncodingError) -> io::Error {
    match error {
        EncodingError::Io(error) => error,
        other => io::Error::other(other),
    }
}

/// A frame that changes nothing.
fn nothing(dispose: DisposalMethod) -> Frame<'static> {
    let mut frame = Frame {
        width: 1,
        height: 1,
        dispose,
        transparent: Some(0),
        palette: Some(vec![0; 3]),
        buffer: Cow::Borrowed(&[0]),
        ..Frame::default()
    };
    frame.make_lzw_pre_encoded();
    frame
}

/// What of a picture is stored: a rectangle, and in it what is not left out.
struct Stored<'a> {
    before: Option<&'a Picture>,
    now: &'a Picture,
    left: usize,
    top: usize,
    width: usize,
    height: usize,
}

impl<'a> Stored<'a> {
    /// What has changed, or of a picture with transparency what is opaque. `None`: nothing.
    fn new(before: Option<&'a Picture>, now: &'a Picture) -> Option<Self> {
        let (width, height) = (now.width as usize, now.height as usize);
        let before = before.filter(|_| now.alpha.is_none());
        let all = Self { before, now, left: 0, top: 0, width, height };
        let (mut x, mut y) = ([usize::MAX, 0], [usize::MAX, 0]);
        for row in 0..height {
            let range = row * width..(row + 1) * width;
            if before.is_some_and(|before| before.pixels[range.clone()] == now.pixels[range]) {
                continue;
            }
            let is_stored = |column: &usize| all.color(*column, row).is_some();
            if let (Some(first), Some(last)) = ((0..width).find(is_stored), (0..width).rfind(is_stored)) {
                x = [x[0].min(first), x[1].max(last)];
                y = [y[0].min(row), row];
            }
        }
        (x[0] <= x[1]).then(|| Self {
            left: x[0],
            top: y[0],
            width: x[1] + 1 - x[0],
            height: y[1] + 1 - y[0],
            ..all
        })
    }

    /// The colour of a pixel of the rectangle; `None`: it is left out.
    fn color(&self, column: usize, row: usize) -> Option<u32> {
        let k = (self.top + row) * self.now.width as usize + self.left + column;
        let color = self.now.pixels[k] & 0xff_ffff;
        let is_left_out = match (&self.now.alpha, self.before) {
            (Some(alpha), _) => alpha[k] < OPAQUE,
            (None, Some(before)) => before.pixels[k] & 0xff_ffff == color,
            (None, None) => false,
        };
        (!is_left_out).then_some(color)
    }

    /// The colours of all pixels, row by row.
    fn colors(&self) -> impl Iterator<Item = Option<u32>> {
        (0..self.height).flat_map(move |row| (0..self.width).map(move |column| self.color(column, row)))
    }

    /// The colours that there are, counted, in ascending order; whether pixels are left out.
    fn counted(&self) -> (Vec<Counted>, bool) {
        let (mut counts, mut holes) = (HashMap::new(), false);
        // Pixels that are alike mostly lie side by side: each run is looked up once.
        let mut run = (None, 0);
        let mut add = |(color, length): (Option<u32>, u64)| match color {
            Some(color) => *counts.entry(color).or_insert(0) += length,
            None => holes |= length > 0,
        };
        for color in self.colors() {
            if color != run.0 {
                add(std::mem::replace(&mut run, (color, 0)));
            }
            run.1 += 1;
        }
        add(run);
        let mut counted: Vec<Counted> = counts.into_iter().collect();
        counted.sort_unstable();
        (counted, holes)
    }
}

/// A frame that makes `now` of what is on show, which is `before`.
fn encode(before: Option<&Picture>, now: &Picture) -> Frame<'static> {
    let dispose = if now.alpha.is_some() { DisposalMethod::Background } else { DisposalMethod::Keep };
    let Some(mut stored) = Stored::new(before, now) else { return nothing(dispose) };
    let (mut counted, mut holes) = stored.counted();
    if holes && counted.len() == MOST_COLORS && now.alpha.is_none() {
        // No entry is left to be transparent, but perhaps none is needed: what is left out may have these colours, too.
        let whole = Stored { before: None, ..stored };
        let (all, _) = whole.counted();
        if all.len() == MOST_COLORS {
            (stored, counted, holes) = (whole, all, false);
        }
    }
    let colors = palette(&counted, MOST_COLORS - usize::from(holes));
    let nearest = Nearest::new(&colors);
    let places: HashMap<u32, u8> = counted.iter().map(|(color, _)| (*color, nearest.index(*color))).collect();
    // No entry of the palette's: its last place is free then.
    let transparent = holes.then_some(colors.len() as u8);

    let mut run = (None, transparent.unwrap_or_default());
    let indices = stored.colors().map(|color| {
        if color != run.0 {
            let place = color.and_then(|color| places.get(&color).copied());
            run = (color, place.or(transparent).unwrap_or_default());
        }
        run.1
    });
    let buffer: Vec<u8> = indices.collect();
    let mut bytes: Vec<u8> = colors.iter().flat_map(|color| color.to_be_bytes()[1..].to_owned()).collect();
    bytes.extend_from_slice(&[0; 3][..if holes { 3 } else { 0 }]);
    let mut frame = Frame {
        left: stored.left as u16,
        top: stored.top as u16,
        width: stored.width as u16,
        height: stored.height as u16,
        dispose,
        transparent,
        palette: Some(bytes),
        buffer: Cow::Owned(buffer),
        ..Frame::default()
    };
    frame.make_lzw_pre_encoded();
    frame
}
