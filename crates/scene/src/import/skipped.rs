//! What a file holds and a model does not: counted, never silently lost.

use core::fmt;

use super::error::Place;

/// A kind of thing that was skipped.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum SkippedKind {
    /// Faces with fewer than three corners.
    ShortFaces,
    /// Lines and points.
    LinesAndPoints,
    /// Free-form curves and surfaces of OBJ.
    FreeForm,
    /// Statements that the format does not have.
    UnknownStatements,
    /// Vertices that no face uses: they would only enlarge the model's bounds.
    UnusedVertices,
    /// Parts without a face.
    EmptyParts,
}

impl SkippedKind {
    /// What it is called in a report, in the plural.
    #[must_use]
    pub const fn label(self) -> &'static str {
        match self {
            Self::ShortFaces => "faces with fewer than three corners",
            Self::LinesAndPoints => "lines and points",
            Self::FreeForm => "free-form curves and surfaces",
            Self::UnknownStatements => "unknown statements",
            Self::UnusedVertices => "vertices that no face uses",
            Self::EmptyParts => "parts without a face",
        }
    }

    /// What one of them is called.
    #[must_use]
    pub const fn singular(self) -> &'static str {
        match self {
            Self::ShortFaces => "face with fewer than three corners",
            Self::LinesAndPoints => "line or point",
            Self::FreeForm => "free-form curve or surface",
            Self::UnknownStatements => "unknown statement",
            Self::UnusedVertices => "vertex that no face uses",
            Self::EmptyParts => "part without a face",
        }
    }
}

/// How many of a kind were skipped, and where the first of them is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct SkippedItem {
    /// What.
    pub kind: SkippedKind,
    /// How many.
    pub count: u64,
    /// The first one's place, where one is known.
    pub first: Option<Place>,
}

/// `2 unknown statements (the first at line 7)`.
impl fmt::Display for SkippedItem {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let one = self.count == 1;
        write!(f, "{} {}", self.count, if one { self.kind.singular() } else { self.kind.label() })?;
        match self.first {
            Some(place) if one => write!(f, " (at {place})"),
            Some(place) => write!(f, " (the first at {place})"),
            None => Ok(()),
        }
    }
}

/// Everything that was skipped, by kind.
///
/// Degenerate triangles and coordinates that are not finite are *not* here: they stay in the mesh, so that its
/// triangles are numbered as in the file; drawing counts them, and so does [`Topology`](crate::topology::Topology).
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Skipped {
    items: Vec<SkippedItem>,
}

impl Skipped {
    /// The kinds of which at least one was skipped, in the order in which they were met.
    #[must_use]
    pub fn items(&self) -> &[SkippedItem] {
        &self.items
    }

    /// How many of one kind were skipped.
    #[must_use]
    pub fn count(&self, kind: SkippedKind) -> u64 {
        self.items.iter().find(|item| item.kind == kind).map_or(0, |item| item.count)
    }

    /// Whether nothing was skipped.
    #[must_use]
    pub const fn is_empty(&self) -> bool {
        self.items.is_empty()
    }

    pub(super) fn add(&mut self, kind: SkippedKind, count: u64, first: Option<Place>) {
        if count == 0 {
            return;
        }
        match self.items.iter_mut().find(|item| item.kind == kind) {
            Some(item) => {
                item.count += count;
                item.first = item.first.or(first);
            }
            None => self.items.push(SkippedItem { kind, count, first }),
        }
    }
}
