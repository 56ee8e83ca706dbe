//! Claim: every setting does what it says, together with every other.
//!
//! Judge: a model of one pixel. Coverage from the oracle, depth from the triangle drawn alone, and the
//! rules of culling, scissor, test and write in four lines.

mod support;

use polosa_raster::{Cull, Depth, DepthTest, Flat, Fragment, Rect, Sample, State, Target};
use support::classes::{CLASSES, permuted, triangle};
use support::oracle::{CENTRE, area2, covers};
use support::picture::{Picture, on_screen, px, screen};
use support::rng::Rng;

const WIDTH: usize = 40;
const HEIGHT: usize = 32;

#[test]
fn all_settings_together_obey_the_model_of_a_pixel() {
    let mut r = Rng::new(100);
    let mut drawn = 0;
    for cull in [Cull::None, Cull::Front, Cull::Back] {
        for test in [DepthTest::Greater, DepthTest::Less, DepthTest::Off] {
            for write in [true, false] {
                for scissor in [None, Some(Rect { x0: 5, y0: 3, x1: 33, y1: 20 })] {
                    for rows in [0..HEIGHT as u32, 10..25] {
                        for stride in [WIDTH, WIDTH + 3] {
                            let state = State { cull, test, write, scissor, ..on_screen() };
                            for _ in 0..4 {
                                drawn += obeys_the_model(&state, rows.clone(), stride, &mut r);
                            }
                        }
                    }
                }
            }
        }
    }
    assert!(drawn > 50_000, "{drawn} px");
}

/// Draws some triangles into a band that already holds depths, and plays each pixel in the model.
fn obeys_the_model(state: &State, rows: std::ops::Range<u32>, stride: usize, r: &mut Rng) -> usize {
    let band = rows.start as usize..rows.end as usize;
    let mut color = vec![0_u32; stride * band.len()];
    let mut depth: Vec<f32> = color.iter().map(|_| r.range(0, 4) as f32 / 4.0).collect();
    let (mut model_color, mut model_depth) = (color.clone(), depth.clone());
    let mut drawn = 0;
    for id in 1..=4 {
        let t = permuted(&triangle("random", r, WIDTH as i64, HEIGHT as i64), id as usize);
        let v = t.map(|p| screen(p, r.range(1, 7) as f32 / 8.0));
        let mut target = Target::band(
            &mut color,
            Depth::F32(&mut depth),
            [WIDTH as u32, HEIGHT as u32],
            stride,
            rows.clone(),
        )
        .unwrap();
        let stats = target.triangles(state, &v, &[[0, 1, 2]], &Flat(id));

        let front = area2(&t) < 0;
        let culled = state.cull == if front { Cull::Front } else { Cull::Back };
        assert_eq!((stats.culled, stats.drawn), (u64::from(culled), u64::from(!culled)), "{state:?} {t:?}");
        let mut alone = Picture::new(WIDTH, HEIGHT);
        let off = State { test: DepthTest::Off, ..on_screen() };
        alone.target().triangles(&off, &v, &[[0, 1, 2]], &Flat(1));
        for y in band.clone() {
            for x in 0..WIDTH {
                let at = (y - band.start) * stride + x;
                let new = alone.depth_at(x, y);
                let inside = state
                    .scissor
                    .is_none_or(|s| (s.x0..s.x1).contains(&(x as u32)) && (s.y0..s.y1).contains(&(y as u32)));
                let passes = match state.test {
                    DepthTest::Greater => new > model_depth[at],
                    DepthTest::Less => new < model_depth[at],
                    DepthTest::Off => true,
                };
                if !culled && inside && passes && covers(&t, x as i64, y as i64, CENTRE) {
                    model_color[at] = id;
                    if state.write {
                        model_depth[at] = new;
                    }
                    drawn += 1;
                }
            }
        }
        assert!(color == model_color, "colours differ: {state:?}, rows {rows:?}, stride {stride}, {t:?}");
        assert!(depth == model_depth, "depths differ: {state:?}, rows {rows:?}, stride {stride}, {t:?}");
    }
    drawn
}

