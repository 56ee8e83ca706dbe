//! What should be in a picture and is not, in a line for the user.
//!
//! A picture of nothing is a good picture to the program and a riddle to whoever asked for it. The counts of the
//! drawing say where the faces were lost:
//!
//! ```text
//!   submitted ─▶ finite? ─▶ inside? ─▶ area? ─▶ side? ─▶ drawn ─▶ on a pixel? ─▶ another colour?
//!              not_finite   outside  degenerate culled           └──────── looked for here ────┘
//! ```

use polosa_math::glam::DVec2;
use polosa_raster::Stats;
use polosa_scene::{Camera, Picture, PictureSettings, World};

use super::args::CullArg;
use super::models::points;
use super::view_args::ViewArgs;
use super::words::counted;

/// The note about a picture, if it needs one: that it shows nothing, and why; else that it lacks something.
pub(super) fn note(
    args: &ViewArgs,
    settings: &PictureSettings,
    world: &World,
    camera: &Camera,
    picture: &Picture,
) -> Option<String> {
    if is_blank(settings, picture) {
        return Some(format!("nothing to see: {}", reasons(args, world, camera, picture)));
    }
    let count = picture.stats.triangles.not_finite + picture.stats.lines.not_finite;
    let verb = if count == 1 { "is" } else { "are" };
    (count > 0).then(|| {
        let what = counted(count, "face or edge", "faces or edges");
        // The vertices may be numbers and what the transformation makes of them not.
        format!("{what} with coordinates that are not finite, or too large to draw, {verb} left out")
    })
}

/// Whether no pixel differs from an empty picture's.
pub(super) fn is_blank(settings: &PictureSettings, picture: &Picture) -> bool {
    match (settings.background, &picture.alpha) {
        (Some(color), _) => picture.pixels.iter().all(|&pixel| pixel == color.to_u32()),
        (None, Some(alpha)) => alpha.iter().all(|&alpha| alpha == 0),
        (None, None) => false,
    }
}

/// Where the faces and edges were lost.
fn reasons(args: &ViewArgs, world: &World, camera: &Camera, picture: &Picture) -> String {
    let (triangles, lines) = (&picture.stats.triangles, &picture.stats.lines);
    if triangles.submitted + lines.submitted == 0 {
        return if args.wire { "the models have no edges" } else { "the models have no triangles" }
            .to_owned();
    }
    let mut reasons = Vec::new();
    for (stats, [one, many]) in [(triangles, ["triangle", "triangles"]), (lines, ["edge", "edges"])] {
        let Stats { not_finite, outside, degenerate, culled, drawn, .. } = *stats;
        let area = if one == "edge" { "length" } else { "area" };
        let side = if args.cull == CullArg::Front { "front" } else { "back" };
        for (count, what) in [
            (not_finite, "with coordinates that are not finite, or too large to draw".to_owned()),
            (outside, "outside of the view".to_owned()),
            (degenerate, format!("degenerate, without {area} as seen from here")),
            (culled, format!("left out by --cull {side}")),
            (drawn, drawn_unseen(world, camera, picture).to_owned()),
        ] {
            if count > 0 {
                let all = if count == stats.submitted && count > 1 { "all " } else { "" };
                reasons.push(format!("{all}{} {what}", counted(count, one, many)));
            }
        }
    }
    let lost = |of: fn(&Stats) -> u64| of(triangles) + of(lines) > 0;
    let advice = if lost(|stats| stats.outside + stats.drawn) {
        ": check --camera-position, --camera-focal-point and the other --camera options"
    } else if lost(|stats| stats.culled) {
        ": try --cull none"
    } else if lost(|stats| stats.degenerate) {
        ": look from elsewhere, or at what `polosa info` says"
    } else {
        ""
    };
    format!("{}{advice}", reasons.join(", "))
}

/// Why what was drawn is not to be seen.
fn drawn_unseen(world: &World, camera: &Camera, picture: &Picture) -> &'static str {
    let size = DVec2::new(f64::from(picture.width), f64::from(picture.height));
    let (mut least, mut most) = (DVec2::INFINITY, DVec2::NEG_INFINITY);
    for point in points(world) {
        let Some(seen) = camera.project_point(point, picture.width, picture.height) else {
            // Behind the eye: what is drawn of it may be anywhere.
            return "on no pixel or of the background's colour";
        };
        (least, most) = (least.min(DVec2::new(seen.x, seen.y)), most.max(DVec2::new(seen.x, seen.y)));
    }
    if most.cmplt(DVec2::ZERO).any() || least.cmpgt(size).any() {
        "beside the picture"
    } else if (most - least).max_element() < 1.0 {
        "smaller than a pixel"
    } else {
        "on no pixel or of the background's colour"
    }
}
