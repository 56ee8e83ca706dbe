//! The coloured tetrahedron of the tutorials in which many meet rasterisation first.

use super::error::{ShapeError, within};
use crate::subdivide::{Onto, subdivide};
use crate::{Color, Colors, Mesh};

pub(super) fn count(level: u32) -> Result<u64, ShapeError> {
    within("seed-tetrahedron", "LEVEL", level, 0..=11)?;
    Ok(4 << (2 * level))
}

/// The tetrahedron P(100, 100, 100), Q(−100, −100, 100), R(−100, 100, −100), S(100, −100, −100) with one colour
/// a face: white PQR, red PQS, green RSP, blue RSQ; inflated `level` times towards the sphere of radius √30000
/// on which its corners lie (0: the tetrahedron itself; n: 4ⁿ⁺¹ triangles in the colours of their faces).
///
/// The winding is the original's: white and green are wound inward, red and blue outward, so it is to be drawn
/// without culling and lit from both sides; inflated parts are wound as their faces (the original turned two of
/// the four over at each level, which such drawing does not see). Its coordinates are the original's too, where y runs **down** the
/// screen: in this library it is seen upside down until turned.
///
/// # Errors
///
/// When `level` is more than 11, which is [`MOST_TRIANGLES`](crate::subdivide::MOST_TRIANGLES).
pub fn seed_tetrahedron(level: u32) -> Result<Mesh, ShapeError> {
    count(level)?;
    let (p, q, r, s) = (0, 1, 2, 3);
    let mesh = Mesh::new(
        vec![
            [100.0, 100.0, 100.0],
            [-100.0, -100.0, 100.0],
            [-100.0, 100.0, -100.0],
            [100.0, -100.0, -100.0],
        ],
        vec![[p, q, r], [p, q, s], [r, s, p], [r, s, q]],
    )?
    .with_colors(Colors::Face(vec![
        Color::WHITE,
        Color::new(255, 0, 0),
        Color::new(0, 255, 0),
        Color::new(0, 0, 255),
    ]))?;
    if level == 0 {
        return Ok(mesh);
    }
    Ok(subdivide(&mesh, level, Onto::Sphere { center: [0.0; 3], radius: 30_000.0_f64.sqrt() })?)
}
