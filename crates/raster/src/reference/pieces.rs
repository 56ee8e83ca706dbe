//! From vertices to triangles in pixels: reject, clip, divide, map, cull; all that comes before the methods differ.
//!
//! The clipper is the crate's own, in `f64`, for every method: the seeds have none, and without one a vertex behind
//! the eye comes out mirrored. What is left of a clipped triangle is a fan of triangles, each of which the methods see
//! as one of its own. Positions are *not* snapped here: the exact methods do it, the others do without.

use polosa_math::Viewport;

use super::exact::snapped;
use super::{Corner, Coverage, same_side};
use crate::clip::{Clipper, MOST};
use crate::triangle::cross;
use crate::{Clip, Cull, Facing, Space, State, Stats, Triangle};

/// The planes of the guard band; without near and far, which raw corners in pixels do not know.
const GUARD_PLANES: u8 = 0b11_1100;

/// What is needed to prepare triangles.
#[derive(Clone, Copy, Debug)]
pub(super) struct Preparation {
    space: Space,
    viewport: Viewport,
    clipper: Clipper,
    cull: Cull,
    snaps: bool,
}

impl Preparation {
    pub(super) fn new(state: &State, coverage: Coverage, [width, height]: [u32; 2]) -> Self {
        let viewport = state.space.viewport(width, height);
        let clipper = Clipper::new(&viewport);
        Self { space: state.space, viewport, clipper, cull: state.cull, snaps: coverage.snaps() }
    }

    /// For corners in pixels.
    pub(super) fn on_screen(state: &State, coverage: Coverage) -> Self {
        Self::new(&State { space: Space::Screen, ..*state }, coverage, [1, 1])
    }

    /// Prepares a triangle of vertices as draw calls take them.
    pub(super) fn vertices(&self, vertices: [&Clip; 3], stats: &mut Stats, piece: impl FnMut(&[Corner; 3])) {
        if vertices.iter().any(|vertex| vertex.iter().any(|v| !v.is_finite())) {
            stats.not_finite += 1;
            return;
        }
        let positions = vertices.map(|vertex| {
            let [x, y, z, w] = vertex.map(f64::from);
            match self.space {
                Space::Clip => [x, y, z, w],
                Space::Screen => [x * w, y * w, z * w, w],
            }
        });
        self.clipped(&positions, u8::MAX, stats, piece);
    }

    /// Prepares a triangle of corners in pixels. The exact methods reject what is not finite or beyond the range of
    /// `f32`, and cut at the guard band; the others get the corners as they are.
    pub(super) fn screen(
        &self,
        corners: &[Corner; 3],
        stats: &mut Stats,
        mut piece: impl FnMut(&[Corner; 3]),
    ) {
        if !self.snaps {
            self.polygon(corners, stats, piece);
            return;
        }
        let range = -f64::from(f32::MAX)..=f64::from(f32::MAX);
        if corners.iter().flatten().any(|v| !range.contains(v)) {
            stats.not_finite += 1;
            return;
        }
        self.clipped(&corners.map(|[x, y, z]| [x, y, z, 1.0]), GUARD_PLANES, stats, &mut piece);
    }

    fn clipped(
        &self,
        positions: &[[f64; 4]; 3],
        planes: u8,
        stats: &mut Stats,
        piece: impl FnMut(&[Corner; 3]),
    ) {
        let codes = positions.map(|position| self.clipper.outcode(position) & planes);
        if codes[0] & codes[1] & codes[2] != 0 {
            stats.outside += 1;
            return;
        }
        let mut corners = [[0.0; 3]; MOST];
        let crossed = codes[0] | codes[1] | codes[2];
        let mut count = 0;
        let mut behind = false;
        let mut push = |[x, y, z, w]: [f64; 4]| {
            behind |= w <= 0.0;
            let [x, y] = self.viewport.to_pixels(x, y, w);
            // Inside the near and the far plane but for the rounding of a cut.
            let z = if planes == GUARD_PLANES { z } else { (z / w).clamp(0.0, 1.0) + 0.0 };
            corners[count] = [x, y, z];
            count += 1;
        };
        if crossed == 0 {
            positions.iter().copied().for_each(&mut push);
        } else {
            stats.clipped += 1;
            let polygon = self.clipper.triangle(*positions, crossed);
            polygon.as_slice().iter().for_each(|vertex| push(vertex.position));
        }
        if count < 3 {
            stats.outside += 1;
        } else if behind {
            stats.not_finite += 1;
        } else {
            self.polygon(&corners[..count], stats, piece);
        }
    }

    /// Hands over a convex polygon of at least three corners as a fan, unless the side it shows is culled.
    fn polygon(&self, corners: &[Corner], stats: &mut Stats, mut piece: impl FnMut(&[Corner; 3])) {
        let count = corners.len();
        // From the topmost corner, as drawing does; a whole triangle stays as it was given.
        let key = |&k: &usize| {
            let [a, ..] =
                snapped(&[corners[k]; 3]).unwrap_or([crate::Corner { x: 0, y: 0, z: 0.0, w: 1.0 }; 3]);
            (a.y, a.x, a.z.to_bits())
        };
        let top = if count == 3 { 0 } else { (0..count).min_by_key(key).unwrap_or(0) };
        let fan = (top + 1..top + count - 1).map(|k| [top, k, k + 1].map(|k| corners[k % count]));
        let area: f64 = if self.snaps {
            // Below 2⁵³: exact.
            fan.clone().map(|piece| snapped(&piece).map_or(0.0, |[a, b, c]| wide(cross(&a, &b, &c)))).sum()
        } else {
            fan.clone().map(|[a, b, c]| same_side::cross(&a, &b, [c[0], c[1]])).sum()
        };
        if self.snaps && area == 0.0 {
            stats.degenerate += 1;
            return;
        }
        let culled = match self.cull {
            Cull::None => false,
            Cull::Front => area < 0.0,
            Cull::Back => area > 0.0,
        };
        if culled {
            stats.culled += 1;
            return;
        }
        stats.drawn += 1;
        let facing = if area < 0.0 { Facing::Front } else { Facing::Back };
        for corners in fan {
            // Of the exact methods' pieces, those that snapping turned over draw nothing.
            let turned = || {
                let triangle = snapped(&corners).and_then(Triangle::sorted);
                triangle.is_none_or(|triangle| triangle.facing() != facing)
            };
            if !self.snaps || count == 3 || !turned() {
                piece(&corners);
            }
        }
    }
}

#[expect(clippy::cast_precision_loss, reason = "an area is below 2⁵³")]
const fn wide(area: i64) -> f64 {
    area as f64
}
