//! What became of a frame.

use core::ops::AddAssign;

/// Counts of a drawn frame.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, Default)]
pub struct DrawStats {
    /// Objects that were drawn.
    pub objects: u64,
    /// What became of their triangles.
    pub triangles: polosa_raster::Stats,
    /// What became of their edges.
    pub lines: polosa_raster::Stats,
}

impl AddAssign for DrawStats {
    fn add_assign(&mut self, other: Self) {
        self.objects += other.objects;
        self.triangles += other.triangles;
        self.lines += other.lines;
    }
}
