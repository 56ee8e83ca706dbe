//! S4's way from the world to the pixel: the product of six matrices.
//!
//! ```text
//!   M = screen · scale · shift · perspective · rotation · shift
//!       6        5       4       3             2          1
//!
//!   1  the eye comes to the origin             4  the box's middle comes to the origin
//!   2  the axes u, v, w become x, y, z         5  the box becomes −1 … 1
//!   3  what is farther becomes smaller         6  −1 … 1 becomes pixels, centres at whole numbers, y as v
//! ```
//!
//! Distances run along w, away from the eye. Depth is 1 on the near plane and −1 on the far one, so the nearest of
//! two points has the larger; the report's rule, the smallest wins, fits another sign of w.

use super::Fault;
use crate::reference::algebra::{Real, Rows, dot, product, project};

/// Which last row the matrix of step 3 has.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, Default)]
pub enum Form {
    /// 0 0 n 0, as the report prints it.
    Printed,
    /// 0 0 1 0.
    #[default]
    Mended,
}

/// S4's camera.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Camera<T> {
    /// The eye.
    pub position: [T; 3],
    /// The axes u (right), v (up) and w (ahead), of unit length and at right angles.
    pub axes: [[T; 3]; 3],
    /// l, b, n: the box's corner on the near plane.
    pub nearest: [T; 3],
    /// r, t, f: the opposite corner; r and t still on the near plane, f the distance of the far one.
    pub farthest: [T; 3],
    /// The picture's width and height in pixels.
    pub size: [T; 2],
}

impl<T: Real> Camera<T> {
    /// The same camera, its numbers as they are, computed in `f64`.
    #[must_use]
    pub fn widened(&self) -> Camera<f64> {
        Camera {
            position: self.position.map(T::to_f64),
            axes: self.axes.map(|axis| axis.map(T::to_f64)),
            nearest: self.nearest.map(T::to_f64),
            farthest: self.farthest.map(T::to_f64),
            size: self.size.map(T::to_f64),
        }
    }

    /// The six matrices, the last of the way (the screen's) first.
    #[must_use]
    pub fn steps(&self, form: Form) -> [Rows<T, 4>; 6] {
        let ([l, b, n], [r, t, f], [width, height]) = (self.nearest, self.farthest, self.size);
        let (zero, one, two) = (T::of(0.0), T::of(1.0), T::of(2.0));
        let last = match form {
            Form::Printed => n,
            Form::Mended => one,
        };
        let screen = [
            [width / two, zero, zero, (width - one) / two],
            [zero, height / two, zero, (height - one) / two],
            [zero, zero, one, zero],
            [zero, zero, zero, one],
        ];
        let (x, y, z) = (two / (r - l), two / (t - b), two / (n - f));
        let scale =
            [[x, zero, zero, zero], [zero, y, zero, zero], [zero, zero, z, zero], [zero, zero, zero, one]];
        let perspective = [
            [n, zero, zero, zero],
            [zero, n, zero, zero],
            [zero, zero, n + f, -(n * f)],
            [zero, zero, last, zero],
        ];
        let turn = |axis: [T; 3]| [axis[0], axis[1], axis[2], zero];
        let [u, v, w] = self.axes.map(turn);
        let rotation = [u, v, w, [zero, zero, zero, one]];
        let middle = [-(l + r) / two, -(b + t) / two, -(n + f) / two];
        [screen, scale, shift(middle), perspective, rotation, shift(self.position.map(|x| -x))]
    }

    /// M: the product of the six, formed from the left.
    #[must_use]
    pub fn matrix(&self, form: Form) -> Rows<T, 4> {
        let [first, rest @ ..] = self.steps(form);
        rest.iter().fold(first, |m, step| product(&m, step))
    }

    /// Where a point of the world comes to lie: x and y in pixels, and its depth, 1 near to −1 far.
    #[must_use]
    pub fn pixels(&self, form: Form, point: [T; 3]) -> [T; 3] {
        project(&self.matrix(form), point)
    }

    /// What is wrong with it as it stands.
    pub fn faults(&self, form: Form) -> impl Iterator<Item = Fault> + use<T> {
        let near = self.nearest[2].to_f64();
        let [right, up] = [0, 1].map(|i| libm::sqrt(dot(self.axes[i], self.axes[i]).to_f64()));
        let unit = |length: f64| (length - 1.0).abs() < 1e-6;
        let last = (form == Form::Printed && near != 1.0).then_some(Fault::LastRow { near });
        let lengths = (!unit(right) || !unit(up)).then_some(Fault::Lengths { right, up });
        [last, lengths].into_iter().flatten()
    }
}

fn shift<T: Real>([x, y, z]: [T; 3]) -> Rows<T, 4> {
    let (zero, one) = (T::of(0.0), T::of(1.0));
    [[one, zero, zero, x], [zero, one, zero, y], [zero, zero, one, z], [zero, zero, zero, one]]
}
