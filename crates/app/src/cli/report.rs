//! What `--stats` and `--json` tell about a picture.

use std::fmt::Write as _;
use std::time::Duration;

use polosa_math::glam::DVec3;
use polosa_raster::Stats;
use polosa_scene::reference::Methods;
use polosa_scene::{Camera, Projection, Samples};
use serde_json::{Value, json};

use super::models::ModelFacts;
use super::render::Made;
use super::words::counted;
use crate::error::one_line;

/// For people: some lines.
pub(super) fn text(made: &Made<'_>) -> String {
    let mut text = String::new();
    // Writing to a string does not fail.
    let _ = write_text(&mut text, made);
    text
}

fn write_text(text: &mut String, made: &Made<'_>) -> std::fmt::Result {
    let settings = made.settings;
    writeln!(
        text,
        "{}: {}×{} pixels, {} each",
        one_line(&made.job.picture.0.name().to_string_lossy()),
        settings.width,
        settings.height,
        counted(samples(settings.samples), "sample", "samples")
    )?;
    let Methods { coverage, hidden, shading } = made.methods;
    if made.methods != Methods::default() {
        writeln!(text, "  {:<12}fill {coverage}, hidden {hidden}, shade {shading}", "methods")?;
    }
    made.models.iter().for_each(|model| text.push_str(&model.lines()));
    writeln!(text, "  {:<12}{}", "objects", made.stats.objects)?;
    writeln!(text, "  {:<12}{}", "triangles", counts(&made.stats.triangles))?;
    if made.stats.lines.submitted > 0 {
        writeln!(text, "  {:<12}{}", "edges", counts(&made.stats.lines))?;
    }
    writeln!(
        text,
        "  {:<12}read {:.1} ms, draw {:.1} ms, write {:.1} ms",
        "time",
        milliseconds(made.read),
        milliseconds(made.draw),
        milliseconds(made.write)
    )
}

/// Counts that are not zero, in the order in which triangles are lost.
pub(super) fn counts(stats: &Stats) -> String {
    let mut text = format!("{} submitted", stats.submitted);
    for (name, count) in named(stats) {
        if count > 0 || name == "drawn" {
            text += &format!(", {count} {}", name.replace('_', " "));
        }
    }
    text
}

fn named(stats: &Stats) -> [(&'static str, u64); 7] {
    [
        ("not_finite", stats.not_finite),
        ("bad_index", stats.bad_index),
        ("outside", stats.outside),
        ("degenerate", stats.degenerate),
        ("culled", stats.culled),
        ("clipped", stats.clipped),
        ("drawn", stats.drawn),
    ]
}

/// For programs: one line of JSON.
pub(super) fn json(made: &Made<'_>) -> String {
    let name = |to: &crate::output::Destination| to.name().to_string_lossy().into_owned();
    let models: Vec<Value> = made.models.iter().map(ModelFacts::json).collect();
    let value = json!({
        "output": name(&made.job.picture.0),
        "depth_image": made.job.depth.as_ref().map(name),
        "id_image": made.job.ids.as_ref().map(|(to, _)| name(to)),
        "width": made.settings.width,
        "height": made.settings.height,
        "samples": samples(made.settings.samples),
        "fill": made.methods.coverage.name(),
        "hidden": made.methods.hidden.name(),
        "shade": made.methods.shading.name(),
        "models": models,
        "bounds": bounds(&made.bounds),
        "camera": {
            "position": vector(made.camera.position()),
            "direction": vector(made.camera.direction()),
            "up": vector(made.camera.up()),
            "projection": projection(&made.camera, made.view_angle),
        },
        "objects": made.stats.objects,
        "triangles": stats(&made.stats.triangles),
        "edges": stats(&made.stats.lines),
        "notes": made.notes,
        "milliseconds": {
            "read": milliseconds(made.read),
            "draw": milliseconds(made.draw),
            "write": milliseconds(made.write),
        },
    });
    format!("{value}\n")
}

pub(super) fn stats(stats: &Stats) -> Value {
    let mut object = serde_json::Map::new();
    object.insert("submitted".to_owned(), stats.submitted.into());
    object.extend(named(stats).map(|(name, count)| (name.to_owned(), count.into())));
    object.into()
}

/// A box as its corners; null if there is none.
pub(super) fn bounds(bounds: &polosa_math::Bounds) -> Value {
    if bounds.is_empty() {
        return Value::Null;
    }
    json!({ "min": vector(bounds.min()), "max": vector(bounds.max()), "size": vector(bounds.size()) })
}

pub(super) fn vector(v: DVec3) -> Value {
    // −0 + 0 is 0; everything else stays.
    json!((v + DVec3::ZERO).to_array())
}

/// The angle is the one that was asked for: degrees that have been radians may come back with another last digit.
pub(super) fn projection(camera: &Camera, view_angle: f64) -> Value {
    match camera.projection() {
        Projection::Perspective { near, .. } => {
            json!({ "kind": "perspective", "view_angle": view_angle, "near": near })
        }
        Projection::Orthographic { height, near, far } => {
            json!({ "kind": "orthographic", "height": height, "near": near, "far": far })
        }
        // No option makes another one.
        _ => Value::Null,
    }
}

pub(super) const fn samples(samples: Samples) -> u64 {
    match samples {
        Samples::One => 1,
        Samples::Four => 4,
        Samples::Sixteen => 16,
    }
}

pub(super) fn milliseconds(time: Duration) -> f64 {
    (time.as_secs_f64() * 1e5).round() / 1e2
}
