//! Tells when a file that is on show was written again.

use std::ffi::OsString;
use std::fmt;
use std::path::{Path, PathBuf};
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};

use notify::{RecommendedWatcher, RecursiveMode, Watcher as _};

use crate::application::Waker;
use crate::error::Error;
use crate::output::{folder, followed};

/// Watches the folders of files. Editors write a new file and rename it, so that watching the file itself would watch
/// the old one for ever.
pub(super) struct Watch {
    changed: Arc<AtomicBool>,
    _watcher: RecommendedWatcher,
}

impl fmt::Debug for Watch {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("Watch").field("changed", &self.changed).finish_non_exhaustive()
    }
}

impl Watch {
    /// Watches these files.
    pub(super) fn new(files: Vec<PathBuf>, waker: Waker) -> Result<Self, Error> {
        let failed = |file: &Path, error: notify::Error| {
            Error::file(file, format!("cannot be watched: {error}: reload it with Ctrl+R"))
        };
        // Of a link both are watched, it and what it leads to.
        let targets = files.iter().filter_map(|file| followed(file).ok());
        let files: Vec<PathBuf> = files.iter().cloned().chain(targets).collect();
        let names: Vec<OsString> = files.iter().filter_map(|file| file.file_name()).map(Into::into).collect();
        let changed = Arc::new(AtomicBool::new(false));
        let tell = Arc::clone(&changed);
        // Files beside a model that it is made of count, too; what else happens in the folder does not.
        let ours = move |path: &PathBuf| {
            path.file_name().is_some_and(|name| names.iter().any(|ours| ours == name))
                || path.extension().is_some_and(|extension| {
                    ["mtl", "bin"].iter().any(|side| extension.eq_ignore_ascii_case(side))
                })
        };
        let on_event = move |event: notify::Result<notify::Event>| {
            // Who has lost events, or does not know what was changed, may have lost ours.
            if event.map_or(true, |event| {
                event.need_rescan() || !event.kind.is_access() && event.paths.iter().any(&ours)
            }) {
                tell.store(true, Ordering::Release);
                waker.wake();
            }
        };
        let first = files.first().cloned().unwrap_or_default();
        let mut watcher = notify::recommended_watcher(on_event).map_err(|error| failed(&first, error))?;
        let mut watched = Vec::new();
        for file in &files {
            let folder = folder(file).to_owned();
            if !watched.contains(&folder) {
                watcher.watch(&folder, RecursiveMode::NonRecursive).map_err(|error| failed(file, error))?;
                watched.push(folder);
            }
        }
        Ok(Self { changed, _watcher: watcher })
    }

    /// Whether a file was written since the last time this was asked.
    pub(super) fn take(&self) -> bool {
        self.changed.swap(false, Ordering::AcqRel)
    }
}
