//! Claim: what the planes cut off is gone, what they leave stays, to within the snap of a vertex.
//!
//! Judge: homogeneous lines in exact integers ([`support::homogeneous`]), which need no clipping.
//! A pixel may differ only where its centre lies within √2/512 px of a true edge. Meshes that are
//! clipped still draw every pixel once: scenes 8 to 13.

mod support;

use polosa_raster::{Clip, Depth, Flat, State, Stats, Target};
use support::homogeneous::{Homogeneous, SNAP};
use support::oracle::{CENTRE, Vertex, covers, near_boundary, sample_point};
use support::picture::{Picture, count, on_screen, px, screen};
use support::rng::Rng;

const WIDTH: usize = 64;
const HEIGHT: usize = 48;

fn counted(state: &State, v: &[Clip], triangles: &[[u32; 3]]) -> (Vec<u32>, Stats) {
    let mut color = vec![0; WIDTH * HEIGHT];
    let mut target = Target::new(&mut color, Depth::None, WIDTH as u32, HEIGHT as u32, WIDTH).unwrap();
    let stats = target.triangles(state, v, triangles, &count);
    (color, stats)
}

/// Draws one triangle and compares it with the oracle; returns the statistics and the pixels drawn.
#[track_caller]
fn equals_homogeneous(v: &[[i64; 4]; 3]) -> (Stats, usize) {
    let (color, stats) = counted(&State::default(), &Homogeneous::clip(v), &[[0, 1, 2]]);
    let oracle = Homogeneous::new(v, WIDTH as i64, HEIGHT as i64);
    for (k, &times) in color.iter().enumerate() {
        let (i, j) = ((k % WIDTH) as i64, (k / WIDTH) as i64);
        let by = oracle.as_ref().map_or(f64::NEG_INFINITY, |o| o.inside_by(i, j));
        assert!(times <= 1, "{v:?}: pixel ({i}, {j}) drawn {times} times");
        let fine = (times == 1) == (by >= 0.0) || by.abs() <= SNAP;
        assert!(fine, "{v:?}: pixel ({i}, {j}) drawn {times} times, {by} px inside the true triangle");
    }
    (stats, color.iter().filter(|&&times| times > 0).count())
}

/// Scene 8: a quad far larger than the viewport, turned by 0°, 6°, … 84°.
#[test]
fn scene_08_a_turned_quad_larger_than_the_viewport_draws_every_pixel_once() {
    for half in [2.0, 100.0, 1e4, 1e6, 1e9, 1e18] {
        for step in 0..15 {
            let (sin, cos) = f64::from(step * 6).to_radians().sin_cos();
            let corner =
                |x: f64, y: f64| [half * (x * cos - y * sin), half * (x * sin + y * cos)].map(|c| c as f32);
            let v = [(-1.0, -1.0), (1.0, -1.0), (1.0, 1.0), (-1.0, 1.0)].map(|(x, y)| {
                let [x, y] = corner(x, y);
                [x, y, 0.5, 1.0]
            });
            for cut in [[[0, 1, 2], [0, 2, 3]], [[1, 2, 3], [3, 0, 1]], [[2, 1, 0], [0, 2, 3]]] {
                let (color, _) = counted(&State::default(), &v, &cut);
                assert!(color.iter().all(|&times| times == 1), "half size {half}, {}°, {cut:?}", step * 6);
            }
        }
    }
}

/// Scene 9: a quad with w from 0.1 at one side to 4 at the other; its diagonal is drawn once.
#[test]
fn scene_09_a_projected_quad_draws_every_pixel_at_most_once() {
    let mut r = Rng::new(50);
    for round in 0..200 {
        let jitter = |r: &mut Rng| if round == 0 { 0.0 } else { r.real(-0.2, 0.2) as f32 };
        let v = [(-0.9, -0.8, 0.1), (0.9, -0.7, 0.1), (0.8, 0.9, 4.0), (-0.7, 0.8, 4.0)]
            .map(|(x, y, w): (f32, f32, f32)| [(x + jitter(&mut r)) * w, (y + jitter(&mut r)) * w, 0.05, w]);
        let snap = |c: f32, w: f32, half: f64| {
            (f64::from(c) / f64::from(w) * half + half.abs()).round_ties_even() as i64
        };
        let t = v.map(|[x, y, _, w]| [snap(x, w, 128.0 * WIDTH as f64), snap(y, w, -128.0 * HEIGHT as f64)]);
        for cut in [[[0_u32, 1, 2], [0, 2, 3]], [[1, 2, 3], [0, 1, 3]]] {
            let (color, stats) = counted(&State::default(), &v, &cut);
            assert_eq!((stats.drawn, stats.clipped), (2, 0), "{v:?}");
            for (k, &times) in color.iter().enumerate() {
                let inside = |c: [u32; 3]| {
                    covers(&c.map(|i| t[i as usize]), (k % WIDTH) as i64, (k / WIDTH) as i64, CENTRE)
                };
                let expected = u32::from(inside(cut[0])) + u32::from(inside(cut[1]));
                assert!(times == expected && times <= 1, "{v:?}: pixel {k} {times} times, not {expected}");
            }
        }
    }
}

