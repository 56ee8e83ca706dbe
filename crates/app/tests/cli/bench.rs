//! `polosa bench`.

use serde_json::Value;

use crate::support::{Folder, SQUARE};

const SMALL: &str = "--resolution 64,48 --frames 3";

fn json(folder: &Folder, arguments: &str) -> Value {
    let text = folder.done(&format!("bench {arguments} --json")).text();
    assert_eq!(text.lines().count(), 1);
    serde_json::from_str(&text).unwrap()
}

fn number(value: &Value, key: &str) -> f64 {
    value[key].as_f64().unwrap_or_else(|| panic!("{key}: {value}"))
}

/// What `render` makes of the same options, by the same number as the report's: FNV-1a over red, green and blue.
fn rendered(folder: &Folder, arguments: &str) -> String {
    let picture = folder.render(arguments);
    let bytes = picture.pixels().flat_map(|pixel| pixel.0.into_iter().take(3));
    let hash = bytes
        .fold(0xcbf2_9ce4_8422_2325_u64, |hash, byte| (hash ^ u64::from(byte)).wrapping_mul(0x100_0000_01b3));
    format!("{hash:016x}")
}

#[test]
fn json_has_every_figure_and_they_agree_with_each_other() {
    let folder = Folder::new().with("square.obj", SQUARE);
    let value = json(&folder, "square.obj shape:cube --resolution 200,100 --frames 7 --threads 2");
    for (key, expected) in [("triangles", 14), ("width", 200), ("height", 100), ("threads", 2), ("frames", 7)]
    {
        assert_eq!(value[key], expected, "{key}: {value}");
    }
    let [median, min, max] = ["median_ms", "min_ms", "max_ms"].map(|key| number(&value, key));
    assert!(0.0 < min && min <= median && median <= max, "{value}");
    let [lower, upper] = [0, 1].map(|k| value["quartiles_ms"][k].as_f64().unwrap());
    assert!(min <= lower && lower <= median && median <= upper && upper <= max, "{value}");
    let close = |a: f64, b: f64| (a - b).abs() <= 1e-9 * b;
    assert!(close(number(&value, "mtri_per_s"), 14.0 / median / 1e3), "{value}");
    assert!(close(number(&value, "mpix_per_s"), 200.0 * 100.0 / median / 1e3), "{value}");
    let bytes = 8.0 * 200.0 * 100.0;
    assert!(close(number(&value, "memset_gb_per_s"), bytes / number(&value, "memset_ms") / 1e6), "{value}");
    let stages = value["stages_ms"].as_object().unwrap();
    assert!(!stages.is_empty());
    for (stage, time) in stages {
        assert!((0.0..=max).contains(&time.as_f64().unwrap()), "{stage}: {value}");
    }
    assert_eq!(value["models"][0]["name"], "square.obj");
    assert_eq!(value["models"][1]["triangles"], 12);
    assert!(folder.names() == ["square.obj"], "nothing is written");
}

#[test]
fn what_is_timed_is_the_picture_that_render_makes() {
    let folder = Folder::new().with("square.obj", SQUARE);
    for options in [
        "shape:teapot:4",
        "shape:teapot:4 --edges --cull back --camera-azimuth-angle 30",
        "shape:cube shape:torus --wire --background none",
        "shape:torus --samples 4 --shading unlit --color teal",
        "square.obj --samples 4 --background none --camera-orthographic --light 1,2,3 --light-world --up +Z",
    ] {
        let arguments = format!("{options} --resolution 97,61");
        let expected = rendered(&folder, &arguments);
        for threads in ["1", "2", "3", "8", "256"] {
            let value = json(&folder, &format!("{arguments} --frames 1 --threads {threads}"));
            assert_eq!(value["fingerprint"], expected.as_str(), "{options}, {threads} threads");
        }
    }
}

