//! Standard shapes: one function a shape, and [`Shape`], which names them all.
//!
//! All shapes stand upright along Y and have radius 1, or reach from −1 to 1. Triangles are counter-clockwise
//! from outside, vertices are shared, so that closed shapes are watertight, and the edges are those that a person
//! would draw: a square face has four sides and no diagonal. Curved shapes have smooth normals. The same call
//! gives the same bits on every machine.
//!
//! ```
//! use polosa_scene::Shape;
//!
//! let torus = "torus:64:32".parse::<Shape>()?.mesh()?;
//! assert_eq!(torus.triangles().len(), 2 * 64 * 32);
//! # Ok::<(), polosa_scene::ShapeError>(())
//! ```
//!
//! Anything else that can be cut into triangles is a [`Mesh`] from its points, edges and triangles:
//! [`from_points`].

mod build;
mod cone;
mod cube;
mod cylinder;
mod error;
mod icosahedron;
mod octahedron;
mod plane;
mod pyramid;
mod registry;
mod seed_tetrahedron;
mod sphere;
mod teapot;
mod teapot_patches;
mod tetrahedron;
mod torus;
mod uv_sphere;

pub use cone::cone;
pub use cube::cube;
pub use cylinder::cylinder;
pub use error::ShapeError;
pub use icosahedron::icosahedron;
pub use octahedron::octahedron;
pub use plane::plane;
pub use pyramid::pyramid;
pub use registry::{Shape, ShapeInfo};
pub use seed_tetrahedron::seed_tetrahedron;
pub use sphere::{Solid, sphere};
pub use teapot::teapot;
pub use tetrahedron::tetrahedron;
pub use torus::torus;
pub use uv_sphere::uv_sphere;

use crate::{Mesh, MeshError};

/// Any object that can be cut into triangles: its points, its edges as pairs and its triangles as triples of
/// numbers of points, counter-clockwise seen from outside.
///
/// ```
/// use polosa_scene::shape;
///
/// // A roof: two rectangles, each of two triangles; seven edges, no diagonals.
/// let roof = shape::from_points(
///     vec![[-1., 0., 1.], [1., 0., 1.], [1., 1., 0.], [-1., 1., 0.], [1., 0., -1.], [-1., 0., -1.]],
///     vec![[0, 1], [1, 2], [2, 3], [3, 0], [2, 4], [4, 5], [5, 3]],
///     vec![[0, 1, 2], [0, 2, 3], [3, 2, 4], [3, 4, 5]],
/// )?;
/// assert_eq!((roof.edges().len(), roof.triangles().len()), (7, 4));
/// # Ok::<(), polosa_scene::MeshError>(())
/// ```
///
/// # Errors
///
/// When an edge or a triangle names a point that is not there.
pub fn from_points(
    points: Vec<[f32; 3]>,
    edges: Vec<[u32; 2]>,
    triangles: Vec<[u32; 3]>,
) -> Result<Mesh, MeshError> {
    Mesh::new(points, triangles)?.with_edges(edges)
}
