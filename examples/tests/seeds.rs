//! Claim: the five seeds start as they did, and do what they did when they are dragged and keys are struck. Facts are
//! from the seeds' own formulas, written out here once more.

#[expect(dead_code, reason = "its `main` opens a window")]
#[path = "../hue_sphere.rs"]
mod hue_sphere;
#[expect(dead_code, reason = "its `main` opens a window")]
#[path = "../mouse_tetrahedron.rs"]
mod mouse_tetrahedron;
#[expect(dead_code, reason = "its `main` opens a window")]
#[path = "../scene/main.rs"]
mod scene;
#[expect(dead_code, reason = "its `main` opens a window")]
#[path = "../tetrahedron.rs"]
mod tetrahedron;
#[expect(dead_code, reason = "its `main` opens a window")]
#[path = "../view_cube.rs"]
mod view_cube;

use std::f64::consts::PI;

use polosa::event::{Button, Event, Key};
use polosa::{Application, Program};
use polosa_math::glam::DVec3;
use polosa_scene::reference::hue;
use polosa_scene::{Picture, WorldError};

const BLACK: u32 = 0;
const WHITE: u32 = 0xff_ffff;
const RED: u32 = 0xff_0000;
const GREEN: u32 = 0x00_ff00;
const BLUE: u32 = 0x00_00ff;

/// What is on show after events, and one step.
fn shown(app: &mut Application, program: &mut impl Program, events: &[Event]) -> Picture {
    events.iter().for_each(|event| app.send(event.clone()));
    let mut last = None;
    let done = app.run_headless(1, program, |_, picture| {
        last = Some(picture.clone());
        Ok(())
    });
    done.unwrap();
    last.unwrap()
}

fn key(key: Key) -> Event {
    Event::Key { key, pressed: true, repeat: false }
}

/// Keys struck one after the other.
fn keys(text: &str) -> Vec<Event> {
    text.chars().map(|sign| key(if sign == ' ' { Key::Space } else { Key::Char(sign) })).collect()
}

/// A drag with a button.
fn drag(button: Button, from: [f64; 2], to: [f64; 2]) -> Vec<Event> {
    let press = |pressed, at| Event::Button { button, pressed, at };
    vec![press(true, from), Event::Motion { at: to }, press(false, to)]
}

fn at(picture: &Picture, x: usize, y: usize) -> u32 {
    picture.pixels[y * picture.width as usize + x]
}

/// How many pixels differ, sliders and the text above left aside.
fn differing(a: &Picture, b: &Picture) -> usize {
    let width = a.width as usize;
    (40..360)
        .flat_map(|y| (20..360).map(move |x| y * width + x))
        .filter(|k| a.pixels[*k] != b.pixels[*k])
        .count()
}

/// `(int)((c^e·s)^(1/e))` for channels of 255 and of 0.
fn power(color: u32, cosine: f64, exponent: f64) -> u32 {
    let code = (255_f64.powf(exponent) * cosine).powf(1.0 / exponent) as u32;
    color / 255 * code
}

#[test]
fn tetrahedron_starts_as_wire_on_black_with_both_sliders() {
    let (mut app, mut program) = tetrahedron::new().unwrap();
    let start = shown(&mut app, &mut program, &[]);
    assert_eq!((start.width, start.height), (400, 400));
    // At 180° of heading x and z change signs: P (100, 100, 100) comes to (−100, 100, −100), R to (100, 100, 100).
    // All four corners are those of a square, with both diagonals.
    for (x, y) in [(100, 150), (150, 100), (299, 150), (150, 300), (150, 150), (250, 150)] {
        let near = (0..=1).any(|dx| (0..=1).any(|dy| at(&start, x + dx, y + dy) == WHITE));
        assert!(near, "a side passes ({x}, {y})");
    }
    assert_eq!(at(&start, 200, 130), BLACK, "wire is empty");
    assert!((0..400).any(|x| at(&start, x, 382) == WHITE), "the knob of the slider below");
    assert!((0..364).any(|y| at(&start, 382, y) == WHITE), "the knob of the slider at the side");
}

