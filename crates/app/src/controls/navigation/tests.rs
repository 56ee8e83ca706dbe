//! Events in, camera and light out: no window.

use core::f64::consts::FRAC_PI_2;
use std::time::Duration;

use polosa_math::Viewport;
use polosa_math::glam::DVec3;
use polosa_scene::{Camera, FieldOfView, Light, LightSpace, Object, Projection, World, shape};
use proptest::prelude::*;

use super::{Navigation, POLE, Stage};
use crate::event::{Button, Event, Handled, Modifiers};
use crate::input::Input;

/// All that an application has.
#[derive(Debug)]
struct Rig {
    world: World,
    camera: Camera,
    light: Light,
    size: [u32; 2],
    scale: f64,
    trackball: bool,
    navigation: Navigation,
    input: Input,
}

impl Rig {
    /// A torus, framed.
    fn new() -> Self {
        let mut world = World::new();
        let mesh = world.add_mesh(shape::torus(24, 12).unwrap());
        world.add(Object::new(mesh)).unwrap();
        let mut camera = Camera::new();
        camera.frame(&world.bounds(), DVec3::new(1.0, 0.7, 1.0), DVec3::Y, 0.05).unwrap();
        Self {
            world,
            camera,
            light: Light::default(),
            size: [400, 300],
            scale: 1.0,
            trackball: false,
            navigation: Navigation::default(),
            input: Input::default(),
        }
    }

    fn parallel(mut self) -> Self {
        let lens = Projection::Orthographic { height: 3.0, near: 0.1, far: 100.0 };
        self.camera.set_projection(lens).unwrap();
        self
    }

