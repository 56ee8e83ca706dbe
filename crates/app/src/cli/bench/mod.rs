//! `polosa bench`: what this machine does with this model.
//!
//! ```text
//!   models ─▶ world ─▶ memset ─▶ warm-up ─▶ frame, frame, frame, … ─▶ median, spread, stages ─▶ report
//!   loaded    once     the       drawn,     drawn and timed              (measure.rs)          (report.rs)
//!                      yardstick not timed  (frames.rs)
//! ```
//!
//! A frame is what a window would show: the target is cleared, the world transformed, lit and drawn into it. Reading
//! the models and writing files are no part of it; nothing is written.

mod frames;
mod measure;
mod report;

use core::num::NonZeroUsize;
use std::path::{Path, PathBuf};
use std::process::ExitCode;
use std::thread;
use std::time::{Duration, Instant};

use clap::Args;
use polosa_raster::TargetError;
use polosa_scene::{DrawStats, PictureSettings, Show, World};

use self::frames::{Frames, Scene};
use self::measure::{Memset, Spread};
use super::args::{self, ModelArg};
use super::models::{self, ModelFacts};
use super::progress::Progress;
use super::view_args::{ViewArgs, after_help};
use super::{tell, unseen};
use crate::demo;
use crate::error::Error;
use crate::guard::caught;
use crate::view::Up;

/// Frames that are timed when nobody says how many.
const FRAMES: usize = 50;

/// When nobody says how many frames, no new one is begun after so long: huge models answer soon, too.
const PATIENCE: Duration = Duration::from_secs(5);

/// The first frames are slower: memory is touched for the first time, and the processor wakes up. So many are not
/// counted, or fewer if they take longer than [`WARM_UP_TIME`] together.
const WARM_UP: usize = 5;

/// See [`WARM_UP`].
const WARM_UP_TIME: Duration = Duration::from_millis(500);

/// Bytes of a pixel in memory: colour and depth.
const PIXEL: usize = 8;

/// Measures how fast this machine draws models
///
/// The models are read once, all into one scene as `render` does it, and drawn again and again into memory: cleared,
/// transformed, lit and drawn each time. Nothing is written. Reported are the median time of a frame and its spread,
/// triangles and pixels per second, the time of each stage, and beside them how long this machine takes for filling
/// as much memory with nothing.
///
/// Camera, looks and light are those of `render`. Let nothing else run meanwhile.
#[derive(Debug, Args)]
#[command(after_help = after_help(EXAMPLES))]
pub(super) struct BenchArgs {
    /// Files, `-` for standard input, or shapes such as shape:teapot [default: the built-in scene]
    #[arg(value_name = "MODEL", value_parser = ModelArg::parser())]
    models: Vec<ModelArg>,

    #[command(flatten)]
    view: ViewArgs,

    /// Frames that are timed, 1 to 1000000 [default: 50, or as many as 5 seconds are enough for]
    #[arg(long, value_name = "N", value_parser = args::frames, allow_hyphen_values = true)]
    frames: Option<NonZeroUsize>,

    /// The report as one line of JSON
    #[arg(long)]
    json: bool,
}

const EXAMPLES: &str = "  polosa bench bunny.obj
  polosa bench bunny.obj --resolution 1920,1080 --threads 1
  polosa bench floor.ply chair.glb --edges --frames 200
  polosa bench shape:torus:512:256 --json | jq .median_ms";

/// Measures, and prints the report.
pub(super) fn run(args: &BenchArgs) -> Result<ExitCode, Error> {
    args.view.check()?;
    ModelArg::check_stdin(&args.models)?;
    let name = args.models.first().map_or_else(|| PathBuf::from(BUILT_IN), ModelArg::name);
    let settings = args.view.settings(&name)?;
    let measured = caught(&name, || measure(args, &settings, &name))?;
    tell(&if args.json { report::json(&measured) } else { report::text(&measured) }, false);
    Ok(ExitCode::SUCCESS)
}

/// The name of what is drawn without models.
const BUILT_IN: &str = "built-in scene";

/// What was measured, as reports tell about it.
#[derive(Debug)]
struct Measured {
    models: Vec<ModelFacts>,
    settings: PictureSettings,
    threads: NonZeroUsize,
    /// Triangles of a frame: those of all surfaces.
    triangles: u64,
    timed: Timed,
    memset: Memset,
    /// See [`measure::fingerprint`].
    fingerprint: u64,
    notes: Vec<String>,
}

