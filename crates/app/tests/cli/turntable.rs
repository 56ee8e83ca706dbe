//! Turntables: animations and sequences, read again.

use std::fs;

use image::{Rgba, RgbaImage};

use crate::support::{BACKGROUND, Folder, SQUARE, cube_stl, extent, play};

const SMALL: &str = "--resolution 60,40";

fn differing(a: &RgbaImage, b: &RgbaImage) -> usize {
    assert_eq!(a.dimensions(), b.dimensions());
    a.pixels().zip(b.pixels()).filter(|(a, b)| a != b).count()
}

#[test]
fn frames_are_the_pictures_that_render_makes_from_all_round() {
    let folder = Folder::new();
    let view = format!("{SMALL} --camera-position 3,2.5,4 --camera-focal-point 0,0,0 --light 1,2,1");
    folder.done(&format!("turntable shape:teapot:3 -o a.gif --frames 8 {view}"));
    let frames = play(&folder.bytes("a.gif"));
    assert_eq!(frames.len(), 8);
    assert_eq!(
        frames[0].0,
        folder.render(&format!("shape:teapot:3 {view}")),
        "the first is the still picture"
    );
    for (n, (frame, _)) in frames.iter().enumerate() {
        // The model turns counter-clockwise seen from above: as if the camera went to the left.
        let azimuth = -45.0 * n as f64;
        let still = folder.render(&format!("shape:teapot:3 {view} --camera-azimuth-angle {azimuth}"));
        // Cameras that are equal but for rounding may see another pixel at an edge.
        assert!(differing(frame, &still) <= 2, "frame {n}: {}", differing(frame, &still));
        assert!(n == 0 || differing(frame, &frames[0].0) > 100, "frame {n} is another view");
    }
}

#[test]
fn a_whole_turn_closes() {
    let folder = Folder::new();
    // A square pyramid looks the same after each quarter.
    folder.done(&format!("turntable shape:pyramid -o a.gif --frames 12 {SMALL}"));
    let frames = play(&folder.bytes("a.gif"));
    assert_eq!(frames.len(), 12);
    for n in 0..12 {
        assert!(differing(&frames[n].0, &frames[(n + 3) % 12].0) <= 6, "frame {n} and a quarter later");
        assert!(differing(&frames[n].0, &frames[(n + 1) % 12].0) > 30, "frame {n} and the next");
    }
}

#[test]
fn delays_sum_up_to_the_time_of_the_turn() {
    let folder = Folder::new();
    for (options, sum) in [
        ("", 300),
        ("--frames 10 --fps 30", 33),
        ("--frames 7 --fps 0.5", 1400),
        ("--frames 50 --fps 50", 100),
    ] {
        folder.done(&format!("turntable shape:cube -o a.gif --resolution 16,12 {options}"));
        let delays: Vec<u64> =
            play(&folder.bytes("a.gif")).iter().map(|(_, delay)| u64::from(*delay)).collect();
        assert_eq!(delays.iter().sum::<u64>(), sum, "{options}: {delays:?}");
        assert!(delays.iter().max().unwrap() - delays.iter().min().unwrap() <= 1, "{delays:?}");
    }
}

#[test]
fn every_frame_shows_the_whole_model() {
    let folder = Folder::new().with("cube.stl", cube_stl()).with("square.obj", SQUARE);
    for arguments in [
        "shape:teapot:3",
        "shape:teapot:3 --axis -X",
        "cube.stl --camera-elevation-angle 40",
        "square.obj --camera-orthographic --axis +Z",
        "square.obj --camera-focal-point 20,0,0 --camera-view-angle 90",
        "square.obj shape:cone",
    ] {
        folder.done(&format!("turntable {arguments} -o a.gif --frames 16 --resolution 90,60"));
        let mut widest = 0;
        for (n, (frame, _)) in play(&folder.bytes("a.gif")).iter().enumerate() {
            if let Some([x0, y0, x1, y1]) = extent(frame, BACKGROUND) {
                assert!(
                    x0 >= 3 && y0 >= 2 && x1 <= 86 && y1 <= 57,
                    "{arguments}, frame {n}: {:?}",
                    [x0, y0, x1, y1]
                );
                widest = widest.max(x1 - x0).max((y1 - y0) * 3 / 2);
            }
        }
        assert!(widest >= 30, "{arguments}: no farther away than needed: {widest}");
    }
}

