//! The command line: one file a command.
//!
//! ```text
//!   args ─▶ values ─▶ model ─▶ view ─▶ Picture::render ─▶ encode ─▶ output
//!          (args.rs)  models   camera      (scene)                  rename
//! ```
//!
//! Exit status: 0 when all is done, 1 when something was not, 2 for wrong usage; of `compare`, as of `cmp`: 0 when the
//! pictures are the same, 1 when they differ, 2 when that could not be found out. Every failure is one line on
//! standard error.

mod args;
mod bench;
mod compare;
mod info;
mod job;
mod methods;
mod models;
mod progress;
mod render;
mod render_args;
mod report;
mod turntable;
mod unseen;
#[cfg(feature = "window")]
mod view;
mod view_args;
mod words;

use std::ffi::OsString;
use std::io::{self, Write};
use std::path::Path;
use std::process::ExitCode;

use clap::{Parser, Subcommand};

use crate::error::Error;
use crate::guard;

/// 3D pictures without a GPU: exact, and the same bytes on every machine.
///
#[cfg_attr(
    feature = "window",
    doc = "`polosa MODEL...` is `polosa view MODEL...`. Without arguments: a built-in scene, in a window, or where none can be opened in the file polosa.png in the current folder."
)]
#[cfg_attr(
    not(feature = "window"),
    doc = "Without arguments: draws a built-in scene to polosa.png in the current folder. This build has no windows."
)]
#[derive(Debug, Parser)]
#[command(name = "polosa", version, after_help = format!("Examples:{WINDOWS}{EXAMPLES}"), override_usage = USAGE)]
struct Cli {
    #[command(subcommand)]
    command: Option<Command>,
}

#[cfg(feature = "window")]
const USAGE: &str = "polosa [MODEL]... [OPTIONS OF view]\n       polosa COMMAND [OPTIONS]";
#[cfg(not(feature = "window"))]
const USAGE: &str = "polosa [COMMAND [OPTIONS]]";

#[cfg(feature = "window")]
const WINDOWS: &str = "
  polosa                                    a built-in scene in a window
  polosa bunny.obj                          a model in a window; H shows the keys";
#[cfg(not(feature = "window"))]
const WINDOWS: &str = "
  polosa                                    a built-in scene, to ./polosa.png";

const EXAMPLES: &str = "
  polosa render bunny.obj -o bunny.png      a model's picture
  polosa render shape:teapot -o teapot.png  a standard shape
  polosa turntable bunny.obj -o bunny.gif   a model that turns round once
  polosa info bunny.obj                     counts, bounds, materials, holes
  polosa bench bunny.obj                    how fast this machine draws it
  polosa compare old.png new.png            what differs, and by how much
  polosa render --help                      all options, all shapes";

#[derive(Debug, Subcommand)]
enum Command {
    #[cfg(feature = "window")]
    View(Box<view::WindowArgs>),
    Render(Box<render_args::RenderArgs>),
    Turntable(Box<turntable::TurntableArgs>),
    Info(info::InfoArgs),
    Bench(Box<bench::BenchArgs>),
    Compare(compare::CompareArgs),
}

/// Does what the arguments, the program's name first, ask for; the program's exit status.
pub fn run(args: impl IntoIterator<Item = OsString>) -> ExitCode {
    let cli = match Cli::try_parse_from(with_command(args.into_iter().collect())) {
        Ok(cli) => cli,
        Err(error) => {
            // Nobody may be listening any more; there is no one else to tell.
            let _ = error.print();
            return ExitCode::from(u8::try_from(error.exit_code()).unwrap_or(2));
        }
    };
    guard::silence_panics();
    let done = match cli.command {
        #[cfg(feature = "window")]
        Some(Command::View(args)) => guard::caught(Path::new("the window"), || view::run(&args)),
        Some(Command::Render(args)) => render::run(&args),
        Some(Command::Turntable(args)) => turntable::run(&args),
        Some(Command::Info(args)) => info::run(&args),
        Some(Command::Bench(args)) => bench::run(&args),
        Some(Command::Compare(args)) => compare::run(&args),
        #[cfg(feature = "window")]
        None => guard::caught(Path::new(crate::demo::FILE), view::demo),
        #[cfg(not(feature = "window"))]
        None => guard::caught(Path::new(crate::demo::FILE), demo),
    };
    match done {
        Ok(status) => status,
        Err(error) => {
            complain(&error);
            ExitCode::from(error.exit_status())
        }
    }
}

/// Arguments that begin with a model are those of `view`. A word that is neither a file nor looks like one is left to
/// clap, which knows what command it may have been meant for.
fn with_command(mut args: Vec<OsString>) -> Vec<OsString> {
    let told = ["-h", "--help", "-V", "--version"];
    let is_model = args.get(1).and_then(|first| first.to_str()).map_or(args.len() > 1, |first| {
        let is_command = <Cli as clap::CommandFactory>::command().find_subcommand(first).is_some();
        let looks_like_one =
            first == "-" || first.contains(['.', ':', '/', '\\']) || Path::new(first).exists();
        !is_command && first != "help" && !told.contains(&first) && (first.starts_with('-') || looks_like_one)
    });
    if is_model && cfg!(feature = "window") {
        args.insert(1, "view".into());
    }
    args
}

/// The command of no arguments.
#[cfg(not(feature = "window"))]
fn demo() -> Result<ExitCode, Error> {
    let path = crate::demo::write(Path::new(crate::demo::FILE))?;
    tell(&format!("{}\n", path.display()), false);
    Ok(ExitCode::SUCCESS)
}

/// Prints an error's line.
fn complain(error: &Error) {
    tell(&format!("polosa: {error}\n"), true);
}

/// Prints what may go unread: that nobody takes it is no failure.
fn tell(text: &str, to_stderr: bool) {
    let _ = print(text, to_stderr);
}

/// Prints a report. That its reader has gone away is no failure, that there is no room for it is one.
fn print(text: &str, to_stderr: bool) -> io::Result<()> {
    let printed = if to_stderr {
        io::stderr().write_all(text.as_bytes())
    } else {
        let mut out = io::stdout().lock();
        out.write_all(text.as_bytes()).and_then(|()| out.flush())
    };
    match printed {
        Err(error) if error.kind() == io::ErrorKind::BrokenPipe => Ok(()),
        printed => printed,
    }
}
