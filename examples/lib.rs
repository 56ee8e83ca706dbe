//! The examples are the files beside this one; see `README.md`. Here is what they share: where their pictures go.

use std::error::Error;
use std::fs;
use std::path::{Path, PathBuf};

use polosa::encode::{ImageFormat, write_picture};
use polosa_scene::{DrawStats, Picture};

/// Writes a picture as PNG into the folder that is the program's first argument, else into `target/pictures`.
///
/// # Errors
///
/// When the folder or the file cannot be written.
pub fn save(name: &str, picture: &Picture) -> Result<PathBuf, Box<dyn Error>> {
    let folder = std::env::args_os().nth(1).unwrap_or_else(|| "target/pictures".into());
    fs::create_dir_all(&folder)?;
    let path = Path::new(&folder).join(name);
    let mut png = Vec::new();
    write_picture(&mut png, ImageFormat::Png, picture)?;
    fs::write(&path, png)?;
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