/// What the frames tell.
#[derive(Debug)]
struct Timed {
    /// Frames that were drawn before the first that counts.
    warm_up: usize,
    /// Frames that were asked for. Without a wish, fewer may have been drawn.
    asked: usize,
    /// The times of the frames that were drawn.
    frames: Spread,
    /// Each stage's median, in the order of the work.
    stages: Vec<(&'static str, Duration)>,
    /// What became of triangles and edges.
    stats: DrawStats,
}

fn measure(args: &BenchArgs, settings: &PictureSettings, name: &Path) -> Result<Measured, Error> {
    let steps = args.models.len().max(1) + args.frames.map_or(FRAMES, usize::from);
    let progress = Progress::new(steps as u64);
    let (world, facts, up) = world(args, &progress)?;
    models::reserve(settings, PIXEL, 0, name)?;
    let camera = models::camera(&world, &args.view, up, settings, name)?;

    let memset = Memset::measure(PIXEL * settings.width as usize * settings.height as usize);
    let threads = settings.threads.or_else(|| thread::available_parallelism().ok());
    let settings = PictureSettings { threads, ..*settings };
    let (light, style) = (args.view.light(), args.view.style());
    let scene = Scene { world: &world, camera: &camera, light: &light, style: &style, settings: &settings };
    let mut frames = Frames::new(&scene);
    progress.now(&format!("drawing {}", name.display()));
    let timed = time(&mut frames, &scene, args.frames, &progress)
        .map_err(|error| Error::file(name, error.to_string()))?;

    let picture = frames.into_picture(timed.stats);
    let mut notes: Vec<String> =
        unseen::note(&args.view, &settings, &world, &camera, &picture).into_iter().collect();
    if cfg!(debug_assertions) {
        notes
            .push("this program was built for finding defects: figures that count need --release".to_owned());
    }
    Ok(Measured {
        models: facts,
        settings,
        threads: threads.unwrap_or(NonZeroUsize::MIN),
        triangles: triangles(&world),
        timed,
        memset,
        fingerprint: measure::fingerprint(&picture.pixels),
        notes,
    })
}

/// Draws frames, at first for nothing, then with a look at the clock.
fn time(
    frames: &mut Frames,
    scene: &Scene<'_>,
    wish: Option<NonZeroUsize>,
    progress: &Progress,
) -> Result<Timed, TargetError> {
    let mut warm_up = 0;
    let start = Instant::now();
    while warm_up == 0 || (warm_up < WARM_UP && start.elapsed() < WARM_UP_TIME) {
        frames.draw(scene)?;
        warm_up += 1;
    }
    let asked = wish.map_or(FRAMES, usize::from);
    let mut times = Vec::new();
    let mut stages: Vec<(&'static str, Vec<Duration>)> = Vec::new();
    let mut stats = DrawStats::default();
    let start = Instant::now();
    while times.len() < asked && (times.is_empty() || wish.is_some() || start.elapsed() < PATIENCE) {
        let begun = Instant::now();
        let drawn = frames.draw(scene)?;
        times.push(begun.elapsed());
        stats = drawn.stats;
        for (stage, time) in drawn.stages {
            match stages.iter_mut().find(|(name, _)| *name == stage) {
                Some((_, times)) => times.push(time),
                None => stages.push((stage, vec![time])),
            }
        }
        progress.step();
    }
    let stages = stages.into_iter().map(|(stage, times)| (stage, Spread::of(times).median())).collect();
    Ok(Timed { warm_up, asked, frames: Spread::of(times), stages, stats })
}

/// What is drawn: the models, or the built-in scene.
fn world(args: &BenchArgs, progress: &Progress) -> Result<(World, Vec<ModelFacts>, Up), Error> {
    if !args.models.is_empty() {
        return models::load(&args.models, &args.view, args.json, progress);
    }
    let mut world = demo::world().map_err(|error| Error::file(BUILT_IN, error.to_string()))?;
    // Its objects are shown each in its own way, unless all are to be shown in one.
    let show = args.view.show();
    if show != Show::Surface {
        world.objects_mut().for_each(|(_, object)| object.show = show);
    }
    progress.step();
    Ok((world, Vec::new(), args.view.up.unwrap_or(Up::PlusY)))
}

/// The triangles of all surfaces that are shown.
fn triangles(world: &World) -> u64 {
    let shown = world.objects().filter(|(_, object)| object.visible && object.show != Show::Wire);
    shown.filter_map(|(_, object)| world.mesh(object.mesh())).map(|mesh| mesh.triangles().len() as u64).sum()
}
