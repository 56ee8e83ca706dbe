//! What `--stats` and `--json` tell about a turntable.

use std::fmt::Write as _;

use serde_json::{Value, json};

use super::Made;
use crate::cli::models::ModelFacts;
use crate::cli::report::{counts, milliseconds, projection, samples, stats, vector};
use crate::cli::words::counted;
use crate::error::one_line;

/// For people: some lines.
pub(super) fn text(made: &Made<'_>) -> String {
    let mut text = String::new();
    // Writing to a string does not fail.
    let _ = write_text(&mut text, made);
    text
}

fn write_text(text: &mut String, made: &Made<'_>) -> std::fmt::Result {
    let (settings, frames) = (made.settings, made.args.frames.get());
    writeln!(
        text,
        "{}: {} of {}×{} pixels, {} each, {} a second, {:.2} s",
        one_line(&made.to.name().to_string_lossy()),
        counted(frames as u64, "frame", "frames"),
        settings.width,
        settings.height,
        counted(samples(settings.samples), "sample", "samples"),
        made.args.fps,
        frames as f64 / made.args.fps
    )?;
    made.models.iter().for_each(|model| text.push_str(&model.lines()));
    writeln!(text, "  {:<12}{}, in the first frame", "triangles", counts(&made.stats.triangles))?;
    if made.stats.lines.submitted > 0 {
        writeln!(text, "  {:<12}{}, in the first frame", "edges", counts(&made.stats.lines))?;
    }
    writeln!(
        text,
        "  {:<12}read {:.1} ms, draw {:.1} ms, wait for encoding {:.1} ms",
        "time",
        milliseconds(made.read),
        milliseconds(made.draw),
        milliseconds(made.wait)
    )
}

/// For programs: one line of JSON.
pub(super) fn json(made: &Made<'_>) -> String {
    let models: Vec<Value> = made.models.iter().map(ModelFacts::json).collect();
    let value = json!({
        "output": made.to.name().to_string_lossy(),
        "width": made.settings.width,
        "height": made.settings.height,
        "samples": samples(made.settings.samples),
        "frames": made.args.frames.get(),
        "fps": made.args.fps,
        "models": models,
        "first": {
            "camera": {
                "position": vector(made.camera.position()),
                "direction": vector(made.camera.direction()),
                "up": vector(made.camera.up()),
                "projection": projection(&made.camera, made.args.view.camera_view_angle),
            },
            "triangles": stats(&made.stats.triangles),
            "edges": stats(&made.stats.lines),
        },
        "notes": made.notes,
        "milliseconds": {
            "read": milliseconds(made.read),
            "draw": milliseconds(made.draw),
            "wait": milliseconds(made.wait),
        },
    });
    format!("{value}\n")
}
