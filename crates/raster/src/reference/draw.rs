//! A whole picture by any pair of methods.

use alloc::vec::Vec;
use core::ops::Range;

use super::barycentric::{self, Barycentric};
use super::grid::Grid;
use super::pieces::Preparation;
use super::surface::{Constant, Exact, PlaneF32, PlaneF32Origin, PlaneF64, Strip, Surface, Weighted};
use super::vertical::Sorted;
use super::zbuffer::Precision;
use super::{Corner, Coverage, Hidden, Methods, Visit, ZBuffer};
use crate::{Clip, DepthTest, State, Stats, Target};

/// Draws all triangles of a picture, each a triple of indices into `vertices`, with the chosen methods.
///
/// With `Methods::default()` the picture is that of [`Target::triangles`] with [`PerTriangle`](crate::PerTriangle), bit
/// for bit, depth included. `value` is asked for a triangle's pixel by its place in the call, for each piece of a
/// clipped one.
///
/// *All* triangles in one call: the painter's method sorts them, and each call clears `depth`. The target's own depth
/// is neither read nor written, its pixels are not cleared. `state` is obeyed as far as a method can: `Order` has no
/// depth to test or write, `Painter` sorts by it (from near to far for [`DepthTest::Less`]).
///
/// ```
/// use polosa_raster::reference::{Coverage, Hidden, Methods, ZBuffer, draw};
/// use polosa_raster::{Depth, State, Target};
///
/// let vertices = [
///     [-1.0, -1.0, 0.9, 1.0], [1.0, -1.0, 0.9, 1.0], [0.0, 1.0, 0.9, 1.0],
///     [-1.0, -1.0, 0.1, 1.0], [1.0, -1.0, 0.1, 1.0], [0.0, 1.0, 0.1, 1.0],
/// ];
/// let mut centre = |hidden| {
///     let mut color = [0_u8; 64];
///     let mut target = Target::new(&mut color, Depth::None, 8, 8, 8)?;
///     let methods = Methods { coverage: Coverage::Strips, hidden };
///     let triangles = [[0, 1, 2], [3, 4, 5]];
///     draw(&mut target, &mut ZBuffer::new(), methods, &State::default(), &vertices, &triangles, |k| [b'n', b'f'][k as usize]);
///     Ok::<_, polosa_raster::TargetError>(color[36])
/// };
/// assert_eq!(centre(Hidden::Exact)?, b'n');
/// assert_eq!(centre(Hidden::Order)?, b'f', "the last one drawn");
/// assert_eq!(centre(Hidden::StripPrinted)?, b'n', "a tie: both planes are stored as zero");
/// # Ok::<(), polosa_raster::TargetError>(())
/// ```
pub fn draw<P: Copy>(
    target: &mut Target<'_, P>,
    depth: &mut ZBuffer,
    methods: Methods,
    state: &State,
    vertices: &[Clip],
    triangles: &[[u32; 3]],
    value: impl FnMut(u32) -> P,
) -> Stats {
    let preparation = Preparation::new(state, methods.coverage, [target.width, target.height]);
    // As `Target::clear` does it, so that the far plane itself is not seen.
    let farthest = if methods.hidden == Hidden::Exact { 0.0 } else { f64::NEG_INFINITY };
    let mut brush = Brush::new(target, depth, methods, state, farthest);
    brush.all(triangles.len(), value, |k, stats, piece| {
        let [Some(a), Some(b), Some(c)] = triangles[k].map(|k| vertices.get(k as usize)) else {
            stats.bad_index += 1;
            return;
        };
        preparation.vertices([a, b, c], stats, piece);
    })
}

/// The same for corners that are in pixels already: x to the right, y down, any depth.
///
/// Nothing is clipped but by the exact methods at the guard band, 32,768 pixels off; they reject what is not finite, and
/// what `f32` cannot hold. The others take any number, as they would. `state.space` has no say, depth is cleared to −∞
/// for all methods.
pub fn draw_screen<P: Copy>(
    target: &mut Target<'_, P>,
    depth: &mut ZBuffer,
    methods: Methods,
    state: &State,
    triangles: &[[Corner; 3]],
    value: impl FnMut(u32) -> P,
) -> Stats {
    let preparation = Preparation::on_screen(state, methods.coverage);
    let mut brush = Brush::new(target, depth, methods, state, f64::NEG_INFINITY);
    brush.all(triangles.len(), value, |k, stats, piece| preparation.screen(&triangles[k], stats, piece))
}

