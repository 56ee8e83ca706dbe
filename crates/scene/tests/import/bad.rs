//! Bad input: each kind has its line.

use std::path::Path;

use polosa_scene::import::{Format, Place, load, read};

use crate::data::{self, Ply};
use crate::{model, refusal};

#[test]
fn missing_files_folders_and_empty_files_are_told_apart() {
    let folder = tempfile::tempdir().unwrap();
    let line = |path: &Path| load(path).unwrap_err().to_string();
    assert!(line(&folder.path().join("gone.obj")).contains("no such file"));
    assert!(line(folder.path()).contains("is a folder"));
    std::fs::write(folder.path().join("empty.stl"), "").unwrap();
    let empty = line(&folder.path().join("empty.stl"));
    assert!(empty.contains("empty.stl") && empty.contains("the file is empty"), "{empty}");
}

#[cfg(target_os = "linux")]
#[test]
fn an_endless_file_ends_with_an_error() {
    // Refused before anything is read: what the name or the first bytes say does not matter.
    let folder = tempfile::tempdir().unwrap();
    let file = std::fs::File::create(folder.path().join("huge.stl")).unwrap();
    file.set_len(polosa_scene::import::MAX_FILE + 1).unwrap();
    assert!(load(&folder.path().join("huge.stl")).unwrap_err().to_string().contains("2 GiB"));
}

#[test]
fn obj_errors_name_the_line() {
    let vertices = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";
    for (end, what) in [
        ("f 1 2 4\n", "line 4: a face names vertex 4, but the file has 3 vertices"),
        ("f 1 2 0\n", "line 4: a face names vertex 0, but OBJ counts from 1"),
        ("f 1 2 -4\n", "line 4: a face names vertex -4, but there are fewer"),
        ("f 1/1 2 3\n", "line 4: a face names texture coordinate 1, but the file has 0"),
        ("f 1//9 2 3\n", "line 4: a face names normal 9"),
        ("f 1 2 x\n", "line 4: `x` is not a corner"),
        ("f 1 2 99999999999999999999\n", "is not a corner"),
        ("v 1 2\n", "line 4: a vertex needs three coordinates"),
        ("v 1 2 3,5\n", "line 4: `3,5` is not a number"),
        ("vn 1 2\n", "line 4: a normal needs three"),
        ("vt x\n", "line 4: `x` is not a number"),
        ("", "no face"),
        ("l 1 2\np 1\n", "no face but 2 lines and points (the first at line 4)"),
        ("l 1 2\n", "no face but 1 line or point (at line 4)"),
    ] {
        let line = refusal(format!("{vertices}{end}"), "b.obj");
        assert!(line.contains(what), "{line}");
    }
    let error = read(format!("{vertices}f 1 2 9\n").as_bytes(), "b.obj", None, None).unwrap_err();
    assert_eq!((error.file(), error.place()), ("b.obj", Some(Place::Line(4))));
}

#[test]
fn a_cut_off_stl_is_refused() {
    let binary = data::stl_binary(b"");
    let line = refusal(&binary[..binary.len() - 1], "c.stl");
    assert!(line.contains("byte 80: the header says 4 triangles, 284 bytes, but the file has 283"), "{line}");
    assert!(refusal(&binary[..50], "c.stl").contains("too few for its header"));
    let ascii = data::stl_ascii();
    let line = refusal(&ascii[..ascii.len() / 2 + 60], "c.stl");
    assert!(line.contains("line ") && line.contains("cut off"), "{line}");
    assert!(
        refusal("solid x\nfacet normal 0 0 1\nouter loop\nvertex 0 0 z\n", "c.stl").contains("line 4: `z`")
    );
    let mut empty = vec![b' '; 84];
    empty[80..].fill(0);
    assert!(refusal(&empty, "e.stl").contains("this is an empty STL"));
    assert!(refusal("solid x\nendsolid x\n", "c.stl").contains("no face"));
}

#[test]
fn a_cut_off_or_lying_ply_is_refused() {
    for encoding in [Ply::Ascii, Ply::Little, Ply::Big] {
        let bytes = data::ply(encoding);
        let line = refusal(&bytes[..bytes.len() - 9], "c.ply");
        assert!(line.contains("cut off") || line.contains("not understood"), "{encoding:?}: {line}");
        let header = bytes.windows(11).position(|w| w == b"end_header\n").unwrap();
        assert!(refusal(&bytes[..header], "c.ply").contains("header"));
    }
    let text = String::from_utf8(data::ply(Ply::Ascii)).unwrap();
    for (from, to, what) in [
        ("vertex 4", "vertex 4000000000", "4000000000 entries of `vertex`, more than"),
        ("face 4", "face 18446744073709551615", "more than"),
        (
            "face 4",
            "face 99999999999999999999",
            "line 11: the header says 99999999999999999999 entries of `face`",
        ),
        ("3 0 2 1", "3 0 2 4", "face 0: a face names vertex 4, but the file has 4"),
        ("3 0 2 1", "3 0 2 -1", "line 18: a face names vertex -1"),
        ("3 0 2 1", "4000000000 0 2 1", "line 18"),
        ("3 0 2 1", "3 0 2 x", "line 18"),
        ("element vertex", "element vortex", "no element `vertex`"),
        ("float x", "float q", "no properties `x`"),
        ("ascii 1.0", "ebcdic 1.0", "line 2"),
        ("list uchar int", "list uchar float", "not integers"),
    ] {
        assert!(text.contains(from), "{from}");
        let line = refusal(text.replacen(from, to, 1), "c.ply");
        assert!(line.contains(what), "{from} → {to}: {line}");
    }
}

