//! The programs that claims are about.
#![expect(clippy::print_stdout, reason = "what these programs have to say")]

use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};
use std::time::Duration;

use polosa::event::{Event, Handled};
use polosa::math::glam::DVec3;
use polosa::scene::{Color, Object, ObjectKey, shape};
use polosa::{Application, Program, Settings};

use crate::screen::Shot;

pub(crate) const RED: u32 = 0xa0_2020;
pub(crate) const GREEN: u32 = 0x20_a020;
pub(crate) const BLUE: u32 = 0x20_20a0;

/// How many frames the cube moves for.
pub(crate) const FRAMES: u16 = 20;

/// Runs a program.
pub(crate) fn run(name: &str) {
    match name {
        "own-loop" => own_loop(),
        "refuses-once" => application(RED).run(&mut RefusesOnce(false)).expect("a window"),
        "twice" => twice(),
        "woken" => woken(),
        other => panic!("no program {other}"),
    }
}

fn application(background: u32) -> Application {
    Application::with(Settings {
        size: [200, 150],
        background: Color::from_u32(background),
        ..Settings::default()
    })
}

fn with_cube(app: &mut Application) -> ObjectKey {
    let mesh = app.world.add_mesh(shape::cube());
    let cube = app.world.add(Object::new(mesh)).expect("a world of one cube");
    app.frame_world();
    cube
}

fn step(app: &mut Application, cube: ObjectKey) {
    app.world.move_by(cube, DVec3::new(0.02, 0.0, 0.0)).expect("a cube that is there");
}

fn own_loop() {
    let mut app = application(BLUE);
    let cube = with_cube(&mut app);
    let mut calls = 0_u64;
    while app.update().expect("a window") {
        if calls < FRAMES.into() {
            step(&mut app, cube);
        }
        calls += 1;
    }
    assert!(!app.update().expect("an application that has ended says no more"));
    println!("ended after {calls}");
}

/// What that shows in the end.
pub(crate) fn headless() -> Shot {
    headless_of([200, 150])
}

/// And in a window that got another size.
pub(crate) fn headless_of(size: [u32; 2]) -> Shot {
    let mut app = application(BLUE);
    let cube = with_cube(&mut app);
    (0..FRAMES).for_each(|_| step(&mut app, cube));
    app.send(Event::Resize { size, scale: 1.0 });
    let mut shot = None;
    let taken = app.run_headless(1, &mut (), |_, picture| {
        shot = Some(Shot { size: [picture.width, picture.height], pixels: picture.pixels.clone() });
        Ok(())
    });
    taken.expect("a picture is drawn");
    shot.expect("one picture")
}

/// Turns green when it is asked to close for the first time.
struct RefusesOnce(bool);

impl Program for RefusesOnce {
    fn animated(&self) -> bool {
        false
    }

    fn event(&mut self, app: &mut Application, event: &Event) -> Handled {
        if *event == Event::Close && !self.0 {
            self.0 = true;
            app.settings.background = Color::from_u32(GREEN);
            return Handled::Yes;
        }
        Handled::No
    }
}

fn twice() {
    let mut app = application(RED);
    app.run(&mut ()).expect("a window");
    app.settings.background = Color::from_u32(BLUE);
    app.run(&mut ()).expect("another window");
    println!("twice");
}

/// Is told by a thread that it is time to turn green.
struct Woken(Arc<AtomicBool>);

impl Program for Woken {
    fn start(&mut self, app: &mut Application) {
        let (waker, told) = (app.waker(), Arc::clone(&self.0));
        std::thread::spawn(move || {
            // Long enough for the program to be idle; if it is not, this claims less, and still holds.
            std::thread::sleep(Duration::from_millis(500));
            told.store(true, Ordering::Release);
            waker.wake();
        });
    }

    fn animated(&self) -> bool {
        false
    }

    fn update(&mut self, app: &mut Application, _: Duration) {
        if self.0.load(Ordering::Acquire) {
            app.settings.background = Color::from_u32(GREEN);
        }
    }
}

fn woken() {
    application(RED).run(&mut Woken(Arc::default())).expect("a window");
}
