//! Moving an application's camera: what the mouse does, and the same from a program.

use std::time::Duration;

use polosa_math::glam::DVec3;
use polosa_scene::Hit;

use super::Application;
use crate::controls::fly::Fly;
use crate::controls::navigation::{Navigation, Stage};
use crate::event::Event;
use crate::input::Input;
use crate::settings::Navigate;

/// From the world's middle to the observer, with +Y upward: from the front right, and from above.
const TO_EYE: DVec3 = DVec3::new(1.0, 0.7, 1.0);

/// The part of the picture that stays free on every side of a framed world.
const MARGIN: f64 = 0.05;

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
        let _ = self.camera.frame(&bounds, self.navigation.upright(TO_EYE), up, MARGIN);
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
