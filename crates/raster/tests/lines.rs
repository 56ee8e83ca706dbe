//! Claim: a line takes the pixels whose diamond it leaves, and its depth is that of the line.
//!
//! ```text
//!         ▲ ← in            the diamond |x − xc| + |y − yc| < ½ around a pixel's centre, with its
//!        ╱ ╲                top and its left corner. A start inside counts, an end inside does
//!  in → ◀ · ▶               not: the next line of a strip begins there.
//!        ╲ ╱                A flat line that passes exactly between two diamonds takes the lower
//!         ▼                 one, a steep line the right one.
//! ```
//!
//! A line down to the right at exactly 45° may run along diamonds' sides, from left corner to top
//! corner to left corner: for it, and its reverse, the left corner is out.
//!
//! Judge: for every pixel, the least |x − xc| + |y − yc| on the line in exact integers. The line's
//! walk along its longer axis appears nowhere.

mod support;

use std::collections::BTreeSet;

use polosa_raster::{Clip, Depth, DepthTest, Flat, Rect, Sample, State, Target};
use support::oracle::{CENTRE, Vertex, sample_point};
use support::picture::{Picture, on_screen, px, screen};
use support::rng::Rng;

/// Whether a point belongs to the diamond around `c`, its top and left corners in.
fn in_diamond(p: Vertex, c: Vertex) -> bool {
    let d = [p[0] - c[0], p[1] - c[1]];
    d[0].abs() + d[1].abs() < 128 || d == [0, -128] || d == [-128, 0]
}

/// The same for an end of the line from `a` to `b`.
fn end_in_diamond(p: Vertex, a: Vertex, b: Vertex, c: Vertex) -> bool {
    let down = b[0] - a[0] == b[1] - a[1];
    in_diamond(p, c) && !(down && p == [c[0] - 128, c[1]])
}

/// Whether the line from `a` to `b` takes the pixel with centre `c`.
fn takes(a: Vertex, b: Vertex, c: Vertex) -> bool {
    if end_in_diamond(b, a, b, c) {
        return false;
    }
    if end_in_diamond(a, a, b, c) {
        return true;
    }
    // |x − xc| + |y − yc| is convex along the line: least at an end, or where x = xc, or where y = yc.
    // (Were it least at an end, that end would be inside; only the crossings are left.)
    let d = [b[0] - a[0], b[1] - a[1]].map(i128::from);
    let to = [c[0] - a[0], c[1] - a[1]].map(i128::from);
    let steep = d[1].abs() > d[0].abs();
    (0..2).any(|axis| {
        let other = 1 - axis;
        let (across, along) = (d[axis], to[axis] * d[axis].signum());
        if across == 0 || along < 0 || along > across.abs() {
            return false;
        }
        // Where the line crosses, its distance from the centre on the other axis, times |across|.
        let off = d[other] * to[axis] * across.signum() - to[other] * across.abs();
        let tie = (axis == 1) == steep && off == -128 * across.abs();
        off.abs() < 128 * across.abs() || tie
    })
}

/// All pixels of a picture that a line takes.
fn expected(a: Vertex, b: Vertex, width: usize, height: usize, sample: [i64; 2]) -> BTreeSet<(usize, usize)> {
    let all = (0..height).flat_map(|y| (0..width).map(move |x| (x, y)));
    all.filter(|&(x, y)| takes(a, b, sample_point(x as i64, y as i64, sample))).collect()
}

fn drawn(a: Vertex, b: Vertex, width: usize, height: usize) -> BTreeSet<(usize, usize)> {
    let mut picture = Picture::new(width, height);
    picture.target().lines(&on_screen(), &[screen(a, 0.5), screen(b, 0.5)], &[[0, 1]], 1);
    picture.painted().into_iter().collect()
}

#[test]
fn every_line_between_half_pixels_equals_the_diamond_exit_oracle() {
    // All ends on a ½-pixel lattice in 4 × 4 pixels: centres, diamond corners, pixel corners, every tie.
    let lattice: Vec<Vertex> = (0..81).map(|k| [256 + 128 * (k % 9), 256 + 128 * (k / 9)]).collect();
    for &a in &lattice {
        for &b in lattice.iter().filter(|&&b| b != a) {
            assert_eq!(drawn(a, b, 7, 7), expected(a, b, 7, 7, CENTRE), "{a:?} to {b:?}");
        }
    }
}

#[test]
fn lines_with_random_sub_pixel_ends_equal_the_diamond_exit_oracle() {
    let mut r = Rng::new(80);
    let mut octants = [0; 8];
    for k in 0..16_000 {
        let grain = [1, 16, 64, 128][k % 4];
        let (low, high) = if k % 8 < 4 { (-512, 32 * 256) } else { (1024, 4096) };
        let mut p =
            || [r.range(low / grain, high / grain) * grain, r.range(low / grain, high / grain) * grain];
        let (a, b) = (p(), p());
        if a == b {
            continue;
        }
        let d = [b[0] - a[0], b[1] - a[1]];
        octants
            [usize::from(d[0] < 0) + 2 * usize::from(d[1] < 0) + 4 * usize::from(d[1].abs() > d[0].abs())] +=
            1;
        assert_eq!(drawn(a, b, 28, 24), expected(a, b, 28, 24, CENTRE), "{a:?} to {b:?}");
    }
    assert!(octants.iter().all(|&n| n > 1_000), "{octants:?}");
}

