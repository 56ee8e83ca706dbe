//! Wavefront OBJ.
//!
//! An own reader, since no library kept what is needed within the time that there is. A grid of 100,352 triangles
//! with positions only, and with normals (`v//vn`), all readers side by side on the same two busy cores, best of
//! several runs; compare the rows with each other, not with another machine:
//!
//! | reader | ms | indices out of range | beside that |
//! |---|---|---|---|
//! | tobj 4.0 | 111, 184 | error without a place | |
//! | obj 0.10 | 137, 188 | not checked | corners as nested vectors; lines counted from 0 |
//! | `wavefront_obj` 11 | 107, 184 | error with its line | no negative indices, triangles instead of polygons |
//! | wobj 0.3 | 74, 117 | not checked | the closest; errors over several lines |
//! | this one | 20, 33 | error with its line | no free-form geometry, as none of them has |
//!
//! The whole program has 120 ms on two idle cores for such a file, most of which the drawing needs.
//! The grammar is a word and numbers a line, so that the reader stays small.
//!
//! # How it reads
//!
//! Statements fill tables in one pass. Faces may name vertices that come later (nobody forbids it, hardly
//! anybody does it): the first such face stops the pass, the vertex statements alone are read to the end, and
//! the pass starts again with the tables full.

mod assemble;
mod face;
mod gather;
mod library;
mod mtl;

use std::collections::HashMap;

use super::error::{Fault, Parsed, Place, quote};
use super::skipped::SkippedKind;
use super::text::Lines;
use super::words::{Words, float};
use super::{Context, Part};
use face::{Corner, Faces};
use mtl::Materials;

/// Everything that faces refer to.
#[derive(Debug, Default)]
struct Tables {
    positions: Vec<[f32; 3]>,
    uvs: Vec<[f32; 2]>,
    normals: Vec<[f32; 3]>,
    /// As in the file; as long as `positions` once one vertex has a colour, NaN where one has none.
    colors: Vec<[f32; 3]>,
    /// `v`, `vt` and `vn` statements so far, which negative indices count back from. Not the tables' lengths in
    /// a second pass.
    seen: [usize; 3],
}

/// Why a pass ended early.
enum Stop {
    Fault(Fault),
    /// A face names a vertex that is not there yet.
    Forward,
}

impl From<Fault> for Stop {
    fn from(fault: Fault) -> Self {
        Self::Fault(fault)
    }
}

/// What a pass reads.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Pass {
    /// Everything, in order.
    Only,
    /// The tables alone.
    Tables,
    /// Everything but the tables, which are full.
    Faces,
}

/// What stands between two `o` statements.
#[derive(Debug)]
struct Object<'a> {
    /// Empty: the file's.
    name: &'a [u8],
    first_triangle: usize,
    first_side: usize,
}

struct Reader<'a, 'c, 'd> {
    pass: Pass,
    tables: Tables,
    faces: Faces,
    objects: Vec<Object<'a>>,
    /// From which triangle on which material counts, an index into `names`.
    runs: Vec<(usize, usize)>,
    names: Vec<Vec<u8>>,
    /// The line that first names each.
    named_at: Vec<u64>,
    numbers: HashMap<Vec<u8>, usize>,
    materials: Materials,
    textures: bool,
    /// How many material libraries were read, and whether one could not be.
    libraries: usize,
    library_missing: bool,
    context: &'c mut Context<'d>,
}

pub(super) fn read(bytes: &[u8], context: &mut Context<'_>) -> Parsed<Vec<Part>> {
    let (skipped, notes) = (context.skipped.clone(), context.notes.clone());
    let mut reader = Reader::new(Pass::Only, Tables::default(), context);
    let result = match reader.run(bytes) {
        Err(Stop::Forward) => {
            // A second start: forget what the first one reported.
            (context.skipped, context.notes) = (skipped, notes);
            let mut first = Reader::new(Pass::Tables, Tables::default(), context);
            first.run(bytes).map_err(|stop| stop.fault(bytes))?;
            let tables = Tables { seen: [0; 3], ..first.tables };
            reader = Reader::new(Pass::Faces, tables, context);
            reader.run(bytes)
        }
        result => result,
    };
    result.map_err(|stop| stop.fault(bytes))?;
    reader.parts()
}

