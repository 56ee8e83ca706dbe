//! `polosa compare`: whether two pictures are the same, and how far they are from each other.
//!
//! ```text
//!   A, B ─▶ decode ─▶ figures ─▶ difference picture ─▶ report ─▶ exit status 0, 1 or 2
//!                     (crate::compare)                 (report.rs)
//! ```
//!
//! Whoever has golden images asks this of every build. Hence `cmp`'s exit status, of which 2 is for everything that
//! kept the question from being answered: a file that is missing must not pass for one that differs.

mod report;

use std::ffi::OsString;
use std::io::IsTerminal as _;
use std::path::{Path, PathBuf};
use std::process::ExitCode;

use clap::Args;
use clap::builder::{OsStringValueParser, TypedValueParser};

use super::args::{self, OutputArg};
use super::job::{self, identity, is_special};
use super::progress::Progress;
use super::{complain, print};
use crate::compare::{
    Background, CompareError, Comparison, Image, MAX_PIXELS, Settings, compare, difference_picture,
};
use crate::decode::{Decoded, SMALLER, reserve};
use crate::encode::{self, ImageFormat};
use crate::error::Error;
use crate::guard::caught;
use crate::output::Destination;

/// The pictures differ.
const DIFFERENT: u8 = 1;

/// Whether they do could not be found out.
const TROUBLE: u8 = 2;

/// Tells whether two pictures are the same, and how far they are from each other
///
/// Exit status, as of cmp: 0 when the pictures are the same, 1 when they differ, 2 for trouble. Without --threshold
/// and --allow-pixels they are the same when every code of every pixel is. Pictures of two sizes differ.
///
/// A and B are PNG, BMP, TGA, QOI, PPM or JPEG files, or distances as PFM, or `-` for standard input, one of them.
/// What a file is, its content decides. Codes are compared as they are stored, alpha too; where one picture has 16
/// bits a channel, at 16 bits.
#[derive(Debug, Args)]
#[command(after_help = AFTER_HELP)]
pub(super) struct CompareArgs {
    /// A picture, such as the one that is known to be right
    #[arg(value_name = "A", value_parser = PictureArg::parser())]
    a: PictureArg,

    /// The other picture
    #[arg(value_name = "B", value_parser = PictureArg::parser())]
    b: PictureArg,

    /// The largest difference of a channel that is let pass: in codes, 0 to 255 (or to 65535, with 16 bits); for
    /// PFM, in its unit
    #[arg(long, value_name = "N", default_value = "0", value_parser = args::threshold, allow_hyphen_values = true)]
    threshold: f64,

    /// How many pixels may differ by more than the threshold
    #[arg(long, value_name = "N", default_value = "0", value_parser = args::pixels, allow_hyphen_values = true)]
    allow_pixels: u64,

    /// What is not part of the silhouettes: a colour, or none for what is transparent [default: the colour of A's
    /// upper left corner]
    #[arg(long, value_name = "C", value_parser = args::background)]
    background: Option<args::Background>,

    /// A picture of what differs: red to yellow beyond the threshold, blue within it, magenta where one picture has
    /// no pixel; what is the same is dim. `-` for PNG to standard output
    #[arg(long, value_name = "OUT.png", value_parser = OutputArg::parser(), allow_hyphen_values = true)]
    diff: Option<OutputArg>,

    /// The report as one line of JSON
    #[arg(long)]
    json: bool,

    /// No report: the exit status says it
    #[arg(short, long, conflicts_with = "json")]
    quiet: bool,
}

const AFTER_HELP: &str = "\
Figures:
  differing     pixels that differ at all
  largest       the largest difference of a channel, and the first pixel with it
  mean          the mean difference of all channels of all pixels
  PSNR          the peak signal-to-noise ratio: the higher, the more alike
  silhouettes   the farthest from a pixel of either outline to the other outline;
                an outline is what has background above, below or beside it

Examples:
  polosa compare golden.png new.png
  polosa compare golden.png new.png --threshold 2 --allow-pixels 10 --diff diff.png
  polosa compare golden.pfm new.pfm --threshold 1e-5 --quiet
  polosa compare golden.png new.png --json | jq .silhouette_px
  polosa render bunny.obj -o - | polosa compare golden.png -";

/// A picture that is read.
#[derive(Clone, Debug, PartialEq, Eq)]
enum PictureArg {
    File(PathBuf),
    Stdin,
}

impl PictureArg {
    fn parser() -> impl TypedValueParser<Value = Self> {
        OsStringValueParser::new().try_map(|text: OsString| match text.to_str() {
            Some("-") => Ok(Self::Stdin),
            Some("") => Err("an empty name: name a file, or `-` for standard input"),
            _ => Ok(Self::File(text.into())),
        })
    }

    /// The name in messages.
    fn name(&self) -> &Path {
        match self {
            Self::File(path) => path,
            Self::Stdin => Path::new("standard input"),
        }
    }

    fn read(&self) -> Result<Decoded, Error> {
        caught(self.name(), || match self {
            Self::File(path) => Decoded::load(path),
            Self::Stdin => Decoded::read(std::io::stdin().lock(), self.name()),
        })
    }
}

/// Compares, and prints the report. Every failure is trouble.
pub(super) fn run(args: &CompareArgs) -> Result<ExitCode, Error> {
    let status = match answer(args) {
        Ok(true) => 0,
        Ok(false) => DIFFERENT,
        Err(errors) => {
            errors.iter().for_each(complain);
            TROUBLE
        }
    };
    Ok(ExitCode::from(status))
}

