//! The fill: every strip of every triangle, tested against the stored depth and written.

use crate::depth::{DepthPlane, Stored};
use crate::setup::{Piece, Setup};
use crate::strip::Strip;
use crate::{Clip, Depth, DepthTest, Fragment, Rect, Shade, State, Stats, Target, Weights};

impl<P: Copy> Target<'_, P> {
    /// Draws triangles, each a triple of indices into `vertices`, in order.
    ///
    /// Nothing is allocated. An index that is out of range, or a vertex that is not finite, costs its triangle
    /// and is counted; nothing panics.
    ///
    /// ```
    /// use polosa_raster::{Depth, Flat, State, Target};
    ///
    /// let mut color = [0_u32; 16];
    /// let mut target = Target::new(&mut color, Depth::None, 4, 4, 4)?;
    /// let corners = [[-1.0, 1.0, 0.5, 1.0], [-1.0, -1.0, 0.5, 1.0], [1.0, 1.0, 0.5, 1.0]];
    /// let stats = target.triangles(&State::default(), &corners, &[[0, 1, 2]], &Flat(9));
    /// assert_eq!(stats.drawn, 1);
    /// // The slanted side runs through pixel centres; it is a right side, so those are not the triangle's.
    /// assert_eq!(color, [9, 9, 9, 0, 9, 9, 0, 0, 9, 0, 0, 0, 0, 0, 0, 0]);
    /// # Ok::<(), polosa_raster::TargetError>(())
    /// ```
    pub fn triangles(
        &mut self,
        state: &State,
        vertices: &[Clip],
        triangles: &[[u32; 3]],
        shade: &impl Shade<P>,
    ) -> Stats {
        let setup = Setup::new(state, self.width, self.height);
        let clip = self.clip(state.scissor);
        let mut stats = Stats::default();
        for (index, triangle) in triangles.iter().enumerate() {
            stats.submitted += 1;
            let [Some(a), Some(b), Some(c)] = triangle.map(|k| vertices.get(k as usize)) else {
                stats.bad_index += 1;
                continue;
            };
            let mut value = None;
            setup.triangle([a, b, c], &mut stats, |piece| {
                // Nothing is asked about what lies in another band, or between two rows of samples.
                if piece.triangle.rows(state.sample, clip).is_empty() {
                    return;
                }
                match *value.get_or_insert_with(|| shade.triangle(index)) {
                    Some(pixel) => self.flat(state, clip, piece, pixel),
                    None => self.shaded(state, clip, piece, index, shade),
                }
            });
        }
        stats
    }

    /// Fills a triangle with one value.
    #[inline]
    fn flat(&mut self, state: &State, clip: Rect, piece: &Piece, pixel: P) {
        let plane = piece.triangle.depth(state.sample);
        for strip in piece.triangle.strips(state.sample, clip) {
            let span = self.span(strip.x0, strip.y, strip.x1);
            let color = &mut self.color[span.clone()];
            match &mut self.depth {
                Depth::None => color.fill(pixel),
                Depth::F32(depth) => flat_strip(state, strip, &plane, &mut depth[span], color, pixel),
                Depth::U16(depth) => flat_strip(state, strip, &plane, &mut depth[span], color, pixel),
            }
        }
    }

    /// Fills a triangle by asking for each fragment.
    #[inline]
    fn shaded(&mut self, state: &State, clip: Rect, piece: &Piece, triangle: usize, shade: &impl Shade<P>) {
        let plane = piece.triangle.depth(state.sample);
        let weights = &piece.triangle.weights(state.sample, piece.clip.as_ref());
        for strip in piece.triangle.strips(state.sample, clip) {
            let span = self.span(strip.x0, strip.y, strip.x1);
            let color = &mut self.color[span.clone()];
            let strip = ShadedStrip { state, strip, plane: &plane, weights, triangle };
            match &mut self.depth {
                Depth::None => strip.fill_untested(color, shade),
                Depth::F32(depth) => strip.fill(&mut depth[span], color, shade),
                Depth::U16(depth) => strip.fill(&mut depth[span], color, shade),
            }
        }
    }
}

