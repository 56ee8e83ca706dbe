//! Spheres by subdivision of a solid: nearly equal triangles, no poles.

use core::fmt;
use core::str::FromStr;

use super::error::{ShapeError, within};
use super::{cube, icosahedron, octahedron, tetrahedron};
use crate::subdivide::{Onto, subdivide};
use crate::{Corners, Mesh};

/// What a sphere is subdivided from.
///
/// The error is the farthest that the triangles lie inside the sphere, as a part of its radius, at level n:
/// for equal error the tetrahedron needs twice the triangles of the octahedron.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, Default)]
#[non_exhaustive]
pub enum Solid {
    /// 4ⁿ⁺¹ triangles, error about 4¹⁻ⁿ.
    Tetrahedron,
    /// 12·4ⁿ triangles.
    Cube,
    /// 8·4ⁿ triangles, error about 4⁻ⁿ.
    #[default]
    Octahedron,
    /// 20·4ⁿ triangles, error about 0.3·4⁻ⁿ: the most equal triangles.
    Icosahedron,
}

impl Solid {
    const ALL: [(&'static str, Self); 4] = [
        ("tetrahedron", Self::Tetrahedron),
        ("cube", Self::Cube),
        ("octahedron", Self::Octahedron),
        ("icosahedron", Self::Icosahedron),
    ];

    /// The solid itself.
    #[must_use]
    pub fn mesh(self) -> Mesh {
        match self {
            Self::Tetrahedron => tetrahedron(),
            Self::Cube => cube(),
            Self::Octahedron => octahedron(),
            Self::Icosahedron => icosahedron(),
        }
    }

    /// The number of triangles of the solid, and the last level that stays below
    /// [`MOST_TRIANGLES`](crate::subdivide::MOST_TRIANGLES).
    const fn size(self) -> (u64, u32) {
        match self {
            Self::Tetrahedron => (4, 11),
            Self::Cube => (12, 10),
            Self::Octahedron => (8, 10),
            Self::Icosahedron => (20, 9),
        }
    }
}

impl fmt::Display for Solid {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let name = Self::ALL.iter().find(|(_, solid)| solid == self).map_or("", |(name, _)| name);
        f.pad(name)
    }
}

impl FromStr for Solid {
    type Err = ShapeError;

    fn from_str(text: &str) -> Result<Self, ShapeError> {
        let known = Self::ALL.iter().find(|(name, _)| *name == text);
        known.map(|&(_, solid)| solid).ok_or_else(|| ShapeError::Unknown(super::error::excerpt(text)))
    }
}

pub(super) fn count(solid: Solid, level: u32) -> Result<u64, ShapeError> {
    let (triangles, most) = solid.size();
    within("sphere", "LEVEL", level, 0..=most)?;
    Ok(triangles << (2 * level))
}

/// A sphere of radius 1: `solid` with every triangle cut into four `level` times and every vertex moved onto the
/// sphere. Its normals are smooth; its edges are the sides of all triangles.
///
/// # Errors
///
/// When `level` would make more than [`MOST_TRIANGLES`](crate::subdivide::MOST_TRIANGLES): beyond 11 for the
/// tetrahedron, 10 for the cube and the octahedron, 9 for the icosahedron.
pub fn sphere(solid: Solid, level: u32) -> Result<Mesh, ShapeError> {
    count(solid, level)?;
    let base = solid.mesh();
    // Without the base's own edges, so that the subdivided triangles' sides count as edges.
    let base = Mesh::new(base.positions().to_vec(), base.triangles().to_vec())?;
    let mesh = subdivide(&base, level, Onto::Sphere { center: [0.0; 3], radius: 1.0 })?;
    // On the unit sphere the position is the normal.
    let normals = Corners::per_vertex(mesh.positions().to_vec());
    Ok(mesh.with_normals(normals)?)
}
