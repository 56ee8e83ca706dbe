//! What the viewer draws over a picture.
//!
//! ```text
//!   ┌──────────────────────────────┐
//!   │ statistics                   │
//!   │             help, progress   │
//!   │ axes                         │
//!   │             message          │
//!   └──────────────────────────────┘
//! ```

use std::time::Duration;

use embedded_graphics::Drawable as _;
use embedded_graphics::geometry::Point;
use embedded_graphics::mono_font::{MonoFont, ascii};
use embedded_graphics::primitives::{Line, Primitive as _, PrimitiveStyle};
use polosa_math::glam::DVec3;
use polosa_scene::Color;

use super::Viewer;
use super::keys::{BINDINGS, MOUSE, Mode};
use crate::application::Application;
use crate::canvas::{Canvas, rgb};
use crate::settings::Look;

const TEXT: Color = Color::new(0xf0, 0xf0, 0xf0);
const FAINT: Color = Color::new(0xb0, 0xb8, 0xc0);
const FAILURE: Color = Color::new(0xff, 0x9a, 0x8a);
const BAR: Color = Color::new(0x5c, 0xb8, 0xa4);

/// In units of the desktop: around texts, and between them and the border.
const MARGIN: f64 = 6.0;

/// What a slider along the lower edge takes, in units of the desktop.
const SLIDER: f64 = 36.0;

/// The length of an axis, in units of the desktop.
const AXIS: f64 = 30.0;

impl Viewer {
    pub(super) fn draw_over(&self, app: &Application, canvas: &mut Canvas<'_>) {
        if self.axes {
            draw_axes(app, canvas, self.lower(canvas));
        }
        if let Some(sliders) = &self.sliders {
            sliders.iter().for_each(|slider| slider.draw(canvas));
        }
        if self.statistics {
            let margin = canvas.pixels_of(MARGIN);
            boxed(canvas, [margin; 2], &self.figures(app), TEXT);
        }
        if self.help {
            draw_help(canvas);
        }
        if let Some((stage, seconds)) = self.loader.stage() {
            draw_progress(canvas, &stage, seconds);
        }
        if let Some(message) = &self.message {
            let color = if message.is_failure { FAILURE } else { TEXT };
            let text = wrapped(canvas, &message.text);
            let [width, height] = canvas.text_size(&text);
            let (margin, [across, _]) = (canvas.pixels_of(MARGIN), canvas.dimensions());
            let at = [(across as i32 - width) / 2 - margin, self.lower(canvas) - height - 3 * margin];
            boxed(canvas, at, &text, color);
        }
    }

    /// The lower edge of what the sliders leave free.
    fn lower(&self, canvas: &Canvas<'_>) -> i32 {
        let sliders = if self.sliders.is_some() { canvas.pixels_of(SLIDER) } else { 0 };
        canvas.dimensions()[1] as i32 - sliders
    }

    /// Times, counts, methods.
    fn figures(&self, app: &Application) -> String {
        let statistics = app.statistics();
        let stats = statistics.last();
        let of = stats.triangles.submitted + stats.hidden;
        let [width, height] = app.size();
        let method = match (app.settings.look, app.settings.methods) {
            (Look::Depth, _) => "depth".to_owned(),
            (_, Some(methods)) => format!("fill {}", methods.coverage.name()),
            _ => "exact".to_owned(),
        };
        let mode = if self.mode == Mode::Fly { ", fly" } else { "" };
        format!(
            "{:.1} ms a frame, {:.0} frames/s\n{} of {of} triangles drawn\n{width} x {height}, {method}{mode}",
            milliseconds(statistics.time()),
            statistics.rate(),
            stats.triangles.drawn,
        )
    }
}

fn milliseconds(time: Duration) -> f64 {
    time.as_secs_f64() * 1e3
}

/// Text on a darkened ground; `at` is the ground's upper left corner.
fn boxed(canvas: &mut Canvas<'_>, at: [i32; 2], text: &str, color: Color) {
    let margin = canvas.pixels_of(MARGIN);
    let [width, height] = canvas.text_size(text);
    canvas.dim(at, [width + 2 * margin, height + 2 * margin]);
    canvas.text(at.map(|place| place + margin), text, color);
}

/// Text in lines that are no longer than the canvas is wide, broken between words where possible.
fn wrapped(canvas: &Canvas<'_>, text: &str) -> String {
    let sign = canvas.text_size("0")[0].max(1);
    let room = (canvas.dimensions()[0] as i32 - 4 * canvas.pixels_of(MARGIN)) / sign;
    let room = usize::try_from(room).unwrap_or(0).max(8);
    let mut lines = vec![String::new()];
    for word in text.split(' ') {
        let mut signs: Vec<char> = word.chars().collect();
        while !signs.is_empty() {
            let line = lines.last().map_or(0, |line| line.chars().count());
            let needed = signs.len() + usize::from(line > 0);
            if line > 0 && line + needed > room {
                lines.push(String::new());
                continue;
            }
            let rest = signs.split_off(signs.len().min(room));
            if let Some(last) = lines.last_mut() {
                if line > 0 {
                    last.push(' ');
                }
                last.extend(signs);
            }
            signs = rest;
        }
    }
    lines.join("\n")
}

