//! PLY, read by `ply-rs-bw`: its header, and its elements one by one.
//!
//! The library is handed one line or one run of bytes at a time, so that this module knows the place of every
//! error and no table of elements is built only to be copied. Before that, the header's counts are held against
//! the bytes that follow it.
//!
//! - `vertex`: `x y z`, `nx ny nz`, `s t` (or `u v`, `texture_u texture_v`), `red green blue` as bytes or as
//!   floats between 0 and 1.
//! - `face`: `vertex_indices` or `vertex_index`, any number of corners; `red green blue`.
//! - `tristrips`: `vertex_indices`, strips ended by −1.
//!
//! Vertex colours count before face colours, unless all vertices have the same.

mod element;

use std::io::ErrorKind;

use ply_rs_bw::parser::{ParseError, Parser, Reader};
use ply_rs_bw::ply::{ElementDef, Encoding, PropertyType, ScalarType};
use polosa_math::Placement;

use super::draft::{Draft, Values};
use super::error::{Fault, Parsed, Place, quote};
use super::polygon::Cutter;
use super::skipped::SkippedKind;
use super::text::Lines;
use super::{Context, Part};
use crate::Color;
use element::Element;

/// Everything that is kept of the elements.
#[derive(Default)]
struct Content {
    positions: Vec<[f32; 3]>,
    normals: Vec<[f32; 3]>,
    uvs: Vec<[f32; 2]>,
    vertex_colors: Vec<Color>,
    /// The corners of all faces, one face after the other.
    corners: Vec<u32>,
    /// Where each face's corners end.
    ends: Vec<usize>,
    face_colors: Vec<Color>,
}

/// What an element's entries are.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Kind {
    Vertex,
    Face,
    Strips,
    Edge,
    Other,
}

pub(super) fn read(bytes: &[u8], context: &mut Context<'_>) -> Parsed<Vec<Part>> {
    let parser = Parser::<Element>::new();
    let mut reader = Reader::new(bytes);
    let header = parser.read_header(&mut reader).map_err(|error| {
        if let Some(fault) = uncountable(bytes) {
            return fault;
        }
        let fault =
            Fault::new(format!("this PLY header is not understood ({}): export it again", one_line(&error)));
        match error.line() {
            Some(line) => fault.at(Place::Line(line as u64)),
            None => fault,
        }
    })?;
    let body: &[u8] = reader.get_ref();
    check_counts(header.elements.values(), header.encoding, body)?;
    if !header.elements.contains_key("vertex") {
        return Err(Fault::new("the header has no element `vertex`: this PLY file holds no mesh"));
    }

    let header_bytes = bytes.len() - body.len();
    let header_lines = bytes[..header_bytes].iter().filter(|&&byte| byte == b'\n').count() as u64;
    let mut rest = body;
    let mut lines = Lines::new(body);
    let mut content = Content::default();
    for definition in header.elements.values().filter(|definition| !definition.properties.is_empty()) {
        let kind = match definition.name.as_str() {
            "vertex" => Kind::Vertex,
            "face" => Kind::Face,
            "tristrips" => Kind::Strips,
            "edge" => Kind::Edge,
            _ => Kind::Other,
        };
        if kind == Kind::Vertex
            && !["x", "y", "z"].iter().all(|axis| definition.properties.contains_key(*axis))
        {
            return Err(Fault::new("the vertices have no properties `x`, `y` and `z`: export it again"));
        }
        for entry in 0..definition.count {
            let cut_off = || {
                Fault::new(format!(
                    "the header says {} entries of `{}`, but the file ends in entry {entry}: it is cut off; copy or \
                     export it again",
                    definition.count,
                    quote(definition.name.as_bytes(), 40)
                ))
            };
            let (element, place) = if header.encoding == Encoding::Ascii {
                let (number, line) =
                    lines.by_ref().find(|(_, line)| !line.trim_ascii().is_empty()).ok_or_else(cut_off)?;
                let place = Place::Line(header_lines + number);
                let text = core::str::from_utf8(line)
                    .map_err(|_| Fault::new("this line is not text: the file is broken").at(place))?;
                (parser.read_ascii_element(text.trim_ascii(), definition), place)
            } else {
                let place = Place::Byte((bytes.len() - rest.len()) as u64);
                let element = if header.encoding == Encoding::BinaryBigEndian {
                    parser.read_big_endian_element(&mut rest, definition)
                } else {
                    parser.read_little_endian_element(&mut rest, definition)
                };
                (element, place)
            };
            let element = element.map_err(|error| {
                if error.kind() == ErrorKind::UnexpectedEof || rest.is_empty() {
                    return cut_off().at(place);
                }
                let (what, name) = (one_line(&error), quote(definition.name.as_bytes(), 40));
                Fault::new(format!("entry {entry} of `{name}` is not understood ({what}): export it again"))
                    .at(place)
            })?;
            content.add(kind, &element, context, place).map_err(|fault| fault.at(place))?;
        }
        if kind == Kind::Edge {
            context.skipped.add(SkippedKind::LinesAndPoints, definition.count as u64, None);
        }
    }
    let mesh = content.draft()?.finish(&mut context.skipped)?;
    let name = context.stem.clone();
    Ok(vec![Part { name, mesh, placement: Placement::default(), color: None, materials: Vec::new() }])
}

