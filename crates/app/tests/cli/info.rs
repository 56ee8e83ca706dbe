//! `polosa info`.

use crate::support::{Folder, SQUARE, cube_stl};

fn json(folder: &Folder, model: &str) -> serde_json::Value {
    let text = folder.done(&format!("info {model} --json")).text();
    assert_eq!(text.lines().count(), 1);
    serde_json::from_str(&text).unwrap()
}

#[test]
fn a_closed_solid_is_watertight_and_an_open_one_is_not() {
    let folder = Folder::new().with("square.obj", SQUARE).with("cube.stl", cube_stl());
    let cube = json(&folder, "cube.stl");
    assert_eq!(cube["format"], "STL");
    assert_eq!(cube["vertices"], 8);
    assert_eq!(cube["triangles"], 12);
    assert_eq!(cube["edges"], 18);
    assert_eq!(cube["open_edges"], 0);
    assert_eq!(cube["watertight"], true);
    assert_eq!(cube["faces_outward"], true);
    let square = json(&folder, "square.obj");
    assert_eq!(square["edges"], 4, "a polygon's sides, without the diagonal");
    assert_eq!(square["open_edges"], 4);
    assert_eq!(square["watertight"], false);
}

#[test]
fn bounds_materials_and_degenerate_faces_are_told() {
    let folder = Folder::new()
        .with("m.obj", "mtllib m.mtl\nusemtl brass\nv 1 2 3\nv 5 2 3\nv 1 9 3\nf 1 2 3\nf 1 2 2\n")
        .with("m.mtl", "newmtl brass\nKd 1 1 0\n");
    let value = json(&folder, "m.obj");
    assert_eq!(value["bounds"]["min"], serde_json::json!([1.0, 2.0, 3.0]));
    assert_eq!(value["bounds"]["size"], serde_json::json!([4.0, 7.0, 0.0]));
    assert_eq!(value["materials"], serde_json::json!(["brass"]));
    assert_eq!(value["degenerate_faces"], 1);
    let text = folder.done("info m.obj").text();
    for part in ["m.obj: OBJ", "brass", "(1, 2, 3) to (5, 9, 3)", "4 × 7 × 0", "watertight          no"] {
        assert!(text.contains(part), "{part}: {text}");
    }
}

#[test]
fn shapes_and_standard_input_have_info_too() {
    let folder = Folder::new();
    let teapot = json(&folder, "shape:pyramid");
    assert_eq!((&teapot["vertices"], &teapot["edges"]), (&5.into(), &8.into()));
    let said = folder.run_with("info -", SQUARE.as_bytes());
    assert!(said.text().starts_with("standard input: OBJ"), "{said:?}");
}
