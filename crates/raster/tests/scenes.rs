//! The scenes that rasterisers are known to fail at, with what must come out.
//!
//! | scene | claim | test |
//! |---|---|---|
//! | 1, 2, 3, 7 | quads, collinear vertices, micro-triangles | here |
//! | 4, 5 | meshes on pixel centres, fans | `meshes.rs` |
//! | 6, 16, 17 | depth of slivers, close pairs, far-off triangles | `depth.rs` |
//! | 8 to 13 | clipping | `clipping.rs` |
//! | 14, 15, 22, 23 | interpenetration, order, bad numbers, vertex order and bands | here |

mod support;

use polosa_raster::{Clip, Depth, Flat, PerTriangle, State, Target};
use support::classes::permuted;
use support::oracle::{CENTRE, Vertex, area2, covers};
use support::picture::{Picture, count, on_screen, px, screen};
use support::plane::numerators;
use support::rng::Rng;

fn counted(v: &[Clip], triangles: &[[u32; 3]], width: usize, height: usize) -> Picture {
    let mut picture = Picture::new(width, height);
    let (w, h) = (u32::try_from(width).unwrap(), u32::try_from(height).unwrap());
    let mut target = Target::new(&mut picture.color, Depth::None, w, h, width).unwrap();
    target.triangles(&on_screen(), v, triangles, &count);
    picture
}

/// Scene 1: the square (1, 1)–(7, 7), its diagonal through six pixel centres.
#[test]
fn scene_01_a_quad_cut_through_pixel_centres_draws_36_pixels_once() {
    let v = [px(1.0, 1.0, 0.5), px(7.0, 1.0, 0.5), px(7.0, 7.0, 0.5), px(1.0, 7.0, 0.5)];
    for cut in
        [[[0, 1, 2], [0, 2, 3]], [[1, 2, 3], [1, 3, 0]], [[2, 1, 0], [0, 2, 3]], [[0, 2, 1], [3, 2, 0]]]
    {
        let picture = counted(&v, &cut, 8, 8);
        assert_eq!(picture.painted().len(), 36, "{cut:?}");
        assert!(picture.color.iter().all(|&times| times <= 1), "{cut:?}: {:?}", picture.rows());
    }
}

/// Scene 2: (0, 0), (50, 50), (100, 100).
#[test]
fn scene_02_collinear_vertices_draw_nothing() {
    for order in [[0, 1, 2], [2, 0, 1], [1, 0, 2]] {
        let v = [px(0.0, 0.0, 0.5), px(50.0, 50.0, 0.5), px(100.0, 100.0, 0.5)];
        let mut picture = Picture::new(128, 128);
        let stats = picture.target().triangles(&on_screen(), &v, &[order], &Flat(1));
        assert_eq!((stats.degenerate, stats.drawn), (1, 0));
        assert!(picture.painted().is_empty());
    }
}

/// Scene 3: all 85,320 triangles with corners on a ¼-pixel lattice inside 2 × 2 pixels. Every tie
/// of the top-left rule is among them.
#[test]
fn scene_03_all_micro_triangles_on_a_quarter_pixel_lattice_equal_the_oracle() {
    let lattice: Vec<Vertex> = (0..81).map(|k| [256 + 64 * (k % 9), 256 + 64 * (k / 9)]).collect();
    let (mut bytes, mut ties, mut tried) = ([0_u8; 16], 0, 0_usize);
    for a in 0..81 {
        for b in a + 1..81 {
            for c in b + 1..81 {
                let t = permuted(&[lattice[a], lattice[b], lattice[c]], tried);
                bytes.fill(0);
                let mut target = Target::new(&mut bytes, Depth::None, 4, 4, 4).unwrap();
                target.triangles(&on_screen(), &t.map(|v| screen(v, 0.5)), &[[0, 1, 2]], &Flat(1));
                for (k, &byte) in bytes.iter().enumerate() {
                    let (i, j) = (k as i64 % 4, k as i64 / 4);
                    assert_eq!(byte == 1, covers(&t, i, j, CENTRE), "{t:?}: pixel ({i}, {j})");
                    ties += usize::from(area2(&t) != 0 && numerators(&t, i, j, CENTRE).contains(&0));
                }
                tried += 1;
            }
        }
    }
    assert!(tried == 85_320 && ties > 100_000, "{tried} triangles, {ties} ties");
}

