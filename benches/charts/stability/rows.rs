//! The rows of the table that are about values, shades, spheres and rotations.

use polosa_math::reference::rotation::Turning;
use polosa_raster::reference::attribute::{Attribute, on_screen};
use polosa_raster::{Depth, DepthTest, Fragment, Space, State, Target};
use polosa_scene::reference::sphere::radial_error;
use polosa_scene::reference::{Shading, Sphere};
use polosa_stability::inputs::classes::triangle;
use polosa_stability::inputs::rng::Rng;
use polosa_stability::oracle::coverage::{CENTRE, Vertex, row_span};
use polosa_stability::oracle::depth::weights;
use polosa_stability::{Table, Verdict};

use crate::shading::oracle;

/// The picture of scene 18.
const SIDE: u32 = 64;

/// Enters all four.
pub(super) fn add(table: &mut Table) {
    let triangles = stripes();
    let values = "values where w differs by 100";
    table.set(18, values, "immediate", verdict(immediate(&triangles)));
    for attribute in [Attribute::Perspective, Attribute::Affine] {
        table.set(18, values, &format!("attribute {attribute}"), verdict(blended(attribute, &triangles)));
    }
    let nearest: Vec<_> = (0..=255).map(oracle::all).collect();
    for &shading in Shading::ALL {
        let wrong = shades(shading, &nearest);
        table.set(19, "256 codes at 1,001 shades", &format!("shade {shading}"), verdict(wrong));
    }
    for &sphere in Sphere::ALL {
        table.set(20, "spheres within ½ px", &format!("sphere {sphere}"), verdict(spheres(sphere)));
    }
    for &turning in Turning::ALL {
        table.set(21, "a million steps of rotation", &format!("turn {turning}"), verdict(turns(turning)));
    }
}

const fn verdict(wrong: u64) -> Verdict {
    if wrong == 0 { Verdict::Pass } else { Verdict::Wrong { pixels: wrong } }
}

/// Triangles in 1/256 px with w at their corners, from 1 to 100.
type Stripe = ([Vertex; 3], [f32; 3]);

fn stripes() -> Vec<Stripe> {
    let mut r = Rng::new(18);
    (0..100)
        .map(|_| {
            (triangle("random", &mut r, SIDE.into(), SIDE.into()), [1.0, 100.0, r.real(1.0, 100.0) as f32])
        })
        .collect()
}

/// Whether a value that is 0, ½ and 1 at the corners is off by more than 2⁻²⁰ by these weights.
fn off(found: [f64; 3], (t, w): &Stripe, [i, j]: [i64; 2]) -> bool {
    let value = |weights: [f64; 3]| weights[1] / 2.0 + weights[2];
    let error = value(found) - value(weights(t, *w, i, j, CENTRE));
    error.is_nan() || error.abs() > 1.0 / 1_048_576.0
}

/// Wrong pixels by a method of the reference module.
fn blended(attribute: Attribute, stripes: &[Stripe]) -> u64 {
    let mut wrong = 0;
    for stripe in stripes {
        let corners = stripe.0.map(|[x, y]| [x as f64 / 256.0, y as f64 / 256.0, 0.0]);
        for j in 0..i64::from(SIDE) {
            for i in row_span(&stripe.0, j, CENTRE, SIDE as usize) {
                let place = on_screen(&corners, [i as f64 + 0.5, j as f64 + 0.5]);
                let found = attribute.weights(place, stripe.1.map(f64::from));
                wrong += u64::from(off(found, stripe, [i as i64, j]));
            }
        }
    }
    wrong
}

/// Wrong pixels of what is drawn.
fn immediate(stripes: &[Stripe]) -> u64 {
    let mut wrong = 0;
    for stripe in stripes {
        let mut pixels = vec![[f32::NAN; 3]; (SIDE * SIDE) as usize];
        let state = State { space: Space::Screen, test: DepthTest::Off, ..State::default() };
        let corner = |k: usize| {
            let [x, y] = stripe.0[k].map(|c| c as f32 / 256.0);
            [x, y, 0.5, stripe.1[k]]
        };
        let shade = |fragment: &Fragment<'_>, pixel: &mut [f32; 3]| {
            *pixel = fragment.weights();
            true
        };
        let mut target =
            Target::new(&mut pixels, Depth::None, SIDE, SIDE, SIDE as usize).expect("the size is in range");
        target.triangles(&state, &[corner(0), corner(1), corner(2)], &[[0, 1, 2]], &shade);
        for j in 0..i64::from(SIDE) {
            for i in row_span(&stripe.0, j, CENTRE, SIDE as usize) {
                let found = pixels[j as usize * SIDE as usize + i].map(f64::from);
                wrong += u64::from(off(found, stripe, [i as i64, j]));
            }
        }
    }
    wrong
}

/// Codes that are not the nearest.
fn shades(shading: Shading, nearest: &[Vec<(u8, bool)>]) -> u64 {
    let mut wrong = 0;
    for (code, shades) in (0..=255_u8).zip(nearest) {
        for (&(right, tie), thousandths) in shades.iter().zip(0_u16..) {
            let shaded = shading.shade(code, f32::from(thousandths) / 1000.0);
            wrong += u64::from(shaded != right && !(tie && shaded + 1 == right));
        }
    }
    wrong
}

/// Radii at which the level that the bound chooses for ½ px is off by more.
fn spheres(sphere: Sphere) -> u64 {
    let radii = [20.0, 50.0, 100.0, 200.0, 500.0, 1000.0];
    let too_far = |radius: &&f64| {
        let level = (0..12).find(|&level| **radius * crate::detail::bound(sphere, level) <= 0.5);
        let mesh = level.and_then(|level| sphere.mesh(level).ok());
        mesh.is_none_or(|mesh| **radius * radial_error(&mesh, 1.0) > 0.5)
    };
    radii.iter().filter(too_far).count() as u64
}

/// Steps, about one axis and about two, that leave no rotation after a million.
fn turns(turning: Turning) -> u64 {
    let steps = [[1.0 / 64.0, 0.0], [1.0 / 64.0, 1.0 / 128.0]];
    let is_bent = |[dx, dy]: &&[f64; 2]| {
        let off = turning.drift(*dx, *dy, 1_000_000).orthogonality;
        off.is_nan() || off >= 1e-5
    };
    steps.iter().filter(is_bent).count() as u64
}
