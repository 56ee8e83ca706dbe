//! Turning the camera as a whole about a point, by heading and pitch.
//!
//! ```text
//!        up                                   heading  round the up axis, counter-clockwise seen from above:
//!         │      direction                             what faces ahead turns to the left
//!         │    ╱                              pitch    over the horizon, nose up
//!         │  ╱  pitch
//!         │╱──────────▶ level                 heading 0, pitch 0: along −Z where +Y is up
//!        ╱
//!      ahead at heading 0                     the camera's right is level, unless it is rolled
//! ```
//!
//! The angles are those of [`polosa_math::rotation`]. They say where the camera looks, and the camera keeps its place
//! relative to the pivot in its own axes; so it need not look at the pivot, and nothing jumps when a turn begins.
//!
//! At the poles the direction alone says nothing of the heading. The camera therefore stops a hair's breadth short of
//! them, at [`POLE`]. One that was put there exactly has an upward in its picture all the same
//! ([`Basis::looking`](polosa_math::Basis::looking)), and goes on from that.

use core::f64::consts::{FRAC_PI_2, TAU};

use polosa_math::glam::{DMat3, DVec3};
use polosa_math::{axis_angle, unit};
use polosa_scene::{Camera, CameraError, Light, LightSpace};

/// The greatest pitch, in radians. What is left to the pole shows in no picture, being a 10⁻⁶ of a pixel; ten times
/// less, and [`Basis::looking`](polosa_math::Basis::looking) would no longer tell the heading from it.
pub const POLE: f64 = FRAC_PI_2 - 1e-9;

/// A camera's right is level within this sine. Near the poles, where it is computed from what is left of the direction
/// (10⁻⁹), rounding tilts it by 10⁻⁷; a roll of 10⁻⁶ cannot be seen.
const LEVEL: f64 = 1e-6;

/// A vector that is given for +Y upward, for another unit vector upward: turned the shortest way, and about X where
/// all ways are as long.
pub(crate) fn upright(up: DVec3, v: DVec3) -> DVec3 {
    let share = 1.0 + up.y;
    if share < 1e-12 {
        return DVec3::new(v.x, -v.y, -v.z);
    }
    // Rodrigues' formula with the sine times the axis, c = +Y × up, and the cosine, up.y; exact for the axes.
    let c = DVec3::new(up.z, 0.0, -up.x);
    let once = c.cross(v);
    v + once + c.cross(once) / share
}

/// What a camera that is to go on turning goes round: `up` unless it is rolled against that; then what it has upward
/// itself. Upside down, it is the opposite.
pub(crate) fn axis(camera: &Camera, up: DVec3) -> DVec3 {
    let basis = camera.basis();
    if basis.right().dot(up).abs() > LEVEL {
        camera.view_up()
    } else if basis.up().dot(up) < -LEVEL {
        -up
    } else {
        up
    }
}

/// The level unit vector ahead of a camera, and its pitch. Straight above and below, where the direction is no help,
/// the picture's upward is.
fn ahead_and_pitch(camera: &Camera, axis: DVec3) -> (DVec3, f64) {
    let (right, direction) = (camera.right(), camera.direction());
    let ahead = unit(axis.cross(right)).unwrap_or(direction);
    (ahead, libm::atan2(direction.dot(axis), direction.dot(ahead)))
}

/// Heading in [0, 2π) and pitch in [−π/2, π/2] of where a camera looks, in radians.
pub(crate) fn heading_pitch(camera: &Camera, up: DVec3) -> [f64; 2] {
    // A rolled camera's right is not level: its direction counts alone.
    let mut level = *camera;
    if axis(camera, up) != up {
        let _ = level.set_view_up(up);
    }
    let (ahead, pitch) = ahead_and_pitch(&level, up);
    let heading = libm::atan2(-ahead.dot(upright(up, DVec3::X)), ahead.dot(upright(up, DVec3::NEG_Z)));
    let heading = if heading < 0.0 { heading + TAU } else { heading };
    [if heading < TAU { heading } else { 0.0 }, pitch.clamp(-FRAC_PI_2, FRAC_PI_2)]
}

/// Where a camera of this heading and pitch looks; the pitch is brought to the poles.
pub(crate) fn direction(up: DVec3, heading: f64, pitch: f64) -> DVec3 {
    let (sin, cos) = libm::sincos(heading);
    let ahead = upright(up, DVec3::NEG_Z) * cos - upright(up, DVec3::X) * sin;
    pitched(up, ahead, pitch)
}

fn pitched(axis: DVec3, ahead: DVec3, pitch: f64) -> DVec3 {
    let (sin, cos) = libm::sincos(pitch.clamp(-POLE, POLE));
    ahead * cos + axis * sin
}

/// Turns a camera about `pivot` and the axis, up to the poles.
pub(crate) fn orbit(
    camera: &mut Camera,
    pivot: DVec3,
    axis: DVec3,
    [heading, pitch]: [f64; 2],
) -> Result<(), CameraError> {
    let (ahead, pitched_by) = ahead_and_pitch(camera, axis);
    let (sin, cos) = libm::sincos(heading);
    let ahead = ahead * cos + axis.cross(ahead) * sin;
    turn_whole(camera, pivot, pitched(axis, ahead, pitched_by + pitch), axis)
}

