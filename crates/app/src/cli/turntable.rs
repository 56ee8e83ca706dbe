//! `polosa turntable`: models turn round once, as an animation or a sequence of pictures.
//!
//! ```text
//!   models ─▶ world ─▶ View::turntable ─▶ camera of frame 0, 1, 2, … ─▶ Picture::render ─▶ Recorder ─▶ file
//!                      stands back                                       drawn             encoded
//!                      from the whole turn                                     └ side by side ┘
//! ```

mod report;

use core::num::NonZeroUsize;
use std::collections::HashSet;
use std::ffi::OsString;
use std::io::IsTerminal as _;
use std::process::ExitCode;
use std::time::{Duration, Instant};

use clap::Args;
use polosa_scene::{Camera, DrawStats, Picture, PictureSettings, Renderer};

use super::args::{self, ModelArg, OutputArg};
use super::job::identity;
use super::models::{self, ModelFacts};
use super::progress::Progress;
use super::view_args::{ViewArgs, after_help};
use super::{complain, tell, unseen};
use crate::error::{Error, one_line};
use crate::guard::caught;
use crate::output::Destination;
use crate::record::{MOST_FPS, Options, Recorder, To, bytes_a_pixel};
use crate::view::Up;

/// Draws models that turn round once, as an animation or a sequence of pictures
///
/// The models turn about an axis through the focal point, counter-clockwise for an observer whom the axis points at:
/// with the default axis, seen from above. Camera and light stand still, as beside a real turntable. The camera stands
/// back until the models fit the picture through the whole turn, unless --camera-position says where it stands. The
/// last frame is followed by the first.
///
/// Models, camera, looks and light are those of `render`. A GIF has 256 colours a frame, which for models of one colour
/// are enough to be exact; a sequence of PNG is exact always, and what video encoders take:
/// `ffmpeg -framerate 24 -i OUT_%04d.png OUT.mp4`.
#[derive(Debug, Args)]
#[command(after_help = after_help(EXAMPLES), allow_hyphen_values = false)]
pub(super) struct TurntableArgs {
    /// Files, `-` for standard input, or shapes such as shape:teapot
    #[arg(required = true, value_name = "MODEL", value_parser = ModelArg::parser())]
    models: Vec<ModelArg>,

    /// OUT.gif for an animation; a name with a place for the frame's number for a sequence, counted from 1: OUT_%04d.png
    /// (or .bmp, .tga, .qoi, .ppm, .jpg), OUT%d.png, with %% for a percent sign; `-` for GIF to standard output; {stem}
    /// in it for one turntable a model, named after it. Each file is complete or not there
    #[arg(short, long, value_name = "OUT", value_parser = OutputArg::parser(), allow_hyphen_values = true)]
    output: OutputArg,

    /// Frames of the turn, 1 to 1000000
    #[arg(long, value_name = "N", default_value = "72", value_parser = args::frames, allow_hyphen_values = true)]
    frames: NonZeroUsize,

    /// Frames a second, in a GIF up to 50. Its delays are whole hundredths of a second, whose sum is right
    #[arg(long, value_name = "F", default_value = "24", value_parser = args::fps, allow_hyphen_values = true)]
    fps: f64,

    /// The axis of the turn: +X, -X, +Y, -Y, +Z, -Z [default: the axis that is upward]. The opposite axis turns the other
    /// way
    #[arg(long, value_name = "AXIS", value_parser = args::up, allow_hyphen_values = true)]
    axis: Option<Up>,

    #[command(flatten)]
    view: ViewArgs,

    /// Reports counts and times: to standard output, or to standard error if the animation goes there
    #[arg(long)]
    stats: bool,

    /// The same report as JSON, one line a turntable
    #[arg(long)]
    json: bool,
}

const EXAMPLES: &str = "  polosa turntable bunny.obj -o bunny.gif
  polosa turntable bunny.obj -o bunny.gif --frames 120 --fps 30 --samples 16 --resolution 640,480
  polosa turntable part.stl -o 'part_%04d.png' --background none --camera-elevation-angle 20
  polosa turntable *.glb -o '{stem}.gif' --axis -Y --resolution 256,256
  polosa turntable shape:teapot -o - --frames 36 --fps 12 > teapot.gif";

/// One turntable to make.
struct Job<'a> {
    models: &'a [ModelArg],
    to: To,
}

/// Makes every turntable that the options ask for. A failure does not stop those that follow.
pub(super) fn run(args: &TurntableArgs) -> Result<ExitCode, Error> {
    args.view.check()?;
    let settings = args.view.settings(args.output.path())?;
    let jobs = jobs(args)?;

    let steps = args.models.len() + args.frames.get() * jobs.len();
    let progress = Progress::new(steps as u64);
    let mut renderer = Renderer::new();
    let mut status = ExitCode::SUCCESS;
    for job in &jobs {
        let made = caught(job.to.name(), || make(job, args, &settings, &mut renderer, &progress));
        progress.aside(|| match made {
            Ok(made) if args.json => tell(&report::json(&made), args.output.is_stdout()),
            Ok(made) if args.stats => tell(&report::text(&made), args.output.is_stdout()),
            Ok(_) => {}
            Err(error) => {
                complain(&error);
                status = ExitCode::from(error.exit_status());
            }
        });
    }
    Ok(status)
}

