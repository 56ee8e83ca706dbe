//! Claim: depth is within 5·2⁻²⁴, relative, of the rational plane through the `f32` vertex depths.
//!
//! Always: on slivers and steep floors, far off and near by. Judge: exact integers
//! ([`support::plane`]). Then what follows from it: the order of surfaces, of formats, of ties.

mod support;

use polosa_raster::{Depth, DepthTest, Flat, Sample, State, StoredDepth, Target};
use support::classes::{CLASSES, permuted, triangle};
use support::oracle::{CENTRE, Vertex, area2, row_span};
use support::picture::{Picture, on_screen, px, screen};
use support::plane::{depth_units, depth_units_at};
use support::rng::Rng;

const BOUND: f64 = 5.0;

/// Draws a triangle and returns its worst error over all pixels, in 2⁻²⁴ relative.
#[track_caller]
fn worst(picture: &mut Picture, t: &[Vertex; 3], z: [f32; 3], sample: [i64; 2]) -> f64 {
    picture.depth.fill(0.0);
    let v = [0, 1, 2].map(|k| screen(t[k], z[k]));
    let [x, y] = sample.map(|s| u8::try_from(s).unwrap());
    let state = State { sample: Sample { x, y }, ..on_screen() };
    picture.target().triangles(&state, &v, &[[0, 1, 2]], &Flat(1));
    let mut worst = 0_f64;
    for (j, row) in picture.depth.chunks(picture.width).enumerate() {
        for i in row_span(t, j as i64, sample, row.len()) {
            worst = worst.max(depth_units_at(t, z, i as i64, j as i64, sample, row[i]));
        }
    }
    worst
}

/// Three vertex depths of one of several kinds.
fn depths(r: &mut Rng) -> [f32; 3] {
    let z = |r: &mut Rng| match r.index(4) {
        0 => r.unit() as f32,
        1 => 2_f64.powf(r.real(-20.0, 0.0)) as f32,
        2 => 1.0,
        _ => 0.5 + r.range(-4, 4) as f32 / (1 << 24) as f32,
    };
    [z(r), z(r), z(r)].map(|z| z.max(1e-6))
}

#[test]
fn every_class_of_triangle_keeps_the_depth_bound() {
    let (mut picture, mut r) = (Picture::new(64, 48), Rng::new(30));
    for class in CLASSES {
        for k in 0..4_000 {
            let t = permuted(&triangle(class, &mut r, 64, 48), k);
            let z = depths(&mut r);
            let units = worst(&mut picture, &t, z, CENTRE);
            assert!(units <= BOUND, "{class} {t:?} {z:?}: {units} units of 2^-24");
        }
    }
}

#[test]
fn every_sample_position_keeps_the_depth_bound() {
    let (mut picture, mut r) = (Picture::new(64, 48), Rng::new(31));
    for k in 0..8_000 {
        let t = permuted(&triangle(CLASSES[k % 10], &mut r, 64, 48), k);
        let (z, sample) = (depths(&mut r), [r.range(0, 255), r.range(0, 255)]);
        let units = worst(&mut picture, &t, z, sample);
        assert!(units <= BOUND, "{t:?} {z:?} at {sample:?}: {units} units of 2^-24");
    }
}