/// Draws prepared triangles.
struct Brush<'a, 't, P> {
    target: &'a mut Target<'t, P>,
    depth: &'a mut ZBuffer,
    methods: Methods,
    state: &'a State,
    grid: Grid,
}

impl<'a, 't, P: Copy> Brush<'a, 't, P> {
    fn new(
        target: &'a mut Target<'t, P>,
        depth: &'a mut ZBuffer,
        methods: Methods,
        state: &'a State,
        farthest: f64,
    ) -> Self {
        let farthest = if state.test == DepthTest::Less { f64::INFINITY } else { farthest };
        let (width, rows) = (target.width, target.rows.clone());
        match methods.hidden {
            Hidden::Order | Hidden::Painter => depth.forget(),
            Hidden::Sum | Hidden::StripLinear | Hidden::StripPrinted | Hidden::Barycentric => {
                depth.clear(width, rows, farthest);
            }
            Hidden::Exact | Hidden::PlaneF32Origin | Hidden::PlaneF32Vertex | Hidden::PlaneF64 => {
                #[expect(clippy::cast_possible_truncation, reason = "0 or infinite")]
                depth.clear(width, rows, farthest as f32);
            }
        }
        let grid = Grid::new(target.clip(state.scissor), state.sample);
        Self { target, depth, methods, state, grid }
    }

    /// Draws `count` triangles, sorted if the method says so.
    fn all(
        &mut self,
        count: usize,
        mut value: impl FnMut(u32) -> P,
        mut prepare: impl FnMut(usize, &mut Stats, &mut dyn FnMut(&[Corner; 3])),
    ) -> Stats {
        let mut stats = Stats::default();
        let mut sorted: Vec<(f64, u32, [Corner; 3])> = Vec::new();
        let sorts = self.methods.hidden == Hidden::Painter && self.state.test != DepthTest::Off;
        for (k, index) in (0..count).zip(0..) {
            stats.submitted += 1;
            prepare(k, &mut stats, &mut |corners| {
                if sorts {
                    let [a, b, c] = corners.map(|corner| corner[2]);
                    sorted.push(((a + b + c) / 3.0, index, *corners));
                } else {
                    self.triangle(corners, value(index));
                }
            });
        }
        // Far to near; of two at the same depth the first drawn wins, as everywhere, and so is drawn last.
        sorted.reverse();
        match self.state.test {
            DepthTest::Less => sorted.sort_by(|a, b| b.0.total_cmp(&a.0)),
            _ => sorted.sort_by(|a, b| a.0.total_cmp(&b.0)),
        }
        for (_, index, corners) in &sorted {
            self.triangle(corners, value(*index));
        }
        stats
    }

    fn triangle(&mut self, corners: &[Corner; 3], pixel: P) {
        let Self { grid, state, methods: Methods { coverage, hidden }, .. } = *self;
        let placed = &coverage.placed(state.sample, corners);
        let sorted = |as_printed| Strip { grid, sorted: Sorted::new(placed), as_printed };
        let weights = || Weighted { grid, weights: Barycentric::new(placed) };
        match hidden {
            Hidden::Order | Hidden::Painter => {
                let mut fill = Fill { target: self.target, pixel };
                cover(coverage, &grid, corners, &mut fill);
            }
            Hidden::Exact => self.surface(corners, pixel, &Exact::new(&grid, state.sample, placed)),
            Hidden::Sum => {
                self.surface(corners, pixel, &Constant(placed[0][2] + placed[1][2] + placed[2][2]));
            }
            Hidden::StripLinear => self.surface(corners, pixel, &sorted(false)),
            Hidden::StripPrinted => self.surface(corners, pixel, &sorted(true)),
            Hidden::Barycentric if coverage == Coverage::Barycentric => {
                let mut fill = self.tested(pixel, &weights);
                barycentric::with_depth(&grid, corners, |x, y, z| fill.one(x, y, z));
            }
            Hidden::Barycentric => self.surface(corners, pixel, &weights()),
            Hidden::PlaneF32Origin => self.surface(corners, pixel, &PlaneF32Origin::new(&grid, placed)),
            Hidden::PlaneF32Vertex => self.surface(corners, pixel, &PlaneF32::new(&grid, placed)),
            Hidden::PlaneF64 => self.surface(corners, pixel, &PlaneF64::new(&grid, placed)),
        }
    }

