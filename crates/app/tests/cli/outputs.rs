//! Where pictures go, and what is there when something fails.

use std::fs;

use image::ImageFormat;

use crate::support::{BACKGROUND, Folder, SQUARE, extent, pfm};

const SMALL: &str = "--resolution 40,30";

#[test]
fn every_format_holds_the_same_picture() {
    let folder = Folder::new();
    folder.done(&format!("render shape:teapot -o a.png {SMALL}"));
    let expected = folder.picture("a.png");
    for extension in ["bmp", "tga", "qoi", "ppm", "pnm", "PNG"] {
        folder.done(&format!("render shape:teapot -o a.{extension} {SMALL}"));
        assert_eq!(folder.picture(&format!("a.{extension}")), expected, "{extension}");
    }
    folder.done(&format!("render shape:teapot -o a.jpg {SMALL}"));
    let jpeg = folder.picture("a.jpg");
    for (a, b) in jpeg.pixels().zip(expected.pixels()) {
        assert!(a.0.iter().zip(b.0).all(|(a, b)| a.abs_diff(b) < 60), "{a:?} {b:?}");
    }
}

#[test]
fn transparency_survives_in_every_format_that_has_it() {
    let folder = Folder::new();
    let arguments = format!("{SMALL} --background none --samples 4");
    folder.done(&format!("render shape:teapot -o a.png {arguments}"));
    let expected = folder.picture("a.png");
    assert!(
        expected.pixels().any(|pixel| pixel.0[3] == 0) && expected.pixels().any(|pixel| pixel.0[3] == 255)
    );
    for extension in ["bmp", "tga", "qoi"] {
        folder.done(&format!("render shape:teapot -o a.{extension} {arguments}"));
        assert_eq!(folder.picture(&format!("a.{extension}")), expected, "{extension}");
    }
    for extension in ["ppm", "jpg"] {
        let said = folder.run(&format!("render shape:teapot -o b.{extension} {arguments}"));
        assert_eq!(said.status, Some(2));
        assert!(said.stderr.contains("transparency"), "{}", said.stderr);
    }
}

#[test]
fn standard_streams_carry_model_picture_and_report() {
    let folder = Folder::new().with("square.obj", SQUARE);
    folder.done(&format!("render square.obj -o file.png {SMALL}"));
    let said = folder.run_with(&format!("render - -o - {SMALL} --stats"), SQUARE.as_bytes());
    assert_eq!(said.status, Some(0), "{}", said.stderr);
    assert_eq!(said.stdout, folder.bytes("file.png"));
    assert!(said.stderr.contains("standard input: OBJ"), "{}", said.stderr);
    // The other pictures may go there instead; the report still does not mix with them.
    let said = folder.run(&format!("render square.obj -o p.png --depth-image - {SMALL} --json"));
    assert_eq!(pfm(&said.stdout).0, 40);
    assert!(serde_json::from_str::<serde_json::Value>(&said.stderr).is_ok(), "{}", said.stderr);
}

#[test]
fn names_may_begin_with_a_hyphen() {
    let folder = Folder::new();
    folder.done(&format!("render shape:cube -o -x.png --id-image -i.png --depth-image -d.pfm {SMALL}"));
    assert_eq!(folder.names(), ["-d.pfm", "-i.png", "-x.png"]);
    assert_eq!(folder.picture("-x.png").dimensions(), (40, 30));
}

#[cfg(unix)]
#[test]
fn a_link_to_nothing_stays_and_its_target_is_made() {
    let folder = Folder::new();
    std::os::unix::fs::symlink("real.png", folder.path("link.png")).unwrap();
    // Two names of one file that is not there yet.
    let said = folder.run(&format!("render shape:cube -o link.png --id-image real.png {SMALL}"));
    assert!(said.status == Some(2) && said.stderr.contains("twice"), "{}", said.stderr);
    folder.done(&format!("render shape:cube -o link.png {SMALL}"));
    assert!(fs::symlink_metadata(folder.path("link.png")).unwrap().is_symlink());
    assert_eq!(folder.picture("real.png").dimensions(), (40, 30));
    assert_eq!(folder.names(), ["link.png", "real.png"]);
}

