//! Shading by a closure: colours blended over a triangle, half-transparent ones, and holes.
#![expect(clippy::print_stdout, reason = "says where the picture is")]

use std::error::Error;

use polosa_examples::{picture, save};
use polosa_raster::{Clip, Depth, DepthTest, Flat, Fragment, State, Target};

const WIDTH: u32 = 320;
const HEIGHT: u32 = 240;

fn main() -> Result<(), Box<dyn Error>> {
    let mut color = vec![0_u32; (WIDTH * HEIGHT) as usize];
    let mut depth = vec![0.0_f32; color.len()];
    let mut target = Target::new(&mut color, Depth::F32(&mut depth), WIDTH, HEIGHT, WIDTH as usize)?;
    target.clear(0x2b_2b2b, DepthTest::Greater);
    let state = State::default();

    // 1. Each corner has a colour; the weights say how much of each.
    let corners: [Clip; 3] = [[-0.9, -0.8, 0.4, 1.0], [0.7, -0.8, 0.4, 1.0], [-0.1, 0.9, 0.4, 1.0]];
    let blended = |fragment: &Fragment<'_>, pixel: &mut u32| {
        let [r, g, b] = fragment.weights().map(|weight| (weight * 255.0 + 0.5) as u32);
        *pixel = r << 16 | g << 8 | b;
        true
    };
    target.triangles(&state, &corners, &[[0, 1, 2]], &blended);

    // 2. Half of what is there, half white; depth is tested but not written, so that glass hides nothing.
    let glass: [Clip; 3] = [[-0.5, 0.6, 0.6, 1.0], [0.9, -0.2, 0.6, 1.0], [0.8, 0.9, 0.6, 1.0]];
    let half = |_: &Fragment<'_>, pixel: &mut u32| {
        *pixel = ((*pixel >> 1) & 0x7f_7f7f) + 0x7f_7f7f;
        true
    };
    target.triangles(&State { write: false, ..state }, &glass, &[[0, 1, 2]], &half);

    // 3. A grille: where the closure says `false`, the depth stays as it was.
    let grille: [Clip; 3] = [[-0.9, 0.1, 0.8, 1.0], [0.1, -0.9, 0.8, 1.0], [-0.9, -0.9, 0.8, 1.0]];
    let bars = |fragment: &Fragment<'_>, pixel: &mut u32| {
        let kept = fragment.x() % 12 < 4 || fragment.y() % 12 < 4;
        if kept {
            *pixel = 0xff_c040;
        }
        kept
    };
    target.triangles(&state, &grille, &[[0, 1, 2]], &bars);
    let [hole, bar] = [[56, 174], [48, 174]];
    assert_eq!(target.color_at(bar[0], bar[1]), Some(0xff_c040));

    // What lies behind the bars comes through the holes, and only there.
    let behind: [Clip; 3] = [[-0.85, -0.2, 0.7, 1.0], [-0.4, -0.3, 0.7, 1.0], [-0.65, -0.75, 0.7, 1.0]];
    target.triangles(&state, &behind, &[[0, 1, 2]], &Flat(0x40_60a0));
    assert_eq!(target.color_at(bar[0], bar[1]), Some(0xff_c040), "the bar hides it");
    assert_eq!(target.color_at(hole[0], hole[1]), Some(0x40_60a0), "the hole does not");

    println!("{}", save("blend.png", &picture(WIDTH, HEIGHT, color))?.display());
    Ok(())
}
