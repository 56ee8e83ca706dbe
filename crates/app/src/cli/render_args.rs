//! The options of `polosa render`.

use clap::Args;
use polosa_raster::reference::{Coverage, Hidden};
use polosa_scene::reference::{Methods, Shading};

use super::args::{ModelArg, OutputArg};
use super::methods;
use super::view_args::{ViewArgs, after_help};

const OTHER: &str = "Other outputs";
const METHODS: &str = "Methods for comparison";
/// What a picture by methods for comparison cannot have.
const EXACT_ALONE: [&str; 6] = ["edges", "wire", "samples", "threads", "depth_image", "id_image"];

/// Draws models as a picture
///
/// All models make one picture, each at its own coordinates. With {stem} in the output's name they make one
/// picture each; a failure then does not stop the rest, and the exit status is 1 at the end.
///
/// A MODEL is an OBJ (with MTL), STL, PLY, glTF or GLB file, `-` for standard input, or a standard shape: see
/// below. What a file is, its content decides. The same command writes the same bytes, always.
#[derive(Debug, Args)]
#[command(after_help = after_help(EXAMPLES), allow_hyphen_values = false)]
pub(super) struct RenderArgs {
    /// Files, `-` for standard input, or shapes such as shape:teapot
    #[arg(required = true, value_name = "MODEL", value_parser = ModelArg::parser())]
    pub(super) models: Vec<ModelArg>,

    /// The picture: .png, .bmp, .tga, .qoi, .ppm, .pnm, .jpg; `-` for PNG to standard output; {stem} in it for
    /// one picture a model, named after it. It is complete or not there
    #[arg(short, long, value_name = "OUT", value_parser = OutputArg::parser(), allow_hyphen_values = true)]
    pub(super) output: OutputArg,

    #[command(flatten)]
    pub(super) view: ViewArgs,

    /// Distances along the viewing axis in world units, +infinity where nothing is, as PFM
    #[arg(long, value_name = "OUT.pfm", value_parser = OutputArg::parser(), allow_hyphen_values = true, help_heading = OTHER)]
    pub(super) depth_image: Option<OutputArg>,

    /// The number of the triangle at each pixel plus one as 24-bit RGB, 0 where nothing is
    #[arg(long, value_name = "OUT.png", value_parser = OutputArg::parser(), allow_hyphen_values = true, help_heading = OTHER)]
    pub(super) id_image: Option<OutputArg>,

    /// How the pixels of a triangle are found. Any but the first is slower or wrong, and there to be compared with; S0
    /// to S4 are the five tutorials that polosa grew from (docs/seeds.md)
    #[arg(
        long, value_name = "NAME", value_parser = methods::of(Coverage::ALL, Coverage::name, Coverage::about),
        conflicts_with_all = EXACT_ALONE, help_heading = METHODS
    )]
    pub(super) fill: Option<Coverage>,

    /// How it is decided which triangle is seen
    #[arg(
        long, value_name = "NAME", value_parser = methods::of(Hidden::ALL, Hidden::name, Hidden::about),
        conflicts_with_all = EXACT_ALONE, help_heading = METHODS
    )]
    pub(super) hidden: Option<Hidden>,

    /// How a colour is shaded by an amount of light
    #[arg(
        long, value_name = "NAME", value_parser = methods::of(Shading::ALL, Shading::name, Shading::about),
        conflicts_with_all = EXACT_ALONE, help_heading = METHODS
    )]
    pub(super) shade: Option<Shading>,

    /// Reports counts and times: to standard output, or to standard error if the picture goes there
    #[arg(long, help_heading = OTHER)]
    pub(super) stats: bool,

    /// The same report as JSON, one line a picture
    #[arg(long, help_heading = OTHER)]
    pub(super) json: bool,
}

impl RenderArgs {
    /// The methods for comparison, if one is named.
    pub(super) fn methods(&self) -> Option<Methods> {
        let Self { fill, hidden, shade, .. } = *self;
        (fill.is_some() || hidden.is_some() || shade.is_some()).then(|| Methods {
            coverage: fill.unwrap_or_default(),
            hidden: hidden.unwrap_or_default(),
            shading: shade.unwrap_or_default(),
        })
    }
}

const EXAMPLES: &str = "  polosa render bunny.obj -o bunny.png --resolution 1920,1080 --samples 16
  polosa render part.stl -o part.png --camera-azimuth-angle 45 --edges
  polosa render floor.ply chair.glb -o room.png --light 1,2,3 --light-world
  polosa render *.stl -o 'thumbnails/{stem}.png' --resolution 256,256 --background none
  polosa render plan.obj -o plan.png --camera-orthographic --camera-height 256 --resolution 256,256
  polosa render shape:teapot -o painter.png --fill float-scan --hidden painter --shade power-2.4
  cat bunny.ply | polosa render - -o - > bunny.png";
