//! What the viewer does when it is told to.

use std::path::PathBuf;
use std::time::Duration;

use polosa_math::glam::DVec3;
use polosa_math::{Basis, axis_angle};
use polosa_raster::Cull;
use polosa_raster::reference::Coverage;
use polosa_scene::reference::Methods;
use polosa_scene::{FieldOfView, LightSpace, Object, Projection, Shading, Show};

use super::keys::{Command, Mode};
use super::{Home, Viewer, grid};
use crate::application::Application;
use crate::encode::{ImageFormat, save_picture};
use crate::error::Error;
use crate::model::{Model, points};
use crate::output::Destination;
use crate::settings::{Look, Navigate};
use crate::view::MARGIN;

/// How far one press of an arrow turns, in radians.
const STEP: f64 = core::f64::consts::PI / 36.0;

/// How far one press of an arrow pans, as a share of the picture's height.
const PAN: f64 = 0.05;

/// How fast the turntable turns, in radians a second: once round in eight seconds.
const TURNTABLE: f64 = core::f64::consts::TAU / 8.0;

/// The colour of the grid.
const GRID: polosa_scene::Color = polosa_scene::Color::new(0x60, 0x66, 0x6e);

/// Screenshots are numbered from 1 to this.
const MOST_SCREENSHOTS: u32 = 9999;

/// Whether a command is done again and again while its key is held.
pub(super) const fn repeats(command: Command) -> bool {
    matches!(
        command,
        Command::Turn(..) | Command::Orbit(..) | Command::Zoom(_) | Command::Pan(..) | Command::MoveLight(..)
    )
}

impl Viewer {
    pub(super) fn obey(&mut self, app: &mut Application, command: Command) {
        match command {
            Command::Front => self.look_from(app, DVec3::Z, DVec3::Y),
            Command::Right => self.look_from(app, DVec3::X, DVec3::Y),
            Command::Top => self.look_from(app, DVec3::Y, DVec3::NEG_Z),
            Command::Isometric => self.look_from(app, DVec3::ONE, DVec3::Y),
            Command::Parallel => self.toggle_parallel(app),
            Command::Reset => self.reset(app),
            Command::Edges => self.next_show(app),
            Command::Grid => {
                self.grid_wanted = !self.grid_wanted;
                self.show_grid(app);
            }
            Command::Axes => self.axes = !self.axes,
            Command::Cull => {
                let (next, name) = match app.style.cull {
                    Cull::None => (Cull::Back, "back faces left out"),
                    Cull::Back => (Cull::Front, "front faces left out"),
                    Cull::Front => (Cull::None, "both sides drawn"),
                };
                app.style.cull = next;
                self.say(app, name);
            }
            Command::Shading => {
                let (next, name) = match app.style.shading {
                    Shading::Flat => (Shading::Unlit, "unlit"),
                    Shading::Unlit => (Shading::Flat, "flat shading"),
                };
                app.style.shading = next;
                self.say(app, name);
            }
            Command::Fill => self.next_fill(app),
            Command::Depth => {
                let (next, name) = match app.settings.look {
                    Look::Shaded => (Look::Depth, "depth: white is near"),
                    Look::Depth => (Look::Shaded, "colours"),
                };
                app.settings.look = next;
                self.say(app, name);
            }
            Command::Light => self.toggle_light(app),
            Command::Turntable => self.turntable = !self.turntable,
            Command::Help => self.help = !self.help,
            Command::Statistics => self.statistics = !self.statistics,
            Command::Sliders => {
                self.sliders = if self.sliders.is_some() { None } else { Some(Self::new_sliders()) };
                self.follow_camera(app);
            }
            Command::Screenshot => self.screenshot(app),
            Command::Reload => self.reload(app),
            Command::Turn(right, up) => self.turn(app, right, up),
            Command::Orbit(right, up) => {
                // A camera that goes up round what it looks at looks down on it.
                let [heading, pitch] = [right, -up].map(|steps| f64::from(steps) * STEP);
                app.orbit_by(heading, pitch);
            }
            Command::Zoom(notches) => app.dolly(f64::from(notches)),
            Command::Pan(right, up) => {
                let step = f64::from(app.size()[1]) * PAN;
                app.pan_by([f64::from(right) * step, f64::from(-up) * step]);
            }
            Command::MoveLight(right, up) => app.light_by(f64::from(right) * STEP, f64::from(up) * STEP),
            Command::Pivot => {
                let middle = app.size().map(|side| f64::from(side) / 2.0);
                match app.pick(middle) {
                    Some(hit) => app.set_pivot(hit.point),
                    None => self.say(app, "there is nothing in the middle of the picture"),
                }
            }
            Command::Fly => match self.mode {
                Mode::Orbit => {
                    (self.mode, self.turntable) = (Mode::Fly, false);
                    self.navigation = core::mem::replace(&mut app.settings.navigation, Navigate::Fly);
                    self.say(app, "fly: W A S D, Q down, E up, drag to look; Tab or Esc leaves");
                }
                Mode::Fly => {
                    self.land(app);
                    self.say(app, "round the model");
                }
            },
            Command::Quit => app.quit(),
        }
    }

