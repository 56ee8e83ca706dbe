//! glTF.

use polosa_math::glam::DVec3;
use polosa_scene::import::{Format, SkippedKind, load};
use polosa_scene::topology::Topology;
use polosa_scene::{Color, Colors};

use crate::{data, model, part, refusal};

const NODE: &str = r#"[{"mesh":0,"translation":[1,2,3],"name":"n"}]"#;

#[test]
fn embedded_external_and_binary_are_the_same_part() {
    let folder = tempfile::tempdir().unwrap();
    std::fs::write(folder.path().join("a b.bin"), data::gltf_buffer()).unwrap();
    std::fs::write(folder.path().join("t.gltf"), data::gltf_text(Some("a%20b.bin"), 60, NODE, "")).unwrap();
    let external = load(&folder.path().join("t.gltf")).unwrap();
    assert_eq!(external.format, Format::Gltf);
    for part in
        [part(data::gltf_embedded(NODE, ""), "t.gltf"), part(data::glb(NODE), "-"), external.parts[0].clone()]
    {
        assert_eq!(part.mesh.positions(), data::POSITIONS);
        assert_eq!(part.mesh.triangles(), data::TRIANGLES);
        assert_eq!(part.placement.translation, DVec3::new(1.0, 2.0, 3.0));
        assert_eq!(part.placement.scale, DVec3::ONE);
        // Linear ½ is code 188.
        assert_eq!(part.color, Some(Color::new(255, 188, 0)));
        assert_eq!((part.name.as_str(), part.materials.as_slice()), ("n", &["m".to_owned()][..]));
    }
}

#[test]
fn transforms_of_parents_are_composed() {
    let nodes = r#"[{"children":[1,2],"translation":[10,0,0],"scale":[2,2,2]},
        {"mesh":0,"translation":[1,0,0]},
        {"mesh":0,"matrix":[0,1,0,0, -1,0,0,0, 0,0,1,0, 0,5,0,1]}]"#;
    let model = model(data::gltf_embedded(nodes, ""), "t.gltf");
    let at = |part: usize, x, y, z| model.parts[part].placement.to_world(DVec3::new(x, y, z));
    assert_eq!(at(0, 1.0, 0.0, 0.0), DVec3::new(14.0, 0.0, 0.0));
    // A quarter turn about z, five up, then the parent's.
    assert!(at(1, 1.0, 0.0, 0.0).abs_diff_eq(DVec3::new(10.0, 12.0, 0.0), 1e-12));
    assert_eq!(model.parts[0].name, "tetra");
}

