//! From what a user says about the view to a [`Camera`].
//!
//! ```text
//!   position?   focal point?   direction?     what is not said
//!   ─────────   ────────────   ──────────     ─────────────────────────────────────────────────
//!       -            any           any        the camera stands back until the model fits the picture
//!      yes           any            -         it looks at the focal point; else at the model's middle
//!      yes            -            yes        nothing
//! ```
//!
//! A parallel view with a height of its own is a drawing to scale: it is not fitted to the model, and looks along
//! −Z at the world's origin. With a height of 256 in a picture of 256 pixels a world unit is a pixel, and the
//! world's (0, 0) is the picture's middle.

mod turntable;

use polosa_math::glam::DVec3;
use polosa_math::{Bounds, unit};
use polosa_scene::{Camera, CameraError, FieldOfView, Projection};

pub use self::turntable::Turntable;

/// From the model's middle to the observer, with +Y upward.
pub(crate) const TO_EYE: DVec3 = DVec3::new(1.0, 0.7, 1.0);

/// The part of the picture that stays free on every side of a fitted model.
pub(crate) const MARGIN: f64 = 0.05;

/// Which axis of the world points upward.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Up {
    /// +X.
    PlusX,
    /// −X.
    MinusX,
    /// +Y: OBJ, PLY, glTF and the standard shapes.
    PlusY,
    /// −Y.
    MinusY,
    /// +Z: STL, as printers and CAD have it.
    PlusZ,
    /// −Z.
    MinusZ,
}

impl Up {
    /// The axis itself.
    #[must_use]
    pub fn axis(self) -> DVec3 {
        self.turned(DVec3::Y)
    }

    /// A vector that is given for +Y upward, for this axis upward: turned by a quarter or half a turn, so that no
    /// number changes but in place and sign.
    #[must_use]
    pub fn turned(self, v: DVec3) -> DVec3 {
        let DVec3 { x, y, z } = v;
        match self {
            Self::PlusY => v,
            Self::MinusY => DVec3::new(x, -y, -z),
            Self::PlusZ => DVec3::new(x, -z, y),
            Self::MinusZ => DVec3::new(x, z, -y),
            Self::PlusX => DVec3::new(y, -x, z),
            Self::MinusX => DVec3::new(-y, x, z),
        }
    }
}

/// How the world is seen; angles in degrees. By default as far from it as it takes, in a perspective of 30°, from the
/// upper right front.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct View {
    /// Where the camera stands; `None`: as far away as the model needs.
    pub position: Option<DVec3>,
    /// What it looks at, and turns about; `None`: the middle of the model.
    pub focal_point: Option<DVec3>,
    /// Where it looks.
    pub direction: Option<DVec3>,
    /// What the picture has upward; `None`: `up`.
    pub view_up: Option<DVec3>,
    /// The axis of the world that is upward.
    pub up: Up,
    /// Round the focal point, to the right.
    pub azimuth: f64,
    /// Over the focal point, upward.
    pub elevation: f64,
    /// How things get smaller with distance, if they do.
    pub lens: Lens,
}

/// The projection.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Lens {
    /// Perspective with a vertical angle of view in degrees.
    Perspective(f64),
    /// Parallel, as high as the model needs.
    Parallel,
    /// Parallel, with so many world units from the lower to the upper edge.
    ParallelTo(f64),
}

impl Default for View {
    fn default() -> Self {
        Self {
            position: None,
            focal_point: None,
            direction: None,
            view_up: None,
            up: Up::PlusY,
            azimuth: 0.0,
            elevation: 0.0,
            lens: Lens::Perspective(30.0),
        }
    }
}

impl View {
    /// The camera for a picture of `points`, which lie in `bounds`; `aspect` is width / height.
    ///
    /// # Errors
    ///
    /// What the camera refuses, such as a world too large to stand back from.
    pub fn camera(
        &self,
        points: impl Iterator<Item = DVec3>,
        bounds: &Bounds,
        aspect: f64,
    ) -> Result<Camera, CameraError> {
        self.camera_to(self.focal(bounds), points, bounds, aspect)
    }

    /// What the camera looks at, and turns about.
    fn focal(&self, bounds: &Bounds) -> DVec3 {
        let middle = if self.is_to_scale() { DVec3::ZERO } else { bounds.center().unwrap_or(DVec3::ZERO) };
        match (self.position, self.focal_point, self.direction.and_then(unit)) {
            // The point of the line of sight that is nearest to the middle.
            (Some(position), None, Some(looking)) => {
                position + looking * (middle - position).dot(looking).max(0.0)
            }
            (_, focal, _) => focal.unwrap_or(middle),
        }
    }

