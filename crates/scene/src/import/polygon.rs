//! A polygon with any number of corners, cut into triangles.
//!
//! ```text
//!   fan from 0            no fan from 0: try the other corners, else clip ears
//!   3 ───── 2             2
//!   │     ╱ │             │ ╲    0                 2
//!   │   ╱   │             │  ╲ ╱  ╲                │╲╲  0
//!   │ ╱     │             │  1     ╲               │ 1 ──╲  fan from 1
//!   0 ───── 1             └──────── 3              └────── 3
//! ```
//!
//! A fan is right when all its triangles have the polygon's own orientation; convex polygons always have one.
//! Anything else goes to the `earcut` crate, in the projection along the polygon's normal that keeps it largest.
//!
//! # Guarantee
//!
//! A polygon of n corners becomes n − 2 triangles that use every side of the polygon exactly once, in its own
//! direction. (A corner in the middle of a straight side must not be dropped, as ear clipping does: the
//! neighbour on that side still uses it, and the closed surface would open there.)

use earcut::Earcut;

/// Above this many corners a polygon that has no fan is fanned all the same: ear clipping takes time with the
/// square of the corners in the worst case, and a hostile file could hold the program up for minutes.
const MOST_EARS: usize = 10_000;

/// Above this many corners only the first corner is tried as a fan's apex: trying all takes quadratic time.
const MOST_APEXES: usize = 8;

/// Cuts polygons, and keeps the scratch memory for the next one.
pub(super) struct Cutter {
    points: Vec<[f64; 3]>,
    flat: Vec<[f64; 2]>,
    earcut: Earcut<f64>,
    ears: Vec<u32>,
    triangles: Vec<[usize; 3]>,
}

impl Cutter {
    pub(super) fn new() -> Self {
        Self {
            points: Vec::new(),
            flat: Vec::new(),
            earcut: Earcut::new(),
            ears: Vec::new(),
            triangles: Vec::new(),
        }
    }

    /// The triangles of the polygon with these corners, as triples of numbers of corners, from 0.
    pub(super) fn cut(&mut self, corners: impl Iterator<Item = [f32; 3]>) -> &[[usize; 3]] {
        self.points.clear();
        self.points.extend(corners.map(|p| p.map(f64::from)));
        self.triangles.clear();
        let n = self.points.len();
        if n < 3 {
            return &self.triangles;
        }
        let normal = newell(&self.points);
        let apex = if n == 3 || normal.iter().any(|c| !c.is_finite()) || normal == [0.0; 3] {
            Some(0)
        } else {
            let tries = if n <= MOST_APEXES { n } else { 1 };
            (0..tries).find(|&apex| is_fan(&self.points, apex, normal))
        };
        match apex {
            Some(apex) => self.fan(apex),
            None if n > MOST_EARS || !self.clip_ears(normal) => {
                self.triangles.clear();
                self.fan(0);
            }
            None => {}
        }
        &self.triangles
    }

    fn fan(&mut self, apex: usize) {
        let n = self.points.len();
        self.triangles.extend((1..n - 1).map(|i| [apex, (apex + i) % n, (apex + i + 1) % n]));
    }

    /// Ear clipping; false when its result does not use every side once (self-intersecting polygons).
    fn clip_ears(&mut self, normal: [f64; 3]) -> bool {
        let n = self.points.len();
        let size = normal.map(f64::abs);
        let drop = if size[0] >= size[1] && size[0] >= size[2] {
            0
        } else if size[1] >= size[2] {
            1
        } else {
            2
        };
        let (u, v) = ((drop + 1) % 3, (drop + 2) % 3);
        self.flat.clear();
        self.flat.extend(self.points.iter().map(|p| [p[u], p[v]]));
        self.earcut.earcut_slice(&self.flat, &[], &mut self.ears);
        self.triangles
            .extend(self.ears.chunks_exact(3).map(|t| [t[0] as usize, t[1] as usize, t[2] as usize]));

        // Which way earcut turns its triangles: one of them has a side of the polygon, in one direction.
        let is_side = |a: usize, b: usize| (a + 1) % n == b;
        let forward = self.triangles.iter().any(|&[a, b, c]| is_side(a, b) || is_side(b, c) || is_side(c, a));
        if !forward {
            for triangle in &mut self.triangles {
                triangle.swap(1, 2);
            }
        }
        self.put_back_dropped_corners();
        self.uses_every_side_once()
    }

