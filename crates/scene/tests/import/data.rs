//! Small files, made here.

/// A tetrahedron, closed, counter-clockwise seen from outside.
pub(crate) const POSITIONS: [[f32; 3]; 4] =
    [[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];
pub(crate) const TRIANGLES: [[u32; 3]; 4] = [[0, 2, 1], [0, 1, 3], [1, 2, 3], [2, 0, 3]];

pub(crate) fn obj() -> String {
    let mut text = String::from("# tetrahedron\n");
    for [x, y, z] in POSITIONS {
        text += &format!("v {x} {y} {z}\n");
    }
    for [a, b, c] in TRIANGLES.map(|t| t.map(|i| i + 1)) {
        text += &format!("f {a} {b} {c}\n");
    }
    text
}

pub(crate) fn stl_ascii() -> String {
    let mut text = String::from("solid tetra hedron\n");
    for triangle in TRIANGLES {
        text += "  facet normal NaN 0 0\n    outer loop\n";
        for [x, y, z] in triangle.map(|i| POSITIONS[i as usize]) {
            text += &format!("      vertex {x:e} {y} {z}\n");
        }
        text += "    endloop\n  endfacet\n";
    }
    text + "endsolid tetra hedron\n"
}

pub(crate) fn stl_binary(header: &[u8]) -> Vec<u8> {
    let mut bytes = vec![0; 80];
    bytes[..header.len()].copy_from_slice(header);
    bytes.extend(4_u32.to_le_bytes());
    for triangle in TRIANGLES {
        bytes.extend([0; 12]);
        for coordinate in triangle.map(|i| POSITIONS[i as usize]).as_flattened() {
            bytes.extend(coordinate.to_le_bytes());
        }
        bytes.extend([0; 2]);
    }
    bytes
}

/// How a PLY file is encoded.
#[derive(Clone, Copy, Debug)]
pub(crate) enum Ply {
    Ascii,
    Little,
    Big,
}

/// The tetrahedron with a colour for each vertex.
pub(crate) fn ply(encoding: Ply) -> Vec<u8> {
    let format = match encoding {
        Ply::Ascii => "ascii",
        Ply::Little => "binary_little_endian",
        Ply::Big => "binary_big_endian",
    };
    let mut bytes = format!(
        "ply\nformat {format} 1.0\ncomment made by a test\nelement vertex 4\nproperty float x\nproperty float y\n\
         property double z\nproperty uchar red\nproperty uchar green\nproperty uchar blue\nelement face 4\n\
         property list uchar int vertex_indices\nend_header\n"
    )
    .into_bytes();
    for (i, [x, y, z]) in (0_u8..).zip(POSITIONS) {
        match encoding {
            Ply::Ascii => bytes.extend(format!("{x} {y} {z} {i} 20 30\n").bytes()),
            Ply::Little => {
                bytes.extend([x.to_le_bytes(), y.to_le_bytes()].as_flattened());
                bytes.extend(f64::from(z).to_le_bytes());
                bytes.extend([i, 20, 30]);
            }
            Ply::Big => {
                bytes.extend([x.to_be_bytes(), y.to_be_bytes()].as_flattened());
                bytes.extend(f64::from(z).to_be_bytes());
                bytes.extend([i, 20, 30]);
            }
        }
    }
    for triangle in TRIANGLES {
        match encoding {
            Ply::Ascii => {
                let [a, b, c] = triangle;
                bytes.extend(format!("3 {a} {b} {c}\n").bytes());
            }
            Ply::Little => {
                bytes.push(3);
                bytes.extend(triangle.map(u32::to_le_bytes).as_flattened());
            }
            Ply::Big => {
                bytes.push(3);
                bytes.extend(triangle.map(u32::to_be_bytes).as_flattened());
            }
        }
    }
    bytes
}

/// Positions (48 bytes), then indices as bytes (12).
pub(crate) fn gltf_buffer() -> Vec<u8> {
    let mut bytes: Vec<u8> = POSITIONS.as_flattened().iter().flat_map(|c| c.to_le_bytes()).collect();
    bytes.extend(TRIANGLES.as_flattened().iter().map(|&i| u8::try_from(i).unwrap()));
    bytes
}

/// A glTF text over one buffer of `length` bytes from `uri`, with more members at the top level.
pub(crate) fn gltf_text(uri: Option<&str>, length: usize, nodes: &str, more: &str) -> String {
    let uri = uri.map(|uri| format!("\"uri\":\"{uri}\",")).unwrap_or_default();
    format!(
        r#"{{"asset":{{"version":"2.0"}},"scene":0,"scenes":[{{"nodes":[0]}}],"nodes":{nodes},
        "meshes":[{{"name":"tetra","primitives":[{{"attributes":{{"POSITION":0}},"indices":1,"material":0}}]}}],
        "materials":[{{"name":"m","pbrMetallicRoughness":{{"baseColorFactor":[1,0.5,0,1]}}}}],
        "buffers":[{{{uri}"byteLength":{length}}}],
        "bufferViews":[{{"buffer":0,"byteLength":48}},{{"buffer":0,"byteOffset":48,"byteLength":12}}],
        "accessors":[{{"bufferView":0,"componentType":5126,"count":4,"type":"VEC3","min":[0,0,0],"max":[1,1,1]}},
        {{"bufferView":1,"componentType":5121,"count":12,"type":"SCALAR"}}]{more}}}"#
    )
}

/// What `base64` would say, in a line of its own.
pub(crate) fn base64(bytes: &[u8]) -> String {
    const ALPHABET: &[u8; 64] = b"ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    let mut text = String::new();
    for chunk in bytes.chunks(3) {
        let word =
            chunk.iter().fold(0_u32, |word, &byte| word << 8 | u32::from(byte)) << (8 * (3 - chunk.len()));
        for digit in 0..4 {
            let sextet = (word >> (18 - 6 * digit) & 63) as usize;
            text.push(if digit <= chunk.len() { char::from(ALPHABET[sextet]) } else { '=' });
        }
    }
    text
}

pub(crate) fn gltf_embedded(nodes: &str, more: &str) -> String {
    let uri = format!("data:application/octet-stream;base64,{}", base64(&gltf_buffer()));
    gltf_text(Some(&uri), 60, nodes, more)
}

pub(crate) fn glb(nodes: &str) -> Vec<u8> {
    let mut json = gltf_text(None, 60, nodes, "").into_bytes();
    json.resize(json.len().next_multiple_of(4), b' ');
    let buffer = gltf_buffer();
    let mut bytes = b"glTF".to_vec();
    let length = 12 + 8 + json.len() + 8 + buffer.len();
    for word in [2, u32::try_from(length).unwrap(), u32::try_from(json.len()).unwrap()] {
        bytes.extend(word.to_le_bytes());
    }
    bytes.extend(b"JSON");
    bytes.extend(json);
    bytes.extend(u32::try_from(buffer.len()).unwrap().to_le_bytes());
    bytes.extend(b"BIN\0");
    bytes.extend(buffer);
    bytes
}
