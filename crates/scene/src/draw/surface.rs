//! A surface: what one object's triangles are coloured by.

use polosa_raster::{Columns, Vertices};

use super::View;
use crate::light::Lighting;
use crate::shades::Shades;
use crate::{Color, Colors, Mesh, Object};

/// An object's surface, as one view shows it.
pub(crate) struct Surface<'a> {
    pub(super) object: &'a Object,
    pub(crate) mesh: &'a Mesh,
    /// Model to clip space.
    pub(crate) matrix: Columns,
    pub(super) lighting: Lighting,
    pub(crate) paint: Paint<'a>,
}

/// Where a surface's colours come from.
#[derive(Clone, Copy)]
pub(crate) enum Paint<'a> {
    /// One for all triangles.
    One(Color),
    /// One for each.
    Face(&'a [Color]),
    /// One for each vertex, blended in between.
    Vertex(&'a [Color]),
}

impl<'a> Paint<'a> {
    /// An object's colour goes before its mesh's, and those before the style's.
    pub(super) fn of(view: &View<'_>, object: &Object, mesh: &'a Mesh) -> Self {
        match (object.color, mesh.colors()) {
            (Some(color), _) => Self::One(color),
            (None, Colors::None) => Self::One(view.style.color),
            (None, Colors::Face(colors)) => Self::Face(colors),
            (None, Colors::Vertex(colors)) => Self::Vertex(colors),
        }
    }

    pub(super) const fn is_blended(&self) -> bool {
        matches!(self, Self::Vertex(_))
    }
}

/// Something that takes how a triangle's value is found from its place and its intensity.
pub(super) trait Take<R> {
    fn take(self, shade: impl Fn(usize, f32) -> u32 + Sync) -> R;
}

/// A table of shades is made for surfaces of at least so many triangles; for fewer the formula is sooner done.
const WORTH_SHADES: usize = 2_000;

impl<'a> Surface<'a> {
    pub(crate) fn new(view: &View<'_>, object: &'a Object, mesh: &'a Mesh) -> Self {
        Self {
            object,
            mesh,
            matrix: view.camera.clip_from_model(&object.placement),
            lighting: Lighting::new(view.light, view.style.shading, view.camera, &object.placement),
            paint: Paint::of(view, object, mesh),
        }
    }

    pub(super) fn vertices(&self) -> Vertices<'_> {
        Vertices::Model { matrix: &self.matrix, positions: self.mesh.positions() }
    }

    /// How much of its colour a triangle shows.
    pub(crate) fn intensity(&self, index: usize) -> f32 {
        let positions = self.mesh.positions();
        self.lighting.intensity(self.mesh.triangles()[index].map(|vertex| positions[vertex as usize]))
    }

    /// Hands over how a triangle's pixel is found. `blended` is asked where that is no one colour.
    ///
    /// `shades` keeps a table from one surface to the next of the same colour.
    pub(super) fn give<R>(
        &self,
        shades: &mut Option<Shades>,
        to: impl Take<R>,
        blended: impl Fn(usize) -> u32 + Sync,
    ) -> R {
        match self.paint {
            Paint::One(color) => {
                if shades.as_ref().is_none_or(|shades| shades.color() != color) {
                    if self.mesh.triangles().len() < WORTH_SHADES {
                        return to.take(|_, intensity| Lighting::pixel(color, intensity));
                    }
                    *shades = None;
                }
                let shades = shades.get_or_insert_with(|| Shades::new(color));
                to.take(|_, intensity| shades.pixel(intensity))
            }
            Paint::Face(colors) => to.take(|index, intensity| Lighting::pixel(colors[index], intensity)),
            Paint::Vertex(_) => to.take(|index, _| blended(index)),
        }
    }
}
