//! Where the camera looks: its three axes, and the view matrix made of them.
//!
//! ```text
//!            V  up
//!            │
//!            │
//!            o────── U  right          U, V, N: unit length, at right angles, right-handed (U × V = N)
//!           ╱ eye
//!          ╱
//!         N  backward                  the camera looks along −N
//! ```
//!
//! A position, a direction and a rough idea of "up" are what people have; they are hardly ever at right angles.
//! [`Basis::looking`] keeps the direction, bends `up` until it fits, and **always** answers with three unit axes:
//! a naive `direction × up` shrinks the picture when the two are not perpendicular; when they are parallel it is zero,
//! on which the whole picture falls, or, normalised, not a number ([`reference::camera::s1`](crate::reference::camera::s1)).

use glam::{DMat4, DVec3, DVec4};

/// Below this sine of the angle between direction and up the two count as parallel: what is left of their cross
/// product is then mostly rounding (10⁻¹⁶), and the picture would roll at random from one frame to the next.
const PARALLEL: f64 = 1e-10;

/// The vector of length 1 in the direction of `v`, or `None` if `v` is zero or not finite.
///
/// Works for every finite length: 10³⁰⁰ does not overflow on the way, nor does 10⁻³⁰⁰ vanish.
#[must_use]
pub fn unit(v: DVec3) -> Option<DVec3> {
    if !v.is_finite() {
        return None;
    }
    let largest = v.abs().max_element();
    if largest == 0.0 {
        return None;
    }
    let scaled = v / largest;
    Some(scaled / scaled.length())
}

/// The camera's axes in the world: unit length, at right angles to each other, right-handed.
///
/// # Guarantees
///
/// Made by [`Basis::looking`] only, which answers for every input; so no axis is ever zero or not a number.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Basis {
    right: DVec3,
    up: DVec3,
    back: DVec3,
}

impl Basis {
    /// The axes of a camera that looks along `direction` with `up` upward in its picture. Lengths do not matter.
    ///
    /// What happens when that is not enough to go by:
    ///
    /// - `direction` zero or not finite: the camera looks along −Z.
    /// - `up` zero, not finite, or parallel to the direction: the world's +Y is taken for it, and if that is
    ///   parallel too, −Z (looking down on a map, north is up).
    #[must_use]
    pub fn looking(direction: DVec3, up: DVec3) -> Self {
        let forward = unit(direction).unwrap_or(DVec3::NEG_Z);
        let right = [up, DVec3::Y, DVec3::NEG_Z].into_iter().find_map(|up| right_of(forward, up));
        // +Y and −Z are not both parallel to one direction, so there is always a right; +X only completes the type.
        let right = right.unwrap_or(DVec3::X);
        Self { right, up: right.cross(forward), back: -forward }
    }

    /// U: to the right in the picture.
    #[must_use]
    pub const fn right(&self) -> DVec3 {
        self.right
    }

    /// V: upward in the picture.
    #[must_use]
    pub const fn up(&self) -> DVec3 {
        self.up
    }

    /// N: out of the picture, towards the observer.
    #[must_use]
    pub const fn back(&self) -> DVec3 {
        self.back
    }

    /// Where the camera looks: −N.
    #[must_use]
    pub fn forward(&self) -> DVec3 {
        -self.back
    }

    /// The part of the view matrix that turns and does not move: from axes parallel to the world's, with the
    /// origin in the eye, to the camera's own. Drawing composes with it (see [`clip_from_model`]).
    ///
    /// [`clip_from_model`]: crate::clip_from_model
    #[must_use]
    pub fn rotation(&self) -> DMat4 {
        let (u, v, n) = (self.right, self.up, self.back);
        DMat4::from_cols(
            DVec4::new(u.x, v.x, n.x, 0.0),
            DVec4::new(u.y, v.y, n.y, 0.0),
            DVec4::new(u.z, v.z, n.z, 0.0),
            DVec4::W,
        )
    }

    /// The view matrix: from the world to camera space, where the eye is the origin and looks along −Z.
    ///
    /// Far from the origin its last column is large; a picture made with it in `f32` jitters.
    #[must_use]
    pub fn view(&self, eye: DVec3) -> DMat4 {
        let mut view = self.rotation();
        view.w_axis = (-self.to_camera(eye)).extend(1.0);
        view
    }

    /// A vector of the world in the camera's axes: its parts to the right, upward and backward.
    #[must_use]
    pub fn to_camera(&self, v: DVec3) -> DVec3 {
        DVec3::new(self.right.dot(v), self.up.dot(v), self.back.dot(v))
    }

    /// The inverse of [`to_camera`](Self::to_camera): a vector given in the camera's axes, in the world.
    #[must_use]
    pub fn to_world(&self, v: DVec3) -> DVec3 {
        self.right * v.x + self.up * v.y + self.back * v.z
    }
}

/// The unit vector at right angles to `forward` (a unit vector) and `up`, if these span a plane.
fn right_of(forward: DVec3, up: DVec3) -> Option<DVec3> {
    let cross = forward.cross(unit(up)?);
    if cross.length() <= PARALLEL {
        return None;
    }
    // Near the limit the cross product is at right angles to 10⁻⁶ only; taking out once more what is left along
    // `forward` makes it good to the last bits.
    let right = unit(cross)?;
    unit(right - forward * forward.dot(right))
}
