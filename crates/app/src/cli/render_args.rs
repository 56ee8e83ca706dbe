//! The options of `polosa render`.

use std::fmt::Write as _;

use clap::Args;
use polosa_math::glam::DVec3;
use polosa_scene::{Color, Samples, Shape};

use super::args::{self, Background, CullArg, ModelArg, OutputArg, Resolution, ShadingArg};
use crate::view::Up;

const CAMERA: &str = "Camera";
const LOOKS: &str = "Looks";
const LIGHT: &str = "Light";
const OTHER: &str = "Other outputs";

/// Draws models as a picture
///
/// All models make one picture, each at its own coordinates. With {stem} in the output's name they make one
/// picture each; a failure then does not stop the rest, and the exit status is 1 at the end.
///
/// A MODEL is an OBJ (with MTL), STL, PLY, glTF or GLB file, `-` for standard input, or a standard shape: see
/// below. What a file is, its content decides. The same command writes the same bytes, always.
#[derive(Debug, Args)]
#[command(after_help = after_help(), allow_hyphen_values = false)]
pub(super) struct RenderArgs {
    /// Files, `-` for standard input, or shapes such as shape:teapot
    #[arg(required = true, value_name = "MODEL", value_parser = ModelArg::parser())]
    pub(super) models: Vec<ModelArg>,

    /// The picture: .png, .bmp, .tga, .qoi, .ppm, .pnm, .jpg; `-` for PNG to standard output; {stem} in it for
    /// one picture a model, named after it. It is complete or not there
    #[arg(short, long, value_name = "OUT", value_parser = OutputArg::parser(), allow_hyphen_values = true)]
    pub(super) output: OutputArg,

    /// Width and height in pixels, up to 16384 each
    #[arg(long, value_name = "W,H", default_value = "1024,768", value_parser = args::resolution)]
    pub(super) resolution: Resolution,

    /// Where the camera stands [default: as far away as the model needs, with 5 % margin]
    #[arg(long, value_name = "X,Y,Z", value_parser = args::vector, allow_hyphen_values = true, help_heading = CAMERA)]
    pub(super) camera_position: Option<DVec3>,

    /// The point that it looks at and turns about, the picture's middle [default: the middle of the models, or of
    /// what is seen of them]
    #[arg(long, value_name = "X,Y,Z", value_parser = args::vector, allow_hyphen_values = true, help_heading = CAMERA)]
    pub(super) camera_focal_point: Option<DVec3>,

    /// Where it looks, away from the observer [default: -1,-0.7,-1 for +Y upward]
    #[arg(long, value_name = "X,Y,Z", value_parser = args::direction, allow_hyphen_values = true, help_heading = CAMERA)]
    pub(super) camera_direction: Option<DVec3>,

    /// What the picture has upward [default: the axis of --up]
    #[arg(long, value_name = "X,Y,Z", value_parser = args::direction, allow_hyphen_values = true, help_heading = CAMERA)]
    pub(super) camera_view_up: Option<DVec3>,

