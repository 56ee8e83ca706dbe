//! STL, ASCII and binary.
//!
//! An own reader: `stl_io` 0.11 was looked at, and all it would have done here is to read twelve numbers a
//! triangle. It tells ASCII from binary by the word `solid`, with which many binary files begin; it welds −0 and
//! 0 apart, so that closed solids come out open; it knows one solid a file, and no place in its errors.
//!
//! # What the wild is like, and what is done
//!
//! - A binary header that begins with `solid`: the length decides (84 + 50 bytes a triangle).
//! - A count of 0 or 2³² − 1 with triangles after it, from programs that stream: the triangles are counted.
//! - Normals that are wrong, zero or NaN: not used; the order of the vertices says where outside is.
//! - Vertices repeated for each triangle: welded where they are equal, 0 and −0 being so, within a solid.
//! - More than three vertices in a loop: a polygon. Fewer: skipped and counted.
//! - A missing `endsolid`: taken as there, with a note. A facet without its end: the file is cut off, an error.
//! - Capital letters, any indentation, no name, several solids: read.

use std::collections::HashMap;

use polosa_math::Placement;

use super::detect::stl_length;
use super::draft::Draft;
use super::error::{Fault, Parsed, Place, quote};
use super::polygon::Cutter;
use super::skipped::SkippedKind;
use super::text::Lines;
use super::words::{Words, float};
use super::{Context, Part};

/// Bytes before the first triangle of a binary file: a free text and the count.
const HEADER: usize = 84;

/// Bytes of a triangle: a normal, three vertices, two bytes to be ignored.
const RECORD: usize = 50;

pub(super) fn read(bytes: &[u8], context: &mut Context<'_>) -> Parsed<Vec<Part>> {
    if stl_length(bytes) != Some(bytes.len() as u64) && is_text(bytes) {
        ascii(bytes, context)
    } else {
        binary(bytes, context)
    }
}

/// Text has no NUL and says `solid` or `facet` first.
fn is_text(bytes: &[u8]) -> bool {
    let head = &bytes[..bytes.len().min(1024)];
    let first = Words::new(super::detect::without_mark(head)).next().unwrap_or_default();
    !head.contains(&0) && (first.eq_ignore_ascii_case(b"solid") || first.eq_ignore_ascii_case(b"facet"))
}

/// Gives equal positions one index, in the order in which they are first met.
#[derive(Default)]
struct Weld {
    positions: Vec<[f32; 3]>,
    /// By bits, so that NaN equals itself. The standard library's hash is seeded: no file can make it collide.
    known: HashMap<[u32; 3], u32>,
}

impl Weld {
    fn index(&mut self, position: [f32; 3]) -> Parsed<u32> {
        // −0 + 0 is 0; everything else stays.
        let position = position.map(|c| c + 0.0);
        let next = u32::try_from(self.positions.len())
            .map_err(|_| Fault::new("more than 4,294,967,295 vertices: simplify the model"))?;
        let index = *self.known.entry(position.map(f32::to_bits)).or_insert(next);
        if index == next {
            self.positions.push(position);
        }
        Ok(index)
    }
}

fn binary(bytes: &[u8], context: &mut Context<'_>) -> Parsed<Vec<Part>> {
    let Some(promised) = stl_length(bytes) else {
        return Err(Fault::new(format!(
            "neither ASCII STL (no `solid`) nor binary: {} bytes are too few for its header of {HEADER}",
            bytes.len()
        )));
    };
    let records = &bytes[HEADER..];
    let there = records.len() / RECORD;
    let count = usize::try_from((promised - HEADER as u64) / RECORD as u64).unwrap_or(usize::MAX);
    let used = if count == 0 || count == u32::MAX as usize {
        if there > 0 {
            context
                .notes
                .push(format!("the header says {count} triangles; the file holds {there}, all are read"));
        }
        there
    } else if count <= there {
        if promised < bytes.len() as u64 {
            let extra = bytes.len() as u64 - promised;
            let bytes = if extra == 1 { "byte" } else { "bytes" };
            context.notes.push(format!("ignored: {extra} {bytes} after the last triangle"));
        }
        count
    } else {
        return Err(Fault::new(format!(
            "the header says {count} triangles, {promised} bytes, but the file has {} bytes: it is cut off or no \
             STL; copy or export it again",
            bytes.len()
        ))
        .at(Place::Byte(80)));
    };
    if used == 0 {
        return Err(Fault::new(
            "this is an empty STL: it has no face after its header; export it again with the model in it",
        ));
    }
    let mut weld = Weld::default();
    let mut triangles = Vec::with_capacity(used);
    for record in records.chunks_exact(RECORD).take(used) {
        let mut triangle = [0; 3];
        for (corner, index) in record[12..48].chunks_exact(12).zip(&mut triangle) {
            let coordinate =
                |at: usize| f32::from_le_bytes([corner[at], corner[at + 1], corner[at + 2], corner[at + 3]]);
            *index = weld.index([coordinate(0), coordinate(4), coordinate(8)])?;
        }
        triangles.push(triangle);
    }
    let draft = Draft { positions: weld.positions, triangles, ..Draft::default() };
    Ok(vec![part(context.stem.clone(), draft, context)?])
}

