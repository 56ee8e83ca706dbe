//! Six ways to turn a thing by many small steps, and how far each drifts.
//!
//! ```text
//!          Y                    A step turns the thing's own axes X, Y, Z (unit length, in the world), as a drag
//!          │  ╱ Z               of the mouse does:
//!          │ ╱
//!          │╱   dx              1. by dx from X towards Z, about Y
//!          o─────── X           2. by dy from Y towards Z, about the X that has come of it
//! ```
//!
//! The matrix M has X, Y and Z for its columns, so a step is M ← M·S with S = Ry(−dx)·Rx(dy), and a point's
//! coordinates along the axes are p·M. A rotation has M·Mᵀ = 1. How far a method is from that after n steps, and how
//! far its axes point from where n exact steps would have brought them, is its [`Drift`].
//!
//! All ways get the same angles, and round them as their arithmetic does: to see only what accumulates, take angles
//! that an `f32` holds, such as 1/64.

use core::fmt;

use glam::{DMat3, DQuat, DVec3};

use super::algebra::{Real, Rows, cross, identity, length, normalized, product, transposed};
use crate::rotation::{axis_angle, turn};

/// A way to turn by many small steps.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, Default)]
pub enum Turning {
    /// Unit quaternions in `f64`, scaled to unit length at each step: [`turn`], which all of polosa
    /// turns by.
    #[default]
    Quaternion,
    /// The sums of all dx and of all dy; the matrix is made of the two angles when it is asked for (S0, S3). The seeds
    /// read their angles off a slider or the pointer and add nothing up, so the sums here keep what rounding cuts off.
    Angles,
    /// The matrix multiplied by that of the step, in `f32`.
    MatrixF32,
    /// The matrix multiplied by that of the step, in `f64`.
    MatrixF64,
    /// X ← norm(X cos dx + Z sin dx), Y ← norm(Y cos dy + Z sin dy), with Z = X × Y each time, in `f32` (S2).
    AxesF32,
    /// Unit quaternions in `f32`, scaled to unit length at each step.
    QuaternionF32,
}

impl Turning {
    /// All of them, the one in use first.
    pub const ALL: &[Self] = &[
        Self::Quaternion,
        Self::Angles,
        Self::MatrixF32,
        Self::MatrixF64,
        Self::AxesF32,
        Self::QuaternionF32,
    ];

    /// Its name, in small letters.
    #[must_use]
    pub const fn name(self) -> &'static str {
        match self {
            Self::Quaternion => "quaternion",
            Self::Angles => "angles",
            Self::MatrixF32 => "matrix-f32",
            Self::MatrixF64 => "matrix-f64",
            Self::AxesF32 => "axes-f32",
            Self::QuaternionF32 => "quaternion-f32",
        }
    }

    /// In one line: from which seed, and what it gets wrong.
    #[must_use]
    pub const fn about(self) -> &'static str {
        match self {
            Self::Quaternion => "unit quaternions in f64, scaled at each step: the default; stays a rotation",
            Self::Angles => {
                "sums of angles (S0, S3): no drift, but turns only about the first axes, and locks at 90°"
            }
            Self::MatrixF32 => "matrices multiplied in f32: shrinks or grows with each step",
            Self::MatrixF64 => "matrices multiplied in f64: the same, a hundred million times less",
            Self::AxesF32 => {
                "two axes turned and scaled in f32 (S2): stays near a rotation, its angles wander"
            }
            Self::QuaternionF32 => {
                "unit quaternions in f32, scaled at each step: a rotation, its angles wander"
            }
        }
    }

    /// Where `steps` exact steps by (`dx`, `dy`) radians bring the axes: the matrix M, to about 10⁻¹⁶ a step.
    ///
    /// That is Sⁿ, the turn about the axis of S by n times its angle; for [`Angles`](Self::Angles), which add up
    /// something else if both angles change, it is Ry(−n·dx)·Rx(n·dy).
    #[must_use]
    pub fn exact(self, dx: f64, dy: f64, steps: u32) -> Rows<f64, 3> {
        let n = f64::from(steps);
        if self == Self::Angles {
            return step(dx * n, dy * n);
        }
        let s = about_y_then_x(dx, dy);
        let v = DVec3::new(s.x, s.y, s.z);
        let sine = v.length();
        if sine == 0.0 {
            return identity();
        }
        let (sin, cos) = libm::sincos(n * libm::atan2(sine, s.w));
        let v = v / sine * sin;
        rows(DQuat::from_xyzw(v.x, v.y, v.z, cos))
    }

    /// What has become of the axes after `steps` steps by (`dx`, `dy`) radians.
    #[must_use]
    pub fn drift(self, dx: f64, dy: f64, steps: u32) -> Drift {
        let mut turned = Turned::new(self);
        for _ in 0..steps {
            turned.step(dx, dy);
        }
        let m = turned.matrix();
        Drift { orthogonality: orthogonality(&m), angle: apart(&m, &self.exact(dx, dy, steps)) }
    }
}

