//! What the shapes' documentation says, as claims.

use std::collections::{BTreeMap, BTreeSet, HashMap};

use polosa_scene::shape::{self, Solid};
use polosa_scene::subdivide::{MOST_TRIANGLES, Onto, SubdivideError, subdivide};
use polosa_scene::{Color, Colors, Corners, Mesh, Shape, ShapeError};
use proptest::prelude::*;

type V = [f64; 3];

fn at(mesh: &Mesh, index: u32) -> V {
    mesh.positions()[index as usize].map(f64::from)
}

fn add(a: V, b: V) -> V {
    [a[0] + b[0], a[1] + b[1], a[2] + b[2]]
}

fn sub(a: V, b: V) -> V {
    [a[0] - b[0], a[1] - b[1], a[2] - b[2]]
}

fn dot(a: V, b: V) -> f64 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

fn cross(a: V, b: V) -> V {
    [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
}

fn area_vector(mesh: &Mesh, [a, b, c]: [u32; 3]) -> V {
    cross(sub(at(mesh, b), at(mesh, a)), sub(at(mesh, c), at(mesh, a)))
}

/// Sides that no other triangle has the other way round, from vertex to vertex; panics if a side is there twice.
fn boundary(mesh: &Mesh) -> BTreeMap<u32, u32> {
    let mut sides = BTreeSet::new();
    for &[a, b, c] in mesh.triangles() {
        for side in [(a, b), (b, c), (c, a)] {
            assert!(sides.insert(side), "side {side:?} belongs to two triangles in the same direction");
        }
    }
    sides.iter().filter(|&&(a, b)| !sides.contains(&(b, a))).copied().collect()
}

fn loops(mut next: BTreeMap<u32, u32>) -> Vec<Vec<u32>> {
    let mut loops = Vec::new();
    while let Some((start, mut here)) = next.pop_first() {
        let mut ring = vec![start];
        while here != start {
            ring.push(here);
            here = next.remove(&here).expect("a boundary is closed");
        }
        loops.push(ring);
    }
    loops
}

/// Vertices − edges + triangles.
fn euler(mesh: &Mesh) -> i64 {
    let bare = Mesh::new(mesh.positions().to_vec(), mesh.triangles().to_vec()).unwrap();
    mesh.positions().len() as i64 - bare.edges().len() as i64 + mesh.triangles().len() as i64
}

/// Volume inside, with every opening closed by a fan around the middle of its border.
fn volume(mesh: &Mesh) -> f64 {
    let mut volume = 0.0;
    for &[a, b, c] in mesh.triangles() {
        volume += dot(at(mesh, a), cross(at(mesh, b), at(mesh, c)));
    }
    for ring in loops(boundary(mesh)) {
        let sum = ring.iter().fold([0.0; 3], |s, &v| add(s, at(mesh, v)));
        let middle = sum.map(|x| x / ring.len() as f64);
        for (i, &a) in ring.iter().enumerate() {
            let b = ring[(i + 1) % ring.len()];
            volume += dot(at(mesh, b), cross(at(mesh, a), middle));
        }
    }
    volume / 6.0
}

/// The connected parts of a mesh, in the order of their first vertices.
fn parts(mesh: &Mesh) -> Vec<Mesh> {
    fn root(of: &mut [u32], mut v: u32) -> u32 {
        while of[v as usize] != v {
            of[v as usize] = of[of[v as usize] as usize];
            v = of[v as usize];
        }
        v
    }
    let mut of: Vec<u32> = (0..mesh.positions().len() as u32).collect();
    for &[a, b, c] in mesh.triangles() {
        for other in [b, c] {
            let (r, s) = (root(&mut of, a), root(&mut of, other));
            of[r.max(s) as usize] = r.min(s);
        }
    }
    let mut by_root: BTreeMap<u32, Vec<[u32; 3]>> = BTreeMap::new();
    for &t in mesh.triangles() {
        by_root.entry(root(&mut of, t[0])).or_default().push(t);
    }
    let part = |triangles: Vec<[u32; 3]>| {
        let mut new = HashMap::new();
        let mut positions = Vec::new();
        let mut renumber = |v: u32| {
            *new.entry(v).or_insert_with(|| {
                positions.push(mesh.positions()[v as usize]);
                positions.len() as u32 - 1
            })
        };
        let triangles = triangles.into_iter().map(|t| t.map(&mut renumber)).collect();
        Mesh::new(positions, triangles).unwrap()
    };
    by_root.into_values().map(part).collect()
}

fn mesh(text: &str) -> Mesh {
    text.parse::<Shape>().unwrap().mesh().unwrap()
}

/// Name, vertices, edges, triangles, Euler characteristic.
const CLOSED: [(&str, usize, usize, usize, i64); 22] = [
    ("tetrahedron", 4, 6, 4, 2),
    ("cube", 8, 12, 12, 2),
    ("octahedron", 6, 12, 8, 2),
    ("icosahedron", 12, 30, 20, 2),
    ("pyramid", 5, 8, 6, 2),
    ("sphere:tetrahedron:0", 4, 6, 4, 2),
    ("sphere:tetrahedron:4", 514, 1536, 1024, 2),
    ("sphere:cube:3", 386, 1152, 768, 2),
    ("sphere:octahedron:5", 4098, 12_288, 8192, 2),
    ("sphere:icosahedron:3", 642, 1920, 1280, 2),
    ("sphere", 4098, 12_288, 8192, 2),
    ("sphere:1", 18, 48, 32, 2),
    ("uv-sphere:3:2", 5, 9, 6, 2),
    ("uv-sphere:64:32", 64 * 31 + 2, 64 * 63, 64 * 62, 2),
    ("uv-sphere:7:5", 7 * 4 + 2, 7 * 9, 7 * 8, 2),
    ("cylinder:3", 8, 9, 12, 2),
    ("cylinder", 98, 144, 192, 2),
    ("cone:3", 5, 6, 6, 2),
    ("cone:100", 102, 200, 200, 2),
    ("torus:3:3", 9, 18, 18, 0),
    ("torus:5:7", 35, 70, 70, 0),
    ("torus", 64 * 32, 2 * 64 * 32, 2 * 64 * 32, 0),
];

#[test]
fn closed_shapes_are_watertight_and_wound_outward() {
    for (name, vertices, edges, triangles, characteristic) in CLOSED {
        let mesh = mesh(name);
        let counts = (mesh.positions().len(), mesh.edges().len(), mesh.triangles().len());
        assert_eq!(counts, (vertices, edges, triangles), "{name}");
        assert!(boundary(&mesh).is_empty(), "{name} has openings");
        assert_eq!(euler(&mesh), characteristic, "{name}");
        assert!(volume(&mesh) > 0.0, "{name} is inside out");
        assert_eq!(parts(&mesh).len(), 1, "{name}");
    }
}

#[test]
fn every_face_of_a_convex_shape_looks_away_from_the_middle() {
    for (name, ..) in CLOSED.iter().filter(|line| !line.0.contains("torus")) {
        let mesh = mesh(name);
        for &t in mesh.triangles() {
            assert!(dot(area_vector(&mesh, t), at(&mesh, t[0])) > 0.0, "{name}: {t:?}");
        }
    }
}

#[test]
fn volumes_approach_the_textbooks() {
    let pi = core::f64::consts::PI;
    for (name, expected, error) in [
        ("cube", 8.0, 0.0),
        ("tetrahedron", 8.0 / 3.0, 1e-15),
        ("octahedron", 4.0 / 3.0, 1e-15),
        ("pyramid", 8.0 / 3.0, 1e-15),
        ("sphere:6", 4.0 / 3.0 * pi, 2e-3),
        ("uv-sphere:200:100", 4.0 / 3.0 * pi, 3e-3),
        ("cylinder:400", 2.0 * pi, 1e-3),
        ("cone:400", 2.0 / 3.0 * pi, 1e-3),
        ("torus:400:400", 2.0 * pi * pi * 0.7 * 0.09, 1e-3),
    ] {
        let volume = volume(&mesh(name));
        assert!((volume - expected).abs() <= error, "{name}: {volume}, not {expected}");
    }
}

#[test]
fn no_shape_has_a_degenerate_triangle_or_a_loose_vertex() {
    let teapots = (2..=12).map(|n| format!("teapot:{n}"));
    let names = Shape::all().iter().map(|info| info.name.to_owned()).chain(teapots);
    for name in names.chain(CLOSED.iter().map(|line| line.0.to_owned())) {
        let mesh = mesh(&name);
        let mut used = vec![false; mesh.positions().len()];
        for &t in mesh.triangles() {
            let n = area_vector(&mesh, t);
            assert!(dot(n, n) > 0.0, "{name}: {t:?}");
            for v in t {
                used[v as usize] = true;
            }
        }
        assert!(used.iter().all(|&used| used), "{name}");
    }
}

#[test]
fn shapes_fill_the_unit_box() {
    for info in Shape::all().iter().filter(|info| !["seed-tetrahedron", "teapot"].contains(&info.name)) {
        let mesh = info.default.mesh().unwrap();
        let largest = mesh.positions().as_flattened().iter().fold(0.0, |m: f32, x| m.max(x.abs()));
        assert!((0.85..=1.0).contains(&largest), "{}: {largest}", info.name);
    }
}

/// How far the triangles lie inside the unit sphere.
fn depth_below_sphere(mesh: &Mesh) -> f64 {
    let distance = |&t: &[u32; 3]| {
        let n = area_vector(mesh, t);
        dot(n, at(mesh, t[0])) / dot(n, n).sqrt()
    };
    1.0 - mesh.triangles().iter().map(distance).fold(1.0, f64::min)
}

#[test]
fn subdivided_spheres_lie_as_close_to_the_sphere_as_their_docs_say() {
    for level in 1..=6_u32 {
        for (solid, factor) in
            [(Solid::Octahedron, 1.0), (Solid::Tetrahedron, 4.0), (Solid::Icosahedron, 0.3)]
        {
            let bound = factor * 0.25_f64.powi(level as i32);
            let mesh = shape::sphere(solid, level).unwrap();
            let error = depth_below_sphere(&mesh);
            assert!(error <= bound, "{solid}:{level}: {error} > {bound}");
            // Not a bound that anything would keep.
            assert!(level < 4 || error >= 0.8 * bound, "{solid}:{level}: {error} is far below {bound}");
            for p in mesh.positions() {
                let p = p.map(f64::from);
                assert!((dot(p, p).sqrt() - 1.0).abs() < 1.1e-7);
            }
        }
    }
}

#[test]
fn edges_are_those_that_a_person_would_draw() {
    // No diagonals: each edge of these borders two faces that are not in one plane.
    for name in ["cube", "pyramid", "tetrahedron", "octahedron", "icosahedron", "cylinder:12", "cone:12"] {
        let mesh = mesh(name);
        for edge in mesh.edges().iter() {
            let borders = |t: &&[u32; 3]| t.contains(&edge[0]) && t.contains(&edge[1]);
            let normals: Vec<V> =
                mesh.triangles().iter().filter(borders).map(|&t| area_vector(&mesh, t)).collect();
            let [a, b] = normals[..] else { panic!("{name}: {edge:?} borders {} triangles", normals.len()) };
            let cos = dot(a, b) / (dot(a, a) * dot(b, b)).sqrt();
            assert!(cos < 0.99, "{name}: {edge:?}");
        }
    }
    assert_eq!(mesh("plane").edges().len(), 4);
    assert_eq!(mesh("plane:3").edges().len(), 24);
}

/// The largest angle between a face and a normal at one of its corners.
fn normals_off_faces(name: &str) -> f64 {
    let mesh = mesh(name);
    let normals = mesh.normals().unwrap_or_else(|| panic!("{name} has no normals"));
    let indices = normals.indices().unwrap_or(mesh.triangles());
    let mut worst = 1.0_f64;
    for (&t, corners) in mesh.triangles().iter().zip(indices) {
        let face = area_vector(&mesh, t);
        for &corner in corners {
            let n = normals.values()[corner as usize].map(f64::from);
            assert!((dot(n, n).sqrt() - 1.0).abs() < 1e-6, "{name}: {n:?}");
            worst = worst.min(dot(n, face) / dot(face, face).sqrt());
        }
    }
    worst.acos()
}

#[test]
fn normals_have_unit_length_and_agree_with_the_faces() {
    for (name, most) in
        [("sphere:4", 0.1), ("uv-sphere", 0.1), ("cylinder", 0.1), ("cone", 0.1), ("torus", 0.15)]
    {
        let angle = normals_off_faces(name);
        assert!(angle < most, "{name}: {angle}");
    }
    // The lip of the teapot's spout is tightly rounded: coarse faces there are far from the surface's normals. But
    // twice the segments halve the angle, which a single wrong normal would prevent.
    let angles = [30, 60, 120, 240].map(|n| normals_off_faces(&format!("teapot:{n}")));
    assert!(angles.windows(2).all(|pair| pair[1] < 0.55 * pair[0]), "{angles:?}");
    assert!(angles[3] < 0.1, "{angles:?}");
}

#[test]
fn the_teapot_is_four_parts_that_open_where_newells_do() {
    for n in [2, 5, 10, 16] {
        let teapot = shape::teapot(n).unwrap();
        let n = n as usize;
        assert_eq!(teapot.triangles().len(), 64 * n * n - 8 * n);
        let parts = parts(&teapot);
        // Pot and lid are discs, handle and spout tubes.
        let found: Vec<_> = parts
            .iter()
            .map(|part| {
                let openings: Vec<usize> = loops(boundary(part)).iter().map(Vec::len).collect();
                (euler(part), openings)
            })
            .collect();
        let expected = [(1, vec![4 * n]), (1, vec![4 * n]), (0, vec![2 * n, 2 * n]), (0, vec![2 * n, 2 * n])];
        assert_eq!(found, expected, "teapot:{n}");
        for (i, part) in parts.iter().enumerate() {
            assert!(volume(part) > 0.0, "teapot:{n}, part {i} is inside out: {}", volume(part));
        }
    }
}

#[test]
fn the_teapot_is_upright_two_high_and_symmetric() {
    let teapot = shape::teapot(12).unwrap();
    let range = |axis: usize| {
        let values = || teapot.positions().iter().map(|p| p[axis]);
        (values().fold(f32::MAX, f32::min), values().fold(f32::MIN, f32::max))
    };
    assert_eq!(range(1), (-1.0, 1.0));
    let (back, front) = range(2);
    assert_eq!(back, -front);
    // The handle on the left; the spout on the right reaches farther.
    let (handle, spout) = range(0);
    assert!(handle < -1.85 && spout > 2.1, "{handle} {spout}");
    let points: BTreeSet<[u32; 3]> = teapot.positions().iter().map(|p| p.map(f32::to_bits)).collect();
    for &[x, y, z] in teapot.positions() {
        assert!(points.contains(&[x, y, 0.0 - z].map(f32::to_bits)), "{x} {y} {z} has no mirror image");
    }
}

#[test]
fn the_seed_tetrahedron_keeps_its_colors_and_its_winding() {
    let flat = shape::seed_tetrahedron(0).unwrap();
    let inward: Vec<bool> =
        flat.triangles().iter().map(|&t| dot(area_vector(&flat, t), at(&flat, t[0])) < 0.0).collect();
    assert_eq!(inward, [true, false, true, false], "white and green inward, red and blue outward");
    assert_eq!(flat.edges().len(), 6);

    let round = shape::seed_tetrahedron(3).unwrap();
    for p in round.positions() {
        let p = p.map(f64::from);
        assert!((dot(p, p) - 30_000.0).abs() < 0.01);
    }
    // Each part is still over its face: farther from the vertex that the face lacks than from any other.
    let Colors::Face(colors) = round.colors() else { panic!("one colour a face") };
    let lacks = |color: Color| match color.to_u32() {
        0xff_ffff => 3,
        0xff_0000 => 2,
        0x00_ff00 => 1,
        0x00_00ff => 0,
        other => panic!("{other:#x}"),
    };
    let mut counts = [0; 4];
    for (&t, &color) in round.triangles().iter().zip(colors) {
        let middle = t.iter().fold([0.0; 3], |s, &v| add(s, at(&round, v)));
        let far = lacks(color);
        counts[far as usize] += 1;
        for other in (0..4).filter(|&other| other != far) {
            assert!(dot(middle, at(&flat, far)) < dot(middle, at(&flat, other)), "{t:?} {color}");
        }
    }
    assert_eq!(counts, [64; 4]);
}

#[test]
fn flat_subdivision_keeps_surface_edges_and_attributes() {
    let corners = vec![[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [1.0, 1.0, 0.0], [0.0, 1.0, 0.0]];
    let colors = [0x0, 0xff_0000, 0xff_ffff, 0xff].map(Color::from_u32).to_vec();
    let square = Mesh::new(corners, vec![[0, 1, 2], [0, 2, 3]])
        .and_then(|mesh| mesh.with_edges(vec![[0, 1], [1, 2], [2, 3], [3, 0]]))
        .and_then(|mesh| mesh.with_colors(Colors::Vertex(colors)))
        .and_then(|mesh| mesh.with_normals(Corners::indexed(vec![[0.0, 0.0, 2.0]], vec![[0; 3]; 2])))
        .and_then(|mesh| {
            mesh.with_uvs(Corners::per_vertex(vec![[0.0, 1.0], [1.0, 1.0], [1.0, 0.0], [0.0, 0.0]]))
        })
        .unwrap();
    let fine = subdivide(&square, 3, Onto::Flat).unwrap();
    assert_eq!((fine.triangles().len(), fine.positions().len(), fine.edges().len()), (128, 81, 32));
    let area: f64 = fine.triangles().iter().map(|&t| area_vector(&fine, t)[2] / 2.0).sum();
    assert_eq!(area, 1.0);
    for (p, uv) in fine.positions().iter().zip(fine.uvs().unwrap().values()) {
        assert_eq!([p[0], 1.0 - p[1]], *uv);
    }
    let Colors::Vertex(colors) = fine.colors() else { panic!("colours of vertices") };
    let middle = fine.positions().iter().position(|p| *p == [0.5, 0.0, 0.0]).unwrap();
    assert_eq!(colors[middle], Color::new(128, 0, 0));
    assert!(fine.normals().unwrap().values().iter().all(|n| *n == [0.0, 0.0, 2.0]));
    // No edge runs inside the square.
    for edge in fine.edges().iter() {
        let [a, b] = edge.map(|v| fine.positions()[v as usize]);
        assert!((0..2).any(|i| a[i] == b[i] && (a[i] == 0.0 || a[i] == 1.0)), "{a:?} {b:?}");
    }
}

#[test]
fn strange_meshes_are_subdivided_without_a_panic() {
    let strange = Mesh::new(
        vec![[f32::NAN, 0.0, 0.0], [f32::INFINITY, f32::MAX, 0.0], [0.0; 3], [f32::MAX; 3]],
        vec![[0, 1, 2], [2, 2, 2], [3, 3, 1], [2, 1, 3]],
    )
    .and_then(|mesh| mesh.with_edges(vec![[0, 0], [3, 1]]))
    .unwrap();
    for onto in [Onto::Flat, Onto::Sphere { center: [0.0; 3], radius: f64::NAN }] {
        assert_eq!(subdivide(&strange, 2, onto).unwrap().triangles().len(), 64);
    }
    assert_eq!(subdivide(&Mesh::default(), 30, Onto::Flat), Ok(Mesh::default()));
}

#[test]
fn too_many_levels_are_refused_with_advice_before_any_is_made() {
    for level in [11, 31, 32, 40, 64, u32::MAX] {
        let error = subdivide(&shape::cube(), level, Onto::Flat).unwrap_err();
        assert_eq!(error, SubdivideError::TooLarge { triangles: 12, level, most: 10 });
        assert!(error.to_string().contains("at most 10 levels"), "{error}");
    }
    for (base, most) in
        [(Solid::Tetrahedron, 11), (Solid::Cube, 10), (Solid::Octahedron, 10), (Solid::Icosahedron, 9)]
    {
        let count = |level| Shape::Sphere { base, level }.triangle_count();
        let largest = count(most).unwrap();
        assert!((MOST_TRIANGLES / 4..=MOST_TRIANGLES).contains(&largest), "{largest}");
        let error = count(most + 1).unwrap_err();
        assert!(error.to_string().contains(&format!("from 0 to {most}")), "{error}");
    }
}

#[test]
fn extreme_parameters_stay_within_the_limit_or_are_refused() {
    for info in Shape::all() {
        for numbers in ["", ":0", ":1", ":2", ":3", ":1000", ":4294967295", ":3:3", ":1000000:1000000"] {
            let text = format!("{}{numbers}", info.name);
            if let Ok(shape) = text.parse::<Shape>() {
                assert!(shape.triangle_count().unwrap() <= MOST_TRIANGLES, "{text}");
            }
        }
    }
    assert!(matches!(shape::torus(1_000_000, 1_000_000), Err(ShapeError::TooLarge { .. })));
    assert!(matches!(shape::uv_sphere(2, 9), Err(ShapeError::Range { parameter: "SEGMENTS", .. })));
    assert!(matches!(shape::teapot(1), Err(ShapeError::Range { .. })));
    assert!(matches!(shape::plane(3163), Err(ShapeError::Range { .. })));
}

#[test]
fn the_number_of_triangles_is_known_before_they_are_made() {
    for name in CLOSED.iter().map(|line| line.0).chain(["teapot:7", "plane:5", "seed-tetrahedron:2"]) {
        let shape: Shape = name.parse().unwrap();
        assert_eq!(shape.triangle_count().unwrap(), shape.mesh().unwrap().triangles().len() as u64, "{name}");
    }
}

#[test]
fn names_with_parameters_mean_what_they_say() {
    for (text, shape) in [
        ("teapot", Shape::Teapot { segments: 10 }),
        ("teapot:8", Shape::Teapot { segments: 8 }),
        ("sphere", Shape::Sphere { base: Solid::Octahedron, level: 5 }),
        ("sphere:4", Shape::Sphere { base: Solid::Octahedron, level: 4 }),
        ("sphere:tetrahedron", Shape::Sphere { base: Solid::Tetrahedron, level: 5 }),
        ("sphere:icosahedron:4", Shape::Sphere { base: Solid::Icosahedron, level: 4 }),
        ("uv-sphere:48", Shape::UvSphere { segments: 48, rings: 32 }),
        ("torus:7:9", Shape::Torus { segments: 7, sides: 9 }),
        ("cylinder:48", Shape::Cylinder { segments: 48 }),
        ("seed-tetrahedron:5", Shape::SeedTetrahedron { level: 5 }),
    ] {
        assert_eq!(text.parse(), Ok(shape), "{text}");
    }
}

#[test]
fn other_texts_are_refused_with_the_list_of_names_and_parameters() {
    for text in [
        "",
        ":",
        "ball",
        "teapot:",
        "teapot:x",
        "teapot:+8",
        "teapot:-1",
        "teapot:8:8",
        "cube:1",
        "sphere:cone:3",
        "sphere:3:cube",
        "sphere:cube:3:1",
        "torus:99999999999",
        "Teapot",
        "пирамида",
    ] {
        let error = text.parse::<Shape>().unwrap_err().to_string();
        for info in Shape::all() {
            let usage = format!("{}{}", info.name, info.parameters);
            assert!(error.contains(&usage), "{text}: {error}");
        }
        assert_eq!(error.lines().count(), 1);
    }
}

#[test]
fn the_list_names_each_shape_once_by_its_default() {
    for info in Shape::all() {
        assert_eq!(info.name.parse(), Ok(info.default));
        assert!(info.default.to_string().starts_with(info.name));
    }
}

/// All bits of all default shapes, mixed (FNV-1a), as found on x86-64. Another value elsewhere means that shapes,
/// and so pictures, differ between machines.
#[test]
fn the_same_shapes_have_the_same_bits_everywhere() {
    let mut hash = 0xcbf2_9ce4_8422_2325_u64;
    let mut mix = |bits: u32| {
        for byte in bits.to_le_bytes() {
            hash = (hash ^ u64::from(byte)).wrapping_mul(0x0100_0000_01b3);
        }
    };
    for info in Shape::all() {
        let mesh = info.default.mesh().unwrap();
        mesh.positions().as_flattened().iter().for_each(|x| mix(x.to_bits()));
        mesh.triangles().as_flattened().iter().for_each(|&i| mix(i));
        mesh.edges().as_flattened().iter().for_each(|&i| mix(i));
        let normals = mesh.normals().map_or(&[][..], Corners::values);
        normals.as_flattened().iter().for_each(|x| mix(x.to_bits()));
        assert!(info.default.mesh().unwrap() == mesh, "{} differs from call to call", info.name);
    }
    assert_eq!(hash, 0x00be_aca7_8592_0c59, "{hash:#018x}");
}

proptest! {
    #[test]
    fn any_shape_survives_its_text(
        kind in 0..Shape::all().len(),
        a in 0..12_u32,
        b in 3..40_u32,
        solid in 0..4_usize,
    ) {
        let solid = [Solid::Tetrahedron, Solid::Cube, Solid::Octahedron, Solid::Icosahedron][solid];
        let mut shape = Shape::all()[kind].default;
        match &mut shape {
            Shape::Sphere { base, level } => (*base, *level) = (solid, a),
            Shape::UvSphere { segments, rings: other } | Shape::Torus { segments, sides: other } => {
                (*segments, *other) = (b, a);
            }
            Shape::Plane { cells: n }
            | Shape::Cylinder { segments: n }
            | Shape::Cone { segments: n }
            | Shape::Teapot { segments: n }
            | Shape::SeedTetrahedron { level: n } => *n = a,
            _ => {}
        }
        prop_assert_eq!(shape.to_string().parse::<Shape>(), shape.triangle_count().map(|_| shape));
    }

    #[test]
    fn round_shapes_of_any_numbers_are_watertight(n in 3..40_u32, m in 3..40_u32) {
        for (mesh, characteristic) in [
            (shape::uv_sphere(n, m).unwrap(), 2),
            (shape::torus(n, m).unwrap(), 0),
            (shape::cylinder(n).unwrap(), 2),
            (shape::cone(n).unwrap(), 2),
        ] {
            prop_assert!(boundary(&mesh).is_empty());
            prop_assert_eq!(euler(&mesh), characteristic);
            prop_assert!(volume(&mesh) > 0.0);
        }
    }

    #[test]
    fn no_text_makes_the_parser_panic(
        text in "\\PC{0,20}",
        kind in 0..Shape::all().len(),
        tail in "[:0-9a-z+-]{0,12}",
    ) {
        let _ = text.parse::<Shape>();
        let _ = format!("{}{tail}", Shape::all()[kind].name).parse::<Shape>();
    }
}
