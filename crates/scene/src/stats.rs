//! What became of a frame.

use core::ops::AddAssign;

/// Counts of a drawn frame.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, Default)]
pub struct DrawStats {
    /// Objects that were drawn.
    pub objects: u64,
    /// What became of their triangles.
    pub triangles: polosa_raster::Stats,
    /// Triangles that are not among these: left out, since [balls inside their mesh](crate::World::occluders) hide
    /// them.
    pub hidden: u64,
    /// What became of their edges.
    pub lines: polosa_raster::Stats,
}

impl AddAssign for DrawStats {
    fn add_assign(&mut self, other: Self) {
        self.objects += other.objects;
        self.triangles += other.triangles;
        self.hidden += other.hidden;
        self.lines += other.lines;
    }
}
