//! The viewer inside a program of your own: with a grid, axes and sliders, and a line of the program's over it.
//!
//! What to see: the teapot; every key and the mouse do what they do in `polosa view` (H shows them), and dropped files
//! are opened. F2, which the viewer leaves alone, is the program's: it counts.

use std::error::Error;
use std::process::ExitCode;
use std::time::Duration;

use polosa::canvas::Canvas;
use polosa::event::{Event, Handled, Key};
use polosa::model::Model;
use polosa::viewer::{Options, Viewer};
use polosa::{Application, Program, Settings};
use polosa_examples::{Headless, label, report};
use polosa_scene::Show;

struct Counting {
    viewer: Viewer,
    count: u32,
}

impl Program for Counting {
    fn start(&mut self, app: &mut Application) {
        self.viewer.start(app);
    }

    fn update(&mut self, app: &mut Application, step: Duration) {
        self.viewer.update(app, step);
    }

    fn animated(&self) -> bool {
        self.viewer.animated()
    }

    fn event(&mut self, app: &mut Application, event: &Event) -> Handled {
        if !matches!(event, Event::Key { key: Key::F(2), pressed: true, .. }) {
            return self.viewer.event(app, event);
        }
        self.count += 1;
        app.redraw();
        Handled::Yes
    }

    fn overlay(&mut self, app: &Application, canvas: &mut Canvas<'_>) {
        self.viewer.overlay(app, canvas);
        label(canvas, [canvas.pixels_of(12.0); 2], &format!("F2 was struck {} times", self.count));
    }
}

fn main() -> Result<ExitCode, Box<dyn Error>> {
    let mut app = Application::with(Settings { size: [800, 600], ..Settings::default() });
    let options = Options { grid: true, axes: true, show: Show::Both, ..Options::default() };
    let mut viewer = Viewer::new(vec![Model::parse("shape:teapot:6".into())?], options);
    viewer.load_now(&mut app)?;
    let sliders = Event::Key { key: Key::Char('v'), pressed: true, repeat: false };
    app.send(sliders);
    let mut program = Counting { viewer, count: 0 };
    Ok(report(match Headless::from_args("")? {
        Some(headless) => headless.run(&mut app, &mut program),
        None => app.run(&mut program),
    }))
}
