//! Three cameras as their seeds have them, in `f32` or `f64`.
//!
//! | module | seed | depth |
//! |---|---|---|
//! | [`s1`] | S1: location, direction, up; three perspectives and a parallel projection | −1 near … 1 far |
//! | [`s4`] | S4: six matrices from the world to the pixel, as printed and mended | 1 near … −1 far |
//! | [`angles`] | S0, S3: heading and pitch, no perspective | along z, larger is nearer |
//!
//! Each has a method or function that says what of it is wrong in the state that it is in: its [`Fault`]s.

pub mod angles;
pub mod s1;
pub mod s4;

use core::fmt;

/// What is wrong with a camera.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub enum Fault {
    /// Axes that should have length 1 have another, and the picture's width and height shrink or grow by it (S1).
    Lengths {
        /// The length of the axis to the right.
        right: f64,
        /// The length of the axis upward.
        up: f64,
    },
    /// The direction is parallel to up: both axes are zero, and all points fall on the picture's middle (S1).
    Collapsed,
    /// The direction is parallel to up, and the axes were divided by their length of 0 (S1 mended by normalising).
    NotANumber,
    /// A matrix was kept that a setter should have renewed (S1).
    Stale,
    /// The last row of the perspective matrix is 0 0 n 0 and should be 0 0 1 0: right for n = 1 only (S4).
    LastRow {
        /// n, the distance of the near plane: what should be divided by w is divided by n·w.
        near: f64,
    },
    /// Half of an odd size was cut off to a whole number: the picture is half a pixel from the middle (S0).
    HalfPixel,
}

impl fmt::Display for Fault {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Lengths { right, up } => {
                write!(
                    f,
                    "the picture is scaled by {right:.3} across and {up:.3} upward: axes are not of unit length"
                )
            }
            Self::Collapsed => f.write_str("all points fall on one: the direction is parallel to up"),
            Self::NotANumber => f.write_str("no point has a place: the direction is parallel to up"),
            Self::Stale => f.write_str("the view-projection matrix is that of an earlier state"),
            Self::LastRow { near } => {
                write!(
                    f,
                    "x, y and depth are divided by {near} once too often: the last row should be 0 0 1 0"
                )
            }
            Self::HalfPixel => f.write_str("the picture is half a pixel from the middle"),
        }
    }
}