#[test]
fn tetrahedron_goes_through_its_stages() {
    let (mut app, mut program) = tetrahedron::new().unwrap();
    shown(&mut app, &mut program, &[]);
    let stages: Vec<Picture> = (0..6).map(|_| shown(&mut app, &mut program, &keys(" "))).collect();
    let [ordered, hidden, naive, power24, inflated, wire] = &stages[..] else { panic!("six") };

    // At 180° the two that face the observer are green RSP, below left, and blue RSQ, above right.
    for picture in [ordered, hidden] {
        assert_eq!((at(picture, 150, 250), at(picture, 250, 150)), (GREEN, BLUE));
    }
    // Each face has the cosine 1/√3 to the observer.
    let cosine = (1.0_f64 / 3.0).sqrt();
    let dark = (255.0 * cosine) as u32;
    assert_eq!((at(naive, 150, 250), at(naive, 250, 150)), (dark << 8, dark));
    assert_eq!(at(power24, 150, 250), power(GREEN, cosine, 2.4));
    assert_eq!(at(power24, 250, 150), power(BLUE, cosine, 2.4));

    // Inflated, it reaches √30000 from the middle, nearly: corners do.
    let reach = |x: usize, y: usize| ((x as f64 - 200.0).powi(2) + (y as f64 - 200.0).powi(2)).sqrt();
    let colored = |x: usize, y: usize| at(inflated, x, y) != BLACK;
    let inside = (40..360).flat_map(|y| (20..360).map(move |x| (x, y)));
    for (x, y) in inside {
        let reach = reach(x, y);
        assert!(reach > 165.0 || colored(x, y), "({x}, {y}) is inside");
        assert!(reach < 30_000_f64.sqrt() || !colored(x, y), "({x}, {y}) is outside");
    }
    assert_eq!(at(wire, 200, 130), BLACK, "and wire again");
}

#[test]
fn tetrahedron_in_the_lists_order_has_blue_on_top_at_any_angle() {
    let (mut app, mut program) = tetrahedron::new().unwrap();
    // The slider below, dragged to its very left: heading 0, where white PQR and red PQS face the observer.
    let mut events = drag(Button::Left, [200.0, 382.0], [0.0, 382.0]);
    events.extend(keys(" "));
    let ordered = shown(&mut app, &mut program, &events);
    let hidden = shown(&mut app, &mut program, &keys(" "));
    // Blue, RSQ, is the half above the diagonal from Q to P, far behind; green, RSP, the half below right.
    let colors = |x, y| [&ordered, &hidden].map(|picture| at(picture, x, y));
    let seen: Vec<u32> =
        [(150, 250), (250, 150), (200, 120), (120, 200)].map(|(x, y)| colors(x, y)[1]).to_vec();
    assert!(seen.iter().all(|color| [WHITE, RED].contains(color)), "{seen:x?}");
    for (x, y) in [(150, 250), (250, 150), (200, 120), (120, 200)] {
        assert!([BLUE, GREEN].contains(&colors(x, y)[0]), "what is last in the list is on top");
    }
}

#[test]
fn white_and_green_are_wound_inward_red_and_blue_outward() {
    let mesh = polosa_scene::shape::seed_tetrahedron(0).unwrap();
    let outward = mesh.triangles().iter().map(|triangle| {
        let [a, b, c] = triangle.map(|k| DVec3::from_array(mesh.positions()[k as usize].map(f64::from)));
        (b - a).cross(c - a).dot(a + b + c) > 0.0
    });
    assert_eq!(outward.collect::<Vec<_>>(), [false, true, false, true]);
}

