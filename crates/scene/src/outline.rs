//! What drawing a mesh's edges needs to know, found out when it is first asked for.

use crate::Mesh;
use crate::topology::{EdgeFaces, VertexFaces};

/// At a vertex of more faces than this, the hub of a fan, only those beside an edge's own are named.
const MANY: usize = 12;

/// A mesh's edges, and the triangles around them.
#[derive(Clone, Debug)]
pub(crate) struct Outline {
    pub(crate) edges: Vec<[u32; 2]>,
    around_vertices: VertexFaces,
    on_edges: EdgeFaces,
}

impl Outline {
    pub(crate) fn of(mesh: &Mesh) -> Self {
        Self {
            edges: mesh.edges().into_owned(),
            around_vertices: VertexFaces::of(mesh),
            on_edges: EdgeFaces::of(mesh),
        }
    }

    /// The triangles of `mesh` that hold an edge, then those that share an end of it.
    pub(crate) fn around(&self, mesh: &Mesh, edge: usize) -> Vec<[u32; 3]> {
        let [a, b] = self.edges[edge];
        let triangle = |face: u32| mesh.triangles()[face as usize];
        let mut faces: Vec<[u32; 3]> = self.on_edges.on([a, b]).map(triangle).collect();
        let own = faces.len();
        for (end, other) in [(a, b), (b, a)] {
            let around = self.around_vertices.around(end);
            if around.len() <= MANY {
                faces.extend(around.iter().map(|&face| triangle(face)).filter(|face| !face.contains(&other)));
                continue;
            }
            for k in 0..own {
                for third in faces[k].into_iter().filter(|&third| third != a && third != b) {
                    let beside = self.on_edges.on([end, third]).map(triangle);
                    faces.extend(beside.filter(|face| !face.contains(&other)));
                }
            }
        }
        faces
    }
}
