//! A triangle into an array of bytes, with the raster core alone: no allocation, no file, no window.
#![expect(clippy::print_stdout, reason = "the picture is text")]

use polosa_raster::{Clip, Depth, DepthTest, Flat, State, Target, TargetError};

const WIDTH: u32 = 48;
const HEIGHT: u32 = 20;

fn main() -> Result<(), TargetError> {
    let mut color = [0_u8; (WIDTH * HEIGHT) as usize];
    let mut depth = [0.0_f32; (WIDTH * HEIGHT) as usize];
    let mut target = Target::new(&mut color, Depth::F32(&mut depth), WIDTH, HEIGHT, WIDTH as usize)?;
    target.clear(b'.', DepthTest::Greater);

    // In clip space: x to the right, y up, both from −1 to 1; depth 1 is near, 0 far; w is 1 without perspective.
    let corners: [Clip; 6] = [
        [-0.9, -0.9, 0.9, 1.0],
        [0.5, -0.5, 0.1, 1.0],
        [-0.3, 0.9, 0.5, 1.0],
        [0.9, 0.8, 0.5, 1.0],
        [-0.8, 0.3, 0.5, 1.0],
        [0.4, -0.9, 0.5, 1.0],
    ];
    // The two pierce each other: each is nearer in its own part.
    let a = target.triangles(&State::default(), &corners, &[[0, 1, 2]], &Flat(b'#'));
    let b = target.triangles(&State::default(), &corners, &[[3, 4, 5]], &Flat(b'o'));
    assert_eq!(a.drawn + b.drawn, 2);
    assert_eq!(target.color_at(10, 15), Some(b'#'), "the first is nearer on the left");
    assert_eq!(target.color_at(30, 12), Some(b'o'), "the second is nearer on the right");

    for row in color.chunks(WIDTH as usize) {
        println!("{}", String::from_utf8_lossy(row));
    }
    Ok(())
}
