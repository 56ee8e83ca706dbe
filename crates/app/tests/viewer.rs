//! The viewer, without a window: what keys, dropped files and time do to camera, light and world.

use std::fs;
use std::path::Path;
use std::time::{Duration, Instant};

use polosa::event::{Event, Key, Modifiers};
use polosa::math::glam::DVec3;
use polosa::model::Model;
use polosa::scene::{Camera, LightSpace, Projection, Shading, Show};
use polosa::viewer::keys::Mode;
use polosa::viewer::{Options, Viewer};
use polosa::{Application, Look, Settings};
use polosa_raster::Cull;

/// A tetrahedron whose faces have four colours' worth of directions, higher than it is wide.
const OBJ: &str = "v 0 0 0\nv 1 0 0\nv 0 2 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n";

struct Seat {
    app: Application,
    viewer: Viewer,
}

impl Seat {
    fn at(models: Vec<Model>, options: Options) -> Self {
        let mut app = Application::with(Settings { size: [160, 120], ..Settings::default() });
        let mut viewer = Viewer::new(models, options);
        viewer.load_now(&mut app).unwrap();
        Self { app, viewer }
    }

    fn of(model: &str) -> Self {
        Self::at(vec![Model::parse(model.into()).unwrap()], Options::default())
    }

    /// Some frames; the pixels of the last.
    fn frames(&mut self, count: u64) -> Vec<u32> {
        let mut pixels = Vec::new();
        let mut take = |_, picture: &polosa::scene::Picture| {
            pixels.clone_from(&picture.pixels);
            Ok(())
        };
        self.app.run_headless(count, &mut self.viewer, &mut take).unwrap();
        pixels
    }

    fn key(&mut self, key: Key, modifiers: Modifiers) {
        self.app.send(Event::Modifiers(modifiers));
        for pressed in [true, false] {
            self.app.send(Event::Key { key, pressed, repeat: false });
        }
        self.app.send(Event::Modifiers(Modifiers::NONE));
        self.frames(1);
    }

    fn press(&mut self, letter: char) {
        self.key(Key::Char(letter), Modifiers::NONE);
    }

    /// Waits for what is being read.
    fn wait(&mut self) {
        let start = Instant::now();
        while self.viewer.is_loading() {
            self.frames(1);
            assert!(start.elapsed() < Duration::from_secs(20), "it is read for ever");
        }
    }

    fn picture(&mut self) -> Vec<u32> {
        self.app.picture().unwrap().pixels
    }
}

fn near(a: DVec3, b: DVec3) -> bool {
    a.distance(b) < 1e-9
}

fn same_camera(a: &Camera, b: &Camera) -> bool {
    near(a.position(), b.position()) && near(a.direction(), b.direction()) && near(a.up(), b.up())
}

#[test]
fn number_keys_look_from_the_named_sides_with_the_models_axis_upward() {
    let folder = tempfile::tempdir().unwrap();
    let stl = folder.path().join("up.stl");
    let facet =
        "facet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 2\nendloop\nendfacet\n";
    fs::write(&stl, format!("solid a\n{facet}endsolid a\n")).unwrap();
    let corner = -DVec3::ONE.normalize();
    for (model, sides) in [
        ("shape:cone", [(DVec3::NEG_Z, DVec3::Y), (DVec3::NEG_X, DVec3::Y), (DVec3::NEG_Y, DVec3::NEG_Z)]),
        // Printers have Z upward, and look along +Y from the front.
        (stl.to_str().unwrap(), [(DVec3::Y, DVec3::Z), (DVec3::NEG_X, DVec3::Z), (DVec3::NEG_Z, DVec3::Y)]),
    ] {
        let mut seat = Seat::of(model);
        for (letter, (direction, up)) in ['1', '3', '7'].into_iter().zip(sides) {
            seat.press(letter);
            assert!(near(seat.app.camera.direction(), direction), "{model} {letter}");
            assert!(near(seat.app.camera.up(), up), "{model} {letter}: {}", seat.app.camera.up());
        }
        seat.press('9');
        let direction = seat.app.camera.direction();
        assert!(model != "shape:cone" || near(direction, corner), "{direction}");
    }
}

