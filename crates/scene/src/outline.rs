//! What drawing a mesh's edges needs to know, found out when it is first asked for.

use crate::Mesh;
use crate::topology::VertexFaces;

/// A mesh's edges, and the triangles around them.
#[derive(Clone, Debug)]
pub(crate) struct Outline {
    pub(crate) edges: Vec<[u32; 2]>,
    faces: VertexFaces,
}

impl Outline {
    pub(crate) fn of(mesh: &Mesh) -> Self {
        Self { edges: mesh.edges().into_owned(), faces: VertexFaces::of(mesh) }
    }

    /// The triangles of `mesh` that hold an end of an edge; those that hold both come twice.
    pub(crate) fn around<'a>(&'a self, mesh: &'a Mesh, edge: usize) -> impl Iterator<Item = [u32; 3]> + 'a {
        let triangles = mesh.triangles();
        self.edges[edge].into_iter().flat_map(|end| self.faces.around(end)).map(|&k| triangles[k as usize])
    }
}
