//! The plane: a square floor.

use super::build::Builder;
use super::error::{ShapeError, within};
use crate::Mesh;

pub(super) fn count(cells: u32) -> Result<u64, ShapeError> {
    within("plane", "CELLS", cells, 1..=3162)?;
    Ok(2 * u64::from(cells) * u64::from(cells))
}

/// The square from −1 to 1 in x and z at y = 0, seen from above (+Y), in `cells` × `cells` squares. Its edges are
/// the sides of the squares.
///
/// # Errors
///
/// When `cells` is 0 or more than 3162, which is
/// [`MOST_TRIANGLES`](crate::subdivide::MOST_TRIANGLES).
pub fn plane(cells: u32) -> Result<Mesh, ShapeError> {
    count(cells)?;
    let mut build = Builder::default();
    let place = |i: u32| (2.0 * f64::from(i) - f64::from(cells)) / f64::from(cells);
    let rows: Vec<Vec<_>> = (0..=cells)
        .map(|j| (0..=cells).map(|i| build.flat_vertex([place(i), 0.0, 0.0 - place(j)])).collect())
        .collect();
    for pair in rows.windows(2) {
        let [near, far] = pair else { continue };
        for (n, f) in near.windows(2).zip(far.windows(2)) {
            build.polygon([n[0], n[1], f[1], f[0]]);
        }
    }
    Ok(build.finish())
}
