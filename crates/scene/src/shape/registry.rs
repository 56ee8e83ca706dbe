//! All shapes by name, as the command line and a menu need them.

use core::fmt;
use core::str::FromStr;

use super::error::{ShapeError, excerpt};
use super::{Solid, cone, cylinder, plane, seed_tetrahedron, sphere, teapot, torus, uv_sphere};
use super::{cube, icosahedron, octahedron, pyramid, tetrahedron};
use crate::Mesh;

/// A standard shape with its parameters.
///
/// As text a name and its parameters, separated by colons; what is left out at the end takes its default:
/// `teapot`, `teapot:8`, `sphere:5`, `sphere:icosahedron:4`, `uv-sphere:64:32`. [`Display`](fmt::Display) writes
/// all parameters.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[non_exhaustive]
pub enum Shape {
    /// [`tetrahedron`].
    Tetrahedron,
    /// [`cube`].
    Cube,
    /// [`octahedron`].
    Octahedron,
    /// [`icosahedron`].
    Icosahedron,
    /// [`sphere`].
    Sphere {
        /// What it is subdivided from.
        base: Solid,
        /// How often.
        level: u32,
    },
    /// [`uv_sphere`].
    UvSphere {
        /// Slices around the axis.
        segments: u32,
        /// Bands from pole to pole.
        rings: u32,
    },
    /// [`plane`].
    Plane {
        /// Squares along each side.
        cells: u32,
    },
    /// [`cylinder`].
    Cylinder {
        /// Flat sides around the axis.
        segments: u32,
    },
    /// [`cone`].
    Cone {
        /// Flat sides around the axis.
        segments: u32,
    },
    /// [`torus`].
    Torus {
        /// Pieces around the axis.
        segments: u32,
        /// Sides around the tube.
        sides: u32,
    },
    /// [`teapot`].
    Teapot {
        /// Quadrilaterals along each side of a patch.
        segments: u32,
    },
    /// [`pyramid`].
    Pyramid,
    /// [`seed_tetrahedron`].
    SeedTetrahedron {
        /// How often it is inflated.
        level: u32,
    },
}

/// A line of the list of all shapes.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub struct ShapeInfo {
    /// Its name in texts.
    pub name: &'static str,
    /// Its parameters, in the notation of usage lines: `[:BASE][:LEVEL]`; empty if it has none.
    pub parameters: &'static str,
    /// One line about it.
    pub description: &'static str,
    /// What the name alone means.
    pub default: Shape,
}

const fn info(
    name: &'static str,
    parameters: &'static str,
    description: &'static str,
    default: Shape,
) -> ShapeInfo {
    ShapeInfo { name, parameters, description, default }
}

const ALL: [ShapeInfo; 13] = [
    info("tetrahedron", "", "regular tetrahedron over corners of the cube", Shape::Tetrahedron),
    info("cube", "", "cube from -1 to 1", Shape::Cube),
    info("octahedron", "", "regular octahedron of radius 1", Shape::Octahedron),
    info("icosahedron", "", "regular icosahedron of radius 1", Shape::Icosahedron),
    info(
        "sphere",
        "[:BASE][:LEVEL]",
        "sphere subdivided LEVEL times from BASE: tetrahedron, cube, octahedron or icosahedron",
        Shape::Sphere { base: Solid::Octahedron, level: 5 },
    ),
    info(
        "uv-sphere",
        "[:SEGMENTS[:RINGS]]",
        "sphere of SEGMENTS slices and RINGS bands from pole to pole",
        Shape::UvSphere { segments: 64, rings: 32 },
    ),
    info("plane", "[:CELLS]", "horizontal square of CELLS by CELLS squares", Shape::Plane { cells: 1 }),
    info("cylinder", "[:SEGMENTS]", "closed cylinder of SEGMENTS sides", Shape::Cylinder { segments: 48 }),
    info("cone", "[:SEGMENTS]", "closed cone of SEGMENTS sides", Shape::Cone { segments: 48 }),
    info(
        "torus",
        "[:SEGMENTS[:SIDES]]",
        "ring of SEGMENTS pieces, its tube of SIDES sides",
        Shape::Torus { segments: 64, sides: 32 },
    ),
    info(
        "teapot",
        "[:SEGMENTS]",
        "Utah teapot, its 32 Bezier patches in SEGMENTS by SEGMENTS quadrilaterals",
        Shape::Teapot { segments: 10 },
    ),
    info("pyramid", "", "pyramid OABCD over a square", Shape::Pyramid),
    info(
        "seed-tetrahedron",
        "[:LEVEL]",
        "tetrahedron with white, red, green and blue faces, inflated LEVEL times",
        Shape::SeedTetrahedron { level: 0 },
    ),
];

