//! A model on a turntable, seen whole through the whole turn.
//!
//! ```text
//!        axis                    every vertex goes round in a circle; the camera stands back from
//!     ┌───┼───┐  ╲               all circles, so that nothing leaves the picture in any frame
//!    (    ┼    )  ╲ eye
//!    │ ▟█▙┼    │ ◁             the model turns by the right-hand rule: the axis upward, counter-clockwise
//!    (    ┼    )                 seen from above; what is in front goes to the right
//!     └───┼───┘
//! ```
//!
//! It is the camera that goes round, the other way, and the world's light with it: that is the same picture, and the
//! model's numbers stay as they are.

use core::f64::consts::{PI, TAU};

use polosa_math::glam::{DMat3, DVec3};
use polosa_math::{Bounds, axis_angle};
use polosa_scene::{Camera, CameraError, Light, LightSpace};

use super::{Up, View};

/// Corners of the polygon around a vertex's circle: the camera stands 0.1 % farther away than the circle needs.
const CORNERS: u32 = 64;

/// What is seen while a model makes one turn.
#[derive(Clone, Copy, Debug)]
pub struct Turntable {
    first: Camera,
    focal: DVec3,
    axis: DVec3,
}

impl View {
    /// The turntable for a picture of `points`, which lie in `bounds`; `aspect` is width / height. The axis goes through
    /// the focal point. A camera whose position is given stays there; any other stands back until all of the turn fits.
    ///
    /// # Errors
    ///
    /// As [`View::camera`].
    pub fn turntable(
        &self,
        points: impl Iterator<Item = DVec3>,
        bounds: &Bounds,
        axis: Up,
        aspect: f64,
    ) -> Result<Turntable, CameraError> {
        let (focal, axis) = (self.focal(bounds), axis.axis());
        let swept = swept(points, focal, axis);
        let mut bounds = Bounds::EMPTY;
        for point in &swept {
            bounds.insert(*point);
        }
        let first = self.camera_to(focal, swept.into_iter(), &bounds, aspect)?;
        Ok(Turntable { first, focal, axis })
    }
}

impl Turntable {
    /// The camera of the first frame.
    #[must_use]
    pub const fn first(&self) -> &Camera {
        &self.first
    }

    /// Camera and light of frame `n`, counted from 0, of `frames`; in frame 0 they are as they are.
    ///
    /// # Errors
    ///
    /// When the camera would be too far away for numbers.
    pub fn frame(&self, n: u32, frames: u32, light: &Light) -> Result<(Camera, Light), CameraError> {
        let (mut camera, mut light) = (self.first, *light);
        if n == 0 {
            return Ok((camera, light));
        }
        let angle = -TAU * f64::from(n) / f64::from(frames.max(1));
        let turn = axis_angle(self.axis, angle).map(DMat3::from_quat).unwrap_or_default();
        camera.set_position(self.focal + turn * (self.first.position() - self.focal))?;
        // The picture's upward as it is: a mere hint could mean something else where it lies along the direction.
        camera.set_view_up(turn * self.first.up())?;
        camera.set_direction(turn * self.first.direction())?;
        if light.space == LightSpace::World {
            light.direction = turn * light.direction;
        }
        Ok((camera, light))
    }
}

/// Points around the circles of all points.
///
/// Of two circles about one axis the larger hides the smaller where they are at one height. Their heights and radii
/// therefore are reduced first to the outer hull, which even for millions of vertices has few corners:
///
/// ```text
///   radius ▲      o───o
///          │   o   .    ╲       a chain from the lowest to the highest, bent one way only
///          │  ╱  .    .  o
///          └──o───────────o──▶ height
/// ```
fn swept(points: impl Iterator<Item = DVec3>, focal: DVec3, axis: DVec3) -> Vec<DVec3> {
    let place = |point: DVec3| {
        let away = point - focal;
        let height = away.dot(axis);
        [height, (away - axis * height).length()]
    };
    let mut places: Vec<[f64; 2]> = Vec::new();
    let mut room = 1 << 12;
    for place in points.map(place).filter(|place| place.iter().all(|n| n.is_finite())) {
        places.push(place);
        if places.len() == room {
            places = hull(places);
            // Where few fall away, all would be looked at again and again.
            room = 2 * places.len() + (1 << 12);
        }
    }
    let (right, back) = (axis.any_orthonormal_vector(), axis.cross(axis.any_orthonormal_vector()));
    let grown = 1.0 / libm::cos(PI / f64::from(CORNERS));
    let corner = |[height, radius]: [f64; 2], k: u32| {
        let (sin, cos) = libm::sincos(TAU * f64::from(k) / f64::from(CORNERS));
        focal + axis * height + (right * cos + back * sin) * (radius * grown)
    };
    hull(places).into_iter().flat_map(|place| (0..CORNERS).map(move |k| corner(place, k))).collect()
}

