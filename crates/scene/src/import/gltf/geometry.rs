//! A glTF mesh, all its primitives together, as one draft.

use std::collections::{HashMap, HashSet};

use gltf::Semantic;
use gltf::mesh::Mode;

use super::super::draft::{Draft, Values};
use super::super::error::{Fault, Parsed, Place, quote};
use super::super::skipped::{Skipped, SkippedKind};
use super::accessor::{Buffers, indices, vectors};
use crate::Color;
use crate::srgb::encode;

/// A mesh and how it is coloured when it has one colour.
#[derive(Clone, Debug)]
pub(super) struct Geometry {
    pub(super) draft: Draft,
    pub(super) color: Option<Color>,
    /// Names, each once.
    pub(super) materials: Vec<String>,
}

/// Linear light, from 0 to 1.
type Light = [f32; 3];

fn color([r, g, b]: Light) -> Color {
    Color::new(encode(r), encode(g), encode(b))
}

/// What a primitive's vertices are read from: two with the same share them.
type Source = [Option<usize>; 4];

/// Tables of all primitives so far; attributes that only some have are zero (normals, texture coordinates) or
/// the base colour in the others.
#[derive(Default)]
struct Tables {
    positions: Vec<[f32; 3]>,
    normals: Vec<[f32; 3]>,
    uvs: Vec<[f32; 2]>,
    vertex_light: Vec<Option<Light>>,
    triangles: Vec<[u32; 3]>,
    face_colors: Vec<Color>,
}

pub(super) fn read(mesh: &gltf::Mesh<'_>, buffers: &Buffers, skipped: &mut Skipped) -> Parsed<Geometry> {
    let place = Place::Item("mesh", mesh.index() as u64);
    let mut tables = Tables::default();
    let mut sources: HashMap<(Source, [u32; 3]), usize> = HashMap::new();
    let (mut materials, mut named) = (Vec::new(), HashSet::new());
    let (mut has_normals, mut has_uvs, mut has_colors) = (false, false, false);
    for primitive in mesh.primitives() {
        if !matches!(primitive.mode(), Mode::Triangles | Mode::TriangleStrip | Mode::TriangleFan) {
            skipped.add(SkippedKind::LinesAndPoints, 1, Some(place));
            continue;
        }
        let Some(positions) = primitive.get(&Semantic::Positions) else {
            skipped.add(SkippedKind::EmptyParts, 1, Some(place));
            continue;
        };
        let attributes = [
            Some(positions.clone()),
            primitive.get(&Semantic::Normals),
            primitive.get(&Semantic::TexCoords(0)),
            primitive.get(&Semantic::Colors(0)),
        ];
        let material = primitive.material();
        let [r, g, b, _] = material.pbr_metallic_roughness().base_color_factor();
        let base = [r, g, b];
        let key = (attributes.clone().map(|a| a.map(|a| a.index())), base.map(f32::to_bits));
        let first = match sources.get(&key) {
            Some(&first) => first,
            None => {
                let first = tables.positions.len();
                let [_, normals, uvs, colors] = &attributes;
                tables.positions.extend(vectors::<3>(&positions, buffers)?);
                let count = positions.count();
                let same = |accessor: &gltf::Accessor<'_>| {
                    if accessor.count() == count { Ok(()) } else { Err(uneven(accessor, count)) }
                };
                if let Some(accessor) = normals {
                    same(accessor)?;
                    has_normals = true;
                    tables.normals.resize(first, [0.0; 3]);
                    tables.normals.extend(vectors::<3>(accessor, buffers)?);
                }
                if let Some(accessor) = uvs {
                    same(accessor)?;
                    has_uvs = true;
                    tables.uvs.resize(first, [0.0; 2]);
                    tables.uvs.extend(vectors::<2>(accessor, buffers)?);
                }
                match colors {
                    Some(accessor) => {
                        same(accessor)?;
                        has_colors = true;
                        let light = vectors::<3>(accessor, buffers)?;
                        let light = light.into_iter().map(|c| Some([c[0] * r, c[1] * g, c[2] * b]));
                        tables.vertex_light.extend(light);
                    }
                    None => tables.vertex_light.resize(tables.positions.len(), Some(base)),
                }
                sources.insert(key, first);
                first
            }
        };
        let before = tables.triangles.len();
        tables.add_triangles(&primitive, first, positions.count(), buffers, skipped, place)?;
        tables.face_colors.resize(tables.triangles.len(), color(base));
        if tables.triangles.len() > before
            && let Some(name) = material.name()
            && named.insert(name.to_owned())
        {
            materials.push(quote(name.as_bytes(), 200));
        }
    }
    let Tables { positions, mut normals, mut uvs, vertex_light, triangles, face_colors } = tables;
    normals.resize(positions.len(), [0.0; 3]);
    uvs.resize(positions.len(), [0.0; 2]);
    let single = face_colors.first().copied().filter(|one| face_colors.iter().all(|color| color == one));
    let vertex_colors =
        has_colors.then(|| vertex_light.into_iter().map(|light| light.map_or(Color::WHITE, color)).collect());
    let face_colors = (single.is_none() && !has_colors && !face_colors.is_empty()).then_some(face_colors);
    Ok(Geometry {
        draft: Draft {
            positions,
            triangles,
            sides: None,
            normals: has_normals.then_some(Values { values: normals, indices: None }),
            uvs: has_uvs.then_some(Values { values: uvs, indices: None }),
            vertex_colors,
            face_colors,
        },
        color: single.filter(|_| !has_colors),
        materials,
    })
}

#[cold]
fn uneven(accessor: &gltf::Accessor<'_>, count: usize) -> Fault {
    let number = accessor.count();
    Fault::new(format!("it has {number} entries for {count} positions: the file is broken, export it again"))
        .at(Place::Item("accessor", accessor.index() as u64))
}

impl Tables {
    fn add_triangles(
        &mut self,
        primitive: &gltf::Primitive<'_>,
        first: usize,
        count: usize,
        buffers: &Buffers,
        skipped: &mut Skipped,
        place: Place,
    ) -> Parsed<()> {
        let corners = match primitive.indices() {
            Some(accessor) => indices(&accessor, buffers)?,
            None => (0..).take(count).collect(),
        };
        if let Some(&index) = corners.iter().find(|&&index| index as usize >= count) {
            return Err(Fault::new(format!(
                "a triangle names vertex {index}, but there are only {count}: the file is broken, export it again"
            ))
            .at(place));
        }
        // A mesh with more vertices than 32 bits can number is refused when it is made.
        let first = u32::try_from(first).unwrap_or(u32::MAX);
        let corners: Vec<u32> = corners.into_iter().map(|corner| corner.saturating_add(first)).collect();
        match primitive.mode() {
            Mode::TriangleStrip => self.triangles.extend(corners.windows(3).enumerate().map(
                |(number, t)| {
                    if number % 2 == 0 { [t[0], t[1], t[2]] } else { [t[0], t[2], t[1]] }
                },
            )),
            Mode::TriangleFan => {
                let rim = corners.get(1..).unwrap_or_default().windows(2);
                self.triangles.extend(rim.map(|pair| [pair[0], pair[1], corners[0]]));
            }
            _ => {
                self.triangles.extend(corners.chunks_exact(3).map(|t| [t[0], t[1], t[2]]));
                let left = corners.len() % 3;
                skipped.add(SkippedKind::ShortFaces, u64::from(left > 0), Some(place));
            }
        }
        Ok(())
    }
}
