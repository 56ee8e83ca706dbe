//! Models become a world.

use std::path::Path;

use polosa_scene::{Camera, PictureSettings, World};
use serde_json::{Value, json};

use super::args::ModelArg;
use super::progress::Progress;
use super::tell;
use super::view_args::ViewArgs;
use super::words::counted;
use crate::decode;
use crate::error::{Error, one_line};
pub(super) use crate::model::points;
use crate::model::{Source, common_up};
use crate::view::Up;

/// What is told about a model after its meshes have gone into the world.
#[derive(Debug)]
pub(super) struct ModelFacts {
    pub(super) name: String,
    pub(super) kind: &'static str,
    pub(super) parts: usize,
    pub(super) vertices: u64,
    pub(super) triangles: u64,
    pub(super) remarks: Vec<String>,
}

impl ModelFacts {
    fn of(name: String, source: &Source) -> Self {
        Self {
            name,
            kind: source.kind(),
            parts: source.parts.len(),
            vertices: source.vertices(),
            triangles: source.triangles(),
            remarks: source.remarks(),
        }
    }

    /// For people: one line, without the remarks.
    pub(super) fn text(&self) -> String {
        format!(
            "{}: {}, {}, {}, {}",
            self.name,
            self.kind,
            counted(self.parts as u64, "part", "parts"),
            counted(self.vertices, "vertex", "vertices"),
            counted(self.triangles, "triangle", "triangles")
        )
    }

    /// The lines of a report about a picture: that one, and the remarks.
    pub(super) fn lines(&self) -> String {
        let mut text = format!("  {:<12}{}\n", "model", self.text());
        for remark in &self.remarks {
            text += &format!("  {:<12}{}\n", "", one_line(remark));
        }
        text
    }

    /// For programs.
    pub(super) fn json(&self) -> Value {
        json!({
            "name": self.name,
            "format": self.kind,
            "parts": self.parts,
            "vertices": self.vertices,
            "triangles": self.triangles,
            "remarks": self.remarks,
        })
    }
}

/// All models in one world, in the order of the command line. Unless `quiet`, says what of them is not shown.
pub(super) fn load(
    models: &[ModelArg],
    view: &ViewArgs,
    quiet: bool,
    progress: &Progress,
) -> Result<(World, Vec<ModelFacts>, Up), Error> {
    let mut world = World::new();
    let mut facts = Vec::new();
    let mut ups = Vec::new();
    for model in models {
        let name = one_line(&model.name().to_string_lossy());
        progress.now(&format!("reading {name}"));
        let source = Source::open(model)?;
        ups.push(source.up());
        let fact = ModelFacts::of(name, &source);
        if !quiet {
            progress.aside(|| source.notes.iter().for_each(|text| note(&fact.name, text)));
        }
        facts.push(fact);
        source.add_to(&mut world, view.show(), &model.name())?;
        progress.step();
    }
    Ok((world, facts, view.up.unwrap_or_else(|| common_up(&ups))))
}

/// A line about a file that is no failure.
pub(super) fn note(name: &str, text: &str) {
    tell(&format!("polosa: {name}: note: {}\n", one_line(text)), true);
}

/// The camera for a picture of a world.
pub(super) fn camera(
    world: &World,
    view: &ViewArgs,
    up: Up,
    settings: &PictureSettings,
    name: &Path,
) -> Result<Camera, Error> {
    let aspect = f64::from(settings.width) / f64::from(settings.height);
    let camera = view.view(up).camera(points(world), &world.bounds(), aspect);
    camera.map_err(|error| Error::file(name, error.to_string()))
}

/// Asks whether there is memory for a picture of so many bytes a pixel, since running out of it on the way would end
/// the program without a word.
pub(super) fn reserve(
    settings: &PictureSettings,
    bytes_a_pixel: usize,
    more: u64,
    name: &Path,
) -> Result<(), Error> {
    // No more than 2²⁸ pixels: `ViewArgs::settings` has seen to that.
    let bytes = (bytes_a_pixel as u64 * u64::from(settings.width)).checked_mul(u64::from(settings.height));
    let bytes = bytes.and_then(|bytes| bytes.checked_add(more));
    decode::reserve(bytes.unwrap_or(u64::MAX), "lower --resolution", name)
}