impl fmt::Display for Turning {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.pad(self.name())
    }
}

/// How far a matrix is from the rotation that it should be.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Drift {
    /// [`orthogonality`]: 0 for a rotation.
    pub orthogonality: f64,
    /// [`apart`]: the greatest angle between an axis and where it should point, in radians.
    pub angle: f64,
}

/// ‖M·Mᵀ − 1‖, the root of the sum of the squares of all entries: 0 for a rotation.
#[must_use]
pub fn orthogonality(m: &Rows<f64, 3>) -> f64 {
    let square = product(m, &transposed(m));
    let mut sum = 0.0;
    for (r, row) in square.iter().enumerate() {
        for (c, &x) in row.iter().enumerate() {
            let d = if r == c { x - 1.0 } else { x };
            sum += d * d;
        }
    }
    libm::sqrt(sum)
}

/// The greatest angle, in radians, between a column of `a` and the same column of `b`; lengths do not matter. NaN if a
/// number is.
#[must_use]
pub fn apart(a: &Rows<f64, 3>, b: &Rows<f64, 3>) -> f64 {
    let (a, b) = (transposed(a), transposed(b));
    let angles = [0, 1, 2].map(|i| {
        let cosine = a[i][0] * b[i][0] + a[i][1] * b[i][1] + a[i][2] * b[i][2];
        libm::atan2(length(cross(a[i], b[i])), cosine)
    });
    angles.into_iter().fold(0.0, |most: f64, angle| if angle > most || angle.is_nan() { angle } else { most })
}

/// Axes on their way through many steps.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Turned {
    state: State,
}

#[derive(Clone, Copy, Debug, PartialEq)]
enum State {
    Quaternion(DQuat),
    /// Each with what its sum has lost so far.
    Angles([[f64; 2]; 2]),
    MatrixF32(Rows<f32, 3>),
    MatrixF64(Rows<f64, 3>),
    Axes([[f32; 3]; 2]),
    QuaternionF32([f32; 4]),
}

impl Turned {
    /// The world's own axes, to be turned in this way.
    #[must_use]
    pub fn new(turning: Turning) -> Self {
        let state = match turning {
            Turning::Quaternion => State::Quaternion(DQuat::IDENTITY),
            Turning::Angles => State::Angles([[0.0; 2]; 2]),
            Turning::MatrixF32 => State::MatrixF32(identity()),
            Turning::MatrixF64 => State::MatrixF64(identity()),
            Turning::AxesF32 => State::Axes([[1.0, 0.0, 0.0], [0.0, 1.0, 0.0]]),
            Turning::QuaternionF32 => State::QuaternionF32([0.0, 0.0, 0.0, 1.0]),
        };
        Self { state }
    }

