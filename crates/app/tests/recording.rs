//! An application records what it draws.

use std::time::Duration;

use polosa::canvas::Canvas;
use polosa::event::Event;
use polosa::math::{axis_angle, glam::DVec3};
use polosa::scene::{Object, ObjectKey, Picture, shape};
use polosa::{Application, Error, Program, Settings};

/// A cube that turns, with a number over it.
struct Turning {
    cube: Option<ObjectKey>,
    frames: u32,
}

impl Program for Turning {
    fn start(&mut self, app: &mut Application) {
        let mesh = app.world.add_mesh(shape::cube());
        self.cube = app.world.add(Object::new(mesh)).ok();
        app.frame_world();
    }

    fn update(&mut self, app: &mut Application, step: Duration) {
        let turn = axis_angle(DVec3::Y, step.as_secs_f64()).unwrap();
        self.cube.and_then(|cube| app.world.turn(cube, turn).ok());
        self.frames += 1;
    }

    fn overlay(&mut self, _: &Application, canvas: &mut Canvas<'_>) {
        canvas.text([1, 1], &self.frames.to_string(), polosa::scene::Color::WHITE);
    }
}

fn app(frame_rate: f64) -> (Application, Turning) {
    let settings = Settings { size: [64, 48], frame_rate, ..Settings::default() };
    (Application::with(settings), Turning { cube: None, frames: 0 })
}

/// The pictures that are taken, and what is in the sequence.
fn pixels(pictures: &[Picture]) -> Vec<&[u32]> {
    pictures.iter().map(|picture| &picture.pixels[..]).collect()
}

#[test]
fn what_is_recorded_is_what_is_drawn_overlay_included() {
    let folder = tempfile::tempdir().unwrap();
    let (mut app, mut program) = app(25.0);
    let mut pictures = Vec::new();
    let mut take = |_, picture: &Picture| {
        pictures.push(picture.clone());
        Ok(())
    };
    app.run_headless(2, &mut program, &mut take).unwrap();
    app.record(folder.path().join("x_%d.png")).unwrap();
    assert!(app.is_recording());
    // In two goes, as one.
    app.run_headless(3, &mut program, &mut take).unwrap();
    app.run_headless(2, &mut program, &mut take).unwrap();
    app.stop_recording().unwrap();
    assert!(!app.is_recording());
    app.run_headless(1, &mut program, &mut take).unwrap();

    assert_eq!(std::fs::read_dir(folder.path()).unwrap().count(), 5);
    for (n, expected) in (1..).zip(&pixels(&pictures)[2..7]) {
        let picture = image::open(folder.path().join(format!("x_{n}.png"))).unwrap().into_rgb8();
        let recorded = picture.pixels().map(|p| u32::from_be_bytes([0, p.0[0], p.0[1], p.0[2]]));
        assert!(recorded.eq(expected.iter().copied()), "frame {n}");
    }
    assert!(app.stop_recording().is_ok(), "nothing is recorded: nothing happens");
}

#[test]
fn a_recording_without_a_window_takes_the_time_of_its_frames() {
    let folder = tempfile::tempdir().unwrap();
    for (rate, frames, hundredths) in [(25.0, 10, 40), (60.0, 90, 150), (f64::INFINITY, 1, 2)] {
        let (mut app, mut program) = app(rate);
        let path = folder.path().join("x.gif");
        app.record_headless(frames, &mut program, &path).unwrap();
        let bytes = std::fs::read(&path).unwrap();
        let mut decoder = gif::DecodeOptions::new().read_info(&bytes[..]).unwrap();
        let mut sum = 0;
        while let Some(frame) = decoder.read_next_frame().unwrap() {
            assert!(frame.delay >= 2, "browsers show what is shorter for longer");
            sum += u32::from(frame.delay);
        }
        // Where frames are left out, the last may be late by as much as is the least.
        let late = if rate > 50.0 { 2 } else { 0 };
        assert!((hundredths..=hundredths + late).contains(&sum), "{frames} at {rate}: {sum}");
    }
}

#[test]
fn a_size_that_changes_ends_a_recording_with_an_error_and_without_a_file() {
    struct Resizing;
    impl Program for Resizing {
        fn update(&mut self, app: &mut Application, _: Duration) {
            app.send(Event::Resize { size: [9 + app.statistics().frames() as u32, 9], scale: 1.0 });
        }
    }
    let folder = tempfile::tempdir().unwrap();
    let (mut app, _) = app(25.0);
    let error = app.record_headless(5, &mut Resizing, folder.path().join("x.gif")).unwrap_err();
    assert!(error.to_string().contains("does not fit into a recording of 64×48"), "{error}");
    assert!(!app.is_recording());
    assert_eq!(std::fs::read_dir(folder.path()).unwrap().count(), 0);
    for name in ["x.png", "x%d%d.png"] {
        assert!(matches!(app.record(folder.path().join(name)), Err(Error::Usage(_))), "{name}");
        assert!(!app.is_recording());
    }
}
