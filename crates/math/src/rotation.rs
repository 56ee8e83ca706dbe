//! Rotations as unit quaternions, from the angles that people think in, and without drift.
//!
//! Every angle is in radians and turns by the right-hand rule: counter-clockwise for an observer whom the axis
//! points at. Sine and cosine come from `libm`, the same bits on every machine.
//!
//! ```text
//!        +Y  heading: turns to the left       An object that faces −Z, as the camera does, is
//!         │  ↺                                 1. rolled about its own +Z   (leans to its left),
//!         │                                    2. pitched about +X          (nose up),
//!         o───── +X  pitch: nose up            3. headed about +Y           (turns left).
//!        ╱       ↺
//!      +Z  roll: leans to its left             As a matrix: heading · pitch · roll.
//!          ↺
//! ```

use core::f64::consts::FRAC_PI_2;

use glam::{DMat3, DQuat, DVec3};

use crate::view::unit;

/// Within this sine of straight up or down, heading and roll turn about the same axis, and only their sum or
/// difference can be told.
const POLE: f64 = 1e-12;

/// The rotation by `angle` radians about `axis`, whose length does not matter.
///
/// `None` if the axis is zero, or anything is not finite.
#[must_use]
pub fn axis_angle(axis: DVec3, angle: f64) -> Option<DQuat> {
    if !angle.is_finite() {
        return None;
    }
    let (sin, cos) = libm::sincos(angle / 2.0);
    let v = unit(axis)? * sin;
    Some(DQuat::from_xyzw(v.x, v.y, v.z, cos))
}

/// The rotation that rolls about +Z, then pitches about +X, then heads about +Y (see the drawing above).
///
/// Angles in radians; one that is not finite counts as 0.
#[must_use]
pub fn heading_pitch_roll(heading: f64, pitch: f64, roll: f64) -> DQuat {
    let half = |angle: f64| libm::sincos(if angle.is_finite() { angle / 2.0 } else { 0.0 });
    let ((sh, ch), (sp, cp), (sr, cr)) = (half(heading), half(pitch), half(roll));
    let heading = DQuat::from_xyzw(0.0, sh, 0.0, ch);
    let pitch = DQuat::from_xyzw(sp, 0.0, 0.0, cp);
    let roll = DQuat::from_xyzw(0.0, 0.0, sr, cr);
    normalized(heading.mul_quat(pitch).mul_quat(roll))
}

/// The inverse of [`heading_pitch_roll`]: `[heading, pitch, roll]` of a rotation, heading and roll in [−π, π],
/// pitch in [−π/2, π/2].
///
/// Straight up and straight down, where heading and roll cannot be told apart, the roll is 0.
#[must_use]
pub fn to_heading_pitch_roll(rotation: DQuat) -> [f64; 3] {
    let DMat3 { x_axis: x, y_axis: y, z_axis: z } = DMat3::from_quat(normalized(rotation));
    let level = libm::sqrt(z.x * z.x + z.z * z.z);
    if level <= POLE {
        let pitch = if z.y < 0.0 { FRAC_PI_2 } else { -FRAC_PI_2 };
        return [libm::atan2(-x.z, x.x), pitch, 0.0];
    }
    let heading = libm::atan2(z.x, z.z);
    // The roll is what is left once the heading is undone. Near the poles the heading is uncertain, but the roll
    // then takes up exactly its error, and the rotation as a whole stays right.
    let (sin, cos) = libm::sincos(heading);
    let roll = libm::atan2(sin * y.z - cos * y.x, cos * x.x - sin * x.z);
    [heading, libm::atan2(-z.y, level), roll]
}

/// `rotation` followed by `by`, both in the world's axes; `turn(by, rotation)` turns about the object's own axes.
///
/// The result is scaled back to unit length each time, so that any number of small steps still is a rotation:
/// a product of a million of them is orthogonal to the last few bits. A quaternion that is zero or not finite
/// counts as no rotation.
#[must_use]
pub fn turn(rotation: DQuat, by: DQuat) -> DQuat {
    normalized(normalized(by).mul_quat(normalized(rotation)))
}

/// `q` at unit length; the identity if it is zero or not finite.
#[must_use]
pub fn normalized(q: DQuat) -> DQuat {
    let largest = [q.x, q.y, q.z, q.w].into_iter().fold(0.0, |m: f64, c| m.max(c.abs()));
    if !q.is_finite() || largest == 0.0 {
        return DQuat::IDENTITY;
    }
    let length = q.length();
    if length.is_normal() && (0.5..2.0).contains(&length) {
        return DQuat::from_xyzw(q.x / length, q.y / length, q.z / length, q.w / length);
    }
    // Far from unit length the squares may overflow or vanish: bring it near first.
    let q = DQuat::from_xyzw(q.x / largest, q.y / largest, q.z / largest, q.w / largest);
    let length = q.length();
    DQuat::from_xyzw(q.x / length, q.y / length, q.z / length, q.w / length)
}