#[test]
fn the_report_is_a_table_that_people_can_read() {
    let folder = Folder::new().with("t.obj", format!("{SQUARE}what\n"));
    let text = folder.done(&format!("bench t.obj --edges --threads 1 {SMALL}")).text();
    assert!(text.starts_with("t.obj: 64×48 pixels, 1 thread\n"), "{text}");
    for line in [
        "  model       t.obj: OBJ, 1 part, 4 vertices, 2 triangles\n",
        "              skipped 1 unknown statement (at line 6)\n",
        "  triangles   2, 2 drawn\n",
        "  edges       4, 4 drawn\n",
        "  frames      3, after ",
    ] {
        assert!(text.contains(line), "{line:?}: {text}");
    }
    for what in ["median", "spread", "speed", "memset", "fingerprint"] {
        assert!(text.lines().any(|line| line.trim_start().starts_with(what)), "{what}: {text}");
    }
    for unit in [" ms", " frames/s", " million triangles/s", " million pixels/s", " GB/s", " %"] {
        assert!(text.contains(unit), "{unit}: {text}");
    }
    let both = folder.done(&format!("bench shape:cube shape:cone {SMALL}")).text();
    assert!(both.starts_with("shape:cube and 1 other: 64×48 pixels, "), "{both}");
}

#[test]
fn without_a_model_the_built_in_scene_is_drawn() {
    let folder = Folder::new();
    let value = json(&folder, SMALL);
    assert_eq!(value["models"], serde_json::json!([]));
    assert!(number(&value, "triangles") > 10_000.0 && number(&value, "edges") > 0.0, "{value}");
    assert!(folder.done(&format!("bench {SMALL}")).text().starts_with("built-in scene: 64×48 pixels, "));
    // Wire is no surface: its triangles are not drawn, and not counted.
    let wire = json(&folder, &format!("--wire {SMALL}"));
    assert_eq!((&wire["triangles"], number(&wire, "mtri_per_s")), (&0.into(), 0.0));
    assert!(number(&wire, "edges") > number(&value, "edges"));
    assert!(folder.names().is_empty());
}

#[test]
fn as_many_frames_are_timed_as_were_asked_for_and_50_without() {
    let folder = Folder::new();
    for (option, frames) in [("", 50), ("--frames 1", 1), ("--frames 123", 123)] {
        let value = json(&folder, &format!("shape:cube --resolution 8,8 --threads 1 {option}"));
        assert_eq!(value["frames"], frames);
    }
}

#[test]
fn a_bench_of_nothing_says_why() {
    let folder = Folder::new().with("square.obj", SQUARE);
    let away = format!("square.obj --camera-position 5,2.5,22 --camera-direction 0,0,1 {SMALL}");
    for more in ["", "--background none", "--background none --samples 4"] {
        let value = json(&folder, &format!("{away} {more}"));
        let note = value["notes"][0].as_str().unwrap();
        assert!(note.starts_with("nothing to see: all 2 triangles outside"), "{more}: {note}");
        assert!(
            folder.done(&format!("bench {away} {more}")).text().contains("  note        nothing to see: ")
        );
    }
}

#[test]
fn standard_input_and_notes_of_models_are_as_with_render() {
    let folder = Folder::new();
    let said = folder.run_with(&format!("bench - {SMALL}"), SQUARE.as_bytes());
    assert_eq!(said.status, Some(0), "{said:?}");
    assert!(said.text().starts_with("standard input: 64×48"), "{said:?}");
    let model = format!("mtllib m.mtl\nusemtl missing\n{SQUARE}");
    let folder = folder.with("m.obj", model).with("m.mtl", "newmtl a\nKd 1 1 1\n");
    let said = folder.run(&format!("bench m.obj {SMALL}"));
    assert!(said.stderr.starts_with("polosa: m.obj: note: ") && said.stderr.lines().count() == 1, "{said:?}");
    assert_eq!(folder.run(&format!("bench m.obj {SMALL} --json")).stderr, "", "they are in the report");
}
