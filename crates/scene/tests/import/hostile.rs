//! Files that were changed, cut, or never were files: an error or a model, never a panic, never wild memory.

use polosa_scene::import::{Format, read};
use proptest::prelude::*;

use crate::data::{self, Ply};

fn seeds() -> Vec<Vec<u8>> {
    let nodes = r#"[{"children":[1]},{"mesh":0,"rotation":[0,0,0.6,0.8]}]"#;
    vec![
        data::obj().into_bytes(),
        b"mtllib a.mtl\nv 0 0 0 1 0 0\nv 1 0 0\nv 1 1 0\nv 0.2 0.1 0\nv 0 1 0\nvt 0 0\nvn 0 0 1\no a\nusemtl m\n\
            f 1/1/1 2/1 3//1 4 -1\no b\nf 1 2 \\\n3\nl 1 2\n"
            .to_vec(),
        data::stl_ascii().into_bytes(),
        data::stl_binary(b"solid"),
        data::ply(Ply::Ascii),
        data::ply(Ply::Little),
        data::ply(Ply::Big),
        data::gltf_embedded(nodes, "").into_bytes(),
        data::glb(nodes),
    ]
}

/// Reads some bytes as every format. What is read must be a mesh that keeps the mesh's promises, by type; the rest
/// is one line.
fn try_all(bytes: &[u8]) {
    for format in [None, Some(Format::Obj), Some(Format::Stl), Some(Format::Ply), Some(Format::Gltf)] {
        match read(bytes, "hostile", format, None) {
            Ok(model) => {
                assert!(model.parts.iter().all(|part| !part.mesh.triangles().is_empty()));
                let _ = polosa_scene::topology::Topology::of(&model.parts[0].mesh);
            }
            Err(error) => {
                let line = error.to_string();
                assert!(!line.contains('\n') && line.len() < 500, "{line}");
                assert!(!line.contains("the reader stopped"), "a panic was caught: {line}");
            }
        }
    }
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(1000))]

    #[test]
    fn changed_bytes_do_no_harm(
        seed in 0_usize..9,
        changes in proptest::collection::vec((any::<prop::sample::Index>(), any::<u8>()), 1..8),
    ) {
        let mut bytes = seeds().swap_remove(seed);
        for (at, byte) in changes {
            let at = at.index(bytes.len());
            bytes[at] = byte;
        }
        try_all(&bytes);
    }

    #[test]
    fn cut_joined_and_repeated_pieces_do_no_harm(
        seed in 0_usize..9,
        pieces in proptest::collection::vec((any::<prop::sample::Index>(), any::<prop::sample::Index>()), 1..5),
    ) {
        let whole = seeds().swap_remove(seed);
        let mut bytes = Vec::new();
        for (a, b) in pieces {
            let (a, b) = (a.index(whole.len()), b.index(whole.len() + 1));
            bytes.extend(&whole[a.min(b)..a.max(b)]);
        }
        try_all(&bytes);
    }

    #[test]
    fn changed_digits_do_no_harm(
        seed in 0_usize..9,
        changes in proptest::collection::vec((any::<prop::sample::Index>(), "-?[0-9]{1,20}"), 1..4),
    ) {
        let mut bytes = seeds().swap_remove(seed);
        for (at, number) in changes {
            let digits: Vec<usize> = (0..bytes.len()).filter(|&i| bytes[i].is_ascii_digit()).collect();
            if !digits.is_empty() {
                let at = digits[at.index(digits.len())];
                bytes.splice(at..=at, number.bytes());
            }
        }
        try_all(&bytes);
    }

    #[test]
    fn random_bytes_do_no_harm(
        start in prop::sample::select(vec![
            &b""[..], b"ply\nformat binary_little_endian 1.0\n", b"solid ", b"glTF\x02\0\0\0", b"{\"asset\":", b"f ", b"v 1 ",
        ]),
        rest in proptest::collection::vec(any::<u8>(), 0..300),
    ) {
        try_all(&[start, &rest].concat());
    }
}

#[cfg(target_os = "linux")]
#[test]
fn headers_that_promise_gigabytes_cost_none() {
    fn peak_kib() -> u64 {
        let status = std::fs::read_to_string("/proc/self/status").unwrap();
        let line = status.lines().find(|line| line.starts_with("VmHWM:")).unwrap();
        line.split_whitespace().nth(1).unwrap().parse().unwrap()
    }
    let before = peak_kib();
    let huge = "4294967295";
    for encoding in ["ascii", "binary_little_endian", "binary_big_endian"] {
        for (vertices, faces) in [(huge, "1"), ("1", huge), ("18446744073709551615", huge)] {
            let text = format!(
                "ply\nformat {encoding} 1.0\nelement vertex {vertices}\nproperty float x\nproperty float y\n\
                 property float z\nelement face {faces}\nproperty list uint int vertex_indices\nelement none {huge}\n\
                 end_header\n0 0 0\n\u{7f}\u{7f}\u{7f}\u{7f}\u{7f}\u{7f}\u{7f}\u{7f}\u{7f}\u{7f}\u{7f}\u{7f}"
            );
            assert!(read(text.as_bytes(), "h.ply", None, None).is_err());
        }
    }
    let mut stl = vec![b' '; 84];
    stl[80..].copy_from_slice(&[0xf0, 0xff, 0xff, 0xff]);
    assert!(read(&stl, "h.stl", None, None).is_err());
    let gltf = data::gltf_embedded(r#"[{"mesh":0}]"#, "");
    for (from, to) in [
        (r#""count":4"#, r#""count":4294967295"#),
        (
            r#""bufferView":0,"componentType":5126,"count":4"#,
            r#""sparse":{"count":1,"indices":{"bufferView":1,"componentType":5121},"values":{"bufferView":0}},"componentType":5126,"count":4294967295"#,
        ),
    ] {
        assert!(gltf.contains(from));
        assert!(read(gltf.replacen(from, to, 1).as_bytes(), "h.gltf", None, None).is_err());
    }
    // Other tests run beside this one; they need little, and a lie believed would cost gigabytes.
    assert!(peak_kib() - before < 512 * 1024);
}
