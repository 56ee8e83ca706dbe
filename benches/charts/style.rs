//! One colour and one mark for each method, over all charts.
//!
//! Blue is what is exact by default. Of the others, those from one document have one colour: orange is the Java viewer
//! and its rewrite (S0, S3), green the report on strips (S4), purple and black are common practice.

use crate::chart::{Color, Mark};

/// How a method looks, and what is written beside its mark.
pub(crate) fn of(method: &str) -> (Color, Mark, String) {
    use Color::{Black, Blue, Green, Orange, Purple, Vermilion};
    use Mark::{Diamond, Disc, Ring, Square};
    let (color, mark) = match method {
        "frame" | "f32-reversed" | "icosahedron" => (Blue, Disc),
        "immediate" => (Vermilion, Square),
        "strips" | "exact" => (Blue, Diamond),
        "edges" => (Blue, Ring),
        "barycentric" | "power-2.4" | "tetrahedron" => (Orange, Square),
        "same-side" | "power-2.2" => (Orange, Diamond),
        "naive" => (Orange, Disc),
        "vertical-strips" | "strip-linear" | "octant" => (Green, Square),
        "vertical-strips-closed" => (Green, Diamond),
        "whole-pixels" | "f32-signed" => (Black, Diamond),
        "float-edges" | "plane-f32-origin" | "table-4096" | "f32-standard" => (Purple, Disc),
        "float-scan" | "plane-f32-vertex" | "table-65536" | "d24" => (Purple, Square),
        "d16" | "fast-srgb8" => (Green, Disc),
        "w-buffer-24" => (Orange, Diamond),
        _ => (Black, Square),
    };
    let name = match method {
        "frame" => "frame (the default)",
        "exact" => "exact (the default)",
        "f32-reversed" => "f32, reversed (the default)",
        other => other,
    };
    (color, mark, name.to_owned())
}
