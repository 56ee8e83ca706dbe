//! What the raster core makes of triangles and lines, pixel by pixel, magnified.

use std::error::Error;

use polosa_raster::{Clip, Depth, DepthTest, Fragment, Space, State, Target};
use polosa_scene::Picture;

use crate::kit::{BLUE, Canvas, FAINT, GREEN, GREY, INK, ORANGE, PAPER, Point, RED};

const CELL: f32 = 40.0;
const STATE: State = State {
    space: Space::Screen,
    cull: polosa_raster::Cull::None,
    test: DepthTest::Off,
    write: false,
    scissor: None,
    sample: polosa_raster::Sample::CENTER,
};

/// A small picture and where it lies on a canvas.
struct Grid {
    columns: u32,
    rows: u32,
    origin: Point,
}

impl Grid {
    fn place(&self, [x, y]: Point) -> Point {
        [self.origin[0] + x * CELL, self.origin[1] + y * CELL]
    }

    /// How often each pixel is drawn on by each of up to six triangles.
    fn counts(&self, vertices: &[Point], triangles: &[[u32; 3]]) -> Result<Vec<[u8; 6]>, Box<dyn Error>> {
        let vertices: Vec<Clip> = vertices.iter().map(|&[x, y]| [x, y, 0.5, 1.0]).collect();
        // A pixel is any `Copy` value: here, six counters.
        let mut counts = vec![[0; 6]; (self.columns * self.rows) as usize];
        let mut target =
            Target::new(&mut counts, Depth::None, self.columns, self.rows, self.columns as usize)?;
        let count = |fragment: &Fragment<'_>, pixel: &mut [u8; 6]| {
            pixel[fragment.triangle()] += 1;
            true
        };
        target.triangles(&STATE, &vertices, triangles, &count);
        Ok(counts)
    }

    /// Which pixels a line draws on.
    fn line(&self, ends: [Point; 2]) -> Result<Vec<bool>, Box<dyn Error>> {
        let vertices = ends.map(|[x, y]| [x, y, 0.5, 1.0]);
        let mut drawn = vec![false; (self.columns * self.rows) as usize];
        let mut target =
            Target::new(&mut drawn, Depth::None, self.columns, self.rows, self.columns as usize)?;
        target.lines(&STATE, &vertices, &[[0, 1]], true);
        Ok(drawn)
    }

    fn pixels(&self) -> impl Iterator<Item = (usize, Point)> + use<> {
        let columns = self.columns;
        (0..columns * self.rows).map(move |k| (k as usize, [(k % columns) as f32, (k / columns) as f32]))
    }

    fn fill(&self, canvas: &mut Canvas, [x, y]: Point, color: u32) -> Result<(), Box<dyn Error>> {
        canvas.rectangle(self.place([x, y]), self.place([x + 1.0, y + 1.0]), color)
    }

    fn rule(&self, canvas: &mut Canvas) -> Result<(), Box<dyn Error>> {
        let (w, h) = (self.columns as f32, self.rows as f32);
        for x in 0..=self.columns {
            canvas.line(self.place([x as f32, 0.0]), self.place([x as f32, h]), 1.0, FAINT)?;
        }
        for y in 0..=self.rows {
            canvas.line(self.place([0.0, y as f32]), self.place([w, y as f32]), 1.0, FAINT)?;
        }
        Ok(())
    }
}

fn single(columns: u32, rows: u32) -> (Canvas, Grid) {
    let canvas = Canvas::new(columns * CELL as u32 + 1, rows * CELL as u32 + 1);
    (canvas, Grid { columns, rows, origin: [0.5, 0.5] })
}

/// The top-left rule: a triangle whose sides run through samples.
pub(crate) fn samples() -> Result<Picture, Box<dyn Error>> {
    let (mut canvas, grid) = single(12, 9);
    let corners: [Point; 3] = [[2.5, 1.5], [9.5, 1.5], [2.5, 8.5]];
    let counts = grid.counts(&corners, &[[0, 1, 2]])?;
    for (k, pixel) in grid.pixels().filter(|(k, _)| counts[*k][0] > 0) {
        assert_eq!(counts[k][0], 1);
        grid.fill(&mut canvas, pixel, ORANGE)?;
    }
    grid.rule(&mut canvas)?;
    canvas.outline(&corners.map(|c| grid.place(c)), 2.5, BLUE)?;
    for (k, [x, y]) in grid.pixels() {
        let (x, y) = (x + 0.5, y + 0.5);
        let at = grid.place([x, y]);
        let (left_or_top, right) = (x == 2.5 || y == 1.5, x + y == 11.0);
        let on_side = (left_or_top || right) && x >= 2.5 && y >= 1.5 && x + y <= 11.0;
        match (on_side, counts[k][0] > 0) {
            (true, true) => canvas.ring(at, 7.0, GREEN, PAPER)?,
            (true, false) => canvas.ring(at, 7.0, RED, PAPER)?,
            (false, covered) => canvas.dot(at, 3.5, if covered { INK } else { GREY })?,
        }
        assert_eq!(counts[k][0] > 0, x >= 2.5 && y >= 1.5 && x + y < 11.0, "the rule, at ({x}, {y})");
    }
    Ok(canvas.finish())
}