#[test]
fn mirroring_and_shearing_nodes_keep_the_outside_outside() {
    for matrix in ["[-1,0,0,0, 0,1,0,0, 0,0,1,0, 0,0,0,1]", "[1,0,0,0, 0.5,1,0,0, 0,0,1,0, 0,0,0,1]"] {
        let part = part(data::gltf_embedded(&format!(r#"[{{"mesh":0,"matrix":{matrix}}}]"#), ""), "m.gltf");
        assert!(Topology::of(&part.mesh).closed_outward(), "{matrix}");
        assert_eq!(part.placement, polosa_math::Placement::default());
        let first: f32 = matrix[1..].split(',').next().unwrap().parse().unwrap();
        assert_eq!(part.mesh.positions()[1], [first, 0.0, 0.0]);
    }
}

/// A glTF text with its own accessors over a buffer of the given numbers.
fn custom(buffer: &[u8], views: &str, accessors: &str, primitives: &str, more: &str) -> String {
    format!(
        r#"{{"asset":{{"version":"2.0"}},"nodes":[{{"mesh":0}}],"meshes":[{{"primitives":[{primitives}]}}],
        "buffers":[{{"byteLength":{},"uri":"data:;base64,{}"}}],"bufferViews":[{views}],
        "accessors":[{accessors}]{more}}}"#,
        buffer.len(),
        data::base64(buffer)
    )
}

fn floats(values: &[f32]) -> Vec<u8> {
    values.iter().flat_map(|v| v.to_le_bytes()).collect()
}

const POINTS: &str =
    r#"{"bufferView":0,"componentType":5126,"count":5,"type":"VEC3","min":[0,0,0],"max":[1,1,1]}"#;

#[test]
fn strips_and_fans_are_wound_as_triangles_are() {
    let buffer = floats(&[0., 0., 0., 1., 0., 0., 0., 1., 0., 1., 1., 0., 0., 2., 0.]);
    let view = format!(r#"{{"buffer":0,"byteLength":{}}}"#, buffer.len());
    let triangles = |mode: u32| {
        let primitive = format!(r#"{{"attributes":{{"POSITION":0}},"mode":{mode}}}"#);
        part(custom(&buffer, &view, POINTS, &primitive, ""), "s.gltf").mesh.triangles().to_vec()
    };
    assert_eq!(triangles(5), [[0, 1, 2], [1, 3, 2], [2, 3, 4]]);
    assert_eq!(triangles(6), [[1, 2, 0], [2, 3, 0], [3, 4, 0]]);
    assert_eq!(triangles(4), [[0, 1, 2]]);
    let lines = r#"{"attributes":{"POSITION":0},"mode":1},{"attributes":{"POSITION":0}}"#;
    let model = model(custom(&buffer, &view, POINTS, lines, ""), "l.gltf");
    assert_eq!(model.skipped.count(SkippedKind::LinesAndPoints), 1);
    assert_eq!(model.skipped.count(SkippedKind::ShortFaces), 1, "five corners are one triangle and a rest");
    assert_eq!(model.skipped.count(SkippedKind::UnusedVertices), 2);
}

#[test]
fn primitives_stay_one_mesh_and_color_its_faces() {
    let buffer = floats(&[0., 0., 0., 1., 0., 0., 0., 1., 0., 1., 1., 0., 0., 2., 0.]);
    let view = format!(r#"{{"buffer":0,"byteLength":{}}}"#, buffer.len());
    let primitives =
        r#"{"attributes":{"POSITION":0},"mode":5,"material":0},{"attributes":{"POSITION":0},"mode":6}"#;
    let materials = r#","materials":[{"pbrMetallicRoughness":{"baseColorFactor":[0,0,1,1]}}]"#;
    let part = part(custom(&buffer, &view, POINTS, primitives, materials), "p.gltf");
    let (blue, white) = (Color::new(0, 0, 255), Color::WHITE);
    assert_eq!(part.mesh.colors(), &Colors::Face(vec![blue, blue, blue, white, white, white]));
    assert_eq!((part.color, part.materials.len()), (None, 0));
}

#[test]
fn vertex_colors_are_linear_and_multiply_the_base_color() {
    let mut buffer = floats(&[0., 0., 0., 1., 0., 0., 0., 1., 0.]);
    buffer.extend([255, 255, 255, 0, 0, 128, 255, 9, 255, 0, 0, 9]);
    let views = r#"{"buffer":0,"byteLength":36},{"buffer":0,"byteOffset":36,"byteLength":12}"#;
    let accessors = r#"{"bufferView":0,"componentType":5126,"count":3,"type":"VEC3","min":[0,0,0],"max":[1,1,0]},
        {"bufferView":1,"componentType":5121,"normalized":true,"count":3,"type":"VEC4"}"#;
    let materials = r#","materials":[{"pbrMetallicRoughness":{"baseColorFactor":[0.5,1,1,1]}}]"#;
    let primitive = r#"{"attributes":{"POSITION":0,"COLOR_0":1},"material":0}"#;
    let part = part(custom(&buffer, views, accessors, primitive, materials), "c.gltf");
    let colors = vec![Color::new(188, 255, 255), Color::new(0, 188, 255), Color::new(188, 0, 0)];
    assert_eq!(part.mesh.colors(), &Colors::Vertex(colors));
}

#[test]
fn sparse_accessors_replace_entries_and_strides_are_followed() {
    let mut buffer = floats(&[0., 0., 0., 9., 1., 0., 0., 9., 0., 1., 0., 9.]);
    buffer.extend([2, 0, 0, 0]);
    buffer.extend(floats(&[0., 3., 0.]));
    let views = r#"{"buffer":0,"byteLength":48,"byteStride":16},{"buffer":0,"byteOffset":48,"byteLength":1},
        {"buffer":0,"byteOffset":52,"byteLength":12}"#;
    let sparse =
        r#""sparse":{"count":1,"indices":{"bufferView":1,"componentType":5121},"values":{"bufferView":2}}"#;
    let shape = r#""componentType":5126,"count":3,"type":"VEC3","min":[0,0,0],"max":[1,3,0]"#;
    let primitive = r#"{"attributes":{"POSITION":0}}"#;
    let dense = custom(&buffer, views, &format!(r#"{{"bufferView":0,{shape},{sparse}}}"#), primitive, "");
    assert_eq!(part(dense, "s.gltf").mesh.positions(), [[0.0; 3], [1.0, 0.0, 0.0], [0.0, 3.0, 0.0]]);
    let zeros = custom(&buffer, views, &format!("{{{shape},{sparse}}}"), primitive, "");
    assert_eq!(part(zeros, "s.gltf").mesh.positions(), [[0.0; 3], [0.0; 3], [0.0, 3.0, 0.0]]);
}

#[test]
fn quantized_positions_are_read_and_other_required_extensions_refused_by_name() {
    let buffer: Vec<u8> =
        [0_i16, 0, 0, 0, 32767, 0, 0, 0, -32768, 16384, 0, 0].iter().flat_map(|v| v.to_le_bytes()).collect();
    let view = r#"{"buffer":0,"byteLength":24,"byteStride":8}"#;
    let accessor = r#"{"bufferView":0,"componentType":5122,"normalized":true,"count":3,"type":"VEC3","min":[-1,0,0],"max":[1,1,0]}"#;
    let primitive = r#"{"attributes":{"POSITION":0}}"#;
    let text = |extension: &str| {
        let more = format!(r#","extensionsUsed":["{extension}"],"extensionsRequired":["{extension}"]"#);
        custom(&buffer, view, accessor, primitive, &more)
    };
    let positions = part(text("KHR_mesh_quantization"), "q.gltf").mesh.positions().to_vec();
    assert_eq!(positions, [[0.0; 3], [1.0, 0.0, 0.0], [-1.0, 16384.0 / 32767.0, 0.0]]);
    for (extension, advice) in [
        ("EXT_meshopt_compression", "decompress"),
        ("KHR_draco_mesh_compression", "Draco"),
        ("ACME_x", "export"),
    ] {
        let line = refusal(text(extension), "q.gltf");
        assert!(line.contains(extension) && line.contains(advice), "{line}");
    }
}

#[test]
fn bounds_of_positions_may_be_missing() {
    let text = data::gltf_embedded(NODE, "").replace(r#","min":[0,0,0],"max":[1,1,1]"#, "");
    assert_eq!(part(text, "m.gltf").mesh.positions(), data::POSITIONS);
}

#[test]
fn a_loop_of_nodes_is_refused_and_deep_nesting_is_not() {
    let line = refusal(data::gltf_embedded(r#"[{"mesh":0,"children":[1]},{"children":[0]}]"#, ""), "l.gltf");
    assert!(line.contains("node 0") && line.contains("below itself"), "{line}");
    let depth = 20_000;
    let mut nodes: Vec<String> = (1..depth).map(|child| format!(r#"{{"children":[{child}]}}"#)).collect();
    nodes.push(r#"{"mesh":0}"#.to_owned());
    assert_eq!(
        part(data::gltf_embedded(&format!("[{}]", nodes.join(",")), ""), "d.gltf").mesh.triangles().len(),
        4
    );
}
