//! The mouse moves the camera and the light.
//!
//! | what is done | what happens |
//! |---|---|
//! | left drag | the camera goes round the pivot, as if the scene were turned by hand: half a degree a unit of the desktop |
//! | middle drag, Shift and left drag | the point under the pointer goes with it; the pivot keeps its place in the picture |
//! | wheel | the camera goes towards the point under the pointer, or away: a fifth a notch |
//! | right drag | the light goes round the scene, as seen |
//! | double click | the point under the pointer becomes the pivot; nothing moves |
//!
//! ```text
//!   press ─▶ drag: orbit, pan or light ─▶ motion ─▶ ... ─▶ release of that very button, or the focus goes
//! ```
//!
//! What a drag does is settled when it begins: buttons and keys that are pressed meanwhile change nothing. After every
//! move near and far plane fit the scene again; nobody else touches them.

#[cfg(test)]
mod tests;

use polosa_math::glam::DVec3;
use polosa_math::{Bounds, unit};
use polosa_scene::{Camera, Hit, Light, Revision, World};

pub use super::orbit::POLE;
use super::{orbit, zoom};
use crate::event::{Button, Event, Handled};
use crate::input::Input;

/// How far a drag of a unit of the desktop turns: half a degree.
const RADIANS_PER_UNIT: f64 = core::f64::consts::PI / 360.0;

/// No pointer is farther away from the picture than so many pixels; numbers beyond are no places.
const PIXELS: f64 = 1e6;

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
    /// How many pixels a unit of the desktop has.
    pub scale: f64,
    /// Whether the camera may turn beyond the poles.
    pub trackball: bool,
}

impl Stage<'_> {
    /// What is seen at a place of the picture.
    #[must_use]
    pub fn seen(&self, at: [f64; 2]) -> Option<Hit> {
        zoom::seen(self.world, self.camera, self.size, at)
    }

    /// From the path of a pointer, in pixels, to angles about the axes that it seems to turn about: to the right, and
    /// upward.
    pub(super) fn angles(&self, from: [f64; 2], to: [f64; 2]) -> [f64; 2] {
        let scale = if self.scale > 0.0 && self.scale.is_finite() { self.scale } else { 1.0 };
        [to[0] - from[0], from[1] - to[1]].map(|path| path / scale * RADIANS_PER_UNIT)
    }
}

/// A place where a pointer can be.
pub(super) fn is_place(at: [f64; 2]) -> bool {
    at.iter().all(|x| x.abs() <= PIXELS)
}

/// What is being done with the mouse, and the point that the camera turns about.
#[derive(Clone, Debug)]
pub struct Navigation {
    pivot: DVec3,
    up: DVec3,
    drag: Option<Drag>,
    /// What the wheel was turned over, for the next notch: the point is still there, and need not be looked for.
    aimed: Option<Aim>,
    bounds: Option<(Revision, Bounds)>,
}

impl Default for Navigation {
    fn default() -> Self {
        Self { pivot: DVec3::ZERO, up: DVec3::Y, drag: None, aimed: None, bounds: None }
    }
}

#[derive(Clone, Copy, Debug)]
struct Drag {
    button: Button,
    last: [f64; 2],
    kind: Kind,
}

#[derive(Clone, Copy, Debug)]
enum Kind {
    Orbit,
    /// The point that stays under the pointer.
    Pan(DVec3),
    Light,
}

/// A point that is seen at a place of a picture.
#[derive(Clone, Copy, Debug)]
struct Aim {
    point: DVec3,
    at: [f64; 2],
    size: [u32; 2],
    camera: Camera,
    world: Revision,
}

/// Pivot and axis.
impl Navigation {
    /// What the camera turns about.
    #[must_use]
    pub const fn pivot(&self) -> DVec3 {
        self.pivot
    }

    /// Has it turn about another point. One that is not finite changes nothing.
    pub fn set_pivot(&mut self, pivot: DVec3) {
        if pivot.is_finite() {
            self.pivot = pivot;
        }
    }

    /// The axis of the world that is upward; unit length. A camera that has something else upward, be it that it was
    /// set so or turned as a trackball, orbits about that.
    #[must_use]
    pub const fn up(&self) -> DVec3 {
        self.up
    }

    /// Has another axis upward, of any length: +Z for most printers' and CAD models. Zero or not finite changes
    /// nothing. The camera is not touched; the next [`turn_to`](Self::turn_to) obeys.
    pub fn set_up(&mut self, up: DVec3) {
        self.up = unit(up).unwrap_or(self.up);
    }

