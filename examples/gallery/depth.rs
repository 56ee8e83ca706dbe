//! What becomes of a depth: planes in `f32`, and formats in which it is stored.

use std::error::Error;

use polosa_raster::reference::{Corner, Coverage, DepthFormat, Hidden, Methods, ZBuffer, draw_screen};
use polosa_raster::{Depth, State, Target};

use super::kit::{BLUE, Drawing, Made, Panel, colors, count, differing, marks, seen, sheet};

/// A surface and, drawn after it, another one behind; cells where the farther one shows are wrong.
fn pair(
    hidden: Hidden,
    size: [u32; 2],
    ids: impl Fn(Hidden) -> Result<Vec<u32>, Box<dyn Error>>,
    zoom: u32,
) -> Made {
    let (by_method, exact) = (ids(hidden)?, ids(Hidden::Exact)?);
    assert!(exact.iter().all(|&id| id == 1), "the nearer surface is seen everywhere");
    let wrong = differing(&by_method, &exact);
    let figures = format!("{hidden}: {} of {} pixels wrong", marks(&wrong), count(exact.len()));
    let panels = [Panel::of(size, &colors(&by_method)).marked(&wrong), Panel::of(size, &colors(&exact))];
    Ok(Drawing { picture: sheet(&panels, zoom)?, figures })
}

/// Two tilted planes 2⁻¹⁷ apart, the nearer one cut into triangles of two pixels, at (4000, 2000).
pub(crate) fn origin() -> Made {
    const SIZE: [u32; 2] = [32, 24];
    let (left, top) = (4000, 2000);
    let plane = |x: u32, y: u32, below: f64| -> Corner {
        let z = 0.125 + 0.017 * f64::from(x) + 0.0083 * f64::from(y) - below;
        [f64::from(left + x), f64::from(top + y), z]
    };
    let square = |x: u32, y: u32, [w, h]: [u32; 2], below: f64| {
        let [a, b, c, d] = [(x, y), (x + w, y), (x + w, y + h), (x, y + h)].map(|(x, y)| plane(x, y, below));
        [[a, b, c], [a, c, d]]
    };
    let cells = (0..12).flat_map(|j| (0..16).map(move |i| (2 * i, 2 * j)));
    let mut all: Vec<[Corner; 3]> = cells.flat_map(|(x, y)| square(x, y, [2, 2], 0.0)).collect();
    let near = all.len() as u32;
    all.extend(square(0, 0, SIZE, 1.0 / 131_072.0));
    let ids = |hidden| {
        // The band of rows that they lie in.
        let (width, rows) = (left + SIZE[0], top..top + SIZE[1]);
        let mut ids = vec![0_u32; (width * SIZE[1]) as usize];
        let mut target = Target::band(&mut ids, Depth::None, [width, rows.end], width as usize, rows)?;
        let methods = Methods { coverage: Coverage::Strips, hidden };
        let surface = |k: u32| if k < near { 1 } else { 2 };
        draw_screen(&mut target, &mut ZBuffer::new(), methods, &State::default(), &all, surface);
        Ok(ids.chunks(width as usize).flat_map(|row| row[left as usize..].to_vec()).collect())
    };
    pair(Hidden::PlaneF32Origin, SIZE, ids, 8)
}

/// Two tilted planes 2⁻¹⁷ apart, the nearer one cut into slivers.
pub(crate) fn slivers() -> Made {
    const SIZE: [u32; 2] = [48, 32];
    let plane = |x: f64, y: f64, below: f64| -> Corner { [x, y, 0.125 + 0.0071 * x + 0.0043 * y - below] };
    // From the upper left corner to the right and the lower side, 1/64 pixel apart.
    let fan = |k: u32| {
        let along = f64::from(k) / 64.0;
        if along <= 32.0 { (48.0, along) } else { (80.0 - along, 32.0) }
    };
    let end = |k: u32| plane(fan(k).0, fan(k).1, 0.0);
    let mut all: Vec<[Corner; 3]> =
        (0..80 * 64).map(|k| [plane(0.0, 0.0, 0.0), end(k), end(k + 1)]).collect();
    let slivers = all.len() as u32;
    let [a, b, c, d] =
        [(0.0, 0.0), (48.0, 0.0), (48.0, 32.0), (0.0, 32.0)].map(|(x, y)| plane(x, y, 1.0 / 131_072.0));
    all.extend([[a, b, c], [a, c, d]]);
    let ids = |hidden| {
        let methods = Methods { coverage: Coverage::Strips, hidden };
        let (ids, _) = seen(methods, SIZE, &all)?;
        Ok(ids.iter().map(|&id| if id > slivers { 2 } else { id.min(1) }).collect())
    };
    pair(Hidden::PlaneF32Vertex, SIZE, ids, 6)
}

/// Two floors, the nearer one a hundred-thousandth of the distance before the other, drawn after it.
pub(crate) fn formats() -> Made {
    const SIZE: [u32; 2] = [56, 56];
    const APART: f64 = 1e-5;
    // 1/w is linear over the screen: 1/1000 in one corner, 1/3 in the other.
    let distance = |x: u32, y: u32| {
        let along = (f64::from(y) + 0.5) * 0.9 / 56.0 + (f64::from(x) + 0.5) * 0.1 / 56.0;
        1.0 / (0.001 + along * along * (1.0 / 3.0 - 0.001))
    };
    let ties = |format: DepthFormat, far: f64| -> Vec<bool> {
        let places = (0..SIZE[1]).flat_map(|y| (0..SIZE[0]).map(move |x| (x, y)));
        let hidden = |(x, y)| {
            let w = distance(x, y);
            format.store(w * (1.0 - APART), 0.1, far) <= format.store(w, 0.1, far)
        };
        places.map(hidden).collect()
    };
    let shown =
        [DepthFormat::D24, DepthFormat::F32Standard, DepthFormat::F32Signed, DepthFormat::F32Reversed];
    let panel = |format| Panel::new(SIZE, |_, _| BLUE).marked(&ties(format, 1e3));
    let said = DepthFormat::ALL.iter().map(|&format| format!("{format} {}", marks(&ties(format, 1e3))));
    let figures = format!(
        "wrong of {} pixels: {}",
        count((SIZE[0] * SIZE[1]) as usize),
        said.collect::<Vec<_>>().join(", ")
    );
    Ok(Drawing { picture: sheet(&shown.map(panel), 3)?, figures })
}
