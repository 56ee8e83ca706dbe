//! From a name on the command line to the parts of a model.

use std::io::Read as _;

use polosa_math::Placement;
use polosa_scene::import::{self, Format, MAX_FILE, Part, Skipped};

use super::args::ModelArg;
use crate::error::Error;
use crate::guard::caught;
use crate::view::Up;

/// A model that was read, or a shape that was made.
#[derive(Debug)]
pub(super) struct Source {
    /// What the file was; `None`: a shape.
    pub(super) format: Option<Format>,
    /// Its objects.
    pub(super) parts: Vec<Part>,
    /// What was skipped.
    pub(super) skipped: Skipped,
    /// What the user should know.
    pub(super) notes: Vec<String>,
}

impl Source {
    /// The model of this name.
    pub(super) fn open(model: &ModelArg) -> Result<Self, Error> {
        caught(&model.name(), || match model {
            ModelArg::File(path) => Ok(import::load(path)?.into()),
            ModelArg::Stdin => {
                let bytes = read_stdin()?;
                Ok(import::read(&bytes, &model.name().to_string_lossy(), None, None)?.into())
            }
            ModelArg::Shape(shape) => {
                let mesh = shape.mesh().map_err(|error| Error::file(model.name(), error.to_string()))?;
                let name = shape.to_string();
                let part =
                    Part { name, mesh, placement: Placement::IDENTITY, color: None, materials: Vec::new() };
                Ok(Self { format: None, parts: vec![part], skipped: Skipped::default(), notes: Vec::new() })
            }
        })
    }

    /// Which axis is upward when nobody says so: printers and CAD, whose format STL is, have Z upward.
    pub(super) fn up(&self) -> Up {
        if self.format == Some(Format::Stl) { Up::PlusZ } else { Up::PlusY }
    }

    /// What it is, in a word.
    pub(super) fn kind(&self) -> &'static str {
        self.format.map_or("shape", Format::name)
    }

    /// Triangles of all parts.
    pub(super) fn triangles(&self) -> u64 {
        self.parts.iter().map(|part| part.mesh.triangles().len() as u64).sum()
    }

    /// Vertices of all parts.
    pub(super) fn vertices(&self) -> u64 {
        self.parts.iter().map(|part| part.mesh.positions().len() as u64).sum()
    }

    /// Notes, and what was skipped, one line each.
    pub(super) fn remarks(&self) -> Vec<String> {
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
