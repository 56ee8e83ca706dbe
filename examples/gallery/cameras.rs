//! From the world to the screen: what lies behind the eye, attributes, axes that are not of unit length.

use polosa_math::Placement;
use polosa_math::glam::DVec3;
use polosa_math::reference::algebra::length;
use polosa_math::reference::camera::s1::{self, Axes};
use polosa_math::reference::camera::s4::{self, Form};
use polosa_raster::reference::attribute::{Attribute, on_screen};
use polosa_raster::reference::{Corner, Coverage, Hidden, Methods, ZBuffer, draw};
use polosa_raster::{Depth, State, Target, transform};
use polosa_scene::Camera;

use super::kit::{
    BLUE, Drawing, GREY, INK, Made, ORANGE, PAPER, Panel, RED, colors, count, differing, marks, seen, sheet,
};

/// The cube's corners are numbered x + 2y + 4z; its edges.
pub(crate) const EDGES: [[usize; 2]; 12] =
    [[0, 1], [2, 3], [4, 5], [6, 7], [0, 2], [1, 3], [4, 6], [5, 7], [0, 4], [1, 5], [2, 6], [3, 7]];

/// The cube's corners, ±1.
pub(crate) fn corners() -> [[f64; 3]; 8] {
    std::array::from_fn(|k| [0, 1, 2].map(|axis| if k >> axis & 1 == 1 { 1.0 } else { -1.0 }))
}

/// The cube's edges over a panel.
pub(crate) fn cube(panel: Panel, places: &[[f64; 2]; 8], color: u32) -> Panel {
    EDGES.iter().fold(panel, |panel, &[a, b]| panel.line(places[a], places[b], color))
}

/// A floor that runs from behind S1's eye to far away, divided by w as it is, and cut at the near plane.
pub(crate) fn behind() -> Made {
    const SIZE: [u32; 2] = [32, 24];
    // S1's start: the eye at z = 10. The near corners lie 4 units behind it.
    let floor = [[-2.0, -1.5, 14.0], [2.0, -1.5, 14.0], [2.0, -1.5, -20.0], [-2.0, -1.5, -20.0]];
    let halves = [[0, 1, 2], [0, 2, 3]];
    let seed: s1::Camera<f64> = s1::Camera::new(SIZE[0], SIZE[1]);
    let unclipped = halves.map(|half: [usize; 3]| half.map(|k| seed.pixels(floor[k])));
    let methods = Methods { coverage: Coverage::Strips, hidden: Hidden::Order };
    let (mirrored, _) = seen(methods, SIZE, &unclipped)?;

    let mut camera = Camera::new();
    camera.set_aspect(f64::from(SIZE[0]) / f64::from(SIZE[1]))?;
    let mut clip = [[0.0; 4]; 4];
    let positions = floor.map(|p| p.map(|v| v as f32));
    transform(&camera.clip_from_model(&Placement::at(DVec3::ZERO)), &positions, &mut clip);
    let mut exact = vec![0; mirrored.len()];
    let mut target = Target::new(&mut exact, Depth::None, SIZE[0], SIZE[1], SIZE[0] as usize)?;
    let triangles = halves.map(|half| half.map(|k| k as u32));
    draw(&mut target, &mut ZBuffer::new(), methods, &State::default(), &clip, &triangles, |k| k + 1);

    let wrong = differing(&mirrored, &exact);
    let figures = format!("no near clip: {} of {} pixels wrong", marks(&wrong), count(wrong.len()));
    let panels = [Panel::of(SIZE, &colors(&mirrored)).marked(&wrong), Panel::of(SIZE, &colors(&exact))];
    Ok(Drawing { picture: sheet(&panels, 10)?, figures })
}

/// A checkered square, w from 1 to 4, as two triangles.
pub(crate) fn affine() -> Made {
    const SIZE: [u32; 2] = [56, 44];
    // x, y and w; u and v.
    let quad = [
        ([2.0, 42.0], 1.0, [0.0, 0.0]),
        ([54.0, 42.0], 1.0, [1.0, 0.0]),
        ([34.5, 3.0], 4.0, [1.0, 1.0]),
        ([21.5, 3.0], 4.0, [0.0, 1.0]),
    ];
    let mut most = 0.0_f64;
    let mut by = |blend: Attribute| {
        let mut cells = vec![PAPER; (SIZE[0] * SIZE[1]) as usize];
        for half in [[0, 1, 2], [0, 2, 3]] {
            let t = half.map(|k: usize| quad[k]);
            let place: [Corner; 3] = t.map(|([x, y], ..)| [x, y, 0.0]);
            let w = t.map(|(_, w, _)| w);
            Coverage::Strips.pixels(SIZE[0], SIZE[1], &place, &mut |x, y| {
                let weights = on_screen(&place, [f64::from(x) + 0.5, f64::from(y) + 0.5]);
                let value = |way: Attribute, k: usize| way.blend(weights, w, t.map(|(.., uv)| uv[k]));
                most = most.max((value(blend, 1) - value(Attribute::Perspective, 1)).abs());
                let field = [0, 1].map(|k| (value(blend, k) * 8.0) as u32);
                let color = if (field[0] + field[1]).is_multiple_of(2) { BLUE } else { ORANGE };
                cells[(y * SIZE[0] + x) as usize] = color;
            });
        }
        cells
    };
    let (affine, exact) = (by(Attribute::Affine), by(Attribute::Perspective));
    let wrong = differing(&affine, &exact);
    let covered = exact.iter().filter(|&&color| color != PAPER).count();
    let figures = format!(
        "affine: {} of {} pixels have the wrong colour, v is up to {most:.2} off",
        marks(&wrong),
        count(covered)
    );
    let panels = [Panel::of(SIZE, &affine), Panel::of(SIZE, &affine).marked(&wrong), Panel::of(SIZE, &exact)];
    Ok(Drawing { picture: sheet(&panels, 5)?, figures })
}

