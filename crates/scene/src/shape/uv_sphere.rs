//! The sphere of circles of latitude and longitude, as a globe has them.

use super::build::{Builder, around_y, circle, next};
use super::error::{ShapeError, fits, within};
use crate::Mesh;

pub(super) fn count(segments: u32, rings: u32) -> Result<u64, ShapeError> {
    within("uv-sphere", "SEGMENTS", segments, 3..=1_000_000)?;
    within("uv-sphere", "RINGS", rings, 2..=1_000_000)?;
    fits("uv-sphere", "SEGMENTS and RINGS", 2 * u64::from(segments) * u64::from(rings - 1))
}

/// A sphere of radius 1 with its poles on the Y axis: `segments` slices around the axis, `rings` bands from pole
/// to pole; 2 × `segments` × (`rings` − 1) triangles. Its normals are smooth; its edges are the circles.
///
/// # Errors
///
/// When there are fewer than 3 segments or 2 rings, or more triangles than
/// [`MOST_TRIANGLES`](crate::subdivide::MOST_TRIANGLES).
pub fn uv_sphere(segments: u32, rings: u32) -> Result<Mesh, ShapeError> {
    count(segments, rings)?;
    let mut build = Builder::default();
    let around: Vec<[f64; 2]> = circle(segments).collect();
    // Half of the circle of 2 × rings points runs from the north pole (cos 1, sin 0) to the south pole.
    let mut bands = circle(2 * rings).take(rings as usize + 1).enumerate().map(|(j, [cos, sin])| {
        let poles = j == 0 || j == rings as usize;
        let mut corners = Vec::with_capacity(around.len());
        for &direction in &around {
            // A pole is one vertex: all quadrilaterals there are triangles.
            let corner = match corners.first() {
                Some(&pole) if poles => pole,
                _ => {
                    let p = around_y(direction, sin, cos);
                    build.smooth_vertex(p, p)
                }
            };
            corners.push(corner);
        }
        corners
    });
    let bands: Vec<_> = bands.by_ref().collect();
    for pair in bands.windows(2) {
        let [upper, lower] = pair else { continue };
        for k in 0..around.len() {
            let l = next(k, around.len());
            build.polygon([lower[k], lower[l], upper[l], upper[k]]);
        }
    }
    Ok(build.finish())
}
