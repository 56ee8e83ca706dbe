//! Moving an application's camera: what the mouse does, and the same from a program.

use std::time::Duration;

use polosa_math::glam::DVec3;
use polosa_scene::Hit;

use super::Application;
use crate::controls::fly::Fly;
use crate::controls::navigation::{Navigation, Stage};
use crate::event::Event;
use crate::input::Input;
use crate::model::points;
use crate::settings::Navigate;
use crate::view::{MARGIN, TO_EYE};

/// # Moving the camera
///
/// All but [`frame_world`](Self::frame_world) keep the camera's place relative to the pivot, as if the mouse moved it.
impl Application {
    /// Has the camera look at all of the world from where it is seen best, and turn about its middle.
    ///
    /// Where that is not possible, in a world too large for numbers, the camera stays.
    pub fn frame_world(&mut self) {
        self.follow_size();
        let (bounds, up) = (self.world.bounds(), self.navigation.up());
        let to_eye = self.navigation.upright(TO_EYE);
        let _ = self.camera.frame_points(points(&self.world), to_eye, up, MARGIN);
        self.navigation.set_pivot(bounds.center().unwrap_or(DVec3::ZERO));
    }

    /// What the camera turns about.
    #[must_use]
    pub const fn pivot(&self) -> DVec3 {
        self.navigation.pivot()
    }

    /// Has the camera turn about another point. One that is not finite changes nothing.
    pub fn set_pivot(&mut self, pivot: DVec3) {
        self.navigation.set_pivot(pivot);
    }

    /// The axis of the world that is upward; +Y at first.
    #[must_use]
    pub const fn up(&self) -> DVec3 {
        self.navigation.up()
    }

    /// Has another axis upward: from the next [`frame_world`](Self::frame_world) or [`turn_to`](Self::turn_to) on. Zero
    /// or not finite changes nothing.
    pub fn set_up(&mut self, up: DVec3) {
        self.navigation.set_up(up);
    }

    /// Heading in [0, 2π) and pitch in [−π/2, π/2] of where the camera looks, in radians. With +Y upward heading 0 is
    /// along −Z, a quarter turn along −X; a positive pitch looks upward.
    #[must_use]
    pub fn heading_pitch(&self) -> [f64; 2] {
        self.navigation.heading_pitch(&self.camera)
    }

    /// Turns the camera about the pivot until it looks there, not rolled.
    pub fn turn_to(&mut self, heading: f64, pitch: f64) {
        self.navigate(|navigation, _, _, stage| navigation.turn_to(stage, heading, pitch));
    }

    /// Turns the camera about the pivot: by `heading` radians to the left, by `pitch` upward. What it sees goes the other
    /// way.
    pub fn orbit_by(&mut self, heading: f64, pitch: f64) {
        self.navigate(|navigation, _, _, stage| navigation.orbit_by(stage, heading, pitch));
    }

    /// Goes towards what is seen at a place of the picture, as so many notches of the wheel do.
    pub fn zoom(&mut self, at: [f64; 2], notches: f64) {
        self.navigate(|navigation, _, _, stage| navigation.zoom(stage, at, notches));
    }

    /// Goes towards the pivot, as so many notches of the wheel do.
    pub fn dolly(&mut self, notches: f64) {
        self.navigate(|navigation, _, _, stage| navigation.dolly(stage, notches));
    }

    /// Moves camera and pivot so that the pivot goes so many pixels to the right and down.
    pub fn pan_by(&mut self, pixels: [f64; 2]) {
        self.navigate(|navigation, _, _, stage| navigation.pan_by(stage, pixels));
    }

    /// Moves the light round what is seen: by so many radians to the right, and upward.
    pub fn light_by(&mut self, right: f64, upward: f64) {
        self.navigate(|_, _, _, stage| Navigation::light_by(stage, right, upward));
    }

    /// Has near and far plane fit the world: for programs that change it, and leave the camera where it is.
    pub fn fit_depth(&mut self) {
        self.navigate(|navigation, _, _, stage| navigation.settle(stage));
    }

    /// The surface that is seen at a place of the picture, in pixels.
    #[must_use]
    pub fn pick(&self, at: [f64; 2]) -> Option<Hit> {
        crate::controls::seen(&self.world, &self.camera, self.size, at)
    }
}