/// Scene 7: quads parallel to the axes and turned, cut along either diagonal, wound either way.
#[test]
fn scene_07_quads_draw_every_pixel_once() {
    let straight = [[10.0, 10.0], [50.5, 10.0], [50.5, 40.25], [10.0, 40.25]];
    let centres = [[10.5, 10.5], [40.5, 10.5], [40.5, 40.5], [10.5, 40.5]];
    let diamond = [[32.5, 2.5], [60.5, 30.5], [32.5, 58.5], [4.5, 30.5]];
    let turned = [[20.0, 5.0], [58.0, 21.0], [42.0, 59.0], [4.0, 43.0]];
    for (name, q) in [("straight", straight), ("centres", centres), ("diamond", diamond), ("turned", turned)]
    {
        let v = q.map(|[x, y]| px(x, y, 0.5));
        let snapped = q.map(|c: [f32; 2]| c.map(|c| (c * 256.0) as i64));
        for cut in [[[0_u32, 1, 2], [0, 2, 3]], [[1, 2, 3], [1, 3, 0]]] {
            for reverse in [false, true] {
                let cut = if reverse { cut.map(|[a, b, c]| [c, b, a]) } else { cut };
                let picture = counted(&v, &cut, 64, 64);
                for (k, &times) in picture.color.iter().enumerate() {
                    let (i, j) = (k as i64 % 64, k as i64 / 64);
                    // The whole quad, each half-plane by the same rule: two of its triangles
                    // cover the pixel together or not at all, whichever way it is cut.
                    let whole =
                        [[0, 1, 2], [0, 2, 3]].map(|t| covers(&t.map(|k: usize| snapped[k]), i, j, CENTRE));
                    assert_eq!(times, u32::from(whole[0] || whole[1]), "{name} {cut:?}: pixel ({i}, {j})");
                }
            }
        }
    }
}

/// Scene 14: one triangle with depth 10/16 at its first vertex and 0 at the others goes through one
/// at 3/16. It must be in front exactly where its first weight is above 0.3.
#[test]
fn scene_14_interpenetrating_triangles_switch_where_the_planes_meet() {
    let t: [Vertex; 3] = [[40 * 256, 4 * 256], [75 * 256, 70 * 256], [3 * 256, 61 * 256]];
    let tilted = [0, 1, 2].map(|k| screen(t[k], [10.0 / 16.0, 0.0, 0.0][k]));
    let level = t.map(|v| screen(v, 3.0 / 16.0));
    for order in [[(tilted, 1), (level, 2)], [(level, 2), (tilted, 1)]] {
        let mut picture = Picture::new(80, 80);
        for (v, color) in order {
            picture.target().triangles(&on_screen(), &v, &[[0, 1, 2]], &Flat(color));
        }
        let (mut front, mut back) = (0, 0);
        for (x, y) in picture.painted() {
            let n = numerators(&t, x as i64, y as i64, CENTRE)[0] * area2(&t).signum();
            let (ten, three) = (10 * n, 3 * area2(&t).abs()); // b₁ against 0.3, exactly
            if (ten - three).abs() * (1 << 21) < three {
                continue; // Nearer to the switch than 5·2⁻²⁴: either may be rounded in front.
            }
            let expected = if ten > three { 1 } else { 2 };
            assert_eq!(
                picture.at(x, y),
                expected,
                "({x}, {y}): b1 = {}",
                ten as f64 / area2(&t).abs() as f64 / 10.0
            );
            if expected == 1 { front += 1 } else { back += 1 }
        }
        assert!(front > 200 && back > 200, "{front} in front, {back} behind");
    }
}