/// Strips from this many pixels on are worth starting a loop of vector code. Changing it changes no pixel.
const LONG: usize = 16;

/// One strip in one value.
#[inline]
fn flat_strip<P: Copy, S: Stored>(
    state: &State,
    strip: Strip,
    plane: &DepthPlane,
    depth: &mut [S],
    color: &mut [P],
    pixel: P,
) {
    if color.len() >= LONG {
        return long_flat_strip(state, strip, plane, (depth, color), pixel);
    }
    plane.row(strip.x0, strip.y, depth.iter_mut().zip(color), |(depth, color), z| {
        let new = S::store(z);
        if state.test.passes(new, *depth) {
            *color = pixel;
            if state.write {
                *depth = new;
            }
        }
    });
}

/// One long strip in one value. The loops choose instead of branching, so that compilers make vector code of them.
#[inline(never)]
fn long_flat_strip<P: Copy, S: Stored>(
    state: &State,
    strip: Strip,
    plane: &DepthPlane,
    items: (&mut [S], &mut [P]),
    pixel: P,
) {
    #[inline]
    fn run<P: Copy, S: Stored>(
        strip: Strip,
        plane: &DepthPlane,
        (depth, color): (&mut [S], &mut [P]),
        pixel: P,
        passes: impl Fn(S, S) -> (bool, bool),
    ) {
        plane.long_row(strip.x0, strip.y, depth.iter_mut().zip(color), |(depth, color), z| {
            let new = S::store(z);
            let (draws, writes) = passes(new, *depth);
            *depth = if writes { new } else { *depth };
            *color = if draws { pixel } else { *color };
        });
    }
    match (state.test, state.write) {
        (DepthTest::Greater, true) => run(strip, plane, items, pixel, |new, old| (new > old, new > old)),
        (DepthTest::Greater, false) => run(strip, plane, items, pixel, |new, old| (new > old, false)),
        (DepthTest::Less, true) => run(strip, plane, items, pixel, |new, old| (new < old, new < old)),
        (DepthTest::Less, false) => run(strip, plane, items, pixel, |new, old| (new < old, false)),
        (DepthTest::Off, true) => run(strip, plane, items, pixel, |_, _| (true, true)),
        (DepthTest::Off, false) => items.1.fill(pixel),
    }
}

/// One strip whose fragments are shaded one by one.
struct ShadedStrip<'a> {
    state: &'a State,
    strip: Strip,
    plane: &'a DepthPlane,
    weights: &'a Weights,
    triangle: usize,
}

impl ShadedStrip<'_> {
    #[inline]
    fn fill<P: Copy, S: Stored>(&self, depth: &mut [S], color: &mut [P], shade: &impl Shade<P>) {
        let Strip { x0, y, x1 } = self.strip;
        let items = (x0..x1).zip(depth.iter_mut().zip(color));
        self.plane.row(x0, y, items, |(x, (depth, color)), z| {
            let new = S::store(z);
            if self.state.test.passes(new, *depth) && self.shade(x, z, color, shade) && self.state.write {
                *depth = new;
            }
        });
    }

    #[inline]
    fn fill_untested<P: Copy>(&self, color: &mut [P], shade: &impl Shade<P>) {
        let Strip { x0, y, x1 } = self.strip;
        self.plane.row(x0, y, (x0..x1).zip(color), |(x, color), z| {
            self.shade(x, z, color, shade);
        });
    }

    /// Shades one fragment; a pixel that is discarded keeps its value, whatever was written to it before.
    #[inline]
    fn shade<P: Copy, F: Shade<P>>(&self, x: u32, depth: f32, pixel: &mut P, shade: &F) -> bool {
        let fragment = Fragment { x, y: self.strip.y, depth, triangle: self.triangle, weights: self.weights };
        if F::OPAQUE {
            return shade.fragment(&fragment, pixel);
        }
        let mut value = *pixel;
        let kept = shade.fragment(&fragment, &mut value);
        if kept {
            *pixel = value;
        }
        kept
    }
}
