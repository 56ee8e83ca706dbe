//! Coverage of a triangle in clip space without clipping it: Olano and Greer, *Triangle scan
//! conversion using 2D homogeneous coordinates* (1997), here in exact integers.
//!
//! A point p = (x, y, 1) of the screen, in normalised device coordinates, is λ₀v₀ + λ₁v₁ + λ₂v₂
//! with vᵢ = (xᵢ, yᵢ, wᵢ) and λ = M⁻¹p; it is visible through the triangle where no λ is negative
//! and the depth z = Σ λᵢzᵢ lies in [0, 1]. Each of the five conditions is a line on the screen,
//! its coefficients integers, so that neither a vertex behind the eye nor one at w = 0 matters.

use super::coverage::{CENTRE, Vertex, sample_point};

/// Vertex coordinates are integers in 2⁻¹² clip-space units; below 2²⁴, the lines fit `i128`.
pub const UNIT: f64 = 4096.0;

/// A snapped vertex moves by no more than this, in px; the 10⁻⁹ is for the rounding of
/// [`Homogeneous::inside_by`]'s quotients, the only one in this file.
pub const SNAP: f64 = std::f64::consts::SQRT_2 / 512.0 + 1e-9;

/// All lines: the edges opposite vertices 0, 1, 2, then the near plane's and the far plane's.
pub const ALL: [usize; 5] = [0, 1, 2, 3, 4];

/// The lines around the visible part of a triangle in clip space: a·X + b·Y + c ≥ 0, with X, Y in 1/256 px.
#[derive(Clone, Debug)]
pub struct Homogeneous {
    lines: [[i128; 3]; 5],
    /// The lines' slopes: a distance of 1/256 px changes a line's value by this.
    slopes: [f64; 5],
    adjugate: [[i128; 3]; 3],
    size: [i64; 2],
}

fn cross(a: [i128; 3], b: [i128; 3]) -> [i128; 3] {
    [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
}

impl Homogeneous {
    /// The oracle for three vertices (x, y, z, w) in [`UNIT`]s; `None` if seen edge-on.
    #[must_use]
    pub fn new(v: &[[i64; 4]; 3], width: i64, height: i64) -> Option<Self> {
        let xyw = v.map(|[x, y, _, w]| [x, y, w].map(i128::from));
        let z = v.map(|v| i128::from(v[2]));
        let mut n = [cross(xyw[1], xyw[2]), cross(xyw[2], xyw[0]), cross(xyw[0], xyw[1])];
        let mut det: i128 = (0..3).map(|c| n[0][c] * xyw[0][c]).sum();
        if det == 0 {
            return None;
        }
        if det < 0 {
            n = n.map(|n| n.map(|c| -c));
            det = -det;
        }
        let far = [0, 1, 2].map(|c| (0..3).map(|k| n[k][c] * z[k]).sum::<i128>());
        let near = [-far[0], -far[1], det - far[2]];
        let (w, h) = (i128::from(width), i128::from(height));
        // x = X/(128W) − 1 and y = 1 − Y/(128H), multiplied by 128WH.
        let line = |m: [i128; 3]| [m[0] * h, -m[1] * w, 128 * w * h * (m[2] - m[0] + m[1])];
        let lines = [n[0], n[1], n[2], near, far].map(line);
        let slopes = lines.map(|[a, b, _]| (a as f64).hypot(b as f64));
        Some(Self { lines, slopes, adjugate: n, size: [width, height] })
    }

    /// The vertices as the code under test gets them, exactly.
    ///
    /// # Panics
    ///
    /// Where a coordinate is 2²⁴ or more: it would be rounded.
    #[must_use]
    pub fn clip(v: &[[i64; 4]; 3]) -> [[f32; 4]; 3] {
        v.map(|v| {
            v.map(|c| {
                assert!(c.abs() < 1 << 24, "{c} would be rounded");
                (c as f64 / UNIT) as f32
            })
        })
    }

    /// The signed distance from a pixel's centre to the boundary, in px: positive inside.
    ///
    /// Inside, the nearest line is the nearest edge. Outside it is a lower bound, which reaches
    /// the distance everywhere but beyond a corner.
    #[must_use]
    pub fn inside_by(&self, i: i64, j: i64) -> f64 {
        self.point_inside_by(&ALL, sample_point(i, j, CENTRE))
    }

    /// The same without line `edge` (0 to 2: the edge opposite that vertex; 3: near, 4: far).
    #[must_use]
    pub fn inside_by_without(&self, edge: usize, i: i64, j: i64) -> f64 {
        let lines: Vec<usize> = ALL.into_iter().filter(|&k| k != edge).collect();
        self.point_inside_by(&lines, sample_point(i, j, CENTRE))
    }

    /// The same for some of the lines and any point of the screen, in 1/256 px.
    ///
    /// # Panics
    ///
    /// Where there is no such line: they are 0 to 4.
    #[must_use]
    pub fn point_inside_by(&self, lines: &[usize], point: Vertex) -> f64 {
        let [x, y] = point.map(i128::from);
        let distance = |&k: &usize| {
            let [a, b, c] = self.lines[k];
            let (value, slope) = ((a * x + b * y + c) as f64, self.slopes[k]);
            if slope == 0.0 { value.signum() * f64::INFINITY } else { value / slope / 256.0 }
        };
        lines.iter().map(distance).fold(f64::INFINITY, f64::min)
    }

    /// The depth at the point (x, y) of the screen, in px: its distance from the far plane, as a part of the
    /// way from there to the near one.
    #[must_use]
    pub fn depth(&self, x: f64, y: f64) -> f64 {
        let [near, far] = [3, 4].map(|k| {
            let [a, b, c] = self.lines[k].map(|c: i128| c as f64);
            a * 256.0 * x + b * 256.0 * y + c
        });
        far / (near + far)
    }

    /// The perspective-correct weights of the point (x, y) of the screen, in px.
    #[must_use]
    pub fn weights(&self, x: f64, y: f64) -> [f64; 3] {
        let [w, h] = self.size.map(|s| s as f64);
        let p = [2.0 * x / w - 1.0, 1.0 - 2.0 * y / h, 1.0];
        let lambda = self.adjugate.map(|n| (0..3).map(|c| n[c] as f64 * p[c]).sum::<f64>());
        let sum: f64 = lambda.iter().sum();
        lambda.map(|l| l / sum)
    }
}