#[test]
fn several_models_make_one_picture_on_standard_output() {
    let folder = Folder::new();
    let said = folder.run(&format!("render shape:cube shape:cone -o - {SMALL}"));
    assert_eq!((said.status, said.stderr.as_str()), (Some(0), ""));
    let picture = image::load_from_memory_with_format(&said.stdout, ImageFormat::Png).unwrap().into_rgba8();
    assert!(extent(&picture, BACKGROUND).is_some());
    assert!(folder.names().is_empty());
}

#[test]
fn a_reader_that_stops_reading_is_no_panic() {
    let folder = Folder::new();
    for arguments in
        ["render shape:teapot -o - --resolution 2000,2000 --edges", "info shape:teapot", "--help"]
    {
        let mut command = folder.command();
        command.args(arguments.split(' '));
        command.stdout(std::process::Stdio::piped()).stderr(std::process::Stdio::piped());
        let mut child = command.spawn().unwrap();
        drop(child.stdout.take());
        let output = child.wait_with_output().unwrap();
        let stderr = String::from_utf8(output.stderr).unwrap();
        assert!(!stderr.contains("panicked") && stderr.lines().count() <= 1, "{arguments}: {stderr}");
        assert!(output.status.code().is_some(), "{arguments}");
        // Only the picture is lost, which is worth a word.
        assert_eq!(
            stderr.contains("stopped reading"),
            arguments.starts_with("render"),
            "{arguments}: {stderr}"
        );
    }
}

#[test]
fn a_stem_makes_a_picture_of_each_model_and_a_failure_stops_none() {
    let folder = Folder::new().with("square.obj", SQUARE).with("bad.obj", "v 1 2\n");
    fs::create_dir(folder.path("out")).unwrap();
    let said = folder.run(&format!(
        "render square.obj bad.obj missing.stl shape:cube -o out/x-{{stem}}.png --id-image out/{{stem}}.id.png {SMALL}"
    ));
    assert_eq!(said.status, Some(1));
    let lines: Vec<&str> = said.stderr.lines().collect();
    assert_eq!(lines.len(), 2, "{}", said.stderr);
    assert!(lines[0].starts_with("polosa: bad.obj: ") && lines[1].starts_with("polosa: missing.stl: "));
    let mut names: Vec<_> =
        fs::read_dir(folder.path("out")).unwrap().map(|entry| entry.unwrap().file_name()).collect();
    names.sort();
    assert_eq!(names, ["cube.id.png", "square.id.png", "x-cube.png", "x-square.png"]);
    // Each is the picture that it would have been alone.
    folder.done(&format!("render square.obj -o alone.png {SMALL}"));
    assert_eq!(folder.bytes("alone.png"), folder.bytes("out/x-square.png"));
}

#[test]
fn models_of_one_stem_are_refused_before_anything_is_written() {
    let folder = Folder::new().with("a.obj", SQUARE).with("a.ply", "ply\n");
    let said = folder.run("render a.obj a.ply -o {stem}.png");
    assert_eq!(said.status, Some(2));
    assert!(said.stderr.contains("a.png would be written twice"), "{}", said.stderr);
    assert_eq!(folder.names(), ["a.obj", "a.ply"]);
}

#[cfg(unix)]
#[test]
fn devices_are_written_directly_and_stay() {
    use std::os::unix::fs::FileTypeExt as _;

    let folder = Folder::new();
    folder.done(&format!("render shape:cube -o /dev/null --depth-image /dev/null {SMALL}"));
    assert!(fs::metadata("/dev/null").unwrap().file_type().is_char_device());
    let full = folder.run(&format!("render shape:cube -o /dev/full {SMALL}"));
    assert_eq!(full.status, Some(1));
    assert!(
        full.stderr.starts_with("polosa: /dev/full: ") && full.stderr.contains("no space"),
        "{}",
        full.stderr
    );
}

#[cfg(unix)]
#[test]
fn a_new_file_has_the_permissions_of_any_new_file() {
    use std::os::unix::fs::PermissionsExt as _;

    let folder = Folder::new().with("reference", "");
    folder.done(&format!("render shape:cube -o a.png {SMALL}"));
    let mode = |name: &str| fs::metadata(folder.path(name)).unwrap().permissions().mode();
    assert_eq!(mode("a.png"), mode("reference"));
}