    /// Turns by `dx` radians from X towards Z, then by `dy` from Y towards Z.
    ///
    /// An angle that is not finite makes all numbers NaN, but for [`Turning::Quaternion`], where it counts as none.
    pub fn step(&mut self, dx: f64, dy: f64) {
        match &mut self.state {
            // `turn(by, rotation)`: about the thing's own axes.
            State::Quaternion(q) => *q = turn(about_y_then_x(dx, dy), *q),
            State::Angles([x, y]) => (*x, *y) = (plus(*x, dx), plus(*y, dy)),
            State::MatrixF32(m) => *m = product(m, &step(dx as f32, dy as f32)),
            State::MatrixF64(m) => *m = product(m, &step(dx, dy)),
            State::Axes([x, y]) => {
                *x = towards(*x, cross(*x, *y), dx as f32);
                *y = towards(*y, cross(*x, *y), dy as f32);
            }
            State::QuaternionF32(q) => {
                let half = |angle: f64| Real::sin_cos(angle as f32 / 2.0);
                let ((sx, cx), (sy, cy)) = (half(-dx), half(dy));
                let by = hamilton([0.0, sx, 0.0, cx], [sy, 0.0, 0.0, cy]);
                let [x, y, z, w] = hamilton(*q, by);
                let length = Real::sqrt(x * x + y * y + z * z + w * w);
                *q = [x / length, y / length, z / length, w / length];
            }
        }
    }

    /// M: the axes X, Y and Z as its columns.
    #[must_use]
    pub fn matrix(&self) -> Rows<f64, 3> {
        match self.state {
            State::Quaternion(q) => rows(q),
            State::Angles([[x, _], [y, _]]) => step(x, y),
            State::MatrixF32(m) => m.map(|row| row.map(f64::from)),
            State::MatrixF64(m) => m,
            State::Axes([x, y]) => transposed(&[x, y, cross(x, y)].map(|axis| axis.map(f64::from))),
            State::QuaternionF32(q) => of_quaternion(q).map(|row| row.map(f64::from)),
        }
    }
}

/// S = Ry(−dx)·Rx(dy).
fn step<T: Real>(dx: T, dy: T) -> Rows<T, 3> {
    let ((sx, cx), (sy, cy), one, zero) = (dx.sin_cos(), dy.sin_cos(), T::of(1.0), T::of(0.0));
    let y = [[cx, zero, -sx], [zero, one, zero], [sx, zero, cx]];
    let x = [[one, zero, zero], [zero, cy, -sy], [zero, sy, cy]];
    product(&y, &x)
}

/// The same as a quaternion, in the crate's own way.
fn about_y_then_x(dx: f64, dy: f64) -> DQuat {
    let y = axis_angle(DVec3::Y, -dx).unwrap_or(DQuat::IDENTITY);
    let x = axis_angle(DVec3::X, dy).unwrap_or(DQuat::IDENTITY);
    y.mul_quat(x)
}

/// A sum with what it has lost, and one more summand (Kahan 1965).
fn plus([sum, lost]: [f64; 2], x: f64) -> [f64; 2] {
    let x = x - lost;
    let next = sum + x;
    [next, (next - sum) - x]
}

/// S2's step: `axis` turned by `angle` towards `z`, scaled to length 1.
fn towards(axis: [f32; 3], z: [f32; 3], angle: f32) -> [f32; 3] {
    let (sin, cos) = Real::sin_cos(angle);
    normalized(core::array::from_fn(|i| axis[i] * cos + z[i] * sin))
}

/// The product of two quaternions, [x, y, z, w].
fn hamilton([ax, ay, az, aw]: [f32; 4], [bx, by, bz, bw]: [f32; 4]) -> [f32; 4] {
    [
        aw * bx + ax * bw + ay * bz - az * by,
        aw * by - ax * bz + ay * bw + az * bx,
        aw * bz + ax * by - ay * bx + az * bw,
        aw * bw - ax * bx - ay * by - az * bz,
    ]
}

/// The rotation matrix of a unit quaternion.
fn of_quaternion([x, y, z, w]: [f32; 4]) -> Rows<f32, 3> {
    [
        [1.0 - 2.0 * (y * y + z * z), 2.0 * (x * y - w * z), 2.0 * (x * z + w * y)],
        [2.0 * (x * y + w * z), 1.0 - 2.0 * (x * x + z * z), 2.0 * (y * z - w * x)],
        [2.0 * (x * z - w * y), 2.0 * (y * z + w * x), 1.0 - 2.0 * (x * x + y * y)],
    ]
}

/// The rows of the crate's own matrix of a rotation.
fn rows(q: DQuat) -> Rows<f64, 3> {
    DMat3::from_quat(q).transpose().to_cols_array_2d()
}
