//! From three vertices to triangles on the grid: reject, clip, snap, sort, cull.

use polosa_math::Viewport;

use crate::clip::Clipper;
use crate::snap::{depth, snap};
use crate::triangle::cross;
use crate::{Clip, Corner, Cull, Facing, Space, State, Stats, Triangle};

/// What a draw call needs to know to prepare its vertices.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Setup {
    space: Space,
    viewport: Viewport,
    clipper: Clipper,
    cull: Cull,
}

/// A triangle to fill. A clipped one is several.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Piece {
    pub(crate) triangle: Triangle,
    /// For a piece of a clipped triangle, its vertices' weights in the whole one.
    pub(crate) clip: Option<[[f32; 3]; 3]>,
}

impl Setup {
    pub(crate) fn new(state: &State, width: u32, height: u32) -> Self {
        let viewport = state.space.viewport(width, height);
        Self { space: state.space, viewport, clipper: Clipper::new(&viewport), cull: state.cull }
    }

    /// Prepares one triangle, counts what became of it, and hands its pieces to `draw`.
    #[inline]
    pub(crate) fn triangle(&self, vertices: [&Clip; 3], stats: &mut Stats, mut draw: impl FnMut(&Piece)) {
        let Some(corners) = self.positions(vertices) else {
            stats.not_finite += 1;
            return;
        };
        let codes = corners.map(|corner| self.clipper.outcode(corner));
        if codes[0] & codes[1] & codes[2] != 0 {
            stats.outside += 1;
            return;
        }
        let planes = codes[0] | codes[1] | codes[2];
        if planes != 0 {
            self.clipped(corners, planes, stats, draw);
            return;
        }
        if corners.iter().any(|corner| corner[3] <= 0.0) {
            stats.not_finite += 1;
            return;
        }
        let Some(triangle) = Triangle::sorted(corners.map(|corner| snap(&self.viewport, corner))) else {
            stats.degenerate += 1;
            return;
        };
        if self.culls(triangle.facing()) {
            stats.culled += 1;
            return;
        }
        stats.drawn += 1;
        draw(&Piece { triangle, clip: None });
    }

    /// The pieces of one triangle that a plane crosses.
    ///
    /// They take the facing of the whole, the sum of their areas; a piece that snapping turned over draws
    /// nothing. They fan out from the topmost corner, so that the order in which the vertices were given
    /// changes nothing.
    #[inline(never)]
    fn clipped(&self, corners: [[f64; 4]; 3], planes: u8, stats: &mut Stats, mut draw: impl FnMut(&Piece)) {
        stats.clipped += 1;
        let polygon = self.clipper.triangle(corners, planes);
        let vertices = polygon.as_slice();
        let count = vertices.len();
        if count < 3 {
            stats.outside += 1;
            return;
        }
        if vertices.iter().any(|vertex| vertex.position[3] <= 0.0) {
            stats.not_finite += 1;
            return;
        }
        let corner = |k: usize| snap(&self.viewport, vertices[k % count].position);
        let key = |k: &usize| {
            let Corner { x, y, z, .. } = corner(*k);
            (y, x, z.to_bits())
        };
        let top = (0..count).min_by_key(key).unwrap_or(0);
        let pieces = (top + 1..top + count - 1).map(|k| [top, k, k + 1]);
        let area = |[a, b, c]: [usize; 3]| cross(&corner(a), &corner(b), &corner(c));
        let sum: i64 = pieces.clone().map(area).sum();
        if sum == 0 {
            stats.degenerate += 1;
            return;
        }
        let facing = if sum < 0 { Facing::Front } else { Facing::Back };
        if self.culls(facing) {
            stats.culled += 1;
            return;
        }
        stats.drawn += 1;
        for piece in pieces {
            let Some(triangle) = Triangle::sorted(piece.map(corner)) else { continue };
            if triangle.facing() == facing {
                let clip = piece.map(|k| vertices[k % count].weights.map(to_f32));
                draw(&Piece { triangle, clip: Some(clip) });
            }
        }
    }

    /// Prepares a line: its two ends on the grid.
    pub(crate) fn line(&self, vertices: [&Clip; 2], stats: &mut Stats) -> Option<[Corner; 2]> {
        let Some(ends) = self.positions(vertices) else {
            stats.not_finite += 1;
            return None;
        };
        let codes = ends.map(|end| self.clipper.outcode(end));
        if codes[0] & codes[1] != 0 {
            stats.outside += 1;
            return None;
        }
        let planes = codes[0] | codes[1];
        stats.clipped += u64::from(planes != 0);
        let Some(ends) = self.clipper.line(ends, planes) else {
            stats.outside += 1;
            return None;
        };
        if ends.iter().any(|end| end[3] <= 0.0) {
            stats.not_finite += 1;
            return None;
        }
        let ends = ends.map(|end| snap(&self.viewport, end));
        if (ends[0].x, ends[0].y) == (ends[1].x, ends[1].y) {
            stats.degenerate += 1;
            return None;
        }
        stats.drawn += 1;
        Some(ends)
    }

    /// A vertex's depth; `None` where it has none, beyond the near or the far plane.
    pub(crate) fn depth(&self, vertex: &Clip) -> Option<f32> {
        let [[_, _, z, w]] = self.positions([vertex])?;
        (0.0 <= z && z <= w && w > 0.0).then(|| depth(z, w))
    }

    /// Homogeneous positions in `f64`; `None` when a coordinate is not finite.
    #[inline]
    fn positions<const N: usize>(&self, vertices: [&Clip; N]) -> Option<[[f64; 4]; N]> {
        let finite = vertices.iter().all(|vertex| vertex.iter().all(|v| v.is_finite()));
        finite.then(|| {
            vertices.map(|vertex| {
                let [x, y, z, w] = vertex.map(f64::from);
                match self.space {
                    Space::Clip => [x, y, z, w],
                    // The products are exact, and so are the quotients that snapping makes of them.
                    Space::Screen => [x * w, y * w, z * w, w],
                }
            })
        })
    }

    #[inline]
    const fn culls(&self, facing: Facing) -> bool {
        matches!((self.cull, facing), (Cull::Front, Facing::Front) | (Cull::Back, Facing::Back))
    }
}

#[expect(clippy::cast_possible_truncation, reason = "the one rounding of a cut's weights")]
const fn to_f32(value: f64) -> f32 {
    value as f32
}
