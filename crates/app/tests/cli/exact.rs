//! What is promised to the last bit.

use image::Rgba;

use crate::support::{BACKGROUND, Folder, SQUARE, count, extent, pfm, rgb};

/// One world unit is one pixel, and the world's (0, 0) is the picture's middle.
const TO_SCALE: &str = "--camera-orthographic --camera-height 256 --resolution 256,256 --shading unlit";

#[test]
fn a_unit_is_a_pixel_and_the_origin_is_the_middle() {
    let folder = Folder::new().with("square.obj", SQUARE);
    let picture = folder.render(&format!("square.obj {TO_SCALE}"));
    assert_eq!(extent(&picture, BACKGROUND), Some([128, 123, 137, 127]));
    assert_eq!(count(&picture, rgb(0xcc, 0xcc, 0xcc)), 50);
}

#[test]
fn the_same_holds_for_stl_and_beside_the_square_picture() {
    let stl = "solid s\nfacet normal 0 0 1\nouter loop\nvertex 0 0 2\nvertex 20 0 2\nvertex 0 20 2\nendloop\nendfacet\nendsolid s\n";
    let folder = Folder::new().with("s.stl", stl);
    let picture =
        folder.render("s.stl --camera-orthographic --camera-height 100 --resolution 300,100 --shading unlit");
    // Pixel centres on the slanted side are not the triangle's: it is a right side.
    assert_eq!(count(&picture, rgb(0xcc, 0xcc, 0xcc)), 20 * 19 / 2);
    assert_eq!(extent(&picture, BACKGROUND), Some([150, 31, 168, 49]));
}

#[test]
fn unlit_material_colors_are_the_files_codes() {
    let model =
        "mtllib m.mtl\nusemtl a\nv 0 0 0\nv 10 0 0\nv 10 10 0\nv 0 10 0\nf 1 2 3\nusemtl b\nf 1 3 4\n";
    let folder = Folder::new()
        .with("m.obj", model)
        .with("m.mtl", "newmtl a\nKd 0.2 0.4 0.6\nnewmtl b\nKd 1 0.5 0.001\n");
    let picture = folder.render(&format!("m.obj {TO_SCALE}"));
    // 0.5 · 255 = 127.5, rounded to 128.
    let (a, b) = (count(&picture, rgb(51, 102, 153)), count(&picture, rgb(255, 128, 0)));
    assert_eq!(a + b, 100);
    assert!(a.abs_diff(b) <= 10, "{a} and {b}");
}

#[test]
fn unlit_vertex_and_face_colors_are_the_files_codes() {
    let vertices = "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z\n\
        property uchar red\nproperty uchar green\nproperty uchar blue\nelement face 1\n\
        property list uchar int vertex_indices\nend_header\n0 0 0 17 200 3\n9 0 0 17 200 3\n0 9 0 17 200 3\n3 0 1 2\n";
    let faces = "ply\nformat ascii 1.0\nelement vertex 4\nproperty float x\nproperty float y\nproperty float z\n\
        element face 2\nproperty list uchar int vertex_indices\nproperty uchar red\nproperty uchar green\n\
        property uchar blue\nend_header\n0 0 0\n9 0 0\n0 9 0\n-9 0 0\n3 0 1 2 1 2 3\n3 0 2 3 254 253 252\n";
    let folder = Folder::new().with("v.ply", vertices).with("f.ply", faces);
    assert_eq!(count(&folder.render(&format!("v.ply {TO_SCALE}")), rgb(17, 200, 3)), 9 * 8 / 2);
    let picture = folder.render(&format!("f.ply {TO_SCALE}"));
    assert!(count(&picture, rgb(1, 2, 3)) >= 36);
    assert!(count(&picture, rgb(254, 253, 252)) >= 36);
}

#[test]
fn unlit_gltf_base_colors_are_their_codes() {
    // 0.5 of linear light is code 188 of sRGB; the buffer holds (0, 0, 0), (9, 0, 0), (0, 9, 0).
    let model = r#"{"asset":{"version":"2.0"},"scene":0,"scenes":[{"nodes":[0]}],"nodes":[{"mesh":0}],
        "meshes":[{"primitives":[{"attributes":{"POSITION":0},"material":0}]}],
        "materials":[{"pbrMetallicRoughness":{"baseColorFactor":[1,0,0.5,1]}}],
        "accessors":[{"bufferView":0,"componentType":5126,"count":3,"type":"VEC3","min":[0,0,0],"max":[9,9,0]}],
        "bufferViews":[{"buffer":0,"byteLength":36}],
        "buffers":[{"byteLength":36,"uri":"data:application/octet-stream;base64,DATA"}]}"#;
    let folder = Folder::new()
        .with("m.gltf", model.replace("DATA", "AAAAAAAAAAAAAAAAAAAQQQAAAAAAAAAAAAAAAAAAEEEAAAAA"));
    assert_eq!(count(&folder.render(&format!("m.gltf {TO_SCALE}")), rgb(255, 0, 188)), 9 * 8 / 2);
}

