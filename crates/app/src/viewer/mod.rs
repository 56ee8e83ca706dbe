//! The viewer behind `polosa view`: a [`Program`] that shows models, and does what its keys say.
//!
//! ```text
//!   models ─▶ loader, a thread ─▶ world, home camera ─▶ on show, until other models have been read whole
//!      ▲                                                   │
//!   dropped files, Ctrl+R, a watched file was written      └─ keys (keys.rs) ─▶ commands (commands.rs)
//!                                                             overlay.rs: help, statistics, messages, axes, sliders
//! ```

mod commands;
mod grid;
pub mod keys;
mod loader;
mod overlay;
#[cfg(feature = "window")]
mod watch;

use std::path::PathBuf;
use std::time::Duration;

use polosa_math::glam::DVec3;
use polosa_math::{Bounds, Placement};
use polosa_scene::{Camera, FieldOfView, Light, Object, ObjectKey, Show};

use self::keys::Mode;
use self::loader::{Loaded, Loader};
use crate::application::Application;
use crate::canvas::Canvas;
use crate::controls::slider::{Slider, SliderSide};
use crate::error::{Error, one_line};
use crate::event::{Event, Handled};
use crate::model::{Model, points};
use crate::program::Program;
use crate::settings::Navigate;
use crate::view::{Up, View};

/// How long a message stays.
const MESSAGE: Duration = Duration::from_secs(4);

/// How often the progress of a load is shown.
const PROGRESS: Duration = Duration::from_millis(100);

