//! The values of options: texts become what they mean, or an error that shows how it is written.

use core::num::NonZeroUsize;
use std::ffi::OsString;
use std::path::{Path, PathBuf};

use clap::ValueEnum;
use clap::builder::{OsStringValueParser, TypedValueParser};
use polosa_math::glam::DVec3;
use polosa_scene::{Color, Samples, Shading};

pub(super) use crate::model::Model as ModelArg;
use crate::output::Destination;
use crate::record::LEAST_FPS;
use crate::view::Up;

/// Where an output goes, `{stem}` still in it.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) struct OutputArg(PathBuf);

impl OutputArg {
    /// The parser for clap.
    pub(super) fn parser() -> impl TypedValueParser<Value = Self> {
        OsStringValueParser::new().try_map(|text| {
            if text.is_empty() {
                Err("an empty name: name a file, or `-` for standard output")
            } else {
                Ok(Self(text.into()))
            }
        })
    }

    /// As it was written.
    #[must_use]
    pub(super) fn path(&self) -> &Path {
        &self.0
    }

    /// Whether it is standard output.
    #[must_use]
    pub(super) fn is_stdout(&self) -> bool {
        self.0.as_os_str() == "-"
    }

    /// Whether it has a place for the model's name.
    #[must_use]
    pub(super) fn has_stem(&self) -> bool {
        self.0.to_str().is_some_and(|text| text.contains(STEM))
    }

    /// The output for a model of this name.
    #[must_use]
    pub(super) fn with_stem(&self, stem: &OsString) -> Destination {
        if self.is_stdout() {
            return Destination::Stdout;
        }
        let Some(mut pieces) = self.0.to_str().map(|text| text.split(STEM)) else {
            return Destination::File(self.0.clone());
        };
        let mut name = OsString::from(pieces.next().unwrap_or_default());
        for piece in pieces {
            name.push(stem);
            name.push(piece);
        }
        Destination::File(name.into())
    }
}

/// The place for the model's name in an output's.
pub(super) const STEM: &str = "{stem}";

/// Three numbers, `X,Y,Z`.
pub(super) fn vector(text: &str) -> Result<DVec3, String> {
    let numbers: Option<Vec<f64>> = text.split(',').map(|part| part.trim().parse().ok()).collect();
    match numbers.as_deref() {
        Some(&[x, y, z]) if x.is_finite() && y.is_finite() && z.is_finite() => Ok(DVec3::new(x, y, z)),
        _ => Err("write three finite numbers, X,Y,Z, such as 1,0.7,-2".to_owned()),
    }
}

/// Three numbers of which one is not 0: a direction of any length.
pub(super) fn direction(text: &str) -> Result<DVec3, String> {
    let vector = vector(text)?;
    if vector == DVec3::ZERO {
        return Err("0,0,0 is no direction: at least one number must not be 0".to_owned());
    }
    Ok(vector)
}

/// A finite number.
pub(super) fn number(text: &str) -> Result<f64, String> {
    let finite = text.trim().parse().ok().filter(|number: &f64| number.is_finite());
    finite.ok_or_else(|| "write a finite number".to_owned())
}

/// An angle of view in degrees, in (0, 180).
pub(super) fn view_angle(text: &str) -> Result<f64, String> {
    let inside = number(text).ok().filter(|angle| 0.0 < *angle && *angle < 180.0);
    inside.ok_or_else(|| "write degrees, more than 0 and less than 180".to_owned())
}

/// A length, more than 0.
pub(super) fn length(text: &str) -> Result<f64, String> {
    let positive = number(text).ok().filter(|length| *length > 0.0);
    positive.ok_or_else(|| "write a length in world units, more than 0".to_owned())
}

/// A share, 0 to 1.
pub(super) fn share(text: &str) -> Result<f32, String> {
    let share = text.trim().parse().ok().filter(|share: &f32| (0.0..=1.0).contains(share));
    share.ok_or_else(|| "write a number from 0 to 1".to_owned())
}

/// Width and height of a picture, not yet held against what is possible.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Resolution {
    /// Pixels from left to right.
    pub(super) width: u64,
    /// Pixels from top to bottom.
    pub(super) height: u64,
}

