//! glTF 2.0, text and binary, read by the crate `gltf`: its JSON, its references, its nodes.
//!
//! Each node with a mesh becomes a part; its primitives stay together. The base colour factor and `COLOR_0` are
//! linear light and become sRGB codes. A node's matrix becomes a placement; when it shears or mirrors, it is
//! applied to the positions instead, and a mirroring one turns the triangles round, as glTF asks.
//!
//! Not read, with a note where it changes the picture: textures, skins, morph targets, animations.

mod accessor;
mod buffers;
mod geometry;

use std::collections::HashMap;

use gltf::json;
use polosa_math::Placement;
use polosa_math::glam::{DMat3, DMat4, DQuat, DVec3};

use super::error::{Fault, Parsed, Place, quote};
use super::{Context, Part};
use crate::Mesh;
use geometry::Geometry;

/// The most triangles and vertices that the nodes of a scene may show together: a few bytes for each node can
/// show a large mesh again and again.
const MOST_SHOWN: usize = 1 << 26;

/// Extensions that a model may require: what they change is read, or is not drawn anyway.
fn is_supported(extension: &str) -> bool {
    extension == "KHR_mesh_quantization"
        || extension == "KHR_texture_transform"
        || extension == "KHR_texture_basisu"
        || extension == "KHR_lights_punctual"
        || extension == "EXT_texture_webp"
        || extension == "EXT_texture_avif"
        || extension == "MSFT_texture_dds"
        || (extension.starts_with("KHR_materials_") && extension != "KHR_materials_pbrSpecularGlossiness")
}

fn advice(extension: &str) -> &'static str {
    match extension {
        "EXT_meshopt_compression" | "KHR_meshopt_compression" => {
            "decompress it (npx gltf-transform copy IN.glb OUT.glb) or export it without compression"
        }
        "KHR_draco_mesh_compression" => {
            "decompress it (npx gltf-transform copy IN.glb OUT.glb) or export it without Draco"
        }
        _ => "export the model without it",
    }
}