#[test]
fn polosas_own_tetrahedron_is_the_seeds_but_for_the_rims() {
    for (strikes, allowed) in [("  ", 900), ("    ", 900), ("     ", 2500)] {
        let (mut app, mut program) = tetrahedron::new().unwrap();
        let mut events = drag(Button::Left, [200.0, 382.0], [130.0, 382.0]);
        events.extend(drag(Button::Left, [382.0, 170.0], [382.0, 120.0]));
        events.extend(keys(strikes));
        let seed = shown(&mut app, &mut program, &events);
        let exact = shown(&mut app, &mut program, &keys("e"));
        // The shade of 2.4 is not sRGB's curve, which is up to 13 codes away: faces are compared, not codes.
        let face = |color: u32| [16, 8, 0].map(|shift| (color >> shift & 0xff) > 24);
        let differing = (40..360).flat_map(|y| (20..360).map(move |x| (x, y)));
        let differing = differing.filter(|&(x, y)| face(at(&seed, x, y)) != face(at(&exact, x, y))).count();
        assert!(differing < allowed, "{differing} pixels");
        assert!(exact.stats.triangles.drawn > 0 && seed.stats.triangles.drawn == 0);
    }
}

#[test]
fn each_change_of_a_slider_is_drawn_and_only_whole_degrees_count() {
    let (mut app, mut program) = tetrahedron::new().unwrap();
    let start = shown(&mut app, &mut program, &keys("  "));
    let pitched = shown(&mut app, &mut program, &drag(Button::Left, [382.0, 180.0], [382.0, 100.0]));
    assert!(differing(&start, &pitched) > 1000);
    let headed = shown(&mut app, &mut program, &drag(Button::Left, [200.0, 382.0], [90.0, 382.0]));
    assert!(differing(&pitched, &headed) > 1000);
    let same = shown(&mut app, &mut program, &drag(Button::Left, [90.0, 382.0], [90.01, 382.0]));
    assert_eq!(differing(&headed, &same), 0);
}

/// S1's formulas for a corner of the cube, `angle` turned, in 400×300 pixels.
fn s1_pixel(corner: DVec3, angle: f64) -> [f64; 2] {
    let (sin, cos) = (-angle).sin_cos();
    let p = DVec3::new(cos * corner.x + sin * corner.z, corner.y, cos * corner.z - sin * corner.x);
    let (location, up) = (DVec3::new(3.0, 4.0, 8.0), DVec3::Y);
    let direction = -location / location.length();
    let u = direction.cross(up);
    let v = u.cross(direction);
    let (x, y, z) = (u.dot(p - location), v.dot(p - location), -direction.dot(p - location));
    let m00 = 1.0 / 35_f64.to_radians().tan();
    let w = -z;
    [200.0 + 200.0 * m00 * x / w, 150.0 - 150.0 * m00 * (4.0 / 3.0) * y / w]
}

#[test]
fn view_cube_has_its_corners_where_the_formulas_say_at_half_a_turn_a_second() {
    let (mut app, mut program) = view_cube::new().unwrap();
    let mut frames = Vec::new();
    app.run_headless(30, &mut program, |_, picture| {
        frames.push(picture.clone());
        Ok(())
    })
    .unwrap();
    assert!(
        (program.angle - PI / 2.0).abs() < 1e-6,
        "30 frames of a 60th of a second are a quarter of a turn"
    );
    assert_eq!((frames[0].width, frames[0].height), (400, 300));
    for (number, frame) in frames.iter().enumerate() {
        let angle = (number + 1) as f64 / 60.0 * PI;
        for k in 0..8 {
            let corner = [0, 1, 2].map(|axis| if k >> axis & 1 == 1 { 1.0 } else { -1.0 });
            let [x, y] = s1_pixel(DVec3::from_array(corner), angle);
            assert!((0..2).all(|_| at(frame, x as usize, y as usize) == WHITE), "{number}: ({x}, {y})");
        }
    }
}

