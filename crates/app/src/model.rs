//! Models: from a name to parts, and from parts to a world's objects.

use std::ffi::OsString;
use std::io::Read as _;
use std::path::{Path, PathBuf};

use clap::builder::{OsStringValueParser, TypedValueParser};
use polosa_math::Placement;
use polosa_math::glam::DVec3;
use polosa_scene::import::{self, Format, MAX_FILE, Part, Skipped};
use polosa_scene::{Mesh, Object, Shape, Show, World};

use crate::error::Error;
use crate::guard::caught;
use crate::view::Up;

/// What is drawn or told about.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Model {
    /// A file.
    File(PathBuf),
    /// Standard input.
    Stdin,
    /// A standard shape.
    Shape(Shape),
}

impl Model {
    /// The parser for clap; names of files may be any bytes that the system allows.
    pub(crate) fn parser() -> impl TypedValueParser<Value = Self> {
        OsStringValueParser::new().try_map(Self::parse)
    }

    /// The model that a text names on the command line: `-`, `shape:NAME`, or a file.
    ///
    /// # Errors
    ///
    /// When it is empty, or no shape has the name: a line that says what could be written.
    pub fn parse(text: OsString) -> Result<Self, String> {
        match text.to_str() {
            Some("-") => Ok(Self::Stdin),
            Some("") => Err("an empty name: name a file, `-` or a shape such as shape:teapot".to_owned()),
            Some(name) if name.starts_with("shape:") => {
                name["shape:".len()..].parse().map(Self::Shape).map_err(|error| error.to_string())
            }
            _ => Ok(Self::File(text.into())),
        }
    }

    /// The name in messages: what was written on the command line.
    #[must_use]
    pub fn name(&self) -> PathBuf {
        match self {
            Self::File(path) => path.clone(),
            Self::Stdin => "standard input".into(),
            Self::Shape(shape) => format!("shape:{shape}").into(),
        }
    }

    /// The file, if it is one.
    #[must_use]
    pub fn file(&self) -> Option<&Path> {
        if let Self::File(path) = self { Some(path) } else { None }
    }

    /// Refuses models of which two are standard input.
    pub(crate) fn check_stdin(models: &[Self]) -> Result<(), Error> {
        if models.iter().filter(|model| **model == Self::Stdin).count() > 1 {
            return Err(Error::Usage("standard input can be read only once: name `-` once".to_owned()));
        }
        Ok(())
    }

    /// What `{stem}` stands for.
    #[must_use]
    pub(crate) fn stem(&self) -> OsString {
        match self {
            Self::File(path) => path.file_stem().unwrap_or_default().to_owned(),
            Self::Stdin => "stdin".into(),
            Self::Shape(shape) => shape.to_string().replace(':', "-").into(),
        }
    }
}

/// A model that was read, or a shape that was made.
#[derive(Debug)]
pub(crate) struct Source {
    /// What the file was; `None`: a shape.
    pub(crate) format: Option<Format>,
    /// Its objects.
    pub(crate) parts: Vec<Part>,
    /// What was skipped.
    pub(crate) skipped: Skipped,
    /// What the user should know.
    pub(crate) notes: Vec<String>,
}

impl Source {
    /// The model of this name.
    pub(crate) fn open(model: &Model) -> Result<Self, Error> {
        caught(&model.name(), || match model {
            Model::File(path) => Ok(import::load(path)?.into()),
            Model::Stdin => {
                let bytes = read_stdin()?;
                Ok(import::read(&bytes, &model.name().to_string_lossy(), None, None)?.into())
            }
            Model::Shape(shape) => {
                let mesh = shape.mesh().map_err(|error| Error::file(model.name(), error.to_string()))?;
                let name = shape.to_string();
                let part =
                    Part { name, mesh, placement: Placement::IDENTITY, color: None, materials: Vec::new() };
                Ok(Self { format: None, parts: vec![part], skipped: Skipped::default(), notes: Vec::new() })
            }
        })
    }

    /// Which axis is upward when nobody says so: printers and CAD, whose format STL is, have Z upward.
    pub(crate) fn up(&self) -> Up {
        if self.format == Some(Format::Stl) { Up::PlusZ } else { Up::PlusY }
    }

    /// What it is, in a word.
    pub(crate) fn kind(&self) -> &'static str {
        self.format.map_or("shape", Format::name)
    }

    /// Makes objects of the parts, shown in one way.
    pub(crate) fn add_to(self, world: &mut World, show: Show, name: &Path) -> Result<(), Error> {
        for part in self.parts {
            let mesh = world.add_mesh(part.mesh);
            let mut object = Object::new(mesh).placed(part.placement).shown(show);
            object.color = part.color;
            world.add(object).map_err(|error| Error::file(name, error.to_string()))?;
        }
        Ok(())
    }

    /// Triangles of all parts.
    pub(crate) fn triangles(&self) -> u64 {
        self.parts.iter().map(|part| part.mesh.triangles().len() as u64).sum()
    }

    /// Vertices of all parts.
    pub(crate) fn vertices(&self) -> u64 {
        self.parts.iter().map(|part| part.mesh.positions().len() as u64).sum()
    }

    /// Notes, and what was skipped, one line each.
    pub(crate) fn remarks(&self) -> Vec<String> {
        let skipped = self.skipped.items().iter().map(|item| format!("skipped {item}"));
        self.notes.iter().cloned().chain(skipped).collect()
    }
}

impl From<import::Model> for Source {
    fn from(model: import::Model) -> Self {
        let import::Model { parts, format, skipped, notes } = model;
        Self { format: Some(format), parts, skipped, notes }
    }
}

/// The axis that models have upward together: that of all, if they agree, else +Y for a mixture, which keeps its own
/// coordinates.
pub(crate) fn common_up(ups: &[Up]) -> Up {
    ups.first().copied().filter(|first| ups.iter().all(|up| up == first)).unwrap_or(Up::PlusY)
}

/// Every vertex of every visible object.
pub(crate) fn points(world: &World) -> impl Iterator<Item = DVec3> {
    world.objects().filter(|(_, object)| object.visible).flat_map(|(_, object)| {
        let matrix = object.placement.matrix();
        let positions = world.mesh(object.mesh()).map(Mesh::positions).unwrap_or_default();
        positions.iter().map(move |position| matrix.transform_point3(position.map(f64::from).into()))
    })
}

fn read_stdin() -> Result<Vec<u8>, Error> {
    let mut bytes = Vec::new();
    let failed = |what: String| Error::file("standard input", what);
    match std::io::stdin().lock().take(MAX_FILE + 1).read_to_end(&mut bytes) {
        Err(error) => Err(failed(format!("cannot be read: {error}"))),
        Ok(_) if bytes.len() as u64 > MAX_FILE => Err(failed(format!(
            "holds more than {} GiB, the most that is read: split or simplify the model",
            MAX_FILE >> 30
        ))),
        Ok(_) => Ok(bytes),
    }
}