pub(super) fn read(bytes: &[u8], context: &mut Context<'_>) -> Parsed<Vec<Part>> {
    let (document, chunk) = parse(bytes)?;
    let buffers = buffers::load(&document, chunk, context.side_files)?;
    note_what_is_missing(&document, context);

    let mut meshes: HashMap<usize, Geometry> = HashMap::new();
    let mut parts = Vec::new();
    let mut visited = vec![false; document.nodes().len()];
    let mut shown = 0_usize;
    // Depth first, in the file's order, without recursion: the nesting is the file's to choose.
    let mut stack: Vec<(gltf::Node<'_>, DMat4)> = roots(&document);
    stack.reverse();
    while let Some((node, parent)) = stack.pop() {
        let place = Place::Item("node", node.index() as u64);
        if core::mem::replace(&mut visited[node.index()], true) {
            return Err(Fault::new(
                "it has two parents or is below itself: the file is broken, export it again",
            )
            .at(place));
        }
        let global = parent * local(&node);
        if let Some(mesh) = node.mesh() {
            let geometry = match meshes.entry(mesh.index()) {
                std::collections::hash_map::Entry::Occupied(known) => known.into_mut(),
                std::collections::hash_map::Entry::Vacant(new) => {
                    new.insert(geometry::read(&mesh, &buffers, &mut context.skipped)?)
                }
            };
            shown = shown
                .saturating_add(geometry.draft.triangles.len())
                .saturating_add(geometry.draft.positions.len());
            // Names of materials are copied with the mesh, too.
            let names: usize = geometry.materials.iter().map(String::len).sum();
            shown = shown.saturating_add(names);
            if shown > MOST_SHOWN {
                return Err(too_much(place));
            }
            let name = node.name().or(mesh.name()).unwrap_or(&context.stem);
            let name = quote(name.as_bytes(), 200);
            parts.push(part(name, geometry.clone(), global, context)?);
        }
        let from = stack.len();
        stack.extend(node.children().map(|child| (child, global)));
        stack[from..].reverse();
    }
    Ok(parts)
}

fn too_much(node: Place) -> Fault {
    Fault::new(format!(
        "the nodes show more than {MOST_SHOWN} triangles and vertices, the most that is read: simplify it"
    ))
    .at(node)
}

/// The document, validated, and the binary chunk.
fn parse(bytes: &[u8]) -> Parsed<(gltf::Document, Option<Vec<u8>>)> {
    if bytes.starts_with(b"glTF") {
        check_container(bytes)?;
    }
    let gltf = gltf::Gltf::from_slice_without_validation(super::detect::without_mark(bytes))
        .map_err(not_understood)?;
    let mut root: json::Root = gltf.document.into_json();
    if !root.asset.version.starts_with("2.") {
        let version = quote(root.asset.version.as_bytes(), 20);
        return Err(Fault::new(format!("it is glTF {version}; only 2.0 is read: convert it with Blender")));
    }
    if let Some(extension) = root.extensions_required.iter().find(|extension| !is_supported(extension)) {
        let (extension, advice) = (quote(extension.as_bytes(), 60), advice(extension));
        return Err(Fault::new(format!(
            "it needs the extension {extension}, which is not supported: {advice}"
        )));
    }
    // The library would refuse these by its own list.
    root.extensions_required.clear();
    check_positions(&mut root)?;
    Ok((gltf::Document::from_json(root).map_err(not_understood)?, gltf.blob))
}

/// The library's validation reads the accessor of each primitive's positions without looking whether it is there,
/// and refuses it without the bounds that some exporters leave out and nothing here needs.
fn check_positions(root: &mut json::Root) -> Parsed<()> {
    let positions = json::validation::Checked::Valid(gltf::Semantic::Positions);
    for (number, mesh) in (0..).zip(&root.meshes) {
        for primitive in &mesh.primitives {
            let Some(index) = primitive.attributes.get(&positions) else { continue };
            let Some(accessor) = root.accessors.get_mut(index.value()) else {
                let (index, count) = (index.value(), root.accessors.len());
                return Err(Fault::new(format!(
                    "its positions are accessor {index}, but there are only {count}: the file is broken, export it again"
                ))
                .at(Place::Item("mesh", number)));
            };
            let zero = json::Value::from(vec![0; 3]);
            (accessor.min, accessor.max) = (Some(zero.clone()), Some(zero));
        }
    }
    Ok(())
}

/// The header of a GLB: the library subtracts from its length without looking.
fn check_container(bytes: &[u8]) -> Parsed<()> {
    let word = |at: usize| bytes.get(at..at + 4).map(|b| u32::from_le_bytes([b[0], b[1], b[2], b[3]]));
    let cut_off = |said: u64| {
        Fault::new(format!(
            "its header says {said} bytes, but the file has {}: it is cut off; copy or export it again",
            bytes.len()
        ))
        .at(Place::Byte(8))
    };
    match (word(4), word(8), word(12)) {
        (Some(2), Some(length), Some(json)) => {
            if length < 20
                || u64::from(length) > bytes.len() as u64
                || u64::from(json) + 20 > u64::from(length)
            {
                return Err(cut_off(u64::from(length).max(u64::from(json) + 20)));
            }
            Ok(())
        }
        (Some(version), _, _) if version != 2 => {
            Err(Fault::new(format!("it is binary glTF {version}; only 2 is read: convert it with Blender")))
        }
        _ => Err(cut_off(20)),
    }
}

fn not_understood(error: gltf::Error) -> Fault {
    let what = match error {
        gltf::Error::Validation(list) => match list.first() {
            Some((path, error)) => return broken(&path.to_string(), *error),
            None => "invalid".to_owned(),
        },
        error => error.to_string(),
    };
    Fault::new(format!("this glTF is not understood ({}): export it again", quote(what.as_bytes(), 160)))
}

/// What the library found wrong, in words that say more than its own ("Missing data").
fn broken(path: &str, error: json::validation::Error) -> Fault {
    use json::validation::Error as Kind;
    let what = match error {
        Kind::IndexOutOfBounds => "names something that is not there",
        Kind::Missing => "is missing, and nothing can be read without it",
        Kind::Oversize => "is larger than a file can be",
        _ => "has a value that glTF does not know",
    };
    let path = if path.is_empty() {
        "the document".to_owned()
    } else {
        format!("`{}`", quote(path.as_bytes(), 160))
    };
    Fault::new(format!("this glTF is broken, {path} {what}: export it again"))
}

fn note_what_is_missing(document: &gltf::Document, context: &mut Context<'_>) {
    let primitives = || document.meshes().flat_map(|mesh| mesh.primitives());
    if document.skins().len() > 0 {
        context.notes.push("skins are not applied: drawn in the rest pose".to_owned());
    }
    if primitives().any(|primitive| primitive.morph_targets().len() > 0) {
        context.notes.push("morph targets are not applied".to_owned());
    }
    if document.animations().len() > 0 {
        context.notes.push("animations are not played: drawn as the nodes stand".to_owned());
    }
    if document.materials().any(|m| m.pbr_metallic_roughness().base_color_texture().is_some()) {
        context.notes.push("textures are not drawn; the materials' colours are".to_owned());
    }
}

/// The nodes of the default scene, else of the first, else those without a parent.
fn roots(document: &gltf::Document) -> Vec<(gltf::Node<'_>, DMat4)> {
    let scene = document.default_scene().or_else(|| document.scenes().next());
    let nodes: Vec<gltf::Node<'_>> = match scene {
        Some(scene) => scene.nodes().collect(),
        None => {
            let mut is_child = vec![false; document.nodes().len()];
            for child in document.nodes().flat_map(|node| node.children()) {
                is_child[child.index()] = true;
            }
            document.nodes().filter(|node| !is_child[node.index()]).collect()
        }
    };
    nodes.into_iter().map(|node| (node, DMat4::IDENTITY)).collect()
}