/// Sorted corners, the two sides of a row, and the strips between them.
pub(crate) fn strips() -> Result<Picture, Box<dyn Error>> {
    let (columns, rows) = (11, 9);
    let panel = columns * CELL as u32;
    let mut canvas = Canvas::new(2 * panel + 41, rows * CELL as u32 + 1);
    // Sorted from top to bottom: the middle corner lies right of the long side, and left of it.
    let shapes: [[Point; 3]; 2] =
        [[[3.2, 0.7], [9.9, 3.9], [1.3, 8.4]], [[6.9, 0.7], [0.8, 5.3], [9.7, 8.4]]];
    for (number, corners) in shapes.into_iter().enumerate() {
        let origin = [number as f32 * (panel + 40) as f32 + 0.5, 0.5];
        let grid = Grid { columns, rows, origin };
        let counts = grid.counts(&corners, &[[0, 1, 2]])?;
        let covered = |x: u32, y: u32| counts[(y * columns + x) as usize][0] > 0;
        for y in 0..rows {
            let row: Vec<u32> = (0..columns).filter(|&x| covered(x, y)).collect();
            if let (Some(&first), Some(&last)) = (row.first(), row.last()) {
                assert_eq!(row.len() as u32, last + 1 - first, "a strip has no holes");
                let (a, b) = ([first as f32, y as f32 + 0.12], [last as f32 + 1.0, y as f32 + 0.88]);
                canvas.rectangle(grid.place(a), grid.place(b), ORANGE)?;
            }
        }
        grid.rule(&mut canvas)?;
        for (k, [x, y]) in grid.pixels() {
            let color = if counts[k][0] > 0 { INK } else { GREY };
            canvas.dot(grid.place([x + 0.5, y + 0.5]), 2.5, color)?;
        }
        let [top, middle, bottom] = corners.map(|corner| grid.place(corner));
        // The turn: from the row of the middle corner on, another side counts.
        let (left, right) = (grid.place([0.0, 0.0])[0], grid.place([columns as f32, 0.0])[0]);
        canvas.dashes([left, middle[1]], [right, middle[1]], 1.5, INK)?;
        canvas.line(top, bottom, 4.0, BLUE)?;
        canvas.line(top, middle, 4.0, RED)?;
        canvas.line(middle, bottom, 4.0, GREEN)?;
        for corner in [top, middle, bottom] {
            canvas.ring(corner, 8.0, INK, PAPER)?;
        }
    }
    Ok(canvas.finish())
}

/// Triangles around a point, all corners on samples: each pixel is drawn once.
pub(crate) fn shared() -> Result<Picture, Box<dyn Error>> {
    const SHADES: [u32; 6] = [0xf0_b46a, 0x8f_b8dc, 0xa6_cfae, 0xe3_9c8f, 0xc9_b2dc, 0xe2_d47c];
    let (mut canvas, grid) = single(15, 11);
    let vertices: [Point; 7] =
        [[7.5, 5.5], [1.5, 3.5], [5.5, 1.5], [12.5, 0.5], [13.5, 6.5], [8.5, 9.5], [3.5, 9.5]];
    let triangles: Vec<[u32; 3]> = (0..6).map(|k| [0, k + 1, (k + 1) % 6 + 1]).collect();
    let counts = grid.counts(&vertices, &triangles)?;
    for (k, pixel) in grid.pixels() {
        assert!(counts[k].iter().sum::<u8>() <= 1, "no pixel is drawn twice");
        if let Some(owner) = counts[k].iter().position(|&count| count > 0) {
            grid.fill(&mut canvas, pixel, SHADES[owner])?;
        }
    }
    grid.rule(&mut canvas)?;
    for triangle in &triangles {
        canvas.outline(&triangle.map(|k| grid.place(vertices[k as usize])), 2.0, INK)?;
    }
    for (k, [x, y]) in grid.pixels() {
        let color = if counts[k].iter().sum::<u8>() == 1 { INK } else { GREY };
        canvas.dot(grid.place([x + 0.5, y + 0.5]), 2.5, color)?;
    }
    Ok(canvas.finish())
}

/// Two lines in a row, and the diamonds that they leave.
pub(crate) fn lines() -> Result<Picture, Box<dyn Error>> {
    let (mut canvas, grid) = single(15, 8);
    let points: [Point; 3] = [[1.6, 1.4], [11.55, 5.3], [5.2, 7.2]];
    let pairs = [[points[0], points[1]], [points[1], points[2]]];
    let drawn = [grid.line(pairs[0])?, grid.line(pairs[1])?];
    for (k, pixel) in grid.pixels() {
        assert!(!(drawn[0][k] && drawn[1][k]), "the joint's pixel is drawn once");
        for (which, color) in [(0, ORANGE), (1, 0x8f_b8dc)] {
            if drawn[which][k] {
                grid.fill(&mut canvas, pixel, color)?;
            }
        }
    }
    grid.rule(&mut canvas)?;
    for (_, [x, y]) in grid.pixels() {
        let diamond = [[x + 0.5, y], [x + 1.0, y + 0.5], [x + 0.5, y + 1.0], [x, y + 0.5]];
        canvas.outline(&diamond.map(|corner| grid.place(corner)), 1.0, GREY)?;
    }
    for [a, b] in pairs.map(|pair| pair.map(|point| grid.place(point))) {
        canvas.arrow(a, b, 3.0, INK)?;
    }
    for point in points {
        canvas.ring(grid.place(point), 6.0, INK, PAPER)?;
    }
    Ok(canvas.finish())
}