    const fn is_to_scale(&self) -> bool {
        matches!(self.lens, Lens::ParallelTo(_))
    }

    /// The camera that turns about `focal`.
    fn camera_to(
        &self,
        focal: DVec3,
        points: impl Iterator<Item = DVec3>,
        bounds: &Bounds,
        aspect: f64,
    ) -> Result<Camera, CameraError> {
        let to_scale = self.is_to_scale();
        let away = self.up.turned(if to_scale { DVec3::Z } else { TO_EYE });

        let mut camera = Camera::new();
        camera.set_projection(match self.lens {
            Lens::Perspective(angle) => Projection::Perspective {
                fov: FieldOfView::Vertical(angle.to_radians()),
                near: 1.0,
                far: f64::INFINITY,
            },
            Lens::Parallel => Projection::Orthographic { height: 1.0, near: 0.0, far: 1.0 },
            Lens::ParallelTo(height) => Projection::Orthographic { height, near: 0.0, far: 1.0 },
        })?;
        camera.set_aspect(aspect)?;
        camera.set_view_up(self.view_up.unwrap_or(self.up.axis()))?;

        match (self.position, self.direction) {
            (Some(position), direction) => {
                camera.set_position(position)?;
                let looking = direction.unwrap_or(focal - position);
                camera.set_direction(if looking == DVec3::ZERO { -away } else { looking })?;
            }
            (None, direction) => {
                camera.set_direction(direction.unwrap_or(-away))?;
                camera.set_position(focal - camera.direction())?;
            }
        }
        camera.azimuth(self.azimuth.to_radians(), focal)?;
        camera.elevation(self.elevation.to_radians(), focal)?;

        if self.position.is_some() {
            set_depth(&mut camera, bounds)?;
        } else if to_scale {
            let (nearest, _) = depths(&camera, bounds);
            let back = camera.direction() * (nearest - radius(bounds)).min(0.0);
            camera.set_position(camera.position() + back)?;
            set_depth(&mut camera, bounds)?;
        } else {
            let (axis, up) = (camera.direction(), camera.view_up());
            match self.focal_point {
                None => camera.frame_points(points, -axis, up, MARGIN)?,
                Some(focal) => {
                    let both = points.flat_map(|point| [point, half_turn(point, focal, axis)]);
                    camera.frame_points(both, -axis, up, MARGIN)?;
                }
            }
        }
        Ok(camera)
    }
}

/// A point after half a turn about the line through `focal` along the unit vector `axis`. Points together with
/// these have `focal` in the middle of their picture.
fn half_turn(point: DVec3, focal: DVec3, axis: DVec3) -> DVec3 {
    let v = point - focal;
    focal + axis * (2.0 * v.dot(axis)) - v
}

/// Half the diagonal, 1 for what has none.
pub(crate) fn radius(bounds: &Bounds) -> f64 {
    let radius = bounds.diagonal() / 2.0;
    if radius > 0.0 { radius } else { 1.0 }
}

/// The least and the greatest distance of a corner from the eye, along the axis.
pub(crate) fn depths(camera: &Camera, bounds: &Bounds) -> (f64, f64) {
    if bounds.is_empty() {
        return (1.0, 1.0);
    }
    let depths = bounds.corners().map(|corner| (corner - camera.position()).dot(camera.direction()));
    (depths.into_iter().fold(f64::INFINITY, f64::min), depths.into_iter().fold(f64::NEG_INFINITY, f64::max))
}

/// Sets the near and the far plane of a camera that stays where it is: all that is in front of it is seen.
pub(crate) fn set_depth(camera: &mut Camera, bounds: &Bounds) -> Result<(), CameraError> {
    let (nearest, farthest) = depths(camera, bounds);
    let radius = radius(bounds);
    let projection = match camera.projection() {
        // Reversed depth with an infinite far plane resolves as finely wherever the near plane is.
        Projection::Perspective { fov, .. } => {
            Projection::Perspective { fov, near: (nearest / 2.0).max(radius * 1e-4), far: f64::INFINITY }
        }
        Projection::Orthographic { height, .. } => {
            // What lies in the eye's own plane counts as in front of it, rounding or not.
            let near = (nearest - radius / 2.0).max(-1e-6 * radius);
            Projection::Orthographic { height, near, far: (farthest + radius / 2.0).max(near + radius) }
        }
        other => other,
    };
    camera.set_projection(projection)
}