#[test]
fn lines_shorter_than_a_pixel_equal_the_diamond_exit_oracle() {
    let mut r = Rng::new(81);
    let mut taken = 0;
    for _ in 0..40_000 {
        let a = [r.range(256, 1024), r.range(256, 1024)];
        let b = [a[0] + r.range(-200, 200), a[1] + r.range(-200, 200)];
        if a != b {
            let drawn = drawn(a, b, 6, 6);
            assert_eq!(drawn, expected(a, b, 6, 6, CENTRE), "{a:?} to {b:?}");
            taken += drawn.len();
        }
    }
    assert!(taken > 5_000, "{taken}");
}

#[test]
fn lines_far_beyond_the_picture_equal_the_diamond_exit_oracle() {
    let mut r = Rng::new(82);
    let far = 32_767 * 256;
    let mut seen = 0;
    for _ in 0..4_000 {
        let through = [r.range(0, 28 * 256), r.range(0, 24 * 256)];
        let d = [r.range(-far / 2, far / 2), r.range(-far / 2, far / 2)];
        let (a, b) = ([through[0] - d[0], through[1] - d[1]], [through[0] + d[0], through[1] + d[1]]);
        let drawn = drawn(a, b, 28, 24);
        assert_eq!(drawn, expected(a, b, 28, 24, CENTRE), "{a:?} to {b:?}");
        seen += drawn.len();
    }
    assert!(seen > 40_000, "{seen}");
}

#[test]
fn every_sample_position_moves_the_diamonds_along() {
    let mut r = Rng::new(83);
    for _ in 0..3_000 {
        let mut p = || [r.range(0, 28 * 256), r.range(0, 24 * 256)];
        let (a, b) = (p(), p());
        let sample = [r.range(0, 255), r.range(0, 255)];
        let mut picture = Picture::new(28, 24);
        let state = State { sample: Sample { x: sample[0] as u8, y: sample[1] as u8 }, ..on_screen() };
        picture.target().lines(&state, &[screen(a, 0.5), screen(b, 0.5)], &[[0, 1]], 1);
        let drawn: BTreeSet<_> = picture.painted().into_iter().collect();
        assert_eq!(drawn, expected(a, b, 28, 24, sample), "{a:?} to {b:?} at {sample:?}");
    }
}

/// Draws line by line and counts: blending would show a joint drawn twice.
#[test]
fn a_strip_never_takes_the_pixel_of_a_joint_twice() {
    let mut r = Rng::new(84);
    for k in 0..6_000 {
        let grain = [1, 64, 128, 256][k % 4];
        let mut p = || [r.range(0, 28 * 256 / grain) * grain, r.range(0, 24 * 256 / grain) * grain];
        let (a, b, c) = (p(), p(), p());
        if a == b || b == c {
            continue;
        }
        let (first, second) = (drawn(a, b, 30, 26), drawn(b, c, 30, 26));
        for y in 0..26 {
            for x in 0..30 {
                let centre = sample_point(x as i64, y as i64, CENTRE);
                if in_diamond(b, centre) {
                    let times = [&first, &second].map(|line| usize::from(line.contains(&(x, y))));
                    let [down, leaves] =
                        [b[1] - a[1] == b[0] - a[0] || c[1] - b[1] == c[0] - b[0], !in_diamond(c, centre)];
                    assert!(times[0] + times[1] <= 1, "{a:?} to {b:?} to {c:?}: ({x}, {y}) {times:?}");
                    assert!(
                        down || times == [0, usize::from(leaves)],
                        "{a:?} to {b:?} to {c:?}: ({x}, {y}) {times:?}"
                    );
                }
            }
        }
    }
}

#[test]
fn a_line_without_length_or_with_a_bad_end_is_counted_and_takes_nothing() {
    let v = [px(3.0, 3.0, 0.5), px(3.0, 3.0, 0.5), px(f32::NAN, 1.0, 0.5), px(9.0, 9.0, 0.5)];
    let mut picture = Picture::new(16, 16);
    let stats = picture.target().lines(&on_screen(), &v, &[[0, 1], [0, 2], [0, 9], [0, 0], [0, 3]], 1);
    assert_eq!((stats.submitted, stats.drawn), (5, 1));
    assert_eq!((stats.degenerate, stats.not_finite, stats.bad_index), (2, 1, 1));
    assert_eq!(picture.painted(), (3..9).map(|k| (k, k)).collect::<Vec<_>>());
}

