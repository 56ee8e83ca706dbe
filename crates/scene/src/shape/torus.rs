//! The torus: a ring.

use super::build::{Builder, Corner, around_y, circle, next};
use super::error::{ShapeError, fits, within};
use crate::Mesh;

/// From the centre of the ring to the middle of the tube.
const RING: f64 = 0.7;
/// Radius of the tube; with [`RING`] it makes an outer radius of 1.
const TUBE: f64 = 0.3;

pub(super) fn count(segments: u32, sides: u32) -> Result<u64, ShapeError> {
    within("torus", "SEGMENTS", segments, 3..=1_000_000)?;
    within("torus", "SIDES", sides, 3..=1_000_000)?;
    fits("torus", "SEGMENTS and SIDES", 2 * u64::from(segments) * u64::from(sides))
}

/// A ring around the Y axis with the outer radius 1 and a tube of radius 0.3: `segments` pieces around the axis,
/// `sides` around the tube, 2 × `segments` × `sides` triangles. Its normals are smooth.
///
/// # Errors
///
/// When there are fewer than 3 segments or sides, or more triangles than
/// [`MOST_TRIANGLES`](crate::subdivide::MOST_TRIANGLES).
pub fn torus(segments: u32, sides: u32) -> Result<Mesh, ShapeError> {
    count(segments, sides)?;
    let mut build = Builder::default();
    let tube: Vec<[f64; 2]> = circle(sides).collect();
    let slices: Vec<Vec<Corner>> = circle(segments)
        .map(|direction| {
            tube.iter()
                .map(|&[out, up]| {
                    build.smooth_vertex(
                        around_y(direction, RING + TUBE * out, TUBE * up),
                        around_y(direction, out, up),
                    )
                })
                .collect()
        })
        .collect();
    for (k, slice) in slices.iter().enumerate() {
        let after = &slices[next(k, slices.len())];
        for a in 0..tube.len() {
            let b = next(a, tube.len());
            build.polygon([slice[a], after[a], after[b], slice[b]]);
        }
    }
    Ok(build.finish())
}
