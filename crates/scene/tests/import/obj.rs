//! OBJ.

use polosa_scene::import::{Format, SkippedKind, load};
use polosa_scene::topology::Topology;
use polosa_scene::{Color, Colors};

use crate::{data, model, part};

#[test]
fn a_tetrahedron_arrives_as_it_is_written() {
    let model = model(data::obj(), "dir/tetra.obj");
    assert_eq!(model.format, Format::Obj);
    assert!(model.skipped.is_empty() && model.notes.is_empty());
    let part = &model.parts[0];
    assert_eq!(part.name, "tetra");
    assert_eq!(part.mesh.positions(), data::POSITIONS);
    assert_eq!(part.mesh.triangles(), data::TRIANGLES);
    assert!(!part.mesh.has_own_edges(), "triangles have no edges of their own");
    assert_eq!((part.color, part.mesh.colors()), (None, &Colors::None));
    assert!(Topology::of(&part.mesh).closed_outward());
}

#[test]
fn a_quad_keeps_its_four_sides_as_edges() {
    let part = part("v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 2 0 0\nf 2 5 3\nf 1 2 3 4\n", "q.obj");
    assert_eq!(part.mesh.triangles(), [[1, 4, 2], [0, 1, 2], [0, 2, 3]]);
    assert_eq!(*part.mesh.edges(), [[0, 1], [0, 3], [1, 2], [1, 4], [2, 3], [2, 4]]);
}

#[test]
fn negative_indices_count_back_from_the_face() {
    let text = "v 9 9 9\nv 0 0 0\nv 1 0 0\nv 0 1 0\nf -3 -2 -1\nv 5 5 5\nf -1 -3 -2\nf 1 2 3\n";
    assert_eq!(part(text, "n.obj").mesh.triangles(), [[1, 2, 3], [4, 2, 3], [0, 1, 2]]);
}

#[test]
fn faces_may_come_before_their_vertices() {
    let text = "v 0 0 0\nf 1 2 3 4\nf -1 2 3\nv 1 0 0\nv 1 1 0\nv 0 1 0\nl 1 2\n";
    let model = model(text, "f.obj");
    assert_eq!(model.parts[0].mesh.triangles(), [[0, 1, 2], [0, 2, 3], [0, 1, 2]]);
    assert_eq!(model.skipped.count(SkippedKind::LinesAndPoints), 1, "counted once, not once a pass");
}

#[test]
fn comments_continuations_blanks_and_line_ends_are_read() {
    let text = "\u{feff}# c\r\n\r\n  v 0 0 0 # origin\r\nv\t1 \\\r\n 0 0\r\nv 0 1 0\r\ng a b\r\ns off\r\nf 1 2 \\\r\n3\r\n";
    // The remark after the coordinates is words that are no numbers; OBJ has comments on lines of their own only.
    assert!(crate::refusal(text, "c.obj").contains("line 3: `#` is not a number"));
    let part = part(text.replace(" # origin", ""), "c.obj");
    assert_eq!(part.mesh.triangles(), [[0, 1, 2]]);
    assert_eq!(part.mesh.positions()[1], [1.0, 0.0, 0.0]);
}

#[test]
fn normals_and_texture_coordinates_keep_indices_of_their_own() {
    let text = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nvn 0 0 1\nvn 1 0 0\nvt 0.25 0.75\nvt 0.5\n\
        f 1/1/1 2/2/1 3/1/1\nf 1//2 3//2 4//2\nf 2/1 3/2 4/1\n";
    let mesh = part(text, "vn.obj").mesh;
    assert_eq!(mesh.positions().len(), 4, "positions stay shared");
    let normals = mesh.normals().unwrap();
    assert_eq!(normals.indices().unwrap(), [[0, 0, 0], [1, 1, 1], [2, 2, 2]]);
    assert_eq!(normals.values()[2], [0.0; 3], "the third face has no normal");
    let uvs = mesh.uvs().unwrap();
    assert_eq!(uvs.indices().unwrap(), [[0, 1, 0], [2, 2, 2], [0, 1, 0]]);
    assert_eq!(uvs.values(), [[0.25, 0.25], [0.5, 1.0], [0.0, 0.0]], "v runs down from the top edge");
}

