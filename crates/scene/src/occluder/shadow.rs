//! The shadows of a mesh's balls in one view.

use fearless_simd::{Level, dispatch, f32x8, prelude::*, u32x8};
use polosa_math::glam::DVec3;
use polosa_math::{Bounds, Placement, SUB_PIXELS};

use super::{MOST, Occluders};
use crate::Camera;

/// Half a unit in the last place of an `f32`, relative.
const U: f64 = 1.0 / 16_777_216.0;

/// A coordinate of clip space takes one rounding of each entry of the matrix, one of each product and three of sums:
/// each of its four terms at most five. Six leave room for the `f64` that the matrix is composed in.
const TRANSFORM: f64 = 6.0 * U;

/// Just inside the guard band: what stays within is snapped, not cut.
const GUARD: f64 = 8_388_600.0;

/// Vertices that are asked about at a time.
const LANES: usize = 8;

/// One ball's shadow in clip space: `((x − cx·w)·ix)² + ((y − cy·w)·iy)² ≤ w²` and `z < most·w`.
#[derive(Clone, Copy, Debug, Default)]
struct Shadow {
    center: [f32; 2],
    inverse: [f32; 2],
    most: f32,
}

/// Which vertices of one object are hidden by which ball, in one view of it.
#[derive(Clone, Debug)]
pub struct Shadows {
    balls: [Shadow; MOST],
    count: usize,
}

/// What rounding may do to the vertices of an object in one view.
struct Errors {
    /// On the screen, half a sub-pixel of snapping included: along x and y, in units of clip space at w = 1.
    screen: [f64; 2],
    depth: f64,
}

impl Occluders {
    /// The shadows as a camera sees them in a picture of `size` pixels; `bounds` are those of the whole mesh, as
    /// [`World::mesh_bounds`](crate::World::mesh_bounds) has them. `None` when there is nothing to gain: no balls, or
    /// none of use in this view; or when the object reaches the near or far plane or the end of the guard band.
    #[must_use]
    pub fn shadows(
        &self,
        camera: &Camera,
        placement: &Placement,
        bounds: &Bounds,
        size: [u32; 2],
    ) -> Option<Shadows> {
        if self.balls.is_empty() || bounds.is_empty() || size.contains(&0) {
            return None;
        }
        let errors = Errors::of(camera, placement, bounds, size)?;
        let basis = camera.basis();
        let lens = camera.projection_matrix();
        let matrix = camera.clip_from_model_f64(placement);
        let model = placement.matrix_from(camera.position());
        let shrink = placement.scale.abs().min_element() * (1.0 - 1e-9);
        let mut shadows = Shadows { balls: [Shadow::default(); MOST], count: 0 };
        for ball in &self.balls {
            let center = ball.center.extend(1.0);
            let (at, clip) = (basis.to_camera((model * center).truncate()), matrix * center);
            let radius = ball.radius * shrink;
            if let Some(shadow) = shadow(&errors, at, clip.to_array(), radius, lens.to_cols_array_2d()) {
                shadows.balls[shadows.count] = shadow;
                shadows.count += 1;
            }
        }
        (shadows.count > 0).then_some(shadows)
    }
}

impl Errors {
    /// `None` when a clip plane may cut the object.
    fn of(camera: &Camera, placement: &Placement, bounds: &Bounds, size: [u32; 2]) -> Option<Self> {
        let matrix = camera.clip_from_model_f64(placement);
        let largest = bounds.min().abs().max(bounds.max().abs());
        let rows = [matrix.row(0), matrix.row(1), matrix.row(2), matrix.row(3)];
        let [ex, ey, ez, ew] = rows.map(|row| {
            let row = row.abs();
            // The least normal number covers products that vanish.
            TRANSFORM * (row.truncate().dot(largest) + row.w) + 4.0 * f64::from(f32::MIN_POSITIVE)
        });
        let (mut least_w, mut most_w) = (f64::INFINITY, 0.0_f64);
        let mut most = [0.0_f64; 2];
        for corner in bounds.corners() {
            let [x, y, z, w] = (matrix * corner.extend(1.0)).to_array();
            // Written so that NaN fails.
            if !(w > 4.0 * ew && z > ez && z + ez + ew < w) {
                return None;
            }
            (least_w, most_w) = (least_w.min(w), most_w.max(w));
            most = [most[0].max((x / w).abs()), most[1].max((y / w).abs())];
        }
        let w = least_w - ew;
        let half = size.map(|side| f64::from(SUB_PIXELS) / 2.0 * f64::from(side));
        let screen = [(ex + most[0] * ew) / w + 0.501 / half[0], (ey + most[1] * ew) / w + 0.501 / half[1]];
        let on_grid = (0..2).all(|k| (most[k] + screen[k] + 1.0) * half[k] < GUARD);
        // Squares of w are compared, in `f32`.
        let in_range = w > 1e-15 && most_w < 1e15;
        (on_grid && in_range).then_some(Self { screen, depth: (ez + ew) / w + U })
    }
}

