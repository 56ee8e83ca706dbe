//! Side files: what a model names and keeps in files of their own. Only from the model's folder and below.

use std::path::{Component, Path, PathBuf};

use super::error::{Fault, Parsed, quote};

/// The bytes of the file that a model calls `name`, from `folder` and below.
pub(super) fn read(folder: Option<&Path>, name: &str) -> Parsed<Vec<u8>> {
    let quoted = quote(name.as_bytes(), 100);
    let folder = folder.ok_or_else(|| {
        Fault::new(format!("`{quoted}` is a file of its own, and no folder is known for it"))
    })?;
    let outside = || {
        Fault::new(format!(
            "`{quoted}` is not in the model's own folder and not read: copy it there and name it so"
        ))
    };
    // Exporters on Windows write backslashes.
    let relative = PathBuf::from(name.replace('\\', "/"));
    if !relative.components().all(|c| matches!(c, Component::Normal(_) | Component::CurDir)) {
        return Err(outside());
    }
    let path = folder.join(relative);
    let missing = |_| Fault::new(format!("`{quoted}` is missing: put it beside the model"));
    let (real, real_folder) =
        (path.canonicalize().map_err(missing)?, folder.canonicalize().map_err(missing)?);
    // A symbolic link may point anywhere.
    if !real.starts_with(real_folder) {
        return Err(outside());
    }
    if !real.is_file() {
        return Err(Fault::new(format!("`{quoted}` is not a file")));
    }
    super::read_file(&real)
}