#[test]
fn the_other_projection_keeps_the_size_of_what_is_at_the_pivot_and_comes_back() {
    let mut seat = Seat::of("shape:teapot:4");
    let before = seat.app.camera;
    let seen = |seat: &Seat| {
        let camera = &seat.app.camera;
        [DVec3::ZERO, camera.right() * 0.3, camera.up() * -0.2]
            .map(|off| camera.project_point(seat.app.pivot() + off, 160, 120).unwrap())
    };
    let in_perspective = seen(&seat);
    seat.press('5');
    assert!(matches!(seat.app.camera.projection(), Projection::Orthographic { .. }));
    for (a, b) in in_perspective.iter().zip(seen(&seat)) {
        assert!((a.x - b.x).abs() < 1e-9 && (a.y - b.y).abs() < 1e-9, "{a:?} {b:?}");
    }
    seat.press('5');
    assert!(same_camera(&seat.app.camera, &before));
}

#[test]
fn enter_brings_everything_back() {
    let mut seat = Seat::of("shape:teapot:4");
    let picture = seat.picture();
    seat.key(Key::Right, Modifiers::NONE);
    let turned = seat.picture();
    seat.key(Key::Up, Modifiers::SHIFT);
    let risen = seat.picture();
    seat.key(Key::PageUp, Modifiers::NONE);
    let nearer = seat.picture();
    assert!(picture != turned && turned != risen && risen != nearer);
    seat.key(Key::Enter, Modifiers::NONE);
    assert!(seat.picture() == picture);
}

#[test]
fn arrows_turn_the_model_and_with_shift_the_camera_goes_round_it() {
    let mut seat = Seat::of("shape:teapot:4");
    let camera = seat.app.camera;
    let center = seat.app.world.bounds().center().unwrap();
    let (key, object) = seat.app.world.objects().next().map(|(key, object)| (key, *object)).unwrap();
    for arrow in [Key::Left, Key::Up] {
        seat.key(arrow, Modifiers::NONE);
    }
    assert!(same_camera(&seat.app.camera, &camera));
    assert!(seat.app.world.get(key).unwrap().placement != object.placement);
    seat.key(Key::Down, Modifiers::NONE);
    seat.key(Key::Right, Modifiers::NONE);
    let back = seat.app.world.get(key).unwrap().placement;
    assert!(back.translation.distance(object.placement.translation) < 1e-12, "there and back");
    seat.key(Key::Right, Modifiers::SHIFT);
    let moved = seat.app.camera.position() - camera.position();
    assert!(moved.dot(camera.right()) > 0.0, "to the right");
    let distance = |camera: &Camera| camera.position().distance(center);
    assert!((distance(&seat.app.camera) - distance(&camera)).abs() < 1e-9);
    let before = seat.app.camera.position();
    seat.key(Key::Up, Modifiers::SHIFT);
    assert!(seat.app.camera.position().y > before.y);
}

#[test]
fn keys_do_what_the_mouse_does() {
    let mut seat = Seat::of("shape:teapot:4");
    let at = |seat: &Seat, point| seat.app.camera.project_point(point, 160, 120).unwrap();
    let pivot = seat.app.pivot();
    let before = at(&seat, pivot);
    seat.key(Key::Right, Modifiers::CONTROL);
    seat.key(Key::Up, Modifiers::CONTROL);
    let panned = at(&seat, pivot);
    assert!(
        (panned.x - before.x - 6.0).abs() < 1e-9 && (before.y - panned.y - 6.0).abs() < 1e-9,
        "{panned:?}"
    );
    let light = seat.app.light.direction;
    seat.key(Key::Right, Modifiers::ALT);
    assert!(seat.app.light.direction.x > light.x);
    seat.key(Key::Home, Modifiers::NONE);
    let middle = at(&seat, seat.app.pivot());
    assert!((middle.x - 80.0).abs() < 1e-9 && (middle.y - 60.0).abs() < 1e-9, "{middle:?}");
    assert!(seat.app.pivot() != pivot, "on the surface");
}

