//! Vectors and matrices of plain rows, for `f32` and `f64` alike.
//!
//! Sums go from left to right, products are not fused, and the functions of angles are `libm`'s: one result on all
//! machines. Vectors are columns: [`apply`] forms M·p. What a seed writes with row vectors, p·M, is
//! [`apply`] of the transposed matrix.

use core::fmt::Debug;
use core::ops::{Add, Div, Mul, Neg, Sub};

/// `f32` or `f64`.
pub trait Real:
    Copy
    + Debug
    + PartialOrd
    + Add<Output = Self>
    + Sub<Output = Self>
    + Mul<Output = Self>
    + Div<Output = Self>
    + Neg<Output = Self>
    + sealed::Sealed
{
    /// The nearest number of this type.
    #[must_use]
    fn of(x: f64) -> Self;
    /// The same number; exact.
    #[must_use]
    fn to_f64(self) -> f64;
    /// The square root, correctly rounded; NaN below 0.
    #[must_use]
    fn sqrt(self) -> Self;
    /// Sine and cosine of an angle in radians.
    #[must_use]
    fn sin_cos(self) -> (Self, Self);
    /// The tangent of an angle in radians.
    #[must_use]
    fn tan(self) -> Self;
}

mod sealed {
    pub trait Sealed {}
    impl Sealed for f32 {}
    impl Sealed for f64 {}
}

impl Real for f32 {
    fn of(x: f64) -> Self {
        x as Self
    }

    fn to_f64(self) -> f64 {
        self.into()
    }

    fn sqrt(self) -> Self {
        libm::sqrtf(self)
    }

    fn sin_cos(self) -> (Self, Self) {
        libm::sincosf(self)
    }

    fn tan(self) -> Self {
        libm::tanf(self)
    }
}

impl Real for f64 {
    fn of(x: f64) -> Self {
        x
    }

    fn to_f64(self) -> f64 {
        self
    }

    fn sqrt(self) -> Self {
        libm::sqrt(self)
    }

    fn sin_cos(self) -> (Self, Self) {
        libm::sincos(self)
    }

    fn tan(self) -> Self {
        libm::tan(self)
    }
}

/// A square matrix as its rows, top to bottom.
pub type Rows<T, const N: usize> = [[T; N]; N];

/// The matrix that changes nothing.
#[must_use]
pub fn identity<T: Real, const N: usize>() -> Rows<T, N> {
    core::array::from_fn(|r| core::array::from_fn(|c| T::of(if r == c { 1.0 } else { 0.0 })))
}

/// The matrix product a·b.
#[must_use]
pub fn product<T: Real, const N: usize>(a: &Rows<T, N>, b: &Rows<T, N>) -> Rows<T, N> {
    core::array::from_fn(|r| {
        core::array::from_fn(|c| (0..N).fold(T::of(0.0), |sum, k| sum + a[r][k] * b[k][c]))
    })
}

/// Rows become columns.
#[must_use]
pub fn transposed<T: Real, const N: usize>(m: &Rows<T, N>) -> Rows<T, N> {
    core::array::from_fn(|r| core::array::from_fn(|c| m[c][r]))
}

/// The column vector M·p.
#[must_use]
pub fn apply<T: Real, const N: usize>(m: &Rows<T, N>, p: [T; N]) -> [T; N] {
    core::array::from_fn(|r| (0..N).fold(T::of(0.0), |sum, c| sum + m[r][c] * p[c]))
}

/// M·(x, y, z, 1) divided by its fourth coordinate, whatever that is: behind the eye the picture is mirrored, in the
/// eye's own plane the result is infinite or not a number.
#[must_use]
pub fn project<T: Real>(m: &Rows<T, 4>, [x, y, z]: [T; 3]) -> [T; 3] {
    let [x, y, z, w] = apply(m, [x, y, z, T::of(1.0)]);
    [x / w, y / w, z / w]
}

/// a·b.
#[must_use]
pub fn dot<T: Real>(a: [T; 3], b: [T; 3]) -> T {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

/// a × b.
#[must_use]
pub fn cross<T: Real>(a: [T; 3], b: [T; 3]) -> [T; 3] {
    [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
}

/// The length of a vector, without care for squares that overflow.
#[must_use]
pub fn length<T: Real>(v: [T; 3]) -> T {
    dot(v, v).sqrt()
}

/// A vector divided by its length: not a number if that is 0.
#[must_use]
pub fn normalized<T: Real>(v: [T; 3]) -> [T; 3] {
    let length = length(v);
    v.map(|x| x / length)
}