#[test]
fn front_faces_are_counter_clockwise_to_the_eye() {
    // In clip space y is up: left, right, top is counter-clockwise.
    let v = [[-0.5, -0.5, 0.5, 1.0], [0.5, -0.5, 0.5, 1.0], [0.0, 0.5, 0.5, 1.0]];
    for (order, cull, visible) in [
        ([0, 1, 2], Cull::Back, true),
        ([0, 1, 2], Cull::Front, false),
        ([0, 2, 1], Cull::Back, false),
        ([0, 2, 1], Cull::Front, true),
    ] {
        let mut picture = Picture::new(16, 16);
        picture.target().triangles(&State { cull, ..State::default() }, &v, &[order], &Flat(1));
        assert_eq!(!picture.painted().is_empty(), visible, "{order:?} {cull:?}");
    }
}

#[test]
fn a_scissor_of_any_numbers_draws_no_pixel_outside_of_it() {
    let v = [px(-50.0, -50.0, 0.5), px(150.0, -50.0, 0.5), px(-50.0, 150.0, 0.5)];
    let most = u32::MAX;
    for [x0, y0, x1, y1] in [
        [0, 0, 0, 0],
        [5, 5, 5, 9],
        [9, 3, 2, 8],
        [0, 0, most, most],
        [most, most, most, most],
        [most, 0, 0, most],
        [7, 9, 8, 10],
        [15, 15, 99, 99],
    ] {
        let scissor = Some(Rect { x0, y0, x1, y1 });
        let mut picture = Picture::new(16, 16);
        picture.target().triangles(&State { scissor, ..on_screen() }, &v, &[[0, 1, 2]], &Flat(1));
        for k in 0..256 {
            let (x, y) = (k % 16, k / 16);
            let inside = x0 <= x && x < x1 && y0 <= y && y < y1;
            assert_eq!(picture.at(x as usize, y as usize) == 1, inside, "{scissor:?}: ({x}, {y})");
        }
    }
}

#[test]
fn every_sample_offset_equals_the_oracle_at_that_offset() {
    let mut r = Rng::new(101);
    let mut picture = Picture::new(WIDTH, HEIGHT);
    for k in 0..65_536_usize {
        let sample = [k as i64 % 256, k as i64 / 256];
        let t = permuted(&triangle(CLASSES[k % 5], &mut r, WIDTH as i64, HEIGHT as i64), k);
        picture.color.fill(0);
        let state = State {
            sample: Sample { x: sample[0] as u8, y: sample[1] as u8 },
            test: DepthTest::Off,
            ..on_screen()
        };
        picture.target().triangles(&state, &t.map(|v| screen(v, 0.5)), &[[0, 1, 2]], &Flat(1));
        for (y, row) in picture.color.chunks(WIDTH).enumerate() {
            let span = support::oracle::row_span(&t, y as i64, sample, WIDTH);
            let same = row.iter().enumerate().all(|(x, &c)| (c == 1) == span.contains(&x));
            assert!(same, "{t:?} at {sample:?}, row {y}: expected {span:?}");
        }
    }
}

#[test]
fn bad_indices_are_counted_and_the_rest_is_drawn() {
    let v = [px(0.0, 0.0, 0.5), px(16.0, 0.0, 0.5), px(0.0, 16.0, 0.5)];
    let mut picture = Picture::new(16, 16);
    let triangles = [[0, 1, 3], [u32::MAX, 1, 2], [0, 1, 2], [3, 3, 3], [0, 0, 1]];
    let stats = picture.target().triangles(&on_screen(), &v, &triangles, &Flat(1));
    assert_eq!((stats.submitted, stats.bad_index, stats.drawn, stats.degenerate), (5, 3, 1, 1));
    assert_eq!(picture.painted().len(), 120);
    let stats = picture.target().triangles(&on_screen(), &[], &triangles, &Flat(1));
    assert_eq!((stats.submitted, stats.bad_index), (5, 5));
}

