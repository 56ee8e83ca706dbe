//! A viewer in a window, and its twin without: whatever is done to one is done to the other, and both must show the
//! same pixels.
//!
//! ```text
//!             ┌─ XTEST ─▶ X server ─▶ winit ─▶ `polosa view` ─▶ softbuffer ─▶ X server ─▶ GetImage ─┐
//!   a gesture ┤                                                                                      ├─▶ equal?
//!             └─ Application::send ─▶ Viewer ─▶ run_headless ───────────────────────────────────────┘
//! ```

use std::path::{Path, PathBuf};

use polosa::event::{Button, Event, Key, Modifiers};
use polosa::model::Model;
use polosa::scene::Picture;
use polosa::viewer::{Options, Viewer};
use polosa::{Application, Settings};

use crate::display::Display;
use crate::process::{Process, Said, command};
use crate::screen::{Screen, Shot, keysym};
use crate::wait::until;

/// The window's size in units of the desktop.
pub(crate) const SIZE: [u32; 2] = [320, 240];

/// The program under test.
pub(crate) const POLOSA: &str = env!("CARGO_BIN_EXE_polosa");

/// The twin's frame rate: frames as far apart as steps can be, so that it need not draw many for seconds to pass.
const TWIN_RATE: f64 = 4.0;

/// A viewer without a window.
pub(crate) struct Twin {
    pub(crate) app: Application,
    pub(crate) viewer: Viewer,
}

impl Twin {
    /// One that has read its models.
    pub(crate) fn new(models: &[&str]) -> Self {
        let mut app =
            Application::with(Settings { size: SIZE, frame_rate: TWIN_RATE, ..Settings::default() });
        let mut twin = {
            let models = models.iter().map(|name| Model::parse(name.into()).expect("a model's name"));
            let mut viewer = Viewer::new(models.collect(), Options::default());
            viewer.load_now(&mut app).expect("models that can be read");
            Self { app, viewer }
        };
        // As the windows' screen has it.
        twin.send(Event::Resize { size: SIZE, scale: 1.0 });
        twin
    }

    /// The viewer's next picture.
    pub(crate) fn shot(&mut self) -> Shot {
        self.shot_after(1)
    }

    /// The picture after a time that is as long as so many frames.
    fn shot_after(&mut self, frames: u64) -> Shot {
        let mut shot = None;
        let take = |_, picture: &Picture| {
            shot = Some(Shot { size: [picture.width, picture.height], pixels: picture.pixels.clone() });
            Ok(())
        };
        self.app.run_headless(frames, &mut self.viewer, take).expect("pictures are drawn");
        shot.expect("a viewer that goes on")
    }

    pub(crate) fn send(&mut self, event: Event) {
        self.app.send(event);
    }
}

/// A key, in X's words and in ours.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Tap(pub(crate) u32, pub(crate) Key);

impl Tap {
    pub(crate) const ENTER: Self = Self(keysym::RETURN, Key::Enter);
    pub(crate) const ESCAPE: Self = Self(keysym::ESCAPE, Key::Escape);
    pub(crate) const TAB: Self = Self(keysym::TAB, Key::Tab);
    pub(crate) const LEFT: Self = Self(keysym::LEFT, Key::Left);
    pub(crate) const UP: Self = Self(keysym::UP, Key::Up);
    pub(crate) const PAGE_UP: Self = Self(keysym::PAGE_UP, Key::PageUp);
    pub(crate) const F12: Self = Self(keysym::F12, Key::F(12));

    pub(crate) fn sign(sign: char) -> Self {
        Self(u32::from(sign), Key::Char(sign))
    }
}

/// A modifier key, in X's words and in ours.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Hold(pub(crate) u32, Modifiers);

impl Hold {
    pub(crate) const SHIFT: Self = Self(keysym::SHIFT, Modifiers::SHIFT);
    pub(crate) const CONTROL: Self = Self(keysym::CONTROL, Modifiers::CONTROL);
}

/// A folder, a viewer that runs in it, and its twin. Fields go in this order: the server last.
pub(crate) struct Session {
    pub(crate) screen: Screen,
    pub(crate) process: Process,
    pub(crate) twin: Twin,
    /// What was shown last.
    shown: Option<Shot>,
    pub(crate) folder: tempfile::TempDir,
    pub(crate) display: Display,
}

impl Session {
    /// `polosa view` with these models, once it shows them; `None` where there is no X server.
    pub(crate) fn of(models: &[&str]) -> Option<Self> {
        Self::with(models, &[], &[])
    }

    /// The same with options, of which the twin knows nothing, and with environment variables.
    pub(crate) fn with(models: &[&str], options: &[&str], variables: &[(&str, &str)]) -> Option<Self> {
        Self::in_folder(tempfile::tempdir().expect("a folder"), models, options, variables)
    }

    /// The same in a folder that holds something already.
    pub(crate) fn in_folder(
        folder: tempfile::TempDir,
        models: &[&str],
        options: &[&str],
        variables: &[(&str, &str)],
    ) -> Option<Self> {
        let display = Display::start()?;
        let resolution = SIZE.map(|side| side.to_string()).join(",");
        let mut command = command(POLOSA, Some(display.name()), folder.path());
        command.arg("view").args(models).args(["--resolution", &resolution]).args(options);
        command.envs(variables.iter().copied());
        let process = Process::start(&mut command);
        let mut screen = Screen::connect(display.name());
        screen.find();
        // What is being read yet has no name in the title.
        screen.wait_for_title(" – polosa");
        Some(Self { screen, process, twin: Twin::new(models), shown: None, folder, display })
    }