/// The shadow of a ball of some radius around a place in camera space that `clip` is the image of.
fn shadow(
    errors: &Errors,
    at: DVec3,
    [x, y, z, w]: [f64; 4],
    radius: f64,
    lens: [[f64; 4]; 4],
) -> Option<Shadow> {
    let parallel = lens[2][3] == 0.0;
    let distance = -at.z;
    // How far in space the surface may move: first along the axis. Depth is B/d − A in perspective, B − A·d else.
    let along = if parallel {
        errors.depth / lens[2][2].abs()
    } else {
        let rest = lens[3][2] - errors.depth * distance;
        if rest > 0.0 { errors.depth * distance * distance / rest } else { f64::INFINITY }
    };
    // Then across: by a place on the screen at the greatest distance, and by what a line of sight drifts over `along`.
    let zoom = [lens[0][0], lens[1][1]];
    let (farthest, drift) = if parallel { (1.0, 0.0) } else { (distance + along, along / distance) };
    let across = [0, 1].map(|k| errors.screen[k] * farthest / zoom[k] + (at[k].abs() + radius) * drift);
    let moved = DVec3::new(across[0], across[1], along).length();
    let room = radius - moved;
    // Last, the vertices that are asked about are themselves snapped, and the asking is in `f32`. The last term is
    // what `f64` may lose on the way here; it counts in telescopes alone.
    let scale = if parallel { 1.0 } else { distance };
    let center = [x / w, y / w];
    let radii = [0, 1].map(|k| {
        let whole = room * zoom[k] / scale;
        let lost = 16.0 * U * (center[k].abs() + whole + 1.0) + 1e-14 * zoom[k] * at.length() / scale;
        (whole - errors.screen[k] - lost) * (1.0 - 16.0 * U)
    });
    // Written so that NaN fails.
    let sound = radii.iter().all(|&radius| radius > 0.0 && radius.is_finite());
    let most = z / w * (1.0 - 16.0 * U);
    (sound && most > 1e-30).then(|| Shadow {
        center: center.map(|c| c as f32),
        inverse: radii.map(|radius| (1.0 / radius) as f32),
        most: most as f32,
    })
}

impl Shadows {
    /// For each vertex, in the clip space that [`Camera::clip_from_model`] and [`polosa_raster::transform`] take it to,
    /// a bit for each ball that hides it. A triangle is hidden if its three marks have a bit in common.
    ///
    /// The level of the machine's vector registers changes no mark.
    pub fn mark(&self, level: Level, clip: &[[f32; 4]], marks: &mut Vec<u8>) {
        marks.clear();
        marks.resize(clip.len(), 0);
        dispatch!(level, simd => self.mark_all(simd, clip, marks));
    }

    #[inline(always)]
    fn mark_all<S: Simd>(&self, simd: S, clip: &[[f32; 4]], marks: &mut [u8]) {
        let (eights, rest) = clip.as_chunks::<LANES>();
        let (marks, rest_marks) = marks.as_chunks_mut::<LANES>();
        for (eight, marks) in eights.iter().zip(marks) {
            self.mark_eight(simd, eight, marks);
        }
        let mut eight = [[0.0; 4]; LANES];
        eight[..rest.len()].copy_from_slice(rest);
        let mut last = [0; LANES];
        self.mark_eight(simd, &eight, &mut last);
        rest_marks.copy_from_slice(&last[..rest.len()]);
    }

    #[inline(always)]
    fn mark_eight<S: Simd>(&self, simd: S, eight: &[[f32; 4]; LANES], marks: &mut [u8; LANES]) {
        let mut gathered = [[0.0; LANES]; 4];
        for (lane, vertex) in eight.iter().enumerate() {
            for k in 0..4 {
                gathered[k][lane] = vertex[k];
            }
        }
        let x = f32x8::from_slice(simd, &gathered[0]);
        let y = f32x8::from_slice(simd, &gathered[1]);
        let z = f32x8::from_slice(simd, &gathered[2]);
        let w = f32x8::from_slice(simd, &gathered[3]);
        let mut all = u32x8::splat(simd, 0);
        for (k, shadow) in self.balls[..self.count].iter().enumerate() {
            let Shadow { center: [cx, cy], inverse: [ix, iy], most } = *shadow;
            let (u, v) = ((x - w * cx) * ix, (y - w * cy) * iy);
            let hidden = (u * u + v * v).simd_le(w * w) & z.simd_lt(w * most);
            all |= hidden.select(u32x8::splat(simd, 1 << k), u32x8::splat(simd, 0));
        }
        let mut wide = [0; LANES];
        all.store_slice(&mut wide);
        for (mark, wide) in marks.iter_mut().zip(wide) {
            // At most 8 bits.
            *mark = (wide & 0xff) as u8;
        }
    }

    /// Whether a triangle is hidden, by the marks of all vertices. No pixel changes if it is left out.
    #[inline]
    #[must_use]
    pub fn hides(marks: &[u8], triangle: [u32; 3]) -> bool {
        let [a, b, c] = triangle.map(|vertex| marks[vertex as usize]);
        a & b & c != 0
    }
}