/// Scene 10: up to ±32,767 px nothing is clipped, and the picture is the oracle's, cut off.
#[test]
fn scene_10_up_to_32_767_px_equals_the_oracle() {
    let far = 32_767 * 256;
    let all: [[Vertex; 3]; 4] = [
        [[-far, -far], [far, -far], [0, far]],
        [[-far, -far], [far, far], [far, far - 1]],
        [[-far, 20 * 256], [far, 21 * 256], [far, 20 * 256]],
        [[far, far], [-far, far - 256 * 11], [40 * 256, -far]],
    ];
    for t in all {
        let (color, stats) = counted(&on_screen(), &t.map(|v| screen(v, 0.5)), &[[0, 1, 2]]);
        assert_eq!((stats.drawn, stats.clipped), (1, 0), "{t:?}");
        for (k, &times) in color.iter().enumerate() {
            let expected = covers(&t, (k % WIDTH) as i64, (k / WIDTH) as i64, CENTRE);
            assert_eq!(times, u32::from(expected), "{t:?}: pixel ({}, {})", k % WIDTH, k / WIDTH);
        }
    }
}

#[test]
fn scene_10_beyond_32_767_px_differs_only_beside_a_true_edge() {
    let mut r = Rng::new(51);
    let mut visible = 0;
    for _ in 0..4_000 {
        // Whole pixels up to ±2,000,000: exact in f32, and no rounding in the oracle either.
        let reach = [40_000, 200_000, 2_000_000][r.index(3)];
        let p = |r: &mut Rng| [r.range(-reach, reach), r.range(-reach, reach)];
        let mut t = [p(&mut r), p(&mut r), p(&mut r)];
        if r.index(3) > 0 {
            t[r.index(3)] = [r.range(-10, 80), r.range(-10, 60)];
        }
        let (color, stats) =
            counted(&on_screen(), &t.map(|v| px(v[0] as f32, v[1] as f32, 0.5)), &[[0, 1, 2]]);
        assert_eq!(stats.not_finite, 0, "{t:?}");
        let t = t.map(|v| v.map(|c| 256 * c));
        for (k, &times) in color.iter().enumerate() {
            let (i, j) = ((k % WIDTH) as i64, (k / WIDTH) as i64);
            let same = times == u32::from(covers(&t, i, j, CENTRE));
            assert!(same || near_boundary(&t, sample_point(i, j, CENTRE), 1), "{t:?}: pixel ({i}, {j})");
        }
        visible += usize::from(color.contains(&1));
    }
    assert!(visible > 1_000, "only {visible} triangles are visible");
}

#[test]
fn scene_10_no_size_is_too_large() {
    for size in [1e10, 1e20, 1e30, f32::MAX] {
        for state in [State::default(), on_screen()] {
            let v = [
                [-size, -size, 0.5, 1.0],
                [size, -size, 0.5, 1.0],
                [size, size, 0.5, 1.0],
                [-size, size, 0.5, 1.0],
            ];
            let (color, stats) = counted(&state, &v, &[[0, 1, 2], [0, 2, 3]]);
            assert_eq!((stats.drawn, stats.clipped), (2, 2), "{size:e}: {stats:?}");
            assert!(color.iter().all(|&times| times == 1), "{size:e}");
        }
    }
}

/// Scene 11: a floor one unit below the eye that runs from five units behind it to 1,000 ahead.
/// With a reversed infinite depth, z is the near distance (here 1/16) at every vertex.
#[test]
fn scene_11_a_floor_through_the_near_plane_equals_the_oracle() {
    let u = 4096;
    let floor = |x: i64, w: i64| [x * u, -u, u / 16, w * u];
    // The diagonal runs ahead through (0, 2) to the horizon, in sight all the way.
    let v = [floor(-7, -5), floor(2000, -5), floor(998, 1000), floor(-2000, 1000)];
    let cut = [[0, 1, 2], [0, 2, 3]];
    for t in cut {
        let (stats, drawn) = equals_homogeneous(&t.map(|i| v[i]));
        assert_eq!((stats.drawn, stats.clipped), (1, 1));
        assert!(drawn > 100, "{drawn} px");
    }
    let (color, _) = counted(
        &State::default(),
        &v.map(|v| v.map(|c| c as f32 / 4096.0)),
        &cut.map(|t| t.map(|i| i as u32)),
    );
    // No bow-tie: nothing above the horizon (row 24), everything below it, once.
    let above = &color[..WIDTH * HEIGHT / 2];
    assert!(above.iter().all(|&times| times == 0), "drawn above the horizon");
    assert!(
        color[WIDTH * (HEIGHT / 2 + 1)..].iter().all(|&times| times == 1),
        "a hole or a double below the horizon"
    );
}