    /// Earcut leaves out corners on straight lines: the triangle at such a side becomes a fan over them.
    fn put_back_dropped_corners(&mut self) {
        let n = self.points.len();
        let mut used = vec![false; n];
        for &corner in self.triangles.iter().flatten() {
            used[corner] = true;
        }
        let Some(first) = used.iter().position(|&used| used) else { return };
        let mut a = first;
        while a < first + n {
            let b = (a + 1..=first + n).find(|b| used[b % n]).unwrap_or(first + n);
            if b > a + 1 {
                let (from, to) = (a % n, b % n);
                let found = self.triangles.iter_mut().find_map(|triangle| {
                    let [x, y, z] = *triangle;
                    let opposite = [(x, y, z), (y, z, x), (z, x, y)]
                        .into_iter()
                        .find_map(|(p, q, opposite)| (p == from && q == to).then_some(opposite))?;
                    *triangle = [from, (a + 1) % n, opposite];
                    Some(opposite)
                });
                let Some(opposite) = found else { return };
                self.triangles.extend((a + 1..b).map(|i| [i % n, (i + 1) % n, opposite]));
            }
            a = b;
        }
    }

    fn uses_every_side_once(&self) -> bool {
        let n = self.points.len();
        let mut uses = vec![0_u8; n];
        for &[a, b, c] in &self.triangles {
            for (from, to) in [(a, b), (b, c), (c, a)] {
                if (from + 1) % n == to {
                    uses[from] = uses[from].saturating_add(1);
                }
            }
        }
        self.triangles.len() == n - 2 && uses.iter().all(|&uses| uses == 1)
    }
}

/// Newell's normal: the sum of the fan's cross products, twice the polygon's area long.
fn newell(points: &[[f64; 3]]) -> [f64; 3] {
    let mut sum = [0.0; 3];
    for pair in points[1..].windows(2) {
        let cross = cross(points[0], pair[0], pair[1]);
        for axis in 0..3 {
            sum[axis] += cross[axis];
        }
    }
    sum
}

/// (b − a) × (c − a).
fn cross(a: [f64; 3], b: [f64; 3], c: [f64; 3]) -> [f64; 3] {
    let (p, q) = ([b[0] - a[0], b[1] - a[1], b[2] - a[2]], [c[0] - a[0], c[1] - a[1], c[2] - a[2]]);
    [p[1] * q[2] - p[2] * q[1], p[2] * q[0] - p[0] * q[2], p[0] * q[1] - p[1] * q[0]]
}

/// Whether every triangle of the fan from `apex` is turned as the polygon is, and none is flat.
fn is_fan(points: &[[f64; 3]], apex: usize, normal: [f64; 3]) -> bool {
    let n = points.len();
    (1..n - 1).all(|i| {
        let turn = cross(points[apex], points[(apex + i) % n], points[(apex + i + 1) % n]);
        turn[0] * normal[0] + turn[1] * normal[1] + turn[2] * normal[2] > 0.0
    })
}

#[cfg(test)]
mod tests {
    use super::{Cutter, cross};

    fn cut(corners: &[[f32; 3]]) -> Vec<[usize; 3]> {
        Cutter::new().cut(corners.iter().copied()).to_vec()
    }

    fn area_z(corners: &[[f32; 3]], triangles: &[[usize; 3]]) -> Vec<f64> {
        let p = |i: usize| corners[i].map(f64::from);
        triangles.iter().map(|&[a, b, c]| cross(p(a), p(b), p(c))[2] / 2.0).collect()
    }