/// A node's own matrix, in f64.
fn local(node: &gltf::Node<'_>) -> DMat4 {
    match node.transform() {
        gltf::scene::Transform::Matrix { matrix } => {
            DMat4::from_cols_array_2d(&matrix.map(|c| c.map(f64::from)))
        }
        gltf::scene::Transform::Decomposed { translation, rotation, scale } => Placement {
            translation: DVec3::from_array(translation.map(f64::from)),
            rotation: DQuat::from_array(rotation.map(f64::from)),
            scale: DVec3::from_array(scale.map(f64::from)),
        }
        .matrix(),
    }
}

fn part(name: String, geometry: Geometry, global: DMat4, context: &mut Context<'_>) -> Parsed<Part> {
    let Geometry { mut draft, color, materials } = geometry;
    let linear = DMat3::from_mat4(global);
    let volume = linear.x_axis.cross(linear.y_axis).dot(linear.z_axis);
    let placement = match Placement::from_matrix(&global) {
        Some(placement) if volume >= 0.0 => placement,
        _ => {
            bake(&mut draft, &global, volume < 0.0);
            Placement::default()
        }
    };
    let mesh: Mesh = draft.finish(&mut context.skipped)?;
    Ok(Part { name, mesh, placement, color, materials })
}

/// Applies a matrix to positions and normals; turns the triangles round when it mirrors.
fn bake(draft: &mut super::draft::Draft, global: &DMat4, mirrors: bool) {
    for position in &mut draft.positions {
        let moved = *global * DVec3::from_array(position.map(f64::from)).extend(1.0);
        *position = moved.truncate().to_array().map(|c| c as f32);
    }
    // Normals go by the cofactors, which need no inverse and keep their direction under shear; mirrored ones
    // would point inwards.
    let m = DMat3::from_mat4(*global);
    let sign = if mirrors { -1.0 } else { 1.0 };
    let cofactors = DMat3::from_cols(
        m.y_axis.cross(m.z_axis) * sign,
        m.z_axis.cross(m.x_axis) * sign,
        m.x_axis.cross(m.y_axis) * sign,
    );
    if let Some(normals) = &mut draft.normals {
        for normal in &mut normals.values {
            let turned = cofactors * DVec3::from_array(normal.map(f64::from));
            *normal = turned.to_array().map(|c| c as f32);
        }
    }
    if mirrors {
        for triangle in &mut draft.triangles {
            triangle.swap(1, 2);
        }
    }
}
