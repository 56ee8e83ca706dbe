//! A whole frame with the raster core alone: 8,192 triangles by two threads, into a picture, and what comes of it
//! is what drawing them one by one gives.
#![expect(clippy::print_stdout, reason = "the picture is text")]

use polosa_raster::{Columns, Depth, DepthTest, PerTriangle, State, StoredDepth, Target, TargetError};
use polosa_raster::{Frame, Level, Triangles, Vertices, transform};

const SIDE: u32 = 64;
const SIZE: [u32; 2] = [640, 480];
const PIXELS: usize = 640 * 480;
/// A look from the front and above: x to the right, h up, y away, where w grows.
const MATRIX: Columns =
    [[0.62, 0.0, 0.0, 0.0], [0.0, 1.1, 0.0, 0.0], [0.0, 0.6, 0.0, 0.4], [0.0, -0.4, 0.5, 1.0]];

fn main() -> Result<(), TargetError> {
    // A hill with a pit on top, over a grid of squares, each of two triangles.
    let place = |k: u32| k as f32 / SIDE as f32 * 2.0 - 1.0;
    let hill =
        |x: f32, y: f32| (0.1 + 4.0 * (x * x + y * y)) / (1.0 + 20.0 * (x * x + y * y) * (x * x + y * y));
    let grid = (0..=SIDE).flat_map(|j| (0..=SIDE).map(move |i| [place(i), place(j)]));
    let positions: Vec<[f32; 3]> = grid.map(|[x, y]| [x, hill(x, y), y]).collect();
    let corners = (0..SIDE).flat_map(|j| (0..SIDE).map(move |i| j * (SIDE + 1) + i));
    let squares = corners.flat_map(|a| [[a, a + 1, a + SIDE + 2], [a, a + SIDE + 2, a + SIDE + 1]]);
    let triangles: Vec<[u32; 3]> = squares.collect();
    // A value is any 32 bits; here how high a triangle lies.
    let value = |k: usize| (positions[triangles[k][0] as usize][1] * 18.0) as u32 + 1;

    // Sort all triangles into tiles, then draw the tiles.
    let mut frame = Frame::with(Level::detect(), 2);
    frame.begin(SIZE, 0, StoredDepth::F32(0.0))?;
    let vertices = Vertices::Model { matrix: &MATRIX, positions: &positions };
    let stats = frame.draw(&State::default(), 0, vertices, Triangles::Indexed(&triangles), value);
    let (mut color, mut depth) = (vec![7; PIXELS], vec![7.0; PIXELS]);
    frame.finish(&mut Target::new(
        &mut color,
        Depth::F32(&mut depth),
        SIZE[0],
        SIZE[1],
        SIZE[0] as usize,
    )?)?;

    // One by one: every pixel, every depth and every count is the same.
    let mut clip = vec![[0.0; 4]; positions.len()];
    transform(&MATRIX, &positions, &mut clip);
    let (mut expected, mut depths) = (vec![0; PIXELS], vec![0.0; PIXELS]);
    let mut target = Target::new(&mut expected, Depth::F32(&mut depths), SIZE[0], SIZE[1], SIZE[0] as usize)?;
    target.clear(0, DepthTest::Greater);
    assert_eq!(stats, target.triangles(&State::default(), &clip, &triangles, &PerTriangle(value)));
    assert_eq!((stats.submitted, stats.drawn), (8_192, 8_192));
    assert!(color == expected && depth == depths);

    for row in color.chunks(SIZE[0] as usize).step_by(16) {
        let marks = row.iter().step_by(8).map(|&value| b" .:-=+*#%@"[value.min(9) as usize]);
        println!("{}", String::from_utf8_lossy(&marks.collect::<Vec<u8>>()));
    }
    Ok(())
}