/// Scene 15: where order is defined to matter, it does; everywhere else a shuffle changes no bit.
#[test]
fn scene_15_shuffled_triangles_give_the_same_picture() {
    let mut r = Rng::new(60);
    // Triangles of 40 levels, each drawn twice in two colours: of a pair, the first must win.
    let mut v = Vec::new();
    let mut order: Vec<u32> = Vec::new();
    for level in 0..40_u32 {
        let depth = (level + 1) as f32 / 64.0;
        v.extend([(); 3].map(|()| px(r.range(-20, 120) as f32, r.range(-20, 100) as f32, depth)));
        order.extend([level, level]);
    }
    let mut hashes = Vec::new();
    for _ in 0..12 {
        let mut seen = [0; 40];
        let (mut triangles, mut colors) = (Vec::new(), Vec::new());
        for &level in &order {
            triangles.push([3 * level, 3 * level + 1, 3 * level + 2]);
            colors.push(2 * level + 1 + seen[level as usize]);
            seen[level as usize] += 1;
        }
        let mut picture = Picture::new(100, 80);
        picture.target().triangles(&on_screen(), &v, &triangles, &PerTriangle(|k: usize| colors[k]));
        assert!(picture.color.iter().all(|c| *c == 0 || c % 2 == 1), "a second drawn won a tie");
        hashes.push(picture.hash());
        r.shuffle(&mut order);
    }
    assert!(hashes.iter().all(|&h| h == hashes[0]), "{hashes:x?}");
}

/// Scene 22: each bad number in each coordinate of each vertex.
#[test]
fn scene_22_bad_numbers_are_counted_and_leave_no_pixel() {
    let good = [[-0.5, -0.5, 0.5, 1.0], [0.5, -0.5, 0.5, 1.0], [0.0, 0.5, 0.5, 1.0]];
    for bad in [f32::NAN, f32::INFINITY, f32::NEG_INFINITY, -f32::NAN] {
        for state in [State::default(), on_screen()] {
            for at in 0..12 {
                let mut v = good;
                v[at / 4][at % 4] = bad;
                let mut picture = Picture::new(32, 32);
                let stats = picture.target().triangles(&state, &v, &[[0, 1, 2], [2, 1, 0]], &Flat(1));
                assert_eq!(
                    (stats.submitted, stats.not_finite, stats.drawn),
                    (2, 2, 0),
                    "{bad} in {v:?}: {stats:?}"
                );
                assert_eq!(picture, Picture::new(32, 32), "{bad} in {v:?}");
            }
        }
    }
}

#[test]
fn scene_22_zeros_and_denormals_are_ordinary_numbers() {
    // −0 is 0, wherever it stands.
    let v = [[-1.0, 0.0, 0.5, 1.0], [1.0, 0.0, 0.5, 1.0], [0.0, -1.0, 0.0, 1.0]];
    let negated = v.map(|v: Clip| v.map(|c| if c == 0.0 { -0.0 } else { c }));
    let mut pictures = [v, negated].map(|v| {
        let mut picture = Picture::new(32, 32);
        let stats = picture.target().triangles(&State::default(), &v, &[[0, 1, 2]], &Flat(1));
        assert_eq!(stats.drawn, 1);
        picture
    });
    assert!(pictures[0].painted().len() > 100);
    pictures[1].depth.iter_mut().for_each(|z| *z += 0.0); // −0 + 0 is 0
    assert_eq!(pictures[0], pictures[1]);

    // A denormal x is next to 0: the same picture. A triangle of denormals alone is ordinary, too:
    // x/w and y/w are what counts.
    let tiny = f32::from_bits(1);
    let mut shifted = v;
    shifted[2][0] = tiny;
    let mut picture = Picture::new(32, 32);
    picture.target().triangles(&State::default(), &shifted, &[[0, 1, 2]], &Flat(1));
    assert_eq!(picture, pictures[0]);
    let scaled = v.map(|v| v.map(|c| c * (4.0 * tiny)));
    let mut picture = Picture::new(32, 32);
    picture.target().triangles(&State::default(), &scaled, &[[0, 1, 2]], &Flat(1));
    assert_eq!(picture, pictures[0], "denormal x, y, z and w");
}