    pub(crate) fn path(&self, name: &str) -> PathBuf {
        self.folder.path().join(name)
    }

    /// Waits until the window shows what the twin does, which must be something else than was shown at the last call:
    /// every gesture has a visible effect.
    ///
    /// Messages go after some seconds. On a busy machine that may be before this looks, so that without them is fine,
    /// too.
    #[track_caller]
    pub(crate) fn check(&mut self, what: &str) {
        let expected = self.twin.shot();
        assert_ne!(self.shown.as_ref(), Some(&expected), "{what} changes nothing");
        self.shown = Some(expected.clone());
        let begun = std::time::Instant::now();
        let mut seen;
        loop {
            seen = self.screen.shot();
            if seen.as_ref() == Some(&expected) {
                keep(what, &expected);
                return;
            }
            if !self.process.is_running() || begun.elapsed() >= crate::wait::LIMIT {
                break;
            }
            std::thread::sleep(std::time::Duration::from_millis(3));
        }
        if seen == Some(self.twin.shot_after(4 * TWIN_RATE as u64 + 1)) {
            return;
        }
        let [expected, seen] = [("expected", Some(expected)), ("seen", seen)]
            .map(|(kind, shot)| shot.map(|shot| save(&failures(), &format!("{what}, {kind}"), &shot)));
        let running = self.process.is_running();
        panic!(
            "{what}: the window does not show what it should; expected {expected:?}, seen {seen:?}, running: {running}"
        );
    }

    /// Waits for the program's end.
    pub(crate) fn end(self) -> Said {
        // The server goes on until then.
        let Self { process, display: _display, .. } = self;
        process.end()
    }
}

/// # Gestures
impl Session {
    fn event(&mut self, event: Event) {
        self.twin.send(event);
    }

    /// A key is pressed and let go.
    pub(crate) fn tap(&mut self, Tap(keysym, key): Tap) {
        for pressed in [true, false] {
            self.screen.key(keysym, pressed);
            self.event(Event::Key { key, pressed, repeat: false });
        }
    }

    /// A key with a sign on it.
    pub(crate) fn type_sign(&mut self, sign: char) {
        self.tap(Tap::sign(sign));
    }

    /// Does something while a modifier key is held.
    pub(crate) fn holding(&mut self, Hold(keysym, modifiers): Hold, does: impl FnOnce(&mut Self)) {
        self.screen.key(keysym, true);
        self.event(Event::Modifiers(modifiers));
        does(self);
        self.screen.key(keysym, false);
        self.event(Event::Modifiers(Modifiers::NONE));
    }

    pub(crate) fn point(&mut self, at: [i32; 2]) {
        self.screen.point(at);
        self.event(Event::Motion { at: at.map(f64::from) });
    }

    /// Presses a button, goes from place to place, and lets it go.
    pub(crate) fn drag(&mut self, button: Button, path: &[[i32; 2]]) {
        let (&[first, ..], &[.., last]) = (path, path) else { return };
        self.point(first);
        self.press(button, true, first);
        path[1..].iter().for_each(|&at| self.point(at));
        self.press(button, false, last);
    }

    /// Presses a button or lets it go, where the pointer is.
    pub(crate) fn press(&mut self, button: Button, pressed: bool, at: [i32; 2]) {
        let number = match button {
            Button::Left => 1,
            Button::Middle => 2,
            Button::Right => 3,
            other => panic!("a button of another kind, {other:?}"),
        };
        self.screen.button(number, pressed);
        self.event(Event::Button { button, pressed, at: at.map(f64::from) });
    }

    /// Turns the wheel by notches, positive away from the user.
    pub(crate) fn wheel(&mut self, at: [i32; 2], notches: i32) {
        self.point(at);
        let (number, notch) = if notches > 0 { (4, 1.0) } else { (5, -1.0) };
        for _ in 0..notches.abs() {
            self.screen.button(number, true);
            self.screen.button(number, false);
            self.event(Event::Wheel { notches: notch, at: at.map(f64::from) });
        }
    }

    /// Gives the window another size.
    pub(crate) fn resize(&mut self, size: [u32; 2]) {
        self.screen.resize(size);
        self.event(Event::Resize { size, scale: 1.0 });
        until("the new size", || (self.screen.size() == size).then_some(()));
    }
}

/// Where pictures of failed comparisons are kept.
fn failures() -> PathBuf {
    Path::new(env!("CARGO_TARGET_TMPDIR")).join("window")
}

/// Keeps a picture that is as it should be, for somebody who wants to look at them.
fn keep(what: &str, shot: &Shot) {
    if let Some(folder) = std::env::var_os("POLOSA_WINDOW_PICTURES") {
        save(Path::new(&folder), what, shot);
    }
}

/// Writes a picture; its path.
pub(crate) fn save(folder: &Path, what: &str, shot: &Shot) -> PathBuf {
    let name: String = what.chars().map(|c| if c.is_ascii_alphanumeric() { c } else { '-' }).collect();
    let path = folder.join(format!("{name}.png"));
    let bytes = shot.pixels.iter().flat_map(|pixel| pixel.to_be_bytes()[1..].to_vec()).collect();
    let [width, height] = shot.size;
    let image = image::RgbImage::from_raw(width, height, bytes).expect("as many pixels as its size says");
    std::fs::create_dir_all(folder)
        .and_then(|()| image.save(&path).map_err(std::io::Error::other))
        .expect("a picture");
    path
}
