//! Spheres as the seeds make them, of radius 1, and how far their triangles lie inside.
//!
//! ```text
//!   S0, S3: inflated tetrahedron               S2: one octant, mirrored
//!            v3                                          c
//!           ╱  ╲                                        ╱ ╲       ab = norm(a + b), …
//!         m2 ── m1   of v2v3 and v1v3: m2, m3         ac ── bc    the other seven octants are
//!        ╱  ╲  ╱  ╲                                   ╱ ╲ ╱ ╲     this one with signs changed
//!      v2 ── m1 ── v1                                a ─ ab ─ b
//! ```
//!
//! Both make triangles with corners of their own; a corner that is shared by several triangles has the same bits in
//! all. [`shape::sphere`](crate::shape::sphere()) makes the same triangles over shared vertices, all wound outward.

use polosa_math::reference::algebra::{cross, dot, length, normalized};

use crate::shape::{self, ShapeError, Solid};
use crate::subdivide::{MOST_TRIANGLES, to_f32};
use crate::{Mesh, MeshError};

/// A way to make a sphere.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, Default)]
pub enum Sphere {
    /// A tetrahedron, its triangles cut into four and their corners moved out to the sphere, level by level (S0, S3).
    Tetrahedron,
    /// One octant of an octahedron, cut by normalised sums, mirrored to the other seven (S2).
    Octant,
    /// An icosahedron, [`shape::sphere`](crate::shape::sphere())'s best.
    #[default]
    Icosahedron,
}

/// A triangle's corners.
type Corners = [[f64; 3]; 3];

impl Sphere {
    /// All of them.
    pub const ALL: &[Self] = &[Self::Tetrahedron, Self::Octant, Self::Icosahedron];

    /// Its name, in small letters.
    #[must_use]
    pub const fn name(self) -> &'static str {
        match self {
            Self::Tetrahedron => "tetrahedron",
            Self::Octant => "octant",
            Self::Icosahedron => "icosahedron",
        }
    }

    /// In one line: from which seed, and what it gets wrong.
    #[must_use]
    pub const fn about(self) -> &'static str {
        match self {
            Self::Tetrahedron => {
                "tetrahedron inflated (S0, S3): twice the octahedron's triangles for equal error"
            }
            Self::Octant => {
                "octant of an octahedron, mirrored (S2): exactly symmetric; its triangles differ in size"
            }
            Self::Icosahedron => "icosahedron subdivided: the most equal triangles, the fewest for an error",
        }
    }

    /// How many triangles level `level` has: 4ⁿ⁺¹, 8·4ⁿ or 20·4ⁿ. `None` beyond 2⁶³.
    #[must_use]
    pub fn triangles(self, level: u32) -> Option<u64> {
        let base: u64 = match self {
            Self::Tetrahedron => 4,
            Self::Octant => 8,
            Self::Icosahedron => 20,
        };
        4_u64.checked_pow(level)?.checked_mul(base)
    }

    /// The sphere of radius 1 around the origin.
    ///
    /// The tetrahedron's triangles are wound as in the seed, where two of the four parts of each are turned over; the
    /// others' are counter-clockwise from outside.
    ///
    /// # Errors
    ///
    /// When it would have more than [`MOST_TRIANGLES`] triangles.
    pub fn mesh(self, level: u32) -> Result<Mesh, ShapeError> {
        let triangles = self.triangles(level).unwrap_or(u64::MAX);
        if triangles > MOST_TRIANGLES {
            return Err(ShapeError::TooLarge { shape: self.name(), triangles, parameters: "LEVEL" });
        }
        let corners = match self {
            Self::Tetrahedron => inflated(level),
            Self::Octant => mirrored(level),
            Self::Icosahedron => return shape::sphere(Solid::Icosahedron, level),
        };
        Ok(separate(&corners)?)
    }
}

impl core::fmt::Display for Sphere {
    fn fmt(&self, f: &mut core::fmt::Formatter<'_>) -> core::fmt::Result {
        f.pad(self.name())
    }
}

