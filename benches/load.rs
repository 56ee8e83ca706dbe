//! The importers: a model in memory, as a file of each format, to meshes. MB/s are of the file.
//!
//! ```sh
//! cargo bench --bench load
//! ```
//!
//! The files are written here, from one mesh of 100,000 triangles; what is read must be that mesh again.

use std::hint::black_box;
use std::io::Write as _;
use std::time::Duration;

use criterion::{BenchmarkId, Criterion, Throughput, criterion_group, criterion_main};
use polosa_benches::mesh::{Mesh, dented_ball};
use polosa_scene::import;

/// Triangles of the model.
const COUNT: u32 = 100_000;

fn obj(mesh: &Mesh) -> Vec<u8> {
    let mut file = Vec::new();
    for [x, y, z] in &mesh.positions {
        writeln!(file, "v {x:.6} {y:.6} {z:.6}").expect("memory takes it");
    }
    for triangle in &mesh.triangles {
        let [a, b, c] = triangle.map(|k| k + 1);
        writeln!(file, "f {a} {b} {c}").expect("memory takes it");
    }
    file
}

fn corners<'a>(mesh: &'a Mesh) -> impl Iterator<Item = [[f32; 3]; 3]> + 'a {
    mesh.triangles.iter().map(|triangle| triangle.map(|k| mesh.positions[k as usize]))
}

fn stl_binary(mesh: &Mesh) -> Vec<u8> {
    let mut file = vec![b' '; 80];
    file.extend((mesh.triangles.len() as u32).to_le_bytes());
    for corners in corners(mesh) {
        file.extend([0; 12]);
        file.extend(corners.iter().flatten().flat_map(|x| x.to_le_bytes()));
        file.extend([0; 2]);
    }
    file
}

fn stl_text(mesh: &Mesh) -> Vec<u8> {
    let mut file = b"solid ball\n".to_vec();
    for corners in corners(mesh) {
        file.extend(b"facet normal 0 0 0\nouter loop\n");
        for [x, y, z] in corners {
            writeln!(file, "vertex {x:e} {y:e} {z:e}").expect("memory takes it");
        }
        file.extend(b"endloop\nendfacet\n");
    }
    file.extend(b"endsolid ball\n");
    file
}

fn ply_header(mesh: &Mesh, format: &str) -> Vec<u8> {
    format!(
        "ply\nformat {format} 1.0\nelement vertex {}\nproperty float x\nproperty float y\nproperty float z\n\
         element face {}\nproperty list uchar int vertex_indices\nend_header\n",
        mesh.positions.len(),
        mesh.triangles.len()
    )
    .into_bytes()
}

fn ply_binary(mesh: &Mesh) -> Vec<u8> {
    let mut file = ply_header(mesh, "binary_little_endian");
    file.extend(mesh.positions.iter().flatten().flat_map(|x| x.to_le_bytes()));
    for triangle in &mesh.triangles {
        file.push(3);
        file.extend(triangle.iter().flat_map(|k| k.to_le_bytes()));
    }
    file
}

fn ply_text(mesh: &Mesh) -> Vec<u8> {
    let mut file = ply_header(mesh, "ascii");
    for [x, y, z] in &mesh.positions {
        writeln!(file, "{x} {y} {z}").expect("memory takes it");
    }
    for [a, b, c] in &mesh.triangles {
        writeln!(file, "3 {a} {b} {c}").expect("memory takes it");
    }
    file
}

/// Binary glTF 2.0: a header, a chunk of JSON, a chunk of positions and indices.
fn glb(mesh: &Mesh) -> Vec<u8> {
    let mut data: Vec<u8> = mesh.positions.iter().flatten().flat_map(|x| x.to_le_bytes()).collect();
    let positions = data.len();
    data.extend(mesh.triangles.iter().flatten().flat_map(|k| k.to_le_bytes()));
    let (total, indices) = (data.len(), data.len() - positions);
    let mut json = format!(
        r#"{{"asset":{{"version":"2.0"}},"scene":0,"scenes":[{{"nodes":[0]}}],"nodes":[{{"mesh":0}}],
"meshes":[{{"primitives":[{{"attributes":{{"POSITION":0}},"indices":1}}]}}],"buffers":[{{"byteLength":{total}}}],
"bufferViews":[{{"buffer":0,"byteLength":{positions}}},{{"buffer":0,"byteOffset":{positions},"byteLength":{indices}}}],
"accessors":[{{"bufferView":0,"componentType":5126,"count":{},"type":"VEC3","min":[-2,-2,-2],"max":[2,2,2]}},
{{"bufferView":1,"componentType":5125,"count":{},"type":"SCALAR"}}]}}"#,
        mesh.positions.len(),
        3 * mesh.triangles.len()
    )
    .into_bytes();
    json.resize(json.len().next_multiple_of(4), b' ');
    let mut file = b"glTF".to_vec();
    let length = 12 + 8 + json.len() + 8 + data.len();
    file.extend([2, length as u32, json.len() as u32].map(u32::to_le_bytes).as_flattened());
    file.extend(b"JSON");
    file.extend(&json);
    file.extend((data.len() as u32).to_le_bytes());
    file.extend(b"BIN\0");
    file.extend(&data);
    file
}

fn load(c: &mut Criterion) {
    let mesh = dented_ball(COUNT);
    let files = [
        ("OBJ", obj(&mesh), "ball.obj"),
        ("STL binary", stl_binary(&mesh), "ball.stl"),
        ("STL text", stl_text(&mesh), "ball.stl"),
        ("PLY binary", ply_binary(&mesh), "ball.ply"),
        ("PLY text", ply_text(&mesh), "ball.ply"),
        ("glTF binary", glb(&mesh), "ball.glb"),
    ];
    for (unit, per) in [("MB per s", None), ("triangles per s", Some(mesh.triangles.len() as u64))] {
        let mut group = c.benchmark_group(unit);
        for (format, file, name) in &files {
            let model = import::read(file, name, None, None).expect("the file is right");
            assert!(same(&mesh, &model), "{format}: another mesh is read than was written");
            group.throughput(per.map_or(Throughput::BytesDecimal(file.len() as u64), Throughput::Elements));
            group.bench_function(BenchmarkId::from_parameter(format), |b| {
                b.iter(|| import::read(black_box(file), name, None, None));
            });
        }
        group.finish();
    }
}

/// Whether a model is the mesh, to the digits that OBJ was given.
fn same(mesh: &Mesh, model: &import::Model) -> bool {
    let [part] = &model.parts[..] else { return false };
    let read = &part.mesh;
    let near = |a: [f32; 3], b: [f32; 3]| a.iter().zip(b).all(|(a, b)| (a - b).abs() < 1e-6);
    read.triangles().len() == mesh.triangles.len()
        && read.triangles().iter().zip(&mesh.triangles).all(|(read_triangle, triangle)| {
            (0..3).all(|k| {
                near(read.positions()[read_triangle[k] as usize], mesh.positions[triangle[k] as usize])
            })
        })
}

fn brief() -> Criterion {
    Criterion::default()
        .warm_up_time(Duration::from_millis(300))
        .measurement_time(Duration::from_secs(1))
        .sample_size(10)
}

criterion_group! { name = benches; config = brief(); targets = load }
criterion_main!(benches);