#[test]
fn scene_11_random_floors_and_walls_equal_the_oracle() {
    let mut r = Rng::new(52);
    let mut clipped = 0;
    for _ in 0..1_500 {
        let (turn, height) = (r.index(2), r.range(-40_000, 40_000));
        let v = [(); 3].map(|()| {
            let across = r.range(-100_000, 100_000);
            let xy = if turn == 0 { [across, height] } else { [height, across] };
            [xy[0], xy[1], 400, r.range(-40_000, 80_000)]
        });
        clipped += equals_homogeneous(&v).0.clipped;
    }
    assert!(clipped > 500, "{clipped} clipped");
}

/// Scene 12: one, two or three vertices behind the near plane, behind the eye, or beyond the far plane.
#[test]
fn scene_12_any_number_of_clipped_vertices_equals_the_oracle() {
    let mut r = Rng::new(53);
    let mut seen = [[0; 2]; 4];
    for _ in 0..2_500 {
        let v = [(); 3].map(|()| {
            let w = [r.range(-4_096, 20_000), r.range(1, 20_000)][r.index(2)];
            let reach = 2 * w.abs() + 100;
            [r.range(-reach, reach), r.range(-reach, reach), r.range(-6_000, 20_000), w]
        });
        let (stats, drawn) = equals_homogeneous(&v);
        let cut_off = v.iter().filter(|v| v[2] > v[3] || v[2] < 0).count();
        seen[cut_off][usize::from(drawn > 0)] += 1;
        if cut_off == 0 && v.iter().all(|v| v[0].abs() <= 100 * v[3] && v[1].abs() <= 100 * v[3]) {
            assert_eq!(stats.clipped, 0, "{v:?} needs no clipping");
        }
        if cut_off == 1 || cut_off == 2 {
            assert!(
                stats.clipped + stats.degenerate + stats.outside + stats.not_finite > 0,
                "{v:?}: {stats:?}"
            );
        }
    }
    assert!(seen[..3].iter().all(|s| s[1] > 50), "visible triangles by vertices cut off: {seen:?}");
    assert!(seen[3][0] > 50, "{seen:?}");
}

/// Scene 13: a parallelogram of two triangles through the near plane, the far plane or the guard band.
/// Were the shared edge cut differently from its two sides, holes and doubles would line it.
#[test]
fn scene_13_an_edge_clipped_from_both_sides_has_no_crack() {
    let mut r = Rng::new(54);
    let (mut clipped, mut inner) = (0, 0);
    for round in 0..1_500 {
        let corner = |r: &mut Rng| {
            let w = r.range(-20_000, 60_000);
            let z = [r.range(-3_000, 30_000), 300][r.index(2)];
            let reach = if round % 3 == 0 { 50_000 } else { 2_000_000 };
            [r.range(-reach, reach), r.range(-reach, reach), z, w]
        };
        let [mut a, mut b, mut c] = [corner(&mut r), corner(&mut r), corner(&mut r)];
        if round % 3 == 2 {
            // Only one of the two is cut, and the shared edge ends on the near plane or a hair inside of it.
            let mut at = |w: i64, reach: i64| [r.range(-reach, reach), r.range(-reach, reach), 300, w];
            (a, b, c) = (at(300 + round, 600), at(290 - round % 500, 600), at(300 + round % 4, 300));
        }
        let d = [0, 1, 2, 3].map(|k| a[k] + c[k] - b[k]);
        let v = [a, b, c, d];
        let both = ([a, b, c], [c, d, a]); // The shared edge is opposite vertex 1 of each.
        let size = (WIDTH as i64, HEIGHT as i64);
        let (Some(one), Some(two)) =
            (Homogeneous::new(&both.0, size.0, size.1), Homogeneous::new(&both.1, size.0, size.1))
        else {
            continue;
        };
        let clip = v.map(|v| v.map(|c| c as f32 / 4096.0));
        let (color, stats) = counted(&State::default(), &clip, &[[0, 1, 2], [2, 3, 0]]);
        clipped += stats.clipped;
        for (k, &times) in color.iter().enumerate() {
            let (i, j) = ((k % WIDTH) as i64, (k / WIDTH) as i64);
            let by = one.inside_by_without(1, i, j).min(two.inside_by_without(1, i, j));
            let once = by > SNAP;
            inner += usize::from(once);
            assert!(!once || times == 1, "{v:?}: pixel ({i}, {j}) drawn {times} times");
            assert!(by >= -SNAP || times == 0, "{v:?}: stray pixel ({i}, {j})");
        }
    }
    assert!(clipped > 1_500 && inner > 150_000, "{clipped} clipped, {inner} px");
}

