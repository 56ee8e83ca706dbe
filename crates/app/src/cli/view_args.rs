//! The options of every command that draws: how large, from where, in what light, by how many threads.

use core::num::NonZeroUsize;
use std::fmt::Write as _;
use std::path::Path;

use clap::Args;
use polosa_math::glam::DVec3;
use polosa_raster::MAX_SIDE;
use polosa_scene::{Color, Light, LightSpace, PictureSettings, Samples, Shape, Show, Style};

use super::args::{self, Background, CullArg, Resolution, ShadingArg};
use crate::error::Error;
use crate::view::{Lens, Up, View};

const CAMERA: &str = "Camera";
const LOOKS: &str = "Looks";
const LIGHT: &str = "Light";

// No doc comment: clap would take it for the help of the command that these options belong to.
#[derive(Debug, Args)]
pub(super) struct ViewArgs {
    /// Width and height in pixels, up to 16384 each
    #[arg(long, value_name = "W,H", default_value = "1024,768", value_parser = args::resolution)]
    pub(super) resolution: Resolution,

    /// Threads that draw, 1 to 256; the picture is the same with any number [default: as many as the machine runs
    /// at once]
    #[arg(long, value_name = "T", value_parser = args::threads, allow_hyphen_values = true)]
    pub(super) threads: Option<NonZeroUsize>,

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
}

impl ViewArgs {
    /// Refuses options that contradict each other where clap does not.
    pub(super) fn check(&self) -> Result<(), Error> {
        let (position, focal_point) = (self.camera_position, self.camera_focal_point);
        if position.is_some() && focal_point.is_some() && self.camera_direction.is_some() {
            return Err(Error::Usage(
                "--camera-position, --camera-focal-point and --camera-direction say twice where to look: leave one \
                 out"
                    .to_owned(),
            ));
        }
        if position.is_some() && position == focal_point {
            return Err(Error::Usage(
                "--camera-position and --camera-focal-point are one point, from which no direction follows: move one \
                 of them"
                    .to_owned(),
            ));
        }
        Ok(())
    }

    /// What picture is asked for, without distances and ids. `name` is what an error about it is said of.
    pub(super) fn settings(&self, name: &Path) -> Result<PictureSettings, Error> {
        let side = |side: u64| u32::try_from(side).ok().filter(|side| (1..=MAX_SIDE).contains(side));
        let Resolution { width, height } = self.resolution;
        let (Some(width), Some(height)) = (side(width), side(height)) else {
            return Err(Error::file(
                name,
                format!(
                    "--resolution {width},{height} is no possible picture: each side must have 1 to {MAX_SIDE} pixels"
                ),
            ));
        };
        Ok(PictureSettings {
            width,
            height,
            background: match self.background {
                Background::Nothing => None,
                Background::Color(color) => Some(color),
            },
            samples: self.samples,
            distances: false,
            ids: false,
            threads: self.threads,
        })
    }

    /// What is shown of a model.
    pub(super) fn show(&self) -> Show {
        match (self.wire, self.edges) {
            (true, _) => Show::Wire,
            (_, true) => Show::Both,
            _ => Show::Surface,
        }
    }

    /// Where it is seen from; `up` is the axis that the models have upward.
    pub(super) fn view(&self, up: Up) -> View {
        let lens = match (self.camera_orthographic, self.camera_height) {
            (false, _) => Lens::Perspective(self.camera_view_angle),
            (true, None) => Lens::Parallel,
            (true, Some(height)) => Lens::ParallelTo(height),
        };
        View {
            position: self.camera_position,
            focal_point: self.camera_focal_point,
            direction: self.camera_direction,
            view_up: self.camera_view_up,
            // A drawing to scale shows x and y, whatever the file's own upward axis is, unless told otherwise.
            up: if self.camera_height.is_some() { self.up.unwrap_or(Up::PlusY) } else { up },
            azimuth: self.camera_azimuth_angle,
            elevation: self.camera_elevation_angle,
            lens,
        }
    }

    /// The same for models that are still to be read: where from, and which axis is upward whatever they say.
    #[cfg(feature = "window")]
    pub(super) fn view_and_up(&self) -> (View, Option<Up>) {
        let view = self.view(self.up.unwrap_or(Up::PlusY));
        (view, if self.camera_height.is_some() { Some(view.up) } else { self.up })
    }

    /// Whether nobody asked for another background.
    #[cfg(feature = "window")]
    pub(super) fn has_default_background(&self) -> bool {
        self.background == Background::Color(Color::new(0x2b, 0x2b, 0x2b))
    }

    /// The light.
    pub(super) fn light(&self) -> Light {
        Light {
            direction: self.light.unwrap_or(Light::default().direction),
            space: if self.light_world { LightSpace::World } else { LightSpace::Camera },
            ambient: self.ambient,
        }
    }

    /// Shading, sides and colour.
    pub(super) fn style(&self) -> Style {
        Style { shading: self.shading.into(), cull: self.cull.into(), color: self.color, ..Style::default() }
    }
}

/// The shapes, from the library's own list, and a command's examples.
pub(super) fn after_help(examples: &str) -> String {
    let mut text = String::from("Shapes:\n");
    for info in Shape::all() {
        let usage = format!("shape:{}{}", info.name, info.parameters);
        // Writing to a string does not fail.
        let _ = writeln!(text, "  {usage:<32} {}", info.description);
    }
    text + "\nExamples:\n" + examples
}
