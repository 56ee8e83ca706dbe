//! Figures: panels side by side, each with two logarithmic axes, drawn as SVG.
//!
//! ```text
//!   title                                    what the figure says
//!   note
//!   ┌ panel ───────────┐ ┌ panel ─────────┐
//!   │   ○ name         │ │                │  names stand beside what they name; where there is no room for one,
//!   │  ╱   ● name      │ │                │  it goes to a line above the panel
//!   │ ○   ╱            │ │                │
//!   │0┆ ●              │ │                │  zero has a place of its own
//!   └──────────────────┘ └────────────────┘
//! ```
//!
//! The background is white and opaque, so that a figure can be read on pages of any colour; text is set in whatever
//! sans-serif the reader has. Colours are those of Okabe and Ito, which the colour-blind can tell apart; no series is
//! told from others by colour alone.

mod axis;
mod draw;
mod front;
mod place;

use plotters::prelude::*;

pub(crate) use self::axis::Axis;
use self::draw::Canvas;

/// What a file shows.
#[derive(Clone, Debug)]
pub(crate) struct Figure {
    pub(crate) title: String,
    /// Lines below the title.
    pub(crate) notes: Vec<String>,
    pub(crate) panels: Vec<Panel>,
    /// How many panels stand side by side.
    pub(crate) columns: usize,
}

/// One diagram.
#[derive(Clone, Debug, Default)]
pub(crate) struct Panel {
    pub(crate) title: String,
    pub(crate) x: Axis,
    pub(crate) y: Axis,
    pub(crate) series: Vec<Series>,
    pub(crate) guides: Vec<Guide>,
    /// Whether the Pareto front of all points is drawn: less is then better on both axes.
    pub(crate) front: bool,
}

/// Points that belong together.
#[derive(Clone, Debug)]
pub(crate) struct Series {
    /// Stands beside one of the points, in their colour; may be empty.
    pub(crate) name: String,
    pub(crate) color: Color,
    pub(crate) mark: Mark,
    pub(crate) line: Line,
    pub(crate) points: Vec<Point>,
}

/// What was measured.
#[derive(Clone, Debug, Default, PartialEq)]
pub(crate) struct Point {
    pub(crate) at: [f64; 2],
    /// Half the length of the bars through it, in both directions.
    pub(crate) spread: [f64; 2],
    /// Stands beside it; may be empty.
    pub(crate) name: String,
}

impl Point {
    pub(crate) const fn new(at: [f64; 2], spread: [f64; 2]) -> Self {
        Self { at, spread, name: String::new() }
    }
}

/// What a point looks like.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Mark {
    Disc,
    Ring,
    Square,
    Diamond,
}

/// How points are joined.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Line {
    None,
    Solid,
    Dashed,
}

/// A thin line to compare with.
#[derive(Clone, Debug)]
pub(crate) enum Guide {
    /// Twice the x, twice the y: through this point.
    Proportional([f64; 2], String),
    /// One y for every x.
    Level(f64, String),
}

/// Colours that everybody can tell apart.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Color {
    Blue,
    Vermilion,
    Green,
    Purple,
    Orange,
    Black,
}

impl Color {
    const fn rgb(self) -> RGBColor {
        match self {
            Self::Blue => RGBColor(0, 0x72, 0xb2),
            Self::Vermilion => RGBColor(0xd5, 0x5e, 0),
            Self::Green => RGBColor(0, 0x8a, 0x66),
            Self::Purple => RGBColor(0xb0, 0x58, 0x90),
            Self::Orange => RGBColor(0xb5, 0x7a, 0),
            Self::Black => RGBColor(0x22, 0x22, 0x22),
        }
    }
}