    /// From a vector that is given for +Y upward to the same for this axis.
    #[must_use]
    pub fn upright(&self, v: DVec3) -> DVec3 {
        orbit::upright(self.up, v)
    }

    /// Heading in [0, 2π) and pitch in [−π/2, π/2] of where a camera looks, in radians. With +Y upward heading 0 is
    /// along −Z, a quarter turn along −X; a positive pitch looks upward.
    #[must_use]
    pub fn heading_pitch(&self, camera: &Camera) -> [f64; 2] {
        orbit::heading_pitch(camera, self.up)
    }
}

/// Moves, by the mouse or without it. All keep near and far plane fitting, and do nothing where a number would leave its
/// range.
impl Navigation {
    /// Turns the camera about the pivot: by `heading` to the left, by `pitch` upward, in radians. What is before it
    /// goes the other way. Unless the camera is a trackball, it goes no farther than the poles ([`POLE`]).
    pub fn orbit_by(&mut self, stage: &mut Stage<'_>, heading: f64, pitch: f64) {
        let by = [heading, pitch];
        if !by.iter().all(|angle| angle.is_finite()) || by == [0.0; 2] {
            return;
        }
        let done = if stage.trackball {
            orbit::tumble(stage.camera, self.pivot, by)
        } else {
            let axis = orbit::axis(stage.camera, self.up);
            orbit::orbit(stage.camera, self.pivot, axis, by)
        };
        if done.is_ok() {
            self.settle(stage);
        }
    }

    /// Turns the camera about the pivot until it looks there: see [`heading_pitch`](Self::heading_pitch). It is not
    /// rolled then.
    pub fn turn_to(&mut self, stage: &mut Stage<'_>, heading: f64, pitch: f64) {
        if !heading.is_finite() || !pitch.is_finite() {
            return;
        }
        let along = orbit::direction(self.up, heading, pitch);
        if orbit::turn_whole(stage.camera, self.pivot, along, self.up).is_ok() {
            self.settle(stage);
        }
    }

    /// Goes towards the point at a place of the picture, or for negative notches away from it, by a constant factor a
    /// notch. The point stays at its place; the pivot comes nearer to it, too. Nobody comes so near, nor gets so far
    /// away, that numbers fail.
    pub fn zoom(&mut self, stage: &mut Stage<'_>, at: [f64; 2], notches: f64) {
        if !is_place(at) || !notches.is_finite() || notches == 0.0 {
            return;
        }
        let world = stage.world.revision();
        let aimed = self.aimed.filter(|aim| {
            aim.at == at && aim.size == stage.size && aim.camera == *stage.camera && aim.world == world
        });
        let Some(point) = aimed.map_or_else(|| self.aim(stage, at), |aim| Some(aim.point)) else { return };
        self.zoom_about(stage, point, notches);
        self.aimed = Some(Aim { point, at, size: stage.size, camera: *stage.camera, world });
    }

    /// Goes towards the pivot, or for negative notches away from it.
    pub fn dolly(&mut self, stage: &mut Stage<'_>, notches: f64) {
        if notches.is_finite() {
            self.zoom_about(stage, self.pivot, notches);
        }
    }

    fn zoom_about(&mut self, stage: &mut Stage<'_>, point: DVec3, notches: f64) {
        let bounds = self.bounds(stage.world);
        if let Ok(factor) = zoom::zoom(stage.camera, point, zoom::factor(notches), &bounds) {
            self.set_pivot(point + (self.pivot - point) * factor);
            self.settle(stage);
        }
    }

    /// Moves camera and pivot along the world's axes.
    pub fn move_by(&mut self, stage: &mut Stage<'_>, offset: DVec3) {
        if stage.camera.set_position(stage.camera.position() + offset).is_ok() {
            self.set_pivot(self.pivot + offset);
            self.settle(stage);
        }
    }

    /// Turns the camera where it stands, up to the poles: to the left and upward. The pivot keeps its place in the
    /// picture.
    pub fn look_by(&mut self, stage: &mut Stage<'_>, heading: f64, pitch: f64) {
        let eye = stage.camera.position();
        let before = stage.camera.basis().to_camera(self.pivot - eye);
        let axis = orbit::axis(stage.camera, self.up);
        if heading.is_finite()
            && pitch.is_finite()
            && orbit::orbit(stage.camera, eye, axis, [heading, pitch]).is_ok()
        {
            self.set_pivot(eye + stage.camera.basis().to_world(before));
            self.settle(stage);
        }
    }

