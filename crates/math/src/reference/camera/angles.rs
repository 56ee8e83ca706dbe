//! Heading and pitch (S0, S3): two angles instead of a camera, and no perspective.
//!
//! ```text
//!   S0                              S3
//!            ┌────────────┐         while the button is down, the pointer's place is the angles:
//!            │            │ │       heading =  (int)(x·180 / width)    whole degrees, and a jump
//!            │            │ o       pitch   = −(int)(y·180 / height)   at the first touch
//!            │            │ │
//!            └────────────┘         x right, y down the screen, z towards the observer
//!            ──────o─────── heading 0…360, pitch −90…90
//! ```
//!
//! Points are rows: p' = p·T with T = heading·pitch, then moved to the picture's middle. The matrix is made of the
//! two angles in each frame, so it never drifts; but its turns are about two given axes only.

use super::Fault;
use crate::reference::algebra::{Real, Rows, apply, product, transposed};

/// Whose matrices.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Seed {
    /// The viewer with sliders: heading [c 0 s; 0 1 0; −s 0 c], the middle at whole pixels.
    S0,
    /// Its rewrite: heading [c 0 −s; 0 1 0; s 0 c], the middle where it is.
    S3,
}

/// T = heading·pitch for row vectors; angles in radians.
#[must_use]
pub fn rotation<T: Real>(seed: Seed, heading: T, pitch: T) -> Rows<T, 3> {
    let ((sh, ch), (sp, cp), zero, one) = (heading.sin_cos(), pitch.sin_cos(), T::of(0.0), T::of(1.0));
    let sh = match seed {
        Seed::S0 => sh,
        Seed::S3 => -sh,
    };
    let heading = [[ch, zero, sh], [zero, one, zero], [-sh, zero, ch]];
    let pitch = [[one, zero, zero], [zero, cp, sp], [zero, -sp, cp]];
    product(&heading, &pitch)
}

/// Where a point comes to lie in a picture of `width` × `height` pixels: x, y down, and z, larger is nearer.
#[must_use]
pub fn pixels<T: Real>(seed: Seed, rotation: &Rows<T, 3>, point: [T; 3], width: u32, height: u32) -> [T; 3] {
    let [x, y, z] = apply(&transposed(rotation), point);
    let half = |size: u32| match seed {
        Seed::S0 => T::of((size / 2).into()),
        Seed::S3 => T::of(size.into()) / T::of(2.0),
    };
    [x + half(width), y + half(height), z]
}

/// S3's heading and pitch, in whole degrees, for the pointer at (`x`, `y`) in a picture of `width` × `height`; a
/// picture without pixels has none, and 0 is given.
#[must_use]
pub fn pointed(x: i32, y: i32, width: u32, height: u32) -> [i64; 2] {
    let degrees = |at: i32, size: u32| (i64::from(at) * 180).checked_div(size.into()).unwrap_or(0);
    [degrees(x, width), -degrees(y, height)]
}

/// What is wrong with it in a picture of `width` × `height` pixels.
pub fn faults(seed: Seed, width: u32, height: u32) -> impl Iterator<Item = Fault> {
    let odd = width % 2 == 1 || height % 2 == 1;
    (seed == Seed::S0 && odd).then_some(Fault::HalfPixel).into_iter()
}
