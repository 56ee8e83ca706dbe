//! Claims of the camera's documentation.

use core::f64::consts::{FRAC_PI_2, FRAC_PI_4, PI};

use polosa_math::{
    Bounds, Placement, Planes,
    glam::{DMat4, DVec2, DVec3, DVec4},
};
use proptest::prelude::*;

use super::{Camera, CameraError, FieldOfView, Projection};

const OFF_CENTRE: Planes = Planes { left: -0.5, right: 1.0, bottom: -0.75, top: 0.25, near: 1.0, far: 50.0 };

/// One of each kind.
fn projections() -> [Projection; 6] {
    [
        Projection::Perspective { fov: FieldOfView::Vertical(0.8), near: 0.5, far: 100.0 },
        Projection::Perspective { fov: FieldOfView::Vertical(2.0), near: 0.1, far: f64::INFINITY },
        Projection::Perspective { fov: FieldOfView::Horizontal(1.2), near: 1.0, far: 1000.0 },
        Projection::Orthographic { height: 7.0, near: -20.0, far: 80.0 },
        Projection::PerspectivePlanes(OFF_CENTRE),
        Projection::OrthographicPlanes(OFF_CENTRE),
    ]
}

fn camera(projection: Projection) -> Camera {
    let mut camera = Camera::new();
    camera.set_position(DVec3::new(3.0, 4.0, 8.0)).unwrap();
    camera.set_direction(DVec3::new(-3.0, -4.0, -8.0)).unwrap();
    camera.set_aspect(1.5).unwrap();
    camera.set_projection(projection).unwrap();
    camera
}

fn close(a: DVec3, b: DVec3, tolerance: f64) -> bool {
    (a - b).length() <= tolerance
}

#[test]
fn starts_like_the_first_camera_chapter() {
    let camera = Camera::new();
    assert_eq!(camera.position(), DVec3::new(0.0, 0.0, 10.0));
    assert_eq!(camera.direction(), DVec3::NEG_Z);
    assert_eq!((camera.right(), camera.up()), (DVec3::X, DVec3::Y));
    // 70° from left to right, near 1: x/w is 1 at tan 35° beside the axis.
    let edge = camera.project_point(DVec3::new(35_f64.to_radians().tan(), 0.0, 9.0), 400, 300).unwrap();
    assert!((edge.x - 400.0).abs() < 1e-9 && edge.y == 150.0 && (edge.depth - 1.0).abs() < 1e-12);
    assert!((camera.distance(0.0) - 1000.0).abs() < 1e-9);
}

#[test]
fn every_setter_changes_what_is_computed_at_once() {
    let mut camera = Camera::new();
    let mut last = camera.view_projection();
    let mut changed = |camera: &Camera| {
        let now = camera.view_projection();
        core::mem::replace(&mut last, now) != now
    };
    camera.set_position(DVec3::new(1.0, 2.0, 3.0)).unwrap();
    assert!(changed(&camera));
    camera.set_direction(DVec3::new(1.0, 0.0, -1.0)).unwrap();
    assert!(changed(&camera));
    camera.set_view_up(DVec3::new(1.0, 1.0, 0.0)).unwrap();
    assert!(changed(&camera));
    camera.set_aspect(2.0).unwrap();
    assert!(changed(&camera));
    camera.set_projection(Projection::Orthographic { height: 2.0, near: 0.0, far: 9.0 }).unwrap();
    assert!(changed(&camera));
}

#[test]
fn what_has_no_matrix_is_refused_and_changes_nothing() {
    let mut camera = Camera::new();
    let before = camera;
    let nan = DVec3::new(0.0, f64::NAN, 0.0);
    assert!(matches!(camera.set_position(nan), Err(CameraError::Position(_))));
    assert_eq!(camera.set_direction(DVec3::ZERO), Err(CameraError::Direction(DVec3::ZERO)));
    assert_eq!(camera.set_view_up(DVec3::INFINITY), Err(CameraError::Up(DVec3::INFINITY)));
    for aspect in [0.0, -1.0, f64::NAN, f64::INFINITY] {
        assert!(matches!(camera.set_aspect(aspect), Err(CameraError::Projection { .. })), "{aspect}");
    }
    for fov in [0.0, PI, -1.0, f64::NAN] {
        let projection = Projection::Perspective { fov: FieldOfView::Vertical(fov), near: 1.0, far: 2.0 };
        assert!(camera.set_projection(projection).is_err(), "{fov}");
    }
    for (near, far) in [(0.0, 1.0), (2.0, 1.0), (1.0, 1.0), (f64::NAN, 1.0), (1.0, f64::NAN)] {
        let projection = Projection::Perspective { fov: FieldOfView::Vertical(1.0), near, far };
        assert!(camera.set_projection(projection).is_err(), "{near} {far}");
    }
    assert!(camera.azimuth(f64::NAN, DVec3::ZERO).is_err() && camera.elevation(1.0, nan).is_err());
    let cube = Bounds::new(DVec3::ZERO, DVec3::ONE);
    assert_eq!(camera.frame(&cube, DVec3::ONE, DVec3::Y, 0.5), Err(CameraError::Margin(0.5)));
    assert_eq!(camera.frame(&cube, DVec3::ZERO, DVec3::Y, 0.0), Err(CameraError::Direction(DVec3::ZERO)));
    assert_eq!(camera, before);
}

