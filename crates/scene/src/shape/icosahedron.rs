//! The icosahedron: the corners of three golden rectangles.

use super::build::Builder;
use crate::Mesh;

/// A regular icosahedron of radius 1: 20 triangles, 30 edges.
///
/// ```text
///      0 --- 1
///      |     |          rectangles of sides 2 and 2φ, φ = (1 + √5)/2, in the planes
///      |     |          yz (vertices 0–3), zx (4–7) and xy (8–11);
///      |     |          all corners scaled to length 1
///      2 --- 3
/// ```
#[must_use]
pub fn icosahedron() -> Mesh {
    let golden = (1.0 + 5.0_f64.sqrt()) / 2.0;
    let length = (1.0 + golden * golden).sqrt();
    let (short, long) = (1.0 / length, golden / length);
    let mut build = Builder::default();
    let corners = [(-short, long), (short, long), (-short, -long), (short, -long)];
    let mut vertices = Vec::with_capacity(12);
    for axis in 0..3 {
        for (s, l) in corners {
            // s and l along the two axes that follow: zero first, turned round from rectangle to rectangle.
            let mut position = [0.0; 3];
            position[(axis + 1) % 3] = s;
            position[(axis + 2) % 3] = l;
            vertices.push(build.flat_vertex(position));
        }
    }
    for face in FACES {
        build.polygon(face.map(|i: usize| vertices[i]));
    }
    build.finish()
}

/// The eight faces in the octants, then the twelve that share a short side of a rectangle.
const FACES: [[usize; 3]; 20] = [
    [0, 7, 10],
    [0, 11, 5],
    [1, 5, 9],
    [1, 8, 7],
    [2, 4, 11],
    [2, 10, 6],
    [3, 6, 8],
    [3, 9, 4],
    [0, 1, 7],
    [0, 5, 1],
    [0, 10, 11],
    [1, 9, 8],
    [2, 3, 4],
    [2, 6, 3],
    [2, 11, 10],
    [3, 8, 9],
    [4, 5, 11],
    [4, 9, 5],
    [6, 7, 8],
    [6, 10, 7],
];
