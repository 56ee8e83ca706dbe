//! The exact methods, and whole pixels, which are exact in the wrong place: the crate's own strips and edges.

use super::grid::{Grid, runs};
use super::pieces::Preparation;
use super::{Corner, Coverage, Visit};
use crate::edge::Edge;
use crate::snap::{GUARD, snap};
use crate::{Sample, State, Stats, Triangle};
use polosa_math::{SUB_PIXELS, Viewport};

/// Corners on the sub-pixel grid; `None` when one lies outside of the guard band, or is no number.
#[expect(clippy::cast_possible_truncation, reason = "the one rounding of a vertex's depth")]
pub(super) fn snapped(corners: &[Corner; 3]) -> Option<[crate::Corner; 3]> {
    // What is cut at the guard band may lie beyond it by the rounding of the cut: products still fit.
    let limit = f64::from(GUARD + 2) / f64::from(SUB_PIXELS);
    let inside = |corner: &Corner| [corner[0], corner[1]].iter().all(|v| (-limit..=limit).contains(v));
    corners.iter().all(inside).then(|| {
        corners.map(|[x, y, z]| crate::Corner { z: z as f32, ..snap(&Viewport::SCREEN, [x, y, 0.0, 1.0]) })
    })
}

/// The triangle on the sub-pixel grid, in pieces where it reaches beyond the guard band.
fn triangles(corners: &[Corner; 3], mut each: impl FnMut(&Triangle)) {
    if let Some(corners) = snapped(corners) {
        Triangle::sorted(corners).iter().for_each(each);
        return;
    }
    Preparation::on_screen(&State::default(), Coverage::Strips).screen(
        corners,
        &mut Stats::default(),
        |piece| snapped(piece).and_then(Triangle::sorted).iter().for_each(&mut each),
    );
}

pub(super) fn strips(grid: &Grid, corners: &[Corner; 3], visit: &mut (impl Visit + ?Sized)) {
    triangles(corners, |triangle| {
        for strip in triangle.strips(grid.sample, grid.rect) {
            visit.row(strip.y, strip.x0..strip.x1);
        }
    });
}

/// The three edge functions at every pixel of the box.
///
/// With `E = 256·E′ + rest`, and the rest the same at every pixel, E is positive, or zero on a top or left side, if and
/// only if E′ is at least 0, or at least 1 where the rest is zero and the side another.
pub(super) fn edges(grid: &Grid, corners: &[Corner; 3], visit: &mut (impl Visit + ?Sized)) {
    triangles(corners, |triangle| {
        let sides = [0, 1, 2].map(|k| {
            let side = Edge::opposite(triangle, k);
            let at = side.at_pixels(grid.sample);
            (at, i64::from(at.rest == 0 && !side.is_top_left()))
        });
        let columns = triangle.columns(grid.sample, grid.rect);
        let rows = triangle.rows(grid.sample, grid.rect);
        let [columns, rows] = [columns, rows].map(|range| as_u32(range.start)..as_u32(range.end));
        for j in rows {
            let first = sides.map(|(side, least)| side.at(0, j) - least);
            runs(j, columns.clone(), visit, |i| {
                let e = [0, 1, 2].map(|k| first[k] + sides[k].0.x * i64::from(i));
                (e[0] | e[1] | e[2]) >= 0
            });
        }
    });
}

/// A row or column inside a rectangle of pixels, or one before an empty range.
#[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "clamped to u32")]
fn as_u32(place: i64) -> u32 {
    place.clamp(0, u32::MAX.into()) as u32
}

/// Corners cut off to whole pixels, which are their samples: where a line drawn from pixel to pixel has its ends.
#[expect(clippy::cast_possible_truncation, reason = "the method: saturates, and makes NaN 0, as in Java")]
pub(super) fn truncated(sample: Sample, corners: &[Corner; 3]) -> [Corner; 3] {
    let [sx, sy] = sample.sub_pixels().map(|s| f64::from(s) / f64::from(SUB_PIXELS));
    corners.map(|[x, y, z]| [f64::from(x as i32) + sx, f64::from(y as i32) + sy, z])
}
