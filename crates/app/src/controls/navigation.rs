//! The mouse moves the camera and the light.

use polosa_math::glam::DVec3;
use polosa_scene::{Camera, Light, World};

use crate::event::{Event, Handled};
use crate::input::Input;

/// What the mouse acts on.
#[derive(Debug)]
pub struct Stage<'a> {
    /// To find what is under the pointer.
    pub world: &'a World,
    /// To be moved.
    pub camera: &'a mut Camera,
    /// To be turned.
    pub light: &'a mut Light,
    /// The picture's width and height in pixels.
    pub size: [u32; 2],
    /// Whether the camera may turn beyond the poles.
    pub trackball: bool,
}

/// What is being done with the mouse, and the point that the camera turns about.
#[derive(Clone, Debug, Default)]
pub struct Navigation {
    pivot: DVec3,
}

impl Navigation {
    /// What the camera turns about.
    #[must_use]
    pub const fn pivot(&self) -> DVec3 {
        self.pivot
    }

    /// Has it turn about another point.
    pub fn set_pivot(&mut self, pivot: DVec3) {
        self.pivot = pivot;
    }

    /// Follows an event.
    pub fn event(&mut self, _event: &Event, _input: &Input, _stage: &mut Stage<'_>) -> Handled {
        Handled::No
    }
}