/// What happens by itself.
impl Application {
    fn navigate<R>(&mut self, act: impl FnOnce(&mut Navigation, &mut Fly, &Input, &mut Stage<'_>) -> R) -> R {
        self.follow_size();
        let mut stage = Stage {
            world: &self.world,
            camera: &mut self.camera,
            light: &mut self.light,
            size: self.size,
            scale: self.scale,
            trackball: self.settings.navigation == Navigate::Trackball,
        };
        act(&mut self.navigation, &mut self.fly, &self.input, &mut stage)
    }

    /// Has camera and light follow an event.
    pub(super) fn steer(&mut self, event: &Event) {
        let mode = self.settings.navigation;
        self.navigate(|navigation, fly, input, stage| {
            // A drag that began in another mode does not go on when that comes back.
            if matches!(mode, Navigate::Off | Navigate::Fly) {
                navigation.let_go();
            }
            if mode != Navigate::Fly {
                fly.let_go();
            }
            match mode {
                Navigate::Off => {}
                Navigate::Orbit | Navigate::Trackball => _ = navigation.event(event, input, stage),
                Navigate::Fly => _ = fly.event(event, input, navigation, stage),
            }
        });
    }

    /// Has a camera that flies go on.
    pub(super) fn fly_on(&mut self, step: Duration) {
        if self.settings.navigation == Navigate::Fly {
            self.navigate(|navigation, fly, input, stage| fly.update(navigation, stage, input, step));
        }
    }

    /// Whether the camera moves by itself.
    #[cfg(feature = "window")]
    pub(crate) fn is_flying(&self) -> bool {
        self.settings.navigation == Navigate::Fly && self.fly.is_moving(&self.input)
    }
}

#[cfg(test)]
mod tests {
    use polosa_math::glam::DVec3;
    use polosa_scene::{Object, shape};

    use crate::event::{Button, Event, Handled, Key};
    use crate::settings::{Navigate, Settings};
    use crate::{Application, Program};

    fn with_cube(navigation: Navigate) -> Application {
        let mut app = Application::with(Settings { size: [160, 120], navigation, ..Settings::default() });
        let cube = app.world.add_mesh(shape::cube());
        app.world.add(Object::new(cube)).unwrap();
        app.frame_world();
        app
    }

    fn drag(app: &mut Application, button: Button) {
        app.send(Event::Button { button, pressed: true, at: [80.0, 60.0] });
        app.send(Event::Motion { at: [110.0, 70.0] });
        app.send(Event::Button { button, pressed: false, at: [110.0, 70.0] });
    }

    fn run(app: &mut Application, frames: u64) {
        app.run_headless(frames, &mut (), |_, _| Ok(())).unwrap();
    }

    #[test]
    fn the_mouse_moves_the_camera_unless_that_is_switched_off() {
        for (mode, moves) in [
            (Navigate::Off, false),
            (Navigate::Orbit, true),
            (Navigate::Trackball, true),
            (Navigate::Fly, true),
        ] {
            let mut app = with_cube(mode);
            let before = app.camera;
            drag(&mut app, Button::Left);
            run(&mut app, 1);
            assert_eq!(app.camera != before, moves, "{mode:?}");
        }
    }

    #[test]
    fn what_a_program_handles_the_camera_does_not_hear_of() {
        struct Keeps;
        impl Program for Keeps {
            fn event(&mut self, _: &mut Application, event: &Event) -> Handled {
                if matches!(event, Event::Button { .. }) { Handled::Yes } else { Handled::No }
            }
        }
        let mut app = with_cube(Navigate::Orbit);
        let before = app.camera;
        drag(&mut app, Button::Left);
        app.run_headless(1, &mut Keeps, |_, _| Ok(())).unwrap();
        assert_eq!(app.camera, before);
    }

    #[test]
    #[cfg(feature = "window")]
    fn in_flight_held_keys_move_the_camera_with_time() {
        let mut app = with_cube(Navigate::Fly);
        let before = app.camera.position();
        app.send(Event::Key { key: Key::Char('w'), pressed: true, repeat: false });
        run(&mut app, 61);
        let path = app.camera.position() - before;
        let expected = app.camera.direction() * 0.25 * 12_f64.sqrt();
        assert!((path - expected * 61.0 / 60.0).length() < 1e-4, "{path}");
        assert!(app.is_flying());
        app.settings.navigation = Navigate::Orbit;
        let before = app.camera.position();
        run(&mut app, 3);
        assert_eq!(app.camera.position(), before);
    }

    #[test]
    fn another_axis_upward_is_framed_and_turned_to() {
        let mut app = with_cube(Navigate::Orbit);
        let [heading, pitch] = app.heading_pitch();
        app.set_up(DVec3::Z);
        app.frame_world();
        assert!(app.camera.up().z > 0.8 && app.camera.right().z.abs() < 1e-12);
        let [h, p] = app.heading_pitch();
        assert!((h - heading).abs() < 1e-12 && (p - pitch).abs() < 1e-12);
        app.turn_to(0.0, 0.0);
        assert!((app.camera.direction() - DVec3::Y).length() < 1e-12, "the front of a model with +Z upward");
        assert!(app.pick([80.0, 60.0]).is_some_and(|hit| (hit.point.y + 1.0).abs() < 1e-9));
        assert!(app.pick([0.5, 0.5]).is_none());
        let before = app.camera.position();
        app.dolly(1.0);
        app.zoom([80.0, 60.0], -1.0);
        app.orbit_by(0.1, 0.1);
        assert!((app.camera.position() - before).length() > 0.1);
    }
}