#[test]
fn scene_22_no_w_of_zero_or_less_is_drawn() {
    // All of w ≤ 0: outside 0 ≤ z ≤ w, or rejected where z = w = 0. No pixel in either case.
    for w in [0.0, -0.0, -1.0, -1e-30] {
        for z in [0.0, 0.5, -0.5, -1.0] {
            let v = [[-1.0, -1.0, z, w], [1.0, -1.0, z, w], [0.0, 1.0, z, w]];
            let mut picture = Picture::new(16, 16);
            let stats = picture.target().triangles(&State::default(), &v, &[[0, 1, 2]], &Flat(1));
            assert_eq!((stats.drawn, stats.outside + stats.not_finite), (0, 1), "z {z}, w {w}: {stats:?}");
            assert!(picture.painted().is_empty(), "z {z}, w {w}");
        }
    }
}

/// Scene 23: which vertex comes first decides no bit of colour or depth.
#[test]
fn scene_23_the_order_of_the_vertices_decides_no_bit() {
    let mut r = Rng::new(61);
    for round in 0..400 {
        let v: [Clip; 3] = if round % 2 == 0 {
            [(); 3].map(|()| {
                [
                    r.real(-2.0, 2.0) as f32,
                    r.real(-2.0, 2.0) as f32,
                    r.unit() as f32 * 0.5,
                    r.real(0.5, 3.0) as f32,
                ]
            })
        } else {
            // Through the near plane and the guard band.
            [(); 3].map(|()| {
                [r.real(-900.0, 900.0) as f32, r.real(-900.0, 900.0) as f32, 0.1, r.real(-1.0, 3.0) as f32]
            })
        };
        let draw = |t: [u32; 3]| {
            let mut picture = Picture::new(64, 48);
            picture.target().triangles(&State::default(), &v, &[t], &Flat(1));
            picture.hash()
        };
        let first = draw([0, 1, 2]);
        for k in 1..6 {
            assert_eq!(draw(permuted(&[0, 1, 2], k)), first, "{v:?}, permutation {k}");
        }
    }
}

/// Scene 23: bands of any height, drawn one by one, are the whole picture's rows.
#[test]
fn scene_23_bands_have_the_same_bytes_as_the_whole_picture() {
    let mut r = Rng::new(62);
    let v: Vec<Clip> = (0..180)
        .map(|_| [r.real(-3.0, 3.0) as f32, r.real(-3.0, 3.0) as f32, 0.1, r.real(-0.2, 3.0) as f32])
        .collect();
    let triangles: Vec<[u32; 3]> = (0..60).map(|k| [3 * k, 3 * k + 1, 3 * k + 2]).collect();
    let shade = PerTriangle(|k: usize| k as u32 + 1);
    let (width, height) = (70_usize, 61_usize);
    let mut whole = Picture::new(width, height);
    let stats = whole.target().triangles(&State::default(), &v, &triangles, &shade);
    for rows in [1, 2, 7, 16, 60, 61] {
        let mut banded = Picture::new(width, height);
        let bands = banded.color.chunks_mut(rows * width).zip(banded.depth.chunks_mut(rows * width));
        for (k, (color, depth)) in bands.enumerate() {
            let range = (k * rows) as u32..((k + 1) * rows).min(height) as u32;
            let mut target = Target::band(color, Depth::F32(depth), [70, 61], width, range).unwrap();
            assert_eq!(target.triangles(&State::default(), &v, &triangles, &shade), stats);
        }
        assert!(banded == whole, "bands of {rows} rows");
    }
}
