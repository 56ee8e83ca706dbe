//! Meshes to be drawn as a whole: closed, outward, in a coherent order, of any number of triangles.
//!
//! A lattice on the six faces of a cube is blown up to a ball and dented, so that its faces are of about one size
//! and its light varies; faces that meet share their vertices, as in a file from a modeller or a scanner.

use std::collections::HashMap;

/// An indexed mesh.
#[derive(Clone, Debug)]
pub struct Mesh {
    /// Model space; within 1.2 of the origin.
    pub positions: Vec<[f32; 3]>,
    /// Counter-clockwise seen from outside.
    pub triangles: Vec<[u32; 3]>,
}

/// Triangles of the meshes of the quoted figures; [`dented_ball`] comes as near as it can.
pub const COUNTS: [u32; 4] = [23_000, 100_000, 400_000, 1_600_000];

/// From 1 thousand to 4 million triangles.
pub const RANGE: [u32; 7] = [1_000, 4_000, 16_000, 64_000, 250_000, 1_000_000, 4_000_000];

/// A closed mesh of about `count` triangles (12·n² of them, n ≥ 1).
#[must_use]
pub fn dented_ball(count: u32) -> Mesh {
    let n = ((f64::from(count) / 12.0).sqrt().round() as i32).max(1);
    let mut positions = Vec::new();
    let mut triangles = Vec::with_capacity((12 * n * n) as usize);
    let mut known = HashMap::new();
    let mut vertex = |lattice: [i32; 3]| {
        *known.entry(lattice).or_insert_with(|| {
            positions.push(place(lattice.map(|k| f64::from(k) / f64::from(n))));
            (positions.len() - 1) as u32
        })
    };
    for axis in 0..3 {
        for side in [-n, n] {
            // Two cells of the lattice a step: it reaches from −n to n in each direction.
            for i in (-n..n).step_by(2) {
                for j in (-n..n).step_by(2) {
                    // u × v points along the axis: counter-clockwise from outside where side > 0.
                    let mut at = |u: i32, v: i32| {
                        let mut lattice = [0; 3];
                        lattice[axis] = side;
                        lattice[(axis + 1) % 3] = u;
                        lattice[(axis + 2) % 3] = v;
                        vertex(lattice)
                    };
                    let [a, b, c, d] = [at(i, j), at(i + 2, j), at(i + 2, j + 2), at(i, j + 2)];
                    let two = if side > 0 { [[a, b, c], [a, c, d]] } else { [[a, c, b], [a, d, c]] };
                    triangles.extend(two);
                }
            }
        }
    }
    Mesh { positions, triangles }
}

/// A point of the cube's surface on the dented ball.
fn place(cube: [f64; 3]) -> [f32; 3] {
    let square: f64 = cube.iter().map(|x| x * x).sum();
    let [x, y, z] = cube.map(|c| c / square.sqrt());
    // Chebyshev's fifth polynomial waves five times between −1 and 1; no sine is asked.
    let wave = |t: f64| ((16.0 * t * t - 20.0) * t * t + 5.0) * t;
    let radius = 1.0 + 0.05 * (wave(x) * wave(y) + wave(y) * wave(z) + wave(z) * wave(x));
    [x, y, z].map(|c| (c * radius) as f32)
}
