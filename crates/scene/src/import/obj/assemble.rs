//! Tables and faces become parts: one for each object, its colours from materials or vertices.

use std::collections::HashSet;

use polosa_math::Placement;

use super::super::Part;
use super::super::draft::{Draft, MISSING, Values, code};
use super::super::error::{Parsed, quote};
use super::super::skipped::SkippedKind;
use super::gather::Gather;
use super::{Reader, Tables};
use crate::Color;

/// What an object is called at most, in characters.
const NAME: usize = 200;

impl Reader<'_, '_, '_> {
    /// The parts, in the file's order.
    pub(super) fn parts(mut self) -> Parsed<Vec<Part>> {
        if self.textures {
            self.context.notes.push("textures are not drawn; the materials' colours are".to_owned());
        }
        self.note_unknown_materials();
        let end = self.faces.counts();
        let mut ends: Vec<(usize, usize)> =
            self.objects.iter().skip(1).map(|o| (o.first_triangle, o.first_side)).collect();
        ends.push(end);
        let mut colors = vertex_colors(&mut self.tables);
        let mut filled = Vec::new();
        for (number, (object, (triangle_end, side_end))) in self.objects.iter().zip(ends).enumerate() {
            if object.first_triangle < triangle_end {
                filled.push((object.name, object.first_triangle..triangle_end, object.first_side..side_end));
            } else if number > 0 {
                self.context.skipped.add(SkippedKind::EmptyParts, 1, None);
            }
        }
        let single = filled.len() == 1;
        let mut gathers = (!single).then(|| {
            [self.tables.positions.len(), self.tables.uvs.len(), self.tables.normals.len()].map(Gather::new)
        });
        let mut parts = Vec::with_capacity(filled.len());
        for (name, triangles, sides) in filled {
            let paint = self.paint(triangles.clone());
            let mut draft = match &mut gathers {
                None => self.whole(colors.take()),
                Some(gathers) => self.piece(gathers, triangles, sides, colors.as_deref()),
            };
            if draft.vertex_colors.is_none() {
                draft.face_colors = paint.faces;
            }
            let colored = draft.vertex_colors.is_some() || draft.face_colors.is_some();
            let name = if name.is_empty() { self.context.stem.clone() } else { quote(name, NAME) };
            parts.push(Part {
                name,
                mesh: draft.finish(&mut self.context.skipped)?,
                placement: Placement::default(),
                color: paint.one.filter(|_| !colored),
                materials: paint.materials.iter().map(|&name| quote(&self.names[name], NAME)).collect(),
            });
        }
        if let Some([positions, ..]) = &gathers {
            self.context.skipped.add(SkippedKind::UnusedVertices, positions.unmet() as u64, None);
        }
        Ok(parts)
    }

    /// The only object: the tables as they are.
    fn whole(&mut self, vertex_colors: Option<Vec<Color>>) -> Draft {
        let (tables, faces) = (core::mem::take(&mut self.tables), &mut self.faces);
        let take = core::mem::take::<Vec<[u32; 3]>>;
        let (uv, normal) = (take(&mut faces.uvs), take(&mut faces.normals));
        let triangles = take(&mut faces.triangles);
        let padded = |mut indices: Vec<[u32; 3]>| {
            indices.resize(triangles.len(), [MISSING; 3]);
            Some(indices)
        };
        Draft {
            uvs: (!uv.is_empty()).then(|| Values { values: tables.uvs, indices: padded(uv) }),
            normals: (!normal.is_empty()).then(|| Values { values: tables.normals, indices: padded(normal) }),
            positions: tables.positions,
            triangles,
            sides: faces.sides.take(),
            vertex_colors,
            face_colors: None,
        }
    }

    /// One of several objects, with what it uses of the tables.
    fn piece(
        &self,
        [gather_positions, gather_uvs, gather_normals]: &mut [Gather; 3],
        triangles: core::ops::Range<usize>,
        sides: core::ops::Range<usize>,
        vertex_colors: Option<&[Color]>,
    ) -> Draft {
        let (mut positions, mut colors) = (Vec::new(), Vec::new());
        gather_positions.next_part();
        let mut position = |shared: u32| {
            gather_positions.index(shared, |from| {
                positions.push(self.tables.positions[from]);
                if let Some(all) = vertex_colors {
                    colors.push(all[from]);
                }
                positions.len() - 1
            })
        };
        let mut draft = Draft {
            triangles: self.faces.triangles[triangles.clone()].iter().map(|t| t.map(&mut position)).collect(),
            ..Draft::default()
        };
        // An object of triangles alone needs no sides, whatever the others have.
        if let Some(all) = &self.faces.sides
            && sides.len() != 3 * triangles.len()
        {
            draft.sides = Some(all[sides].iter().map(|side| side.map(&mut position)).collect());
        }
        draft.positions = positions;
        draft.vertex_colors = vertex_colors.map(|_| colors);
        draft.uvs = values(gather_uvs, &self.tables.uvs, &self.faces.uvs, triangles.clone());
        draft.normals = values(gather_normals, &self.tables.normals, &self.faces.normals, triangles);
        draft
    }

    /// The materials of some triangles.
    fn paint(&self, triangles: core::ops::Range<usize>) -> Paint {
        let color = |material: Option<usize>| {
            material.and_then(|m| self.materials.get(&self.names[m]).copied().flatten())
        };
        // The runs that overlap, the one in force at the start included.
        let from = self.runs.partition_point(|run| run.0 <= triangles.start).saturating_sub(1);
        let mut runs: Vec<(usize, Option<usize>)> = Vec::new();
        if self.runs.get(from).is_none_or(|run| run.0 > triangles.start) {
            runs.push((triangles.start, None));
        }
        let overlapping =
            self.runs[from.min(self.runs.len())..].iter().take_while(|run| run.0 < triangles.end);
        for &(start, material) in overlapping {
            let start = start.max(triangles.start);
            if runs.last().is_some_and(|last| last.0 == start) {
                runs.pop();
            }
            runs.push((start, Some(material)));
        }
        let mut met = HashSet::new();
        let materials =
            runs.iter().filter_map(|run| run.1).filter(|&material| met.insert(material)).collect();
        let one = color(runs[0].1);
        if runs.iter().all(|run| color(run.1) == one) {
            return Paint { one, materials, faces: None };
        }
        let mut faces = Vec::with_capacity(triangles.len());
        for (number, &(start, material)) in runs.iter().enumerate() {
            let end = runs.get(number + 1).map_or(triangles.end, |next| next.0);
            let color = color(material).unwrap_or(Color::LIGHT_GREY);
            faces.resize(faces.len() + (end - start), color);
        }
        Paint { one: None, materials, faces: Some(faces) }
    }
}