    fn surface<S: Surface<Z: Precision>>(&mut self, corners: &[Corner; 3], pixel: P, surface: &S) {
        let (coverage, grid) = (self.methods.coverage, self.grid);
        cover(coverage, &grid, corners, &mut self.tested(pixel, surface));
    }

    fn tested<'s, Z: Precision, S>(&'s mut self, pixel: P, surface: &'s S) -> Tested<'s, 't, P, Z, S> {
        let state = self.state;
        Tested { target: self.target, depth: Z::of(self.depth), state, pixel, surface }
    }
}

/// Compiled once for each method and not for each pair of them: a triangle costs a call a row.
fn cover(coverage: Coverage, grid: &Grid, corners: &[Corner; 3], visit: &mut dyn Visit) {
    coverage.cover(grid, corners, visit);
}

/// Fills without a test.
struct Fill<'a, 't, P> {
    target: &'a mut Target<'t, P>,
    pixel: P,
}

impl<P: Copy> Visit for Fill<'_, '_, P> {
    #[inline]
    fn pixel(&mut self, x: u32, y: u32) {
        self.row(y, x..x + 1);
    }

    #[inline]
    fn row(&mut self, y: u32, columns: Range<u32>) {
        let span = self.target.span(columns.start, y, columns.end);
        self.target.color[span].fill(self.pixel);
    }
}

/// Fills where the surface is nearer than what is stored.
struct Tested<'a, 't, P, Z, S> {
    target: &'a mut Target<'t, P>,
    depth: &'a mut [Z],
    state: &'a State,
    pixel: P,
    surface: &'a S,
}

impl<P: Copy, Z: Precision, S> Tested<'_, '_, P, Z, S> {
    /// Where a pixel's depth is stored: in rows without gaps.
    #[inline]
    fn depth_at(&self, x: u32, y: u32) -> usize {
        (y - self.target.rows.start) as usize * self.target.width as usize + x as usize
    }

    /// Tests and draws one pixel of known depth.
    #[inline]
    fn one(&mut self, x: u32, y: u32, z: Z) {
        let at = self.depth_at(x, y);
        let stored = &mut self.depth[at];
        let passes = match self.state.test {
            DepthTest::Greater => z > *stored,
            DepthTest::Less => z < *stored,
            DepthTest::Off => true,
        };
        if passes {
            let at = self.target.span(x, y, x + 1).start;
            self.target.color[at] = self.pixel;
            if self.state.write {
                *stored = z;
            }
        }
    }
}

impl<P: Copy, S: Surface<Z: Precision>> Tested<'_, '_, P, S::Z, S> {
    /// Chooses instead of branching, as compilers like it.
    #[inline]
    fn run(&mut self, y: u32, columns: Range<u32>, passes: impl Fn(S::Z, S::Z) -> bool) {
        let (x, pixel, write) = (columns.start, self.pixel, self.state.write);
        let first = self.depth_at(x, y);
        let depth = &mut self.depth[first..first + columns.len()];
        let span = self.target.span(x, y, columns.end);
        let items = depth.iter_mut().zip(&mut self.target.color[span]);
        self.surface.row(x, y, items, |(stored, color), z| {
            let draws = passes(z, *stored);
            *stored = if draws && write { z } else { *stored };
            *color = if draws { pixel } else { *color };
        });
    }
}

impl<P: Copy, S: Surface<Z: Precision>> Visit for Tested<'_, '_, P, S::Z, S> {
    #[inline]
    fn pixel(&mut self, x: u32, y: u32) {
        self.one(x, y, self.surface.at(x, y));
    }

    #[inline]
    fn row(&mut self, y: u32, columns: Range<u32>) {
        match self.state.test {
            DepthTest::Greater => self.run(y, columns, |new, old| new > old),
            DepthTest::Less => self.run(y, columns, |new, old| new < old),
            DepthTest::Off => self.run(y, columns, |_, _| true),
        }
    }

    #[inline]
    fn column(&mut self, x: u32, rows: Range<u32>, ends: [f64; 2]) {
        let surface = self.surface;
        surface.column(x, rows, ends, |y, z| self.one(x, y, z));
    }
}