impl Stop {
    fn fault(self, bytes: &[u8]) -> Fault {
        match self {
            Self::Fault(fault) => fault,
            // Only a face stops so, and only in a pass that is then repeated.
            Self::Forward => Fault::new(format!("unreadable ({} bytes): export it again", bytes.len())),
        }
    }
}

impl<'a, 'c, 'd> Reader<'a, 'c, 'd> {
    fn new(pass: Pass, tables: Tables, context: &'c mut Context<'d>) -> Self {
        Self {
            pass,
            tables,
            faces: Faces::new(),
            objects: vec![Object { name: b"", first_triangle: 0, first_side: 0 }],
            runs: Vec::new(),
            names: Vec::new(),
            named_at: Vec::new(),
            numbers: HashMap::new(),
            materials: Materials::new(),
            textures: false,
            libraries: 0,
            library_missing: false,
            context,
        }
    }

    fn run(&mut self, bytes: &'a [u8]) -> Result<(), Stop> {
        let mut lines = Lines::new(bytes);
        let mut joined: Vec<u8> = Vec::new();
        while let Some((number, line)) = lines.next() {
            if !line.ends_with(b"\\") {
                self.statement(line, Some(line), number)?;
                continue;
            }
            // A backslash at the end of a line: the statement goes on in the next.
            joined.clear();
            let mut piece = line;
            while let Some(start) = piece.strip_suffix(b"\\") {
                joined.extend_from_slice(start);
                joined.push(b' ');
                piece = lines.next().map_or(&b""[..], |(_, line)| line);
            }
            joined.extend_from_slice(piece);
            self.statement(&joined, None, number)?;
        }
        Ok(())
    }

    /// One statement. `kept` is the line where it may be borrowed for as long as the file.
    #[inline]
    fn statement(&mut self, line: &[u8], kept: Option<&'a [u8]>, number: u64) -> Result<(), Stop> {
        let mut words = Words::new(line);
        let Some(keyword) = words.next() else { return Ok(()) };
        match keyword {
            b"v" => self.vertex(words).map_err(|fault| fault.at(Place::Line(number)))?,
            b"vn" => self.normal(words).map_err(|fault| fault.at(Place::Line(number)))?,
            b"vt" => self.uv(words).map_err(|fault| fault.at(Place::Line(number)))?,
            _ if self.pass == Pass::Tables => {}
            b"f" | b"fo" => self.face(words, number)?,
            _ => self.other(keyword, words, kept, number),
        }
        Ok(())
    }

    fn vertex(&mut self, mut words: Words<'_>) -> Parsed<()> {
        self.tables.seen[0] += 1;
        if self.pass == Pass::Faces {
            return Ok(());
        }
        let position = numbers::<3>(&mut words, "a vertex needs three coordinates")?;
        self.tables.positions.push(position);
        if words.rest().is_empty() {
            return Ok(());
        }
        // `v x y z w`, `v x y z r g b`, or both.
        let mut more = [0.0; 4];
        let mut count = 0;
        for (slot, word) in more.iter_mut().zip(&mut words) {
            *slot = float(word).ok_or_else(|| not_a_number(word))?;
            count += 1;
        }
        if count >= 3 {
            let color = [more[count - 3], more[count - 2], more[count - 1]];
            self.tables.colors.resize(self.tables.positions.len() - 1, [f32::NAN; 3]);
            self.tables.colors.push(color);
        }
        Ok(())
    }

    fn normal(&mut self, mut words: Words<'_>) -> Parsed<()> {
        self.tables.seen[2] += 1;
        if self.pass != Pass::Faces {
            self.tables.normals.push(numbers::<3>(&mut words, "a normal needs three coordinates")?);
        }
        Ok(())
    }