/// The upper hull (A. M. Andrew's monotone chain, 1979): of points of one height the one farthest out, and between
/// neighbours none that lies on the inner side.
fn hull(mut places: Vec<[f64; 2]>) -> Vec<[f64; 2]> {
    places.sort_unstable_by(|a, b| a[0].total_cmp(&b[0]).then(b[1].total_cmp(&a[1])));
    places.dedup_by_key(|place| place[0]);
    let mut chain: Vec<[f64; 2]> = Vec::new();
    for place in places {
        while let [.., a, b] = chain[..]
            && (b[0] - a[0]) * (place[1] - a[1]) >= (b[1] - a[1]) * (place[0] - a[0])
        {
            chain.pop();
        }
        chain.push(place);
    }
    chain
}

#[cfg(test)]
mod tests {
    use polosa_math::glam::DVec3;
    use polosa_math::{Bounds, axis_angle};
    use polosa_scene::{Light, LightSpace};
    use proptest::prelude::*;

    use super::super::{Lens, Up, View};
    use super::hull;

    /// A long box beside the origin.
    fn plank() -> Bounds {
        Bounds::new(DVec3::new(9.0, -1.0, -1.0), DVec3::new(19.0, 1.0, 0.5))
    }

    #[test]
    fn the_model_is_seen_whole_in_every_frame_about_any_axis() {
        for lens in [Lens::Perspective(30.0), Lens::Perspective(110.0), Lens::Parallel] {
            for axis in [Up::PlusY, Up::MinusX, Up::PlusZ] {
                for focal_point in [None, Some(DVec3::new(8.0, 1.0, 2.0))] {
                    let view = View { lens, focal_point, ..View::default() };
                    let corners = plank().corners();
                    let table = view.turntable(corners.into_iter(), &plank(), axis, 1.5).unwrap();
                    let mut nearest = f64::INFINITY;
                    for n in 0..40 {
                        let (camera, _) = table.frame(n, 40, &Light::default()).unwrap();
                        for corner in corners {
                            let seen = camera.project_point(corner, 300, 200).expect("in front of the eye");
                            let edges = [seen.x - 15.0, 285.0 - seen.x, seen.y - 10.0, 190.0 - seen.y];
                            nearest = edges.into_iter().fold(nearest, f64::min);
                            assert!(
                                edges.iter().all(|edge| *edge > -1e-6),
                                "{view:?} {axis:?} frame {n}: {seen:?}"
                            );
                        }
                    }
                    assert!(nearest < 12.0, "no farther away than needed: {nearest} px left");
                }
            }
        }
    }

    #[test]
    fn it_is_as_if_the_model_turned_by_the_right_hand_rule() {
        for (axis, azimuth) in [(Up::PlusY, 0.0), (Up::MinusY, 20.0), (Up::PlusX, 70.0)] {
            let view = View { azimuth, view_up: Some(DVec3::new(0.1, 1.0, 0.3)), ..View::default() };
            let table = view.turntable(plank().corners().into_iter(), &plank(), axis, 1.0).unwrap();
            let focal = plank().center().unwrap();
            let light =
                Light { direction: DVec3::new(1.0, 2.0, 3.0), space: LightSpace::World, ambient: 0.1 };
            let (first, _) = table.frame(0, 8, &light).unwrap();
            assert_eq!(first, *table.first());
            for n in 0..=8 {
                let turn = axis_angle(axis.axis(), f64::from(n) * core::f64::consts::TAU / 8.0).unwrap();
                let (camera, turned) = table.frame(n, 8, &light).unwrap();
                for corner in plank().corners() {
                    let seen = camera.project_point(corner, 200, 200).unwrap();
                    let expected = first.project_point(focal + turn * (corner - focal), 200, 200).unwrap();
                    assert!(
                        (seen.x - expected.x).abs() < 1e-6 && (seen.y - expected.y).abs() < 1e-6,
                        "frame {n}"
                    );
                }
                assert!((turn * turned.direction - light.direction).length() < 1e-9);
            }
        }
    }

    #[test]
    fn a_camera_that_is_told_where_to_stand_stays_there_and_nothing_before_it_is_cut_off() {
        let position = Some(DVec3::new(14.0, 0.0, 7.0));
        let view = View { position, direction: Some(DVec3::NEG_Z), ..View::default() };
        let table = view.turntable(plank().corners().into_iter(), &plank(), Up::PlusY, 1.0).unwrap();
        assert_eq!(Some(table.first().position()), position);
        for n in 0..8 {
            let (camera, _) = table.frame(n, 8, &Light::default()).unwrap();
            assert!(
                plank()
                    .corners()
                    .iter()
                    .all(|c| camera.project_point(*c, 9, 9).is_some_and(|s| s.depth <= 1.0))
            );
        }
    }

    proptest! {
        #[test]
        fn no_place_lies_outside_of_the_hull(places in proptest::collection::vec(any::<[i8; 2]>(), 1..60)) {
            let places: Vec<[f64; 2]> = places.iter().map(|p| p.map(f64::from)).collect();
            let chain = hull(places.clone());
            for [x, y] in places {
                let at = chain.partition_point(|corner| corner[0] < x);
                let bound = match (at.checked_sub(1).map(|k| chain[k]), chain[at]) {
                    (_, [right, radius]) if right == x => radius,
                    (Some([a, r]), [b, s]) => r + (s - r) * (x - a) / (b - a),
                    (None, _) => panic!("before the first"),
                };
                prop_assert!(y <= bound + 1e-9);
            }
        }
    }
}
