//! Models come and go: read at first, dropped on the window, read again.
//!
//! What is on show stays until what was asked for has been read whole.

use std::time::Duration;

use polosa_math::glam::DVec3;
use polosa_scene::{Object, ObjectKey};

use super::loader::{self, Aim, Loaded};
#[cfg(feature = "window")]
use super::watch;
use super::{Home, Viewer};
use crate::application::Application;
use crate::error::{Error, one_line};
use crate::model::{Model, points};
use crate::view::View;

/// How long after a file was written it is read: whoever writes it may not be done.
const SETTLE: Duration = Duration::from_millis(150);

impl Viewer {
    /// Reads the models now, and does not return before.
    ///
    /// # Errors
    ///
    /// When one of them cannot be read.
    pub fn load_now(&mut self, app: &mut Application) -> Result<(), Error> {
        self.start(app, false);
        match self.loader.wait() {
            Some(Ok(loaded)) => self.install(app, loaded),
            Some(Err(error)) => Err(error),
            None => Err(loader::broken_off()),
        }
    }

    /// Begins to read the models. If they are on show already, the camera stays.
    pub(super) fn load(&mut self, app: &Application) {
        self.keeps_camera = self.shown.as_ref() == Some(&self.models);
        // What is on show already has warmed the memory that it needs.
        self.start(app, !self.keeps_camera);
    }

    fn start(&mut self, app: &Application, warms: bool) {
        let aim = Aim {
            view: self.options.view,
            up: self.options.up,
            size: app.size(),
            threads: app.settings.threads,
            warms,
        };
        self.loader.start(self.models.clone(), self.show, aim, app.waker());
    }

    /// Shows what was read.
    fn install(&mut self, app: &mut Application, loaded: Loaded) -> Result<(), Error> {
        let Loaded { world, up, notes, look, framed, warm } = loaded;
        if let Some(renderer) = warm {
            app.adopt(renderer);
        }
        let up = self.options.up.unwrap_or(up);
        let bounds = world.bounds();
        let aspect = aspect(app);
        let (camera, light) = match look {
            Some((mut camera, light)) => {
                self.light.get_or_insert(app.light);
                // A window narrower than a camera can have keeps the picture, stretched.
                let _ = camera.set_aspect(aspect);
                (camera, light)
            }
            None => {
                let view = View { up, ..self.options.view };
                // The window may have got another size meanwhile.
                let framed = framed.filter(|(_, before)| *before == aspect);
                let camera = framed
                    .map_or_else(|| view.camera(points(&world), &bounds, aspect), |(camera, _)| Ok(camera));
                let name = self.name();
                let light = *self.light.get_or_insert(app.light);
                (camera.map_err(|error| Error::file(name, error.to_string()))?, light)
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
        self.home = Some(Home { camera, light, pivot, middle, up, placements, shows });
        self.shown = Some(self.models.clone());
        // The way of showing may have been changed while they were read.
        self.show_objects(app);
        if self.keeps_camera {
            app.fit_depth();
        }
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

    /// Looks at what the loader has.
    pub(super) fn receive(&mut self, app: &mut Application) {
        let installed = match self.loader.poll() {
            None => return,
            Some(Ok(loaded)) => self.install(app, loaded),
            Some(Err(error)) => Err(error),
        };
        if let Err(error) = installed {
            self.keeps_camera = false;
            if self.shown.is_none() && !self.has_dropped && !self.options.watch {
                self.failure = Some(error);
                app.quit();
            } else {
                self.complain(app, error.to_string());
            }
        }
    }

    /// Opens what was dropped.
    pub(super) fn open_dropped(&mut self, app: &mut Application) {
        if !self.dropped.is_empty() {
            self.models = self.dropped.drain(..).map(Model::File).collect();
            self.has_dropped = true;
            self.watch_files(app);
            self.load(app);
        }
    }

    #[cfg(feature = "window")]
    pub(super) fn watch_files(&mut self, app: &mut Application) {
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
    pub(super) const fn watch_files(&mut self, _: &mut Application) {}

    /// Reads files again that were written, once they have been left alone for a while.
    pub(super) fn follow_files(&mut self, app: &Application, step: Duration) {
        #[cfg(feature = "window")]
        if self.watch.as_ref().is_some_and(watch::Watch::take) {
            self.written = Some(Duration::ZERO);
            return;
        }
        if let Some(since) = &mut self.written {
            *since += step;
            if *since >= SETTLE && !self.loader.is_running() {
                self.written = None;
                self.load(app);
            }
        }
    }
}

/// Width / height of what is drawn into.
fn aspect(app: &Application) -> f64 {
    let [width, height] = app.size();
    f64::from(width) / f64::from(height)
}