    /// Looks at all of the model from a direction, given for +Y upward.
    fn look_from(&mut self, app: &mut Application, to_eye: DVec3, view_up: DVec3) {
        let Some(Home { up, .. }) = self.home else { return };
        let (to_eye, view_up) = (up.turned(to_eye), up.turned(view_up));
        let grid = self.grid.and_then(|key| app.world.get_mut(key));
        // What is framed is the model; the grid may reach beyond the picture.
        if let Some(grid) = grid {
            grid.visible = false;
        }
        let framed = app.camera.frame_points(points(&app.world), to_eye, view_up, MARGIN);
        if let Some(grid) = self.grid.and_then(|key| app.world.get_mut(key)) {
            grid.visible = true;
        }
        let middle = self.bounds(app).center().unwrap_or(DVec3::ZERO);
        match framed {
            Ok(()) => {
                app.set_pivot(middle);
                self.follow_camera(app);
            }
            Err(error) => self.complain(app, error.to_string()),
        }
    }

    /// Between perspective and parallel projection: what is as deep as the pivot keeps its size.
    fn toggle_parallel(&mut self, app: &mut Application) {
        let mut camera = app.camera;
        let depth = (app.pivot() - camera.position()).dot(camera.direction());
        let (projection, back) = match camera.projection() {
            Projection::Perspective { fov, near, .. } => {
                self.fov = fov;
                // What is behind the eye has no size; then it is what is twice as far as the near plane.
                let depth = if depth > near { depth } else { 2.0 * near };
                let height = depth * height_at_1(fov, camera.aspect());
                (Projection::Orthographic { height, near: 0.0, far: 1.0 }, 0.0)
            }
            Projection::Orthographic { height, .. } => {
                let distance = height / height_at_1(self.fov, camera.aspect());
                (Projection::Perspective { fov: self.fov, near: 1.0, far: f64::INFINITY }, distance - depth)
            }
            _ => return,
        };
        let moved = camera.position() - camera.direction() * back;
        match camera.set_projection(projection).and_then(|()| camera.set_position(moved)) {
            Ok(()) => {
                app.camera = camera;
                app.fit_depth();
            }
            Err(error) => self.complain(app, error.to_string()),
        }
    }

    fn reset(&mut self, app: &mut Application) {
        let Some(Home { mut camera, light, pivot, ref placements, .. }) = self.home else { return };
        for &(key, placement) in placements {
            // What is gone stays gone.
            let _ = app.world.set_placement(key, placement);
        }
        let _ = camera.set_aspect(app.camera.aspect());
        (app.camera, app.light) = (camera, light);
        app.set_pivot(pivot);
        self.turntable = false;
        self.land(app);
        self.show_grid(app);
        self.follow_camera(app);
    }

    /// Ends a flight.
    fn land(&mut self, app: &mut Application) {
        if self.mode == Mode::Fly {
            self.mode = Mode::Orbit;
            app.settings.navigation = self.navigation;
        }
    }

    fn next_show(&mut self, app: &mut Application) {
        let (next, name) = match self.show {
            Show::Surface => (Show::Both, "surfaces with edges"),
            Show::Both => (Show::Wire, "edges alone"),
            Show::Wire => (Show::Surface, "surfaces"),
        };
        self.show = next;
        self.show_objects(app);
        self.say(app, name);
    }

    /// Shows all as is said, or, surfaces of the built-in scene, each in its own way.
    pub(super) fn show_objects(&self, app: &mut Application) {
        let (show, grid) = (self.show, self.grid);
        let objects = app.world.objects_mut().filter(|(key, _)| Some(*key) != grid);
        objects.for_each(|(_, object)| object.show = show);
        let own = self.home.iter().flat_map(|home| &home.shows).filter(|_| show == Show::Surface);
        for &(key, show) in own {
            // What is gone stays gone.
            let _ = app.world.show(key, show);
        }
    }

