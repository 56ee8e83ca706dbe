//! Snapping: a window of twenty by twelve sub-pixels, three vertices, and where they go.

use std::error::Error;

use polosa_math::{SUB_PIXELS, Viewport};
use polosa_scene::Picture;

use crate::kit::{BLUE, Canvas, FAINT, GREY, INK, ORANGE, PAPER, Point, RED};

const COLUMNS: u32 = 20;
const ROWS: u32 = 12;
const CELL: f32 = 30.0;

/// The sub-pixel in the window's upper left corner: 8 left and 4 up of a corner of the pixel grid.
const CORNER: [f64; 2] = [256.0 * 300.0 - 8.0, 256.0 * 200.0 - 4.0];

pub(crate) fn snap() -> Result<Picture, Box<dyn Error>> {
    let viewport = Viewport::new(640, 480);
    let mut canvas = Canvas::new(COLUMNS * CELL as u32, ROWS * CELL as u32);
    let place = |[x, y]: [f64; 2]| -> Point {
        [((x - CORNER[0]) as f32 + 0.5) * CELL, ((y - CORNER[1]) as f32 + 0.5) * CELL]
    };

    // Vertices as a program has them: f32 in clip space.
    let wanted = [[2.37, 8.62], [16.71, 9.44], [10.56, 1.28]];
    let clip = wanted.map(|[x, y]| {
        let [sx, sy] = [CORNER[0] + x, CORNER[1] + y];
        [
            ((sx - viewport.offset[0]) / viewport.scale[0]) as f32,
            ((sy - viewport.offset[1]) / viewport.scale[1]) as f32,
        ]
    });
    let exact = clip.map(|[x, y]| viewport.to_sub_pixels(x.into(), y.into(), 1.0));
    let snapped = exact.map(|v| v.map(f64::round_ties_even));

    canvas.polygon(&snapped.map(place), ORANGE)?;
    for x in 0..COLUMNS {
        for y in 0..ROWS {
            canvas.dot([(x as f32 + 0.5) * CELL, (y as f32 + 0.5) * CELL], 1.8, GREY)?;
        }
    }
    // The border between pixels, where a coordinate is a multiple of 256.
    let [bx, by] = place(CORNER.map(|c| (c / f64::from(SUB_PIXELS)).ceil() * f64::from(SUB_PIXELS)));
    let (width, height) = (COLUMNS as f32 * CELL, ROWS as f32 * CELL);
    canvas.line([bx, 0.0], [bx, height], 4.0, FAINT)?;
    canvas.line([0.0, by], [width, by], 4.0, FAINT)?;

    let exact_points = exact.map(place);
    for k in 0..3 {
        canvas.dashes(exact_points[k], exact_points[(k + 1) % 3], 1.5, GREY)?;
    }
    canvas.outline(&snapped.map(place), 2.5, BLUE)?;
    for (from, to) in exact.into_iter().zip(snapped) {
        let moved = [0, 1].map(|k| (to[k] - from[k]).abs());
        assert!(moved.iter().all(|&m| m <= 0.5), "moved by {moved:?} of a sub-pixel");
        canvas.line(place(from), place(to), 2.0, RED)?;
        canvas.ring(place(from), 5.0, RED, PAPER)?;
        canvas.dot(place(to), 5.0, INK)?;
    }
    Ok(canvas.finish())
}
