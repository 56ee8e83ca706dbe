//! A part on its way to a mesh: what all readers do at the end.

use super::error::Parsed;
use super::skipped::{Skipped, SkippedKind};
use crate::{Color, Colors, Corners, Mesh};

/// An index that a corner of a face did not give.
pub(super) const MISSING: u32 = u32::MAX;

/// Values at corners: with indices of their own, or one for each position.
#[derive(Clone, Debug, Default)]
pub(super) struct Values<const N: usize> {
    pub(super) values: Vec<[f32; N]>,
    /// May hold [`MISSING`], which becomes a value of zeros.
    pub(super) indices: Option<Vec<[u32; 3]>>,
}

/// Positions and triangles with whatever belongs to them.
#[derive(Clone, Debug, Default)]
pub(super) struct Draft {
    pub(super) positions: Vec<[f32; 3]>,
    pub(super) triangles: Vec<[u32; 3]>,
    /// The polygons' sides, in any order and direction, when some polygon is not a triangle.
    pub(super) sides: Option<Vec<[u32; 2]>>,
    pub(super) normals: Option<Values<3>>,
    pub(super) uvs: Option<Values<2>>,
    pub(super) vertex_colors: Option<Vec<Color>>,
    pub(super) face_colors: Option<Vec<Color>>,
}

impl Draft {
    /// The mesh. Vertices that no triangle uses are left out and counted.
    pub(super) fn finish(mut self, skipped: &mut Skipped) -> Parsed<Mesh> {
        if let Some(normals) = &mut self.normals {
            normals.simplify(&self.triangles, self.positions.len());
        }
        if let Some(uvs) = &mut self.uvs {
            uvs.simplify(&self.triangles, self.positions.len());
        }
        self.leave_out_unused(skipped);
        let mut mesh = Mesh::new(self.positions, self.triangles)?;
        if let Some(mut sides) = self.sides {
            for side in &mut sides {
                side.sort_unstable();
            }
            sides.retain(|[a, b]| a != b);
            sides.sort_unstable();
            sides.dedup();
            mesh = mesh.with_edges(sides)?;
        }
        if let Some(normals) = self.normals {
            mesh = mesh.with_normals(normals.finish())?;
        }
        if let Some(uvs) = self.uvs {
            mesh = mesh.with_uvs(uvs.finish())?;
        }
        let colors = match (self.vertex_colors, self.face_colors) {
            (Some(colors), _) => Colors::Vertex(colors),
            (None, Some(colors)) => Colors::Face(colors),
            (None, None) => Colors::None,
        };
        Ok(mesh.with_colors(colors)?)
    }

    fn leave_out_unused(&mut self, skipped: &mut Skipped) {
        let mut used = vec![false; self.positions.len()];
        for &corner in self.triangles.as_flattened() {
            // An index out of range is refused by the mesh, which can say more about it.
            if let Some(used) = used.get_mut(corner as usize) {
                *used = true;
            }
        }
        let unused = used.iter().filter(|used| !**used).count();
        if unused == 0 {
            return;
        }
        skipped.add(SkippedKind::UnusedVertices, unused as u64, None);
        let mut next = 0;
        let moved: Vec<u32> = used
            .iter()
            .map(|&used| {
                let here = next;
                next += u32::from(used);
                here
            })
            .collect();
        let move_index = |index: &mut u32| *index = moved.get(*index as usize).copied().unwrap_or(*index);
        self.triangles.as_flattened_mut().iter_mut().for_each(move_index);
        if let Some(sides) = &mut self.sides {
            // A side of a face that was too short to be kept may name unused vertices; such faces add no sides.
            sides.retain(|side| side.iter().all(|&v| used.get(v as usize).copied().unwrap_or(true)));
            sides.as_flattened_mut().iter_mut().for_each(move_index);
        }
        keep(&mut self.positions, &used);
        if let Some(colors) = &mut self.vertex_colors {
            keep(colors, &used);
        }
        if let Some(normals) = &mut self.normals
            && normals.indices.is_none()
        {
            keep(&mut normals.values, &used);
        }
        if let Some(uvs) = &mut self.uvs
            && uvs.indices.is_none()
        {
            keep(&mut uvs.values, &used);
        }
    }
}

fn keep<T>(values: &mut Vec<T>, used: &[bool]) {
    let mut used = used.iter();
    values.retain(|_| used.next().copied().unwrap_or(false));
}

impl<const N: usize> Values<N> {
    /// Indices that repeat those of the positions, for as many values, are not needed.
    fn simplify(&mut self, triangles: &[[u32; 3]], positions: usize) {
        if self.values.len() == positions && self.indices.as_deref() == Some(triangles) {
            self.indices = None;
        }
    }

    fn finish(mut self) -> Corners<[f32; N]> {
        match self.indices {
            None => Corners::per_vertex(self.values),
            Some(mut indices) => {
                if indices.as_flattened().contains(&MISSING) {
                    let zero = u32::try_from(self.values.len()).unwrap_or(MISSING);
                    self.values.push([0.0; N]);
                    for index in indices.as_flattened_mut() {
                        if *index == MISSING {
                            *index = zero;
                        }
                    }
                }
                Corners::indexed(self.values, indices)
            }
        }
    }
}

/// An 8-bit code from a value between 0 and 1 that is sRGB-encoded already; rounded, clamped, NaN is 0.
#[cfg(any(feature = "obj", feature = "ply"))]
pub(super) fn code(value: f32) -> u8 {
    // f32 × 255 is exact in f64; `as` saturates and takes NaN to 0.
    (f64::from(value) * 255.0).round() as u8
}