/// S0's and S3's inflation, from the faces PQR, PQS, RSP, RSQ.
fn inflated(level: u32) -> Vec<Corners> {
    let [p, q, r, s] =
        [[1.0, 1.0, 1.0], [-1.0, -1.0, 1.0], [-1.0, 1.0, -1.0], [1.0, -1.0, -1.0]].map(normalized);
    let mut triangles = vec![[p, q, r], [p, q, s], [r, s, p], [r, s, q]];
    for _ in 0..level {
        triangles = triangles
            .into_iter()
            .flat_map(|[v1, v2, v3]| {
                let half = |a: [f64; 3], b: [f64; 3]| normalized([0, 1, 2].map(|i| (a[i] + b[i]) / 2.0));
                let (m1, m2, m3) = (half(v1, v2), half(v2, v3), half(v1, v3));
                [[v1, m1, m3], [v2, m1, m2], [v3, m2, m3], [m1, m2, m3]]
            })
            .collect();
    }
    triangles
}

/// S2's octant and its seven mirror images.
fn mirrored(level: u32) -> Vec<Corners> {
    let mut octant = vec![[[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]]];
    for _ in 0..level {
        octant = octant
            .into_iter()
            .flat_map(|[a, b, c]| {
                let between = |a: [f64; 3], b: [f64; 3]| normalized([0, 1, 2].map(|i| a[i] + b[i]));
                let (ab, bc, ac) = (between(a, b), between(b, c), between(a, c));
                [[a, ab, ac], [ab, b, bc], [ac, bc, c], [bc, ac, ab]]
            })
            .collect();
    }
    (0..8_u32)
        .flat_map(|signs| {
            let mirror = move |p: [f64; 3]| [0, 1, 2].map(|i| if signs >> i & 1 == 1 { -p[i] } else { p[i] });
            // An odd number of mirrors turns a triangle over; b and c change places to turn it back.
            let odd = signs.count_ones() % 2 == 1;
            octant.iter().map(move |&[a, b, c]| if odd { [a, c, b] } else { [a, b, c] }.map(mirror))
        })
        .collect()
}

/// A mesh whose triangles share no vertex.
fn separate(triangles: &[Corners]) -> Result<Mesh, MeshError> {
    let positions = triangles.as_flattened().iter().map(|&p| to_f32(p)).collect();
    // Within range: `mesh` has refused more than 20 million triangles.
    let indices = (0..triangles.len() as u32).map(|t| [3 * t, 3 * t + 1, 3 * t + 2]).collect();
    Mesh::new(positions, indices)
}

/// How far the triangles of a mesh lie inside the sphere of `radius` around the origin: the greatest difference
/// between the radius and the distance of a triangle's nearest point. In the mesh's units; negative if all triangles
/// lie outside, −∞ for a mesh without triangles, NaN where a position is not a number.
#[must_use]
pub fn radial_error(mesh: &Mesh, radius: f64) -> f64 {
    let at = |i: u32| mesh.positions()[i as usize].map(f64::from);
    let errors = mesh.triangles().iter().map(|t| radius - distance(t.map(at)));
    errors.fold(f64::NEG_INFINITY, |most, error| if error > most || error.is_nan() { error } else { most })
}

/// The distance of a triangle from the origin.
fn distance([a, b, c]: Corners) -> f64 {
    let minus = |a: [f64; 3], b: [f64; 3]| [0, 1, 2].map(|i| a[i] - b[i]);
    let n = cross(minus(b, a), minus(c, a));
    // The foot of the perpendicular is inside if it is on the inner side of all three sides; from the origin, the
    // side a→b has the sign of n·(a × b).
    let inside = [(a, b), (b, c), (c, a)].iter().all(|&(p, q)| dot(n, cross(p, q)) >= 0.0);
    let size = length(n);
    if inside && size > 0.0 {
        return dot(n, a).abs() / size;
    }
    let to_side = |p: [f64; 3], q: [f64; 3]| {
        let d = minus(q, p);
        let along = if dot(d, d) > 0.0 { (-dot(p, d) / dot(d, d)).clamp(0.0, 1.0) } else { 0.0 };
        let nearest = [0, 1, 2].map(|i| p[i] + d[i] * along);
        length(nearest)
    };
    let sides = [to_side(a, b), to_side(b, c), to_side(c, a)];
    sides.into_iter().fold(f64::INFINITY, |least, d| if d < least || d.is_nan() { d } else { least })
}
