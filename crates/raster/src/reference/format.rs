//! Formats of depth: what is left of a distance once it is stored.
//!
//! ```text
//!   near                                                    far
//!    ┃││││││││ │ │ │  │  │   │    │      │        │          ┃   D24: steps grow with the distance squared
//!    ┃│││││││││││││││││││││││││││││││ │ │ │ │ │ │ │ │ │ │ │ │┃   reversed f32: with the distance
//!    ┃│    │    │    │    │    │    │    │    │    │    │    ┃   w-buffer: everywhere the same
//! ```
//!
//! n/w puts half of all values between n and 2n. Floats have most of theirs near 0. When 1 is the near plane the two
//! cancel out; when 0 is, they add up, and far away the format is coarser than 24 bits of an integer would be.

use super::names::methods;

methods! {
    /// A format in which depth is stored and compared. In tests and charts only: pictures have `f32` or `u16`.
    DepthFormat, "format of depth" {
        F32Reversed, "f32-reversed", "1 at the near plane, 0 at the far one, f32: about 2⁻²⁴ of the distance, everywhere";
        F32Standard, "f32-standard", "0 at the near plane, 1 at the far one, f32: far away no better than 24 bits";
        F32Signed, "f32-signed", "S1: −1 at the near plane, 1 at the far one, f32: far away no better than 24 bits";
        D24, "d24", "0 at the near plane, 1 at the far one, 24 bits: ties far away";
        D16, "d16", "0 at the near plane, 1 at the far one, 16 bits: ties everywhere but before the eye";
        WBuffer24, "w-buffer-24", "the distance itself, 24 bits: ties close by, and needs a far plane";
    }
}

impl DepthFormat {
    /// What is stored for a point at the distance `w` between the planes, as a key: larger is nearer, equal is a tie.
    ///
    /// `far` may be infinite, but for the w-buffer, where then everything ties. The formulas are evaluated in `f64` and
    /// rounded once to the nearest value, so that what is measured is the format alone.
    ///
    /// ```
    /// use polosa_raster::reference::DepthFormat;
    ///
    /// let ties = |format: DepthFormat| format.store(500.0, 0.1, 1e3) == format.store(500.005, 0.1, 1e3);
    /// assert!(!ties(DepthFormat::F32Reversed));
    /// assert!(ties(DepthFormat::F32Standard) && ties(DepthFormat::D24));
    /// ```
    #[must_use]
    pub fn store(self, w: f64, near: f64, far: f64) -> u32 {
        // n/f is 0 for an infinite f.
        let ratio = near / far;
        let reversed = (near / w - ratio) / (1.0 - ratio);
        match self {
            Self::F32Reversed => nearness(reversed),
            Self::F32Standard => !nearness(1.0 - reversed),
            Self::F32Signed => !nearness(1.0 - 2.0 * reversed),
            Self::D24 => !steps(1.0 - reversed, 24),
            Self::D16 => !steps(1.0 - reversed, 16),
            Self::WBuffer24 => !steps((w - near) / (far - near), 24),
        }
    }
}

/// The bits of an `f32`, made to grow with it.
#[expect(clippy::cast_possible_truncation, reason = "the format's rounding")]
const fn nearness(value: f64) -> u32 {
    // + 0.0: there is one zero.
    let bits = (value as f32 + 0.0).to_bits();
    if bits >> 31 == 0 { bits | 1 << 31 } else { !bits }
}

/// The nearest of 2ᵇⁱᵗˢ values from 0 to 1.
#[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "saturates, in at most 24 bits")]
fn steps(value: f64, bits: u32) -> u32 {
    let most = (1_u32 << bits) - 1;
    (value.clamp(0.0, 1.0) * f64::from(most) + 0.5) as u32
}
