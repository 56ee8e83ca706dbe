//! The depths that the methods keep, each in its own precision.

use alloc::vec::Vec;
use core::ops::Range;

/// What [`draw`](super::draw) leaves behind: the depth at each pixel of the target's rows.
///
/// Kept by the caller between pictures only to save the allocation; every call clears it.
#[derive(Clone, Debug, Default)]
pub struct ZBuffer {
    width: u32,
    rows: Range<u32>,
    /// One of the two is in use, or none.
    single: Vec<f32>,
    double: Vec<f64>,
}

impl ZBuffer {
    /// An empty one.
    #[must_use]
    pub const fn new() -> Self {
        Self { width: 0, rows: 0..0, single: Vec::new(), double: Vec::new() }
    }

    /// The depth at a pixel, larger is nearer; `None` outside of the rows that were drawn, and for methods that keep
    /// none. Depths of methods that store `f32` are those exactly. Where nothing was drawn it is what was cleared:
    /// −∞, or 0 by the exact method (+∞ with [`DepthTest::Less`](crate::DepthTest::Less)).
    #[must_use]
    pub fn at(&self, x: u32, y: u32) -> Option<f64> {
        if x >= self.width || !self.rows.contains(&y) {
            return None;
        }
        let at = (y - self.rows.start) as usize * self.width as usize + x as usize;
        self.double.get(at).copied().or_else(|| self.single.get(at).copied().map(f64::from))
    }

    /// Makes room for a picture's rows in one precision and clears it.
    pub(super) fn clear<Z: Precision>(&mut self, width: u32, rows: Range<u32>, to: Z) {
        self.forget();
        let count = rows.len() * width as usize;
        Z::of(self).resize(count, to);
        (self.width, self.rows) = (width, rows);
    }

    /// Keeps no depth.
    pub(super) fn forget(&mut self) {
        self.single.clear();
        self.double.clear();
        (self.width, self.rows) = (0, 0..0);
    }
}

/// A precision in which depth is stored.
pub(super) trait Precision: Copy + PartialOrd {
    fn of(buffer: &mut ZBuffer) -> &mut Vec<Self>;
}

impl Precision for f32 {
    #[inline]
    fn of(buffer: &mut ZBuffer) -> &mut Vec<Self> {
        &mut buffer.single
    }
}

impl Precision for f64 {
    #[inline]
    fn of(buffer: &mut ZBuffer) -> &mut Vec<Self> {
        &mut buffer.double
    }
}
