//! Which pixels a triangle covers: the methods by name.

use core::ops::Range;

use polosa_math::SUB_PIXELS;

use super::grid::Grid;
use super::names::methods;
use super::{Corner, barycentric, exact, float_edges, float_scan, same_side, vertical};
use crate::{Rect, Sample};

methods! {
    /// A way to find the pixels of a triangle.
    ///
    /// All sample the centre of a pixel, so that they can be compared. The seeds sample its upper left corner; ask
    /// for that with [`visit`](Self::visit) or [`State::sample`](crate::State::sample).
    Coverage, "way to fill" {
        Strips, "strips", "exact strips on 1/256 pixel, the default: no pixel wrong";
        Edges, "edges", "exact edge functions over the box: the same pixels";
        Barycentric, "barycentric", "S0: weights from 0 to 1 over the box, in f64: shared sides are drawn twice, three divisions a pixel";
        SameSide, "same-side", "S3: products of cross products over the box: shared sides are drawn twice, corners on a line fill their box";
        VerticalStrips, "vertical-strips", "S4, mended to be half-open: each pixel once, but ties fall to other pixels than by the top-left rule";
        VerticalStripsClosed, "vertical-strips-closed", "S4 as it is, both ends included: shared sides are drawn twice, an upright right side loses its column";
        WholePixels, "whole-pixels", "S1: vertices cut off to whole pixels, then filled exactly: shapes are wrong, and jitter when they move";
        FloatEdges, "float-edges", "edge functions in f32 without snapping: holes along shared sides, the more the longer they are";
        FloatScan, "float-scan", "sides stepped in f32 from row to row: holes and doubles along shared sides";
    }
}

/// Takes the pixels that a triangle covers.
///
/// A closure `FnMut(x, y)` does. Implement the other methods to take pixels as the method finds them: a row at a time,
/// or a column.
pub trait Visit {
    /// The pixel in column `x` of row `y`.
    fn pixel(&mut self, x: u32, y: u32);

    /// A run of pixels in a row.
    #[inline]
    fn row(&mut self, y: u32, columns: Range<u32>) {
        for x in columns {
            self.pixel(x, y);
        }
    }

    /// A run of pixels in a column, from a strip that reaches from `ends[0]` to `ends[1]`, in pixels.
    #[inline]
    fn column(&mut self, x: u32, rows: Range<u32>, ends: [f64; 2]) {
        let _ = ends;
        for y in rows {
            self.pixel(x, y);
        }
    }
}

impl<F: FnMut(u32, u32)> Visit for F {
    #[inline]
    fn pixel(&mut self, x: u32, y: u32) {
        self(x, y);
    }
}

impl Coverage {
    /// Hands over the pixels of a picture of `width` × `height` that the triangle covers.
    ///
    /// Corners may be anything, at any distance: infinite, NaN, without area. Nothing panics, and the time it takes is
    /// bounded by the picture's size. Pixels beyond [`MAX_SIDE`](crate::MAX_SIDE) are left out.
    ///
    /// ```
    /// use polosa_raster::reference::Coverage;
    ///
    /// let line = [[0.0, 0.0, 0.0], [50.0, 50.0, 0.0], [100.0, 100.0, 0.0]];
    /// let count = |method: Coverage| {
    ///     let mut pixels = 0;
    ///     method.pixels(200, 200, &line, &mut |_, _| pixels += 1);
    ///     pixels
    /// };
    /// assert_eq!(count(Coverage::Strips), 0);
    /// assert_eq!(count(Coverage::SameSide), 10_000, "a line has no area, yet fills its box");
    /// ```
    pub fn pixels(self, width: u32, height: u32, corners: &[Corner; 3], visit: &mut dyn FnMut(u32, u32)) {
        let all = Rect { x0: 0, y0: 0, x1: width, y1: height };
        self.visit(all, Sample::CENTER, corners, &mut |x, y| visit(x, y));
    }

    /// The same inside any rectangle, at any sample, and compiled for its visitor: for measuring.
    ///
    /// It hands over a run where the method finds one, which the exact strips' speed rests on.
    #[inline]
    pub fn visit(self, within: Rect, sample: Sample, corners: &[Corner; 3], visit: &mut impl Visit) {
        self.cover(&Grid::new(within, sample), corners, visit);
    }

    #[inline]
    pub(super) fn cover(self, grid: &Grid, corners: &[Corner; 3], visit: &mut (impl Visit + ?Sized)) {
        match self {
            Self::Strips => exact::strips(grid, corners, visit),
            Self::Edges => exact::edges(grid, corners, visit),
            Self::Barycentric => barycentric::cover(grid, corners, visit),
            Self::SameSide => same_side::cover(grid, corners, visit),
            Self::VerticalStrips => vertical::cover(grid, corners, visit),
            Self::VerticalStripsClosed => vertical::cover_closed(grid, corners, visit),
            Self::WholePixels => exact::strips(grid, &exact::truncated(grid.sample, corners), visit),
            Self::FloatEdges => float_edges::cover(grid, corners, visit),
            Self::FloatScan => float_scan::cover(grid, corners, visit),
        }
    }

    /// Whether vertices snap to sub-pixels.
    pub(super) const fn snaps(self) -> bool {
        matches!(self, Self::Strips | Self::Edges)
    }

    /// Where the method has the corners: depth is a plane over the same place as the pixels.
    pub(super) fn placed(self, sample: Sample, corners: &[Corner; 3]) -> [Corner; 3] {
        match self {
            Self::Strips | Self::Edges => exact::snapped(corners).map_or(*corners, |snapped| {
                [0, 1, 2].map(|k| {
                    let [x, y] = [snapped[k].x, snapped[k].y].map(|v| f64::from(v) / f64::from(SUB_PIXELS));
                    [x, y, corners[k][2]]
                })
            }),
            Self::WholePixels => exact::truncated(sample, corners),
            _ => *corners,
        }
    }
}
