//! Clipping in `f64`, so that two triangles that share an edge are cut at the same point, to the last bit.
//!
//! Two rules make that so:
//!
//! 1. Whether a vertex is inside a plane is decided by one expression, [`Clipper::distance`], of that vertex
//!    alone, and an edge is cut if and only if its two ends differ. No decision is made per triangle.
//! 2. A cut is computed from the inside end to the outside one, whichever way the triangle runs.
//!
//! ```text
//!        inside │ outside           d = distance to the plane, in clip space
//!               │                   t = d(in) / (d(in) − d(out))
//!     in ●──────┼──────● out        cut = in + (out − in)·t
//!         d(in) │ d(out)
//! ```
//!
//! Planes, in this order: near (z ≤ w), far (z ≥ 0), then the left, right, top and bottom of the guard band,
//! which lies far outside the picture: what crosses only the picture's border is not cut but scissored.

use polosa_math::Viewport;

use crate::snap::GUARD;

/// Near, far, left, right, top, bottom.
pub(crate) const PLANES: usize = 6;

/// A triangle has three corners, and each plane adds one at most.
pub(crate) const MOST: usize = 3 + PLANES;

/// A vertex while it is being clipped.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct Vertex {
    /// In clip space.
    pub(crate) position: [f64; 4],
    /// What the three vertices of the whole triangle contribute to it.
    pub(crate) weights: [f64; 3],
}

/// The planes of one picture.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Clipper {
    /// Factors of w and of x (or y) in the distance to left, right, top and bottom.
    guard: [[f64; 2]; 4],
}

impl Clipper {
    pub(crate) fn new(viewport: &Viewport) -> Self {
        let g = f64::from(GUARD);
        // Where X = x/w·s + o, X ≥ −g is (g + o)·w + s·x ≥ 0, and X ≤ g is (g − o)·w − s·x ≥ 0.
        let Viewport { scale: [sx, sy], offset: [ox, oy] } = *viewport;
        Self { guard: [[g + ox, sx], [g - ox, -sx], [g + oy, sy], [g - oy, -sy]] }
    }

    /// Positive or zero inside a plane, negative outside.
    #[inline]
    fn distance(&self, plane: usize, [x, y, z, w]: [f64; 4]) -> f64 {
        let guard = |[a, b]: [f64; 2], v: f64| a * w + b * v;
        match plane {
            0 => w - z,
            1 => z,
            2 => guard(self.guard[0], x),
            3 => guard(self.guard[1], x),
            4 => guard(self.guard[2], y),
            _ => guard(self.guard[3], y),
        }
    }

    /// A bit for each plane that the point is outside of.
    #[inline]
    pub(crate) fn outcode(&self, position: [f64; 4]) -> u8 {
        (0..PLANES).fold(0, |code, plane| code | u8::from(self.distance(plane, position) < 0.0) << plane)
    }

    /// Where the line from an inside point to an outside one meets a plane.
    fn cut(&self, plane: usize, inside: &Vertex, outside: &Vertex) -> Vertex {
        let d = self.distance(plane, inside.position);
        let t = d / (d - self.distance(plane, outside.position));
        let mut cut = Vertex {
            position: lerp(inside.position, outside.position, t),
            weights: lerp(inside.weights, outside.weights, t),
        };
        // On the plane exactly: depth is 1 on the near plane and 0 on the far one, and a cut at the guard band
        // stays there even where the outside end lies so far out that rounding moves the cut by more than a
        // picture's width.
        let w = cut.position[3];
        match plane {
            0 => cut.position[2] = w,
            1 => cut.position[2] = 0.0,
            _ => {
                let [a, b] = self.guard[plane - 2];
                cut.position[(plane - 2) / 2] = -a / b * w;
            }
        }
        cut
    }

