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
mod unseen;
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
/// Without a command: draws a built-in scene to polosa.png in the current folder.
#[derive(Debug, Parser)]
#[command(name = "polosa", version, after_help = EXAMPLES)]
struct Cli {
    #[command(subcommand)]
    command: Option<Command>,
}

const EXAMPLES: &str = "\
Examples:
  polosa                                    a built-in scene, to ./polosa.png
  polosa render bunny.obj -o bunny.png      a model's picture
  polosa render shape:teapot -o teapot.png  a standard shape
  polosa info bunny.obj                     counts, bounds, materials, holes
  polosa bench bunny.obj                    how fast this machine draws it
  polosa compare old.png new.png            what differs, and by how much
  polosa render --help                      all options, all shapes";

#[derive(Debug, Subcommand)]
enum Command {
    Render(Box<render_args::RenderArgs>),
    Info(info::InfoArgs),
    Bench(Box<bench::BenchArgs>),
    Compare(compare::CompareArgs),
}

/// Does what the arguments, the program's name first, ask for; the program's exit status.
pub fn run(args: impl IntoIterator<Item = OsString>) -> ExitCode {
    let cli = match Cli::try_parse_from(args) {
        Ok(cli) => cli,
        Err(error) => {
            // Nobody may be listening any more; there is no one else to tell.
            let _ = error.print();
            return ExitCode::from(u8::try_from(error.exit_code()).unwrap_or(2));
        }
    };
    guard::silence_panics();
    let done = match cli.command {
        Some(Command::Render(args)) => render::run(&args),
        Some(Command::Info(args)) => info::run(&args),
        Some(Command::Bench(args)) => bench::run(&args),
        Some(Command::Compare(args)) => compare::run(&args),
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

/// The command of no arguments.
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