#[test]
fn the_three_perspectives_agree_and_the_parallel_ones_do_not() {
    let picture = |strikes: &str| {
        let (mut app, mut program) = view_cube::new().unwrap();
        app.settings.show_rate = false;
        shown(&mut app, &mut program, &keys(strikes))
    };
    let cube = |picture: &Picture| picture.pixels[..400 * 250].to_vec();
    for exact in ["", "e"] {
        let [fov, planes, infinite, parallel, half] =
            ["", "p", "pp", "ppp", "pppp"].map(|strikes| cube(&picture(&format!("{strikes}{exact}"))));
        assert!(fov.contains(&WHITE));
        assert!(planes == fov && infinite == fov, "one picture in three ways {exact}");
        assert!(parallel != fov && half != parallel && half.contains(&WHITE));
    }
    // Culled, what is behind is gone: by the seed's areas and by polosa's hidden lines.
    for exact in ["", "e"] {
        let count = |strikes: &str| cube(&picture(strikes)).iter().filter(|pixel| **pixel == WHITE).count();
        assert!(count(&format!("c{exact}")) < count(exact) * 3 / 4);
    }
}

#[test]
fn text_is_drawn_over_what_is_3d_and_the_rate_is_shown() {
    let (mut app, mut program) = view_cube::new().unwrap();
    assert!(app.settings.show_rate && app.settings.frame_rate == 60.0);
    let with = shown(&mut app, &mut program, &keys("pppp"));
    app.settings.show_rate = false;
    let without = shown(&mut app, &mut program, &[]);
    let above = |picture: &Picture| {
        (6..20).map(|y| (6..60).filter(|x| at(picture, *x, y) == WHITE).count()).sum::<usize>()
    };
    assert!(above(&with) > above(&without));
}

#[test]
fn hue_sphere_has_a_silhouette_of_200_pixels_and_nothing_of_it_is_black_without_light() {
    let (mut app, mut program) = hue_sphere::new().unwrap();
    let unlit = shown(&mut app, &mut program, &keys("l"));
    assert_eq!((unlit.width, unlit.height), (640, 480));
    for (y, row) in unlit.pixels.chunks(640).enumerate() {
        for (x, pixel) in row.iter().enumerate() {
            let reach = (x as f64 + 0.5 - 320.0).hypot(y as f64 + 0.5 - 240.0);
            assert!(reach <= 200.0 || *pixel == BLACK, "({x}, {y}) is outside");
            assert!(reach >= 190.0 || *pixel != BLACK, "({x}, {y}) is inside");
        }
    }
    let middle = at(&unlit, 320, 240);
    let brightest = [16, 8, 0].map(|shift| middle >> shift & 0xff).into_iter().max();
    assert!(brightest >= Some(253), "n·Z is 1 in the middle: {middle:06x}");
}

#[test]
fn hue_sphere_is_colored_by_the_seeds_longitude_and_lit_from_its_direction() {
    // Twice π/4 about x, y and z, as matrices on columns.
    let (c, s) = (0.5_f64.sqrt(), 0.5_f64.sqrt());
    let about = [
        |c: f64, s: f64, p: DVec3| DVec3::new(p.x, c * p.y - s * p.z, s * p.y + c * p.z),
        |c: f64, s: f64, p: DVec3| DVec3::new(c * p.x + s * p.z, p.y, c * p.z - s * p.x),
        |c: f64, s: f64, p: DVec3| DVec3::new(c * p.x - s * p.y, s * p.x + c * p.y, p.z),
    ];
    let back = |p: DVec3| (0..6).rev().fold(p, |p, k| about[k % 3](c, -s, p));
    let (mut app, mut program) = hue_sphere::new().unwrap();
    let third = (1.0_f64 / 3.0).sqrt();
    assert!((program.light - DVec3::new(third, -third, third)).length() < 1e-12);
    let lit = shown(&mut app, &mut program, &[]);
    for (x, y) in [(320, 240), (400, 200), (380, 150), (300, 120), (450, 240), (340, 300)] {
        let (dx, dy) = ((x as f64 + 0.5 - 320.0) / 200.0, (y as f64 + 0.5 - 240.0) / 200.0);
        let p = DVec3::new(dx, dy, (1.0 - dx * dx - dy * dy).sqrt());
        let degrees = hue::pseudo_longitude(back(p).to_array());
        let expected = hue::from_hsv(degrees, 1.0, p.dot(program.light).max(0.0)).to_u32();
        let got = at(&lit, x, y);
        // A triangle is 9 pixels wide, and has one colour.
        let near = [16, 8, 0].iter().all(|k| (got >> k & 0xff).abs_diff(expected >> k & 0xff) <= 24);
        assert!(near, "({x}, {y}): {got:06x}, not {expected:06x}");
    }
    assert_eq!(at(&lit, 200, 300), BLACK, "turned away from the light");
}

