//! The octahedron: one point on each half of each axis.

use super::build::table;
use crate::Mesh;

/// A regular octahedron of radius 1: 8 triangles, 12 edges.
#[must_use]
pub fn octahedron() -> Mesh {
    let (right, left, top, bottom, front, back) = (0, 1, 2, 3, 4, 5);
    table(
        &[
            [1.0, 0.0, 0.0],
            [-1.0, 0.0, 0.0],
            [0.0, 1.0, 0.0],
            [0.0, -1.0, 0.0],
            [0.0, 0.0, 1.0],
            [0.0, 0.0, -1.0],
        ],
        &[
            [right, top, front],
            [back, top, right],
            [left, top, back],
            [front, top, left],
            [front, bottom, right],
            [right, bottom, back],
            [back, bottom, left],
            [left, bottom, front],
        ],
        &[
            [right, top],
            [right, bottom],
            [right, front],
            [right, back],
            [left, top],
            [left, bottom],
            [left, front],
            [left, back],
            [top, front],
            [top, back],
            [bottom, front],
            [bottom, back],
        ],
    )
}
