//! Eight triangles at a time: box, facing, edges and depth, and for those of a few pixels their fragments.
//!
//! Everything is relative to the corner of the triangle's own box, so that up to 128 pixels of extent all products
//! fit an `i32`, exactly. What does not fit (a larger triangle, one that a plane may cut) takes the scalar way of
//! the immediate path, in its turn: the order of drawing stays.
//!
//! Triangles whose box holds no sample end after a dozen instructions a piece: in a dense mesh most of them.

use fearless_simd::prelude::*;
use fearless_simd::{Simd, f32x8, f64x4, i32x8, mask32x8, u32x8};
use polosa_math::SUB_PIXELS;

use super::bins::{Entry, SIDE, Segment, Small, place};
use super::large;
use super::vertices::{LANES, MISSING, PLAIN, Snapped, UNSURE, Vertices, lanes};
use crate::depth::{coefficients, formula};
use crate::setup::Setup;
use crate::{Cull, DepthTest, Rect, State, Stats};

/// Boxes of at most so many pixels a side become fragments.
const WINDOW: u32 = 4;
/// Extents of less than so many sub-pixels are prepared in lanes.
const MOST_EXTENT: i32 = 1 << 15;

/// What all triangles of a draw have in common.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Job<'a> {
    pub(crate) setup: &'a Setup,
    pub(crate) state: &'a State,
    pub(crate) vertices: Vertices<'a>,
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

/// Up to eight triangles: the snapped vertices of each, and where they came from.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Batch {
    /// First corners, second, third; [`MISSING`] where there is none.
    pub(crate) corners: [[Snapped; LANES]; 3],
    /// The vertices' numbers.
    pub(crate) indices: [[u32; 3]; LANES],
    /// The first triangle's place in the draw.
    pub(crate) first: usize,
    /// How many there are; the other lanes are ignored.
    pub(crate) count: usize,
}