impl Shape {
    /// All shapes: names, parameters, descriptions, defaults.
    #[must_use]
    pub const fn all() -> &'static [ShapeInfo] {
        &ALL
    }

    /// The shape's line in the list.
    fn info(&self) -> &'static ShapeInfo {
        let kind = core::mem::discriminant(self);
        // Every kind is in the list, which a test checks; the first line stands in for nothing.
        ALL.iter().find(|info| core::mem::discriminant(&info.default) == kind).unwrap_or(&ALL[0])
    }

    /// How many triangles the shape has; nothing is made.
    ///
    /// # Errors
    ///
    /// As [`mesh`](Self::mesh).
    pub fn triangle_count(&self) -> Result<u64, ShapeError> {
        match *self {
            Self::Tetrahedron => Ok(4),
            Self::Cube => Ok(12),
            Self::Octahedron => Ok(8),
            Self::Icosahedron => Ok(20),
            Self::Pyramid => Ok(6),
            Self::Sphere { base, level } => sphere::count(base, level),
            Self::UvSphere { segments, rings } => uv_sphere::count(segments, rings),
            Self::Plane { cells } => plane::count(cells),
            Self::Cylinder { segments } => cylinder::count(segments),
            Self::Cone { segments } => cone::count(segments),
            Self::Torus { segments, sides } => torus::count(segments, sides),
            Self::Teapot { segments } => teapot::count(segments),
            Self::SeedTetrahedron { level } => seed_tetrahedron::count(level),
        }
    }

    /// The shape's mesh.
    ///
    /// # Errors
    ///
    /// When a parameter is out of its range, or the shape would have more triangles than
    /// [`MOST_TRIANGLES`](crate::subdivide::MOST_TRIANGLES).
    pub fn mesh(&self) -> Result<Mesh, ShapeError> {
        match *self {
            Self::Tetrahedron => Ok(tetrahedron()),
            Self::Cube => Ok(cube()),
            Self::Octahedron => Ok(octahedron()),
            Self::Icosahedron => Ok(icosahedron()),
            Self::Pyramid => Ok(pyramid()),
            Self::Sphere { base, level } => sphere(base, level),
            Self::UvSphere { segments, rings } => uv_sphere(segments, rings),
            Self::Plane { cells } => plane(cells),
            Self::Cylinder { segments } => cylinder(segments),
            Self::Cone { segments } => cone(segments),
            Self::Torus { segments, sides } => torus(segments, sides),
            Self::Teapot { segments } => teapot(segments),
            Self::SeedTetrahedron { level } => seed_tetrahedron(level),
        }
    }
}

impl FromStr for Shape {
    type Err = ShapeError;

    fn from_str(text: &str) -> Result<Self, ShapeError> {
        let (name, rest) = match text.split_once(':') {
            Some((name, rest)) => (name, Some(rest)),
            None => (text, None),
        };
        let info =
            ALL.iter().find(|info| info.name == name).ok_or_else(|| ShapeError::Unknown(excerpt(name)))?;
        let wrong = || ShapeError::Parameters {
            text: excerpt(text),
            usage: format!("{}{}", info.name, info.parameters),
        };

        let mut values: Vec<&str> = rest.map(|rest| rest.split(':').collect()).unwrap_or_default();
        let mut shape = info.default;
        if let Self::Sphere { base, .. } = &mut shape
            && let Some(solid) = values.first().and_then(|value| value.parse().ok())
        {
            *base = solid;
            values.remove(0);
        }
        let mut values = values.into_iter();
        for number in shape.numbers() {
            if let Some(value) = values.next() {
                // `parse` would take a sign.
                let digits = value.bytes().all(|byte| byte.is_ascii_digit());
                *number = value.parse().ok().filter(|_| digits).ok_or_else(wrong)?;
            }
        }
        if values.next().is_some() {
            return Err(wrong());
        }
        shape.triangle_count()?;
        Ok(shape)
    }
}

impl Shape {
    /// Its numbers, in the order in which texts have them.
    fn numbers(&mut self) -> impl Iterator<Item = &mut u32> {
        let [first, second] = match self {
            Self::Tetrahedron | Self::Cube | Self::Octahedron | Self::Icosahedron | Self::Pyramid => {
                [None, None]
            }
            Self::Sphere { level, .. } | Self::SeedTetrahedron { level } => [Some(level), None],
            Self::UvSphere { segments, rings: other } | Self::Torus { segments, sides: other } => {
                [Some(segments), Some(other)]
            }
            Self::Plane { cells: only }
            | Self::Cylinder { segments: only }
            | Self::Cone { segments: only }
            | Self::Teapot { segments: only } => [Some(only), None],
        };
        first.into_iter().chain(second)
    }
}

impl fmt::Display for Shape {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.info().name)?;
        if let Self::Sphere { base, .. } = self {
            write!(f, ":{base}")?;
        }
        let mut copy = *self;
        copy.numbers().try_for_each(|number| write!(f, ":{number}"))
    }
}
