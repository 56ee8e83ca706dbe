//! From camera space to clip space: perspective and parallel projections, all with reversed z.
//!
//! ```text
//!                    ╱│ far: z/w = 0        camera space: right-handed, the eye at the origin, looking along −Z
//!                  ╱  │                     clip space:   x right, y up, visible where −w ≤ x, y ≤ w
//!                ╱    │                                   and 0 ≤ z ≤ w
//!              ╱│     │
//!       eye  ╱  │     │  ──▶ −Z             depth = z/w:  1 on the near plane, 0 on the far plane
//!          o    │     │                                   or at infinity; larger is nearer
//!            ╲  │     │
//!              ╲│ near: z/w = 1
//!                ╲    │
//! ```
//!
//! Reversed, because `f32` is densest around 0 and perspective crowds the far depths together: the two cancel, and
//! nearly every distance gets the same relative resolution (Lapidous and Jiao 1999; Reed, "Depth precision
//! visualized"). An infinite far plane then costs nothing.
//!
//! Each function returns `None` rather than a matrix that is no projection: for a range that is empty or turned
//! over, an angle outside (0, π), anything not finite (except `far` where said), or sizes so extreme that an entry
//! of the matrix would leave `f64`'s range. Tangents come from `libm`, the same bits on every machine.

use glam::{DMat4, DVec4};

/// The six planes of a view volume, in camera space.
///
/// For a perspective the window `left..right` × `bottom..top` lies on the near plane.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Planes {
    /// x of the window's left edge.
    pub left: f64,
    /// x of its right edge; more than `left`.
    pub right: f64,
    /// y of its lower edge.
    pub bottom: f64,
    /// y of its upper edge; more than `bottom`.
    pub top: f64,
    /// Distance of the near plane in front of the eye.
    pub near: f64,
    /// Distance of the far plane; more than `near`.
    pub far: f64,
}

/// A perspective projection from the angle between the lower and the upper edge of the picture.
///
/// `fov` in radians, in (0, π); `aspect` is width / height; `0 < near < far`, and `far` may be
/// [`f64::INFINITY`].
#[must_use]
pub fn perspective_vertical(fov: f64, aspect: f64, near: f64, far: f64) -> Option<DMat4> {
    let y = cotangent_of_half(fov)?;
    perspective([y / aspect, y], [0.0, 0.0], near, far)
}

/// A perspective projection from the angle between the left and the right edge of the picture.
///
/// The arguments are those of [`perspective_vertical`] otherwise.
#[must_use]
pub fn perspective_horizontal(fov: f64, aspect: f64, near: f64, far: f64) -> Option<DMat4> {
    let x = cotangent_of_half(fov)?;
    perspective([x, x * aspect], [0.0, 0.0], near, far)
}

/// A perspective projection whose window on the near plane need not lie around the axis, as for one eye of two,
/// one tile of a large picture, or a shifted lens. `0 < near < far`, and `far` may be [`f64::INFINITY`].
#[must_use]
pub fn perspective_planes(planes: &Planes) -> Option<DMat4> {
    let ([width, height], [x, y]) = window(planes)?;
    perspective(
        [2.0 * planes.near / width, 2.0 * planes.near / height],
        [x / width, y / height],
        planes.near,
        planes.far,
    )
}

/// A parallel projection that shows `height` units of the world from the lower to the upper edge of the picture,
/// and `height * aspect` units across, the axis in the middle.
///
/// `near < far`, both finite; `near` may be negative (behind the eye). With `height` equal to the picture's height
/// in pixels one unit is one pixel, exactly.
#[must_use]
pub fn orthographic(height: f64, aspect: f64, near: f64, far: f64) -> Option<DMat4> {
    parallel([2.0 / (height * aspect), 2.0 / height], [0.0, 0.0], near, far)
}

/// A parallel projection of the box between six planes. `near < far`, both finite; `near` may be negative.
#[must_use]
pub fn orthographic_planes(planes: &Planes) -> Option<DMat4> {
    let ([width, height], [x, y]) = window(planes)?;
    parallel([2.0 / width, 2.0 / height], [-x / width, -y / height], planes.near, planes.far)
}

/// Size of the window, and twice its centre.
fn window(planes: &Planes) -> Option<([f64; 2], [f64; 2])> {
    let &Planes { left, right, bottom, top, .. } = planes;
    (left < right && bottom < top).then_some(([right - left, top - bottom], [right + left, top + bottom]))
}

fn cotangent_of_half(fov: f64) -> Option<f64> {
    (fov > 0.0 && fov < core::f64::consts::PI).then(|| 1.0 / libm::tan(fov / 2.0))
}

/// `shift` is what z adds to x and y: the off-centre terms.
fn perspective(scale: [f64; 2], shift: [f64; 2], near: f64, far: f64) -> Option<DMat4> {
    if !(0.0 < near && near < far && near < f64::INFINITY) {
        return None;
    }
    // z/w = (a·z + b)/(−z) must be 1 at z = −near and 0 at z = −far. In this form it is exactly 0 there, and no
    // far plane, however far, overflows.
    let (a, b) = if far == f64::INFINITY {
        (0.0, near)
    } else {
        let a = near / (far - near);
        (a, far * a)
    };
    checked(
        scale,
        b,
        DMat4::from_cols(
            DVec4::new(scale[0], 0.0, 0.0, 0.0),
            DVec4::new(0.0, scale[1], 0.0, 0.0),
            DVec4::new(shift[0], shift[1], a, -1.0),
            DVec4::new(0.0, 0.0, b, 0.0),
        ),
    )
}

/// `shift` is what is added to x and y.
fn parallel(scale: [f64; 2], shift: [f64; 2], near: f64, far: f64) -> Option<DMat4> {
    let depth = far - near;
    if !(depth > 0.0 && depth < f64::INFINITY) {
        return None;
    }
    checked(
        scale,
        1.0 / depth,
        DMat4::from_cols(
            DVec4::new(scale[0], 0.0, 0.0, 0.0),
            DVec4::new(0.0, scale[1], 0.0, 0.0),
            DVec4::new(0.0, 0.0, 1.0 / depth, 0.0),
            DVec4::new(shift[0], shift[1], far / depth, 1.0),
        ),
    )
}

/// The last gate for all: nothing infinite, nothing collapsed to zero, no axis turned round.
fn checked(scale: [f64; 2], depth: f64, matrix: DMat4) -> Option<DMat4> {
    (scale[0] > 0.0 && scale[1] > 0.0 && depth > 0.0 && matrix.is_finite()).then_some(matrix)
}