/// Whether the pictures are the same, or all that is in the way of knowing.
fn answer(args: &CompareArgs) -> Result<bool, Vec<Error>> {
    let alone = |error: Error| vec![error];
    let diff = output(args).map_err(alone)?;
    if let Some((to, _)) = &diff {
        to.check().map_err(alone)?;
    }
    let progress = Progress::new(3);
    let read = |picture: &PictureArg| {
        progress.now(&format!("reading {}", picture.name().display()));
        let read = picture.read();
        progress.step();
        read
    };
    let (a, b) = match (read(&args.a), read(&args.b)) {
        (Ok(a), Ok(b)) => (a, b),
        (a, b) => return Err([a.err(), b.err()].into_iter().flatten().collect()),
    };
    progress.now("comparing");
    let made = caught(args.b.name(), || compared(args, &a, &b, diff.as_ref())).map_err(alone)?;
    drop(progress);
    if !args.quiet {
        let report = if args.json { report::json(args, &made) } else { report::text(args, &made) };
        let to_stderr = diff.is_some_and(|(to, _)| to == Destination::Stdout);
        let name = if to_stderr { "standard error" } else { "standard output" };
        print(&report, to_stderr).map_err(|error| alone(Error::write(name, error)))?;
    }
    Ok(made.same())
}

/// What reports tell about.
#[derive(Debug)]
struct Compared {
    /// Width and height of each.
    sizes: [[u32; 2]; 2],
    /// What the files were.
    formats: [&'static str; 2],
    /// `None` when the sizes differ.
    figures: Option<Comparison>,
}

impl Compared {
    fn same(&self) -> bool {
        self.figures.is_some_and(|figures| figures.same)
    }
}

fn compared(
    args: &CompareArgs,
    a: &Decoded,
    b: &Decoded,
    diff: Option<&(Destination, ImageFormat)>,
) -> Result<Compared, Error> {
    let failed = |error: CompareError| {
        let names = [&args.a, &args.b].map(|picture| picture.name().to_string_lossy());
        Error::file(format!("{} and {}", names[0], names[1]), error.to_string())
    };
    let [image_a, image_b] = [a, b].map(Decoded::image);
    let (image_a, image_b) = (image_a.map_err(failed)?, image_b.map_err(failed)?);
    let [of_colors, too] = [&image_a, &image_b].map(|image| image.pixels().largest_code().is_some());
    if of_colors != too {
        return Err(failed(CompareError::Kinds));
    }
    // Before anything is compared, so that no answer that is known is lost.
    let [width, height] = [0, 1].map(|side| u64::from(a.size()[side].max(b.size()[side])));
    if diff.is_some() && width * height > MAX_PIXELS as u64 {
        return usage(format!(
            "--diff: its picture would have {width}×{height} pixels, more than {MAX_PIXELS}: leave it out"
        ));
    }
    let shown = if diff.is_some() { width * height } else { 0 };
    let pixels = a.size().map(u64::from).iter().product::<u64>();
    // Silhouettes, outlines and ways have eight bytes a pixel, the picture of what differs has four; two rows of
    // codes, and what the ways along a row need, have 44 bytes a pixel of a row.
    reserve(8 * pixels + 44 * width + 4 * shown, SMALLER, args.a.name())?;
    let settings = Settings {
        threshold: args.threshold,
        allowed_pixels: args.allow_pixels,
        background: background(args, &image_a)?,
    };
    let figures = match compare(&image_a, &image_b, &settings) {
        Ok(figures) => Some(figures),
        // No trouble: there is nothing that is not known.
        Err(CompareError::Sizes { .. }) => None,
        Err(error) => return Err(failed(error)),
    };
    if let Some((to, format)) = diff {
        let picture = difference_picture(&image_a, &image_b, args.threshold).map_err(failed)?;
        let mut output = to.create()?;
        output.fill(|out| encode::write_picture(out, *format, &picture))?;
        output.commit()?;
    }
    Ok(Compared { sizes: [a.size(), b.size()], formats: [a.format(), b.format()], figures })
}

fn background(args: &CompareArgs, image: &Image<'_>) -> Result<Background, Error> {
    if args.background.is_some() && image.pixels().largest_code().is_none() {
        return usage("--background: in distances it is always what is infinite".to_owned());
    }
    Ok(match args.background {
        None => Background::Corner,
        Some(args::Background::Nothing) => Background::Transparent,
        Some(args::Background::Color(color)) => Background::Color(color),
    })
}

/// Where the picture of what differs goes. Refuses what cannot end well, before anything is read.
fn output(args: &CompareArgs) -> Result<Option<(Destination, ImageFormat)>, Error> {
    if args.a == PictureArg::Stdin && args.b == PictureArg::Stdin {
        return usage("standard input can be read only once: name `-` once".to_owned());
    }
    let Some(diff) = &args.diff else { return Ok(None) };
    let format = job::format("--diff", diff)?;
    if !format.is_lossless() {
        return usage("--diff: JPEG blurs single pixels: use .png".to_owned());
    }
    if diff.is_stdout() {
        if std::io::stdout().is_terminal() {
            return usage("standard output is a terminal: name a file, or let a program read it".to_owned());
        }
        return Ok(Some((Destination::Stdout, format)));
    }
    let to = Destination::File(diff.path().to_owned());
    for picture in [&args.a, &args.b] {
        if let PictureArg::File(path) = picture
            && !is_special(diff.path())
            && identity(&to) == identity(&Destination::File(path.clone()))
        {
            return usage(
                "--diff: would be written over a picture that is compared: choose another name".to_owned(),
            );
        }
    }
    Ok(Some((to, format)))
}

fn usage<T>(message: String) -> Result<T, Error> {
    Err(Error::Usage(message))
}