/// How an object is coloured by its materials.
struct Paint {
    one: Option<Color>,
    /// Those of the triangles, each once.
    materials: Vec<usize>,
    faces: Option<Vec<Color>>,
}

/// The part of a table that some triangles use; `None` when they use nothing of it.
fn values<const N: usize>(
    gather: &mut Gather,
    table: &[[f32; N]],
    indices: &[[u32; 3]],
    triangles: core::ops::Range<usize>,
) -> Option<Values<N>> {
    // The indices end with the last triangle that has any.
    let given = indices.get(triangles.start.min(indices.len())..triangles.end.min(indices.len()))?;
    if given.as_flattened().iter().all(|&index| index == MISSING) {
        return None;
    }
    gather.next_part();
    let mut values = Vec::new();
    let mut local: Vec<[u32; 3]> = given
        .iter()
        .map(|triangle| {
            triangle.map(|shared| {
                gather.index(shared, |from| {
                    values.push(table[from]);
                    values.len() - 1
                })
            })
        })
        .collect();
    local.resize(triangles.len(), [MISSING; 3]);
    Some(Values { values, indices: Some(local) })
}

/// The vertices' colours as codes; given from 0 to 1, or from 0 to 255 when one of them is above 1.
fn vertex_colors(tables: &mut Tables) -> Option<Vec<Color>> {
    if tables.colors.is_empty() {
        return None;
    }
    tables.colors.resize(tables.positions.len(), [f32::NAN; 3]);
    let bytes = tables.colors.as_flattened().iter().any(|&c| c > 1.0);
    let scale = if bytes { 255.0 } else { 1.0 };
    let color = |c: [f32; 3]| {
        if c.iter().all(|c| c.is_nan()) {
            Color::LIGHT_GREY
        } else {
            let [r, g, b] = c.map(|c| code(c / scale));
            Color::new(r, g, b)
        }
    };
    Some(core::mem::take(&mut tables.colors).into_iter().map(color).collect())
}
