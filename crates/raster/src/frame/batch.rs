//! Eight triangles at a time: box, facing, edges and depth, and for those of a few pixels their fragments.
//!
//! Everything is relative to the corner of the triangle's own box, so that below 128 pixels of extent all products
//! fit an `i32`, exactly. What does not fit (a larger triangle, one that a plane may cut) takes the scalar way of
//! the immediate path, in its turn: the order of drawing stays.
//!
//! Triangles whose box holds no sample end after a dozen instructions a piece: in a dense mesh most of them.

use core::ops::Range;

use fearless_simd::prelude::*;
use fearless_simd::{Simd, f32x8, f64x4, i32x8, mask32x8, u32x8};
use polosa_math::SUB_PIXELS;

use super::bins::{Entry, SIDE, Segment, Small, place};
use super::each::{four, three, two};
use super::large;
use super::vertices::{LANES, MISSING, PLAIN, Snapped, Snapper, UNSURE, Vertices, lanes};
use super::{Triangles, Values};
use crate::depth::{coefficients, formula};
use crate::setup::Setup;
use crate::{Clip, Cull, DepthTest, Rect, State, Stats};

/// Boxes of at most so many pixels a side become fragments.
const WINDOW: u32 = 4;
/// Extents of less than so many sub-pixels are prepared in lanes.
const MOST_EXTENT: i32 = 1 << 15;

/// What all triangles of a draw have in common.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Job<'a> {
    pub(crate) setup: &'a Setup,
    pub(crate) state: &'a State,
    pub(crate) snapper: &'a Snapper,
    pub(crate) vertices: Vertices<'a>,
    pub(crate) triangles: Triangles<'a>,
    /// The pixels that may be drawn on.
    pub(crate) clip: Rect,
    /// All of them.
    pub(crate) picture: Rect,
    /// The number of the draw in the frame.
    pub(crate) draw: u32,
    /// Whether triangles of a few pixels become fragments.
    pub(crate) fragments: bool,
    /// Tiles in a row of the picture.
    pub(crate) columns: u32,
}

impl Job<'_> {
    /// Whether a triangle that covers a tile hides what is farther there.
    pub(crate) fn occludes(&self) -> bool {
        self.state.test == DepthTest::Greater && self.state.write
    }
}

impl<'a> Job<'a> {
    /// The indices of a triangle's vertices.
    fn indices(&self, triangle: usize) -> [u32; 3] {
        match self.triangles {
            Triangles::Indexed(triangles) => triangles.get(triangle).copied().unwrap_or([u32::MAX; 3]),
            Triangles::Consecutive => [0, 1, 2].map(|k| u32::try_from(3 * triangle + k).unwrap_or(u32::MAX)),
        }
    }

    /// The corners of the triangles from `first` on: for each, x, y, the bits of depth, and the marks.
    #[inline(always)]
    fn corners<L: Simd>(&self, simd: L, snapped: &[Snapped], first: usize) -> [[i32x8<L>; 4]; 3] {
        match self.triangles {
            Triangles::Indexed(triangles) => {
                let given = &triangles[first..];
                let some: &[[u32; 3]; LANES] = match given.first_chunk() {
                    Some(some) => some,
                    None => &padded(given),
                };
                three(
                    #[inline(always)]
                    |c| {
                        let pair = four(
                            #[inline(always)]
                            |k| [vertex(snapped, some[k][c]), vertex(snapped, some[4 + k][c])],
                        );
                        lanes(simd, pair)
                    },
                )
            }
            Triangles::Consecutive => {
                let some: &[Clip; 3 * LANES] = match self.vertices.lent(3 * first) {
                    Some(lent) => lent,
                    None => &self.vertices.made(3 * first),
                };
                three(
                    #[inline(always)]
                    |c| {
                        let pair = four(
                            #[inline(always)]
                            |k| [some[3 * k + c], some[12 + 3 * k + c]],
                        );
                        self.snapper.lanes(simd, pair)
                    },
                )
            }
        }
    }
}

/// A snapped vertex, if it is there.
#[inline(always)]
fn vertex(snapped: &[Snapped], index: u32) -> Snapped {
    *snapped.get(index as usize).unwrap_or(&NOBODY)
}