    fn next_fill(&mut self, app: &mut Application) {
        let current = app.settings.methods.map(|methods| methods.coverage);
        let place = current.and_then(|current| Coverage::ALL.iter().position(|other| *other == current));
        // The first of them is exact: that is drawn by the usual path.
        let next = Coverage::ALL.get(place.unwrap_or(0) + 1).copied();
        app.settings.methods = next.map(|coverage| Methods { coverage, ..Methods::default() });
        let text = match next {
            None => "filled exactly".to_owned(),
            Some(coverage) => format!("fill {}: {}", coverage.name(), coverage.about()),
        };
        self.say(app, text);
    }

    /// Changes what the light is fixed to; at this moment it comes from the same side before and after.
    fn toggle_light(&mut self, app: &mut Application) {
        let basis: Basis = app.camera.basis();
        let name = match app.light.space {
            LightSpace::Camera => {
                app.light.direction = basis.to_world(app.light.direction);
                app.light.space = LightSpace::World;
                "the light stays in the world"
            }
            LightSpace::World => {
                app.light.direction = basis.to_camera(app.light.direction);
                app.light.space = LightSpace::Camera;
                "the light goes with the camera"
            }
        };
        self.say(app, name);
    }

    /// Turns the model about its middle: to the right about the upward axis, upward about the picture's right.
    fn turn(&mut self, app: &mut Application, right: i8, up: i8) {
        let Some(home) = &self.home else { return };
        let middle = home.middle;
        let about_up = axis_angle(home.up.axis(), f64::from(right) * STEP);
        let about_right = axis_angle(app.camera.right(), -f64::from(up) * STEP);
        let (Some(about_up), Some(about_right)) = (about_up, about_right) else { return };
        let by = polosa_math::turn(about_up, about_right);
        let keys: Vec<_> =
            app.world.objects().map(|(key, _)| key).filter(|key| Some(*key) != self.grid).collect();
        for key in keys {
            let _ = app.world.turn_about(key, by, middle);
        }
        app.fit_depth();
    }

    /// Makes the grid, or takes it away, as is wanted.
    pub(super) fn show_grid(&mut self, app: &mut Application) {
        if let Some(object) = self.grid.take().and_then(|key| app.world.remove(key)) {
            let _ = app.world.remove_mesh(object.mesh());
        }
        let Some(home) = self.home.as_ref().filter(|_| self.grid_wanted) else { return };
        let bounds = self.bounds(app);
        if bounds.is_empty() {
            return;
        }
        if let Ok(mesh) = grid::grid(&bounds, home.up) {
            let mesh = app.world.add_mesh(mesh);
            self.grid = app.world.add(Object::new(mesh).shown(Show::Wire).colored(GRID)).ok();
            app.fit_depth();
        }
    }

    fn reload(&mut self, app: &mut Application) {
        if self.models.contains(&Model::Stdin) {
            self.complain(app, "standard input cannot be read again: name a file to be able to reload it");
        } else if self.loader.is_running() {
            self.say(app, "it is being read already");
        } else {
            self.load(app);
        }
    }

    fn screenshot(&mut self, app: &mut Application) {
        match save(app) {
            Ok(path) => self.say(app, format!("saved {}", path.display())),
            Err(error) => self.complain(app, error.to_string()),
        }
    }

    /// What goes on by itself.
    pub(super) fn go_on(&self, app: &mut Application, step: Duration) {
        if self.turntable {
            app.orbit_by(TURNTABLE * step.as_secs_f64(), 0.0);
        }
    }
}

/// The height of what a perspective shows at a distance of 1.
fn height_at_1(fov: FieldOfView, aspect: f64) -> f64 {
    match fov {
        FieldOfView::Vertical(angle) => 2.0 * libm::tan(angle / 2.0),
        FieldOfView::Horizontal(angle) => 2.0 * libm::tan(angle / 2.0) / aspect,
    }
}

/// Writes the picture, without what is drawn over it, to the first free name in the current folder.
fn save(app: &mut Application) -> Result<PathBuf, Error> {
    let name = (1..=MOST_SCREENSHOTS).map(|number| format!("polosa-{number:04}.png"));
    let free = name.map(PathBuf::from).find(|path| !path.exists());
    let Some(path) = free else {
        return Err(Error::file("polosa-9999.png", "all names for screenshots are taken: move some away"));
    };
    save_picture(&Destination::File(path.clone()), ImageFormat::Png, || app.picture())?;
    Ok(path)
}