/// Turns a camera about `pivot` and its own axes: there are no poles.
pub(crate) fn tumble(
    camera: &mut Camera,
    pivot: DVec3,
    [heading, pitch]: [f64; 2],
) -> Result<(), CameraError> {
    let (basis, angle) = (camera.basis(), libm::hypot(heading, pitch));
    let Some(turn) = axis_angle(basis.up() * heading + basis.right() * pitch, angle) else { return Ok(()) };
    let turn = DMat3::from_quat(turn);
    turn_whole(camera, pivot, turn * camera.direction(), turn * basis.up())
}

/// Has a camera look along `direction` with `up` upward, and stand where it then has `pivot` as it had it before.
pub(crate) fn turn_whole(
    camera: &mut Camera,
    pivot: DVec3,
    direction: DVec3,
    up: DVec3,
) -> Result<(), CameraError> {
    let arm = camera.basis().to_camera(camera.position() - pivot);
    let mut turned = *camera;
    turned.set_direction(direction)?;
    turned.set_view_up(up)?;
    turned.set_position(pivot + turned.basis().to_world(arm))?;
    *camera = turned;
    Ok(())
}

/// Moves a light around the object: to the right and upward as the camera has it, in radians. One without a direction
/// begins at the observer.
pub(crate) fn turn_light(light: &mut Light, camera: &Camera, [right, upward]: [f64; 2]) {
    let basis = camera.basis();
    let (x, y) = match light.space {
        LightSpace::Camera => (DVec3::X, DVec3::Y),
        LightSpace::World => (basis.right(), basis.up()),
    };
    let Some(turn) = axis_angle(y * right - x * upward, libm::hypot(right, upward)) else { return };
    let from = unit(light.direction).unwrap_or_else(|| x.cross(y));
    // Scaled back to unit length, so that any number of small steps still is a direction.
    light.direction = unit(DMat3::from_quat(turn) * from).unwrap_or(from);
}

#[cfg(test)]
mod tests {
    use core::f64::consts::{FRAC_PI_2, PI};

    use polosa_math::glam::DVec3;
    use polosa_scene::Camera;
    use proptest::prelude::*;

    use super::{POLE, axis, direction, heading_pitch, upright};
    use crate::view::Up;

    #[test]
    fn upright_is_the_turn_of_the_command_line_for_every_axis() {
        for up in [Up::PlusX, Up::MinusX, Up::PlusY, Up::MinusY, Up::PlusZ, Up::MinusZ] {
            for v in [DVec3::new(1.0, 0.7, 1.0), DVec3::NEG_Z, DVec3::X, DVec3::Y] {
                assert_eq!(upright(up.axis(), v), up.turned(v), "{up:?}");
            }
        }
    }

    #[test]
    fn headings_are_the_views_that_have_names() {
        for (heading, pitch, along) in [
            (0.0, 0.0, DVec3::NEG_Z),
            (FRAC_PI_2, 0.0, DVec3::NEG_X),
            (PI, 0.0, DVec3::Z),
            (0.0, -FRAC_PI_2, DVec3::NEG_Y),
            (1.0, FRAC_PI_2, DVec3::Y),
        ] {
            assert!((direction(DVec3::Y, heading, pitch) - along).length() < 2e-9);
        }
    }

    #[test]
    fn at_the_very_pole_the_pictures_upward_tells_the_heading() {
        let mut camera = Camera::new();
        for (looking, up, heading) in [
            (DVec3::NEG_Y, DVec3::NEG_Z, 0.0),
            (DVec3::NEG_Y, DVec3::NEG_X, FRAC_PI_2),
            (DVec3::Y, DVec3::Z, 0.0),
            (DVec3::NEG_Y, DVec3::Y, 0.0),
        ] {
            camera.set_direction(looking).unwrap();
            camera.set_view_up(up).unwrap();
            assert_eq!(axis(&camera, DVec3::Y), DVec3::Y);
            let [h, p] = heading_pitch(&camera, DVec3::Y);
            assert!((h - heading).abs() < 1e-12 && p == looking.y * FRAC_PI_2, "{h} {p}");
        }
    }

    proptest! {
        #[test]
        fn heading_and_pitch_are_found_again(
            up in prop::array::uniform3(-1.0..1.0_f64),
            heading in 0.0..std::f64::consts::TAU,
            pitch in -FRAC_PI_2..FRAC_PI_2,
        ) {
            let Some(up) = polosa_math::unit(DVec3::from_array(up)) else { return Ok(()) };
            let mut camera = Camera::new();
            camera.set_view_up(up).unwrap();
            for pitch in [pitch, POLE, -POLE] {
                camera.set_direction(direction(up, heading, pitch)).unwrap();
                let [h, p] = heading_pitch(&camera, up);
                let apart = libm::remainder(h - heading, std::f64::consts::TAU).abs();
                // An angle of 10⁻⁹ is known to 10⁻¹⁶ or so.
                let fine = if pitch.abs() < 1.57 { 1e-12 } else { 1e-6 };
                prop_assert!(apart < fine && (p - pitch).abs() < 1e-9, "{h} {p}");
                prop_assert!((0.0..std::f64::consts::TAU).contains(&h));
            }
        }
    }
}