#[cfg(test)]
mod tests {
    use polosa_math::Bounds;
    use polosa_math::glam::DVec3;

    use super::{Lens, Up, View};

    fn cube() -> Bounds {
        Bounds::new(DVec3::new(9.0, -1.0, -1.0), DVec3::new(11.0, 1.0, 1.0))
    }

    #[test]
    fn a_drawing_to_scale_maps_units_to_pixels_exactly() {
        let view = View { lens: Lens::ParallelTo(256.0), ..View::default() };
        let camera = view.camera(cube().corners().into_iter(), &cube(), 1.0).unwrap();
        for (x, y) in [(0.0, 0.0), (10.0, -3.0), (-128.0, 128.0)] {
            let seen = camera.project_point(DVec3::new(x, y, 0.5), 256, 256).unwrap();
            assert_eq!([seen.x, seen.y], [128.0 + x, 128.0 - y]);
        }
    }

    #[test]
    fn the_model_is_seen_whole_from_everywhere() {
        for lens in [Lens::Perspective(30.0), Lens::Perspective(120.0), Lens::Parallel] {
            for up in [Up::PlusY, Up::PlusZ, Up::MinusX] {
                for (azimuth, elevation) in [(0.0, 0.0), (90.0, 0.0), (-30.0, 80.0), (200.0, -120.0)] {
                    for focal_point in [None, Some(DVec3::new(12.0, 0.0, 3.0))] {
                        let view = View { lens, up, azimuth, elevation, focal_point, ..View::default() };
                        let camera = view.camera(cube().corners().into_iter(), &cube(), 1.5).unwrap();
                        for corner in cube().corners() {
                            let seen = camera.project_point(corner, 300, 200).expect("in front of the eye");
                            assert!(
                                (14.9..285.1).contains(&seen.x) && (9.9..190.1).contains(&seen.y),
                                "{view:?}"
                            );
                        }
                    }
                }
            }
        }
    }

    #[test]
    fn the_default_view_has_the_up_axis_upward_and_comes_from_the_front_right() {
        for (up, to_eye) in [(Up::PlusY, DVec3::new(1.0, 0.7, 1.0)), (Up::PlusZ, DVec3::new(1.0, -1.0, 0.7))]
        {
            let camera =
                View { up, ..View::default() }.camera(cube().corners().into_iter(), &cube(), 1.0).unwrap();
            assert!((camera.direction() + to_eye.normalize()).length() < 1e-12);
            assert!(camera.up().dot(up.axis()) > 0.8);
        }
    }

    #[test]
    fn azimuth_goes_to_the_right_and_elevation_upward() {
        let front = View { direction: Some(DVec3::NEG_Z), ..View::default() };
        let right =
            View { azimuth: 90.0, ..front }.camera(cube().corners().into_iter(), &cube(), 1.0).unwrap();
        assert!((right.direction() - DVec3::NEG_X).length() < 1e-12, "{}", right.direction());
        let top =
            View { elevation: 90.0, ..front }.camera(cube().corners().into_iter(), &cube(), 1.0).unwrap();
        assert!((top.direction() - DVec3::NEG_Y).length() < 1e-12, "{}", top.direction());
    }

    #[test]
    fn a_given_place_is_kept_and_all_in_front_of_it_is_seen() {
        for lens in [Lens::Perspective(30.0), Lens::Parallel, Lens::ParallelTo(4.0)] {
            let position = Some(DVec3::new(10.0, 0.0, 7.0));
            let view = View { lens, position, direction: Some(DVec3::NEG_Z), ..View::default() };
            let camera = view.camera(cube().corners().into_iter(), &cube(), 1.0).unwrap();
            assert_eq!(camera.position(), DVec3::new(10.0, 0.0, 7.0));
            for z in [-1.0, 1.0] {
                let seen = camera.project_point(DVec3::new(10.0, 0.0, z), 100, 100).unwrap();
                assert!((camera.distance(seen.depth as f32) - (7.0 - z)).abs() < 1e-5);
            }
        }
    }

    #[test]
    fn nothing_at_all_can_be_looked_at_too() {
        for lens in [Lens::Perspective(30.0), Lens::Parallel, Lens::ParallelTo(4.0)] {
            for position in [None, Some(DVec3::ZERO)] {
                for bounds in [Bounds::EMPTY, Bounds::new(DVec3::ONE, DVec3::ONE)] {
                    assert!(
                        View { lens, position, ..View::default() }
                            .camera(std::iter::empty(), &bounds, 1.0)
                            .is_ok()
                    );
                }
            }
        }
    }
}