    fn with<R>(&mut self, act: impl FnOnce(&mut Navigation, &Input, &mut Stage<'_>) -> R) -> R {
        let mut stage = Stage {
            world: &self.world,
            camera: &mut self.camera,
            light: &mut self.light,
            size: self.size,
            scale: self.scale,
            trackball: self.trackball,
        };
        act(&mut self.navigation, &self.input, &mut stage)
    }

    fn feed(&mut self, event: &Event) -> Handled {
        self.input.take(event, Duration::ZERO);
        if let Event::Resize { size, scale } = *event {
            (self.size, self.scale) = (size, scale);
        }
        self.with(|navigation, input, stage| navigation.event(event, input, stage))
    }

    fn press(&mut self, button: Button, at: [f64; 2]) -> Handled {
        self.feed(&Event::Button { button, pressed: true, at })
    }

    fn release(&mut self, button: Button, at: [f64; 2]) -> Handled {
        self.feed(&Event::Button { button, pressed: false, at })
    }

    fn to(&mut self, at: [f64; 2]) -> Handled {
        self.feed(&Event::Motion { at })
    }

    fn drag(&mut self, button: Button, from: [f64; 2], to: [f64; 2]) {
        self.press(button, from);
        self.to(to);
        self.release(button, to);
    }

    fn wheel(&mut self, notches: f64, at: [f64; 2]) {
        self.feed(&Event::Wheel { notches, at });
    }

    /// The pixel of a point, whatever near and far plane say.
    fn pixel(&self, point: DVec3) -> [f64; 2] {
        let at = self.camera.projection_matrix()
            * self.camera.basis().to_camera(point - self.camera.position()).extend(1.0);
        Viewport::new(self.size[0], self.size[1]).to_pixels(at.x, at.y, at.w)
    }

    fn under(&mut self, at: [f64; 2]) -> DVec3 {
        self.with(|navigation, _, stage| navigation.aim(stage, at)).unwrap()
    }
}

fn apart(a: [f64; 2], b: [f64; 2]) -> f64 {
    libm::hypot(a[0] - b[0], a[1] - b[1])
}

/// Random cameras around the torus, of both projections.
fn rig() -> impl Strategy<Value = Rig> {
    let place = prop::array::uniform3(-6.0..6.0_f64);
    let toward = prop::array::uniform3(-0.7..0.7_f64);
    (place, toward, 0.3..2.0_f64, any::<(bool, bool)>()).prop_filter_map(
        "somewhere to look at",
        |(place, toward, size, (parallel, trackball))| {
            let mut rig = Rig { trackball, ..Rig::new() };
            rig.camera.set_position(DVec3::from_array(place)).ok()?;
            rig.camera.look_at(DVec3::from_array(toward)).ok()?;
            rig.camera
                .set_projection(if parallel {
                    Projection::Orthographic { height: 2.0 * size, near: 0.1, far: 99.0 }
                } else {
                    let fov = FieldOfView::Vertical(size);
                    Projection::Perspective { fov, near: 0.1, far: f64::INFINITY }
                })
                .ok()?;
            Some(rig)
        },
    )
}

fn place() -> impl Strategy<Value = [f64; 2]> {
    (-50.0..450.0_f64, -50.0..350.0_f64).prop_map(|(x, y)| [x, y])
}

proptest! {
    #[test]
    fn the_point_that_was_pressed_stays_under_the_pointer_while_panning(
        mut rig in rig(),
        path in prop::collection::vec(place(), 2..6),
        shift in any::<bool>(),
    ) {
        let point = rig.under(path[0]);
        let pivot = rig.pixel(rig.navigation.pivot());
        let button = if shift { Button::Left } else { Button::Middle };
        rig.feed(&Event::Modifiers(Modifiers { shift, ..Modifiers::NONE }));
        rig.press(button, path[0]);
        for at in &path {
            rig.to(*at);
            prop_assert!(apart(rig.pixel(point), *at) < 1e-9, "{:?} instead of {at:?}", rig.pixel(point));
        }
        rig.release(button, path[path.len() - 1]);
        let in_front = (rig.navigation.pivot() - rig.camera.position()).dot(rig.camera.direction()) > 0.1;
        prop_assert!(!in_front || apart(rig.pixel(rig.navigation.pivot()), pivot) < 1e-6, "the pivot goes with it");
        // And back: nothing has been lost on the way.
        let before = rig.camera.position();
        rig.press(button, path[0]);
        rig.to(path[1]);
        rig.release(button, path[0]);
        prop_assert!((rig.camera.position() - before).length() < 1e-9);
    }

    #[test]
    fn the_point_under_the_pointer_stays_there_while_zooming(
        mut rig in rig(),
        at in place(),
        turns in prop::collection::vec(-4.0..4.0_f64, 1..8),
    ) {
        let point = rig.under(at);
        let [eye, height] = [rig.camera.position(), DVec3::Y * rig.camera.projection_matrix().y_axis.y];
        for notches in &turns {
            rig.wheel(*notches, at);
            prop_assert!(apart(rig.pixel(point), at) < 1e-9, "{:?} instead of {at:?}", rig.pixel(point));
        }
        let factor = libm::pow(1.2, -turns.iter().sum::<f64>());
        if rig.camera.projection().is_parallel() {
            let now = rig.camera.projection_matrix().y_axis.y;
            prop_assert!((now * factor / height.y - 1.0).abs() < 1e-9);
        } else {
            let [now, then] = [rig.camera.position(), eye].map(|eye| eye.distance(point));
            prop_assert!((now - then * factor).abs() < 1e-9 * then.max(1.0), "{now} {then} {factor}");
        }
    }

    #[test]
    fn the_pivot_keeps_its_place_in_the_picture_while_orbiting(
        mut rig in rig(),
        pivot in prop::array::uniform3(-1.0..1.0_f64),
        from in place(),
        path in prop::collection::vec(place(), 1..6),
    ) {
        rig.navigation.set_pivot(DVec3::from_array(pivot));
        let seen = rig.camera.basis().to_camera(rig.navigation.pivot() - rig.camera.position());
        let parallel = rig.camera.projection().is_parallel();
        rig.press(Button::Left, from);
        for at in path {
            rig.to(at);
            let now = rig.camera.basis().to_camera(rig.navigation.pivot() - rig.camera.position());
            let off = now - seen;
            prop_assert!(off.truncate().length() < 1e-9 && (parallel || off.z.abs() < 1e-9), "{off}");
            prop_assert!(rig.trackball || rig.camera.right().y.abs() < 1e-6, "the horizon is level");
        }
    }

    #[test]
    fn no_sequence_of_events_makes_a_camera_that_is_no_camera(
        mut rig in rig(),
        steps in prop::collection::vec((0..7_u8, prop::num::f64::ANY, prop::num::f64::ANY), 0..40),
    ) {
        for (what, x, y) in steps {
            let at = if what % 2 == 0 { [x, y] } else { [x % 400.0, y % 300.0] };
            match what {
                0 | 1 => _ = rig.to(at),
                2 => _ = rig.press(Button::Left, at),
                3 => _ = rig.press(Button::Middle, at),
                4 => rig.wheel(x, [10.0, y % 300.0]),
                5 => _ = rig.release(Button::Left, at),
                _ => rig.with(|navigation, _, stage| {
                    navigation.set_pivot(DVec3::new(x, y, x));
                    navigation.orbit_by(stage, x, y);
                    navigation.turn_to(stage, x, y);
                    navigation.dolly(stage, x);
                }),
            }
            prop_assert!(rig.camera.position().is_finite() && rig.camera.direction().is_normalized());
            prop_assert!(rig.camera.projection().matrix(rig.camera.aspect()).is_some());
        }
    }
}

#[test]
fn a_drag_begins_without_a_jump_also_where_the_camera_looks_past_the_pivot_or_is_rolled() {
    for up in [DVec3::Y, DVec3::NEG_Y, DVec3::new(1.0, 2.0, 0.3), DVec3::X] {
        for trackball in [false, true] {
            let mut rig = Rig { trackball, ..Rig::new() };
            rig.navigation.set_pivot(DVec3::new(3.0, -1.0, 0.5));
            rig.camera.set_view_up(up).unwrap();
            let (before, basis) = (rig.camera, rig.camera.basis());
            rig.press(Button::Left, [100.0, 100.0]);
            rig.to([100.0, 100.0]);
            assert_eq!(rig.camera, before, "not even near and far plane");
            rig.to([100.0 + 1e-6, 100.0]);
            assert!((rig.camera.position() - before.position()).length() < 1e-6);
            let turned = rig.camera.basis();
            assert!((turned.up() - basis.up()).length() < 1e-7, "{up}: {} {}", turned.up(), basis.up());
            assert!((turned.back() - basis.back()).length() < 1e-7);
        }
    }
}

#[test]
fn the_scene_follows_the_hand_by_half_a_degree_a_unit_of_the_desktop() {
    for (scale, pixels) in [(1.0, 20.0), (2.0, 40.0)] {
        let mut rig = Rig { scale, ..Rig::new() };
        let [heading, pitch] = rig.navigation.heading_pitch(&rig.camera);
        // The front of the torus, seen from above, goes to the right and down.
        let front = DVec3::new(0.3, 0.0, 0.3);
        let seen = rig.pixel(front);
        rig.drag(Button::Left, [200.0, 150.0], [200.0 + pixels, 150.0 + pixels / 2.0]);
        let [h, p] = rig.navigation.heading_pitch(&rig.camera);
        assert!((heading - h - 10_f64.to_radians()).abs() < 1e-12);
        assert!((pitch - p - 5_f64.to_radians()).abs() < 1e-12);
        let now = rig.pixel(front);
        assert!(now[0] > seen[0] && now[1] > seen[1]);
    }
}

#[test]
fn at_the_poles_the_camera_stops_with_its_heading_and_comes_back() {
    for (down, pole) in [(900.0, -1.0), (-900.0, 1.0)] {
        let mut rig = Rig::new();
        let [heading, _] = rig.navigation.heading_pitch(&rig.camera);
        rig.press(Button::Left, [0.0, 0.0]);
        rig.to([0.0, down]);
        assert!((rig.camera.direction() - DVec3::Y * pole).length() < 2e-9);
        let [h, p] = rig.navigation.heading_pitch(&rig.camera);
        assert!((h - heading).abs() < 1e-6 && (p - pole * POLE).abs() < 1e-12);
        let upward = rig.camera.up();
        rig.to([0.0, down * 1.01]);
        assert!((rig.camera.up() - upward).length() < 1e-6, "the picture stands still there");
        rig.to([0.0, down * 1.01 - 20.0 * down.signum()]);
        let [h, p] = rig.navigation.heading_pitch(&rig.camera);
        let back = pole * (90_f64 - 10.0).to_radians();
        assert!((h - heading).abs() < 1e-6 && (p - back).abs() < 1e-8, "{h} {p}");
    }
}

#[test]
fn a_camera_put_exactly_at_the_pole_goes_on_from_the_picture_that_it_shows() {
    let mut rig = Rig::new();
    rig.camera.set_position(DVec3::new(0.0, 5.0, 0.0)).unwrap();
    rig.camera.set_direction(DVec3::NEG_Y).unwrap();
    let upward = rig.camera.up();
    rig.press(Button::Left, [0.0, 0.0]);
    rig.to([0.0, 1e-3]);
    assert!((rig.camera.up() - upward).length() < 1e-7);
    rig.to([0.0, -60.0]);
    assert!((rig.camera.position() - DVec3::new(0.0, 5.0, 0.0)).length() > 1.0);
    assert!((rig.camera.direction().x).abs() < 1e-9 && rig.camera.direction().z < -0.4);
}

#[test]
fn a_trackball_passes_the_pole_and_comes_round_to_where_it_began() {
    let mut rig = Rig { trackball: true, ..Rig::new() };
    let before = rig.camera;
    rig.press(Button::Left, [0.0, 0.0]);
    let mut least = f64::INFINITY;
    for step in 1..=72 {
        rig.to([0.0, f64::from(step) * 10.0]);
        least = least.min(rig.camera.up().y);
    }
    assert!(least < -0.9, "upside down on the way");
    assert!((rig.camera.position() - before.position()).length() < 1e-9);
    assert!((rig.camera.up() - before.up()).length() < 1e-9);
    // To orbit again from there is no jump either, and to turn to a heading straightens it.
    rig.to([77.0, 400.0]);
    rig.trackball = false;
    let upward = rig.camera.up();
    rig.to([77.0, 400.0 + 1e-6]);
    assert!((rig.camera.up() - upward).length() < 1e-6);
    rig.with(|navigation, _, stage| navigation.turn_to(stage, 1.0, 0.2));
    assert!(rig.camera.right().y.abs() < 1e-12);
}

#[test]
fn a_double_click_moves_the_pivot_and_nothing_else() {
    let mut rig = Rig::new();
    let at = (0..40).map(|k| [f64::from(k) * 10.0, 150.0]).find(|at| {
        let hit = rig.with(|_, _, stage| stage.seen(*at));
        hit.is_some()
    });
    let at = at.expect("the torus is in the picture");
    let before = rig.camera;
    rig.press(Button::Left, at);
    assert_eq!(rig.feed(&Event::DoubleClick { at }), Handled::Yes);
    assert_eq!(rig.camera, before);
    let pivot = rig.navigation.pivot();
    assert!(apart(rig.pixel(pivot), at) < 1e-9);
    // The drag that the second press began goes round the new pivot.
    rig.to([at[0] + 50.0, at[1] + 20.0]);
    assert!(apart(rig.pixel(pivot), at) < 1e-9 && rig.camera.position() != before.position());
    // Beside the torus there is nothing to turn about.
    rig.feed(&Event::DoubleClick { at: [0.5, 0.5] });
    assert_eq!(rig.navigation.pivot(), pivot);
}

#[test]
fn the_light_seems_to_follow_the_hand_whatever_it_is_fixed_to() {
    for space in [LightSpace::Camera, LightSpace::World] {
        let mut rig = Rig::new();
        let before = rig.camera;
        rig.light.space = space;
        rig.light.direction = match space {
            LightSpace::Camera => DVec3::Z * 3.0,
            LightSpace::World => before.basis().back(),
        };
        let seen = |light: &Light| match space {
            LightSpace::Camera => light.direction,
            LightSpace::World => before.basis().to_camera(light.direction),
        };
        rig.drag(Button::Right, [100.0, 100.0], [160.0, 100.0]);
        let expected = DVec3::new(0.5, 0.0, 0.75_f64.sqrt());
        assert!((seen(&rig.light) - expected).length() < 1e-12, "30 degrees to the right");
        rig.drag(Button::Right, [100.0, 100.0], [40.0, 100.0]);
        rig.drag(Button::Right, [100.0, 100.0], [100.0, 160.0]);
        let expected = DVec3::new(0.0, -0.5, 0.75_f64.sqrt());
        assert!((seen(&rig.light) - expected).length() < 1e-12, "and down");
        assert_eq!(rig.camera, before);
    }
    let mut rig = Rig::new();
    rig.light.direction = DVec3::NAN;
    rig.drag(Button::Right, [0.0, 0.0], [180.0, 0.0]);
    assert!(
        (rig.light.direction - DVec3::X).length() < 1e-12,
        "one without a direction begins at the observer"
    );
}

#[test]
fn a_drag_is_what_it_began_as_until_its_own_button_is_released() {
    let mut rig = Rig::new();
    let (camera, light) = (rig.camera, rig.light);
    rig.press(Button::Right, [100.0, 100.0]);
    assert_eq!(rig.press(Button::Left, [100.0, 100.0]), Handled::Yes);
    rig.to([120.0, 110.0]);
    assert_eq!(rig.release(Button::Left, [120.0, 110.0]), Handled::No);
    rig.to([140.0, 110.0]);
    assert!(rig.camera == camera && rig.light != light, "the light alone");
    assert_eq!(rig.release(Button::Right, [140.0, 110.0]), Handled::Yes);
    let light = rig.light;
    rig.press(Button::Left, [0.0, 0.0]);
    rig.feed(&Event::Modifiers(Modifiers::SHIFT));
    rig.to([30.0, 0.0]);
    assert!((rig.camera.position() - camera.position()).length() > 0.1);
    assert!((rig.navigation.pivot(), rig.light) == (DVec3::ZERO, light), "still an orbit");
}

#[test]
fn without_a_button_held_nothing_moves_be_it_released_elsewhere() {
    let mut rig = Rig::new();
    let before = rig.camera;
    assert_eq!(rig.to([10.0, 10.0]), Handled::No);
    rig.press(Button::Left, [10.0, 10.0]);
    rig.feed(&Event::Focus(false));
    assert_eq!(rig.to([60.0, 10.0]), Handled::No);
    rig.press(Button::Left, [10.0, 10.0]);
    // A program kept the release for itself: only the input has heard of it.
    rig.input.take(&Event::Button { button: Button::Left, pressed: false, at: [10.0, 10.0] }, Duration::ZERO);
    assert_eq!(rig.to([90.0, 10.0]), Handled::No);
    assert_eq!(rig.camera, before);
}

#[test]
fn a_resize_during_a_drag_moves_nothing_by_itself_and_the_drag_goes_on() {
    let mut rig = Rig::new();
    let at = [150.0, 120.0];
    let point = rig.under(at);
    rig.press(Button::Middle, at);
    let before = rig.camera;
    rig.feed(&Event::Resize { size: [800, 600], scale: 2.0 });
    assert_eq!(rig.camera, before);
    rig.to([151.0, 120.0]);
    assert!(apart(rig.pixel(point), [151.0, 120.0]) < 1e-9);
}

#[test]
fn near_and_far_plane_fit_after_every_move_and_are_not_touched_before() {
    for mut rig in [Rig::new(), Rig::new().parallel()] {
        let own = match rig.camera.projection() {
            Projection::Perspective { fov, .. } => Projection::Perspective { fov, near: 1e-5, far: 1e5 },
            Projection::Orthographic { height, .. } => {
                Projection::Orthographic { height, near: -1e5, far: 1e5 }
            }
            other => other,
        };
        rig.camera.set_projection(own).unwrap();
        rig.press(Button::Left, [100.0, 100.0]);
        assert_eq!(rig.camera.projection(), own);
        rig.to([300.0, 120.0]);
        rig.release(Button::Left, [300.0, 120.0]);
        let corners = rig.world.bounds().corners();
        let whole = |rig: &Rig| corners.iter().all(|c| rig.camera.project_point(*c, 400, 300).is_some());
        assert!(rig.camera.projection() != own && whole(&rig));
        for _ in 0..40 {
            rig.wheel(-1.0, [200.0, 150.0]);
            assert!(whole(&rig));
        }
        for _ in 0..40 {
            rig.wheel(1.0, [150.0, 150.0]);
        }
        if rig.camera.projection().is_parallel() {
            rig.drag(Button::Left, [0.0, 0.0], [180.0, 0.0]);
            assert!(whole(&rig), "nothing is behind the eye of a parallel projection");
        }
    }
}

#[test]
fn zooming_ends_before_numbers_do_and_the_way_back_is_open() {
    for mut rig in [Rig::new(), Rig::new().parallel()] {
        for notches in [1e4, -1e4, 700.0, -2e9, 3.0] {
            for at in [[200.0, 150.0], [130.0, 120.0]] {
                let point = rig.under(at);
                rig.wheel(notches, at);
                assert!(apart(rig.pixel(point), at) < 1e-6, "{notches}");
                assert!(rig.world.bounds().diagonal() / rig.camera.position().length() > 1e-6);
            }
        }
        let before = rig.camera;
        rig.wheel(1.0, [200.0, 150.0]);
        assert_ne!(rig.camera, before);
    }
}

#[test]
fn notches_in_pieces_are_notches() {
    let mut rig = Rig::new();
    rig.wheel(2.0, [100.0, 77.0]);
    let whole = rig.camera;
    let mut rig = Rig::new();
    for _ in 0..8 {
        rig.wheel(0.25, [100.0, 77.0]);
    }
    assert!((rig.camera.position() - whole.position()).length() < 1e-12);
}

#[test]
fn with_another_axis_upward_the_same_drag_shows_the_same() {
    let mut flat = Rig::new();
    let mut tall = Rig::new();
    tall.world.clear();
    let mesh = tall.world.add_mesh(shape::torus(24, 12).unwrap());
    let turn = polosa_math::axis_angle(DVec3::X, FRAC_PI_2).unwrap();
    let key = tall.world.add(Object::new(mesh)).unwrap();
    tall.world.turn(key, turn).unwrap();
    tall.navigation.set_up(DVec3::Z);
    for rig in [&mut flat, &mut tall] {
        rig.with(|navigation, _, stage| navigation.turn_to(stage, 0.3, -0.4));
    }
    let to_eye = tall.navigation.upright(flat.camera.position());
    tall.camera.set_position(to_eye).unwrap();
    for rig in [&mut flat, &mut tall] {
        rig.drag(Button::Left, [50.0, 50.0], [170.0, 20.0]);
        rig.wheel(2.0, [180.0, 170.0]);
    }
    for (x, y, z) in [(1.0, 0.2, 0.3), (-0.4, 0.1, 0.9)] {
        let apart = apart(flat.pixel(DVec3::new(x, y, z)), tall.pixel(DVec3::new(x, -z, y)));
        assert!(apart < 1e-6, "{apart}");
    }
}
