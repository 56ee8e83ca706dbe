//! The keys of an example, shown by H.

use std::time::Duration;

use polosa::canvas::Canvas;
use polosa::event::{Event, Handled, Key};
use polosa::{Application, Program};
use polosa_scene::Color;

use crate::run::{redrawn, struck};

/// A program that does nothing but show keys and a line of text.
#[derive(Debug, Default)]
pub struct Help {
    keys: &'static str,
    open: bool,
    /// Stands at the lower edge. Whoever changes it asks for a frame.
    pub line: String,
}

impl Help {
    /// One that shows these keys, a line each.
    #[must_use]
    pub const fn new(keys: &'static str) -> Self {
        Self { keys, open: false, line: String::new() }
    }
}

impl Program for Help {
    fn animated(&self) -> bool {
        false
    }

    fn event(&mut self, app: &mut Application, event: &Event) -> Handled {
        if struck(event) != Some(Key::Char('h')) || self.keys.is_empty() {
            return Handled::No;
        }
        self.open = !self.open;
        redrawn(app)
    }

    fn overlay(&mut self, _app: &Application, canvas: &mut Canvas<'_>) {
        let [width, height] = canvas.dimensions().map(|side| side as i32);
        let room = canvas.pixels_of(12.0);
        if self.open {
            let [wide, high] = canvas.text_size(self.keys);
            label(canvas, [(width - wide) / 2, (height - high) / 2], self.keys);
        }
        if !self.line.is_empty() {
            let line = canvas.text_size(&self.line)[1];
            label(canvas, [room, height - room - line], &self.line);
        }
    }
}

/// White text on darkened ground, its upper left corner at `at`.
pub fn label(canvas: &mut Canvas<'_>, at: [i32; 2], text: &str) {
    let margin = canvas.pixels_of(6.0);
    let [width, height] = canvas.text_size(text);
    canvas.dim(at.map(|x| x - margin), [width + 2 * margin, height + 2 * margin]);
    canvas.text(at, text, Color::WHITE);
}

/// A program with help over it.
#[derive(Debug)]
pub(crate) struct Helped<P> {
    pub(crate) program: P,
    pub(crate) help: Help,
}

impl<P: Program> Program for Helped<P> {
    fn start(&mut self, app: &mut Application) {
        self.program.start(app);
    }

    fn update(&mut self, app: &mut Application, step: Duration) {
        self.program.update(app, step);
    }

    fn animated(&self) -> bool {
        self.program.animated()
    }

    fn event(&mut self, app: &mut Application, event: &Event) -> Handled {
        match self.help.event(app, event) {
            Handled::Yes => Handled::Yes,
            Handled::No => self.program.event(app, event),
        }
    }

    fn overlay(&mut self, app: &Application, canvas: &mut Canvas<'_>) {
        self.program.overlay(app, canvas);
        self.help.overlay(app, canvas);
    }
}
