//! Why a shape is not made.

use std::ops::RangeInclusive;

use super::Shape;
use crate::MeshError;
use crate::subdivide::{MOST_TRIANGLES, SubdivideError};

/// Why a shape is not made, or a text names none.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[non_exhaustive]
pub enum ShapeError {
    /// No shape has this name.
    #[error("there is no shape `{0}`: use one of {usages}", usages = usages())]
    Unknown(String),
    /// The shape exists, but its parameters are not such numbers or names.
    #[error("`{text}` has unknown parameters: write {usage}, whole numbers; known shapes are {usages}", usages = usages())]
    Parameters {
        /// What was written.
        text: String,
        /// What would be right.
        usage: String,
    },
    /// A parameter is too small or too large.
    #[error("{shape}: {parameter} is {given}, but must be from {least} to {most}")]
    Range {
        /// The shape's name.
        shape: &'static str,
        /// The parameter's name.
        parameter: &'static str,
        /// Its value.
        given: u32,
        /// The least value.
        least: u32,
        /// The greatest value.
        most: u32,
    },
    /// The parameters multiply to too many triangles.
    #[error("{shape}: {triangles} triangles are more than {MOST_TRIANGLES}: use smaller {parameters}")]
    TooLarge {
        /// The shape's name.
        shape: &'static str,
        /// How many triangles it would have.
        triangles: u64,
        /// The names of the parameters that make the number.
        parameters: &'static str,
    },
    /// Subdivision refused.
    #[error(transparent)]
    Subdivide(#[from] SubdivideError),
    /// The parts make no mesh.
    #[error(transparent)]
    Mesh(#[from] MeshError),
}

/// All shapes with their parameters, in one line.
fn usages() -> String {
    Shape::all().iter().map(|info| format!("{}{}", info.name, info.parameters)).collect::<Vec<_>>().join(", ")
}

/// A text from outside as an error repeats it: short.
pub(super) fn excerpt(text: &str) -> String {
    text.chars().take(40).collect()
}

/// Refuses a parameter that is out of its range.
pub(super) fn within(
    shape: &'static str,
    parameter: &'static str,
    given: u32,
    range: RangeInclusive<u32>,
) -> Result<(), ShapeError> {
    let (least, most) = range.into_inner();
    if (least..=most).contains(&given) {
        Ok(())
    } else {
        Err(ShapeError::Range { shape, parameter, given, least, most })
    }
}

/// Refuses more triangles than [`MOST_TRIANGLES`], else hands the number on.
pub(super) fn fits(shape: &'static str, parameters: &'static str, triangles: u64) -> Result<u64, ShapeError> {
    if triangles <= MOST_TRIANGLES {
        Ok(triangles)
    } else {
        Err(ShapeError::TooLarge { shape, triangles, parameters })
    }
}