#[test]
fn a_model_that_is_turned_or_read_again_is_never_cut_by_the_near_plane() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("plank.obj");
    let plank = |length: f64| {
        let corners = [[-length, 0.0], [length, 0.0], [length, 0.1], [-length, 0.1]];
        let vertices: String = corners.iter().map(|[x, y]| format!("v {x} {y} 0\n")).collect();
        vertices + "f 1 2 3 4\n"
    };
    write(&path, &plank(1.0));
    let mut seat = Seat::of(path.to_str().unwrap());
    let clipped = |seat: &mut Seat| {
        let picture = seat.app.picture().unwrap();
        picture.stats.triangles.clipped + picture.stats.triangles.outside
    };
    for letter in ['1', '5'] {
        seat.press(letter);
    }
    for _ in 0..18 {
        seat.key(Key::Right, Modifiers::NONE);
        assert_eq!(clipped(&mut seat), 0);
    }
    write(&path, &plank(3.0));
    seat.key(Key::Char('r'), Modifiers::CONTROL);
    seat.wait();
    seat.press('1');
    seat.key(Key::Right, Modifiers::NONE);
    assert_eq!(clipped(&mut seat), 0);
}

#[test]
fn what_was_dropped_and_is_broken_gives_its_camera_to_nobody() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("far.obj");
    write(&path, "nothing");
    let mut seat = Seat::of("shape:torus");
    seat.app.send(Event::Drop(path.clone()));
    seat.frames(1);
    seat.wait();
    assert!(seat.viewer.message().unwrap().contains("far.obj"));
    write(&path, &OBJ.replace("v 0 2 0", "v 0 2000 0"));
    seat.key(Key::Char('r'), Modifiers::CONTROL);
    seat.wait();
    let top = seat.app.camera.project_point(DVec3::new(0.0, 2000.0, 0.0), 160, 120).unwrap();
    assert!((0.0..120.0).contains(&top.y), "all of it is seen, {top:?}");
}

#[test]
fn a_key_that_is_held_turns_on_and_switches_once() {
    let mut seat = Seat::of("shape:cube");
    for repeat in [false, true, true] {
        seat.app.send(Event::Key { key: Key::Char('e'), pressed: true, repeat });
    }
    seat.frames(1);
    assert_eq!(seat.app.world.objects().next().unwrap().1.show, Show::Both);
    let placements = |seat: &Seat| seat.app.world.objects().next().unwrap().1.placement;
    let before = placements(&seat);
    seat.app.send(Event::Key { key: Key::Left, pressed: true, repeat: false });
    seat.frames(1);
    let once = placements(&seat);
    seat.app.send(Event::Key { key: Key::Left, pressed: true, repeat: true });
    seat.frames(1);
    assert!(before != once && once != placements(&seat));
}

#[test]
fn letters_switch_what_they_say_and_back() {
    let mut seat = Seat::of("shape:torus:12:6");
    let plain = seat.picture();
    let shows = |seat: &Seat| seat.app.world.objects().next().unwrap().1.show;
    for show in [Show::Both, Show::Wire, Show::Surface] {
        seat.press('e');
        assert_eq!(shows(&seat), show);
    }
    seat.press('g');
    assert_eq!(seat.app.world.objects().count(), 2, "the grid");
    assert!(seat.picture() != plain);
    seat.press('g');
    assert_eq!((seat.app.world.objects().count(), seat.app.world.meshes().count()), (1, 1));
    for cull in [Cull::Back, Cull::Front, Cull::None] {
        seat.press('c');
        assert_eq!(seat.app.style.cull, cull);
    }
    for shading in [Shading::Unlit, Shading::Flat] {
        seat.press('s');
        assert_eq!(seat.app.style.shading, shading);
    }
    for look in [Look::Depth, Look::Shaded] {
        seat.press('d');
        assert_eq!(seat.app.settings.look, look);
    }
    let mut methods = Vec::new();
    loop {
        seat.press('f');
        match seat.app.settings.methods {
            Some(method) => methods.push(method.coverage),
            None => break,
        }
    }
    assert_eq!(methods, polosa_raster::reference::Coverage::ALL[1..]);
    assert!(seat.picture() == plain);
}