#[test]
fn sixty_pixels_turn_the_sphere_or_the_light_by_sixty_degrees() {
    let (mut app, mut program) = hue_sphere::new().unwrap();
    shown(&mut app, &mut program, &drag(Button::Left, [300.0, 200.0], [360.0, 200.0]));
    let [x, y, _] = program.axes();
    let (sin, cos) = 60_f64.to_radians().sin_cos();
    assert!((x - DVec3::new(cos, 0.0, sin)).length() < 1e-6, "X ← X cos 60° + Z sin 60°: {x}");
    assert!((y - DVec3::Y).length() < 1e-6);
    let light = program.light;
    shown(&mut app, &mut program, &drag(Button::Left, [300.0, 200.0], [300.0, 170.0]));
    let [_, turned, z] = program.axes();
    assert!((turned.dot(y) - 30_f64.to_radians().cos()).abs() < 1e-6, "then Y by −30° towards Z");
    assert_eq!(program.light, light, "the light stays in the world");

    let (mut app, mut program) = hue_sphere::new().unwrap();
    shown(&mut app, &mut program, &drag(Button::Right, [300.0, 200.0], [360.0, 200.0]));
    let l = (1.0_f64 / 3.0).sqrt();
    let expected = DVec3::new(cos * l + sin * l, -l, cos * l - sin * l);
    assert!((program.light - expected).length() < 1e-9, "in the plane of Z and X, its Y part kept");
    assert!(program.axes()[2] == DVec3::Z && z != DVec3::Z, "the sphere stays");
}

#[test]
fn saturation_follows_the_keys_and_escape_ends() {
    let (mut app, mut program) = hue_sphere::new().unwrap();
    let full = shown(&mut app, &mut program, &keys("l"));
    let grey = shown(&mut app, &mut program, &vec![key(Key::Down); 25]);
    assert_eq!(program.saturation, 0.0);
    assert!(grey.pixels.iter().all(|pixel| pixel >> 16 == pixel & 0xff && pixel >> 8 & 0xff == pixel & 0xff));
    let again = shown(&mut app, &mut program, &vec![key(Key::Up); 25]);
    assert_eq!(again.pixels, full.pixels);
    let longitude = shown(&mut app, &mut program, &keys("t"));
    assert_ne!(longitude.pixels, full.pixels);
    app.send(key(Key::Escape));
    app.run_headless(1, &mut program, |_, _| panic!("a frame after the end")).unwrap();
    assert!(app.is_quitting());
}

#[test]
fn mouse_tetrahedron_starts_with_white_and_red_before_the_observer() {
    let (mut app, mut program) = mouse_tetrahedron::new().unwrap();
    let start = shown(&mut app, &mut program, &[]);
    assert_eq!((start.width, start.height), (600, 600));
    let cosine = (1.0_f64 / 3.0).sqrt();
    // Not turned: P is below right, nearest with Q above left; R below left, S above right.
    assert_eq!(at(&start, 250, 350), power(WHITE, cosine, 2.2));
    assert_eq!(at(&start, 350, 250), power(RED, cosine, 2.2));
    assert_eq!(at(&start, 199, 300), BLACK);
    assert_eq!(at(&start, 401, 300), BLACK);
}

