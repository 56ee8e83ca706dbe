//! `polosa view`: models in a window.

use std::io::IsTerminal as _;
use std::path::Path;
use std::process::ExitCode;
use std::time::Duration;

use clap::Args;
use polosa_scene::{Light, import};
use serde_json::json;

use super::args::{Background, ModelArg, OutputArg};
use super::view_args::{self, ViewArgs};
use super::{complain, job, models, tell};
use crate::application::{Application, Statistics};
use crate::demo;
use crate::encode::save_picture;
use crate::error::Error;
use crate::output::Destination;
use crate::settings::{Navigate, Settings};
use crate::view::View;
use crate::viewer::{Options, Viewer};

/// The most frames a second. Events come faster than a screen shows frames; what is drawn between two of its pictures
/// is seen by nobody, and what waits for the next one is seen late. This is four times what most screens show.
const FRAME_RATE: f64 = 240.0;

const OTHER: &str = "Window";

/// Shows models in a window: drag to go round them, H shows all keys
///
/// `polosa MODEL...` is the same. Without a model it shows a built-in scene. Where no window can be opened, the picture
/// goes to a file.
#[derive(Debug, Args)]
#[command(after_help = view_args::after_help(EXAMPLES))]
pub(super) struct WindowArgs {
    /// Files (OBJ, STL, PLY, glTF), `-` for standard input, or shape:NAME; all in one world. Other files can be dropped
    /// on the window
    #[arg(value_name = "MODEL", value_parser = ModelArg::parser())]
    models: Vec<ModelArg>,

    #[command(flatten)]
    view: ViewArgs,

    /// Reads files again when they are written; the camera stays
    #[arg(long, help_heading = OTHER)]
    watch: bool,

    /// Draws a grid under the models
    #[arg(short, long, help_heading = OTHER)]
    grid: bool,

    /// Shows the directions of the world's axes
    #[arg(short = 'x', long, help_heading = OTHER)]
    axis: bool,

    /// Lets the camera turn over the poles
    #[arg(long, help_heading = OTHER)]
    trackball: bool,

    /// The picture's file where no window can be opened
    #[arg(short, long, value_name = "FILE", default_value = demo::FILE, value_parser = OutputArg::parser(), help_heading = OTHER)]
    output: OutputArg,

    /// Shows times and counts in the window, and reports them at the end
    #[arg(long, help_heading = OTHER)]
    stats: bool,

    /// Reports times and counts at the end as JSON
    #[arg(long, help_heading = OTHER)]
    json: bool,
}

const EXAMPLES: &str = "  polosa view bunny.obj
  polosa bunny.obj --edges --grid
  polosa view part.stl --watch --camera-orthographic
  polosa view shape:teapot:16 --stats";

/// Shows what the options say.
pub(super) fn run(args: &WindowArgs) -> Result<ExitCode, Error> {
    args.view.check()?;
    ModelArg::check_stdin(&args.models)?;
    job::format("--output", &args.output)?;
    let (mut app, mut viewer) = prepare(args)?;
    // What is not there needs no window.
    for model in &args.models {
        if let ModelArg::File(path) = model
            && !path.exists()
        {
            import::load(path)?;
        }
    }
    match app.run_unlogged(&mut viewer) {
        Ok(()) => {}
        Err(error @ Error::Window(_)) if app.statistics().frames() == 0 => {
            complain(&error);
            return without_window(args, app, viewer);
        }
        Err(error) => return Err(error),
    }
    if let Some(error) = viewer.take_failure() {
        return Err(error);
    }
    if args.json {
        tell(&format!("{}\n", json(app.statistics())), false);
    } else if args.stats {
        tell(&text(app.statistics()), false);
    }
    Ok(ExitCode::SUCCESS)
}

/// The application and the viewer that the options ask for.
fn prepare(args: &WindowArgs) -> Result<(Application, Viewer), Error> {
    let settings = args.view.settings(Path::new("the window"))?;
    let background = match args.view.background {
        // The built-in scene has its own.
        Background::Color(_) if args.models.is_empty() && args.view.has_default_background() => {
            demo::BACKGROUND
        }
        Background::Color(color) => color,
        Background::Nothing => {
            return Err(Error::Usage(
                "--background none: a window is not transparent: name a colour".to_owned(),
            ));
        }
    };
    let (view, up) = args.view.view_and_up();
    if args.models.is_empty() && (view != View::default() || args.view.light() != Light::default()) {
        return Err(Error::Usage(
            "the built-in scene has a view and a light of its own: name a model, or leave out the options about camera \
             and light"
                .to_owned(),
        ));
    }
    let mut app = Application::with(Settings {
        title: "polosa".to_owned(),
        size: [settings.width, settings.height],
        frame_rate: FRAME_RATE,
        background,
        samples: settings.samples,
        threads: settings.threads,
        navigation: if args.trackball { Navigate::Trackball } else { Navigate::Orbit },
        ..Settings::default()
    });
    (app.light, app.style) = (args.view.light(), args.view.style());
    let options = Options {
        view,
        up,
        show: args.view.show(),
        watch: args.watch,
        grid: args.grid,
        axes: args.axis,
        statistics: args.stats,
    };
    Ok((app, Viewer::new(args.models.clone(), options)))
}

