//! What a mesh hides behind itself is left out of a frame, where the balls inside it are known.
//!
//! Somebody must have asked [`World::occluders`](crate::World::occluders) for them: to look for them takes longer than a
//! few frames could gain. No pixel changes; see [`occluder`](crate::occluder).

use fearless_simd::Level;
use polosa_raster::{Clip, Cull, StoredDepth, transform};

use super::View;
use super::surface::Surface;
use crate::occluder::Shadows;

/// Meshes of fewer triangles are drawn as soon as they are looked at.
const WORTH_IT: usize = 2_000;

/// What is left of an object, and where.
#[derive(Clone, Debug, Default)]
pub(super) struct Hidden {
    marks: Vec<u8>,
    pub(super) clip: Vec<Clip>,
    pub(super) triangles: Vec<[u32; 3]>,
    /// The places of these among all of the mesh's.
    pub(super) places: Vec<u32>,
}

impl Hidden {
    /// Finds out what of a surface is not hidden by itself; how much is. `None`: nothing is known to be, draw it all.
    pub(super) fn leave_out(
        &mut self,
        level: Level,
        view: &View<'_>,
        surface: &Surface<'_>,
        size: [u32; 2],
        depth: StoredDepth,
    ) -> Option<u64> {
        let Surface { object, mesh, matrix, .. } = surface;
        let proven = view.style.cull == Cull::None && matches!(depth, StoredDepth::F32(_));
        if !proven || mesh.triangles().len() < WORTH_IT {
            return None;
        }
        let occluders = view.world.known_occluders(object.mesh())?;
        let bounds = view.world.mesh_bounds(object.mesh())?;
        let shadows = occluders.shadows(view.camera, &object.placement, &bounds, size)?;
        self.clip.resize(mesh.positions().len(), [0.0; 4]);
        transform(matrix, mesh.positions(), &mut self.clip);
        shadows.mark(level, &self.clip, &mut self.marks);
        self.triangles.clear();
        self.places.clear();
        for (place, &triangle) in (0..).zip(mesh.triangles()) {
            if !Shadows::hides(&self.marks, triangle) {
                self.triangles.push(triangle);
                self.places.push(place);
            }
        }
        Some((mesh.triangles().len() - self.triangles.len()) as u64)
    }
}