/// Two whole numbers, `W,H` or `WxH`.
pub(super) fn resolution(text: &str) -> Result<Resolution, String> {
    let side = |text: &str| {
        let text = text.trim();
        let digits = !text.is_empty() && text.bytes().all(|byte| byte.is_ascii_digit());
        // More digits than a number has room for are far too many pixels, not a wrong notation.
        digits.then(|| text.parse().unwrap_or(u64::MAX))
    };
    let sides = text.split_once([',', 'x']).map(|(width, height)| (side(width), side(height)));
    match sides {
        Some((Some(width), Some(height))) => Ok(Resolution { width, height }),
        _ => Err("write width and height in pixels, W,H, such as 1920,1080".to_owned()),
    }
}

/// A background: a colour, or nothing.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Background {
    /// Transparent.
    Nothing,
    /// Filled.
    Color(Color),
}

/// A colour, or `none`.
pub(super) fn background(text: &str) -> Result<Background, String> {
    if text.eq_ignore_ascii_case("none") {
        return Ok(Background::Nothing);
    }
    text.parse().map(Background::Color).map_err(|error| format!("{error}, or none for a transparent picture"))
}

/// The number of samples of a pixel.
pub(super) fn samples(text: &str) -> Result<Samples, String> {
    match text.trim() {
        "1" => Ok(Samples::One),
        "4" => Ok(Samples::Four),
        "16" => Ok(Samples::Sixteen),
        _ => Err("a pixel has 1, 4 or 16 samples".to_owned()),
    }
}

/// The most threads that can be asked for.
const MOST_THREADS: u64 = 256;

/// A number of threads.
pub(super) fn threads(text: &str) -> Result<NonZeroUsize, String> {
    let threads = whole(text, MOST_THREADS).and_then(|count| NonZeroUsize::new(count as usize));
    threads.ok_or_else(|| format!("write a whole number of threads, from 1 to {MOST_THREADS}"))
}

/// The most frames that can be asked for.
const MOST_FRAMES: u64 = 1_000_000;

/// A number of frames.
pub(super) fn frames(text: &str) -> Result<NonZeroUsize, String> {
    let frames = whole(text, MOST_FRAMES).and_then(|count| NonZeroUsize::new(count as usize));
    frames.ok_or_else(|| format!("write a whole number of frames, from 1 to {MOST_FRAMES}"))
}

/// Frames a second.
pub(super) fn fps(text: &str) -> Result<f64, String> {
    let fps = number(text).ok().filter(|fps| (LEAST_FPS..=MOST_FRAMES as f64).contains(fps));
    fps.ok_or_else(|| format!("write frames a second, from {LEAST_FPS} to {MOST_FRAMES}"))
}

/// The largest difference that is let pass.
pub(super) fn threshold(text: &str) -> Result<f64, String> {
    let threshold = number(text).ok().filter(|threshold| *threshold >= 0.0);
    threshold.ok_or_else(|| "write a number, 0 or more".to_owned())
}

/// A number of pixels.
pub(super) fn pixels(text: &str) -> Result<u64, String> {
    whole(text, u64::MAX).ok_or_else(|| "write a whole number of pixels, 0 or more".to_owned())
}

/// A whole number, up to `most`.
fn whole(text: &str, most: u64) -> Option<u64> {
    text.trim().parse().ok().filter(|count| *count <= most)
}

/// An axis: `+Y`, `-Z`, `X`, …
pub(super) fn up(text: &str) -> Result<Up, String> {
    match text.to_ascii_uppercase().as_str() {
        "X" | "+X" => Ok(Up::PlusX),
        "-X" => Ok(Up::MinusX),
        "Y" | "+Y" => Ok(Up::PlusY),
        "-Y" => Ok(Up::MinusY),
        "Z" | "+Z" => Ok(Up::PlusZ),
        "-Z" => Ok(Up::MinusZ),
        _ => Err("write an axis: +X, -X, +Y, -Y, +Z or -Z".to_owned()),
    }
}

/// How surfaces are shaded.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub(super) enum ShadingArg {
    /// Colours are written as the file has them
    Unlit,
    /// Each triangle by the direction that its plane faces
    Flat,
}

impl From<ShadingArg> for Shading {
    fn from(arg: ShadingArg) -> Self {
        match arg {
            ShadingArg::Unlit => Self::Unlit,
            ShadingArg::Flat => Self::Flat,
        }
    }
}

/// Which sides of surfaces are left out.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub(super) enum CullArg {
    /// Both sides are drawn
    None,
    /// Without those that face away from the viewer
    Back,
    /// Without those that face the viewer
    Front,
}