/// Fewer than eight triangles, and others that name no vertex.
#[inline(never)]
fn padded(given: &[[u32; 3]]) -> [[u32; 3]; LANES] {
    let mut padded = [[u32::MAX; 3]; LANES];
    padded.iter_mut().zip(given).for_each(|(to, from)| *to = *from);
    padded
}

/// Prepares the first eight triangles of a range, or as many as there are, and bins them.
#[inline(always)]
pub(crate) fn bin<L: Simd>(
    simd: L,
    job: &Job<'_>,
    snapped: &[Snapped],
    range: Range<usize>,
    values: &Values<'_>,
    segment: &mut Segment,
    stats: &mut Stats,
) {
    let first = range.start;
    let count = range.len().min(LANES);
    let [a, b, c] = job.corners(simd, snapped, first);
    let there = (1_u32 << count) - 1;
    stats.submitted += count as u64;

    // Boxes, in sub-pixels and in pixels.
    let [left, top] = two(
        #[inline(always)]
        |k| a[k].min(b[k]).min(c[k]),
    );
    let [right, bottom] = two(
        #[inline(always)]
        |k| a[k].max(b[k]).max(c[k]),
    );
    let marks = a[3] | b[3] | c[3];
    let fits = (right - left).max(bottom - top).simd_lt(MOST_EXTENT) & marks.simd_eq(PLAIN);
    let [sx, sy] = job.state.sample.sub_pixels();
    let whole = [first_at(left, sx), first_at(top, sy), first_at(right, sx), first_at(bottom, sy)];
    let (x0, y0) = (whole[0].max(job.clip.x0.cast_signed()), whole[1].max(job.clip.y0.cast_signed()));
    let (x1, y1) = (whole[2].min(job.clip.x1.cast_signed()), whole[3].min(job.clip.y1.cast_signed()));
    let samples = x0.simd_lt(x1) & y0.simd_lt(y1);

    // Facing. The area is that of the corners as given, positive clockwise.
    let area = (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
    let culled = match job.state.cull {
        Cull::None => mask32x8::splat(simd, false),
        Cull::Front => area.simd_lt(0),
        Cull::Back => area.simd_gt(0),
    };
    let fits_bits = bits(fits) & there;
    let flat_bits = bits(area.simd_eq(0)) & fits_bits;
    let culled_bits = bits(culled) & fits_bits;
    let live = fits_bits & !flat_bits & !culled_bits;
    stats.degenerate += u64::from(flat_bits.count_ones());
    stats.culled += u64::from(culled_bits.count_ones());
    stats.drawn += u64::from(live.count_ones());
    let scalar = there & !fits_bits;
    let live = live & bits(samples);
    if live | scalar == 0 {
        return;
    }
    if live == 0 {
        return in_scalars(job, first, scalar, values, segment, stats);
    }

    // Sorted by y, then x; relative to the box.
    let mut keys = [key(&a, left, top), key(&b, left, top), key(&c, left, top)];
    let mut z = [a[2].bitcast::<f32x8<L>>(), b[2].bitcast(), c[2].bitcast()];
    exchange(&mut keys, &mut z, 0, 1);
    exchange(&mut keys, &mut z, 1, 2);
    exchange(&mut keys, &mut z, 0, 1);
    let x = three(
        #[inline(always)]
        |k| keys[k] & 0xffff,
    );
    let y = three(
        #[inline(always)]
        |k| keys[k] >> 16,
    );

    // Edges, opposite to each corner, positive inside.
    let turn = ((x[1] - x[0]) * (y[2] - y[0]) - (y[1] - y[0]) * (x[2] - x[0])) >> 31;
    let step_x = [turned(y[1] - y[2], turn), turned(y[2] - y[0], turn), turned(y[0] - y[1], turn)];
    let step_y = [turned(x[2] - x[1], turn), turned(x[0] - x[2], turn), turned(x[1] - x[0], turn)];
    let (px, py) = ((x0 << 8) + sx - left, (y0 << 8) + sy - top);
    let area = turned(area, area >> 31);
    let e0 = step_y[0] * (py - y[1]) + step_x[0] * (px - x[1]);
    let e1 = step_y[1] * (py - y[2]) + step_x[1] * (px - x[2]);
    let edges = [e0, e1, area - e0 - e1];

    // The anchor has the least depth; slots: the two other corners, sorted, then the anchor.
    let at_0 = z[0].simd_le(z[1]) & z[0].simd_le(z[2]);
    let not_2 = at_0 | z[1].simd_le(z[2]);
    let (edges, step_x, step_y) =
        (slots(edges, at_0, not_2), slots(step_x, at_0, not_2), slots(step_y, at_0, not_2));
    let anchor = at_0.select(z[0], not_2.select(z[1], z[2]));
    let others = [at_0.select(z[1], z[0]), not_2.select(z[2], z[1])];
    let most = z[0].max(z[1]).max(z[2]);
    let biased = three(
        #[inline(always)]
        |k| {
            let top_left = step_x[k].simd_gt(0) | (step_x[k].simd_eq(0) & step_y[k].simd_gt(0));
            (edges[k] + top_left.select(i32x8::splat(simd, 0), i32x8::splat(simd, -1))) >> 8
        },
    );

    // c and q, in f64.
    let rest = two(
        #[inline(always)]
        |k| (edges[k] & (SUB_PIXELS - 1)).to_float::<f32x8<L>>().widen(),
    );
    let area = to_f64(area);
    let (anchor_low, anchor_high) = anchor.widen();
    let others = two(
        #[inline(always)]
        |k| others[k].widen(),
    );
    let pixel = f64x4::splat(simd, f64::from(SUB_PIXELS));
    let delta_low = [others[0].0 - anchor_low, others[1].0 - anchor_low];
    let delta_high = [others[0].1 - anchor_high, others[1].1 - anchor_high];
    let low = coefficients(anchor_low, delta_low, [rest[0].0, rest[1].0], area.0, pixel);
    let high = coefficients(anchor_high, delta_high, [rest[0].1, rest[1].1], area.1, pixel);
    let c = low.0.narrow(high.0);
    let q = [low.1[0].narrow(high.1[0]), low.1[1].narrow(high.1[1])];

    // Fragments of the triangles of a few pixels: for each place of a window, which of the eight cover it.
    let (width, height) = (x1 - x0, y1 - y0);
    let tiny = width.max(height).simd_le(WINDOW.cast_signed());
    let tiny_bits = if job.fragments { bits(tiny) & live } else { 0 };
    let more = two(
        #[inline(always)]
        |k| (edges[k] >> 8) - biased[k],
    );
    let mut depths = [[0.0; LANES]; (WINDOW * WINDOW) as usize];
    let mut covered = i32x8::splat(simd, 0);
    if tiny_bits != 0 {
        let (columns, rows) = (most_of(width, tiny), most_of(height, tiny));
        let mut row = biased;
        for j in 0..rows {
            let mut e = row;
            for i in 0..columns {
                let at = j * WINDOW + i;
                // The sign says whether the place is outside.
                covered |= !((e[0] | e[1] | e[2]) >> 31) & (1 << at);
                let e12 = [(e[0] + more[0]).to_float::<f32x8<L>>(), (e[1] + more[1]).to_float()];
                depths[at as usize] = *formula(c, q, e12).min(most);
                e = three(
                    #[inline(always)]
                    |k| e[k] + step_x[k],
                );
            }
            row = three(
                #[inline(always)]
                |k| row[k] + step_y[k],
            );
        }
        // No more than the box, which the picture's sides may have cut.
        let one = i32x8::splat(simd, 1);
        let across = (one << width) - 1;
        let down = ((one << (height << 2)) - 1) & 0x1111;
        covered &= tiny.select(across * down, i32x8::splat(simd, 0));
    }
    let nothing = tiny_bits & !bits(covered.simd_ne(0));
    let mut todo = (live & !nothing) | scalar;
    // Blocks reach beyond a box, so what a scissor cuts takes the way of the strips.
    let scissored = if job.state.scissor.is_some() {
        let inside =
            x0.simd_eq(whole[0]) & y0.simd_eq(whole[1]) & x1.simd_eq(whole[2]) & y1.simd_eq(whole[3]);
        live & !tiny_bits & !bits(inside)
    } else {
        0
    };
    let scalar = scalar | scissored;
    // Scissored ones were counted above, and are counted again by the scalar way.
    let again = u64::from((scalar & live).count_ones());
    stats.drawn -= again;
    stats.submitted -= u64::from(scalar.count_ones());

    let (x0, y0, x1, y1, covered) = (*x0, *y0, *x1, *y1, *covered);
    let prepared = Prepared {
        e: three(
            #[inline(always)]
            |k| *biased[k],
        ),
        x: three(
            #[inline(always)]
            |k| *step_x[k],
        ),
        y: three(
            #[inline(always)]
            |k| *step_y[k],
        ),
        more: [*more[0], *more[1]],
        c: *c,
        q: [*q[0], *q[1]],
        most: *most,
    };
    let mut found = [0; LANES];
    if todo & !scalar != 0 {
        values(first, todo & !scalar, &mut found);
    }
    while todo != 0 {
        let lane = todo.trailing_zeros() as usize % LANES;
        todo &= todo - 1;
        if tiny_bits >> lane & 1 == 1 {
            let value = found[lane];
            let (x, y) = (x0[lane].cast_unsigned(), y0[lane].cast_unsigned());
            let mut bits = covered[lane].cast_unsigned() & 0xffff;
            while bits != 0 {
                let at = bits.trailing_zeros() % (WINDOW * WINDOW);
                bits &= bits - 1;
                let (x, y) = (x + at % WINDOW, y + at / WINDOW);
                let tile = (y / SIDE * job.columns + x / SIDE) as usize;
                let entry = Entry::fragment(job.draw, place(x, y), depths[at as usize][lane], value);
                segment.bins[tile].entries.push(entry);
            }
        } else if scalar >> lane & 1 == 1 {
            one_in_scalars(job, first + lane, values, segment, stats);
        } else {
            let extent = [x0[lane], y0[lane], x1[lane], y1[lane]].map(|v| v.cast_unsigned());
            let (value, [x0, y0, x1, y1]) = (found[lane], extent);
            for row in y0 / SIDE..=(y1 - 1) / SIDE {
                for column in x0 / SIDE..=(x1 - 1) / SIDE {
                    // Made in its place, anew for each tile: a copy would wait for what was just written.
                    let bin = &mut segment.bins[(row * job.columns + column) as usize];
                    bin.push_small(prepared.record(lane, extent, job.draw), value);
                }
            }
        }
    }
}

/// The lanes of what a [`Small`] is made of.
struct Prepared {
    e: [[i32; LANES]; 3],
    x: [[i32; LANES]; 3],
    y: [[i32; LANES]; 3],
    more: [[i32; LANES]; 2],
    c: [f32; LANES],
    q: [[f32; LANES]; 2],
    most: [f32; LANES],
}

impl Prepared {
    #[inline(always)]
    #[expect(clippy::cast_possible_truncation, reason = "inside the picture: up to 16,384")]
    fn record(&self, lane: usize, extent: [u32; 4], draw: u32) -> Small {
        let of = |lanes: &[[i32; LANES]; 3]| [lanes[0][lane], lanes[1][lane], lanes[2][lane]];
        let edges = [of(&self.e), of(&self.x), of(&self.y)];
        let tag = Small::tag(draw, [self.more[0][lane] != 0, self.more[1][lane] != 0]);
        let q = [self.q[0][lane], self.q[1][lane]];
        let [x0, y0, x1, y1] = extent;
        Small::new(edges, self.c[lane], q, self.most[lane], [x0 as u16, y0 as u16, x1 as u16, y1 as u16], tag)
    }
}

/// Lanes that the scalar path prepares, and nothing else in the batch.
#[inline(never)]
fn in_scalars(
    job: &Job<'_>,
    first: usize,
    lanes: u32,
    values: &Values<'_>,
    segment: &mut Segment,
    stats: &mut Stats,
) {
    stats.submitted -= u64::from(lanes.count_ones());
    for lane in (0..LANES).filter(|lane| lanes >> lane & 1 == 1) {
        one_in_scalars(job, first + lane, values, segment, stats);
    }
}

/// One triangle by the immediate path's set-up, which counts it.
#[inline(never)]
fn one_in_scalars(
    job: &Job<'_>,
    triangle: usize,
    values: &Values<'_>,
    segment: &mut Segment,
    stats: &mut Stats,
) {
    stats.submitted += 1;
    let [Some(a), Some(b), Some(c)] = job.indices(triangle).map(|k| job.vertices.get(k as usize)) else {
        stats.bad_index += 1;
        return;
    };
    let mut known = None;
    job.setup.triangle([&a, &b, &c], stats, |piece| {
        if !piece.triangle.rows(job.state.sample, job.clip).is_empty() {
            let value = *known.get_or_insert_with(|| {
                let mut found = [0; LANES];
                values(triangle, 1, &mut found);
                found[0]
            });
            large::bin(job, &piece.triangle, value, segment);
        }
    });
}

/// The greatest of the chosen lanes' sides of windows.
#[inline(always)]
fn most_of<L: Simd>(side: i32x8<L>, chosen: mask32x8<L>) -> u32 {
    let above = |k: i32| (side.simd_gt(k) & chosen).any_true();
    if above(2) {
        if above(3) { 4 } else { 3 }
    } else if above(1) {
        2
    } else {
        1
    }
}

/// The first pixel whose sample lies at or right of (below) a place.
#[inline(always)]
fn first_at<L: Simd>(place: i32x8<L>, sample: i32) -> i32x8<L> {
    (place + (SUB_PIXELS - 1 - sample)) >> 8
}

/// A corner's place in its triangle's box, as one number that sorts by y, then x.
#[inline(always)]
fn key<L: Simd>(corner: &[i32x8<L>; 4], left: i32x8<L>, top: i32x8<L>) -> i32x8<L> {
    (corner[1] - top) << 16 | (corner[0] - left)
}

/// Puts two corners in order.
#[inline(always)]
fn exchange<L: Simd>(keys: &mut [i32x8<L>; 3], z: &mut [f32x8<L>; 3], i: usize, j: usize) {
    let swap = keys[j].simd_lt(keys[i]);
    (keys[i], keys[j]) = (keys[i].min(keys[j]), keys[i].max(keys[j]));
    (z[i], z[j]) = (swap.select(z[j], z[i]), swap.select(z[i], z[j]));
}

/// The negative where `turn` is −1, the value itself where it is 0.
#[inline(always)]
fn turned<L: Simd>(value: i32x8<L>, turn: i32x8<L>) -> i32x8<L> {
    (value ^ turn) - turn
}

/// From the order of the corners to that of the depth formula: the two others, then the anchor.
#[inline(always)]
fn slots<L: Simd>(v: [i32x8<L>; 3], at_0: mask32x8<L>, not_2: mask32x8<L>) -> [i32x8<L>; 3] {
    [at_0.select(v[1], v[0]), not_2.select(v[2], v[1]), at_0.select(v[0], not_2.select(v[1], v[2]))]
}

/// An area, not negative, as `f64`: put under the exponent of 2⁵², which is then taken off again. Exact.
#[inline(always)]
fn to_f64<L: Simd>(v: i32x8<L>) -> (f64x4<L>, f64x4<L>) {
    const TWO_52: f64 = 4_503_599_627_370_496.0;
    let (low, high) = v.bitcast::<u32x8<L>>().widen();
    let low = (low | TWO_52.to_bits()).bitcast::<f64x4<L>>() - TWO_52;
    (low, (high | TWO_52.to_bits()).bitcast::<f64x4<L>>() - TWO_52)
}

/// A bit for each lane.
#[inline(always)]
#[expect(clippy::cast_possible_truncation, reason = "eight bits")]
fn bits<L: Simd>(mask: mask32x8<L>) -> u32 {
    mask.to_bitmask() as u32 & 0xff
}

/// The lanes of missing triangles.
pub(crate) const NOBODY: Snapped = [0, 0, 0, MISSING];
const _: () = assert!(UNSURE != PLAIN && MISSING != PLAIN);