    /// Goes round the focal point to the right, in degrees
    #[arg(
        long, value_name = "D", default_value = "0", value_parser = args::number, allow_hyphen_values = true,
        help_heading = CAMERA
    )]
    pub(super) camera_azimuth_angle: f64,

    /// Rises over the focal point, in degrees
    #[arg(
        long, value_name = "D", default_value = "0", value_parser = args::number, allow_hyphen_values = true,
        help_heading = CAMERA
    )]
    pub(super) camera_elevation_angle: f64,

    /// Vertical angle of view, in degrees
    #[arg(
        long, value_name = "D", default_value = "30", value_parser = args::view_angle, allow_hyphen_values = true,
        conflicts_with = "camera_orthographic", help_heading = CAMERA
    )]
    pub(super) camera_view_angle: f64,

    /// Parallel projection: things keep their size whatever the distance
    #[arg(long, help_heading = CAMERA)]
    pub(super) camera_orthographic: bool,

    /// With --camera-orthographic: world units from the lower to the upper edge, so that the picture is to scale.
    /// Its middle is then the world's origin and it looks along -Z, unless other options say otherwise; with
    /// --camera-height 256 --resolution 256,256 a unit is a pixel
    #[arg(
        long, value_name = "H", value_parser = args::length, allow_hyphen_values = true,
        requires = "camera_orthographic", help_heading = CAMERA
    )]
    pub(super) camera_height: Option<f64>,

    /// The axis that is upward: +X, -X, +Y, -Y, +Z, -Z [default: +Z for STL alone, else +Y]
    #[arg(long, value_name = "AXIS", value_parser = args::up, allow_hyphen_values = true, help_heading = CAMERA)]
    pub(super) up: Option<Up>,

    /// How surfaces are shaded
    #[arg(long, value_enum, default_value = "flat", help_heading = LOOKS)]
    pub(super) shading: ShadingArg,

    /// Draws the edges over the surface: the sides of the file's polygons, else of the triangles
    #[arg(short, long, help_heading = LOOKS)]
    pub(super) edges: bool,

    /// Draws the edges alone
    #[arg(long, conflicts_with = "edges", help_heading = LOOKS)]
    pub(super) wire: bool,

    /// Which sides of surfaces are left out
    #[arg(long, value_enum, default_value = "none", help_heading = LOOKS)]
    pub(super) cull: CullArg,

    /// The colour of what has none of its own: #RRGGBB, #RGB, R,G,B or a CSS basic name
    #[arg(long, value_name = "C", default_value = "#cccccc", help_heading = LOOKS)]
    pub(super) color: Color,

    /// The colour behind everything, or none for a transparent picture
    #[arg(long, value_name = "C", default_value = "#2b2b2b", value_parser = args::background, help_heading = LOOKS)]
    pub(super) background: Background,

    /// Samples of a pixel, 1, 4 or 16: more make smoother edges
    #[arg(long, value_name = "N", default_value = "1", value_parser = args::samples, help_heading = LOOKS)]
    pub(super) samples: Samples,

    /// From the object towards the light: X to the right, Y upward, Z towards the observer [default: 0,0,1]
    #[arg(long, value_name = "X,Y,Z", value_parser = args::direction, allow_hyphen_values = true, help_heading = LIGHT)]
    pub(super) light: Option<DVec3>,

    /// Takes --light in the world's coordinates instead of the camera's
    #[arg(long, requires = "light", help_heading = LIGHT)]
    pub(super) light_world: bool,

    /// The share of light that reaches every side, 0 to 1
    #[arg(
        long, value_name = "A", default_value = "0.1", value_parser = args::share, allow_hyphen_values = true,
        help_heading = LIGHT
    )]
    pub(super) ambient: f32,

    /// Distances along the viewing axis in world units, +infinity where nothing is, as PFM
    #[arg(long, value_name = "OUT.pfm", value_parser = OutputArg::parser(), allow_hyphen_values = true, help_heading = OTHER)]
    pub(super) depth_image: Option<OutputArg>,

    /// The number of the triangle at each pixel plus one as 24-bit RGB, 0 where nothing is
    #[arg(long, value_name = "OUT.png", value_parser = OutputArg::parser(), allow_hyphen_values = true, help_heading = OTHER)]
    pub(super) id_image: Option<OutputArg>,

    /// Reports counts and times: to standard output, or to standard error if the picture goes there
    #[arg(long, help_heading = OTHER)]
    pub(super) stats: bool,

    /// The same report as JSON, one line a picture
    #[arg(long, help_heading = OTHER)]
    pub(super) json: bool,
}

/// The shapes, from the library's own list, and examples.
pub(super) fn after_help() -> String {
    let mut text = String::from("Shapes:\n");
    for info in Shape::all() {
        let usage = format!("shape:{}{}", info.name, info.parameters);
        // Writing to a string does not fail.
        let _ = writeln!(text, "  {usage:<32} {}", info.description);
    }
    text += "\n\
Examples:
  polosa render bunny.obj -o bunny.png --resolution 1920,1080 --samples 16
  polosa render part.stl -o part.png --camera-azimuth-angle 45 --edges
  polosa render floor.ply chair.glb -o room.png --light 1,2,3 --light-world
  polosa render *.stl -o 'thumbnails/{stem}.png' --resolution 256,256 --background none
  polosa render plan.obj -o plan.png --camera-orthographic --camera-height 256 --resolution 256,256
  cat bunny.ply | polosa render - -o - > bunny.png";
    text
}
