//! What is under the pointer, and moving it there or nearer.
//!
//! ```text
//!   pan    the camera moves across, so that P             zoom   the camera moves towards P by a factor,
//!          comes to lie on the new line of sight                 and P stays on its line of sight
//!
//!     eye o──────────────── P                               eye o────────▶o─────── P
//!         │ ╲ the pointer has moved                                 s·|eye − P|
//!         ▼   ╲
//!     eye′ o─────────────── P
//! ```
//!
//! P is the point of a surface, or where there is none, of the plane through the pivot across the axis. In a parallel
//! projection nothing is nearer or farther for being so in the picture: the picture's height is scaled, and the eye
//! moves across only.

use polosa_math::glam::DVec3;
use polosa_math::{Bounds, Planes};
use polosa_scene::{Camera, CameraError, Hit, Projection, Ray, World};

use crate::view::{depths, radius, set_depth};

/// How many times as large a notch of the wheel makes what is under the pointer.
const NOTCH: f64 = 1.2;

/// The least and the greatest distance of what is zoomed at, in radii of the scene. The near plane comes as near as a
/// tenth of the first ([`set_depth`]); at the second all of the scene is less than a pixel.
const DISTANCES: [f64; 2] = [1e-3, 1e4];

/// The same for the height of a parallel projection.
const HEIGHTS: [f64; 2] = [1e-3, 1e4];

/// The factor that so many notches scale distances by.
pub(crate) fn factor(notches: f64) -> f64 {
    libm::pow(NOTCH, -notches)
}

/// What of the world is seen at a place of the picture, between the near and the far plane.
pub(crate) fn seen(world: &World, camera: &Camera, [width, height]: [u32; 2], at: [f64; 2]) -> Option<Hit> {
    let ray = camera.pick_ray(at, width, height)?;
    let axis = camera.direction();
    // In a parallel projection the ray begins on the near plane as it is.
    let skipped =
        if camera.projection().is_parallel() { 0.0 } else { camera.distance(1.0) / ray.direction.dot(axis) };
    let from_near = Ray { origin: ray.origin + ray.direction * skipped, ..ray };
    let mut hit = world.pick(&from_near)?;
    hit.distance += skipped;
    ((hit.point - camera.position()).dot(axis) <= camera.distance(0.0)).then_some(hit)
}

/// Where the line of sight through a place of the picture meets the plane across the axis through `pivot`, or if that
/// is not in front of the near plane, through a point well behind it.
pub(crate) fn on_plane(
    camera: &Camera,
    [width, height]: [u32; 2],
    at: [f64; 2],
    pivot: DVec3,
    bounds: &Bounds,
) -> Option<DVec3> {
    let ray = camera.pick_ray(at, width, height)?;
    let (eye, axis) = (camera.position(), camera.direction());
    let (depth, near) = ((pivot - eye).dot(axis), camera.distance(1.0));
    let before = depth > near || camera.projection().is_parallel();
    let depth = if before { depth } else { near + radius(bounds) };
    let along = (depth - (ray.origin - eye).dot(axis)) / ray.direction.dot(axis);
    let point = ray.origin + ray.direction * along;
    point.is_finite().then_some(point)
}

/// Moves a camera across its axis so that `point` is seen at a place of the picture. By how much it moved.
pub(crate) fn pan(
    camera: &mut Camera,
    [width, height]: [u32; 2],
    point: DVec3,
    at: [f64; 2],
) -> Result<DVec3, CameraError> {
    let Some(ray) = camera.pick_ray(at, width, height) else { return Ok(DVec3::ZERO) };
    let axis = camera.direction();
    let to_point = point - ray.origin;
    // From where the line of sight is as deep as the point: across the axis.
    let across = to_point - ray.direction * (to_point.dot(axis) / ray.direction.dot(axis));
    let before = camera.position();
    camera.set_position(before + across)?;
    Ok(camera.position() - before)
}

/// Scales a camera's distance from `point` by `factor`, as far as sense goes, and a parallel projection's height. By
/// what factor it was done in the end.
pub(crate) fn zoom(
    camera: &mut Camera,
    point: DVec3,
    factor: f64,
    bounds: &Bounds,
) -> Result<f64, CameraError> {
    let (to_eye, projection) = (camera.position() - point, camera.projection());
    let (now, limits) = match projection {
        Projection::Orthographic { height, .. } => (height, HEIGHTS),
        Projection::OrthographicPlanes(planes) => (planes.top - planes.bottom, HEIGHTS),
        _ => (to_eye.length(), DISTANCES),
    };
    // Whoever is beyond a limit already may come back, but not go on.
    let [least, greatest] = limits.map(|limit| limit * radius(bounds) / now);
    let factor = factor.clamp(least.min(1.0), greatest.max(1.0));
    if !(factor > 0.0 && factor.is_finite()) {
        return Ok(1.0);
    }
    let mut zoomed = *camera;
    let axis = camera.direction();
    let by = match projection {
        Projection::Orthographic { height, near, far } => {
            zoomed.set_projection(Projection::Orthographic { height: height * factor, near, far })?;
            to_eye - axis * to_eye.dot(axis)
        }
        Projection::OrthographicPlanes(planes) => {
            zoomed.set_projection(Projection::OrthographicPlanes(Planes {
                left: planes.left * factor,
                right: planes.right * factor,
                bottom: planes.bottom * factor,
                top: planes.top * factor,
                ..planes
            }))?;
            to_eye - axis * to_eye.dot(axis)
        }
        _ => to_eye,
    };
    zoomed.set_position(camera.position() + by * (factor - 1.0))?;
    *camera = zoomed;
    Ok(factor)
}

/// Has near and far plane fit the scene. In a parallel projection the eye, which may be anywhere along the axis without
/// a difference in the picture, first goes back until nothing is behind it.
pub(crate) fn fit_depth(camera: &mut Camera, bounds: &Bounds) -> Result<(), CameraError> {
    if matches!(camera.projection(), Projection::Orthographic { .. }) {
        let (nearest, _) = depths(camera, bounds);
        if nearest < 0.0 {
            let back = nearest - radius(bounds);
            camera.set_position(camera.position() + camera.direction() * back)?;
        }
    }
    set_depth(camera, bounds)
}
