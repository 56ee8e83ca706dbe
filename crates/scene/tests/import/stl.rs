//! STL.

use polosa_scene::import::{Format, SkippedKind};
use polosa_scene::topology::Topology;

use crate::{data, model, part};

/// The order in which the tetrahedron's triangles first use its corners.
const ORDER: [usize; 4] = [0, 2, 1, 3];

#[test]
fn ascii_and_binary_are_the_same_closed_solid() {
    let ascii = part(data::stl_ascii(), "a.stl");
    let binary = part(data::stl_binary(b"anything"), "b.stl");
    assert_eq!(ascii.mesh, binary.mesh);
    assert_eq!(ascii.mesh.positions(), ORDER.map(|i| data::POSITIONS[i]));
    assert_eq!(ascii.mesh.triangles(), [[0, 1, 2], [0, 2, 3], [2, 1, 3], [1, 0, 3]]);
    assert_eq!((ascii.name.as_str(), binary.name.as_str()), ("tetra hedron", "b"));
    assert!(Topology::of(&ascii.mesh).closed_outward());
}

#[test]
fn a_binary_header_may_begin_with_solid() {
    let model = model(data::stl_binary(b"solid facet normal 0 0 1"), "s.stl");
    assert_eq!(model.format, Format::Stl);
    assert_eq!(model.parts[0].mesh.triangles().len(), 4);
}

#[test]
fn both_zeros_are_one_vertex() {
    let mut bytes = data::stl_binary(b"");
    for at in (84..bytes.len()).step_by(50) {
        for corner in 0..3 {
            // Every second corner's zeros are negative.
            for axis in 0..3 {
                let at = at + 12 + 12 * corner + 4 * axis;
                if bytes[at..at + 4] == [0; 4] && (at / 12) % 2 == 0 {
                    bytes[at + 3] = 0x80;
                }
            }
        }
    }
    assert_ne!(bytes, data::stl_binary(b""));
    assert_eq!(part(bytes, "z.stl").mesh, part(data::stl_binary(b""), "z.stl").mesh);
}

#[test]
fn each_solid_is_a_part() {
    let two =
        data::stl_ascii() + "\n" + &data::stl_ascii().replace("tetra hedron", "SECOND") + "solid\nendsolid\n";
    let model = model(two, "two.stl");
    let names: Vec<&str> = model.parts.iter().map(|part| part.name.as_str()).collect();
    assert_eq!(names, ["tetra hedron", "SECOND"]);
    assert!(model.parts.iter().all(|part| Topology::of(&part.mesh).watertight), "not welded to one another");
    assert_eq!(model.skipped.count(SkippedKind::EmptyParts), 1);
}

#[test]
fn capitals_and_odd_ends_of_lines_are_read() {
    let text = data::stl_ascii().to_uppercase().replace("NAN", "nan").replace('\n', "\r\n");
    assert_eq!(part(text, "A.STL").mesh, part(data::stl_ascii(), "a.stl").mesh);
}

#[test]
fn a_missing_endsolid_is_noted() {
    let text = data::stl_ascii().replace("endsolid tetra hedron\n", "");
    let model = model(text, "m.stl");
    assert!(model.notes[0].contains("endsolid"));
    assert!(model.notes[0].ends_with("may be cut off; 4 triangles were read"), "{:?}", model.notes);
    assert_eq!(model.parts[0].mesh.triangles().len(), 4);
}

#[test]
fn four_vertices_make_a_quad_and_two_are_skipped() {
    let facet = |vertices: &str| format!("facet normal 0 0 0\nouter loop\n{vertices}endloop\nendfacet\n");
    let quad = facet("vertex 0 0 0\nvertex 1 0 0\nvertex 1 1 0\nvertex 0 1 0\n");
    let line = facet("vertex 0 0 0\nvertex 1 0 0\n");
    let model = model(format!("solid\n{quad}{line}endsolid\n"), "q.stl");
    assert_eq!(model.parts[0].mesh.triangles(), [[0, 1, 2], [0, 2, 3]]);
    assert_eq!(model.parts[0].mesh.edges().len(), 4);
    assert_eq!(model.skipped.items()[0].first.unwrap().to_string(), "line 10");
}

#[test]
fn a_count_that_streaming_programs_leave_is_replaced_and_noted() {
    for count in [0, u32::MAX] {
        let mut bytes = data::stl_binary(b"streamed");
        bytes[80..84].copy_from_slice(&count.to_le_bytes());
        let model = model(bytes, "s.stl");
        assert_eq!(model.parts[0].mesh.triangles().len(), 4);
        assert!(model.notes[0].contains("the file holds 4"), "{:?}", model.notes);
    }
}

#[test]
fn bytes_after_the_last_triangle_are_noted() {
    let mut bytes = data::stl_binary(b"more");
    bytes.extend([7; 30]);
    assert!(model(bytes, "m.stl").notes[0].starts_with("ignored: 30 bytes"));
}
