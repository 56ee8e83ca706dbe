//! The cylinder.

use super::build::{Builder, Corner, around_y, circle, next};
use super::error::{ShapeError, within};
use crate::Mesh;

pub(super) fn count(segments: u32) -> Result<u64, ShapeError> {
    within("cylinder", "SEGMENTS", segments, 3..=5_000_000)?;
    Ok(4 * u64::from(segments))
}

/// A closed cylinder about the Y axis, radius 1, from y = −1 to 1, with `segments` flat sides: 4 × `segments`
/// triangles. The normals are smooth around the side and sharp at the rims; the edges are the rims and the
/// sides' borders.
///
/// # Errors
///
/// When there are fewer than 3 segments, or more than 5,000,000.
pub fn cylinder(segments: u32) -> Result<Mesh, ShapeError> {
    count(segments)?;
    let mut build = Builder::default();
    let (down, up) = (build.normal([0.0, -1.0, 0.0]), build.normal([0.0, 1.0, 0.0]));
    let (mut lower, mut upper) = (Vec::<Corner>::new(), Vec::<Corner>::new());
    for direction in circle(segments) {
        let outward = build.normal(around_y(direction, 1.0, 0.0));
        lower.push([build.vertex(around_y(direction, 1.0, -1.0)), outward]);
        upper.push([build.vertex(around_y(direction, 1.0, 1.0)), outward]);
    }
    for k in 0..lower.len() {
        let l = next(k, lower.len());
        build.polygon([lower[k], lower[l], upper[l], upper[k]]);
    }
    let top: Vec<Corner> = upper.iter().map(|&[vertex, _]| [vertex, up]).collect();
    let bottom: Vec<Corner> = lower.iter().rev().map(|&[vertex, _]| [vertex, down]).collect();
    let centers = [build.vertex([0.0, 1.0, 0.0]), build.vertex([0.0, -1.0, 0.0])];
    build.disc([centers[0], up], &top);
    build.disc([centers[1], down], &bottom);
    Ok(build.finish())
}
