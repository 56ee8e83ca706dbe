//! Files become meshes: OBJ, STL, PLY and glTF.
//!
//! ```text
//!   bytes ── detect ──▶ obj ┐
//!                       stl ├──▶ Draft ──▶ Mesh ──▶ Part ──▶ Model
//!                       ply │    polygons cut, unused vertices left out
//!                      gltf ┘
//! ```
//!
//! The content decides the format, not the name; a name that says otherwise is noted. What is known and not
//! read (3MF, STEP, FBX, …) is refused by its name with advice.
//!
//! # What a part is
//!
//! One object of the file: an `o` of OBJ, a `solid` of STL, a node with a mesh of glTF. Materials do not split
//! an object, since a closed surface should stay one mesh (only of a closed mesh may back faces be skipped): when an object has
//! several, its triangles are coloured one by one ([`Colors::Face`](crate::Colors::Face)).
//! A polygon's sides stay the mesh's edges when some polygon is not a triangle.
//!
//! # What is kept and what is skipped
//!
//! Triangles keep the order of the file. Degenerate ones and coordinates that are not finite are kept: drawing
//! rejects and counts them. Faces with fewer than three corners, lines, points and unused vertices are skipped
//! and counted in [`Skipped`]. Everything else that is wrong with a file is an [`ImportError`]: one line with
//! the file, the place and what to do. Side files (MTL, `.bin`) are read from the model's own folder and below.
//!
//! # Hostile files
//!
//! No input makes the readers panic, and memory stays within a constant times the bytes that are really there:
//! every count of a header is held against them before anything is allocated. A panic inside a library is
//! caught and becomes an error.
//!
//! # Libraries and own readers
//!
//! PLY and glTF are read by `ply-rs-bw` and `gltf`. OBJ and STL have readers of their own, since no library
//! kept what is needed here: see their modules for the comparison.

mod detect;
#[cfg(any(feature = "obj", feature = "stl", feature = "ply", feature = "gltf"))]
mod draft;
mod error;
#[cfg(feature = "gltf")]
mod gltf;
mod guard;
#[cfg(feature = "obj")]
mod obj;
#[cfg(feature = "ply")]
mod ply;
#[cfg(any(feature = "obj", feature = "stl", feature = "ply"))]
mod polygon;
#[cfg(any(feature = "obj", feature = "gltf"))]
mod side;
mod skipped;
#[cfg(feature = "stl")]
mod stl;
#[cfg(any(feature = "obj", feature = "stl", feature = "ply"))]
mod text;
#[cfg(any(feature = "obj", feature = "stl"))]
mod words;

use core::fmt;
use std::fs::File;
use std::io::Read as _;
use std::path::Path;

use polosa_math::Placement;

pub use error::{ImportError, Place};
pub use skipped::{Skipped, SkippedItem, SkippedKind};

use crate::{Color, Mesh};
use error::{Fault, Parsed, quote};

/// The largest file that is read, in bytes: 2 GiB. Without a limit a device file such as `/dev/zero` would fill
/// the memory.
pub const MAX_FILE: u64 = 1 << 31;

/// A file format that is read.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[non_exhaustive]
pub enum Format {
    /// Wavefront OBJ, with the diffuse colours of its MTL files.
    Obj,
    /// STL, ASCII or binary.
    Stl,
    /// PLY, ASCII or binary of either byte order.
    Ply,
    /// glTF 2.0, as text (`.gltf`) or binary (`.glb`).
    Gltf,
}

impl Format {
    /// The format's name.
    #[must_use]
    pub const fn name(self) -> &'static str {
        match self {
            Self::Obj => "OBJ",
            Self::Stl => "STL",
            Self::Ply => "PLY",
            Self::Gltf => "glTF",
        }
    }
}

impl fmt::Display for Format {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.name())
    }
}

/// What a file held.
#[derive(Clone, Debug)]
pub struct Model {
    /// The objects, in the file's order; at least one, each with at least one triangle.
    pub parts: Vec<Part>,
    /// What the file was, by its content.
    pub format: Format,
    /// What was skipped.
    pub skipped: Skipped,
    /// What the user should know, one line each: a misleading name, a missing material file, a material that is
    /// nowhere or whose colour is none, ignored features.
    pub notes: Vec<String>,
}

/// One object of a model.
#[derive(Clone, Debug)]
pub struct Part {
    /// The object's name; the file's, without extension, when the object has none.
    pub name: String,
    /// Its surface.
    pub mesh: Mesh,
    /// Where it stands.
    pub placement: Placement,
    /// Its colour, when it has one for all triangles.
    pub color: Option<Color>,
    /// The names of the materials that its triangles use, each once, in the order of their first use.
    pub materials: Vec<String>,
}

