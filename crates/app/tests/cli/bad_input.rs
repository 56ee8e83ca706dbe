//! Whatever comes in: one line that names the file, a status, nothing left behind.

use crate::support::{Folder, SQUARE};

/// What a bad file must be told about: its name, its content, and what the line must hold.
type Case = (&'static str, &'static [u8], &'static str);

const FILES: &[Case] = &[
    ("empty.obj", b"", "empty"),
    ("empty.stl", b"", "empty"),
    ("noise.obj", b"\x00\x01\xfe\xff\x80rubbish\x00\x00", ""),
    ("index.obj", b"v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 9\n", "line 4"),
    ("zero.obj", b"v 0 0 0\nv 1 0 0\nv 0 1 0\nf 0 1 2\n", "line 4"),
    ("number.obj", b"v 0 zero 0\nf 1 1 1\n", "line 1"),
    ("points.obj", b"v 0 0 0\nv 1 0 0\n", "no face"),
    ("short.ply", b"ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\n", ""),
    ("lying.ply", b"ply\nformat binary_little_endian 1.0\nelement vertex 4000000000\nproperty float x\nproperty float y\nproperty float z\nelement face 4000000000\nproperty list uchar int vertex_indices\nend_header\n\0\0\0\0", ""),
    ("short.glb", b"glTF\x02\0\0\0\xff\xff\xff\xff", ""),
    ("wrong.gltf", b"{\"asset\":{\"version\":\"2.0\"},\"meshes\":[{\"primitives\":[{\"attributes\":{\"POSITION\":7}}]}]}", ""),
    ("text.stl", b"solid x\nfacet normal 0 0 1\nouter loop\nvertex 1 2\n", "line 4"),
    ("model.3mf", b"PK\x03\x04rest", "3MF"),
    ("model.step", b"ISO-10303-21;\nHEADER;\n", "STEP"),
    ("model.txt", b"hello\n", ""),
];

#[test]
fn a_bad_file_is_one_line_that_names_it_and_leaves_no_output() {
    for (name, content, substance) in FILES {
        let folder = Folder::new().with(name, content);
        for command in [
            format!("render {name} -o out.png --resolution 20,20"),
            format!("info {name}"),
            format!("bench {name} --resolution 20,20 --frames 1"),
        ] {
            let said = folder.run(&command);
            assert_eq!(said.status, Some(1), "{command}: {}", said.stderr);
            assert_eq!(said.stderr.lines().count(), 1, "{command}: {}", said.stderr);
            assert!(said.stderr.starts_with(&format!("polosa: {name}: ")), "{command}: {}", said.stderr);
            assert!(said.stderr.contains(substance), "{command}: {}", said.stderr);
            assert!(!said.stderr.contains("panicked") && !said.stderr.contains("defect"), "{}", said.stderr);
            assert!(said.stdout.is_empty(), "{command}");
        }
        assert_eq!(folder.names(), [*name]);
    }
}

#[test]
fn what_is_no_file_is_said_so() {
    let folder = Folder::new();
    std::fs::create_dir(folder.path("folder.obj")).unwrap();
    for (name, substance) in [("missing.obj", "no such file"), ("folder.obj", "folder")] {
        let said = folder.run(&format!("render {name} -o out.png"));
        assert_eq!(said.status, Some(1));
        assert_eq!(said.stderr.lines().count(), 1);
        assert!(said.stderr.starts_with(&format!("polosa: {name}: ")), "{}", said.stderr);
        assert!(said.stderr.contains(substance), "{}", said.stderr);
    }
}

#[test]
fn bad_standard_input_is_named_as_such() {
    let folder = Folder::new();
    for input in [b"".as_slice(), b"\xff\xfe\x00"] {
        let said = folder.run_with("render - -o out.png", input);
        assert_eq!(said.status, Some(1));
        assert!(said.stderr.starts_with("polosa: standard input: "), "{}", said.stderr);
    }
    assert!(folder.names().is_empty());
}

#[test]
fn impossible_resolutions_are_refused_before_anything_is_read() {
    let folder = Folder::new();
    for size in
        ["0,0", "0,100", "100,0", "16385,1", "1,16385", "4294967296,4294967296", "1,99999999999999999999999"]
    {
        for command in ["render missing.obj -o out.png", "bench missing.obj", "bench"] {
            let said = folder.run(&format!("{command} --resolution {size}"));
            assert_eq!(said.status, Some(1), "{command} {size}");
            assert_eq!(said.stderr.lines().count(), 1);
            assert!(said.stderr.contains("--resolution") && said.stderr.contains("16384"), "{}", said.stderr);
        }
    }
    let most = folder.run("render shape:cube -o out.png --resolution 16384,1");
    assert_eq!(
        (most.status, folder.picture("out.png").dimensions()),
        (Some(0), (16384, 1)),
        "{}",
        most.stderr
    );
}

#[test]
fn coordinates_that_are_no_numbers_are_left_out_and_the_rest_is_drawn() {
    let folder = Folder::new().with("nan.obj", format!("{SQUARE}v nan 0 0\nv inf 1 1\nf 1 2 5\nf 2 3 6\n"));
    let value: serde_json::Value =
        serde_json::from_str(&folder.done("render nan.obj -o out.png --resolution 20,20 --json").text())
            .unwrap();
    assert_eq!(value["triangles"]["not_finite"], 2);
    assert_eq!(value["triangles"]["drawn"], 2);
    // Whoever asks for no report is told all the same.
    let said = folder.run("render nan.obj -o out.png --resolution 20,20");
    assert_eq!(said.status, Some(0));
    let note = "polosa: out.png: note: 2 faces or edges with coordinates that are not finite, or too large to draw, are";
    assert!(said.stderr.starts_with(note), "{}", said.stderr);
    let folder = folder.with("one.obj", format!("{SQUARE}v nan 0 0\nf 1 2 5\n"));
    let said = folder.run("render one.obj -o out.png --resolution 20,20");
    assert!(
        said.stderr.contains("note: 1 face or edge with") && said.stderr.contains(" is left out"),
        "{said:?}"
    );
}

#[test]
fn enormous_and_tiny_models_are_drawn() {
    for scale in ["1e30", "1e-30"] {
        let model = format!("v 0 0 0\nv {scale} 0 0\nv 0 {scale} 0\nf 1 2 3\n");
        let folder = Folder::new().with("m.obj", model);
        for lens in ["", "--camera-orthographic"] {
            let picture =
                folder.render(&format!("m.obj --resolution 40,40 --camera-direction 0,0,-1 {lens}"));
            assert!(crate::support::extent(&picture, crate::support::BACKGROUND).is_some(), "{scale} {lens}");
        }
    }
}

#[test]
fn a_picture_of_nothing_says_why() {
    let front = "--camera-direction 0,0,-1 --camera-orthographic --resolution 50,50";
    let folder = Folder::new()
        .with("square.obj", SQUARE)
        .with("line.obj", "v 0 0 0\nv 1 0 0\nv 2 0 0\nf 1 2 3\nf 1 1 2\n")
        .with("point.obj", "v 1 1 1\nf 1 1 1\n")
        .with("nan.obj", "v nan 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
    let away = "--camera-position 5,2.5,22 --camera-direction 0,0,1";
    for (arguments, what) in [
        (format!("line.obj {front}"), "all 2 triangles degenerate"),
        (format!("line.obj {front}"), "`polosa info`"),
        ("point.obj --wire".to_owned(), "have no edges"),
        ("nan.obj".to_owned(), "1 triangle with coordinates that are not finite, or too large to draw"),
        (format!("square.obj {away}"), "all 2 triangles outside of the view: check --camera-position"),
        (format!("square.obj {away} --wire"), "all 4 edges outside of the view: check --camera-position"),
        (
            format!("square.obj {front} --cull front"),
            "all 2 triangles left out by --cull front: try --cull none",
        ),
        (format!("square.obj {front} --camera-height 20 --camera-focal-point 25,0,0"), "beside the picture"),
        (
            format!("square.obj {front} --camera-height 9999 --camera-focal-point .1,.1,0"),
            "smaller than a pixel",
        ),
        (format!("square.obj {front} --shading unlit --color #2b2b2b"), "of the background's colour"),
        (format!("square.obj {away} --background none"), "outside of the view"),
    ] {
        let note = folder.blank(&arguments);
        assert!(note.contains(what), "{arguments}: {note}");
    }
    // Programs find it in the report.
    let text = folder.done(&format!("render square.obj {away} -o made.png --json")).text();
    let value: serde_json::Value = serde_json::from_str(&text).unwrap();
    assert!(value["notes"][0].as_str().unwrap().starts_with("nothing to see: "), "{text}");
    let text = folder.done("render square.obj -o made.png --json").text();
    assert!(text.contains("\"notes\":[]"), "{text}");
}

#[test]
fn faults_of_materials_are_told_with_file_and_line() {
    let folder = Folder::new()
        .with("m.obj", format!("mtllib m.mtl\nusemtl a\n{SQUARE}usemtl missing\nf 1 2 3\n"))
        .with("m.mtl", "newmtl a\nKd 2 -1 nan\n");
    let said = folder.run("render m.obj -o x.png --resolution 20,20");
    let lines: Vec<&str> = said.stderr.lines().collect();
    assert_eq!((said.status, lines.len()), (Some(0), 2), "{lines:?}");
    assert!(lines[0].starts_with("polosa: m.obj: note: m.mtl: line 2: `Kd 2 -1 nan` is not"), "{lines:?}");
    assert!(
        lines[1].starts_with("polosa: m.obj: note: line 8: the material `missing` is in no MTL"),
        "{lines:?}"
    );
}

#[test]
fn a_name_with_a_newline_stays_one_line() {
    let folder = Folder::new();
    let output = folder.command().args(["render", "a\nb.obj", "-o", "c\nd.png"]).output().unwrap();
    let stderr = String::from_utf8(output.stderr).unwrap();
    assert_eq!(stderr.lines().count(), 1, "{stderr}");
}

#[test]
fn wrong_usage_exits_with_2_and_says_what_is_right() {
    let folder = Folder::new().with("m.obj", SQUARE);
    for (arguments, substance) in [
        ("render m.obj", "--output"),
        ("render -o x.png", "MODEL"),
        ("render m.obj -o x.xyz", ".png"),
        ("render m.obj -o x", ".png"),
        ("render m.obj -o x.png --no-such-option", "--no-such-option"),
        ("render m.obj -o x.png --resolution 640", "W,H"),
        ("render m.obj -o x.png --resolution 6e2,1", "W,H"),
        ("render m.obj -o x.png --camera-position 1,2", "X,Y,Z"),
        ("render m.obj -o x.png --camera-position 1,2,nan", "X,Y,Z"),
        ("render m.obj -o x.png --camera-direction 0,0,0", "no direction"),
        ("render m.obj -o x.png --camera-view-angle 180", "less than 180"),
        ("render m.obj -o x.png --camera-height 5", "--camera-orthographic"),
        ("render m.obj -o x.png --camera-orthographic --camera-height 0", "more than 0"),
        ("render m.obj -o x.png --camera-orthographic --camera-view-angle 20", "--camera-view-angle"),
        (
            "render m.obj -o x.png --camera-position 1,1,1 --camera-focal-point 0,0,0 --camera-direction 1,0,0",
            "twice",
        ),
        ("render m.obj -o x.png --up up", "+X"),
        ("render m.obj -o x.png --shading phong", "unlit"),
        ("render m.obj -o x.png --cull all", "none"),
        ("render m.obj -o x.png --color greenish", "#RRGGBB"),
        ("render m.obj -o x.png --background nothing", "none"),
        ("render m.obj -o x.png --samples 2", "16"),
        ("render m.obj -o x.png --ambient 1.5", "0 to 1"),
        ("render m.obj -o x.png --light-world", "--light"),
        ("render m.obj -o x.png --edges --wire", "--wire"),
        ("render m.obj -o x.png --depth-image d.png", ".pfm"),
        ("render m.obj -o x.png --id-image d.jpg", "JPEG"),
        ("render m.obj -o x.png --id-image x.png", "twice"),
        ("render m.obj -o - --id-image -", "standard output"),
        ("render m.obj shape:cube -o {stem}.png --id-image i.png", "{stem}"),
        ("render - - -o x.png", "once"),
        ("render shape:cubicle -o x.png", "cube"),
        ("render shape:sphere:99 -o x.png", "sphere"),
        ("render m.obj -o x.png --camera-position 1,2,3 --camera-focal-point 1,2,3", "are one point"),
        ("render m.obj -o --edges", "--edges"),
        ("info", "MODEL"),
        ("info - -", "once"),
        ("render m.obj -o x.png --threads 0", "from 1 to 256"),
        ("render m.obj -o x.png --threads 257", "from 1 to 256"),
        ("render m.obj -o x.png --threads -1", "from 1 to 256"),
        ("render m.obj -o x.png --threads two", "from 1 to 256"),
        ("bench m.obj --threads 0", "from 1 to 256"),
        ("bench m.obj --frames 0", "from 1 to 1000000"),
        ("bench m.obj --frames -5", "from 1 to 1000000"),
        ("bench m.obj --frames 99999999999999999999999", "from 1 to 1000000"),
        ("bench m.obj --frames 2.5", "from 1 to 1000000"),
        ("bench m.obj --resolution 640", "W,H"),
        ("bench m.obj --output x.png", "--output"),
        ("bench m.obj --edges --wire", "--wire"),
        ("bench m.obj --camera-position 1,2,3 --camera-focal-point 1,2,3", "are one point"),
        ("bench shape:cubicle", "cube"),
        ("bench - -", "once"),
        ("dance", "dance"),
    ] {
        let said = folder.run(arguments);
        assert_eq!(said.status, Some(2), "{arguments}: {}", said.stderr);
        assert!(said.stderr.contains(substance), "{arguments}: {}", said.stderr);
        assert_eq!(folder.names(), ["m.obj"], "{arguments}");
    }
}
