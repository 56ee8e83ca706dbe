//! How the examples are started: in a window, or with `--headless OUT.png` without one.

use std::path::{Path, PathBuf};
use std::process::ExitCode;

use polosa::encode::{ImageFormat, write_picture};
use polosa::event::{Event, Handled, Key};
use polosa::output::Destination;
use polosa::{Application, Error, Navigate, Program, Settings};
use polosa_scene::{Color, Picture};

use crate::help::{Help, Helped};

const USAGE: &str = "\
without arguments in a window; or:
  --headless OUT.png   without one: the last frame goes to this file
    --frames N         after so many frames (1)
    --keys TEXT        and these keys, a sign each, struck before the first";

/// Runs a program in a window, or as its arguments say. `keys` is shown by H, and by `--help`; it may be empty.
///
/// For the program's own use this is [`Application::run`]. Where no window can be had, the log says why, and the first
/// frame goes to a file as if `--headless` had been asked for.
#[must_use]
pub fn run(mut app: Application, program: impl Program, keys: &'static str) -> ExitCode {
    if !keys.is_empty() {
        app.settings.title.push_str(" - H: keys");
    }
    let mut program = Helped { program, help: Help::new(keys) };
    report(Headless::from_args(keys).and_then(|headless| match headless {
        Some(headless) => headless.run(&mut app, &mut program),
        None => match app.run(&mut program) {
            Err(Error::Window(_)) => Headless::fallback().run(&mut app, &mut program),
            ended => ended,
        },
    }))
}

/// An application as the seeds have it: black, and the mouse is the program's own.
#[must_use]
pub fn application(title: &str, size: [u32; 2]) -> Application {
    Application::with(Settings {
        title: title.to_owned(),
        size,
        background: Color::BLACK,
        navigation: Navigate::Off,
        ..Settings::default()
    })
}

/// The exit status of a result; an error is told in one line.
#[must_use]
#[expect(clippy::print_stderr, reason = "the end of a program")]
pub fn report(result: Result<(), Error>) -> ExitCode {
    let Err(error) = result else { return ExitCode::SUCCESS };
    // That there is no window was logged by the application.
    if !matches!(error, Error::Window(_)) {
        eprintln!("{error}");
    }
    ExitCode::from(error.exit_status())
}

/// A run without a window.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Headless {
    out: PathBuf,
    frames: u64,
    keys: Vec<Key>,
}

impl Headless {
    /// What the program's arguments ask for; `None`: a window. `--help` prints how to ask, and `keys`, and ends the
    /// program.
    ///
    /// # Errors
    ///
    /// When the arguments are wrong.
    #[expect(clippy::print_stdout, reason = "what --help asks for")]
    pub fn from_args(keys: &str) -> Result<Option<Self>, Error> {
        let arguments: Vec<_> = std::env::args_os().skip(1).collect();
        let texts = arguments.iter().map(|argument| argument.to_string_lossy());
        if texts.clone().any(|text| text == "--help") {
            println!("{USAGE}\n\n{keys}");
            std::process::exit(0);
        }
        let mut headless = Self { out: PathBuf::new(), frames: 1, keys: Vec::new() };
        let usage = |text: &str| Error::Usage(format!("{text:?} is not understood here"));
        for pair in arguments.chunks(2) {
            let [option, value] = pair else { return Err(usage(&pair[0].to_string_lossy())) };
            let text = value.to_string_lossy();
            match &*option.to_string_lossy() {
                "--headless" => headless.out = PathBuf::from(value),
                "--frames" => headless.frames = text.parse().map_err(|_| usage(&text))?,
                "--keys" => headless.keys = text.chars().map(key).collect(),
                other => return Err(usage(other)),
            }
        }
        if arguments.is_empty() {
            return Ok(None);
        }
        if headless.out.as_os_str().is_empty() || headless.frames == 0 {
            return Err(Error::Usage("give --headless OUT.png, and at least one frame".to_owned()));
        }
        Ok(Some(headless))
    }

    /// A frame for `target/pictures`, named after the program.
    fn fallback() -> Self {
        let exe = std::env::current_exe().unwrap_or_default();
        let name = exe.file_stem().unwrap_or("example".as_ref());
        let out = Path::new("target/pictures").join(name).with_extension("png");
        // If that fails, writing the file says so.
        let _ = std::fs::create_dir_all("target/pictures");
        Self { out, frames: 1, keys: Vec::new() }
    }

    /// Takes the frames' steps and writes the last picture.
    ///
    /// # Errors
    ///
    /// When a frame cannot be drawn or the file cannot be written.
    #[expect(clippy::print_stdout, reason = "says where the picture is")]
    pub fn run(&self, app: &mut Application, program: &mut impl Program) -> Result<(), Error> {
        for &key in &self.keys {
            app.send(Event::Key { key, pressed: true, repeat: false });
            app.send(Event::Key { key, pressed: false, repeat: false });
        }
        let mut last = None;
        app.run_headless(self.frames, program, |_, picture| {
            last = Some(picture.clone());
            Ok(())
        })?;
        if let Some(picture) = last {
            write(&self.out, &picture)?;
            println!("{}", self.out.display());
        }
        Ok(())
    }
}

/// Writes a picture as PNG: as a whole, or not at all.
///
/// # Errors
///
/// When the file cannot be written.
pub fn write(path: &Path, picture: &Picture) -> Result<(), Error> {
    let mut output = Destination::File(path.to_owned()).create()?;
    output.fill(|out| write_picture(out, ImageFormat::Png, picture))?;
    output.commit()
}

/// The key that a sign stands for.
fn key(sign: char) -> Key {
    match sign {
        ' ' => Key::Space,
        '\t' => Key::Tab,
        sign => Key::Char(sign.to_ascii_lowercase()),
    }
}

/// Whether an event is a key that goes down, and which.
#[must_use]
pub const fn struck(event: &Event) -> Option<Key> {
    match *event {
        Event::Key { key, pressed: true, .. } => Some(key),
        _ => None,
    }
}

/// [`Handled::Yes`], and a new frame.
pub fn redrawn(app: &mut Application) -> Handled {
    app.redraw();
    Handled::Yes
}