/// The picture that the window would have shown at first, to a file.
fn without_window(args: &WindowArgs, mut app: Application, mut viewer: Viewer) -> Result<ExitCode, Error> {
    let format = job::format("--output", &args.output)?;
    if args.output.is_stdout() && std::io::stdout().is_terminal() {
        return Err(Error::Usage(
            "standard output is a terminal: name a file, or let a program read it".to_owned(),
        ));
    }
    let destination = args.output.with_stem(&args.models.first().map(ModelArg::stem).unwrap_or_default());
    let settings = args.view.settings(destination.name())?;
    save_picture(&destination, format, || {
        models::reserve(&settings, 4, 0, destination.name())?;
        viewer.load_now(&mut app)?;
        app.picture()
    })?;
    if args.stats || args.json || args.axis {
        let what = "without a window there are no times to report, and nothing is drawn over the picture";
        models::note(&destination.name().to_string_lossy(), what);
    }
    if destination != Destination::Stdout {
        let path = destination.name();
        let path = std::path::absolute(path).unwrap_or_else(|_| path.to_owned());
        tell(&format!("{}\n", path.display()), false);
    }
    Ok(ExitCode::SUCCESS)
}

/// The command of no arguments: the built-in scene, in a window or as the picture in the current folder.
pub(super) fn demo() -> Result<ExitCode, Error> {
    let settings = Settings {
        size: [1280, 720],
        frame_rate: FRAME_RATE,
        background: demo::BACKGROUND,
        ..Settings::default()
    };
    let (mut app, mut viewer) = (Application::with(settings), Viewer::new(Vec::new(), Options::default()));
    match app.run_unlogged(&mut viewer) {
        Err(error @ Error::Window(_)) if app.statistics().frames() == 0 => {
            complain(&error);
            let path = demo::write(Path::new(demo::FILE))?;
            tell(&format!("{}\n", path.display()), false);
            Ok(ExitCode::SUCCESS)
        }
        Err(error) => Err(error),
        Ok(()) => viewer.take_failure().map_or(Ok(ExitCode::SUCCESS), Err),
    }
}

/// The median, the time that 95 % keep within, and the longest, in milliseconds; `None` of nothing.
fn spread(times: impl Iterator<Item = Duration>) -> Option<[f64; 3]> {
    let mut times: Vec<f64> = times.map(|time| time.as_secs_f64() * 1e3).collect();
    times.sort_by(f64::total_cmp);
    let last = times.len().checked_sub(1)?;
    Some([times[last / 2], times[(last * 95).div_ceil(100)], times[last]])
}

/// For people.
fn text(statistics: &Statistics) -> String {
    let line = |name: &str, times: Option<[f64; 3]>| match times {
        None => format!("{name}: none\n"),
        Some([median, most, longest]) => {
            format!("{name}: median {median:.2} ms, 95 % within {most:.2} ms, longest {longest:.2} ms\n")
        }
    };
    let last = statistics.last();
    format!(
        "frames: {}\n{}{}triangles: {} of {} drawn in the last frame\n",
        statistics.frames(),
        line("drawing", spread(statistics.times())),
        line("event to screen", spread(statistics.latencies())),
        last.triangles.drawn,
        last.triangles.submitted + last.hidden,
    )
}

/// For programs: times in milliseconds, as median, 95th percentile, longest.
fn json(statistics: &Statistics) -> serde_json::Value {
    let times = |times: Option<[f64; 3]>| match times {
        None => serde_json::Value::Null,
        Some([median, most, longest]) => json!({ "median_ms": median, "p95_ms": most, "max_ms": longest }),
    };
    let last = statistics.last();
    json!({
        "frames": statistics.frames(),
        "drawing": times(spread(statistics.times())),
        "event_to_screen": times(spread(statistics.latencies())),
        "answered": statistics.latencies().len(),
        "triangles": last.triangles.submitted + last.hidden,
        "drawn": last.triangles.drawn,
    })
}

#[cfg(test)]
mod tests {
    use std::time::Duration;

    use super::spread;

    #[test]
    fn the_spread_is_of_sorted_times() {
        assert_eq!(spread(std::iter::empty()), None);
        assert_eq!(spread([Duration::from_millis(3)].into_iter()), Some([3.0; 3]));
        let times = (1..=100).rev().map(Duration::from_millis);
        assert_eq!(spread(times), Some([50.0, 96.0, 100.0]));
    }
}