#[test]
fn scene_06_a_sliver_of_1000_by_a_256th_px_keeps_the_depth_bound() {
    let mut picture = Picture::new(1024, 64);
    let mut r = Rng::new(32);
    let (mut covered, mut total) = (0, 0);
    for k in 0..400_usize {
        // A slope takes the sliver through some pixel centres; its third vertex is one sub-pixel off.
        let y = 128 + r.range(0, 40) * 256;
        let rise = r.range(-3, 3) * 128;
        let t = [
            [6 * 256, y],
            [1006 * 256, y + rise],
            [if k % 2 == 0 { 6 } else { 500 } * 256, y + 1 + if k % 2 == 0 { 0 } else { rise / 2 }],
        ];
        let t = permuted(&t, k);
        if area2(&t) == 0 {
            continue;
        }
        let z = if k < 200 { [1.0, 1e-6, 0.5] } else { depths(&mut r) };
        let units = worst(&mut picture, &t, z, CENTRE);
        assert!(units <= BOUND, "{t:?} {z:?}: {units} units of 2^-24");
        let spans: usize = (0..64).map(|j| row_span(&t, j, CENTRE, 1024).len()).sum();
        let drawn = picture.depth.iter().filter(|&&z| z != 0.0).count();
        assert_eq!(drawn, spans, "{t:?}");
        covered += usize::from(spans > 0);
        total += spans;
    }
    assert!(covered > 100 && total > 10_000, "{covered} slivers cover {total} px: too few to judge by");
}

#[test]
fn scene_17_a_triangle_of_2_px_at_4000_2000_keeps_the_depth_bound() {
    let (width, height) = (4096, 2048);
    let mut color = vec![0_u8; width * height];
    let mut depth = vec![0_f32; width * height];
    let mut r = Rng::new(33);
    for k in 0..2_000 {
        let corner = [4000 * 256, 2000 * 256];
        let t = [(); 3].map(|()| corner.map(|c| c + r.range(0, 512)));
        let t = permuted(&t, k);
        let z = depths(&mut r);
        let v = [0, 1, 2].map(|k| screen(t[k], z[k]));
        let mut target = Target::new(&mut color, Depth::F32(&mut depth), 4096, 2048, width).unwrap();
        target.triangles(&State { test: DepthTest::Off, ..on_screen() }, &v, &[[0, 1, 2]], &Flat(1));
        for j in 1999..2004_usize {
            for i in row_span(&t, j as i64, CENTRE, width) {
                let units = depth_units(&t, z, i as i64, j as i64, depth[j * width + i]);
                assert!(units <= BOUND, "{t:?} {z:?} at ({i}, {j}): {units} units of 2^-24");
            }
        }
    }
}

#[test]
fn steep_floors_keep_the_depth_bound() {
    let (mut picture, mut r) = (Picture::new(160, 120), Rng::new(34));
    for k in 0..600 {
        let x = |r: &mut Rng| r.range(-256 * 200, 256 * 360);
        let t = [
            [x(&mut r), r.range(0, 2560)],
            [x(&mut r), r.range(28_000, 40_000)],
            [x(&mut r), r.range(0, 40_000)],
        ];
        let z = [1e-6, 1.0, [1e-6, 1.0, 1e-3][r.index(3)]];
        let order = permuted(&[0, 1, 2], k);
        let units = worst(&mut picture, &order.map(|i| t[i]), order.map(|i| z[i]), CENTRE);
        assert!(units <= BOUND, "{t:?} {z:?}: {units} units of 2^-24");
    }
}

#[test]
fn depth_never_leaves_the_range_of_the_vertex_depths() {
    let (mut picture, mut r) = (Picture::new(64, 48), Rng::new(35));
    for k in 0..20_000 {
        let t = permuted(&triangle(CLASSES[k % 10], &mut r, 64, 48), k);
        let z = depths(&mut r);
        picture.depth.fill(0.0);
        let v = [0, 1, 2].map(|k| screen(t[k], z[k]));
        picture.target().triangles(&on_screen(), &v, &[[0, 1, 2]], &Flat(1));
        let most = z.into_iter().fold(0.0, f32::max);
        let least = z.into_iter().fold(1.0, f32::min);
        let found = picture.depth.iter().find(|&&d| d != 0.0 && !(least..=most).contains(&d));
        // Rounding may go below the least by the bound's few units, above the greatest never.
        let fine = found
            .is_none_or(|&d| d <= most && f64::from(d) >= f64::from(least) * (1.0 - BOUND / 16_777_216.0));
        assert!(fine, "{t:?} {z:?}: {found:?}");
    }
}