/// How long after a file was written it is read: whoever writes it may not be done.
const SETTLE: Duration = Duration::from_millis(150);

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

    /// Reads the models now, and does not return before.
    ///
    /// # Errors
    ///
    /// When one of them cannot be read.
    pub fn load_now(&mut self, app: &mut Application) -> Result<(), Error> {
        self.loader.start(self.models.clone(), self.show, app.waker());
        match self.loader.wait() {
            Some(Ok(loaded)) => self.install(app, loaded),
            Some(Err(error)) => Err(error),
            None => Err(Error::Window("the reading was broken off by a defect of the program".to_owned())),
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

    fn load(&mut self, app: &Application, keeps_camera: bool) {
        self.keeps_camera = keeps_camera && self.home.is_some();
        self.loader.start(self.models.clone(), self.show, app.waker());
    }

    /// Shows what was read.
    fn install(&mut self, app: &mut Application, loaded: Loaded) -> Result<(), Error> {
        let Loaded { world, up, notes, look } = loaded;
        let up = self.options.up.unwrap_or(up);
        let bounds = world.bounds();
        let [width, height] = app.size();
        let aspect = f64::from(width) / f64::from(height);
        let (camera, light) = match look {
            Some((mut camera, light)) => {
                // A window narrower than a camera can have keeps the picture, stretched.
                let _ = camera.set_aspect(aspect);
                (camera, light)
            }
            None => {
                let view = View { up, ..self.options.view };
                let camera = view.camera(points(&world), &bounds, aspect);
                let name = self.name();
                (camera.map_err(|error| Error::file(name, error.to_string()))?, app.light)
            }
        };
        let middle = bounds.center().unwrap_or(DVec3::ZERO);
        let pivot = self.options.view.focal_point.filter(|_| !self.models.is_empty()).unwrap_or(middle);
        let placements = world.objects().map(|(key, object)| (key, object.placement)).collect();
        let own = |(key, object): (ObjectKey, &Object)| (key, object.show);
        let shows = world.objects().map(own).filter(|_| self.models.is_empty()).collect();
        // The key of the old grid is of the old world.
        (app.world, self.grid) = (world, None);
        if !self.keeps_camera {
            (app.camera, app.light) = (camera, light);
            app.set_up(up.axis());
            app.set_pivot(pivot);
            self.follow_camera(app);
        }
        self.home = Some(Home { camera, light, pivot, up, placements, shows });
        // The way of showing may have been changed while they were read.
        self.show_objects(app);
        self.keeps_camera = false;
        self.show_grid(app);
        app.settings.title = format!("{} – polosa", self.name());
        self.message = None;
        if let Some(note) = notes.first() {
            let more = if notes.len() > 1 {
                format!(" (and {} more notes)", notes.len() - 1)
            } else {
                String::new()
            };
            self.say(app, format!("{note}{more}"));
        }
        app.redraw();
        Ok(())
    }

    /// What is on show, in a few words.
    fn name(&self) -> String {
        let first = self.models.first().map(Model::name);
        let first = first.as_deref().map(|path| path.file_name().map_or(path.as_os_str(), |name| name));
        match (first, self.models.len()) {
            (None, _) => "a built-in scene".to_owned(),
            (Some(name), 1) => one_line(&name.to_string_lossy()),
            (Some(name), count) => format!("{} and {} more", one_line(&name.to_string_lossy()), count - 1),
        }
    }

    fn say(&mut self, app: &mut Application, text: impl Into<String>) {
        self.message = Some(Message { text: text.into(), is_failure: false, stays: Some(MESSAGE) });
        app.redraw();
    }

    fn complain(&mut self, app: &mut Application, text: impl Into<String>) {
        self.message = Some(Message { text: text.into(), is_failure: true, stays: None });
        app.redraw();
    }

    /// Looks at what the loader has.
    fn receive(&mut self, app: &mut Application) {
        let installed = match self.loader.poll() {
            None => return,
            Some(Ok(loaded)) => self.install(app, loaded),
            Some(Err(error)) => Err(error),
        };
        if let Err(error) = installed {
            self.keeps_camera = false;
            if self.home.is_none() && !self.options.watch {
                self.failure = Some(error);
                app.quit();
            } else {
                self.complain(app, error.to_string());
            }
        }
    }

    /// Opens what was dropped.
    fn open_dropped(&mut self, app: &mut Application) {
        if !self.dropped.is_empty() {
            self.models = self.dropped.drain(..).map(Model::File).collect();
            self.load(app, false);
            self.watch_files(app);
        }
    }

    #[cfg(feature = "window")]
    fn watch_files(&mut self, app: &mut Application) {
        self.watch = None;
        let files = |model: &Model| model.file().map(ToOwned::to_owned);
        let mut files = self.models.iter().filter_map(files).peekable();
        if !self.options.watch || files.peek().is_none() {
            return;
        }
        match watch::Watch::new(files.collect(), app.waker()) {
            Ok(watch) => self.watch = Some(watch),
            Err(error) => self.complain(app, error.to_string()),
        }
    }

    #[cfg(not(feature = "window"))]
    const fn watch_files(&mut self, _: &mut Application) {}

    /// Reads files again that were written, once they have been left alone for a while.
    fn follow_files(&mut self, app: &Application, step: Duration) {
        #[cfg(feature = "window")]
        if self.watch.as_ref().is_some_and(watch::Watch::take) {
            self.written = Some(Duration::ZERO);
            return;
        }
        if let Some(since) = &mut self.written {
            *since += step;
            if *since >= SETTLE && !self.loader.is_running() {
                self.written = None;
                self.load(app, true);
            }
        }
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

    /// Puts the sliders where the camera is.
    fn follow_camera(&mut self, app: &mut Application) {
        if self.sliders.as_ref().is_some_and(|sliders| !sliders.iter().any(Slider::is_held)) {
            let [heading, pitch] = app.heading_pitch();
            if let Some([below, right]) = &mut self.sliders {
                below.set_value(heading.to_degrees().rem_euclid(360.0));
                right.set_value(pitch.to_degrees());
            }
        }
    }

    fn new_sliders() -> [Slider; 2] {
        [
            Slider::new(SliderSide::Below, [0.0, 360.0], 0.0),
            Slider::new(SliderSide::Right, [-90.0, 90.0], 0.0),
        ]
    }

    /// Hands an event to the sliders, and the camera their values.
    fn slide(&mut self, app: &mut Application, event: &Event) -> Handled {
        let Some(sliders) = &mut self.sliders else { return Handled::No };
        let (size, scale) = (app.size(), app.scale());
        if sliders.iter_mut().all(|slider| slider.event(event, size, scale) == Handled::No) {
            return Handled::No;
        }
        let [heading, pitch] = [&sliders[0], &sliders[1]].map(|slider| slider.value().to_radians());
        app.turn_to(heading, pitch);
        app.redraw();
        Handled::Yes
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
        if self.home.is_none() {
            self.load(app, false);
        }
        self.watch_files(app);
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
