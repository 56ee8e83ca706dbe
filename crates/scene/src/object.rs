//! An object: a mesh at a place in the world.

use polosa_math::Placement;
use polosa_math::glam::DVec3;

use crate::{Color, MeshKey};

/// How an object is shown.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, Default)]
pub enum Show {
    /// Its edges.
    Wire,
    /// Its triangles, filled.
    #[default]
    Surface,
    /// Its triangles, and its edges over them.
    Both,
}

/// A mesh at a place in the world.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Object {
    /// Private, so that an object of a world always has a mesh: see [`World::set_mesh`](crate::World::set_mesh).
    pub(crate) mesh: MeshKey,
    /// Where it stands. Read and assign it as a whole; [`Placement::matrix`] and [`Placement::from_matrix`] give
    /// and take it as a matrix.
    pub placement: Placement,
    /// Its colour, which goes before the mesh's own colours; `None`: the mesh's own, else the default.
    pub color: Option<Color>,
    /// How it is shown.
    pub show: Show,
    /// Whether it is drawn at all.
    pub visible: bool,
}

impl Object {
    /// An object at the origin that shows `mesh` as a surface in the mesh's own colours.
    #[must_use]
    pub const fn new(mesh: MeshKey) -> Self {
        Self { mesh, placement: Placement::IDENTITY, color: None, show: Show::Surface, visible: true }
    }

    /// The same object at another place.
    #[must_use]
    pub const fn placed(self, placement: Placement) -> Self {
        Self { placement, ..self }
    }

    /// The same object with its origin moved to a point of the world.
    #[must_use]
    pub const fn at(mut self, point: DVec3) -> Self {
        self.placement.translation = point;
        self
    }

    /// The same object in one colour.
    #[must_use]
    pub const fn colored(self, color: Color) -> Self {
        Self { color: Some(color), ..self }
    }

    /// The same object, shown otherwise.
    #[must_use]
    pub const fn shown(self, show: Show) -> Self {
        Self { show, ..self }
    }

    /// The mesh that it shows.
    #[must_use]
    pub const fn mesh(&self) -> MeshKey {
        self.mesh
    }
}
