//! Colours by longitude: a hue for each direction (S2).
//!
//! ```text
//!             +y  270°               S2 goes round by the cosine of the angle instead of the angle:
//!              │                     C = x / √(x² + y²), and if y < 0, C ← −(C + 2);  hue = 90·(C + 3)
//!   180°  ─────┼─────  +x  0° = 360°
//!              │                     right on the four axes, up to 18.9° off between them
//!              90°
//! ```

use crate::Color;

/// S2's hue of a direction, in degrees from 0 to 360, from its x and y: even in the cosine of the longitude.
///
/// NaN where x and y are both zero, or one is not finite. The seed cuts it off to whole degrees: [`whole`].
#[must_use]
pub fn pseudo_longitude([x, y, _]: [f64; 3]) -> f64 {
    let cosine = x / (x * x + y * y).sqrt();
    90.0 * (if y < 0.0 { -(cosine + 2.0) } else { cosine } + 3.0)
}

/// The hue that [`pseudo_longitude`] stands for: the longitude itself, in degrees from 0 to 360, clockwise from +x in
/// a picture with y up. `None` where it is not defined: x and y both zero, or not finite.
#[must_use]
pub fn longitude([x, y, _]: [f64; 3]) -> Option<f64> {
    if !(x.is_finite() && y.is_finite()) || (x == 0.0 && y == 0.0) {
        return None;
    }
    let degrees = libm::atan2(y, x).to_degrees();
    // From +x, where the two ends meet, y = 0 belongs to the upper half, as in the seed.
    Some(if y < 0.0 { -degrees } else { 360.0 - degrees })
}

/// A hue cut off to whole degrees, as the seed's `(int)` does; NaN gives 0 (in C++ it may be anything).
#[must_use]
pub fn whole(hue: f64) -> f64 {
    f64::from(hue as i32)
}

/// HSV to RGB, the codes taken as they come, no curve (S2). `hue` in degrees, any; saturation and value from 0 to 1,
/// what is outside goes to the nearer end; NaN counts as 0.
///
/// The seed does not say how a code is rounded; here to the nearest.
#[must_use]
pub fn from_hsv(hue: f64, saturation: f64, value: f64) -> Color {
    let unit = |x: f64| if x > 0.0 { x.min(1.0) } else { 0.0 };
    let (saturation, value) = (unit(saturation), unit(value));
    let sixths = if hue.is_finite() { hue.rem_euclid(360.0) / 60.0 } else { 0.0 };
    // A channel rises over one sixth, stays for two, falls over one, and is out for two.
    let channel = |ahead: f64| {
        let at = (sixths + ahead) % 6.0;
        let share = unit(at.min(4.0 - at));
        (value * (1.0 - saturation * share) * 255.0 + 0.5) as u8
    };
    Color::new(channel(5.0), channel(3.0), channel(1.0))
}
