//! Material libraries: which are read, and what the user is told about them.

use super::super::error::quote;
use super::super::words::Words;
use super::{Reader, mtl};

/// Material libraries in one statement: more are not looked for.
const MOST_LIBRARIES: usize = 16;

/// Notes about libraries and materials: a hostile file could ask for millions.
pub(super) const MOST_NOTES: usize = 16;

impl Reader<'_, '_, '_> {
    /// `mtllib a.mtl b.mtl`, or one name with spaces in it. A library that cannot be read is a note.
    pub(super) fn library(&mut self, words: Words<'_>) {
        let folder = self.context.side_files;
        let read = |name| (name, super::super::side::read(folder, &String::from_utf8_lossy(name)));
        let whole = read(words.rest());
        let found = match &whole.1 {
            Err(_) if words.count() > 1 => words.take(MOST_LIBRARIES).map(read).collect(),
            _ => vec![whole],
        };
        for (name, library) in found {
            match library {
                Ok(bytes) => {
                    self.libraries += 1;
                    let mut notes = Vec::new();
                    self.textures |= mtl::read(&bytes, &quote(name, 100), &mut self.materials, &mut notes);
                    notes.into_iter().for_each(|text| self.note(text));
                }
                Err(fault) => {
                    self.library_missing = true;
                    let error = super::super::ImportError::new("materials", fault);
                    self.note(format!("{}; drawn without its colours", error.message()));
                }
            }
        }
    }

    /// Says which materials no library has. When a library is missing, that is the reason, and said already.
    pub(super) fn note_unknown_materials(&mut self) {
        if self.library_missing || self.names.is_empty() {
            return;
        }
        if self.libraries == 0 {
            let line = self.named_at[0];
            self.note(format!(
                "line {line}: `usemtl` names a material, but no `mtllib` says where it is; drawn without its colour"
            ));
            return;
        }
        let unknown: Vec<String> = self
            .names
            .iter()
            .zip(&self.named_at)
            .filter(|(name, _)| !self.materials.contains_key(*name))
            .map(|(name, line)| {
                let name = quote(name, 100);
                format!("line {line}: the material `{name}` is in no MTL file; drawn without its colour")
            })
            .take(MOST_NOTES)
            .collect();
        unknown.into_iter().for_each(|text| self.note(text));
    }

    fn note(&mut self, text: String) {
        if self.context.notes.len() < MOST_NOTES && !self.context.notes.contains(&text) {
            self.context.notes.push(text);
        }
    }
}