#[test]
fn what_is_drawn_over_a_picture_is_no_part_of_it_and_goes_again() {
    let mut seat = Seat::of("shape:cube");
    let frame = seat.frames(1);
    assert!(frame == seat.picture());
    for letter in ['h', 'i', 'v', 'x'] {
        seat.press(letter);
        assert!(seat.frames(1) != frame, "{letter}");
        assert!(seat.picture() == frame, "{letter}");
        seat.press(letter);
        assert!(seat.frames(1) == frame, "{letter}");
    }
    seat.press('c'); // says so, for a while
    seat.press('c');
    seat.press('c');
    assert!(seat.frames(1) != frame);
    assert!(seat.frames(60 * 5) == frame, "a message goes");
}

#[test]
fn the_light_stays_where_it_is_when_it_changes_hands() {
    let mut seat = Seat::of("shape:teapot:4");
    let before = seat.picture();
    seat.press('l');
    assert_eq!(seat.app.light.space, LightSpace::World);
    let codes = |pixel: u32| [16, 8, 0].map(|shift| (pixel >> shift & 0xff) as i32);
    let differ = |a: &[u32], b: &[u32]| {
        let codes = a.iter().zip(b).flat_map(|(&a, &b)| codes(a).into_iter().zip(codes(b)));
        codes.map(|(a, b)| (a - b).abs()).max()
    };
    assert!(differ(&before, &seat.picture()) <= Some(1));
    seat.key(Key::Right, Modifiers::SHIFT);
    let in_world = seat.picture();
    seat.press('l');
    assert_eq!(seat.app.light.space, LightSpace::Camera);
    assert!(differ(&in_world, &seat.picture()) <= Some(1));
}

#[test]
fn the_turntable_turns_until_it_is_stopped() {
    let mut seat = Seat::of("shape:teapot:4");
    seat.press('t');
    let first = seat.frames(1);
    let later = seat.frames(10);
    assert!(first != later);
    seat.press('t');
    let stopped = seat.frames(1);
    assert!(seat.frames(10) == stopped);
}

#[test]
fn in_fly_mode_letters_move_and_escape_comes_back_before_it_quits() {
    let mut seat = Seat::of("shape:teapot:4");
    seat.key(Key::Tab, Modifiers::NONE);
    assert_eq!(seat.viewer.mode(), Mode::Fly);
    let before = seat.app.camera;
    seat.app.send(Event::Key { key: Key::Char('s'), pressed: true, repeat: false });
    seat.frames(30);
    let moved = seat.app.camera.position() - before.position();
    assert!(moved.dot(before.direction()) < 0.0, "S goes back");
    assert_eq!(seat.app.style.shading, Shading::Flat, "and shades nothing");
    seat.app.send(Event::Key { key: Key::Char('s'), pressed: false, repeat: false });
    seat.frames(1);
    let there = seat.app.camera;
    seat.frames(30);
    assert_eq!(seat.app.camera, there, "a released key moves nothing");
    seat.key(Key::Escape, Modifiers::NONE);
    assert_eq!((seat.viewer.mode(), seat.app.is_quitting()), (Mode::Orbit, false));
    seat.key(Key::Escape, Modifiers::NONE);
    assert!(seat.app.is_quitting());
}

fn write(path: &Path, text: &str) {
    fs::write(path, text).unwrap();
}