#[test]
fn distances_are_along_the_axis_and_infinite_where_nothing_is() {
    let folder = Folder::new().with("square.obj", SQUARE);
    for lens in
        ["--camera-view-angle 90", "--camera-orthographic", "--camera-orthographic --camera-height 20"]
    {
        folder.done(&format!(
            "render square.obj -o p.png --depth-image d.pfm --resolution 80,60 \
             --camera-position 5,0,12 --camera-direction 0,0,-1 {lens}"
        ));
        let (width, height, values) = pfm(&folder.bytes("d.pfm"));
        assert_eq!((width, height), (80, 60));
        let picture = folder.picture("p.png");
        let mut seen = 0;
        for (pixel, value) in picture.pixels().zip(values) {
            if *pixel == BACKGROUND {
                assert_eq!(value, f32::INFINITY);
            } else {
                // Along the axis, not along the line of sight: 10 everywhere, as far as 24 bits tell.
                assert!((value - 10.0).abs() <= 10.0 * 5e-7, "{value}");
                seen += 1;
            }
        }
        assert!(seen > 20, "{lens}");
    }
}

#[test]
fn distances_lie_as_the_picture_does() {
    let folder = Folder::new().with("square.obj", SQUARE);
    folder.done(&format!("render square.obj -o p.png --depth-image d.pfm {TO_SCALE}"));
    let (width, _, values) = pfm(&folder.bytes("d.pfm"));
    let near: Vec<usize> = (0..values.len()).filter(|i| values[*i].is_finite()).collect();
    assert_eq!((near[0] % width, near[0] / width), (128, 123));
    assert_eq!(near.len(), 50);
}

#[test]
fn id_images_hold_the_number_of_each_triangle_plus_one() {
    // Polygons are cut into triangles in the order of the file; models follow each other.
    let folder = Folder::new()
        .with("square.obj", SQUARE)
        .with("one.obj", "v -20 0 0\nv -10 0 0\nv -10 10 0\nf 1 2 3\n");
    folder.done(&format!("render square.obj one.obj -o p.png --id-image i.png {TO_SCALE} --samples 16"));
    let ids = folder.picture("i.png");
    let mut counts = [0_usize; 4];
    for Rgba([r, g, b, _]) in ids.pixels() {
        counts[usize::from(*r) << 16 | usize::from(*g) << 8 | usize::from(*b)] += 1;
    }
    assert_eq!(counts[1] + counts[2], 50);
    assert!(counts[1] >= 20 && counts[2] >= 20 && (45..=55).contains(&counts[3]), "{counts:?}");
    assert_eq!(counts.iter().sum::<usize>(), 256 * 256);
}

#[test]
fn numbers_beyond_a_byte_keep_their_bytes_in_order() {
    let folder = Folder::new();
    folder.done(
        "render shape:plane:300 -o p.png --id-image i.png --resolution 64,64 --camera-direction 0,-1,0",
    );
    let ids = folder.picture("i.png");
    let id = |x, y| {
        let Rgba([r, g, b, _]) = *ids.get_pixel(x, y);
        u32::from(r) << 16 | u32::from(g) << 8 | u32::from(b)
    };
    let all: Vec<u32> = ids.enumerate_pixels().map(|(x, y, _)| id(x, y)).filter(|id| *id > 0).collect();
    assert!(all.iter().all(|id| *id <= 180_000), "a plane of 300 by 300 squares has 180,000 triangles");
    assert!(all.iter().any(|id| *id > 0xffff) && all.iter().any(|id| *id < 0xffff));
}

#[test]
fn the_same_command_writes_the_same_bytes() {
    let folder = Folder::new();
    for name in ["a", "b"] {
        folder.done(&format!(
            "render shape:teapot shape:cube -o {name}.png --depth-image {name}.pfm --id-image {name}-id.png \
             --edges --samples 4 --resolution 200,150 --light 1,2,3"
        ));
    }
    for suffix in [".png", ".pfm", "-id.png"] {
        assert_eq!(folder.bytes(&format!("a{suffix}")), folder.bytes(&format!("b{suffix}")), "{suffix}");
    }
}

#[test]
fn no_number_of_threads_changes_a_byte() {
    let folder = Folder::new();
    for options in ["--edges", "--samples 4 --background none", "--wire", "--resolution 640,480"] {
        let outputs = "--depth-image {}.pfm --id-image {}-ids.png -o {}.png";
        let made = |threads: &str| {
            let name = if threads.is_empty() { "default" } else { threads };
            let threads = if threads.is_empty() { String::new() } else { format!("--threads {threads}") };
            let outputs = outputs.replace("{}", name);
            let size = if options.contains("--resolution") { "" } else { "--resolution 101,77" };
            folder.done(&format!("render shape:teapot:6 shape:cube {options} {size} {threads} {outputs}"));
            [".png", ".pfm", "-ids.png"].map(|end| folder.bytes(&format!("{name}{end}")))
        };
        let one = made("1");
        for threads in ["", "2", "3", "8", "256"] {
            assert!(made(threads) == one, "{options}: {threads} threads");
        }
    }
}
