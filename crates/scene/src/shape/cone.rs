//! The cone.

use super::build::{Builder, Corner, around_y, circle, next};
use super::error::{ShapeError, within};
use crate::Mesh;

pub(super) fn count(segments: u32) -> Result<u64, ShapeError> {
    within("cone", "SEGMENTS", segments, 3..=10_000_000)?;
    Ok(2 * u64::from(segments))
}

/// A closed cone about the Y axis: radius 1 at y = −1, apex at y = 1, `segments` flat sides, 2 × `segments`
/// triangles. The normals are smooth around the side and sharp at the rim; at the apex each triangle has the
/// normal of its middle.
///
/// # Errors
///
/// When there are fewer than 3 segments, or more than 10,000,000.
pub fn cone(segments: u32) -> Result<Mesh, ShapeError> {
    count(segments)?;
    let mut build = Builder::default();
    // The side falls 2 on 1 outward, so its normal rises 1 on 2 outward: (2, 1)/√5.
    let rise = 1.0 / 5.0_f64.sqrt();
    let apex = build.vertex([0.0, 1.0, 0.0]);
    let center = [build.vertex([0.0, -1.0, 0.0]), build.normal([0.0, -1.0, 0.0])];
    let mut rim = Vec::<Corner>::new();
    let mut tips = Vec::<Corner>::new();
    // Twice as many points: those between two segments give the apex its normals.
    for (i, direction) in circle(2 * segments).enumerate() {
        let normal = build.normal(around_y(direction, 2.0 * rise, rise));
        if i % 2 == 0 {
            rim.push([build.vertex(around_y(direction, 1.0, -1.0)), normal]);
        } else {
            tips.push([apex, normal]);
        }
    }
    for (k, &tip) in tips.iter().enumerate() {
        build.polygon([rim[k], rim[next(k, rim.len())], tip]);
    }
    let base: Vec<Corner> = rim.iter().rev().map(|&[vertex, _]| [vertex, center[1]]).collect();
    build.disc(center, &base);
    Ok(build.finish())
}
