//! PLY.

use polosa_scene::import::SkippedKind;
use polosa_scene::topology::Topology;
use polosa_scene::{Color, Colors};

use crate::data::{self, Ply};
use crate::{model, part};

#[test]
fn the_three_encodings_are_the_same_mesh() {
    let parts = [Ply::Ascii, Ply::Little, Ply::Big].map(|encoding| part(data::ply(encoding), "t.ply"));
    for part in &parts {
        assert_eq!(part.mesh, parts[0].mesh);
    }
    let mesh = &parts[0].mesh;
    assert_eq!((mesh.positions(), mesh.triangles()), (&data::POSITIONS[..], &data::TRIANGLES[..]));
    assert_eq!(mesh.colors(), &Colors::Vertex((0..4).map(|i| Color::new(i, 20, 30)).collect()));
    assert!(Topology::of(mesh).closed_outward());
}

#[test]
fn windows_line_ends_and_blank_lines_are_read() {
    let text = String::from_utf8(data::ply(Ply::Ascii)).unwrap();
    let text = text.replace("end_header\n", "end_header\n\n").replace('\n', "\r\n");
    assert_eq!(part(text, "t.ply").mesh, part(data::ply(Ply::Ascii), "t.ply").mesh);
}

#[test]
fn polygons_keep_their_sides_and_face_colors_go_to_their_triangles() {
    let text = "ply\nformat ascii 1.0\nelement vertex 5\nproperty float x\nproperty float y\nproperty float z\n\
        element face 3\nproperty list uchar uint vertex_index\nproperty uchar red\nproperty uchar green\n\
        property uchar blue\nend_header\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n2 0 0\n4 0 1 2 3 255 0 0\n2 0 1 9 9 9\n\
        3 1 4 2 0 0 255\n";
    let model = model(text, "p.ply");
    let mesh = &model.parts[0].mesh;
    assert_eq!(mesh.triangles(), [[0, 1, 2], [0, 2, 3], [1, 4, 2]]);
    assert_eq!(*mesh.edges(), [[0, 1], [0, 3], [1, 2], [1, 4], [2, 3], [2, 4]]);
    let (red, blue) = (Color::new(255, 0, 0), Color::new(0, 0, 255));
    assert_eq!(mesh.colors(), &Colors::Face(vec![red, red, blue]));
    assert_eq!(model.skipped.count(SkippedKind::ShortFaces), 1);
    assert_eq!(model.skipped.items()[0].first.unwrap().to_string(), "line 19");
}

#[test]
fn normals_texture_coordinates_and_unknown_properties_are_sorted_out() {
    let text = "ply\nformat ascii 1.0\nelement camera 1\nproperty list int float view\nproperty float f\n\
        element vertex 3\nproperty float nx\nproperty float ny\nproperty float nz\nproperty short x\nproperty int y\n\
        property float z\nproperty float s\nproperty float t\nproperty float quality\nproperty float red\n\
        property float green\nproperty float blue\nelement face 1\nproperty list int short vertex_indices\n\
        property list uchar float texcoord\nend_header\n2 0.5 0.5 1\n\
        0 0 1 0 0 0 0 1 7 1 0.5 0\n0 0 1 1 0 0 1 1 7 1 0.5 0\n0 0 1 0 1 0 0 0.25 7 1 0.5 1\n3 0 1 2 2 0 0\n";
    let mesh = part(text, "n.ply").mesh;
    assert_eq!(mesh.positions(), [[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]]);
    assert_eq!(mesh.normals().unwrap().values(), [[0.0, 0.0, 1.0]; 3]);
    assert_eq!(mesh.uvs().unwrap().values(), [[0.0, 0.0], [1.0, 0.0], [0.0, 0.75]]);
    let Colors::Vertex(colors) = mesh.colors() else { panic!() };
    assert_eq!(colors[2], Color::new(255, 128, 255));
}

#[test]
fn triangle_strips_turn_every_second_triangle_and_restart() {
    let text = "ply\nformat ascii 1.0\nelement vertex 5\nproperty float x\nproperty float y\nproperty float z\n\
        element tristrips 1\nproperty list int int vertex_indices\nend_header\n0 0 0\n1 0 0\n0 1 0\n1 1 0\n0 2 0\n\
        9 0 1 2 3 -1 2 3 4 0\n";
    assert_eq!(part(text, "s.ply").mesh.triangles(), [[0, 1, 2], [2, 1, 3], [2, 3, 4], [4, 3, 0]]);
}