/// Panels of one pixel a cell.
const WIDE: [u32; 2] = [260, 200];

fn blank() -> Panel {
    Panel::new(WIDE, |_, _| PAPER)
}

/// S1's demonstration, seen along (−3, −4, −8): the axes have the length of a sine.
pub(crate) fn axes() -> Made {
    let mut seed: s1::Camera<f64> = s1::Camera::new(WIDE[0], WIDE[1]);
    seed.set_location([3.0, 4.0, 8.0].map(|v| v * 0.5));
    seed.set_direction([-3.0, -4.0, -8.0].map(|v| v / 89_f64.sqrt()));
    let right = seed.with_axes(Axes::Normalized);
    let places = |camera: &s1::Camera<f64>| {
        corners().map(|p| {
            let [x, y, _] = camera.pixels(p);
            [x, y]
        })
    };
    let (shrunk, exact) = (places(&seed), places(&right));
    let size = length(seed.right());
    let figures = format!("|u| = |v| = {size:.3}: {:.1} % too small", 100.0 * (1.0 - size));
    let panels = [cube(cube(blank(), &exact, GREY), &shrunk, RED), cube(blank(), &exact, INK)];
    Ok(Drawing { picture: sheet(&panels, 1)?, figures })
}

/// The cube from straight above: S1's axes are 0.
pub(crate) fn upright() -> Made {
    let mut seed: s1::Camera<f64> = s1::Camera::new(WIDE[0], WIDE[1]);
    seed.set_location([0.5, 4.0, 0.25]);
    seed.set_direction([0.0, -1.0, 0.0]);
    let seeds = corners().map(|p| seed.pixels(p));
    let one = seeds.iter().all(|[x, y, _]| [*x, *y] == [seeds[0][0], seeds[0][1]]);
    let mut camera = Camera::new();
    camera.set_aspect(f64::from(WIDE[0]) / f64::from(WIDE[1]))?;
    camera.set_position(DVec3::new(0.5, 4.0, 0.25))?;
    camera.set_direction(DVec3::NEG_Y)?;
    let exact = corners()
        .map(|p| camera.project_point(p.into(), WIDE[0], WIDE[1]).map_or([0.0; 2], |at| [at.x, at.y]));
    let distinct = (0..8).filter(|&k| (0..k).all(|l| exact[k] != exact[l])).count();
    let [x, y, _] = seeds[0];
    let figures =
        format!("S1: {} of 8 corners in different places; polosa: {distinct}", if one { 1 } else { 8 });
    let cross = blank().line([x - 4.0, y], [x + 4.0, y], RED).line([x, y - 4.0], [x, y + 4.0], RED);
    let panels = [cross, cube(blank(), &exact, INK)];
    Ok(Drawing { picture: sheet(&panels, 1)?, figures })
}

/// S4's camera with the near plane at 2: what is to be divided by w is divided by 2w.
pub(crate) fn near() -> Made {
    let camera = s4::Camera {
        position: [0.6, 0.75, 7.0],
        axes: [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, -1.0]],
        nearest: [-0.9, -0.9, 2.0],
        farthest: [0.6, 0.3, 50.0],
        size: WIDE.map(f64::from),
    };
    // Pixel centres at whole numbers, y as v: to corners of pixels, y down.
    let places = |form| {
        corners().map(|p| {
            let [x, y, _] = camera.pixels(form, p);
            [x + 0.5, f64::from(WIDE[1]) - 0.5 - y]
        })
    };
    let (printed, mended) = (places(Form::Printed), places(Form::Mended));
    let width = |places: &[[f64; 2]; 8]| {
        let x = places.map(|[x, _]| x);
        x.iter().fold(f64::MIN, |a, &b| a.max(b)) - x.iter().fold(f64::MAX, |a, &b| a.min(b))
    };
    let figures =
        format!("n = 2: the cube is {:.0} pixels wide, and should be {:.0}", width(&printed), width(&mended));
    let panels = [cube(cube(blank(), &mended, GREY), &printed, RED), cube(blank(), &mended, INK)];
    Ok(Drawing { picture: sheet(&panels, 1)?, figures })
}
