//! Indexed triangle meshes.

use std::borrow::Cow;

use crate::Color;

/// Colours of a mesh.
#[derive(Clone, Debug, PartialEq, Default)]
#[non_exhaustive]
pub enum Colors {
    /// None: the object's colour counts.
    #[default]
    None,
    /// One for each position, blended over the triangles.
    Vertex(Vec<Color>),
    /// One for each triangle.
    Face(Vec<Color>),
}

/// Values at the corners of the triangles, such as normals and texture coordinates.
#[derive(Clone, Debug, PartialEq)]
pub struct Corners<T> {
    values: Vec<T>,
    /// Three indices into `values` for each triangle; `None`: the triangle's own, as for positions.
    indices: Option<Vec<[u32; 3]>>,
}

impl<T> Corners<T> {
    /// One value for each position of the mesh.
    #[must_use]
    pub const fn per_vertex(values: Vec<T>) -> Self {
        Self { values, indices: None }
    }

    /// Values with three indices of their own for each triangle, so that positions stay shared where a normal
    /// or a texture coordinate differs from face to face.
    #[must_use]
    pub const fn indexed(values: Vec<T>, indices: Vec<[u32; 3]>) -> Self {
        Self { values, indices: Some(indices) }
    }

    /// The values.
    #[must_use]
    pub fn values(&self) -> &[T] {
        &self.values
    }

    /// The values' own indices, if they have any.
    #[must_use]
    pub fn indices(&self) -> Option<&[[u32; 3]]> {
        self.indices.as_deref()
    }
}

/// Why parts do not make a mesh.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[non_exhaustive]
pub enum MeshError {
    /// A triangle or edge names a vertex that is not there.
    #[error("{what} {number} names {of} {index}, but there are only {count}")]
    Index {
        /// `triangle` or `edge`.
        what: &'static str,
        /// Its number, from 0.
        number: usize,
        /// `vertex`, `normal` or `texture coordinate`.
        of: &'static str,
        /// The index that is out of range.
        index: u32,
        /// How many there are.
        count: usize,
    },
    /// An attribute has another length than what it belongs to.
    #[error("{given} {what} for {needed} {of}: give one for each")]
    Length {
        /// What is given.
        what: &'static str,
        /// What it belongs to.
        of: &'static str,
        /// How many are given.
        given: usize,
        /// How many are needed.
        needed: usize,
    },
    /// More vertices or triangles than 32-bit indices can name.
    #[error("{0} {1}: a mesh holds at most 4,294,967,295")]
    TooLarge(usize, &'static str),
}

/// Triangles over shared positions.
///
/// # Guarantees
///
/// Every index of triangles, edges and attributes is in range, and every attribute has the length that it must
/// have; the constructors refuse anything else, and the drawing relies on it. Positions may be any `f32`,
/// infinite and NaN included (drawing rejects and counts such triangles); triangles may be degenerate.
///
/// ```
/// use polosa_scene::Mesh;
///
/// let square = Mesh::new(
///     vec![[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [1.0, 1.0, 0.0], [0.0, 1.0, 0.0]],
///     vec![[0, 1, 2], [0, 2, 3]],
/// )?
/// .with_edges(vec![[0, 1], [1, 2], [2, 3], [3, 0]])?; // the diagonal is no edge
/// assert_eq!(square.edges().len(), 4);
/// # Ok::<(), polosa_scene::MeshError>(())
/// ```
#[derive(Clone, Debug, PartialEq, Default)]
pub struct Mesh {
    positions: Vec<[f32; 3]>,
    triangles: Vec<[u32; 3]>,
    edges: Option<Vec<[u32; 2]>>,
    normals: Option<Corners<[f32; 3]>>,
    uvs: Option<Corners<[f32; 2]>>,
    colors: Colors,
}

impl Mesh {
    /// A mesh of `triangles` over `positions`, counter-clockwise seen from outside.
    ///
    /// # Errors
    ///
    /// When a triangle names a position that is not there.
    pub fn new(positions: Vec<[f32; 3]>, triangles: Vec<[u32; 3]>) -> Result<Self, MeshError> {
        for (given, what) in [(positions.len(), "vertices"), (triangles.len(), "triangles")] {
            if u32::try_from(given).is_err() {
                return Err(MeshError::TooLarge(given, what));
            }
        }
        check_indices("triangle", &triangles, "vertex", positions.len())?;
        Ok(Self { positions, triangles, ..Self::default() })
    }

