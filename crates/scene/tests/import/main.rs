//! Importers: what each format's files become, what is refused and how, and that nothing makes them panic.

#![cfg(all(feature = "obj", feature = "stl", feature = "ply", feature = "gltf"))]
#![expect(clippy::float_cmp, reason = "importers promise exact numbers")]

mod bad;
mod data;
mod gltf;
mod hostile;
mod obj;
mod ply;
mod stl;

use polosa_scene::import::{Model, Part, read};

/// The model in some bytes, which must be readable.
fn model(bytes: impl AsRef<[u8]>, name: &str) -> Model {
    read(bytes.as_ref(), name, None, None).unwrap_or_else(|error| panic!("{error}"))
}

/// The only part of a model.
fn part(bytes: impl AsRef<[u8]>, name: &str) -> Part {
    let mut model = model(bytes, name);
    assert_eq!(model.parts.len(), 1);
    model.parts.remove(0)
}

/// The line that refuses some bytes.
fn refusal(bytes: impl AsRef<[u8]>, name: &str) -> String {
    let line = match read(bytes.as_ref(), name, None, None) {
        Err(error) => error.to_string(),
        Ok(model) => panic!("{name} was read: {model:?}"),
    };
    assert!(line.starts_with(name) && !line.contains('\n') && line.len() < 500, "{line}");
    line
}