/// Nested floors: one surface lies a hair nearer than another everywhere, with the same x and y.
#[test]
fn scene_16_nested_floors_never_swap_or_tie() {
    let mut r = Rng::new(36);
    let mut pixels = 0;
    for far in [1e3, 1e5, f64::INFINITY] {
        for apart in [1e-3, 1e-4, 1e-5, 1e-6] {
            for _ in 0..12 {
                let x = |r: &mut Rng| r.range(-256 * 100, 256 * 300);
                let t = [[x(&mut r), 700], [x(&mut r), 37_000], [x(&mut r), r.range(700, 37_000)]];
                // Distances of the vertices from the eye; reversed depth with the near plane at 0.1.
                let near = 0.1;
                let w = [r.real(200.0, 900.0), r.real(0.1, 0.2), r.real(0.1, 900.0)];
                let depth = |w: f64| {
                    let z = if far.is_finite() { near * (far - w) / (w * (far - near)) } else { near / w };
                    z as f32
                };
                let behind = [0, 1, 2].map(|k| screen(t[k], depth(w[k])));
                let before = [0, 1, 2].map(|k| screen(t[k], depth(w[k] * (1.0 - apart)).min(1.0)));
                if (0..3).any(|k| before[k][2] <= behind[k][2]) {
                    continue; // Equal at the near plane: not nested.
                }
                for (v, name) in [([before, behind], "before first"), ([behind, before], "behind first")] {
                    let mut picture = Picture::new(200, 150);
                    for t in v {
                        let color = if t == before { 2 } else { 1 };
                        picture.target().triangles(&on_screen(), &t, &[[0, 1, 2]], &Flat(color));
                    }
                    let swapped = picture.color.iter().filter(|&&c| c == 1).count();
                    assert_eq!(swapped, 0, "far {far}, apart {apart}, {name}: {behind:?}");
                    pixels += picture.painted().len();
                }
            }
        }
    }
    assert!(pixels > 500_000, "{pixels} px");
}

#[test]
fn a_tie_goes_to_the_first_drawn() {
    let v = [px(1.0, 1.0, 0.3), px(14.0, 2.0, 0.7), px(5.0, 15.0, 0.5)];
    for test in [DepthTest::Greater, DepthTest::Less] {
        let mut picture = Picture::cleared(16, 16, test);
        let state = State { test, ..on_screen() };
        for (k, color) in [1, 2, 3].into_iter().enumerate() {
            // The same surface with its vertices in another order, wound either way.
            let order = permuted(&[0, 1, 2], [0, 1, 4][k]);
            picture.target().triangles(&state, &v, &[order], &Flat(color));
        }
        assert!(picture.painted().len() > 50);
        assert!(picture.color.iter().all(|&c| c <= 1), "{test:?}: {:?}", picture.rows());
    }
    let mut picture = Picture::cleared(16, 16, DepthTest::Off);
    let state = State { test: DepthTest::Off, ..on_screen() };
    for color in [1, 2, 3] {
        picture.target().triangles(&state, &v, &[[0, 1, 2]], &Flat(color));
    }
    assert!(picture.color.iter().all(|&c| c == 0 || c == 3), "{:?}", picture.rows());
}

#[test]
fn clearing_sets_what_every_depth_beats() {
    let mut color = vec![9_u8; 4];
    let mut wide = vec![0.25_f32; 4];
    let mut narrow = vec![77_u16; 4];
    for (test, f, u) in [(DepthTest::Greater, 0.0, 0), (DepthTest::Less, f32::INFINITY, u16::MAX)] {
        let mut target = Target::new(&mut color, Depth::F32(&mut wide), 2, 2, 2).unwrap();
        target.clear(5, test);
        assert_eq!((target.color_at(1, 1), target.depth_at(1, 1)), (Some(5), Some(StoredDepth::F32(f))));
        let mut target = Target::new(&mut color, Depth::U16(&mut narrow), 2, 2, 2).unwrap();
        target.clear(6, test);
        assert_eq!((target.color_at(0, 1), target.depth_at(0, 1)), (Some(6), Some(StoredDepth::U16(u))));
    }
}