#[test]
fn a_sequence_has_the_frames_of_the_animation() {
    let folder = Folder::new();
    fs::create_dir(folder.path("100%")).unwrap();
    folder.done(&format!("turntable shape:torus:12:6 -o a.gif --frames 11 {SMALL}"));
    folder.done(&format!("turntable shape:torus:12:6 -o 100%/a%%_%03d.png --frames 11 {SMALL}"));
    for (n, (frame, _)) in (1..).zip(play(&folder.bytes("a.gif"))) {
        assert_eq!(folder.picture(&format!("100%/a%_{n:03}.png")), frame);
    }
    assert_eq!(fs::read_dir(folder.path("100%")).unwrap().count(), 11);
}

#[test]
fn transparency_is_kept() {
    let folder = Folder::new();
    let arguments = format!("turntable shape:pyramid --frames 3 {SMALL} --background none --samples 4");
    folder.done(&format!("{arguments} -o a.gif"));
    folder.done(&format!("{arguments} -o a%d.png"));
    let nothing = Rgba([0; 4]);
    for (n, (frame, _)) in (1..).zip(play(&folder.bytes("a.gif"))) {
        let picture = folder.picture(&format!("a{n}.png"));
        assert!(picture.pixels().any(|pixel| !matches!(pixel.0[3], 0 | 255)), "smooth edges");
        for (shown, pixel) in frame.pixels().zip(picture.pixels()) {
            let [r, g, b, alpha] = pixel.0;
            assert_eq!(*shown, if alpha < 128 { nothing } else { Rgba([r, g, b, 255]) });
        }
    }
    let said = folder.run(&format!("{arguments} -o b%d.jpg"));
    assert_eq!(said.status, Some(2));
    assert!(said.stderr.contains("transparency"), "{}", said.stderr);
}

#[test]
fn the_same_command_writes_the_same_bytes_with_any_threads_and_to_standard_output() {
    let folder = Folder::new();
    let arguments = format!("turntable shape:teapot:3 shape:cube --frames 9 {SMALL} --samples 4");
    folder.done(&format!("{arguments} -o a.gif"));
    for threads in [1, 3] {
        folder.done(&format!("{arguments} -o b.gif --threads {threads}"));
        assert!(folder.bytes("a.gif") == folder.bytes("b.gif"), "{threads} threads");
    }
    let said = folder.run(&format!("{arguments} -o - --json"));
    assert_eq!(said.status, Some(0));
    assert!(said.stdout == folder.bytes("a.gif"));
    let report: serde_json::Value = serde_json::from_str(&said.stderr).unwrap();
    assert_eq!((&report["frames"], &report["fps"]), (&9.into(), &24.0.into()));
    assert_eq!(report["models"][1]["triangles"], 12);
    let text = folder.done(&format!("{arguments} -o a.gif --stats")).text();
    assert!(text.starts_with("a.gif: 9 frames of 60×40 pixels, 4 samples each, 24 a second"), "{text}");
}

#[test]
fn a_stem_makes_a_turntable_of_each_model_and_a_failure_stops_none() {
    let folder = Folder::new().with("5%d.obj", SQUARE).with("bad.obj", "v 1 2\n");
    let said =
        folder.run(&format!("turntable 5%d.obj bad.obj shape:cube -o {{stem}}-%d.png --frames 2 {SMALL}"));
    assert_eq!(said.status, Some(1));
    assert_eq!(said.stderr.lines().count(), 1, "{}", said.stderr);
    assert!(said.stderr.starts_with("polosa: bad.obj: "), "{}", said.stderr);
    let made = ["5%d-1.png", "5%d-2.png", "5%d.obj", "bad.obj", "cube-1.png", "cube-2.png"];
    assert_eq!(folder.names(), made);
    let said = folder.run("turntable shape:cube shape:cube -o {stem}.gif");
    assert_eq!(said.status, Some(2));
    assert!(said.stderr.contains("cube.gif would be written twice"), "{}", said.stderr);
}

