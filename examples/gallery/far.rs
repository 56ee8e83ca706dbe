//! Sides that reach far out of the picture, and sides that are walked down in floats.

use polosa_raster::reference::{Corner, Coverage};
use polosa_stability::inputs::mesh::{self, Mesh};
use polosa_stability::inputs::rng::Rng;

use super::kit::{Drawing, Made, Panel, colors, count, differing, filled, sheet, truth};

/// A mesh's triangles, in pixels.
fn triangles(mesh: &Mesh) -> Vec<[Corner; 3]> {
    let corner = |k: u32| {
        let [x, y] = mesh.vertices[k as usize].map(|v| v as f64 / 256.0);
        [x, y, 0.0]
    };
    mesh.triangles.iter().map(|t| t.map(corner)).collect()
}

/// What a method makes of a mesh, and the exact strips, both where most is wrong: a window of `side` pixels.
fn pair(method: Coverage, size: [u32; 2], all: &[[Corner; 3]], side: u32) -> Made {
    let truth = truth(size, all);
    let (by_method, exact) = (filled(method, size, all), filled(Coverage::Strips, size, all));
    let wrong = differing(&by_method.times, &truth);
    let of = |test: fn(&u32, &u32) -> bool| {
        count(by_method.times.iter().zip(&truth).filter(|(times, right)| test(times, right)).count())
    };
    let figures = format!(
        "{method}: {} holes, {} drawn twice, of {} pixels",
        of(|times, right| times < right),
        of(|times, right| times > right),
        count(truth.iter().filter(|&&times| times > 0).count())
    );

    let places = |[x0, y0]: [u32; 2]| {
        (0..side).flat_map(move |y| (0..side).map(move |x| ((y0 + y) * size[0] + x0 + x) as usize))
    };
    let corners = (0..=size[1] - side).flat_map(|y| (0..=size[0] - side).map(move |x| [x, y]));
    let corner = corners.max_by_key(|&corner| places(corner).filter(|&k| wrong[k]).count());
    let corner = corner.ok_or("a window of the picture")?;
    let marked: Vec<bool> = places(corner).map(|k| wrong[k]).collect();
    let panel = |ids: &[u32]| {
        let colors = colors(ids);
        Panel::of([side; 2], &places(corner).map(|k| colors[k]).collect::<Vec<_>>())
    };
    let panels = [panel(&by_method.ids).marked(&marked), panel(&exact.ids)];
    Ok(Drawing { picture: sheet(&panels, 8)?, figures })
}

/// Sixty-four triangles around a point, their rim a million pixels away.
pub(crate) fn fan() -> Made {
    let all = triangles(&mesh::fan([131 * 256 + 77, 90 * 256 + 201], 256e6));
    pair(Coverage::FloatEdges, [256, 256], &all, 36)
}

/// Triangles with corners on pixel centres, walked down in floats.
pub(crate) fn scan() -> Made {
    let low = [128, 128];
    let all = triangles(&mesh::scattered(low, low.map(|c| c + 256 * 60), 120, &mut Rng::new(81), 256));
    pair(Coverage::FloatScan, [64, 64], &all, 36)
}
