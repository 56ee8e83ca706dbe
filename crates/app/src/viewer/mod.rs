//! The viewer behind `polosa view`: a [`Program`] that shows models, and does what its keys say.
//!
//! ```text
//!   models ─▶ loader, a thread ─▶ world, home camera ─▶ on show, until other models have been read whole
//!      ▲           files.rs                                │
//!   dropped files, Ctrl+R, a watched file was written      └─ keys (keys.rs) ─▶ commands (commands.rs)
//!                                                             overlay.rs: help, statistics, messages, axes, sliders
//! ```

mod commands;
mod files;
mod grid;
pub mod keys;
mod loader;
mod overlay;
mod slide;
#[cfg(feature = "window")]
mod watch;

use std::path::PathBuf;
use std::time::Duration;

use polosa_math::glam::DVec3;
use polosa_math::{Bounds, Placement};
use polosa_scene::{Camera, FieldOfView, Light, ObjectKey, Show};

use self::keys::Mode;
use self::loader::Loader;
use crate::application::Application;
use crate::canvas::Canvas;
use crate::controls::slider::Slider;
use crate::error::Error;
use crate::event::{Event, Handled};
use crate::model::Model;
use crate::program::Program;
use crate::settings::Navigate;
use crate::view::{Up, View};

/// How long a message stays.
const MESSAGE: Duration = Duration::from_secs(4);

/// How often the progress of a load is shown.
const PROGRESS: Duration = Duration::from_millis(100);

/// What of a viewer is settled from the start.
#[derive(Clone, Debug)]
pub struct Options {
    /// From where the models are seen at first. Its upward axis counts only if [`up`](Self::up) has none.
    pub view: View,
    /// The axis that is upward; `None`: that of the files.
    pub up: Option<Up>,
    /// What is shown of them.
    pub show: Show,
    /// Whether files are read again when they were written.
    pub watch: bool,
    /// Whether there is a grid under the models.
    pub grid: bool,
    /// Whether the world's axes are shown.
    pub axes: bool,
    /// Whether a line about frames and triangles is shown.
    pub statistics: bool,
}

impl Default for Options {
    fn default() -> Self {
        Self {
            view: View::default(),
            up: None,
            show: Show::Surface,
            watch: false,
            grid: false,
            axes: false,
            statistics: false,
        }
    }
}

/// A viewer of models.
///
/// ```
/// use polosa::event::{Event, Key};
/// use polosa::model::Model;
/// use polosa::viewer::{Options, Viewer};
/// use polosa::{Application, scene::Projection};
///
/// let mut app = Application::new();
/// let mut viewer = Viewer::new(vec![Model::parse("shape:torus".into())?], Options::default());
/// viewer.load_now(&mut app)?;
/// app.send(Event::Key { key: Key::Char('5'), pressed: true, repeat: false }); // parallel projection
/// app.run_headless(1, &mut viewer, |_, picture| {
///     assert_eq!(picture.stats.objects, 1);
///     Ok(())
/// })?;
/// assert!(matches!(app.camera.projection(), Projection::Orthographic { .. }));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Debug)]
pub struct Viewer {
    models: Vec<Model>,
    options: Options,
    loader: Loader,
    #[cfg(feature = "window")]
    watch: Option<watch::Watch>,
    /// Since when a written file waits to be read.
    written: Option<Duration>,
    dropped: Vec<PathBuf>,
    /// Whether the load that goes on shall leave the camera where it is.
    keeps_camera: bool,
    /// What is on show; `None`: nothing yet.
    shown: Option<Vec<Model>>,
    /// Whether other models were asked for than those that the viewer was made for.
    has_dropped: bool,
    /// The light that the viewer was given.
    light: Option<Light>,
    home: Option<Home>,
    show: Show,
    grid: Option<ObjectKey>,
    mode: Mode,
    /// What the mouse does when the camera does not fly.
    navigation: Navigate,
    turntable: bool,
    help: bool,
    statistics: bool,
    axes: bool,
    grid_wanted: bool,
    sliders: Option<[Slider; 2]>,
    /// The angle of view to come back to from a parallel projection.
    fov: FieldOfView,
    message: Option<Message>,
    since_progress: Duration,
    failure: Option<Error>,
}

/// What Enter goes back to.
#[derive(Clone, Debug)]
struct Home {
    camera: Camera,
    light: Light,
    pivot: DVec3,
    /// What the arrows turn the models about.
    middle: DVec3,
    up: Up,
    placements: Vec<(ObjectKey, Placement)>,
    /// How the objects of the built-in scene are shown, each in its own way.
    shows: Vec<(ObjectKey, Show)>,
}