#[test]
fn a_unit_is_a_pixel_and_the_origin_the_centre_in_a_parallel_projection_of_the_pictures_height() {
    let mut camera = Camera::new();
    camera.set_aspect(1.0).unwrap();
    camera.set_projection(Projection::Orthographic { height: 256.0, near: 0.0, far: 20.0 }).unwrap();
    assert_eq!(camera.projection_matrix().x_axis.x, 2.0 / 256.0);
    for (x, y) in [(0.0, 0.0), (1.0, 0.0), (-128.0, 128.0), (17.25, -3.5)] {
        let at = camera.project_point(DVec3::new(x, y, 0.0), 256, 256).unwrap();
        assert_eq!((at.x, at.y), (128.0 + x, 128.0 - y));
    }
}

#[test]
fn only_points_between_near_and_far_are_projected() {
    let camera = Camera::new();
    for (z, seen) in
        [(11.0, false), (10.0, false), (9.5, false), (8.9, true), (-989.0, true), (-991.0, false)]
    {
        assert_eq!(camera.project_point(DVec3::new(0.0, 0.0, z), 4, 3).is_some(), seen, "{z}");
    }
    assert_eq!(camera.project_point(DVec3::NAN, 4, 3), None);
    assert_eq!(camera.project_point(DVec3::ZERO, 0, 3), None);
    assert_eq!(camera.pick_ray([0.0, 0.0], 4, 0), None);
    assert_eq!(camera.pick_ray([f64::NAN, 0.0], 4, 3), None);
}

#[test]
fn the_ray_through_a_projected_point_meets_it() {
    for projection in projections() {
        let camera = camera(projection);
        for point in [DVec3::ZERO, DVec3::new(0.5, -0.25, 1.0), DVec3::new(-2.0, 1.0, -1.0)] {
            let at = camera.project_point(point, 640, 480).unwrap();
            let ray = camera.pick_ray([at.x, at.y], 640, 480).unwrap();
            let along = (point - ray.origin).dot(ray.direction);
            assert!(along > 0.0 && close(ray.origin + ray.direction * along, point, 1e-12), "{projection:?}");
            assert!((ray.direction.length() - 1.0).abs() < 1e-15);
        }
    }
}

#[test]
fn a_parallel_projections_rays_begin_on_the_near_plane() {
    for projection in [projections()[3], projections()[5]] {
        let camera = camera(projection);
        let ray = camera.pick_ray([100.5, 20.5], 640, 480).unwrap();
        let clip = camera.view_projection() * ray.origin.extend(1.0);
        assert!((clip.z - 1.0).abs() < 1e-12);
    }
}

#[test]
fn distance_undoes_depth() {
    for projection in projections() {
        let camera = camera(projection);
        for d in [1.0, 2.5, 7.0, 49.0] {
            let point = camera.position() + camera.direction() * d + camera.right() * 0.3;
            let depth = camera.project_point(point, 8, 8).unwrap().depth;
            // The rounding of the depth to f32, carried back to distances: |dd/dz| · 2⁻²⁴.
            let slope = match projection {
                Projection::Orthographic { near, far, .. } => far - near,
                Projection::OrthographicPlanes(p) => p.far - p.near,
                Projection::Perspective { near, .. } => d * d / near,
                Projection::PerspectivePlanes(p) => d * d / p.near,
            };
            let error = (camera.distance(depth as f32) - d).abs();
            assert!(error <= slope / f64::from(1 << 24) + 1e-12, "{projection:?} {d} {error}");
        }
    }
    assert_eq!(camera(projections()[1]).distance(0.0), f64::INFINITY);
    assert_eq!(camera(projections()[1]).distance(1.0), 0.1);
}