/// A count in the header with more digits than a number has room for, about which the library says no more than
/// that it is no number.
fn uncountable(bytes: &[u8]) -> Option<Fault> {
    let header =
        Lines::new(bytes).take_while(|(_, line)| line.trim_ascii() != b"end_header").take(MOST_LINES);
    for (number, line) in header {
        let mut words = line.split(u8::is_ascii_whitespace).filter(|word| !word.is_empty());
        let (Some(b"element"), Some(name), Some(count)) = (words.next(), words.next(), words.next()) else {
            continue;
        };
        let digits = count.iter().all(u8::is_ascii_digit);
        if digits && core::str::from_utf8(count).is_ok_and(|count| count.parse::<usize>().is_err()) {
            let (count, name) = (quote(count, 40), quote(name, 40));
            return Some(
                Fault::new(format!(
                    "the header says {count} entries of `{name}`, more than any file can hold: it is broken; export \
                     it again"
                ))
                .at(Place::Line(number)),
            );
        }
    }
    None
}

/// Lines of a header that is not understood in which the reason is looked for.
const MOST_LINES: usize = 1000;

/// Refuses counts that the bytes after the header cannot hold: the least that an entry takes is a byte for each
/// list's length and each number's own size, or a digit and a separator in ASCII.
fn check_counts<'a>(
    elements: impl Iterator<Item = &'a ElementDef>,
    encoding: Encoding,
    body: &[u8],
) -> Parsed<()> {
    let mut least = 0_u128;
    for element in elements {
        let entry: u128 = element
            .properties
            .values()
            .map(|property| match (&property.data_type, encoding) {
                (_, Encoding::Ascii) => 2,
                (PropertyType::Scalar(scalar) | PropertyType::List(scalar, _), _) => size(scalar),
            })
            .sum();
        least += entry * element.count as u128;
        // The last number of a text may have no separator after it.
        if least > body.len() as u128 + 1 {
            return Err(Fault::new(format!(
                "the header says {} entries of `{}`, more than {} bytes can hold: it is cut off or broken; copy or \
                 export it again",
                element.count,
                quote(element.name.as_bytes(), 40),
                body.len()
            )));
        }
    }
    Ok(())
}

const fn size(scalar: &ScalarType) -> u128 {
    match scalar {
        ScalarType::Char | ScalarType::UChar => 1,
        ScalarType::Short | ScalarType::UShort => 2,
        ScalarType::Int | ScalarType::UInt | ScalarType::Float => 4,
        ScalarType::Double => 8,
    }
}

/// The library's message, which may have several lines.
fn one_line(error: &ParseError) -> String {
    let text = error.to_string();
    let words: Vec<&str> = text.split_whitespace().collect();
    quote(words.join(" ").as_bytes(), 120)
}