#[test]
fn mouse_tetrahedron_jumps_to_the_pointers_place_and_only_while_the_button_is_down() {
    let (mut app, mut program) = mouse_tetrahedron::new().unwrap();
    let start = shown(&mut app, &mut program, &[]);
    let moved = shown(&mut app, &mut program, &[Event::Motion { at: [500.0, 100.0] }]);
    assert_eq!(moved.pixels, start.pixels, "without the button nothing turns");
    // x·180/600 = 90 at 300, and the pitch −45 at 150.
    let touch = |at| [Event::Button { button: Button::Left, pressed: true, at }];
    let touched = shown(&mut app, &mut program, &touch([300.0, 150.0]));
    assert_ne!(touched.pixels, start.pixels, "a touch alone is a jump");
    let same = shown(&mut app, &mut program, &[Event::Motion { at: [303.0, 153.0] }]);
    assert_eq!(same.pixels, touched.pixels, "whole degrees: 303 pixels are 90 still");
    let turned = shown(&mut app, &mut program, &[Event::Motion { at: [304.0, 150.0] }]);
    assert_ne!(turned.pixels, touched.pixels, "and 304 are 91");
}

#[test]
fn mouse_tetrahedron_is_split_by_face_and_agrees_with_polosas_picture() {
    let (mut app, mut program) = mouse_tetrahedron::new().unwrap();
    let pictures = ["1", "2", "3", "4"].map(|strike| shown(&mut app, &mut program, &keys(strike)));
    let reach = |picture: &Picture| {
        let far = |k: usize| ((k % 600) as f64 - 300.0).hypot((k / 600) as f64 - 300.0);
        (0..360_000).filter(|k| picture.pixels[*k] != BLACK).map(far).fold(0.0, f64::max)
    };
    let edge = 20_000_f64.sqrt();
    assert!((reach(&pictures[0]) - edge).abs() < 2.0, "a corner of the square, {}", reach(&pictures[0]));
    for picture in &pictures[1..] {
        assert!((reach(picture) - 30_000_f64.sqrt()).abs() < 4.0, "a sphere's, {}", reach(picture));
    }
    // One face is round and red is flat still; then all are round.
    assert_eq!(at(&pictures[1], 350, 250), at(&pictures[0], 350, 250));
    assert_ne!(at(&pictures[2], 350, 250), at(&pictures[0], 350, 250));
    assert_ne!(pictures[3].pixels, pictures[2].pixels);
    for (strike, seed) in ["1e", "2", "3", "4"].iter().zip(&pictures) {
        let exact = shown(&mut app, &mut program, &keys(strike));
        let dominant = |color: u32| [16, 8, 0].map(|shift| (color >> shift & 0xff) > 24);
        let differ = (0..360_000).filter(|k| dominant(seed.pixels[*k]) != dominant(exact.pixels[*k])).count();
        assert!(differ < 2500, "{strike}: {differ} pixels");
    }
}

/// A world, and steps of its loop without a window.
fn stepped(app: &mut Application, scene: &mut scene::Scene, events: &[Event], steps: u64) {
    // Small, since nobody looks at it.
    app.send(Event::Resize { size: [40, 30], scale: 1.0 });
    events.iter().for_each(|event| app.send(event.clone()));
    app.run_headless(steps, &mut |app: &mut Application, _| scene.step(app), |_, _| Ok(())).unwrap();
}

#[test]
fn scene_creates_and_removes_a_spark_while_it_runs() {
    let (mut app, mut scene) = scene::new().unwrap();
    let objects = app.world.objects().len();
    assert_eq!(objects, 10, "the ground, the pyramid OABCD and eight standard objects");
    stepped(&mut app, &mut scene, &[], 1);
    assert_eq!((app.world.objects().len(), scene.spark.is_some()), (objects + 1, true));
    stepped(&mut app, &mut scene, &[], 30);
    assert_eq!((app.world.objects().len(), scene.spark.is_some()), (objects, false));
    stepped(&mut app, &mut scene, &[], 30);
    assert_eq!(app.world.objects().len(), objects + 1);
}

