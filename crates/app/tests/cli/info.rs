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
fn all_materials_of_a_part_are_told() {
    let folder = Folder::new()
        .with("m.obj", format!("mtllib m.mtl\nusemtl a\n{SQUARE}usemtl b\nf 1 2 3\nusemtl a\nf 2 3 4\n"))
        .with("m.mtl", "newmtl a\nKd 1 1 0\nnewmtl b\nKd 1 1 1\nnewmtl unused\n");
    let value = json(&folder, "m.obj");
    assert_eq!(value["materials"], serde_json::json!(["a", "b"]));
    assert_eq!(value["parts"][0]["materials"], serde_json::json!(["a", "b"]));
    let text = folder.done("info m.obj").text();
    assert!(text.lines().any(|line| line.split_whitespace().eq(["materials", "a,", "b"])), "{text}");
}

#[test]
fn several_models_have_a_report_each_and_a_failure_stops_none() {
    let folder = Folder::new().with("square.obj", SQUARE).with("bad.obj", "v 1 2\n");
    let said = folder.run("info square.obj bad.obj shape:cube --json");
    assert_eq!(said.status, Some(1));
    assert!(
        said.stderr.starts_with("polosa: bad.obj: line 1") && said.stderr.lines().count() == 1,
        "{said:?}"
    );
    let text = said.text();
    let names: Vec<serde_json::Value> = text
        .lines()
        .map(|line| serde_json::from_str::<serde_json::Value>(line).unwrap()["name"].take())
        .collect();
    assert_eq!(names, ["square.obj", "shape:cube"]);
    let text = folder.done("info square.obj shape:cube").text();
    assert!(text.contains("square.obj: OBJ\n") && text.contains("\nshape:cube: shape\n"), "{text}");
}

#[test]
fn very_small_and_very_large_numbers_are_powers_of_ten() {
    let folder = Folder::new().with("t.obj", "v -1e-17 0 0\nv 3000000 0 0\nv 0 0.5 -0\nf 1 2 3\n");
    let text = folder.done("info t.obj").text();
    assert!(
        text.contains("e-18, 0, 0) to (3e6, 0.5, 0)") || text.contains("e-17, 0, 0) to (3e6, 0.5, 0)"),
        "{text}"
    );
    assert_eq!(json(&folder, "t.obj")["bounds"]["max"][0], 3_000_000.0);
}

#[test]
fn parts_of_one_triangle_are_singular() {
    let folder = Folder::new().with("p.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\no a\nf 1 2 3\no b\nf 1 2 3\n");
    let text = folder.done("info p.obj").text();
    assert!(text.contains("a: 1 triangle, not watertight"), "{text}");
}

#[test]
fn shapes_and_standard_input_have_info_too() {
    let folder = Folder::new();
    let teapot = json(&folder, "shape:pyramid");
    assert_eq!((&teapot["vertices"], &teapot["edges"]), (&5.into(), &8.into()));
    let said = folder.run_with("info -", SQUARE.as_bytes());
    assert!(said.text().starts_with("standard input: OBJ"), "{said:?}");
}