#[test]
fn a_scene_ten_million_units_away_has_the_same_matrices() {
    let offset = DVec3::new(1e7, -1e7, 1e7);
    for projection in projections() {
        let near = camera(projection);
        let mut far = near;
        far.set_position(near.position() + offset).unwrap();
        let placement = Placement::at(DVec3::new(0.5, 0.25, -1.0));
        assert_eq!(near.clip_from_model(&placement), far.clip_from_model(&placement.moved(offset)));
    }
}

#[test]
fn azimuth_goes_round_to_the_right_and_elevation_rises() {
    let mut camera = Camera::new();
    camera.azimuth(FRAC_PI_2, DVec3::ZERO).unwrap();
    assert!(close(camera.position(), DVec3::new(10.0, 0.0, 0.0), 1e-12));
    assert!(close(camera.direction(), DVec3::NEG_X, 1e-15));

    let mut camera = Camera::new();
    camera.elevation(FRAC_PI_4, DVec3::ZERO).unwrap();
    assert!(close(camera.position(), DVec3::new(0.0, 50_f64.sqrt(), 50_f64.sqrt()), 1e-12));
    assert!(close(camera.direction(), -camera.position() / 10.0, 1e-12));
    assert_eq!(camera.view_up(), DVec3::Y);
}

#[test]
fn elevation_goes_over_the_pole_without_a_flip() {
    let focal = DVec3::new(1.0, 2.0, 3.0);
    // Steps that land on the poles exactly, and steps that pass them by.
    for (step, count) in [(10_f64, 36), (7.2, 50), (100.0, 18)] {
        let step = step.to_radians();
        let mut camera = Camera::new();
        camera.set_position(focal + DVec3::new(0.0, 0.0, 10.0)).unwrap();
        for _ in 0..count {
            let (right, up) = (camera.right(), camera.up());
            camera.elevation(step, focal).unwrap();
            assert!(close(camera.right(), right, 1e-9));
            assert!((camera.up().dot(up) - step.cos()).abs() < 1e-9);
        }
        assert!(close(camera.position(), focal + DVec3::new(0.0, 0.0, 10.0), 1e-9));
        assert!(close(camera.up(), DVec3::Y, 1e-9));
    }
    let mut camera = Camera::new();
    camera.elevation(2.0, focal).unwrap();
    assert_eq!(camera.view_up(), DVec3::NEG_Y, "standing on its head");
}

/// The greatest |x/w| and |y/w| of the box's corners, and whether all lie between near and far.
fn extent(camera: &Camera, bounds: &Bounds) -> (f64, bool) {
    let lens = camera.projection_matrix();
    let clip = bounds
        .corners()
        .map(|corner| -> DVec4 { lens * camera.basis().to_camera(corner - camera.position()).extend(1.0) });
    let reach = clip.iter().map(|p| (p.x / p.w).abs().max((p.y / p.w).abs())).fold(0.0, f64::max);
    (reach, clip.iter().all(|p| p.w > 0.0 && 0.0 < p.z && p.z < p.w))
}

#[test]
fn a_framed_box_touches_the_margin_whatever_its_size() {
    for projection in projections() {
        for size in [1e-6, 1.0, 1e7] {
            for center in [DVec3::ZERO, DVec3::new(3.0, -2.0, 1.0) * size * 1e3] {
                for to_eye in [DVec3::new(1.0, 0.7, 1.0), DVec3::Z, DVec3::NEG_Y] {
                    let half = DVec3::new(0.5, 0.1, 0.3) * size;
                    let bounds = Bounds::new(center - half, center + half);
                    let mut camera = camera(projection);
                    camera.frame(&bounds, to_eye, DVec3::Y, 0.05).unwrap();
                    let (reach, between) = extent(&camera, &bounds);
                    let what = format!("{projection:?} {size} {to_eye} {reach}");
                    assert!((reach - 0.9).abs() < 1e-9 && between, "{what}");
                    assert!(close(camera.direction(), -to_eye.normalize(), 1e-12), "{what}");
                }
            }
        }
    }
}

#[test]
fn boxes_without_extent_are_framed_too() {
    let point = DVec3::new(1e7, 2.0, -3.0);
    let line = Bounds::new(DVec3::ZERO, DVec3::new(0.0, 0.0, 5.0));
    for projection in projections() {
        for (bounds, at) in
            [(Bounds::EMPTY, DVec3::ZERO), (Bounds::new(point, point), point), (line, line.center().unwrap())]
        {
            let mut camera = camera(projection);
            camera.frame(&bounds, DVec3::Z, DVec3::Y, 0.05).unwrap();
            let seen = camera.project_point(at, 400, 300);
            assert!(seen.is_some(), "{projection:?} {bounds:?}");
            if !bounds.is_empty() {
                assert!(extent(&camera, &bounds).1, "{projection:?} {bounds:?}");
            }
        }
    }
}

