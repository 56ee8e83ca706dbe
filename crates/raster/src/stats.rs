//! What became of the triangles of a draw call.

use core::ops::{Add, AddAssign};

/// Counts of triangles, or of lines, after a draw call.
///
/// Each one that was submitted is counted once more under exactly one of `not_finite`, `bad_index`, `outside`,
/// `degenerate`, `culled` and `drawn`. Add the counts of several calls with `+`.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, Default)]
pub struct Stats {
    /// Handed over.
    pub submitted: u64,
    /// Rejected: a coordinate is infinite or NaN, or w is not positive after clipping.
    pub not_finite: u64,
    /// Rejected: an index names a vertex that is not there.
    pub bad_index: u64,
    /// Wholly beyond the near or the far plane or the guard band.
    pub outside: u64,
    /// Without area (a line: without length) once the vertices are on sub-pixels.
    pub degenerate: u64,
    /// Left out for the side they show.
    pub culled: u64,
    /// Drawn, be it on no pixel, behind others or beside the picture.
    pub drawn: u64,
    /// Of all these, those that a plane cut.
    pub clipped: u64,
}

impl Add for Stats {
    type Output = Self;

    fn add(self, other: Self) -> Self {
        Self {
            submitted: self.submitted + other.submitted,
            not_finite: self.not_finite + other.not_finite,
            bad_index: self.bad_index + other.bad_index,
            outside: self.outside + other.outside,
            degenerate: self.degenerate + other.degenerate,
            culled: self.culled + other.culled,
            drawn: self.drawn + other.drawn,
            clipped: self.clipped + other.clipped,
        }
    }
}

impl AddAssign for Stats {
    fn add_assign(&mut self, other: Self) {
        *self = *self + other;
    }
}