    #[test]
    fn a_convex_quad_is_fanned_from_its_first_corner() {
        let square = [[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [1.0, 1.0, 0.0], [0.0, 1.0, 0.0]];
        assert_eq!(cut(&square), [[0, 1, 2], [0, 2, 3]]);
    }

    #[test]
    fn a_concave_quad_is_cut_at_its_reflex_corner() {
        // The dart: corner 2 points inwards, so the diagonal 1–3 lies outside.
        let dart = [[4.0, 0.0, 0.0], [0.0, 4.0, 0.0], [1.0, 1.0, 0.0], [0.0, -4.0, 0.0]];
        let dart: Vec<_> = dart.iter().rev().copied().collect();
        let triangles = cut(&dart);
        let areas = area_z(&dart, &triangles);
        assert_eq!(triangles.len(), 2);
        assert!(areas.iter().all(|a| *a < 0.0) || areas.iter().all(|a| *a > 0.0), "{areas:?}");
    }

    #[test]
    fn a_comb_keeps_its_area_its_sides_and_its_turn() {
        // Twelve corners and a straight-side corner at (3, 0), in both turns and three planes.
        let comb: [[f32; 2]; 13] = [
            [0.0, 0.0],
            [3.0, 0.0],
            [6.0, 0.0],
            [6.0, 5.0],
            [5.0, 5.0],
            [5.0, 1.0],
            [4.0, 1.0],
            [4.0, 5.0],
            [2.0, 5.0],
            [2.0, 1.0],
            [1.0, 1.0],
            [1.0, 5.0],
            [0.0, 5.0],
        ];
        for turned in [false, true] {
            for drop in 0..3 {
                let mut corners: Vec<[f32; 3]> = comb
                    .iter()
                    .map(|p| {
                        let mut at = [7.0; 3];
                        (at[(drop + 1) % 3], at[(drop + 2) % 3]) = (p[0], p[1]);
                        at
                    })
                    .collect();
                if turned {
                    corners.reverse();
                }
                let triangles = cut(&corners);
                assert_eq!(triangles.len(), 11);
                let p = |i: usize| corners[i].map(f64::from);
                let areas: Vec<f64> =
                    triangles.iter().map(|&[a, b, c]| cross(p(a), p(b), p(c))[drop] / 2.0).collect();
                let sign = if turned { -1.0 } else { 1.0 };
                assert!(areas.iter().all(|a| a * sign >= 0.0), "{areas:?}");
                assert_eq!(areas.iter().sum::<f64>() * sign, 22.0);
                for side in 0..13 {
                    let next = (side + 1) % 13;
                    let uses = triangles
                        .iter()
                        .flat_map(|&[a, b, c]| [[a, b], [b, c], [c, a]])
                        .filter(|&edge| edge == [side, next])
                        .count();
                    assert_eq!(uses, 1, "side {side}");
                }
            }
        }
    }

    #[test]
    fn a_polygon_without_area_or_with_nan_is_fanned() {
        let nan = [f32::NAN; 3];
        assert_eq!(cut(&[nan, [1.0; 3], [2.0; 3], [3.0; 3]]), [[0, 1, 2], [0, 2, 3]]);
        assert_eq!(cut(&[[0.0; 3], [1.0; 3], [2.0; 3], [3.0; 3]]), [[0, 1, 2], [0, 2, 3]]);
        assert!(cut(&[[0.0; 3], [1.0; 3]]).is_empty());
    }

    proptest::proptest! {
        #[test]
        fn every_polygon_becomes_n_minus_2_triangles_that_use_each_side_once(
            corners in proptest::collection::vec([-4_i8..5, -4..5, -1..2], 3..24),
        ) {
            let corners: Vec<[f32; 3]> = corners.iter().map(|p| p.map(f32::from)).collect();
            let n = corners.len();
            let triangles = cut(&corners);
            proptest::prop_assert_eq!(triangles.len(), n - 2);
            for side in 0..n {
                let uses = triangles
                    .iter()
                    .flat_map(|&[a, b, c]| [[a, b], [b, c], [c, a]])
                    .filter(|&edge| edge == [side, (side + 1) % n])
                    .count();
                proptest::prop_assert_eq!(uses, 1);
            }
        }
    }
}