#[test]
fn a_window_beside_the_axis_cannot_frame() {
    let beside = Planes { left: 1.0, right: 2.0, bottom: -1.0, top: 1.0, near: 1.0, far: 2.0 };
    let mut camera = camera(Projection::PerspectivePlanes(beside));
    let before = camera;
    let cube = Bounds::new(DVec3::ZERO, DVec3::ONE);
    assert_eq!(camera.frame(&cube, DVec3::Z, DVec3::Y, 0.05), Err(CameraError::Frame));
    assert_eq!(camera, before);
}

fn any_vector() -> impl Strategy<Value = DVec3> {
    let special =
        prop::sample::select(vec![0.0, -0.0, 1.0, f64::NAN, f64::INFINITY, f64::MAX, 5e-324, 1e-200]);
    let number = prop_oneof![3 => -10.0..10.0, 1 => special];
    [number.clone(), number.clone(), number].prop_map(DVec3::from_array)
}

proptest! {
    #[test]
    fn no_input_makes_a_matrix_that_is_not_finite(
        direction in any_vector(), up in any_vector(), focal in any_vector(), angle in -1e3..1e3,
        a in any_vector(), b in any_vector(), kind in 0_usize..6, margin in -0.1..0.6,
    ) {
        let mut camera = camera(projections()[kind]);
        let _ = camera.set_direction(direction);
        let _ = camera.set_view_up(up);
        let _ = camera.azimuth(angle, focal);
        let _ = camera.elevation(angle, focal);
        let _ = camera.frame(&Bounds::new(a, b), direction, up, margin);
        prop_assert!(camera.projection_matrix().is_finite());
        let turn = camera.basis().rotation();
        prop_assert!((turn * turn.transpose()).abs_diff_eq(DMat4::IDENTITY, 1e-14));
        prop_assert!(camera.position().is_finite());
        let _ = camera.project_point(focal, 640, 480);
        let _ = camera.pick_ray([a.x, a.y], 640, 480);
    }

    #[test]
    fn a_ray_projects_back_to_its_pixel(
        x in -100.0..740.0, y in -100.0..580.0, along in 0.01..1.0, kind in 0_usize..6,
    ) {
        let camera = camera(projections()[kind]);
        let ray = camera.pick_ray([x, y], 640, 480).unwrap();
        let begin = camera.distance(1.0);
        let axis = ray.direction.dot(camera.direction());
        // A point inside the view volume: a little behind the near plane.
        let further = if camera.projection().is_parallel() { 0.0 } else { begin };
        let point = ray.origin + ray.direction * ((further + along) / axis);
        let at = camera.project_point(point, 640, 480).unwrap();
        prop_assert!((at.x - x).abs() < 1e-8 && (at.y - y).abs() < 1e-8, "{at:?}");
    }
}

#[test]
fn framed_points_touch_the_margin_on_opposite_sides() {
    let points =
        (0..40).map(|k| DVec3::new(f64::from(k % 7) * 3.0, f64::from(k % 5), f64::from(k % 11) * 2.0 - 5.0));
    for projection in
        [Camera::new().projection(), Projection::Orthographic { height: 1.0, near: 0.1, far: 9.0 }]
    {
        for to_eye in [DVec3::new(1.0, 0.7, 1.0), DVec3::Z, DVec3::new(-3.0, 0.2, 0.1)] {
            let mut camera = Camera::new();
            camera.set_projection(projection).unwrap();
            camera.frame_points(points.clone(), to_eye, DVec3::Y, 0.05).unwrap();
            let seen = points.clone().map(|point| {
                let clip = camera.view_projection() * point.extend(1.0);
                clip.truncate().truncate() / clip.w
            });
            let (low, high) = seen.fold((DVec2::MAX, DVec2::MIN), |(low, high), p| (low.min(p), high.max(p)));
            assert!(low.min_element() > -0.9 - 1e-9 && high.max_element() < 0.9 + 1e-9, "{low} {high}");
            let touches = |k: usize| low[k] < -0.9 + 1e-9 && high[k] > 0.9 - 1e-9;
            assert!(touches(0) || touches(1), "{low} {high}");
        }
    }
}