/// What a reader is given beside the bytes, and where it reports to.
#[derive(Debug)]
#[cfg_attr(
    not(any(feature = "obj", feature = "gltf")),
    expect(dead_code, reason = "each format uses what it needs")
)]
struct Context<'a> {
    /// The file's name without folders and extension.
    stem: String,
    /// Where side files may be read from.
    side_files: Option<&'a Path>,
    skipped: Skipped,
    notes: Vec<String>,
}

/// Reads the model in a file; its side files from the same folder and below.
///
/// # Errors
///
/// When the file or something in it cannot be read: see [`ImportError`].
pub fn load(path: &Path) -> Result<Model, ImportError> {
    let name = path.display().to_string();
    let bytes = read_file(path).map_err(|fault| ImportError::new(&name, fault))?;
    let folder = path.parent().filter(|folder| !folder.as_os_str().is_empty());
    read(&bytes, &name, None, Some(folder.unwrap_or(Path::new("."))))
}

/// Reads the model in `bytes`, such as those of standard input.
///
/// `name` stands in messages and names parts; its extension counts only where the content says nothing.
/// `format`, where given, counts before the extension; the content still wins. Without `side_files`, the folder
/// of MTL and `.bin` files, these are not read.
///
/// # Errors
///
/// When something in the file cannot be read: see [`ImportError`].
pub fn read(
    bytes: &[u8],
    name: &str,
    format: Option<Format>,
    side_files: Option<&Path>,
) -> Result<Model, ImportError> {
    guard::run(|| read_parts(bytes, name, format, side_files)).map_err(|fault| ImportError::new(name, fault))
}

fn read_parts(bytes: &[u8], name: &str, format: Option<Format>, side_files: Option<&Path>) -> Parsed<Model> {
    let detected = detect::detect(bytes, name, format)?;
    let mut context = Context {
        stem: detect::stem(name),
        side_files,
        skipped: Skipped::default(),
        notes: detected.note.into_iter().collect(),
    };
    let mut parts = read_format(detected.format, bytes, &mut context)?;
    let before = parts.len();
    parts.retain(|part| !part.mesh.triangles().is_empty());
    context.skipped.add(SkippedKind::EmptyParts, (before - parts.len()) as u64, None);
    if parts.is_empty() {
        return Err(nothing_to_draw(detected.format, &context.skipped));
    }
    Ok(Model { parts, format: detected.format, skipped: context.skipped, notes: context.notes })
}

fn read_format(format: Format, bytes: &[u8], context: &mut Context<'_>) -> Parsed<Vec<Part>> {
    match format {
        #[cfg(feature = "obj")]
        Format::Obj => obj::read(bytes, context),
        #[cfg(feature = "stl")]
        Format::Stl => stl::read(bytes, context),
        #[cfg(feature = "ply")]
        Format::Ply => ply::read(bytes, context),
        #[cfg(feature = "gltf")]
        Format::Gltf => gltf::read(bytes, context),
        #[cfg(not(all(feature = "obj", feature = "stl", feature = "ply", feature = "gltf")))]
        _ => {
            let _ = (bytes, context);
            Err(Fault::new(format!(
                "this build does not read {format}: build polosa-scene with its feature `{}`",
                format.name().to_ascii_lowercase()
            )))
        }
    }
}

/// A file without a single triangle, and what it had instead.
fn nothing_to_draw(format: Format, skipped: &Skipped) -> Fault {
    let had: Vec<String> = skipped
        .items()
        .iter()
        .filter(|item| item.kind != SkippedKind::EmptyParts)
        .map(ToString::to_string)
        .collect();
    let had = if had.is_empty() { String::new() } else { format!(" but {}", had.join(", ")) };
    Fault::new(format!("this {format} file has no face{had}: there is no surface to draw"))
}

/// The bytes of a file, [`MAX_FILE`] at most.
fn read_file(path: &Path) -> Parsed<Vec<u8>> {
    let fault = |error: std::io::Error| {
        let what = match error.kind() {
            std::io::ErrorKind::NotFound => "no such file: check the path".to_owned(),
            std::io::ErrorKind::PermissionDenied => "no permission to read it".to_owned(),
            _ => format!("cannot be read: {}", quote(error.to_string().as_bytes(), 120)),
        };
        Fault::new(what)
    };
    let file = File::open(path).map_err(fault)?;
    let metadata = file.metadata().map_err(fault)?;
    if metadata.is_dir() {
        return Err(Fault::new("is a folder: name a file in it"));
    }
    let too_large = || {
        Fault::new(format!(
            "is larger than {} GiB, the most that is read: split or simplify it",
            MAX_FILE >> 30
        ))
    };
    if metadata.len() > MAX_FILE {
        return Err(too_large());
    }
    let mut bytes = Vec::new();
    bytes.reserve_exact(usize::try_from(metadata.len()).map_err(|_| too_large())? + 1);
    file.take(MAX_FILE + 1).read_to_end(&mut bytes).map_err(fault)?;
    if bytes.len() as u64 > MAX_FILE {
        return Err(too_large());
    }
    Ok(bytes)
}