/// Prepares a batch and bins it.
#[inline(always)]
pub(crate) fn bin<L: Simd, V: Fn(usize) -> u32>(
    simd: L,
    job: &Job<'_>,
    batch: &Batch,
    value: &V,
    segment: &mut Segment,
    stats: &mut Stats,
) {
    let splat = |v: i32| i32x8::splat(simd, v);
    let [a, b, c] = batch.corners.map(|corners| lanes(simd, &corners));
    let there = (1_u32 << batch.count) - 1;
    stats.submitted += batch.count as u64;

    // Boxes, in sub-pixels and in pixels.
    let least = |k: usize| a[k].min(b[k]).min(c[k]);
    let greatest = |k: usize| a[k].max(b[k]).max(c[k]);
    let (left, top, right, bottom) = (least(0), least(1), greatest(0), greatest(1));
    let marks = a[3] | b[3] | c[3];
    let fits = (right - left).max(bottom - top).simd_lt(MOST_EXTENT) & marks.simd_eq(PLAIN);
    let [sx, sy] = job.state.sample.sub_pixels();
    let first_at = |v: i32x8<L>, s: i32| (v + (SUB_PIXELS - 1 - s)) >> 8;
    let edge_of_clip = |v: u32| splat(v.cast_signed());
    let x0 = first_at(left, sx).max(edge_of_clip(job.clip.x0));
    let y0 = first_at(top, sy).max(edge_of_clip(job.clip.y0));
    let x1 = first_at(right, sx).min(edge_of_clip(job.clip.x1));
    let y1 = first_at(bottom, sy).min(edge_of_clip(job.clip.y1));
    let samples = x0.simd_lt(x1) & y0.simd_lt(y1);

    // Facing. The area is that of the corners as given, positive clockwise.
    let area = (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
    let flat = area.simd_eq(0);
    let culled = match job.state.cull {
        Cull::None => mask32x8::splat(simd, false),
        Cull::Front => area.simd_lt(0),
        Cull::Back => area.simd_gt(0),
    };
    let bits = |mask: mask32x8<L>| bit_mask(mask.to_bitmask()) & there;
    let fits_bits = bits(fits);
    let flat_bits = bits(flat) & fits_bits;
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
        return in_scalars(job, batch, scalar, value, segment, stats);
    }

    // Sorted by y, then x; relative to the box.
    let key = |p: &[i32x8<L>; 4]| (p[1] - top) << 16 | (p[0] - left);
    let mut keys = [key(&a), key(&b), key(&c)];
    let mut z = [a[2].bitcast::<f32x8<L>>(), b[2].bitcast(), c[2].bitcast()];
    for (i, j) in [(0, 1), (1, 2), (0, 1)] {
        let swap = keys[j].simd_lt(keys[i]);
        (keys[i], keys[j]) = (keys[i].min(keys[j]), keys[i].max(keys[j]));
        (z[i], z[j]) = (swap.select(z[j], z[i]), swap.select(z[i], z[j]));
    }
    let [x, y] = [keys.map(|key| key & 0xffff), keys.map(|key| key >> 16)];

    // Edges, opposite to each corner, positive inside.
    let turn = ((x[1] - x[0]) * (y[2] - y[0]) - (y[1] - y[0]) * (x[2] - x[0])) >> 31;
    let turned = |v: i32x8<L>| (v ^ turn) - turn;
    let step_x = [turned(y[1] - y[2]), turned(y[2] - y[0]), turned(y[0] - y[1])];
    let step_y = [turned(x[2] - x[1]), turned(x[0] - x[2]), turned(x[1] - x[0])];
    let (px, py) = ((x0 << 8) + sx - left, (y0 << 8) + sy - top);
    let through = |k: usize, p: usize| step_y[k] * (py - y[p]) + step_x[k] * (px - x[p]);
    let area = area.max(splat(0) - area);
    let (e0, e1) = (through(0, 1), through(1, 2));
    let edges = [e0, e1, area - e0 - e1];

    // The anchor has the least depth; slots: the two other corners, sorted, then the anchor.
    let at_0 = z[0].simd_le(z[1]) & z[0].simd_le(z[2]);
    let not_2 = at_0 | z[1].simd_le(z[2]);
    let slots_i = |v: [i32x8<L>; 3]| {
        [at_0.select(v[1], v[0]), not_2.select(v[2], v[1]), at_0.select(v[0], not_2.select(v[1], v[2]))]
    };
    let (edges, step_x, step_y) = (slots_i(edges), slots_i(step_x), slots_i(step_y));
    let anchor = at_0.select(z[0], not_2.select(z[1], z[2]));
    let others = [at_0.select(z[1], z[0]), not_2.select(z[2], z[1])];
    let most = z[0].max(z[1]).max(z[2]);
    let biased = [0, 1, 2].map(|k: usize| {
        let top_left = step_x[k].simd_gt(0) | (step_x[k].simd_eq(0) & step_y[k].simd_gt(0));
        (edges[k] + top_left.select(splat(0), splat(-1))) >> 8
    });

    // c and q, in f64.
    let rest = [0, 1].map(|k: usize| (edges[k] & (SUB_PIXELS - 1)).to_float::<f32x8<L>>().widen());
    let area = to_f64(simd, area);
    let (anchor_low, anchor_high) = anchor.widen();
    let others = others.map(SimdWiden::widen);
    let pixel = f64x4::splat(simd, f64::from(SUB_PIXELS));
    let delta_low = others.map(|(low, _)| low - anchor_low);
    let delta_high = others.map(|(_, high)| high - anchor_high);
    let low = coefficients(anchor_low, delta_low, rest.map(|r| r.0), area.0, pixel);
    let high = coefficients(anchor_high, delta_high, rest.map(|r| r.1), area.1, pixel);
    let c = low.0.narrow(high.0);
    let q = [low.1[0].narrow(high.1[0]), low.1[1].narrow(high.1[1])];

    // Fragments of the triangles of a few pixels: for each place of a window, which of the eight cover it.
    let (width, height) = (x1 - x0, y1 - y0);
    let tiny = width.max(height).simd_le(WINDOW.cast_signed());
    let tiny_bits = if job.fragments { bits(tiny) & live } else { 0 };
    let mut depths = [[0.0; LANES]; (WINDOW * WINDOW) as usize];
    let mut covered = splat(0);
    if tiny_bits != 0 {
        let more = [0, 1].map(|k: usize| (edges[k] >> 8) - biased[k]);
        let mut row = biased;
        for j in 0..WINDOW {
            let below = height.simd_gt(j.cast_signed()) & tiny;
            if !below.any_true() {
                break;
            }
            let mut e = row;
            for i in 0..WINDOW {
                let beside = width.simd_gt(i.cast_signed()) & below;
                let at = j * WINDOW + i;
                let inside = (e[0] | e[1] | e[2]).simd_ge(0) & beside;
                covered |= inside.select(splat(1 << at), splat(0));
                let plane = formula(c, q, [0, 1].map(|k: usize| (e[k] + more[k]).to_float::<f32x8<L>>()));
                depths[at as usize] = *plane.min(most);
                e = [e[0] + step_x[0], e[1] + step_x[1], e[2] + step_x[2]];
            }
            row = [row[0] + step_y[0], row[1] + step_y[1], row[2] + step_y[2]];
        }
    }
    let nothing = tiny_bits & !bits(covered.simd_ne(0));
    let mut todo = (live & !nothing) | scalar;
    let scalar = scalar | if job.state.scissor.is_some() { live & !tiny_bits } else { 0 };
    // Scissored ones were counted above, and are counted again by the scalar way.
    let again = u64::from((scalar & live).count_ones());
    stats.drawn -= again;
    stats.submitted -= u64::from(scalar.count_ones());

    let (x0, y0, x1, y1, covered) = (*x0, *y0, *x1, *y1, *covered);
    let prepared = Prepared {
        e: biased.map(|v| *v),
        x: step_x.map(|v| *v),
        y: step_y.map(|v| *v),
        more: [0, 1].map(|k: usize| *((edges[k] >> 8) - biased[k])),
        c: *c,
        q: q.map(|v| *v),
        most: *most,
    };
    while todo != 0 {
        let lane = todo.trailing_zeros() as usize % LANES;
        todo &= todo - 1;
        if tiny_bits >> lane & 1 == 1 {
            let value = value(batch.first + lane);
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
            one_in_scalars(job, batch, lane, value, segment, stats);
        } else {
            let extent = [x0[lane], y0[lane], x1[lane], y1[lane]].map(|v| v.cast_unsigned());
            let record = prepared.record(lane, extent, job.draw);
            small(job, record, extent, value(batch.first + lane), segment);
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
        let edges = [&self.e, &self.x, &self.y].map(|lanes| [0, 1, 2].map(|k: usize| lanes[k][lane]));
        let tag = Small::tag(draw, [0, 1].map(|k: usize| self.more[k][lane] != 0));
        let q = [self.q[0][lane], self.q[1][lane]];
        Small::new(edges, self.c[lane], q, self.most[lane], extent.map(|v| v as u16), tag)
    }
}

/// Bins a triangle that was prepared in lanes.
#[inline]
fn small(job: &Job<'_>, record: Small, [x0, y0, x1, y1]: [u32; 4], value: u32, segment: &mut Segment) {
    segment.small.push(record);
    for row in y0 / SIDE..=(y1 - 1) / SIDE {
        for column in x0 / SIDE..=(x1 - 1) / SIDE {
            segment.bin_small((row * job.columns + column) as usize, record.most, value);
        }
    }
}

/// Lanes that the scalar path prepares, and nothing else in the batch.
#[inline(never)]
fn in_scalars<V: Fn(usize) -> u32>(
    job: &Job<'_>,
    batch: &Batch,
    lanes: u32,
    value: &V,
    segment: &mut Segment,
    stats: &mut Stats,
) {
    stats.submitted -= u64::from(lanes.count_ones());
    for lane in (0..LANES).filter(|lane| lanes >> lane & 1 == 1) {
        one_in_scalars(job, batch, lane, value, segment, stats);
    }
}

/// One triangle by the immediate path's set-up, which counts it.
#[inline(never)]
fn one_in_scalars<V: Fn(usize) -> u32>(
    job: &Job<'_>,
    batch: &Batch,
    lane: usize,
    value: &V,
    segment: &mut Segment,
    stats: &mut Stats,
) {
    stats.submitted += 1;
    let [Some(a), Some(b), Some(c)] = batch.indices[lane].map(|k| job.vertices.get(k as usize)) else {
        stats.bad_index += 1;
        return;
    };
    let mut known = None;
    job.setup.triangle([&a, &b, &c], stats, |piece| {
        if !piece.triangle.rows(job.state.sample, job.clip).is_empty() {
            let value = *known.get_or_insert_with(|| value(batch.first + lane));
            large::bin(job, &piece.triangle, value, segment);
        }
    });
}

/// An area, not negative, as `f64`: put under the exponent of 2⁵², which is then taken off again. Exact.
#[inline(always)]
fn to_f64<L: Simd>(simd: L, v: i32x8<L>) -> (f64x4<L>, f64x4<L>) {
    const TWO_52: f64 = 4_503_599_627_370_496.0;
    let (low, high) = v.bitcast::<u32x8<L>>().widen();
    let under = |v: fearless_simd::u64x4<L>| (v | TWO_52.to_bits()).bitcast::<f64x4<L>>() - TWO_52;
    let _ = simd;
    (under(low), under(high))
}

#[inline(always)]
#[expect(clippy::cast_possible_truncation, reason = "eight bits")]
const fn bit_mask(bits: u64) -> u32 {
    bits as u32 & 0xff
}

/// The lanes of missing triangles.
pub(crate) const NOBODY: Snapped = [0, 0, 0, MISSING];
const _: () = assert!(UNSURE != PLAIN && MISSING != PLAIN);