impl From<CullArg> for polosa_raster::Cull {
    fn from(arg: CullArg) -> Self {
        match arg {
            CullArg::None => Self::None,
            CullArg::Back => Self::Back,
            CullArg::Front => Self::Front,
        }
    }
}

#[cfg(test)]
mod tests {
    use std::ffi::OsString;
    use std::path::PathBuf;

    use polosa_math::glam::DVec3;

    use super::{
        ModelArg, OutputArg, Resolution, direction, fps, frames, length, pixels, resolution, threads,
        threshold, up, vector, view_angle,
    };
    use crate::output::Destination;
    use crate::view::Up;

    #[test]
    fn texts_become_values_or_say_how_they_are_written() {
        assert_eq!(vector(" -1, 2.5,1e3 "), Ok(DVec3::new(-1.0, 2.5, 1000.0)));
        for text in ["", "1,2", "1,2,3,4", "1,2,x", "nan,0,0", "inf,0,0", "1;2;3"] {
            assert!(vector(text).unwrap_err().contains("X,Y,Z"), "{text}");
        }
        assert!(direction("0,-0,0").is_err());
        assert_eq!(resolution("640x480"), Ok(Resolution { width: 640, height: 480 }));
        assert_eq!(resolution("1,99999999999999999999999").map(|r| r.height), Ok(u64::MAX));
        for text in ["640", "640,", "-1,5", "+1,5", "1.5,2", "1,2,3"] {
            assert!(resolution(text).unwrap_err().contains("W,H"), "{text}");
        }
        assert!(view_angle("0").is_err() && view_angle("180").is_err() && view_angle("179.9").is_ok());
        assert!(length("0").is_err() && length("-1").is_err() && length("1e-9").is_ok());
        assert_eq!(threads(" 256 ").map(usize::from), Ok(256));
        assert_eq!(frames("1000000").map(usize::from), Ok(1_000_000));
        for text in ["", "0", "-1", "1.5", "2e1", "257", "99999999999999999999999"] {
            assert!(threads(text).unwrap_err().contains("from 1 to 256"), "{text}");
        }
        assert_eq!((fps("23.976"), fps("0.001")), (Ok(23.976), Ok(0.001)));
        for text in ["", "0", "-1", "x", "nan", "inf", "1e-9", "1e99"] {
            assert!(fps(text).unwrap_err().contains("from 0.001 to 1000000"), "{text}");
        }
        assert_eq!((threshold("2.5"), pixels("0")), (Ok(2.5), Ok(0)));
        for text in ["", "-1", "x", "nan", "inf"] {
            assert!(threshold(text).is_err() && pixels(text).is_err(), "{text}");
        }
        assert!(pixels("1.5").unwrap_err().contains("whole number"));
        for text in ["", "0", "-1", "1.5", "1000001", "99999999999999999999999"] {
            assert!(frames(text).unwrap_err().contains("from 1 to 1000000"), "{text}");
        }
    }

    #[test]
    fn every_axis_can_be_up_and_turns_keep_handedness() {
        let axes = [
            ("+X", DVec3::X),
            ("-x", -DVec3::X),
            ("Y", DVec3::Y),
            ("-Y", -DVec3::Y),
            ("z", DVec3::Z),
            ("-Z", -DVec3::Z),
        ];
        for (text, axis) in axes {
            let up: Up = up(text).unwrap();
            assert_eq!(up.axis(), axis, "{text}");
            let [x, y, z] = [DVec3::X, DVec3::Y, DVec3::Z].map(|v| up.turned(v));
            assert_eq!(x.cross(y), z, "{text}");
        }
        assert!(up("+W").is_err());
    }

    #[test]
    fn stems_name_models() {
        let stem = |text: &str| ModelArg::parse(text.into()).unwrap().stem();
        assert_eq!(stem("a/b.c.obj"), "b.c");
        assert_eq!(stem("-"), "stdin");
        assert_eq!(stem("shape:sphere:3"), "sphere-octahedron-3");
        let output = OutputArg("out/{stem}-{stem}.png".into());
        assert!(output.has_stem());
        assert_eq!(output.with_stem(&OsString::from("x")), Destination::File(PathBuf::from("out/x-x.png")));
        assert_eq!(OutputArg("-".into()).with_stem(&OsString::from("x")), Destination::Stdout);
    }
}
