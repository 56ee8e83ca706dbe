//! What a program is told when the system, or the programmer himself, has failed.
#![cfg(feature = "window")]

use std::sync::{Arc, Mutex};

use polosa::math::glam::DVec3;
use polosa::scene::{Color, Object, WorldError, shape};
use polosa::{Application, Error, Settings};
use tracing::field::{Field, Visit};
use tracing::span::{Attributes, Id, Record};
use tracing::{Event, Level, Metadata, Subscriber};

/// A log that keeps what it is told.
#[derive(Clone, Default)]
struct Log(Arc<Mutex<Vec<(Level, String)>>>);

struct Line(String);

impl Visit for Line {
    fn record_debug(&mut self, field: &Field, value: &dyn std::fmt::Debug) {
        if field.name() == "message" {
            self.0 = format!("{value:?}");
        }
    }
}

impl Subscriber for Log {
    fn enabled(&self, _: &Metadata<'_>) -> bool {
        true
    }

    fn new_span(&self, _: &Attributes<'_>) -> Id {
        Id::from_u64(1)
    }

    fn event(&self, event: &Event<'_>) {
        let mut line = Line(String::new());
        event.record(&mut line);
        self.0.lock().unwrap().push((*event.metadata().level(), line.0));
    }

    fn record(&self, _: &Id, _: &Record<'_>) {}
    fn record_follows_from(&self, _: &Id, _: &Id) {}
    fn enter(&self, _: &Id) {}
    fn exit(&self, _: &Id) {}
}

/// Tests do not run on a program's main thread, where alone windows can be opened.
#[test]
fn without_a_window_drawing_fails_is_logged_once_and_everything_else_goes_on() {
    let log = Log::default();
    tracing::subscriber::with_default(log.clone(), || {
        let mut app = Application::new();
        let mesh = app.world.add_mesh(shape::cube());
        let cube = app.world.add(Object::new(mesh)).unwrap();
        let error = app.run(&mut ()).unwrap_err();
        assert!(matches!(error, Error::Window(_)), "{error}");
        let again = app.update().unwrap_err();
        assert_eq!(again.to_string(), error.to_string(), "the next frame fails for the same reason");

        let logged = log.0.lock().unwrap().clone();
        assert_eq!(logged.len(), 2, "{logged:?}");
        assert!(
            logged.iter().all(|(level, text)| *level == Level::ERROR && text.contains("window")),
            "{logged:?}"
        );
        assert!(!error.to_string().contains('\n'));

        app.world.move_by(cube, DVec3::X).unwrap();
        app.camera.set_position(DVec3::new(0.0, 1.0, 9.0)).unwrap();
        assert!(app.picture().unwrap().pixels.iter().any(|&pixel| pixel != 0x2b_2b2b));
        app.world.remove(cube);
        assert_eq!(app.world.move_by(cube, DVec3::X), Err(WorldError::NoObject));
        assert_eq!(app.world.recolor(cube, Some(Color::WHITE)), Err(WorldError::NoObject));
        assert!(app.world.remove(cube).is_none() && app.world.get(cube).is_none());
    });
}

#[test]
#[cfg(debug_assertions)]
fn a_window_without_pixels_or_rate_is_the_programmers_mistake() {
    let refused = |settings: Settings| std::panic::catch_unwind(|| Application::with(settings)).is_err();
    assert!(refused(Settings { size: [0, 10], ..Settings::default() }));
    assert!(refused(Settings { frame_rate: 0.0, ..Settings::default() }));
    assert!(refused(Settings { frame_rate: f64::NAN, ..Settings::default() }));
    assert!(!refused(Settings { frame_rate: f64::INFINITY, ..Settings::default() }));
}

#[test]
fn settings_may_change_at_any_time_and_slow_rates_keep_their_step() {
    let settings = Settings { size: [8, 6], frame_rate: 2.0, ..Settings::default() };
    let mut app = Application::with(settings);
    app.settings.size = [4, 3];
    let (mut steps, mut sizes) = (Vec::new(), Vec::new());
    let mut program = |app: &mut Application, step: std::time::Duration| {
        steps.push(step.as_millis());
        app.settings.size = [10, 5 + steps.len() as u32];
    };
    app.run_headless(2, &mut program, |_, picture| {
        sizes.push([picture.width, picture.height]);
        Ok(())
    })
    .unwrap();
    assert_eq!((steps, sizes), (vec![500; 2], vec![[10, 6], [10, 7]]));
    app.settings.frame_rate = 1e-300;
    app.run_headless(1, &mut (), |_, _| Ok(())).unwrap();
}

#[test]
fn failed_frames_end_a_run_without_a_window() {
    let mut app = Application::with(Settings { size: [8, 6], ..Settings::default() });
    let mut seen = 0;
    let ended = app.run_headless(10, &mut (), |frame, _| {
        seen += 1;
        if frame == 3 { Err(Error::file("frame.png", "no space left")) } else { Ok(()) }
    });
    assert_eq!((ended.unwrap_err().to_string().as_str(), seen), ("frame.png: no space left", 4));
}

#[test]
fn a_run_without_a_window_takes_exact_steps_and_ends_when_told_to() {
    let settings = Settings { size: [8, 6], frame_rate: 25.0, ..Settings::default() };
    let (mut app, mut steps, mut frames) = (Application::with(settings), Vec::new(), 0);
    let mut program = |app: &mut Application, step: std::time::Duration| {
        steps.push(step.as_millis());
        if steps.len() == 5 {
            app.quit();
        }
    };
    app.run_headless(100, &mut program, |_, _| {
        frames += 1;
        Ok(())
    })
    .unwrap();
    assert_eq!((steps, frames), (vec![40; 5], 4));
}