fn part(name: String, draft: Draft, context: &mut Context<'_>) -> Parsed<Part> {
    let mesh = draft.finish(&mut context.skipped)?;
    Ok(Part { name, mesh, placement: Placement::default(), color: None, materials: Vec::new() })
}

/// The solid and the facet that are being read.
struct Ascii {
    name: Vec<u8>,
    weld: Weld,
    draft: Draft,
    corners: Vec<[f32; 3]>,
    cutter: Cutter,
    /// Where the facet began, while one is open.
    facet: Option<u64>,
    /// Whether a solid is open.
    solid: bool,
}

fn ascii(bytes: &[u8], context: &mut Context<'_>) -> Parsed<Vec<Part>> {
    let mut reader = Ascii {
        name: Vec::new(),
        weld: Weld::default(),
        draft: Draft::default(),
        corners: Vec::new(),
        cutter: Cutter::new(),
        facet: None,
        solid: false,
    };
    let mut parts = Vec::new();
    for (number, line) in Lines::new(bytes) {
        let words = Words::new(line);
        reader.line(words, number, context, &mut parts).map_err(|fault| fault.at(Place::Line(number)))?;
    }
    if let Some(start) = reader.facet {
        return Err(Fault::new("this facet does not end: the file is cut off; copy or export it again")
            .at(Place::Line(start)));
    }
    if reader.solid {
        reader.close(context, &mut parts)?;
        let read: usize = parts.iter().map(|part| part.mesh.triangles().len()).sum();
        let triangles = if read == 1 { "triangle was" } else { "triangles were" };
        context.notes.push(format!(
            "the last `endsolid` is missing: the file may be cut off; {read} {triangles} read"
        ));
    }
    Ok(parts)
}

impl Ascii {
    fn line(
        &mut self,
        mut words: Words<'_>,
        number: u64,
        context: &mut Context<'_>,
        parts: &mut Vec<Part>,
    ) -> Parsed<()> {
        let Some(word) = words.next() else { return Ok(()) };
        let is = |keyword: &str| word.eq_ignore_ascii_case(keyword.as_bytes());
        if is("vertex") {
            let mut corner = [0.0; 3];
            for coordinate in &mut corner {
                let word = words
                    .next()
                    .ok_or_else(|| Fault::new("a vertex needs three coordinates: the file may be cut off"))?;
                *coordinate = float(word)
                    .ok_or_else(|| Fault::new(format!("`{}` is not a number", quote(word, 40))))?;
            }
            if self.facet.is_none() {
                return Err(Fault::new("a vertex outside a facet: the file is broken, export it again"));
            }
            self.corners.push(corner);
        } else if is("facet") {
            if let Some(start) = self.facet {
                return Err(Fault::new(format!("a facet begins, but that of line {start} has not ended")));
            }
            self.facet = Some(number);
            self.solid = true;
            self.corners.clear();
        } else if is("endfacet") {
            let start = self.facet.take();
            self.end_facet(start, context)?;
        } else if is("solid") {
            if self.solid {
                self.close(context, parts)?;
            }
            self.solid = true;
            self.name = words.rest().to_vec();
        } else if is("endsolid") {
            self.close(context, parts)?;
        } else if !["outer", "endloop", "normal", "color"].iter().any(|known| is(known)) {
            context.skipped.add(SkippedKind::UnknownStatements, 1, Some(Place::Line(number)));
        }
        Ok(())
    }

    fn end_facet(&mut self, start: Option<u64>, context: &mut Context<'_>) -> Parsed<()> {
        if self.corners.len() < 3 {
            context.skipped.add(SkippedKind::ShortFaces, 1, start.map(Place::Line));
            self.corners.clear();
            return Ok(());
        }
        let mut indices = Vec::with_capacity(self.corners.len());
        for &corner in &self.corners {
            indices.push(self.weld.index(corner)?);
        }
        if indices.len() > 3 && self.draft.sides.is_none() {
            let sides = self.draft.triangles.iter().flat_map(|&[a, b, c]| [[a, b], [b, c], [c, a]]);
            self.draft.sides = Some(sides.collect());
        }
        if let Some(sides) = &mut self.draft.sides {
            let next = indices.iter().cycle().skip(1);
            sides.extend(indices.iter().zip(next).map(|(&a, &b)| [a, b]));
        }
        let triangles = self.cutter.cut(self.corners.iter().copied());
        self.draft.triangles.extend(triangles.iter().map(|triangle| triangle.map(|corner| indices[corner])));
        self.corners.clear();
        Ok(())
    }

    /// Ends the solid that is open.
    fn close(&mut self, context: &mut Context<'_>, parts: &mut Vec<Part>) -> Parsed<()> {
        if let Some(start) = self.facet {
            return Err(Fault::new(format!("the solid ends, but the facet of line {start} has not")));
        }
        let name = core::mem::take(&mut self.name);
        let name = if name.is_empty() { context.stem.clone() } else { quote(&name, 200) };
        let weld = core::mem::take(&mut self.weld);
        let draft = Draft { positions: weld.positions, ..core::mem::take(&mut self.draft) };
        self.solid = false;
        if draft.triangles.is_empty() {
            context.skipped.add(SkippedKind::EmptyParts, 1, None);
        } else {
            parts.push(part(name, draft, context)?);
        }
        Ok(())
    }
}