/// Which models go where. Refuses what cannot end well.
fn jobs(args: &TurntableArgs) -> Result<Vec<Job<'_>>, Error> {
    ModelArg::check_stdin(&args.models)?;
    if args.output.is_stdout() && std::io::stdout().is_terminal() {
        return Err(Error::Usage(
            "standard output is a terminal: name a file, or let a program read it".to_owned(),
        ));
    }
    let chunk = if args.output.has_stem() { 1 } else { args.models.len().max(1) };
    let jobs = args.models.chunks(chunk).map(|models| {
        let to = to(&args.output, &models.first().map(ModelArg::stem).unwrap_or_default())?;
        Ok(Job { models, to })
    });
    let jobs: Vec<Job<'_>> = jobs.collect::<Result<_, Error>>()?;
    let mut taken = HashSet::new();
    for Job { to, .. } in &jobs {
        let shown = one_line(&to.name().to_string_lossy());
        let file = match to {
            To::Gif(_) if args.fps > MOST_FPS => {
                return Err(Error::Usage(format!(
                    "--fps {}: browsers show animations of more than {MOST_FPS} frames a second at 10: lower --fps, or \
                     write a sequence such as OUT_%04d.png",
                    args.fps
                )));
            }
            To::Gif(file) => file.clone(),
            To::Sequence(files) => files.file(1),
        };
        if args.view.background == args::Background::Nothing && !to.has_alpha() {
            return Err(Error::Usage(format!(
                "--background none: {shown} keeps no transparency: use .gif, .png, .bmp, .tga or .qoi"
            )));
        }
        if !taken.insert(identity(&file)) && args.output.has_stem() {
            return Err(Error::Usage(format!(
                "{shown} would be written twice: rename one of the models, or turn them one by one"
            )));
        }
    }
    Ok(jobs)
}

/// Where the turntable of a model of this name goes. A percent sign of the model's begins no number.
fn to(output: &OutputArg, stem: &OsString) -> Result<To, Error> {
    let literal = match output.with_stem(stem) {
        Destination::Stdout => return Ok(To::Gif(Destination::Stdout)),
        Destination::File(path) => path,
    };
    match (To::path(&literal), stem.to_str()) {
        (Ok(To::Gif(file)), _) => Ok(To::Gif(file)),
        (_, Some(text)) if text.contains('%') && output.has_stem() => {
            match output.with_stem(&text.replace('%', "%%").into()) {
                Destination::File(path) => To::path(&path),
                Destination::Stdout => Ok(To::Gif(Destination::Stdout)),
            }
        }
        (to, _) => to,
    }
}

/// A turntable that was made, as reports tell about it.
struct Made<'a> {
    args: &'a TurntableArgs,
    to: &'a To,
    settings: &'a PictureSettings,
    models: Vec<ModelFacts>,
    /// Of the first frame.
    camera: Camera,
    /// Of the first frame.
    stats: DrawStats,
    notes: Vec<String>,
    read: Duration,
    draw: Duration,
    /// What the drawing waited for the encoding.
    wait: Duration,
}

fn make<'a>(
    job: &'a Job<'a>,
    args: &'a TurntableArgs,
    settings: &'a PictureSettings,
    renderer: &mut Renderer,
    progress: &Progress,
) -> Result<Made<'a>, Error> {
    let (to, name) = (&job.to, job.to.name());
    let failed = |error: &dyn std::error::Error| Error::file(name, error.to_string());
    to.check()?;
    let start = Instant::now();
    let (world, models, up) = models::load(job.models, &args.view, args.json, progress)?;
    let read = start.elapsed();

    let options = Options { fps: args.fps, threads: settings.threads };
    let transparent = settings.background.is_none();
    let picture = 4 + usize::from(transparent);
    models::reserve(settings, picture + bytes_a_pixel(options.threads(), transparent), 0, name)?;
    let aspect = f64::from(settings.width) / f64::from(settings.height);
    let (view, axis) = (args.view.view(up), args.axis.unwrap_or(up));
    let table = view.turntable(models::points(&world), &world.bounds(), axis, aspect);
    let table = table.map_err(|error| failed(&error))?;
    let (light, style) = (args.view.light(), args.view.style());

    progress.now(&format!("drawing {}", name.display()));
    let mut recorder = Recorder::create(to, options)?;
    let frames = args.frames.get() as u32;
    let (mut stats, mut draw, mut wait) = (DrawStats::default(), Duration::ZERO, Duration::ZERO);
    let (mut note, mut blank) = (None, true);
    for n in 0..frames {
        let begun = Instant::now();
        let (camera, light) = table.frame(n, frames, &light).map_err(|error| failed(&error))?;
        let picture = Picture::render(renderer, &world, &camera, &light, &style, settings);
        let picture = picture.map_err(|error| failed(&error))?;
        if n == 0 {
            stats = picture.stats;
        }
        if blank {
            // Of a turn that shows nothing at all the last frame's reason is told.
            note = unseen::note(&args.view, settings, &world, &camera, &picture);
            blank = unseen::is_blank(settings, &picture);
        }
        let drawn = Instant::now();
        recorder.picture(picture)?;
        draw += drawn - begun;
        wait += drawn.elapsed();
        progress.step();
    }
    let notes: Vec<String> = note.into_iter().collect();
    if !args.json {
        progress
            .aside(|| notes.iter().for_each(|text| models::note(&one_line(&name.to_string_lossy()), text)));
    }
    let drawn = Instant::now();
    recorder.finish()?;
    wait += drawn.elapsed();

    Ok(Made { args, to, settings, models, camera: *table.first(), stats, notes, read, draw, wait })
}