#[test]
fn a_lines_depth_is_linear_between_its_ends() {
    let mut r = Rng::new(85);
    for _ in 0..4_000 {
        let mut p = || [r.range(0, 60 * 256), r.range(0, 60 * 256)];
        let (a, b) = (p(), p());
        let z = [2_f64.powf(r.real(-20.0, 0.0)) as f32, r.unit().max(1e-6) as f32];
        let mut picture = Picture::new(60, 60);
        picture.target().lines(&on_screen(), &[screen(a, z[0]), screen(b, z[1])], &[[0, 1]], 1);
        let axis = usize::from((b[1] - a[1]).abs() > (b[0] - a[0]).abs());
        for (x, y) in picture.painted() {
            // Where the line crosses the pixel's column (a steep line: its row), or at its start
            // or end if that lies beyond.
            let along = sample_point(x as i64, y as i64, CENTRE)[axis] - a[axis];
            let t = (along as f64 / (b[axis] - a[axis]) as f64).clamp(0.0, 1.0);
            let exact = f64::from(z[0]) * (1.0 - t) + f64::from(z[1]) * t;
            let got = f64::from(picture.depth_at(x, y));
            assert!((got - exact).abs() <= exact * 2_f64.powi(-23), "({x}, {y}): {got}, not {exact}");
        }
    }
}

#[test]
fn lines_obey_depth_test_write_and_scissor() {
    let line = [px(0.0, 8.5, 0.5), px(16.0, 8.5, 0.5)];
    let wall = |z| [px(4.0, 0.0, z), px(12.0, 0.0, z), px(12.0, 16.0, z), px(4.0, 16.0, z)];
    for (z, test, visible) in [
        (0.6, DepthTest::Greater, 8),
        (0.4, DepthTest::Greater, 16),
        (0.5, DepthTest::Greater, 8), // a tie goes to the first drawn
        (0.6, DepthTest::Less, 16),
        (0.4, DepthTest::Less, 8),
        (0.6, DepthTest::Off, 16),
    ] {
        for write in [false, true] {
            let mut picture = Picture::cleared(16, 16, test);
            let state = State { test, ..on_screen() };
            picture.target().triangles(&state, &wall(z), &[[0, 1, 2], [0, 2, 3]], &Flat(1));
            let before = picture.depth.clone();
            picture.target().lines(&State { write, ..state }, &line, &[[0, 1]], 2);
            let shown: Vec<_> = (0..16).filter(|&x| picture.at(x, 8) == 2).collect();
            assert_eq!(shown.len(), visible, "{z} {test:?}: {shown:?}");
            for x in 0..16 {
                let written = write && shown.contains(&x);
                let depth = if written { 0.5 } else { before[8 * 16 + x] };
                assert_eq!(picture.depth_at(x, 8), depth, "{z} {test:?} write {write}, column {x}");
            }
        }
    }
    let mut picture = Picture::new(16, 16);
    let state = State { scissor: Some(Rect { x0: 3, y0: 0, x1: 7, y1: 99 }), ..on_screen() };
    picture.target().lines(&state, &line, &[[0, 1]], 2);
    assert_eq!(picture.painted(), [(3, 8), (4, 8), (5, 8), (6, 8)]);
}

/// The line runs from before the eye to behind it, and meets the near plane, z = w, halfway.
#[test]
fn a_line_is_drawn_up_to_the_near_plane_the_same_from_both_ends() {
    let (a, b, cut) = ([0.5, -0.25, 0.5, 2.0], [-0.5, 0.75, 0.5, -1.0], [0.0, 0.25, 0.5, 0.5]);
    for order in [[0, 1], [1, 0]] {
        let [whole, visible] = [b, cut].map(|end| {
            let mut picture = Picture::new(64, 48);
            let stats = picture.target().lines(&State::default(), &[a, end], &[order], 1);
            (picture, stats.clipped, stats.drawn)
        });
        assert_eq!((whole.1, visible.1, whole.2), (1, 0, 1));
        assert!(whole.0 == visible.0 && whole.0.painted().len() > 10, "{:?}", whole.0.rows());
    }
    let mut picture = Picture::new(64, 48);
    let behind = [[0.5, 0.5, 0.5, -1.0], [-0.5, 0.5, 0.5, 0.25]];
    let stats = picture.target().lines(&State::default(), &behind, &[[0, 1]], 1);
    assert!(stats.outside == 1 && picture.painted().is_empty());
}

#[test]
fn a_lines_bands_are_the_whole_pictures_rows() {
    let mut r = Rng::new(86);
    let v: Vec<Clip> = (0..80)
        .map(|_| [r.real(-3.0, 3.0) as f32, r.real(-3.0, 3.0) as f32, 0.1, r.real(-0.5, 2.0) as f32])
        .collect();
    let lines: Vec<[u32; 2]> = (0..40).map(|k| [2 * k, 2 * k + 1]).collect();
    let mut whole = Picture::new(50, 41);
    whole.target().lines(&State::default(), &v, &lines, 3);
    assert!(whole.painted().len() > 200);
    let mut banded = Picture::new(50, 41);
    for (k, (color, depth)) in banded.color.chunks_mut(350).zip(banded.depth.chunks_mut(350)).enumerate() {
        let rows = 7 * k as u32..(7 * k as u32 + 7).min(41);
        let mut target = Target::band(color, Depth::F32(depth), [50, 41], 50, rows).unwrap();
        target.lines(&State::default(), &v, &lines, 3);
    }
    assert!(banded == whole);
}
