//! Panels of magnified pixels side by side, wrong ones marked, thin lines over them.
//!
//! ```text
//!   ┌─┬─┬─┐  ┌─┬─┬─┐      a wrong pixel is red;
//!   ├─┼▣┼─┤  ├─┼─┼─┤      where it is large enough, its middle
//!   └─┴─┴─┘  └─┴─┴─┘      keeps the colour that the method gave it
//!    method   exact
//! ```

use std::error::Error;

use polosa_examples::picture;
use polosa_raster::reference::{Corner, Coverage, Methods, ZBuffer, draw_screen};
use polosa_raster::{Clip, Depth, DepthTest, Flat, Rect, Space, State, Target};
use polosa_scene::Picture;
use polosa_stability::oracle::coverage::{CENTRE, Vertex, covers};

pub(crate) const PAPER: u32 = 0xfa_f8f4;
pub(crate) const INK: u32 = 0x2b_3038;
pub(crate) const GREY: u32 = 0xb8_b2a6;
pub(crate) const BLUE: u32 = 0x5b_8fc7;
pub(crate) const ORANGE: u32 = 0xf0_b46a;
pub(crate) const GREEN: u32 = 0x7f_b58a;
/// The colour of what is wrong, and of nothing else.
pub(crate) const RED: u32 = 0xe0_1238;
/// Between magnified pixels.
const GRID: u32 = 0xdc_d7cc;

/// What surrounds panels, in the picture's pixels.
const MARGIN: u32 = 10;

/// A finished row of the gallery.
pub(crate) struct Drawing {
    pub(crate) picture: Picture,
    /// What was counted, as the document says it.
    pub(crate) figures: String,
}

pub(crate) type Made = Result<Drawing, Box<dyn Error>>;

/// Pixels to be magnified.
pub(crate) struct Panel {
    size: [u32; 2],
    /// A colour, and whether it is wrong.
    cells: Vec<(u32, bool)>,
    /// From, to, in cells; colour.
    lines: Vec<([f64; 2], [f64; 2], u32)>,
}

impl Panel {
    /// Each cell's colour from its column and row.
    pub(crate) fn new(size: [u32; 2], color: impl Fn(u32, u32) -> u32) -> Self {
        let places = (0..size[1]).flat_map(|y| (0..size[0]).map(move |x| (x, y)));
        Self { size, cells: places.map(|(x, y)| (color(x, y), false)).collect(), lines: Vec::new() }
    }

    /// Cells from a list, row by row.
    pub(crate) fn of(size: [u32; 2], colors: &[u32]) -> Self {
        Self::new(size, |x, y| colors[(y * size[0] + x) as usize])
    }

    /// Marks what is wrong.
    pub(crate) fn marked(mut self, wrong: &[bool]) -> Self {
        for (cell, &wrong) in self.cells.iter_mut().zip(wrong) {
            cell.1 = wrong;
        }
        self
    }

    /// A line over the cells.
    pub(crate) fn line(mut self, from: [f64; 2], to: [f64; 2], color: u32) -> Self {
        self.lines.push((from, to, color));
        self
    }

    /// The sides of triangles.
    pub(crate) fn outlined(self, triangles: &[[Corner; 3]], color: u32) -> Self {
        let sides = triangles.iter().flat_map(|[a, b, c]| [(a, b), (b, c), (c, a)]);
        sides.fold(self, |panel, (a, b)| panel.line([a[0], a[1]], [b[0], b[1]], color))
    }
}