/// A closed fan around the eye's axis whose rim lies behind the eye: the whole picture, once.
#[test]
fn a_fan_with_its_rim_behind_the_eye_draws_every_pixel_once() {
    let mut r = Rng::new(55);
    for round in 0..200 {
        let spokes = 3 + r.index(14);
        let mut v = vec![[r.real(-0.5, 0.5) as f32, r.real(-0.5, 0.5) as f32, 0.01, 4.0]];
        for k in 0..spokes {
            let angle = std::f64::consts::TAU * k as f64 / spokes as f64;
            v.push([4.0 * angle.cos() as f32, 4.0 * angle.sin() as f32, 0.01, r.real(-1.0, -0.1) as f32]);
        }
        let triangles: Vec<_> = (0..spokes as u32).map(|k| [0, 1 + k, 1 + (k + 1) % spokes as u32]).collect();
        let (color, stats) = counted(&State::default(), &v, &triangles);
        assert_eq!(stats.clipped, spokes as u64, "round {round}: {stats:?}");
        assert!(color.iter().all(|&times| times == 1), "round {round}: {v:?}");
    }
}

/// A pixel has the depth of a point of the true triangle within the snap of it. Depth is linear on the
/// screen: the points furthest off in depth lie on the border of that neighbourhood.
#[test]
fn a_clipped_triangle_has_the_depth_of_the_whole() {
    let mut r = Rng::new(57);
    let mut pixels = 0;
    for _ in 0..1_000 {
        let v = [(); 3].map(|()| {
            let w = r.range(-10_000, 40_000);
            [r.range(-60_000, 60_000), r.range(-60_000, 60_000), r.range(-2_000, 20_000), w]
        });
        let Some(oracle) = Homogeneous::new(&v, WIDTH as i64, HEIGHT as i64) else { continue };
        let mut picture = Picture::new(WIDTH, HEIGHT);
        picture.target().triangles(&State::default(), &Homogeneous::clip(&v), &[[0, 1, 2]], &Flat(1));
        for (x, y) in picture.painted() {
            let (px, py) = (x as f64 + 0.5, y as f64 + 0.5);
            let exact = oracle.depth(px, py);
            let steps = (0..16).map(|k| (std::f64::consts::TAU * f64::from(k) / 16.0).sin_cos());
            // 1.03: sixteen points come this near to a circle.
            let beside = steps.map(|(sin, cos)| oracle.depth(px + 1.03 * SNAP * cos, py + 1.03 * SNAP * sin));
            let spread = beside.map(|d| (d - exact).abs()).fold(0.0, f64::max);
            let error = (f64::from(picture.depth_at(x, y)) - exact).abs();
            let bound = spread + (exact.abs() + spread) * 5.0 / 16_777_216.0;
            assert!(error <= bound, "{v:?} at ({x}, {y}): {error:e} off {exact}, {bound:e} allowed");
            pixels += 1;
        }
    }
    assert!(pixels > 50_000, "{pixels} px");
}

/// The front of a triangle stays its front however it is cut.
#[test]
fn clipping_keeps_the_side_that_a_triangle_shows() {
    use polosa_raster::Cull;
    let mut r = Rng::new(56);
    let (mut front, mut back) = (0, 0);
    for _ in 0..3_000 {
        let v = [(); 3]
            .map(|()| [r.range(-60_000, 60_000), r.range(-60_000, 60_000), 300, r.range(-10_000, 40_000)]);
        let v = Homogeneous::clip(&v);
        let draw = |cull| {
            let mut picture = Picture::new(WIDTH, HEIGHT);
            let state = State { cull, ..State::default() };
            picture.target().triangles(&state, &v, &[[0, 1, 2]], &Flat(1));
            picture.painted().len()
        };
        let (all, fronts, backs) = (draw(Cull::None), draw(Cull::Back), draw(Cull::Front));
        // Counter-clockwise in the x, y, w cone: det > 0 shows the front to the eye.
        let x = v.map(|[x, y, _, w]| [x, y, w].map(f64::from));
        let det: f64 = (0..3)
            .map(|k| {
                let ([a, b, c], k1, k2) = (x, (k + 1) % 3, (k + 2) % 3);
                a[k] * (b[k1] * c[k2] - b[k2] * c[k1])
            })
            .sum();
        if all > 0 {
            assert_eq!((fronts, backs), if det > 0.0 { (all, 0) } else { (0, all) }, "{v:?}, det {det}");
            front += usize::from(fronts > 0);
            back += usize::from(backs > 0);
        }
    }
    assert!(front > 300 && back > 300, "{front} {back}");
}