#[test]
fn what_cannot_be_written_is_one_line_and_leaves_nothing() {
    let folder = Folder::new().with("file", "x").with("kept.png", "kept");
    fs::create_dir(folder.path("sub.png")).unwrap();
    let mut permissions = fs::metadata(folder.path("kept.png")).unwrap().permissions();
    permissions.set_readonly(true);
    fs::set_permissions(folder.path("kept.png"), permissions).unwrap();
    for (output, substance) in [
        ("none/a.png", "no such folder"),
        ("sub.png", "is a folder"),
        ("file/a.png", "no folder"),
        ("kept.png", "write-protected"),
    ] {
        let said = folder.run(&format!("render shape:cube -o {output} {SMALL}"));
        assert_eq!(said.status, Some(1), "{output}");
        assert_eq!(said.stderr.lines().count(), 1, "{}", said.stderr);
        assert!(said.stderr.starts_with(&format!("polosa: {output}: ")), "{}", said.stderr);
        assert!(said.stderr.contains(substance), "{}", said.stderr);
    }
    assert_eq!(folder.names(), ["file", "kept.png", "sub.png"]);
    assert_eq!(folder.bytes("kept.png"), b"kept");
}

#[test]
fn a_failure_keeps_the_picture_that_was_there() {
    let folder = Folder::new().with("p.png", "old").with("bad.stl", "solid");
    assert_eq!(folder.run("render bad.stl -o p.png").status, Some(1));
    // The second output fails: the first does not appear either.
    assert_eq!(folder.run("render shape:cube -o p.png --id-image none/i.png").status, Some(1));
    assert_eq!(folder.bytes("p.png"), b"old");
    assert_eq!(folder.names(), ["bad.stl", "p.png"]);
}

#[test]
fn without_a_command_and_a_display_a_scene_is_drawn_and_its_place_is_told() {
    let folder = Folder::new();
    let said = folder.run("");
    assert_eq!((said.status, said.stderr.lines().count()), (Some(0), 1), "{}", said.stderr);
    assert!(said.stderr.contains("DISPLAY"), "it names what is missing: {}", said.stderr);
    let place = said.text();
    assert_eq!(fs::canonicalize(place.trim()).unwrap(), fs::canonicalize(folder.path("polosa.png")).unwrap());
    let picture = folder.picture("polosa.png");
    let mut colors: Vec<_> = picture.pixels().map(|pixel| pixel.0).collect();
    colors.sort_unstable();
    colors.dedup();
    assert!(colors.len() > 500, "several shapes in several colours, shaded");
}

#[test]
fn without_a_display_a_model_is_drawn_as_its_window_would_begin() {
    let folder = Folder::new();
    for arguments in ["view shape:cone", "view shape:cone --edges --camera-azimuth-angle 30 -o seen.bmp"] {
        let said = folder.run(arguments);
        assert_eq!((said.status, said.stderr.lines().count()), (Some(0), 1), "{}", said.stderr);
        let place = said.text();
        let same = arguments.replace("view", "render");
        let name = if same.contains("-o") { "seen.bmp" } else { "polosa.png" };
        assert_eq!(fs::canonicalize(place.trim()).unwrap(), fs::canonicalize(folder.path(name)).unwrap());
        let seen = folder.picture(name);
        let same = if same.contains("-o") { same } else { format!("{same} -o polosa.png") };
        folder.done(&same);
        assert!(seen == folder.picture(name), "{arguments}");
    }
}

#[test]
fn a_model_alone_is_viewed_and_a_word_that_is_no_file_is_held_against_the_commands() {
    let folder = Folder::new().with("a.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
    folder.run("a.obj --wire -o wire.png").status.filter(|status| *status == 0).expect("it is drawn");
    let wire = folder.picture("wire.png");
    folder.done("render a.obj --wire -o wire.png");
    assert!(wire == folder.picture("wire.png"));
    let said = folder.run("rendr a.obj");
    assert!(said.status == Some(2) && said.stderr.contains("render"), "{}", said.stderr);
    let said = folder.run("none.obj");
    assert_eq!((said.status, said.stderr.lines().count()), (Some(1), 1), "{}", said.stderr);
    assert!(said.stderr.starts_with("polosa: none.obj: "), "{}", said.stderr);
    let said = folder.run("view a.obj --background none");
    assert!(said.status == Some(2) && said.stderr.contains("name a colour"), "{}", said.stderr);
}
