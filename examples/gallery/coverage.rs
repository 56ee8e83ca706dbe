//! Which pixels a triangle covers: shared sides, corners on a line, corners on whole pixels, ties.

use polosa_raster::reference::{Corner, Coverage};

use super::kit::{Drawing, Filled, INK, Made, Panel, colors, count, differing, filled, marks, sheet, truth};

/// A corner in pixels; what is filled here has no depth.
const fn at(x: f64, y: f64) -> Corner {
    [x, y, 0.0]
}

/// A method's panel beside the exact one, and how often its pixels are drawn in vain, or not drawn.
fn pair(method: Coverage, size: [u32; 2], triangles: &[[Corner; 3]], zoom: u32) -> Made {
    let truth = truth(size, triangles);
    let Filled { ids, times } = filled(method, size, triangles);
    let exact = filled(Coverage::Strips, size, triangles);
    let wrong = differing(&times, &truth);
    let of = |test: fn(&u32, &u32) -> bool| times.iter().zip(&truth).filter(|(t, r)| test(t, r)).count();
    let figures = format!(
        "{method}: {} drawn in vain, {} left out, of {} pixels",
        count(of(|times, right| times > right)),
        count(of(|times, right| times < right)),
        count(truth.iter().filter(|&&times| times > 0).count()),
    );
    let panels = [
        Panel::of(size, &colors(&ids)).marked(&wrong).outlined(triangles, INK),
        Panel::of(size, &colors(&exact.ids)).outlined(triangles, INK),
    ];
    Ok(Drawing { picture: sheet(&panels, zoom)?, figures })
}

/// The quad of scene 1: its diagonal runs through six pixel centres.
pub(crate) fn shared() -> Made {
    let [a, b, c, d] = [at(1.0, 1.0), at(7.0, 1.0), at(7.0, 7.0), at(1.0, 7.0)];
    pair(Coverage::Barycentric, [8, 8], &[[a, b, c], [a, c, d]], 30)
}

/// Three corners on one line.
pub(crate) fn line() -> Made {
    pair(Coverage::SameSide, [108, 108], &[[at(4.0, 4.0), at(54.0, 54.0), at(104.0, 104.0)]], 2)
}

/// A triangle whose corners are cut off to whole pixels.
pub(crate) fn whole() -> Made {
    pair(Coverage::WholePixels, [18, 16], &[[at(2.25, 1.75), at(16.75, 4.875), at(5.875, 14.75)]], 16)
}

/// Six steps of a slow motion, one beside the other.
pub(crate) fn jitter() -> Made {
    const FRAME: [u32; 2] = [11, 11];
    let [width, height] = FRAME.map(f64::from);
    let size = [3 * FRAME[0], 2 * FRAME[1]];
    let step = |k: u32| {
        // Frames are whole pixels apart, which no method notices.
        let by = [
            0.25 * f64::from(k) + f64::from(k % 3) * width,
            0.125 * f64::from(k) + f64::from(k / 3) * height,
        ];
        [at(1.5, 1.25), at(8.25, 2.5), at(3.125, 8.625)].map(|[x, y, z]| [x + by[0], y + by[1], z])
    };
    let steps: Vec<[Corner; 3]> = (0..6).map(step).collect();
    let wrong = differing(&filled(Coverage::WholePixels, size, &steps).times, &truth(size, &steps));
    let [by_method, exact] =
        [Coverage::WholePixels, Coverage::Strips].map(|method| filled(method, size, &steps).ids);
    let areas = |ids: &[u32]| {
        let areas = (1..=6).map(|step| ids.iter().filter(|&&id| id == step).count().to_string());
        areas.collect::<Vec<_>>().join(", ")
    };
    let figures = format!(
        "whole-pixels: {} pixels wrong in six pictures, {} covered; exact: {}",
        marks(&wrong),
        areas(&by_method),
        areas(&exact)
    );
    let panel = |ids: &[u32]| {
        let all: Vec<u32> = ids.iter().map(|&id| id.min(1)).collect();
        Panel::of(size, &colors(&all))
            .line([width, 0.0], [width, 2.0 * height], INK)
            .line([2.0 * width, 0.0], [2.0 * width, 2.0 * height], INK)
            .line([0.0, height], [3.0 * width, height], INK)
    };
    Ok(Drawing { picture: sheet(&[panel(&by_method).marked(&wrong), panel(&exact)], 10)?, figures })
}

/// A square on its corner, all four sides through pixel centres: nothing but ties.
pub(crate) fn tie() -> Made {
    let [a, b, c, d] = [at(8.5, 1.5), at(15.5, 8.5), at(8.5, 15.5), at(1.5, 8.5)];
    pair(Coverage::VerticalStrips, [17, 17], &[[a, b, c], [a, c, d]], 16)
}

/// Four triangles around a pixel centre, both ends of each strip included.
pub(crate) fn closed() -> Made {
    let [a, b, c, d, m] = [at(1.5, 1.5), at(13.5, 1.5), at(13.5, 13.5), at(1.5, 13.5), at(7.5, 7.5)];
    pair(Coverage::VerticalStripsClosed, [15, 15], &[[a, b, m], [b, c, m], [c, d, m], [d, a, m]], 16)
}
