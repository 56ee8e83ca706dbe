//! The pyramid OABCD.

use super::build::table;
use crate::Mesh;

/// A pyramid with the apex O over the square ABCD: 5 vertices, 8 edges, 5 faces, 6 triangles. The base is one
/// face: the diagonal that cuts it into two triangles is no edge and is not drawn.
///
/// ```text
///            O  (0, 1, 0)
///           /|\
///          / | \
///        D/--|--\C   z = −1       y = −1
///        /   |   \
///       A---------B  z = +1
///     x = −1    x = +1
/// ```
#[must_use]
pub fn pyramid() -> Mesh {
    let (o, a, b, c, d) = (0, 1, 2, 3, 4);
    table(
        &[[0.0, 1.0, 0.0], [-1.0, -1.0, 1.0], [1.0, -1.0, 1.0], [1.0, -1.0, -1.0], [-1.0, -1.0, -1.0]],
        &[[o, a, b], [o, b, c], [o, c, d], [o, d, a], [a, d, c], [a, c, b]],
        &[[o, a], [o, b], [o, c], [o, d], [a, b], [b, c], [c, d], [d, a]],
    )
}