#[test]
fn a_reload_shows_the_new_model_from_the_old_place_and_a_broken_file_the_last_good_one() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("model.obj");
    write(&path, OBJ);
    let mut seat = Seat::of(path.to_str().unwrap());
    seat.key(Key::Right, Modifiers::SHIFT);
    let (camera, before) = (seat.app.camera, seat.picture());

    write(&path, &OBJ.replace("f 2 3 4\n", ""));
    seat.key(Key::Char('r'), Modifiers::CONTROL);
    seat.wait();
    assert_eq!(seat.app.camera, camera);
    let reloaded = seat.picture();
    assert!(reloaded != before);

    write(&path, "v 0 0\nf 1 2 3\n");
    seat.key(Key::Char('r'), Modifiers::CONTROL);
    seat.wait();
    assert!(seat.picture() == reloaded);
    let message = seat.viewer.message().unwrap();
    assert!(message.contains("model.obj"), "{message}");
    seat.frames(60 * 10);
    assert!(seat.viewer.message().is_some(), "it stays until something else is read");

    write(&path, OBJ);
    seat.key(Key::Char('r'), Modifiers::CONTROL);
    seat.wait();
    assert!(seat.picture() == before && seat.viewer.message().is_none());
}

#[test]
fn a_watched_file_is_read_again_when_it_is_written() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("model.obj");
    write(&path, OBJ);
    let options = Options { watch: true, ..Options::default() };
    let mut seat = Seat::at(vec![Model::File(path.clone())], options);
    seat.frames(1);
    let (camera, before) = (seat.app.camera, seat.picture());
    // As editors do it: a new file takes the old one's name.
    let new = folder.path().join("model.obj~");
    write(&new, &OBJ.replace("f 2 3 4\n", ""));
    fs::rename(&new, &path).unwrap();
    let start = Instant::now();
    while seat.picture() == before {
        seat.frames(1);
        std::thread::sleep(Duration::from_millis(5));
        assert!(start.elapsed() < Duration::from_secs(20), "nobody has noticed");
    }
    assert!(same_camera(&seat.app.camera, &camera));
}

#[test]
fn dropped_files_take_the_place_of_what_was_there() {
    let folder = tempfile::tempdir().unwrap();
    let paths = ["a.obj", "b.obj"].map(|name| folder.path().join(name));
    paths.iter().for_each(|path| write(path, OBJ));
    let mut seat = Seat::of("shape:torus");
    for path in &paths {
        seat.app.send(Event::Drop(path.clone()));
    }
    seat.frames(1);
    seat.wait();
    assert_eq!(seat.app.world.objects().count(), 2);
    assert!(seat.app.settings.title.starts_with("a.obj and 1 more"), "{}", seat.app.settings.title);
    seat.app.send(Event::Drop(folder.path().join("none.obj")));
    seat.frames(1);
    seat.wait();
    assert_eq!(seat.app.world.objects().count(), 2, "what cannot be read replaces nothing");
    assert!(seat.viewer.message().unwrap().contains("none.obj"));
}

#[test]
fn models_that_cannot_be_read_at_first_end_the_viewer_with_their_error() {
    let mut app = Application::new();
    let mut viewer = Viewer::new(vec![Model::File("does/not/exist.obj".into())], Options::default());
    while !app.is_quitting() {
        app.run_headless(1, &mut viewer, |_, _| Ok(())).unwrap();
    }
    assert!(viewer.take_failure().unwrap().to_string().contains("exist.obj"));
}

#[test]
fn the_built_in_scene_is_shown_where_no_model_is_named() {
    let mut seat = Seat::at(Vec::new(), Options::default());
    assert!(seat.app.world.objects().count() > 5);
    let picture = seat.frames(1);
    assert!(picture.iter().collect::<std::collections::HashSet<_>>().len() > 20);
    let before = seat.picture();
    seat.press('e');
    assert!(seat.picture() != before);
    seat.press('e');
    seat.press('e');
    assert!(seat.picture() == before, "what has a way of its own to be shown gets it back");
}
