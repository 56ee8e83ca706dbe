//! What the shapes are put together with: vertices, polygons, and points on a circle.

use core::f64::consts::{FRAC_1_SQRT_2, FRAC_PI_4};

use crate::subdivide::to_f32;
use crate::{Corners, Mesh};

/// A corner of a polygon: the number of its vertex and of its normal (0 where a shape has no normals).
pub(super) type Corner = [u32; 2];

/// Collects vertices, normals and polygons; the sides of the polygons become the edges of the mesh, and the
/// diagonals that cut them into triangles do not.
#[derive(Default)]
pub(super) struct Builder {
    positions: Vec<[f32; 3]>,
    normals: Vec<[f32; 3]>,
    triangles: Vec<[u32; 3]>,
    normal_indices: Vec<[u32; 3]>,
    edges: Vec<[u32; 2]>,
}

impl Builder {
    /// A new vertex; its number.
    pub(super) fn vertex(&mut self, position: [f64; 3]) -> u32 {
        self.positions.push(to_f32(position));
        number(self.positions.len())
    }

    /// A new normal, of unit length; its number.
    pub(super) fn normal(&mut self, normal: [f64; 3]) -> u32 {
        self.normals.push(to_f32(normal));
        number(self.normals.len())
    }

    /// A new vertex with a normal of its own: both have the same number, if this alone makes them.
    pub(super) fn smooth_vertex(&mut self, position: [f64; 3], normal: [f64; 3]) -> Corner {
        [self.vertex(position), self.normal(normal)]
    }

    /// A new vertex of a shape without normals.
    pub(super) fn flat_vertex(&mut self, position: [f64; 3]) -> Corner {
        [self.vertex(position), 0]
    }

    /// A convex polygon, counter-clockwise from outside. Neighbouring corners at the same vertex (where a
    /// quadrilateral shrinks to a triangle at a pole) count once; less than three corners make nothing.
    pub(super) fn polygon<const N: usize>(&mut self, corners: [Corner; N]) {
        let mut distinct = [[0; 2]; N];
        let mut count = 0;
        for (i, &corner) in corners.iter().enumerate() {
            if corner[0] != corners[(i + 1) % N][0] {
                distinct[count] = corner;
                count += 1;
            }
        }
        let distinct = &distinct[..count];
        if count < 3 {
            return;
        }
        for i in 1..count - 1 {
            self.triangle([distinct[0], distinct[i], distinct[i + 1]]);
        }
        for (i, a) in distinct.iter().enumerate() {
            let b = distinct[(i + 1) % count];
            self.edges.push([a[0].min(b[0]), a[0].max(b[0])]);
        }
    }

    /// A disc: triangles around `center`, whose spokes are no edges. `ring` is counter-clockwise from outside.
    pub(super) fn disc(&mut self, center: Corner, ring: &[Corner]) {
        for (i, &a) in ring.iter().enumerate() {
            let b = ring[(i + 1) % ring.len()];
            self.triangle([center, a, b]);
            self.edges.push([a[0].min(b[0]), a[0].max(b[0])]);
        }
    }

    fn triangle(&mut self, corners: [Corner; 3]) {
        self.triangles.push(corners.map(|[vertex, _]| vertex));
        self.normal_indices.push(corners.map(|[_, normal]| normal));
    }

    /// The mesh: edges once each, lower number first, in order.
    pub(super) fn finish(mut self) -> Mesh {
        self.edges.sort_unstable();
        self.edges.dedup();
        let shared = self.normals.len() == self.positions.len() && self.normal_indices == self.triangles;
        let normals = match (self.normals.is_empty(), shared) {
            (true, _) => None,
            (false, true) => Some(Corners::per_vertex(self.normals)),
            (false, false) => Some(Corners::indexed(self.normals, self.normal_indices)),
        };
        mesh(self.positions, self.triangles, self.edges, normals)
    }
}

/// Number of the newest of `length` things. Shapes stay far below 2³² by their limits on triangles.
fn number(length: usize) -> u32 {
    u32::try_from(length - 1).expect("a shape's limits keep its numbers in 32 bits")
}