#[test]
fn a_fragment_knows_its_place_depth_and_triangle() {
    let v = [px(1.0, 2.0, 0.25), px(14.0, 3.0, 0.5), px(5.0, 13.0, 1.0), px(15.5, 15.5, 0.125)];
    let triangles = [[0, 0, 0], [0, 1, 2], [9, 9, 9], [1, 3, 2]];
    let mut expected = Picture::new(16, 16);
    let id = polosa_raster::PerTriangle(|k: usize| k as u32);
    expected.target().triangles(&on_screen(), &v, &triangles, &id);
    let mut color = vec![None; 16 * 6];
    let mut depth = vec![0.0; 16 * 6];
    let mut target = Target::band(&mut color, Depth::F32(&mut depth), [16, 16], 16, 5..11).unwrap();
    let shade = |f: &Fragment<'_>, pixel: &mut Option<(u32, u32, f32, usize)>| {
        *pixel = Some((f.x(), f.y(), f.depth(), f.triangle()));
        true
    };
    target.triangles(&on_screen(), &v, &triangles, &shade);
    let mut seen = 0;
    for (k, pixel) in color.iter().enumerate() {
        let (x, y) = (k % 16, 5 + k / 16);
        let Some(found) = *pixel else {
            assert_eq!(expected.depth_at(x, y), 0.0);
            continue;
        };
        assert_eq!(found, (x as u32, y as u32, expected.depth_at(x, y), expected.at(x, y) as usize));
        assert_eq!(depth[k], found.2);
        seen += 1;
    }
    assert!(seen > 30, "{seen}");
}

/// What a shade discards leaves neither colour nor depth, so that what comes later and farther is seen through it.
#[test]
fn a_discarded_fragment_leaves_nothing() {
    let wall = |z| [px(0.0, 0.0, z), px(32.0, 0.0, z), px(0.0, 32.0, z)];
    let mut picture = Picture::new(16, 16);
    let grate = |f: &Fragment<'_>, pixel: &mut u32| {
        *pixel = 1; // also where it is discarded
        (f.x() + f.y()) % 2 == 0
    };
    picture.target().triangles(&on_screen(), &wall(0.75), &[[0, 1, 2]], &grate);
    assert_eq!((picture.at(0, 0), picture.at(1, 0)), (1, 0));
    picture.target().triangles(&on_screen(), &wall(0.25), &[[0, 1, 2]], &Flat(2));
    for k in 0..256 {
        let (x, y) = (k % 16, k / 16);
        let kept = (x + y) % 2 == 0;
        let expected = if kept { (1, 0.75) } else { (2, 0.25) };
        assert_eq!((picture.at(x, y), picture.depth_at(x, y)), expected, "({x}, {y})");
    }
}

#[test]
fn a_shade_may_blend_with_what_is_there() {
    let wall = |z| [px(0.0, 0.0, z), px(32.0, 0.0, z), px(0.0, 32.0, z)];
    let mut picture = Picture::new(8, 8);
    picture.color.fill(100);
    let half = |_: &Fragment<'_>, pixel: &mut u32| {
        *pixel = (*pixel + 200) / 2;
        true
    };
    let state = State { write: false, ..on_screen() };
    for expected in [150, 175, 187] {
        picture.target().triangles(&state, &wall(0.5), &[[0, 1, 2]], &half);
        assert!(picture.color.iter().all(|&c| c == expected), "{expected}");
        assert!(picture.depth.iter().all(|&z| z == 0.0), "depth is not written");
    }
}

#[test]
fn statistics_add_up() {
    let v = [
        [-0.5, -0.5, 0.5, 1.0],
        [0.5, -0.5, 0.5, 1.0],
        [0.0, 0.5, 0.5, 1.0],
        [0.0, 0.5, 2.0, 1.0],  // before the near plane
        [0.0, 0.5, -1.0, 1.0], // beyond the far plane
        [f32::NAN, 0.0, 0.5, 1.0],
    ];
    let triangles = [
        [0, 1, 2], // drawn
        [0, 2, 1], // culled
        [0, 1, 3], // drawn, clipped
        [3, 3, 3], // outside
        [4, 4, 4], // outside
        [0, 1, 5], // not finite
        [0, 1, 1], // degenerate
        [0, 1, 6], // bad index
        [1, 0, 4], // culled, clipped
    ];
    let mut picture = Picture::new(16, 16);
    let state = State { cull: Cull::Back, ..State::default() };
    let stats = picture.target().triangles(&state, &v, &triangles, &Flat(1));
    let found = [
        stats.submitted,
        stats.drawn,
        stats.culled,
        stats.outside,
        stats.not_finite,
        stats.degenerate,
        stats.bad_index,
        stats.clipped,
    ];
    assert_eq!(found, [9, 2, 2, 2, 1, 1, 1, 2], "{stats:?}");
    let mut sum = stats;
    sum += stats;
    assert_eq!(sum, stats + stats);
    assert_eq!((sum.submitted, sum.drawn, sum.clipped), (18, 4, 4));
}