#[test]
fn normals_that_go_with_the_positions_need_no_indices() {
    let text = "v 0 0 0\nv 1 0 0\nv 0 1 0\nvn 0 0 1\nvn 0 1 0\nvn 1 0 0\nf 1//1 2//2 3//3\n";
    assert!(part(text, "vn.obj").mesh.normals().unwrap().indices().is_none());
}

#[test]
fn vertex_colors_are_codes_of_either_range() {
    let text = |c: &str| format!("v 0 0 0 {c}\nv 1 0 0 {c}\nv 0 1 0\nf 1 2 3\n");
    let colors = |c: &str| part(text(c), "c.obj").mesh.colors().clone();
    let with = |color: Color| Colors::Vertex(vec![color, color, Color::LIGHT_GREY]);
    assert_eq!(colors("1 0.5 0"), with(Color::new(255, 128, 0)));
    assert_eq!(colors("255 51 0"), with(Color::new(255, 51, 0)));
    assert_eq!(colors("1.0"), Colors::None, "a weight is no colour");
}

#[test]
fn objects_become_parts_with_vertices_of_their_own() {
    let text = "v 0 0 0\nv 1 0 0\nv 0 1 0\no one\nf 1 2 3\no empty\no two x\nv 5 0 0\nv 6 0 0\nv 5 1 0\nv 6 1 0\n\
        v 7 7 7\nf 4 5 7 6\nf 2 5 7\n";
    let model = model(text, "o.obj");
    let names: Vec<&str> = model.parts.iter().map(|part| part.name.as_str()).collect();
    assert_eq!(names, ["one", "two x"]);
    let (one, two) = (&model.parts[0].mesh, &model.parts[1].mesh);
    assert_eq!(one.triangles(), [[0, 1, 2]]);
    assert!(!one.has_own_edges());
    assert_eq!(
        two.positions(),
        [[5.0, 0.0, 0.0], [6.0, 0.0, 0.0], [6.0, 1.0, 0.0], [5.0, 1.0, 0.0], [1.0, 0.0, 0.0]]
    );
    assert_eq!(two.triangles(), [[0, 1, 2], [0, 2, 3], [4, 1, 2]]);
    assert_eq!(*two.edges(), [[0, 1], [0, 3], [1, 2], [1, 4], [2, 3], [2, 4]]);
    assert_eq!(model.skipped.count(SkippedKind::UnusedVertices), 1);
    assert_eq!(model.skipped.count(SkippedKind::EmptyParts), 1);
}

#[test]
fn materials_color_faces_or_the_whole_object() {
    let folder = tempfile::tempdir().unwrap();
    let file = |name: &str, text: &str| std::fs::write(folder.path().join(name), text).unwrap();
    file("a.mtl", "newmtl red\nKd 1 0 0\nnewmtl half\nKd 0.5 0.5 0.5\nnewmtl bare\nKs 1 1 1\n");
    let vertices = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 1 1 0\n";
    file(
        "a.obj",
        &format!(
            "mtllib a.mtl\n{vertices}o p\nf 1 2 3\nusemtl red\nf 1 2 4 3\nusemtl half\nf 1 2 3\nusemtl bare\nf 1 2 3\n\
             o q\nusemtl red\nf 1 2 3\nf 2 4 3\no r\nf 1 2 3\n"
        ),
    );
    let model = load(&folder.path().join("a.obj")).unwrap();
    assert!(model.notes.is_empty(), "{:?}", model.notes);
    let (red, half, grey) = (Color::new(255, 0, 0), Color::new(128, 128, 128), Color::LIGHT_GREY);
    let [p, q, r] = &model.parts[..] else { panic!() };
    assert_eq!(p.mesh.colors(), &Colors::Face(vec![grey, red, red, half, grey]));
    assert_eq!((p.color, p.materials.join(",").as_str()), (None, "red,half,bare"));
    for part in [q, r] {
        assert_eq!((part.color, part.materials.join(",").as_str()), (Some(red), "red"));
        assert_eq!(part.mesh.colors(), &Colors::None);
    }
}