/// The definition of the `u16` format.
fn quantised(z: f32) -> u16 {
    1 + (f64::from(z) * 65_534.0).floor() as u16
}

/// Draws triangles alone to get their `f32` depths, and plays the `u16` test in whole numbers.
#[test]
fn u16_depth_is_the_quantised_order_exactly() {
    let (width, height) = (64, 48);
    let mut r = Rng::new(37);
    for round in 0..200 {
        let (test, clear) =
            if round % 2 == 0 { (DepthTest::Greater, 0) } else { (DepthTest::Less, u16::MAX) };
        let mut color = vec![0_u32; width * height];
        let mut depth = vec![clear; width * height];
        let (mut expected, mut stored) = (color.clone(), depth.clone());
        for id in 1..=24_u32 {
            let t = triangle("random", &mut r, 64, 48);
            // Depths close together, so that quantised ties are common.
            let base = r.real(0.2, 0.8);
            let z = [(); 3]
                .map(|()| (if id % 2 == 0 { 0.5 + 1e-4 * r.unit() } else { base + 0.1 * r.unit() }) as f32);
            let v = [0, 1, 2].map(|k| screen(t[k], z[k]));
            let mut target = Target::new(&mut color, Depth::U16(&mut depth), 64, 48, width).unwrap();
            target.triangles(&State { test, ..on_screen() }, &v, &[[0, 1, 2]], &Flat(id));

            let mut alone = Picture::new(width, height);
            alone.target().triangles(
                &State { test: DepthTest::Off, ..on_screen() },
                &v,
                &[[0, 1, 2]],
                &Flat(1),
            );
            for k in (0..color.len()).filter(|&k| alone.color[k] == 1) {
                let new = quantised(alone.depth[k]);
                if (test == DepthTest::Greater && new > stored[k])
                    || (test == DepthTest::Less && new < stored[k])
                {
                    (expected[k], stored[k]) = (id, new);
                }
            }
        }
        assert!(color == expected && depth == stored, "round {round}");
    }
}

#[test]
fn the_ends_of_the_depth_range_quantise_as_defined() {
    for (z, stored) in [
        (1.0, 65_535),
        (0.0, 1),
        (0.5, 32_768),
        (1.0 / 65_534.0, 1),
        (1.01 / 65_534.0, 2),
        (0.999_999, 65_534),
    ] {
        assert_eq!(quantised(z), stored, "the test's own formula at {z}");
        let (mut color, mut depth) = ([0_u8; 4], [0_u16; 4]);
        let mut target = Target::new(&mut color, Depth::U16(&mut depth), 2, 2, 2).unwrap();
        let v = [px(0.0, 0.0, z), px(4.0, 0.0, z), px(0.0, 4.0, z)];
        target.triangles(&on_screen(), &v, &[[0, 1, 2]], &Flat(1));
        assert_eq!(depth[0], stored, "depth {z}");
    }
}

#[test]
fn a_clip_space_vertex_has_the_depth_z_over_w_rounded_once() {
    let mut r = Rng::new(38);
    for _ in 0..5_000 {
        let w = 2_f64.powf(r.real(-3.0, 10.0)) as f32;
        let z = (r.unit() as f32 * w).min(w);
        let expected = (f64::from(z) / f64::from(w)) as f32;
        let mut picture = Picture::cleared(2, 2, DepthTest::Less);
        let state = State { test: DepthTest::Less, ..State::default() };
        let v = [[-3.0, -3.0], [5.0, -3.0], [-3.0, 5.0]].map(|[x, y]: [f32; 2]| [x * w, y * w, z, w]);
        picture.target().triangles(&state, &v, &[[0, 1, 2]], &Flat(1));
        // All three vertices agree, so every pixel has that very depth.
        assert!(
            picture.depth.iter().all(|&d| d == expected),
            "{z} / {w}: {:?}, not {expected}",
            picture.depth
        );
    }
}
