//! The examples are the files beside this one; see `README.md`. Here is what they share: how they are started, and
//! where their pictures go.

#[path = "lib/help.rs"]
mod help;
#[path = "lib/run.rs"]
mod run;
#[path = "lib/tetrahedron.rs"]
pub mod tetrahedron;

use std::error::Error;
use std::fs;
use std::path::{Path, PathBuf};

pub use help::{Help, label};
use polosa_scene::{DrawStats, Picture};
pub use run::{Headless, application, redrawn, report, run, struck, write};

/// Writes a picture as PNG into the folder that is the program's first argument, else into `target/pictures`; with the
/// arguments `--headless OUT.png`, to that file.
///
/// # Errors
///
/// When the folder or the file cannot be written.
pub fn save(name: &str, picture: &Picture) -> Result<PathBuf, Box<dyn Error>> {
    let mut arguments = std::env::args_os().skip(1);
    let path = match arguments.next() {
        Some(option) if option == "--headless" => {
            arguments.next().ok_or("--headless OUT.png: which file?")?.into()
        }
        folder => {
            let folder = folder.unwrap_or_else(|| "target/pictures".into());
            fs::create_dir_all(&folder)?;
            Path::new(&folder).join(name)
        }
    };
    write(&path, picture)?;
    Ok(path)
}

/// Pixels, `0x00RRGGBB`, row by row, as a picture.
///
/// # Panics
///
/// When there are not `width` × `height` of them.
#[must_use]
pub fn picture(width: u32, height: u32, pixels: Vec<u32>) -> Picture {
    assert_eq!(pixels.len(), width as usize * height as usize, "pixels of a picture of {width}×{height}");
    Picture { width, height, pixels, alpha: None, distances: None, ids: None, stats: DrawStats::default() }
}

/// The Rust blocks of the project's README are tests.
#[cfg(doctest)]
#[doc = include_str!("../README.md")]
struct Readme;