    /// Clips a triangle against the planes in `planes` (a bit each).
    pub(crate) fn triangle(&self, corners: [[f64; 4]; 3], planes: u8) -> Polygon {
        let mut polygon = Polygon { vertices: [Vertex::default(); MOST], count: 3 };
        for (k, position) in corners.into_iter().enumerate() {
            polygon.vertices[k].position = position;
            polygon.vertices[k].weights[k] = 1.0;
        }
        for plane in (0..PLANES).filter(|plane| planes >> plane & 1 == 1) {
            polygon = self.against(plane, &polygon);
        }
        polygon
    }

    fn against(&self, plane: usize, polygon: &Polygon) -> Polygon {
        let mut kept = Polygon { vertices: [Vertex::default(); MOST], count: 0 };
        let Some(mut from) = polygon.as_slice().last() else { return kept };
        let mut from_inside = self.distance(plane, from.position) >= 0.0;
        for to in polygon.as_slice() {
            let to_inside = self.distance(plane, to.position) >= 0.0;
            match (from_inside, to_inside) {
                (true, false) => kept.push(self.cut(plane, from, to)),
                (false, true) => kept.push(self.cut(plane, to, from)),
                _ => {}
            }
            if to_inside {
                kept.push(*to);
            }
            (from, from_inside) = (to, to_inside);
        }
        kept
    }

    /// Clips a line against the planes in `planes`; `None` when nothing is left.
    pub(crate) fn line(&self, ends: [[f64; 4]; 2], planes: u8) -> Option<[[f64; 4]; 2]> {
        let mut ends = ends.map(|position| Vertex { position, weights: [0.0; 3] });
        for plane in (0..PLANES).filter(|plane| planes >> plane & 1 == 1) {
            let inside = [0, 1].map(|k: usize| self.distance(plane, ends[k].position) >= 0.0);
            match inside {
                [true, true] => {}
                [false, false] => return None,
                [true, false] => ends[1] = self.cut(plane, &ends[0], &ends[1]),
                [false, true] => ends[0] = self.cut(plane, &ends[1], &ends[0]),
            }
        }
        Some(ends.map(|end| end.position))
    }
}

/// What is left of a triangle: convex, with up to nine corners.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Polygon {
    vertices: [Vertex; MOST],
    count: usize,
}

impl Polygon {
    pub(crate) fn as_slice(&self) -> &[Vertex] {
        &self.vertices[..self.count]
    }

    /// Rounding can leave a polygon that a plane crosses more than twice; what has no room is left out.
    fn push(&mut self, vertex: Vertex) {
        if let Some(place) = self.vertices.get_mut(self.count) {
            *place = vertex;
            self.count += 1;
        }
    }
}

fn lerp<const N: usize>(from: [f64; N], to: [f64; N], t: f64) -> [f64; N] {
    core::array::from_fn(|k| from[k] + (to[k] - from[k]) * t)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn an_edge_is_cut_at_the_same_point_from_both_sides() {
        let clipper = Clipper::new(&Viewport::new(640, 480));
        let a = [0.1, 0.7, 0.3, 0.9];
        let b = [-0.4, 0.2, 1.7, 0.6];
        let (c, d) = ([0.5, -0.5, 0.2, 1.0], [-0.9, 0.9, 0.1, 1.0]);
        let shared = |polygon: Polygon| {
            let on_near = |v: &&Vertex| v.position[2].to_bits() == v.position[3].to_bits();
            let mut cuts: [[u64; 4]; MOST] = [[0; 4]; MOST];
            let mut count = 0;
            for vertex in polygon.as_slice().iter().filter(on_near) {
                cuts[count] = vertex.position.map(f64::to_bits);
                count += 1;
            }
            (cuts, count)
        };
        let (left, n) = shared(clipper.triangle([a, b, c], 1));
        let (right, m) = shared(clipper.triangle([b, a, d], 1));
        assert_eq!((n, m), (2, 2));
        assert!(left[..n].iter().any(|cut| right[..m].contains(cut)));
    }
}