#[test]
fn a_broken_gltf_is_refused() {
    let node = r#"[{"mesh":0}]"#;
    let text = data::gltf_embedded(node, "");
    for (from, to, what) in [
        (r#""count":12"#, r#""count":13"#, "accessor 1: it reaches beyond its buffer"),
        (r#""count":4"#, r#""count":4000000000"#, "accessor 0: it reaches beyond"),
        (r#""byteOffset":48"#, r#""byteOffset":49"#, "beyond"),
        (r#""byteLength":60"#, r#""byteLength":61"#, "buffer 0: it should have 61 bytes and has 60"),
        ("base64,", "base64,!", "data: URI is broken"),
        (";base64,", ",", "not base64"),
        (r#""mesh":0"#, r#""mesh":7"#, "broken, `nodes[0].mesh` names something that is not there"),
        (
            r#","type":"SCALAR""#,
            r#","type":"SKALAR""#,
            "`accessors[1].type` has a value that glTF does not know",
        ),
        // The library's validation panics on this one.
        (r#""POSITION":0"#, r#""POSITION":2"#, "mesh 0: its positions are accessor 2, but there are only 2"),
        (
            r#""bufferView":1,"#,
            "",
            "broken, `accessors[1].bufferView` is missing, and nothing can be read without it",
        ),
        ("VEC3", "VEC2", "accessor 0: its entries have too few components"),
        (r#""version":"2.0""#, r#""version":"1.0""#, "glTF 1.0"),
        (r#""componentType":5121"#, r#""componentType":5126"#, "accessor 1"),
        (r#""asset":"#, r#""asset":["#, "not understood"),
        (r#""nodes":[0]"#, r#""nodes":[]"#, "no face"),
    ] {
        assert!(text.contains(from), "{from}");
        let line = refusal(text.replacen(from, to, 1), "b.gltf");
        assert!(line.contains(what), "{from} → {to}: {line}");
    }
    // Index 3 becomes 255.
    let mut glb = data::glb(node);
    *glb.last_mut().unwrap() = 255;
    assert!(refusal(&glb, "b.glb").contains("mesh 0: a triangle names vertex 255, but there are only 4"));
    assert!(refusal(&glb[..glb.len() - 4], "b.glb").contains("cut off"));
    glb[8..12].copy_from_slice(&3_u32.to_le_bytes());
    assert!(refusal(&glb, "b.glb").contains("byte 8"));
    assert!(refusal(data::gltf_text(Some("b.bin"), 60, node, ""), "b.gltf").contains("`b.bin`"));
    assert!(
        refusal(data::gltf_text(Some("https://x.org/b.bin"), 60, node, ""), "b.gltf").contains("download")
    );
}

#[test]
fn side_buffers_outside_the_folder_are_not_read() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("s.gltf");
    for (uri, what) in [
        ("../x.bin", "own folder"),
        ("/dev/zero", "own folder"),
        ("%2e%2e/x.bin", "own folder"),
        ("x.bin", "missing"),
    ] {
        std::fs::write(&path, data::gltf_text(Some(uri), 60, r#"[{"mesh":0}]"#, "")).unwrap();
        let line = load(&path).unwrap_err().to_string();
        assert!(line.contains("buffer 0") && line.contains(what), "{line}");
    }
}

#[test]
fn the_content_wins_over_name_and_format_with_a_note() {
    let model = model(data::obj(), "x.stl");
    assert_eq!(model.format, Format::Obj);
    assert!(model.notes[0].contains("OBJ, not STL"));
    let model = read(&data::ply(Ply::Big), "-", Some(Format::Gltf), None).unwrap();
    assert_eq!((model.format, model.parts[0].name.as_str()), (Format::Ply, "model"));
    assert!(model.notes[0].contains("PLY, not glTF"));
}

#[test]
fn a_few_bytes_cannot_show_a_mesh_without_end() {
    // 12,000 triangles of the same four corners, shown by 6,000 nodes: 72 million.
    let indices = data::TRIANGLES.as_flattened().repeat(3_000);
    let mut buffer: Vec<u8> = data::POSITIONS.as_flattened().iter().flat_map(|c| c.to_le_bytes()).collect();
    buffer.extend(indices.iter().map(|&i| u8::try_from(i).unwrap()));
    let nodes: Vec<String> = (0..6_000).map(|_| r#"{"mesh":0}"#.to_owned()).collect();
    let roots: Vec<String> = (0..6_000).map(|i| i.to_string()).collect();
    let uri = format!("data:;base64,{}", data::base64(&buffer));
    let text = data::gltf_text(Some(&uri), buffer.len(), &format!("[{}]", nodes.join(",")), "")
        .replace(r#""nodes":[0]"#, &format!(r#""nodes":[{}]"#, roots.join(",")))
        .replace(r#""byteLength":12}"#, &format!(r#""byteLength":{}}}"#, indices.len()))
        .replace(r#""count":12"#, &format!(r#""count":{}"#, indices.len()));
    assert!(refusal(text, "i.gltf").contains("the most that is read"));
}