/// Panels of one size beside each other, each cell `zoom` pixels wide.
pub(crate) fn sheet(panels: &[Panel], zoom: u32) -> Result<Picture, Box<dyn Error>> {
    let [columns, rows] = panels[0].size;
    let (inner, height) = ([columns * zoom, rows * zoom], rows * zoom + 2 * MARGIN);
    let width = panels.len() as u32 * (inner[0] + MARGIN) + MARGIN;
    let mut pixels = vec![PAPER; (width * height) as usize];
    let mut target = Target::new(&mut pixels, Depth::None, width, height, width as usize)?;
    let flat = State { space: Space::Screen, test: DepthTest::Off, ..State::default() };
    for (panel, k) in panels.iter().zip(0..) {
        let [left, top] = [MARGIN + k * (inner[0] + MARGIN), MARGIN];
        let mut block = |[x, y]: [u32; 2], [w, h]: [u32; 2], color: u32| {
            let [x0, y0, x1, y1] = [x, y, x + w, y + h].map(|v| v as f32);
            let corners: [Clip; 4] = [[x0, y0], [x1, y0], [x1, y1], [x0, y1]].map(|[x, y]| [x, y, 0.5, 1.0]);
            target.triangles(&flat, &corners, &[[0, 1, 2], [0, 2, 3]], &Flat(color));
        };
        // A grid where there is room for one; else a frame alone.
        let (side, frame) = if zoom >= 5 { (zoom - 1, 1) } else { (zoom, 2) };
        block([left - 1, top - 1], inner.map(|v| v + frame), GRID);
        for (&(color, wrong), cell) in panel.cells.iter().zip(0..) {
            let at = [left + cell % columns * zoom, top + cell / columns * zoom];
            block(at, [side; 2], if wrong { RED } else { color });
            if wrong && zoom >= 7 {
                let rim = zoom / 3;
                block(at.map(|v| v + rim), [side - 2 * rim; 2], color);
            }
        }
        let within = Rect { x0: left, y0: top, x1: left + inner[0], y1: top + inner[1] };
        for &(from, to, color) in &panel.lines {
            let place = |[x, y]: [f64; 2]| -> Clip {
                let [x, y] = [x * f64::from(zoom) + f64::from(left), y * f64::from(zoom) + f64::from(top)];
                [x as f32, y as f32, 0.5, 1.0]
            };
            let state = State { scissor: Some(within), ..flat };
            target.lines(&state, &[place(from), place(to)], &[[0, 1]], color);
        }
    }
    Ok(picture(width, height, pixels))
}

/// What was drawn at each pixel: 1 + the index of the last triangle, or 0; and how often.
pub(crate) struct Filled {
    pub(crate) ids: Vec<u32>,
    pub(crate) times: Vec<u32>,
}

/// Triangles filled by a method, each on top of those before it.
pub(crate) fn filled(coverage: Coverage, size: [u32; 2], triangles: &[[Corner; 3]]) -> Filled {
    let count = (size[0] * size[1]) as usize;
    let (mut ids, mut times) = (vec![0; count], vec![0; count]);
    for (corners, id) in triangles.iter().zip(1..) {
        coverage.pixels(size[0], size[1], corners, &mut |x, y| {
            let at = (y * size[0] + x) as usize;
            ids[at] = id;
            times[at] += 1;
        });
    }
    Filled { ids, times }
}

/// How often each pixel is to be drawn: half-planes in integers, and polosa does so, or it is no picture of ours.
/// Corners are whole numbers of 1/256 pixel.
pub(crate) fn truth(size: [u32; 2], triangles: &[[Corner; 3]]) -> Vec<u32> {
    let vertices: Vec<[Vertex; 3]> =
        triangles.iter().map(|t| t.map(|[x, y, _]| [x, y].map(|v| (v * 256.0) as i64))).collect();
    let times = |k: u32| {
        let [i, j] = [k % size[0], k / size[0]].map(i64::from);
        vertices.iter().filter(|t| covers(t, i, j, CENTRE)).count() as u32
    };
    let truth: Vec<u32> = (0..size[0] * size[1]).map(times).collect();
    assert_eq!(filled(Coverage::Strips, size, triangles).times, truth, "the exact side is exact");
    truth
}

/// What is seen at each pixel, and at what depth, by a pair of methods.
pub(crate) fn seen(
    methods: Methods,
    [width, height]: [u32; 2],
    triangles: &[[Corner; 3]],
) -> Result<(Vec<u32>, ZBuffer), Box<dyn Error>> {
    let (mut ids, mut buffer) = (vec![0; (width * height) as usize], ZBuffer::new());
    let mut target = Target::new(&mut ids, Depth::None, width, height, width as usize)?;
    draw_screen(&mut target, &mut buffer, methods, &State::default(), triangles, |k| k + 1);
    Ok((ids, buffer))
}

/// The colours of triangles: 0 is none.
pub(crate) fn colors(ids: &[u32]) -> Vec<u32> {
    ids.iter().map(|&id| if id == 0 { PAPER } else { [BLUE, ORANGE, GREEN][(id as usize - 1) % 3] }).collect()
}

/// Where two lists differ.
pub(crate) fn differing<T: PartialEq>(a: &[T], b: &[T]) -> Vec<bool> {
    a.iter().zip(b).map(|(a, b)| a != b).collect()
}

/// How many are marked, with commas.
pub(crate) fn marks(wrong: &[bool]) -> String {
    count(wrong.iter().filter(|&&wrong| wrong).count())
}

/// A number with a comma before each three digits.
pub(crate) fn count(number: usize) -> String {
    let digits = number.to_string();
    let comma = |k: usize| k > 0 && (digits.len() - k).is_multiple_of(3);
    digits
        .chars()
        .enumerate()
        .flat_map(|(k, digit)| comma(k).then_some(',').into_iter().chain([digit]))
        .collect()
}