    /// The same mesh with the edges that wire drawing shows, as pairs of positions.
    ///
    /// # Errors
    ///
    /// When an edge names a position that is not there.
    pub fn with_edges(mut self, edges: Vec<[u32; 2]>) -> Result<Self, MeshError> {
        check_indices("edge", &edges, "vertex", self.positions.len())?;
        self.edges = Some(edges);
        Ok(self)
    }

    /// The same mesh with colours.
    ///
    /// # Errors
    ///
    /// When there is not one for each position or triangle.
    pub fn with_colors(mut self, colors: Colors) -> Result<Self, MeshError> {
        match &colors {
            Colors::None => {}
            Colors::Vertex(c) => check_length("colours", c.len(), "vertices", self.positions.len())?,
            Colors::Face(c) => check_length("colours", c.len(), "triangles", self.triangles.len())?,
        }
        self.colors = colors;
        Ok(self)
    }

    /// The same mesh with normals: of any length, zero included, seen from outside.
    ///
    /// # Errors
    ///
    /// When an index is out of range or a length is wrong.
    pub fn with_normals(mut self, normals: Corners<[f32; 3]>) -> Result<Self, MeshError> {
        self.check_corners("normals", "normal", &normals)?;
        self.normals = Some(normals);
        Ok(self)
    }

    /// The same mesh with texture coordinates: u to the right, v down from the picture's top edge, as in glTF.
    ///
    /// # Errors
    ///
    /// When an index is out of range or a length is wrong.
    pub fn with_uvs(mut self, uvs: Corners<[f32; 2]>) -> Result<Self, MeshError> {
        self.check_corners("texture coordinates", "texture coordinate", &uvs)?;
        self.uvs = Some(uvs);
        Ok(self)
    }

    fn check_corners<T>(
        &self,
        whats: &'static str,
        of: &'static str,
        corners: &Corners<T>,
    ) -> Result<(), MeshError> {
        match &corners.indices {
            None => check_length(whats, corners.values.len(), "vertices", self.positions.len()),
            Some(indices) => {
                check_length("index triples", indices.len(), "triangles", self.triangles.len())?;
                check_indices("triangle", indices, of, corners.values.len())
            }
        }
    }

    /// The positions.
    #[must_use]
    pub fn positions(&self) -> &[[f32; 3]] {
        &self.positions
    }

    /// The triangles, as triples of indices into the positions.
    #[must_use]
    pub fn triangles(&self) -> &[[u32; 3]] {
        &self.triangles
    }

    /// The normals, if the mesh has any.
    #[must_use]
    pub const fn normals(&self) -> Option<&Corners<[f32; 3]>> {
        self.normals.as_ref()
    }

    /// The texture coordinates, if the mesh has any.
    #[must_use]
    pub const fn uvs(&self) -> Option<&Corners<[f32; 2]>> {
        self.uvs.as_ref()
    }

    /// The colours.
    #[must_use]
    pub const fn colors(&self) -> &Colors {
        &self.colors
    }

    /// Whether the mesh was given edges of its own, such as the sides of a file's polygons.
    #[must_use]
    pub const fn has_own_edges(&self) -> bool {
        self.edges.is_some()
    }

    /// The edges: those that were given, else every side of every triangle, once, lower index first, in order.
    #[must_use]
    pub fn edges(&self) -> Cow<'_, [[u32; 2]]> {
        match &self.edges {
            Some(edges) => Cow::Borrowed(edges),
            None => {
                let mut sides: Vec<[u32; 2]> = self
                    .triangles
                    .iter()
                    .flat_map(|&[a, b, c]| [[a, b], [b, c], [c, a]])
                    .map(|[a, b]| [a.min(b), a.max(b)])
                    .filter(|[a, b]| a != b)
                    .collect();
                sides.sort_unstable();
                sides.dedup();
                Cow::Owned(sides)
            }
        }
    }
}

fn check_indices<const N: usize>(
    what: &'static str,
    items: &[[u32; N]],
    of: &'static str,
    count: usize,
) -> Result<(), MeshError> {
    for (number, item) in items.iter().enumerate() {
        if let Some(&index) = item.iter().find(|&&index| index as usize >= count) {
            return Err(MeshError::Index { what, number, of, index, count });
        }
    }
    Ok(())
}

const fn check_length(
    what: &'static str,
    given: usize,
    of: &'static str,
    needed: usize,
) -> Result<(), MeshError> {
    if given == needed { Ok(()) } else { Err(MeshError::Length { what, of, given, needed }) }
}
