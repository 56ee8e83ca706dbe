//! Faces: corners resolved against the tables, polygons cut into triangles.

use super::super::draft::MISSING;
use super::super::error::Fault;
use super::super::polygon::Cutter;
use super::Tables;

/// What the three indices of a corner name, in their order.
const NAMES: [(&str, &str); 3] =
    [("vertex", "vertices"), ("texture coordinate", "texture coordinates"), ("normal", "normals")];

/// A corner as it is written: `v`, `v/vt`, `v//vn` or `v/vt/vn`; 0 where an index is left out.
pub(super) struct Corner([i64; 3]);

/// An index that names nothing.
pub(super) struct Outside {
    kind: usize,
    index: i64,
    /// How many there are.
    count: usize,
    /// Whether a later statement may still provide it.
    pub(super) later: bool,
}

impl Corner {
    #[inline]
    pub(super) fn parse(word: &[u8]) -> Option<Self> {
        let mut corner = [0; 3];
        let mut rest = word;
        for (kind, slot) in corner.iter_mut().enumerate() {
            let (index, after) = integer(rest)?;
            // The vertex must be there, and nothing may be called 0.
            match index {
                Some(0) | None if kind == 0 => return (index == Some(0)).then_some(Self([0; 3])),
                Some(index) => *slot = index,
                None => {}
            }
            match after.split_first() {
                None => return Some(Self(corner)),
                Some((b'/', after)) => rest = after,
                Some(_) => return None,
            }
        }
        None
    }

    /// Indices into the tables, from 0.
    #[inline]
    pub(super) fn resolve(&self, tables: &Tables) -> Result<[u32; 3], Outside> {
        let counts = [tables.positions.len(), tables.uvs.len(), tables.normals.len()];
        let mut resolved = [MISSING; 3];
        for kind in 0..3 {
            let index = self.0[kind];
            if index == 0 && kind > 0 {
                continue;
            }
            let absolute = if index > 0 { index - 1 } else { index + tables.seen[kind] as i64 };
            let inside = index != 0 && absolute >= 0 && (absolute as u64) < counts[kind] as u64;
            match u32::try_from(absolute) {
                Ok(absolute) if inside => resolved[kind] = absolute,
                _ => return Err(Outside { kind, index, count: counts[kind], later: index > 0 }),
            }
        }
        Ok(resolved)
    }
}

/// A signed integer at the start, `None` when there is none, and what follows it; fails on one beyond 18 digits.
#[inline]
fn integer(bytes: &[u8]) -> Option<(Option<i64>, &[u8])> {
    let negative = bytes.first() == Some(&b'-');
    let digits = if negative { &bytes[1..] } else { bytes };
    let mut value = 0_i64;
    let mut length = 0;
    while let Some(digit @ b'0'..=b'9') = digits.get(length) {
        if length == 18 {
            return None;
        }
        value = value * 10 + i64::from(digit - b'0');
        length += 1;
    }
    let value = if length == 0 { None } else { Some(if negative { -value } else { value }) };
    if negative && value.is_none() { None } else { Some((value, &digits[length..])) }
}

impl Outside {
    #[cold]
    pub(super) fn fault(&self) -> Fault {
        let (one, many) = NAMES[self.kind];
        let Self { index, count, .. } = self;
        Fault::new(match index {
            0 => format!("a face names {one} 0, but OBJ counts from 1"),
            1.. => {
                let there = if *count == 1 { one } else { many };
                format!("a face names {one} {index}, but the file has {count} {there}: it may be cut off")
            }
            _ => format!("a face names {one} {index}, but there are fewer {many} before it"),
        })
    }
}

/// The triangles of the file so far.
pub(super) struct Faces {
    pub(super) triangles: Vec<[u32; 3]>,
    /// Empty until a face has texture coordinates, then one for each triangle.
    pub(super) uvs: Vec<[u32; 3]>,
    /// Empty until a face has normals, then one for each triangle.
    pub(super) normals: Vec<[u32; 3]>,
    /// The sides of all faces, once one of them is not a triangle.
    pub(super) sides: Option<Vec<[u32; 2]>>,
    /// The face that is being read.
    pub(super) corners: Vec<[u32; 3]>,
    cutter: Cutter,
}

impl Faces {
    pub(super) fn new() -> Self {
        Self {
            triangles: Vec::new(),
            uvs: Vec::new(),
            normals: Vec::new(),
            sides: None,
            corners: Vec::new(),
            cutter: Cutter::new(),
        }
    }

    /// Triangles and sides so far. While there are triangles only, they have three sides each.
    pub(super) fn counts(&self) -> (usize, usize) {
        let triangles = self.triangles.len();
        (triangles, self.sides.as_ref().map_or(3 * triangles, Vec::len))
    }

    /// Adds the face of `corners`, of which there are at least three, all with positions in the table.
    #[inline]
    pub(super) fn push(&mut self, positions: &[[f32; 3]]) {
        if let &[a, b, c] = self.corners.as_slice() {
            if let Some(sides) = &mut self.sides {
                sides.extend([[a[0], b[0]], [b[0], c[0]], [c[0], a[0]]]);
            }
            self.triangle([a, b, c]);
            return;
        }
        let sides = self.sides.get_or_insert_with(|| {
            self.triangles.iter().flat_map(|&[a, b, c]| [[a, b], [b, c], [c, a]]).collect()
        });
        let next = self.corners.iter().cycle().skip(1);
        sides.extend(self.corners.iter().zip(next).map(|(a, b)| [a[0], b[0]]));
        let mut cutter = core::mem::replace(&mut self.cutter, Cutter::new());
        for triangle in cutter.cut(self.corners.iter().map(|c| positions[c[0] as usize])) {
            self.triangle(triangle.map(|corner| self.corners[corner]));
        }
        self.cutter = cutter;
    }

    #[inline]
    fn triangle(&mut self, corners: [[u32; 3]; 3]) {
        let before = self.triangles.len();
        self.triangles.push(corners.map(|corner| corner[0]));
        for (kind, indices) in [(1, &mut self.uvs), (2, &mut self.normals)] {
            if !indices.is_empty() || corners.iter().any(|corner| corner[kind] != MISSING) {
                indices.resize(before, [MISSING; 3]);
                indices.push(corners.map(|corner| corner[kind]));
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::Corner;

    #[test]
    fn corners_are_read_in_their_four_forms() {
        for (word, indices) in [
            ("7", Some([7, 0, 0])),
            ("-1/2", Some([-1, 2, 0])),
            ("3//-4", Some([3, 0, -4])),
            ("1/2/3", Some([1, 2, 3])),
            ("5/", Some([5, 0, 0])),
            ("5//", Some([5, 0, 0])),
            ("0", Some([0, 0, 0])),
            ("", None),
            ("/1", None),
            ("1/2/3/4", None),
            ("1a", None),
            ("-", None),
            ("1/-", None),
            ("1.5", None),
            ("12345678901234567890", None),
        ] {
            assert_eq!(Corner::parse(word.as_bytes()).map(|corner| corner.0), indices, "{word}");
        }
    }
}