/// A line for the user.
#[derive(Clone, Debug)]
struct Message {
    text: String,
    is_failure: bool,
    /// How long it still stays; `None`: until something takes its place.
    stays: Option<Duration>,
}

impl Viewer {
    /// A viewer of these models, all in one world; without any it shows the built-in scene. They are read when it is
    /// run, or by [`load_now`](Self::load_now).
    #[must_use]
    pub fn new(models: Vec<Model>, options: Options) -> Self {
        let (show, statistics) = (options.show, options.statistics);
        let (axes, grid_wanted) = (options.axes, options.grid);
        Self {
            models,
            options,
            loader: Loader::default(),
            #[cfg(feature = "window")]
            watch: None,
            written: None,
            dropped: Vec::new(),
            keeps_camera: false,
            shown: None,
            has_dropped: false,
            light: None,
            home: None,
            show,
            grid: None,
            mode: Mode::Orbit,
            navigation: Navigate::Orbit,
            turntable: false,
            help: false,
            statistics,
            axes,
            grid_wanted,
            sliders: None,
            fov: FieldOfView::Vertical(30_f64.to_radians()),
            message: None,
            since_progress: Duration::ZERO,
            failure: None,
        }
    }

    /// Whether models are being read.
    #[must_use]
    pub const fn is_loading(&self) -> bool {
        self.loader.is_running()
    }

    /// How the camera moves.
    #[must_use]
    pub const fn mode(&self) -> Mode {
        self.mode
    }

    /// Why the viewer ended by itself: the models that it was made for could not be read.
    pub const fn take_failure(&mut self) -> Option<Error> {
        self.failure.take()
    }

    /// The line that is shown to the user now.
    #[must_use]
    pub fn message(&self) -> Option<&str> {
        self.message.as_ref().map(|message| message.text.as_str())
    }

    fn say(&mut self, app: &mut Application, text: impl Into<String>) {
        self.message = Some(Message { text: text.into(), is_failure: false, stays: Some(MESSAGE) });
        app.redraw();
    }

    fn complain(&mut self, app: &mut Application, text: impl Into<String>) {
        self.message = Some(Message { text: text.into(), is_failure: true, stays: None });
        app.redraw();
    }

    /// Lets messages go, and keeps progress fresh.
    fn pass_time(&mut self, app: &mut Application, step: Duration) {
        if let Some(Message { stays: Some(stays), .. }) = &mut self.message {
            *stays = stays.saturating_sub(step);
            if stays.is_zero() {
                self.message = None;
                app.redraw();
            }
        }
        if self.loader.is_running() {
            self.since_progress += step;
            if self.since_progress >= PROGRESS {
                self.since_progress = Duration::ZERO;
                app.redraw();
            }
        }
    }

    /// All that is shown but the grid.
    fn bounds(&self, app: &Application) -> Bounds {
        let ours = |key: &ObjectKey| Some(*key) != self.grid;
        let objects = app.world.objects().filter(|(key, object)| object.visible && ours(key));
        let boxes = objects.filter_map(|(key, _)| app.world.object_bounds(key));
        boxes.fold(Bounds::EMPTY, |all, one| all.union(&one))
    }
}

impl Program for Viewer {
    fn start(&mut self, app: &mut Application) {
        app.settings.quit_keys = false;
        // First, so that nothing is missed that is written while the files are read.
        self.watch_files(app);
        if self.shown.is_none() {
            self.load(app);
        }
    }

    fn update(&mut self, app: &mut Application, step: Duration) {
        self.receive(app);
        self.open_dropped(app);
        self.follow_files(app, step);
        self.pass_time(app, step);
        self.go_on(app, step);
        self.follow_camera(app);
    }

    fn animated(&self) -> bool {
        self.loader.is_running()
            || self.written.is_some()
            || self.turntable
            || self.message.as_ref().is_some_and(|message| message.stays.is_some())
    }

    fn event(&mut self, app: &mut Application, event: &Event) -> Handled {
        if self.slide(app, event) == Handled::Yes {
            return Handled::Yes;
        }
        match event {
            Event::Drop(path) => self.dropped.push(path.clone()),
            &Event::Key { key, pressed: true, repeat } => {
                if let Some(command) = keys::command(self.mode, key, app.input().modifiers()) {
                    // What switches something does so once, however long its key is held.
                    if !repeat || commands::repeats(command) {
                        self.obey(app, command);
                        app.redraw();
                    }
                    return Handled::Yes;
                }
            }
            _ => {}
        }
        Handled::No
    }

    fn overlay(&mut self, app: &Application, canvas: &mut Canvas<'_>) {
        self.draw_over(app, canvas);
    }
}