#[test]
fn material_files_are_read_from_the_own_folder_only() {
    let folder = tempfile::tempdir().unwrap();
    let inner = folder.path().join("inner");
    std::fs::create_dir(&inner).unwrap();
    std::fs::write(folder.path().join("up.mtl"), "newmtl m\nKd 1 0 0\n").unwrap();
    for (name, what) in [
        ("../up.mtl", "own folder"),
        ("/etc/passwd", "own folder"),
        ("gone.mtl", "missing"),
        ("..\\up.mtl", "own folder"),
    ] {
        let text = format!("mtllib {name}\nv 0 0 0\nv 1 0 0\nv 0 1 0\nusemtl m\nf 1 2 3\n");
        std::fs::write(inner.join("a.obj"), text).unwrap();
        let model = load(&inner.join("a.obj")).unwrap();
        assert_eq!(model.parts[0].color, None);
        assert_eq!(model.parts[0].materials, ["m"]);
        assert!(model.notes.len() == 1 && model.notes[0].contains(what), "{:?}", model.notes);
    }
    #[cfg(unix)]
    {
        std::os::unix::fs::symlink(folder.path().join("up.mtl"), inner.join("link.mtl")).unwrap();
        std::fs::write(inner.join("a.obj"), "mtllib link.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n").unwrap();
        assert!(load(&inner.join("a.obj")).unwrap().notes[0].contains("own folder"));
    }
}

#[test]
fn faults_of_materials_are_noted_with_their_place() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("a.obj");
    std::fs::write(folder.path().join("a.mtl"), "newmtl red\nKd 2 -1 nan\n").unwrap();
    let notes = |head: &str| {
        let text = format!("{head}v 0 0 0\nv 1 0 0\nv 0 1 0\nusemtl red\nf 1 2 3\nusemtl gone\nf 1 2 3\n");
        std::fs::write(&path, text).unwrap();
        load(&path).unwrap().notes
    };
    let found = notes("mtllib a.mtl\n");
    assert_eq!(found.len(), 2, "{found:?}");
    assert!(found[0].starts_with("a.mtl: line 2: `Kd 2 -1 nan`"), "{found:?}");
    assert!(found[1].starts_with("line 7: the material `gone` is in no MTL file"), "{found:?}");
    let found = notes("");
    assert!(found.len() == 1 && found[0].starts_with("line 4: ") && found[0].contains("mtllib"), "{found:?}");
    let found = notes("mtllib b.mtl\n");
    assert!(found.len() == 1 && found[0].contains("missing"), "said once: {found:?}");
}

#[test]
fn a_file_cannot_ask_for_notes_without_end() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("a.obj");
    let statements: String = (0..1000).map(|i| format!("usemtl {i}\nf 1 2 3\n")).collect();
    std::fs::write(&path, format!("mtllib a.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\n{statements}")).unwrap();
    std::fs::write(folder.path().join("a.mtl"), "newmtl a\nKd 9\n".repeat(1000)).unwrap();
    let model = load(&path).unwrap();
    assert_eq!((model.notes.len(), model.parts[0].materials.len()), (16, 1000));
}

#[test]
fn what_is_no_surface_is_skipped_and_counted() {
    let text =
        "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 3 3 3\nl 1 2\np 1\nf 1 2\nf 1\ncurv 0 1 1 2\nwhat\nf 1 2 3\nf 1 1 2\n";
    let model = model(text, "s.obj");
    for (kind, count) in [
        (SkippedKind::LinesAndPoints, 2),
        (SkippedKind::ShortFaces, 2),
        (SkippedKind::FreeForm, 1),
        (SkippedKind::UnknownStatements, 1),
        (SkippedKind::UnusedVertices, 1),
    ] {
        assert_eq!(model.skipped.count(kind), count, "{kind:?}");
    }
    assert_eq!(model.skipped.items()[1].first.unwrap().to_string(), "line 7");
    assert_eq!(
        model.parts[0].mesh.triangles(),
        [[0, 1, 2], [0, 0, 1]],
        "degenerate triangles keep their number"
    );
}

#[test]
fn coordinates_that_are_not_finite_are_kept() {
    let mesh = part("v nan 0 0\nv 1 -inf 0\nv 0 1e99 -1.#IND\nf 1 2 3\n", "n.obj").mesh;
    assert!(mesh.positions()[0][0].is_nan() && mesh.positions()[2][2].is_nan());
    assert_eq!((mesh.positions()[1][1], mesh.positions()[2][1]), (f32::NEG_INFINITY, f32::INFINITY));
}