fn mesh(
    positions: Vec<[f32; 3]>,
    triangles: Vec<[u32; 3]>,
    edges: Vec<[u32; 2]>,
    normals: Option<Corners<[f32; 3]>>,
) -> Mesh {
    let mesh = Mesh::new(positions, triangles).and_then(|mesh| mesh.with_edges(edges));
    let mesh = match normals {
        Some(normals) => mesh.and_then(|mesh| mesh.with_normals(normals)),
        None => mesh,
    };
    mesh.expect("a shape names only vertices and normals that it made")
}

/// A mesh of a shape's own tables.
pub(super) fn table(positions: &[[f32; 3]], triangles: &[[u32; 3]], edges: &[[u32; 2]]) -> Mesh {
    mesh(positions.to_vec(), triangles.to_vec(), edges.to_vec(), None)
}

/// The points (cos 2πk/n, sin 2πk/n) for k = 0 … n − 1.
///
/// Angles are folded into the first eighth of the turn by whole numbers, so that the points on the axes are
/// exact and mirrored points differ in nothing but their signs:
///
/// ```text
///        sin
///         |  /     k/n of a turn beyond ½: mirror down,
///         | / 1/8  beyond ¼: mirror to the left,
///         |/____   beyond ⅛: swap cos and sin
///              cos
/// ```
pub(super) fn circle(n: u32) -> impl Iterator<Item = [f64; 2]> {
    // In units of 1/8n of a turn, an eighth of a turn is n.
    let eighth = u64::from(n);
    (0..u64::from(n)).map(move |k| {
        let mut a = 8 * k;
        let down = a > 4 * eighth;
        if down {
            a = 8 * eighth - a;
        }
        let left = a > 2 * eighth;
        if left {
            a = 4 * eighth - a;
        }
        let swap = a > eighth;
        if swap {
            a = 2 * eighth - a;
        }
        let angle = FRAC_PI_4 * a as f64 / eighth as f64;
        let (cos, sin) = match a {
            a if a == eighth => (FRAC_1_SQRT_2, FRAC_1_SQRT_2),
            _ => (libm::cos(angle), libm::sin(angle)),
        };
        let (cos, sin) = if swap { (sin, cos) } else { (cos, sin) };
        [if left { -cos } else { cos }, if down { -sin } else { sin }]
    })
}

/// The point at `radius` from the Y axis in the direction of a point on the unit circle. Seen from above, a
/// circle that goes counter-clockwise does so here: x to the right, −z up the page.
pub(super) fn around_y([cos, sin]: [f64; 2], radius: f64, y: f64) -> [f64; 3] {
    // Not `-(radius * sin)`: that would make −0 of the 0 on the X axis.
    [radius * cos, y, 0.0 - radius * sin]
}

/// `k + 1`, or 0 after the last of `n`: the seam of a closed ring is shared.
pub(super) const fn next(k: usize, n: usize) -> usize {
    if k + 1 == n { 0 } else { k + 1 }
}

#[cfg(test)]
mod tests {
    use super::circle;

    #[test]
    fn points_on_the_axes_are_exact_and_mirrored_points_equal() {
        for n in 1..200 {
            let points: Vec<_> = circle(n).collect();
            assert_eq!(points[0], [1.0, 0.0]);
            for (k, p) in points.iter().enumerate() {
                // This plain angle is itself wrong by three roundings, up to 3 · 2⁻⁵³ · 2π = 2.1e-15.
                let angle = core::f64::consts::TAU * k as f64 / f64::from(n);
                assert!(
                    (p[0] - angle.cos()).abs() < 2.5e-15 && (p[1] - angle.sin()).abs() < 2.5e-15,
                    "{k}/{n}"
                );
                assert!((p[0] * p[0] + p[1] * p[1] - 1.0).abs() <= 2.0 * f64::EPSILON, "{k}/{n}");
                if k > 0 {
                    let mirror = points[n as usize - k];
                    assert_eq!([p[0], p[1].abs()], [mirror[0], mirror[1].abs()], "{k}/{n}");
                }
            }
            if n % 4 == 0 {
                assert_eq!(points[n as usize / 4], [0.0, 1.0]);
                assert_eq!(points[n as usize / 2], [-1.0, 0.0]);
            }
        }
    }
}
