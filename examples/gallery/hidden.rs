//! Which of several triangles is seen: by the order of drawing, by one depth a triangle, by S4's strips as printed.

use std::error::Error;

use polosa_math::glam::DVec3;
use polosa_raster::Cull;
use polosa_raster::reference::{Corner, Coverage, Hidden, Methods};
use polosa_scene::{Camera, Color, Light, Object, Style, World, reference, shape};

use super::kit::{BLUE, Drawing, INK, Made, PAPER, Panel, colors, count, differing, marks, seen, sheet};

const SIZE: [u32; 2] = [24, 24];

/// The pixels that a way to hide gets wrong, beside the exact ones.
fn pair(hidden: Hidden, triangles: &[[Corner; 3]]) -> Made {
    let ids = |hidden| {
        Ok::<_, Box<dyn Error>>(seen(Methods { coverage: Coverage::Strips, hidden }, SIZE, triangles)?.0)
    };
    let (by_method, exact) = (ids(hidden)?, ids(Hidden::Exact)?);
    let wrong = differing(&by_method, &exact);
    let covered = exact.iter().filter(|&&id| id != 0).count();
    let figures = format!("{hidden}: {} of {} pixels wrong", marks(&wrong), count(covered));
    let panels = [
        Panel::of(SIZE, &colors(&by_method)).marked(&wrong).outlined(triangles, INK),
        Panel::of(SIZE, &colors(&exact)).outlined(triangles, INK),
    ];
    Ok(Drawing { picture: sheet(&panels, 12)?, figures })
}

/// S2's way with a shape that is not convex: back faces are left out, and what comes last stays.
pub(crate) fn order() -> Made {
    const ALL: [u32; 2] = [128, 96];
    // The middle of it.
    const SIZE: [u32; 2] = [88, 48];
    let mut world = World::new();
    let torus = world.add_mesh(shape::torus(24, 12)?);
    world.add(Object::new(torus).colored(Color::from_u32(BLUE)))?;
    let mut camera = Camera::new();
    camera.frame(&world.bounds(), DVec3::new(0.0, 0.35, -1.0), DVec3::Y, 0.02)?;
    let style = Style { cull: Cull::Back, ..Style::default() };
    let by = |hidden| -> Result<Vec<u32>, Box<dyn Error>> {
        let methods = reference::Methods { hidden, ..reference::Methods::default() };
        let paper = Color::from_u32(PAPER);
        let picture = methods.picture(&world, &camera, &Light::default(), &style, ALL, paper)?;
        let rows = picture.pixels.chunks(ALL[0] as usize).skip(24).take(SIZE[1] as usize);
        Ok(rows.flat_map(|row| row[20..20 + SIZE[0] as usize].to_vec()).collect())
    };
    let (by_order, exact) = (by(Hidden::Order)?, by(Hidden::Exact)?);
    let wrong = differing(&by_order, &exact);
    let covered = exact.iter().filter(|&&color| color != PAPER).count();
    let figures = format!("order: {} of {} pixels wrong", marks(&wrong), count(covered));
    let panel = |pixels: &[u32]| Panel::of(SIZE, pixels);
    let panels = [panel(&by_order), panel(&by_order).marked(&wrong), panel(&exact)];
    Ok(Drawing { picture: sheet(&panels, 3)?, figures })
}

/// Three blades around the middle, each over the next and under the one before.
pub(crate) fn cycle() -> Made {
    let blade = |k: usize| {
        // By a third of a turn, and two.
        let turn = |[x, y]: [f64; 2]| match k {
            0 => [x, y],
            1 => [-0.5 * x - 0.866 * y, 0.866 * x - 0.5 * y],
            _ => [-0.5 * x + 0.866 * y, -0.866 * x - 0.5 * y],
        };
        [([-10.0, -4.0], 0.25), ([10.0, -7.0], 0.75), ([10.0, -1.0], 0.75)].map(|(p, z)| {
            let [x, y] = turn(p);
            [x + 12.0, y + 11.0, z]
        })
    };
    pair(Hidden::Painter, &[blade(0), blade(1), blade(2)])
}

/// Two triangles through each other.
pub(crate) fn pierce() -> Made {
    let one = [[1.0, 3.0, 0.875], [22.0, 10.0, 0.125], [2.0, 20.0, 0.5]];
    let two = [[23.0, 2.0, 0.875], [22.0, 22.0, 0.625], [3.0, 12.0, 0.125]];
    pair(Hidden::Painter, &[one, two])
}

/// Scene 14: depth (10, 0, 0) through 3. The sums are 10 and 9.
pub(crate) fn sum() -> Made {
    let falling = [[12.0, 1.0, 10.0], [23.0, 22.0, 0.0], [1.0, 19.0, 0.0]];
    pair(Hidden::Sum, &[falling.map(|[x, y, _]| [x, y, 3.0]), falling])
}

/// A plane of depth 5, then one of 9 before it.
pub(crate) fn strip() -> Made {
    let far = [[1.0, 2.0, 5.0], [22.0, 5.0, 5.0], [8.0, 22.0, 5.0]];
    let near = [[22.0, 1.0, 9.0], [17.0, 23.0, 9.0], [2.0, 13.0, 9.0]];
    pair(Hidden::StripPrinted, &[far, near])
}