#[test]
fn scene_moves_turns_and_changes_the_chosen_object_and_walks() {
    let (mut app, mut scene) = scene::new().unwrap();
    let before = *app.world.get(scene.chosen).unwrap();
    let camera = app.camera;
    let held: Vec<Event> = [Key::Right, Key::Char('y'), Key::Char('+')].map(key).to_vec();
    stepped(&mut app, &mut scene, &held, 10);
    let after = *app.world.get(scene.chosen).unwrap();
    assert!(after.placement.translation.x > before.placement.translation.x);
    assert!(after.placement.rotation != before.placement.rotation && after.placement.scale.x > 1.2);
    assert_eq!(app.camera, camera);
    let up = |key| Event::Key { key, pressed: false, repeat: false };
    stepped(&mut app, &mut scene, &[Key::Right, Key::Char('y'), Key::Char('+')].map(up), 1);
    stepped(&mut app, &mut scene, &keys("ovc"), 1);
    let changed = app.world.get(scene.chosen).unwrap();
    assert!(changed.show != after.show && !changed.visible && changed.color != after.color);
    stepped(&mut app, &mut scene, &keys("wq"), 5);
    assert!(app.camera.position() != camera.position() && app.camera.direction() != camera.direction());
}

#[test]
fn scene_refuses_what_is_done_to_an_object_that_is_gone_and_goes_on() {
    let (mut app, mut scene) = scene::new().unwrap();
    let first = scene.chosen;
    stepped(&mut app, &mut scene, &[key(Key::Delete)], 1);
    assert!(app.world.get(first).is_none());
    let objects = app.world.objects().len();
    // A tap, over before the frame.
    let released = Event::Key { key: Key::Left, pressed: false, repeat: false };
    stepped(&mut app, &mut scene, &[key(Key::Left), released], 1);
    assert_eq!(scene.help.line, WorldError::NoObject.to_string());
    assert_eq!(app.world.objects().len(), objects, "nothing else has happened");
    stepped(&mut app, &mut scene, &[key(Key::Tab)], 1);
    assert!(app.world.get(scene.chosen).is_some(), "{}", scene.help.line);
    stepped(&mut app, &mut scene, &keys("n"), 1);
    assert_eq!(app.world.objects().len(), objects + 1);
    assert_eq!(scene.help.line, "cube is created");
}

#[test]
fn h_shows_the_keys_and_hides_them() {
    let mut app = polosa_examples::application("keys", [300, 200]);
    let mut help = polosa_examples::Help::new("A  one\nB  the other");
    let without = shown(&mut app, &mut help, &[]);
    let with = shown(&mut app, &mut help, &keys("h"));
    assert!(with.pixels.contains(&WHITE) && !without.pixels.contains(&WHITE));
    assert_eq!(shown(&mut app, &mut help, &keys("h")).pixels, without.pixels);
}

#[test]
fn each_seed_lists_its_keys() {
    for (keys, needed) in [
        (tetrahedron::KEYS, &["Space", "E ", "H ", "Esc"][..]),
        (view_cube::KEYS, &["P ", "C ", "E ", "H ", "Esc"]),
        (hue_sphere::KEYS, &["Up, Down", "L ", "T ", "H ", "Esc"]),
        (mouse_tetrahedron::KEYS, &["1 ", "2 ", "3 ", "4 ", "E ", "H ", "Esc"]),
        (
            scene::keys::KEYS,
            &["Tab", "arrows", "X, Y, Z", "+, -", "C, V, O", "N, Del", "W A S D, Q R", "P ", "H ", "Esc"],
        ),
    ] {
        assert_eq!(keys.lines().count(), needed.len());
        for (line, start) in keys.lines().zip(needed) {
            assert!(line.starts_with(start) && line.is_ascii(), "{line}");
        }
    }
}