/// SVG files, by their names without ending, and their text.
pub(crate) type Drawings = Vec<(&'static str, String)>;

/// Width and height of a panel in pixels of the drawing; pages show it at half of that or less.
const PANEL: [i32; 2] = [1160, 1000];
/// The height of the figure's title, and of each line below it.
const TITLE: i32 = 64;
const NOTE: i32 = 36;

impl Figure {
    /// The figure as SVG.
    pub(crate) fn svg(&self) -> Result<String, String> {
        let columns = self.columns.clamp(1, self.panels.len().max(1));
        let rows = self.panels.len().div_ceil(columns);
        let top = TITLE + NOTE * self.notes.len() as i32 + 16;
        let size = [PANEL[0] * columns as i32, top + PANEL[1] * rows as i32];
        let mut text = String::new();
        {
            let canvas = Canvas::new(&mut text, size)?;
            canvas.text(&self.title, [40, 22], 36, Color::Black.rgb(), true)?;
            for (note, y) in self.notes.iter().zip((TITLE + 10..).step_by(NOTE as usize)) {
                canvas.text(note, [40, y], 25, draw::GREY, false)?;
            }
            for (k, panel) in self.panels.iter().enumerate() {
                let at = [(k % columns) as i32 * PANEL[0], top + (k / columns) as i32 * PANEL[1]];
                canvas.panel(panel, at, PANEL)?;
            }
            canvas.finish()?;
        }
        Ok(text)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn panel() -> Panel {
        let series = |name: &str, line, mark, points: &[[f64; 2]]| Series {
            name: name.to_owned(),
            color: Color::Blue,
            mark,
            line,
            points: points.iter().map(|&at| Point::new(at, [0.0, at[1] / 9.0])).collect(),
        };
        Panel {
            title: "a < b & c".to_owned(),
            x: Axis::of("ns"),
            y: Axis::of("wrong").within(1e-3, 1e3),
            series: vec![
                series("exact", Line::Solid, Mark::Disc, &[[1.0, 0.0], [20.0, 0.0]]),
                series("rough", Line::Dashed, Mark::Diamond, &[[0.5, 3.0], [30.0, 500.0]]),
                series("", Line::Solid, Mark::Square, &[[f64::NAN, 1.0]]),
            ],
            guides: vec![
                Guide::Level(7.0, "limit".to_owned()),
                Guide::Proportional([1.0, 1.0], "proportional".to_owned()),
            ],
            front: true,
        }
    }

    fn figure(panels: Vec<Panel>) -> Figure {
        Figure { title: "Title".to_owned(), notes: vec!["note".to_owned()], panels, columns: 2 }
    }

    #[test]
    fn a_figure_is_opaque_and_says_all_its_names() {
        let svg = figure(vec![panel(), panel(), panel()]).svg().unwrap();
        assert!(svg.starts_with("<svg"), "{svg}");
        let background = svg.lines().find(|line| line.starts_with("<rect")).unwrap();
        assert!(
            background.contains("fill=\"#FFFFFF\"") && background.contains("width=\"2320\""),
            "{background}"
        );
        for name in
            ["Title", "note", "a &lt; b &amp; c", "exact", "rough", "limit", "proportional", "ns", "wrong"]
        {
            assert!(svg.lines().any(|line| line == name), "{name} is missing");
        }
        assert!(!svg.contains("NaN") && svg.contains("sans-serif"));
        assert_eq!(
            svg,
            figure(vec![panel(), panel(), panel()]).svg().unwrap(),
            "another drawing of the same"
        );
    }

    #[test]
    fn nothing_to_draw_is_drawn() {
        assert!(figure(Vec::new()).svg().is_ok());
        assert!(figure(vec![Panel::default()]).svg().is_ok());
    }

    #[test]
    fn names_without_room_stand_above_the_panel() {
        let mut crowded = panel();
        let long = "a name that is much longer than whatever room there is ".repeat(2);
        crowded.series[0].name = long.clone();
        let svg = figure(vec![crowded]).svg().unwrap();
        assert_eq!(svg.lines().filter(|&line| line.trim() == long.trim()).count(), 1);
    }
}
