//! The tetrahedron: every second corner of the cube.

use super::build::table;
use crate::Mesh;

/// A regular tetrahedron over four corners of the cube ±1: 4 triangles, 6 edges.
#[must_use]
pub fn tetrahedron() -> Mesh {
    table(
        &[[1.0, 1.0, 1.0], [-1.0, -1.0, 1.0], [-1.0, 1.0, -1.0], [1.0, -1.0, -1.0]],
        &[[0, 2, 1], [0, 1, 3], [0, 3, 2], [1, 2, 3]],
        &[[0, 1], [0, 2], [0, 3], [1, 2], [1, 3], [2, 3]],
    )
}