#[test]
fn wrong_usage_is_told_before_anything_is_drawn() {
    let folder = Folder::new();
    for (options, substance) in [
        ("-o a.png", "%04d"),
        ("-o a%d%d.png", "%% for a percent sign"),
        ("-o a%x.png", "%% for a percent sign"),
        ("-o a%d", ".gif"),
        ("-o a%d.xyz", ".gif"),
        ("-o a.gif --fps 60", "lower --fps"),
        ("-o a.gif --fps 0", "frames a second"),
        ("-o a.gif --frames 0", "from 1 to 1000000"),
        ("-o a.gif --axis W", "+X, -X"),
        ("-o a.gif --camera-position 0,0,0 --camera-focal-point 0,0,0", "one point"),
    ] {
        let said = folder.run(&format!("turntable shape:cube {options}"));
        assert_eq!(said.status, Some(2), "{options}: {}", said.stderr);
        assert!(said.stderr.contains(substance), "{options}: {}", said.stderr);
    }
    assert!(folder.names().is_empty());
}

#[test]
fn a_failure_is_one_line_and_leaves_nothing() {
    let folder = Folder::new().with("bad.stl", "solid").with("kept.gif", "kept");
    fs::create_dir(folder.path("x_2.png")).unwrap();
    for (arguments, substance) in [
        ("bad.stl -o kept.gif", "bad.stl"),
        ("shape:cube -o none/a.gif", "no such folder"),
        ("shape:cube -o none/a%d.png", "no such folder"),
        ("shape:cube -o kept.gif --resolution 17000,5", "--resolution"),
        ("shape:cube -o kept.gif --resolution 16384,16384 --threads 256", "memory"),
        ("shape:cube -o x_%d.png --frames 40", "x_2.png: "),
    ] {
        let mut command = folder.command();
        command.args(["turntable"].into_iter().chain(arguments.split(' ')));
        if arguments.contains("16384") {
            // Few machines have as little; the check is the same.
            if !cfg!(target_os = "linux") {
                continue;
            }
            command = std::process::Command::new("sh");
            command.current_dir(folder.path("."));
            let program = env!("CARGO_BIN_EXE_polosa");
            command.args(["-c", &format!("ulimit -v 4000000; exec {program} turntable {arguments}")]);
        }
        let said = crate::support::said(command.output().unwrap());
        assert_eq!(said.status, Some(1), "{arguments}: {}", said.stderr);
        assert_eq!(said.stderr.lines().count(), 1, "{}", said.stderr);
        assert!(said.stderr.starts_with("polosa: ") && said.stderr.contains(substance), "{}", said.stderr);
    }
    let others = folder.names().into_iter().filter(|name| !name.starts_with("x_")).collect::<Vec<_>>();
    assert_eq!(others, ["bad.stl", "kept.gif"]);
    assert_eq!(folder.bytes("kept.gif"), b"kept");
}

#[cfg(unix)]
#[test]
fn a_full_disk_is_told() {
    let folder = Folder::new();
    let said = folder.run("turntable shape:teapot -o /dev/full --frames 6");
    assert_eq!(said.status, Some(1));
    assert!(
        said.stderr.starts_with("polosa: /dev/full: ") && said.stderr.contains("no space"),
        "{}",
        said.stderr
    );
}

#[test]
fn a_turn_that_shows_nothing_is_noted() {
    let folder = Folder::new();
    let arguments = format!("turntable shape:cube -o a.gif --frames 3 {SMALL} --camera-position 0,0,9");
    let said = folder.run(&format!("{arguments} --camera-direction 0,0,1"));
    assert_eq!(said.status, Some(0), "{}", said.stderr);
    assert!(said.stderr.starts_with("polosa: a.gif: note: nothing to see: "), "{}", said.stderr);
    assert_eq!(play(&folder.bytes("a.gif")).len(), 3);
}