impl Content {
    fn add(&mut self, kind: Kind, element: &Element, context: &mut Context<'_>, place: Place) -> Parsed<()> {
        match kind {
            Kind::Vertex => {
                self.positions.push(element.position);
                self.normals.extend(element.normal);
                self.uvs.extend(element.uv);
                self.vertex_colors.extend(element.color());
            }
            Kind::Face => {
                let indices = element.indices()?;
                if indices.len() < 3 {
                    context.skipped.add(SkippedKind::ShortFaces, 1, Some(place));
                    return Ok(());
                }
                for index in indices {
                    self.corners.push(index.map_err(|index| outside(index, None))?);
                }
                self.ends.push(self.corners.len());
                self.face_colors.extend(element.color());
            }
            Kind::Strips => self.add_strips(element)?,
            Kind::Edge | Kind::Other => {}
        }
        Ok(())
    }

    /// Strips a, b, c, d, … of triangles abc, cbd, …, each ended by −1.
    fn add_strips(&mut self, element: &Element) -> Parsed<()> {
        let mut strip: Vec<u32> = Vec::new();
        for index in element.indices()? {
            match index {
                Ok(index) => strip.push(index),
                Err(-1) => strip.clear(),
                Err(index) => return Err(outside(index, None)),
            }
            if let &[.., a, b, c] = strip.as_slice() {
                let turned = strip.len().is_multiple_of(2);
                self.corners.extend(if turned { [b, a, c] } else { [a, b, c] });
                self.ends.push(self.corners.len());
            }
        }
        Ok(())
    }

    fn draft(mut self) -> Parsed<Draft> {
        let vertices = self.positions.len();
        if let Some(at) = self.corners.iter().position(|&corner| corner as usize >= vertices) {
            let face = self.ends.partition_point(|&end| end <= at) as u64;
            let fault = outside(i64::from(self.corners[at]), Some(vertices));
            return Err(fault.at(Place::Item("face", face)));
        }
        let mut draft = Draft::default();
        let polygons = self.ends.iter().scan(0, |start, &end| Some(core::mem::replace(start, end)..end));
        if polygons.clone().all(|polygon| polygon.len() == 3) {
            draft.triangles = self.corners.chunks_exact(3).map(|c| [c[0], c[1], c[2]]).collect();
        } else {
            let mut cutter = Cutter::new();
            let (mut sides, mut colors) = (Vec::new(), Vec::new());
            for (number, polygon) in polygons.enumerate() {
                let corners = &self.corners[polygon];
                let next = corners.iter().cycle().skip(1);
                sides.extend(corners.iter().zip(next).map(|(&a, &b)| [a, b]));
                let cut = cutter.cut(corners.iter().map(|&corner| self.positions[corner as usize]));
                if let Some(&color) = self.face_colors.get(number) {
                    colors.resize(colors.len() + cut.len(), color);
                }
                draft.triangles.extend(cut.iter().map(|triangle| triangle.map(|corner| corners[corner])));
            }
            draft.sides = Some(sides);
            self.face_colors = colors;
        }
        let complete = |count: usize, of: usize| count == of && of > 0;
        let faces = complete(self.face_colors.len(), draft.triangles.len());
        let uniform = self.vertex_colors.windows(2).all(|pair| pair[0] == pair[1]);
        if complete(self.vertex_colors.len(), vertices) && !(uniform && faces) {
            draft.vertex_colors = Some(self.vertex_colors);
        } else if faces {
            draft.face_colors = Some(self.face_colors);
        }
        draft.normals =
            complete(self.normals.len(), vertices).then_some(Values { values: self.normals, indices: None });
        draft.uvs = complete(self.uvs.len(), vertices).then_some(Values { values: self.uvs, indices: None });
        draft.positions = self.positions;
        Ok(draft)
    }
}

fn outside(index: i64, vertices: Option<usize>) -> Fault {
    let there = vertices.map_or_else(String::new, |vertices| format!(", but the file has {vertices}"));
    Fault::new(format!("a face names vertex {index}{there}: the file is broken, export it again"))
}