/// Fonts for help in windows where the usual one has no room.
const SMALLER: [&MonoFont<'static>; 3] = [&ascii::FONT_6X10, &ascii::FONT_5X8, &ascii::FONT_4X6];

/// All keys and the mouse, in as many columns as the height asks for, in the largest font that fits.
fn draw_help(canvas: &mut Canvas<'_>) {
    let keys = BINDINGS.iter().filter_map(|binding| binding.help);
    let lines: Vec<[&'static str; 2]> = MOUSE.iter().copied().chain([["", ""]]).chain(keys).collect();
    let [width, height] = canvas.dimensions().map(|side| side as i32);
    let margin = canvas.pixels_of(MARGIN);
    for font in [canvas.font()].into_iter().chain(SMALLER) {
        canvas.set_font(Some(font));
        let [sign, row] = canvas.text_size("0");
        let rows = ((height - 4 * margin) / row.max(1)).clamp(1, lines.len() as i32);
        let columns: Vec<Column<'_>> = lines.chunks(rows as usize).map(Column::of).collect();
        let signs: i32 = columns.iter().map(|column| column.names + column.abouts).sum();
        let size = [signs * sign + 2 * margin, rows * row + 2 * margin];
        if size[0] > width && font != SMALLER[2] {
            continue;
        }
        let at = [(width - size[0]).max(0) / 2, (height - size[1]).max(0) / 2];
        // Twice: over a bright picture, too, it can be read.
        canvas.dim(at, size);
        canvas.dim(at, size);
        let mut left = at[0] + margin;
        for Column { lines, names, abouts } in columns {
            for (line, [name, about]) in lines.iter().enumerate() {
                let top = at[1] + margin + line as i32 * row;
                canvas.text([left, top], name, TEXT);
                canvas.text([left + names * sign, top], about, FAINT);
            }
            left += (names + abouts) * sign;
        }
        break;
    }
    canvas.set_font(None);
}

/// A column of the help.
struct Column<'a> {
    lines: &'a [[&'static str; 2]],
    /// Signs across, the space behind included.
    names: i32,
    abouts: i32,
}

impl<'a> Column<'a> {
    fn of(lines: &'a [[&'static str; 2]]) -> Self {
        let longest = |part: usize| lines.iter().map(|line| line[part].len()).max().unwrap_or(0) as i32;
        Self { lines, names: longest(0) + 2, abouts: longest(1) + 2 }
    }
}

/// What is being read, and a mark that runs to and fro while it is.
fn draw_progress(canvas: &mut Canvas<'_>, stage: &str, seconds: f64) {
    let text = wrapped(canvas, &format!("{stage}: {seconds:.1} s"));
    let (margin, bar) = (canvas.pixels_of(MARGIN), canvas.pixels_of(4.0));
    let [width, height] = canvas.text_size(&text);
    let [across, down] = canvas.dimensions().map(|side| side as i32);
    let length = width.max(canvas.pixels_of(240.0)).min(across - 4 * margin).max(1);
    let size = [length + 2 * margin, height + bar + 3 * margin];
    let at = [(across - size[0]) / 2, (down - size[1]) / 2];
    canvas.dim(at, size);
    canvas.text([at[0] + margin, at[1] + margin], &text, TEXT);
    let run = length * 3 / 4;
    let there = (seconds % 2.0 - 1.0).abs();
    let left = at[0] + margin + (f64::from(run) * (1.0 - there)) as i32;
    let top = at[1] + 2 * margin + height + bar / 2;
    let style = PrimitiveStyle::with_stroke(rgb(BAR), bar as u32);
    let line = Line::new(Point::new(left, top), Point::new(left + length - run, top));
    let Ok(()) = line.into_styled(style).draw(canvas);
}

/// The world's axes, as the camera sees their directions, the nearest last.
fn draw_axes(app: &Application, canvas: &mut Canvas<'_>, lower: i32) {
    let basis = app.camera.basis();
    let axes = [("X", DVec3::X, 0xff_6b60), ("Y", DVec3::Y, 0x7a_d46a), ("Z", DVec3::Z, 0x6a_a8ff)];
    let mut axes = axes.map(|(name, axis, color)| (name, basis.to_camera(axis), Color::from_u32(color)));
    axes.sort_by(|a, b| a.1.z.total_cmp(&b.1.z));
    let reach = f64::from(canvas.pixels_of(AXIS));
    let room = canvas.pixels_of(AXIS + 4.0 * MARGIN);
    let center = Point::new(room, lower - room);
    let half = canvas.text_size("X").map(|side| side / 2);
    for (name, axis, color) in axes {
        let to = |length: f64| center + Point::new((axis.x * length) as i32, (-axis.y * length) as i32);
        let style = PrimitiveStyle::with_stroke(rgb(color), canvas.pixels_of(2.0) as u32);
        let Ok(()) = Line::new(center, to(reach)).into_styled(style).draw(canvas);
        let sign = to(reach + f64::from(half[1]) + 3.0);
        canvas.text([sign.x - half[0], sign.y - half[1]], name, color);
    }
}