    /// The point at a place of the picture: of a surface, or of the plane through the pivot.
    fn aim(&mut self, stage: &Stage<'_>, at: [f64; 2]) -> Option<DVec3> {
        let seen = stage.seen(at).map(|hit| hit.point);
        let bounds = self.bounds(stage.world);
        seen.or_else(|| zoom::on_plane(stage.camera, stage.size, at, self.pivot, &bounds))
    }

    /// Moves camera and pivot so that the pivot goes so many pixels to the right and down in the picture.
    pub fn pan_by(&mut self, stage: &mut Stage<'_>, pixels: [f64; 2]) {
        let [width, height] = stage.size;
        let Some(seen) = stage.camera.project_point(self.pivot, width, height) else { return };
        let to = [seen.x + pixels[0], seen.y + pixels[1]];
        if is_place(to)
            && let Ok(by) = zoom::pan(stage.camera, stage.size, self.pivot, to)
        {
            self.set_pivot(self.pivot + by);
            self.settle(stage);
        }
    }

    /// Moves the light round what is seen: by so many radians to the right, and upward.
    pub fn light_by(stage: &mut Stage<'_>, right: f64, upward: f64) {
        if right.is_finite() && upward.is_finite() {
            orbit::turn_light(stage.light, stage.camera, [right, upward]);
        }
    }

    pub(crate) fn settle(&mut self, stage: &mut Stage<'_>) {
        // A projection that refuses its planes keeps those it has.
        let _ = zoom::fit_depth(stage.camera, &self.bounds(stage.world));
    }

    /// Those of the world, found out anew when it has changed.
    pub(super) fn bounds(&mut self, world: &World) -> Bounds {
        match self.bounds {
            Some((revision, bounds)) if revision == world.revision() => bounds,
            _ => {
                let bounds = world.bounds();
                self.bounds = Some((world.revision(), bounds));
                bounds
            }
        }
    }
}

/// Events.
impl Navigation {
    /// Follows an event, after the input has taken it in. [`Handled::Yes`] if it was for the camera or the light.
    pub fn event(&mut self, event: &Event, input: &Input, stage: &mut Stage<'_>) -> Handled {
        match *event {
            Event::Button { button, pressed: true, at } => self.press(button, at, input, stage),
            Event::Button { button, pressed: false, at } => {
                let Some(drag) = self.drag.filter(|drag| drag.button == button) else { return Handled::No };
                self.follow(drag, at, stage);
                self.drag = None;
                Handled::Yes
            }
            Event::Motion { at } => {
                // The release may have been for somebody else.
                self.drag = self.drag.filter(|drag| input.is_button_held(drag.button));
                let Some(drag) = self.drag else { return Handled::No };
                self.follow(drag, at, stage);
                Handled::Yes
            }
            Event::Wheel { notches, at } => {
                self.zoom(stage, at, notches);
                Handled::Yes
            }
            Event::DoubleClick { at } => {
                if let Some(hit) = stage.seen(at) {
                    self.set_pivot(hit.point);
                }
                Handled::Yes
            }
            Event::Focus(false) => {
                self.let_go();
                Handled::No
            }
            _ => Handled::No,
        }
    }

    /// Ends what is being done with the mouse.
    pub fn let_go(&mut self) {
        self.drag = None;
    }

    fn press(&mut self, button: Button, at: [f64; 2], input: &Input, stage: &Stage<'_>) -> Handled {
        let busy = self.drag.is_some_and(|drag| drag.button != button && input.is_button_held(drag.button));
        if busy {
            return Handled::Yes;
        }
        self.drag = None;
        if !is_place(at) {
            return Handled::No;
        }
        let kind = match button {
            Button::Left if !input.modifiers().shift => Kind::Orbit,
            Button::Left | Button::Middle => {
                let Some(point) = self.aim(stage, at) else { return Handled::No };
                Kind::Pan(point)
            }
            Button::Right => Kind::Light,
        };
        self.drag = Some(Drag { button, last: at, kind });
        Handled::Yes
    }

    fn follow(&mut self, drag: Drag, at: [f64; 2], stage: &mut Stage<'_>) {
        if !is_place(at) || at == drag.last {
            return;
        }
        let [right, upward] = stage.angles(drag.last, at);
        match drag.kind {
            Kind::Orbit => self.orbit_by(stage, -right, upward),
            Kind::Light => orbit::turn_light(stage.light, stage.camera, [right, upward]),
            Kind::Pan(point) => {
                if let Ok(by) = zoom::pan(stage.camera, stage.size, point, at) {
                    self.set_pivot(self.pivot + by);
                    self.settle(stage);
                }
            }
        }
        self.drag = Some(Drag { last: at, ..drag });
    }
}