    fn uv(&mut self, mut words: Words<'_>) -> Parsed<()> {
        self.tables.seen[1] += 1;
        if self.pass != Pass::Faces {
            let [u] = numbers::<1>(&mut words, "a texture coordinate needs a number")?;
            let v = words.next().map_or(Ok(0.0), |word| float(word).ok_or_else(|| not_a_number(word)))?;
            // From the picture's bottom edge up in OBJ, from its top edge down in a mesh.
            self.tables.uvs.push([u, 1.0 - v]);
        }
        Ok(())
    }

    fn face(&mut self, words: Words<'_>, number: u64) -> Result<(), Stop> {
        let at = |fault: Fault| fault.at(Place::Line(number));
        self.faces.corners.clear();
        for word in words {
            let corner = Corner::parse(word).ok_or_else(|| {
                let word = quote(word, 40);
                at(Fault::new(format!("`{word}` is not a corner of a face: write v, v/vt, v//vn or v/vt/vn")))
            })?;
            match corner.resolve(&self.tables) {
                Ok(corner) => self.faces.corners.push(corner),
                Err(outside) if outside.later && self.pass == Pass::Only => return Err(Stop::Forward),
                Err(outside) => return Err(at(outside.fault()).into()),
            }
        }
        if self.faces.corners.len() < 3 {
            self.context.skipped.add(SkippedKind::ShortFaces, 1, Some(Place::Line(number)));
        } else {
            self.faces.push(&self.tables.positions);
        }
        Ok(())
    }

    fn other(&mut self, keyword: &[u8], words: Words<'_>, kept: Option<&'a [u8]>, number: u64) {
        let place = Some(Place::Line(number));
        match keyword {
            b"o" => {
                // A name continued over several lines is no name worth keeping.
                let name = kept.map_or(&b""[..], |line| line.trim_ascii_start()[1..].trim_ascii());
                let (first_triangle, first_side) = self.faces.counts();
                self.objects.push(Object { name, first_triangle, first_side });
            }
            b"usemtl" => {
                let name = words.rest();
                let material = match self.numbers.get(name) {
                    Some(&material) => material,
                    None => {
                        let material = self.names.len();
                        self.names.push(name.to_vec());
                        self.named_at.push(number);
                        self.numbers.insert(name.to_vec(), material);
                        material
                    }
                };
                self.runs.push((self.faces.counts().0, material));
            }
            b"mtllib" => self.library(words),
            b"l" | b"p" => self.context.skipped.add(SkippedKind::LinesAndPoints, 1, place),
            b"curv" | b"curv2" | b"surf" => self.context.skipped.add(SkippedKind::FreeForm, 1, place),
            _ if keyword.starts_with(b"#") || SILENT.contains(&keyword) => {}
            _ => self.context.skipped.add(SkippedKind::UnknownStatements, 1, place),
        }
    }
}

/// Statements that change nothing here: groups do not split an object, and the rest is about free-form geometry
/// or other programs.
const SILENT: [&[u8]; 31] = [
    b"g",
    b"s",
    b"mg",
    b"vp",
    b"cstype",
    b"deg",
    b"bmat",
    b"step",
    b"parm",
    b"trim",
    b"hole",
    b"scrv",
    b"sp",
    b"end",
    b"con",
    b"bevel",
    b"c_interp",
    b"d_interp",
    b"lod",
    b"shadow_obj",
    b"trace_obj",
    b"ctech",
    b"stech",
    b"maplib",
    b"usemap",
    b"call",
    b"csh",
    b"res",
    b"cdc",
    b"cdp",
    b"bzp",
];

/// The next `N` words as numbers.
#[inline]
fn numbers<const N: usize>(words: &mut Words<'_>, needed: &str) -> Parsed<[f32; N]> {
    let mut numbers = [0.0; N];
    for number in &mut numbers {
        let word = words.next().ok_or_else(|| Fault::new(format!("{needed}: the file may be cut off")))?;
        *number = float(word).ok_or_else(|| not_a_number(word))?;
    }
    Ok(numbers)
}

#[cold]
fn not_a_number(word: &[u8]) -> Fault {
    Fault::new(format!("`{}` is not a number", quote(word, 40)))
}
