//! The cube.

use super::build::table;
use crate::Mesh;

/// The cube from −1 to 1 on each axis: 12 triangles, 12 edges.
///
/// ```text
///      6 ------- 7        vertex x + 2y + 4z,
///     /|        /|        where x, y, z are 0 for −1 and 1 for +1
///    4 ------- 5 |        y
///    | |       | |        |
///    | 2 ------|-3        |___ x
///    |/        |/        /
///    0 ------- 1        (z here leads away from the observer)
/// ```
#[must_use]
pub fn cube() -> Mesh {
    let corner = |i: u8| [0, 1, 2].map(|axis| if i >> axis & 1 == 0 { -1.0 } else { 1.0 });
    table(
        &[0, 1, 2, 3, 4, 5, 6, 7].map(corner),
        &[
            [0, 2, 1],
            [1, 2, 3],
            [4, 5, 7],
            [4, 7, 6],
            [5, 1, 3],
            [5, 3, 7],
            [0, 6, 2],
            [0, 4, 6],
            [2, 6, 7],
            [2, 7, 3],
            [1, 4, 0],
            [1, 5, 4],
        ],
        &[[0, 1], [0, 2], [0, 4], [1, 3], [1, 5], [2, 3], [2, 6], [3, 7], [4, 5], [4, 6], [5, 7], [6, 7]],
    )
}
