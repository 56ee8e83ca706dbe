//! Triangulations with integer vertices: no gap, no overlap, by construction.

use super::circle::{part, turns};
use super::rng::Rng;
use crate::oracle::coverage::{Vertex, edge};

/// Vertices in 1/256 px and triangles between them.
#[derive(Clone, Debug, Default)]
pub struct Mesh {
    /// In 1/256 px.
    pub vertices: Vec<Vertex>,
    /// Indices of three vertices each.
    pub triangles: Vec<[u32; 3]>,
}

impl Mesh {
    fn at(&self, index: u32) -> Vertex {
        self.vertices[index as usize]
    }

    fn area(&self, [a, b, c]: [u32; 3]) -> i128 {
        edge(self.at(a), self.at(b), self.at(c))
    }
}

/// The rectangle from `low` to `high`, cut into n × n cells; inner vertices displaced by `move_by`.
///
/// A displacement below a third of a cell keeps every triangle's winding.
#[must_use]
pub fn grid(low: Vertex, high: Vertex, n: i64, mut move_by: impl FnMut(Vertex) -> Vertex) -> Mesh {
    let mut mesh = Mesh::default();
    let index = |i: i64, j: i64| u32::try_from(j * (n + 1) + i).unwrap();
    for j in 0..=n {
        for i in 0..=n {
            let p = [low[0] + (high[0] - low[0]) * i / n, low[1] + (high[1] - low[1]) * j / n];
            let inner = i > 0 && j > 0 && i < n && j < n;
            mesh.vertices.push(if inner { move_by(p) } else { p });
        }
    }
    for j in 0..n {
        for i in 0..n {
            let [a, b, c, d] = [index(i, j), index(i + 1, j), index(i + 1, j + 1), index(i, j + 1)];
            let cut = if (i + j) % 2 == 0 { [[a, b, c], [a, c, d]] } else { [[a, b, d], [b, c, d]] };
            mesh.triangles.extend(cut);
        }
    }
    mesh
}

/// A fan of 64 triangles around `centre`, its rim at `radius` 1/256 px.
#[must_use]
pub fn fan(centre: Vertex, radius: f64) -> Mesh {
    let mut mesh = Mesh { vertices: vec![centre], triangles: Vec::new() };
    for k in 0..64 {
        let direction = turns(part(6), k);
        let end = |c: usize| centre[c] + (radius * direction[c]).round() as i64;
        mesh.vertices.push([end(0), end(1)]);
        mesh.triangles.push([0, 1 + k, 1 + (k + 1) % 64]);
    }
    mesh
}

/// A random triangulation of the rectangle from `low` to `high`: points split the triangle that
/// they fall in, then edges are flipped towards Delaunay's rule where the quad is convex.
#[must_use]
pub fn scattered(low: Vertex, high: Vertex, points: usize, r: &mut Rng, grain: i64) -> Mesh {
    let mut mesh = Mesh {
        vertices: vec![low, [high[0], low[1]], high, [low[0], high[1]]],
        triangles: vec![[0, 1, 2], [0, 2, 3]],
    };
    for _ in 0..points {
        let p = [0, 1].map(|c| low[c] + r.range(1, (high[c] - low[c]) / grain - 1) * grain);
        let inside = |&[a, b, c]: &[u32; 3]| {
            [[a, b], [b, c], [c, a]].iter().all(|&[a, b]| edge(mesh.at(a), mesh.at(b), p) > 0)
        };
        // A point on an edge or a vertex is left out: splitting there would take two triangles.
        let Some(k) = mesh.triangles.iter().position(inside) else { continue };
        let [a, b, c] = mesh.triangles[k];
        let new = u32::try_from(mesh.vertices.len()).unwrap();
        mesh.vertices.push(p);
        mesh.triangles[k] = [a, b, new];
        mesh.triangles.extend([[b, c, new], [c, a, new]]);
    }
    for _ in 0..2 * points {
        flip(&mut mesh, r);
    }
    mesh
}

/// Turns the diagonal between two neighbouring triangles, if that leaves both with positive area.
fn flip(mesh: &mut Mesh, r: &mut Rng) {
    let (k, turn) = (r.index(mesh.triangles.len()), r.index(3));
    let t = mesh.triangles[k];
    let [a, b, c] = [t[turn], t[(turn + 1) % 3], t[(turn + 2) % 3]];
    let other = |u: &[u32; 3]| (0..3).find(|&i| u[i] == b && u[(i + 1) % 3] == a).map(|i| u[(i + 2) % 3]);
    let Some((l, d)) = mesh.triangles.iter().enumerate().find_map(|(l, u)| Some((l, other(u)?))) else {
        return;
    };
    if mesh.area([a, d, c]) > 0 && mesh.area([d, b, c]) > 0 {
        mesh.triangles[k] = [a, d, c];
        mesh.triangles[l] = [d, b, c];
    }
}
