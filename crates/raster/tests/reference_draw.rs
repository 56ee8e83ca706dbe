//! Claim: pictures by the default pair of methods are those of `Target::triangles`, bit for bit; those by any other
//! pair show the failure that is known of it, and nothing that is handed over makes one panic.
//!
//! Judge: the immediate path, and the rational depth plane ([`support::plane`]).
#![cfg(feature = "alloc")]

mod support;

use polosa_raster::reference::{Corner, Coverage, Hidden, Methods, ZBuffer, draw, draw_screen};
use polosa_raster::{
    Clip, Cull, Depth, DepthTest, PerTriangle, Rect, Sample, Space, State, Stats, StoredDepth, Target,
};
use proptest::prelude::*;
use support::rng::Rng;

const WIDTH: u32 = 61;
const HEIGHT: u32 = 47;
const COUNT: usize = (WIDTH * HEIGHT) as usize;

/// Colours, depths and counts by a pair of methods.
fn by(methods: Methods, state: &State, v: &[Clip], t: &[[u32; 3]]) -> (Vec<u32>, ZBuffer, Stats) {
    let mut color = vec![0; COUNT];
    let mut depth = ZBuffer::new();
    let mut target = Target::new(&mut color, Depth::None, WIDTH, HEIGHT, WIDTH as usize).unwrap();
    let stats = draw(&mut target, &mut depth, methods, state, v, t, |k| k + 1);
    (color, depth, stats)
}

/// Colours by a way to hide, of corners in pixels filled by exact strips.
fn hidden(hidden: Hidden, t: &[[Corner; 3]]) -> (Vec<u32>, ZBuffer) {
    let methods = Methods { coverage: Coverage::Strips, hidden };
    let mut color = vec![0; COUNT];
    let mut depth = ZBuffer::new();
    let mut target = Target::new(&mut color, Depth::None, WIDTH, HEIGHT, WIDTH as usize).unwrap();
    draw_screen(&mut target, &mut depth, methods, &State::default(), t, |k| k + 1);
    (color, depth)
}

fn count(color: &[u32], value: u32) -> usize {
    color.iter().filter(|&&c| c == value).count()
}

/// Compares with the immediate path: colours, the bits of depth, counts.
fn check_default(state: &State, v: &[Clip], t: &[[u32; 3]]) -> Result<(), TestCaseError> {
    let (mut color, mut depth) = (vec![0; COUNT], vec![0.0; COUNT]);
    let mut target = Target::new(&mut color, Depth::F32(&mut depth), WIDTH, HEIGHT, WIDTH as usize).unwrap();
    target.clear(0, state.test);
    let stats = target.triangles(state, v, t, &PerTriangle(|k| u32::try_from(k).unwrap() + 1));
    for coverage in [Coverage::Strips, Coverage::Edges] {
        let (ours, buffer, counts) = by(Methods { coverage, hidden: Hidden::Exact }, state, v, t);
        prop_assert_eq!(counts, stats, "{}", coverage);
        prop_assert!(ours == color, "{}", coverage);
        for (k, &z) in (0..).zip(&depth) {
            let stored = buffer.at(k % WIDTH, k / WIDTH).unwrap();
            prop_assert_eq!(stored.to_bits(), f64::from(z).to_bits(), "{} at {}", coverage, k);
        }
    }
    Ok(())
}

fn any_state(r: &mut Rng) -> State {
    let scissor = Rect { x0: 3, y0: 5, x1: 40 + r.index(40) as u32, y1: 30 + r.index(40) as u32 };
    State {
        space: Space::Clip,
        cull: [Cull::None, Cull::Front, Cull::Back][r.index(3)],
        test: [DepthTest::Greater, DepthTest::Less, DepthTest::Off][r.index(3)],
        write: r.index(4) != 0,
        scissor: (r.index(3) == 0).then_some(scissor),
        sample: if r.index(2) == 0 {
            Sample::CENTER
        } else {
            Sample { x: r.index(256) as u8, y: r.index(256) as u8 }
        },
    }
}

#[test]
fn the_default_pair_is_the_immediate_path_bit_for_bit() {
    let mut r = Rng::new(1);
    let mut clipped = 0;
    for _ in 0..400 {
        let state = any_state(&mut r);
        // Half of them around the eye, cut by the near plane, the far one and the guard band.
        let wild = r.index(2) == 0;
        let v: Vec<Clip> = (0..40)
            .map(|_| {
                let w = if wild { r.real(-0.5, 2.0) } else { r.real(0.2, 4.0) };
                let spread = if wild && r.index(4) == 0 { 5_000.0 } else { 1.5 };
                let z = if wild { r.real(-0.3, 1.2) } else { r.real(0.0, w) };
                [r.real(-spread, spread) * w, r.real(-spread, spread) * w, z, w].map(|v| v as f32)
            })
            .collect();
        // One index in forty is no vertex.
        let t: Vec<_> = (0..30).map(|_| [(); 3].map(|()| r.index(41) as u32)).collect();
        check_default(&state, &v, &t).unwrap();
        clipped += by(Methods::default(), &state, &v, &t).2.clipped;
    }
    assert!(clipped > 1_000, "{clipped}");
}

/// Any bit pattern, and ordinary numbers.
fn number() -> impl Strategy<Value = f32> {
    prop_oneof![
        1 => any::<u32>().prop_map(f32::from_bits),
        1 => (-40..60_i32, -1.0..1.0_f32).prop_map(|(e, m)| m * 2_f32.powi(e)),
        3 => -2.0..2.0_f32,
    ]
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 1_500, failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn the_default_pair_takes_any_vertices_as_the_immediate_path_does(
        v in prop::collection::vec(prop::array::uniform4(number()), 3..9),
        t in prop::collection::vec(prop::array::uniform3(0..10_u32), 1..8),
        seed: u64,
        on_screen: bool,
    ) {
        let space = if on_screen { Space::Screen } else { Space::Clip };
        check_default(&State { space, ..any_state(&mut Rng::new(seed)) }, &v, &t)?;
    }

    #[test]
    fn no_pair_of_methods_panics_on_any_corners(
        t in prop::collection::vec(
            prop::array::uniform3(prop::array::uniform3(prop_oneof![
                1 => any::<u64>().prop_map(f64::from_bits),
                3 => -20.0..80.0_f64,
                1 => prop::sample::select(vec![f64::NAN, f64::INFINITY, f64::MIN, 0.5, 32_768.0, 1e38]),
            ])),
            1..4,
        ),
        seed: u64,
    ) {
        let state = any_state(&mut Rng::new(seed));
        for &coverage in Coverage::ALL {
            for &hidden in Hidden::ALL {
                let mut color = [0_u32; 24 * 16];
                let mut buffer = ZBuffer::new();
                // A band of a picture whose rows are farther apart than they are wide.
                let mut target = Target::band(&mut color, Depth::None, [20, 40], 24, 8..20).unwrap();
                let methods = Methods { coverage, hidden };
                let stats = draw_screen(&mut target, &mut buffer, methods, &state, &t, |_| 1);
                prop_assert_eq!(stats.submitted, t.len() as u64);
                prop_assert_eq!(
                    stats.submitted,
                    stats.not_finite + stats.outside + stats.degenerate + stats.culled + stats.drawn
                );
                prop_assert!(color.chunks(24).all(|row| row[20..].iter().all(|&c| c == 0)));
                prop_assert_eq!(buffer.at(0, 8).is_some(), hidden.has_buffer());
                prop_assert_eq!(buffer.at(0, 7), None);
            }
        }
    }
}

/// Two triangles that cross: one falls from depth 10 to 0, the other lies at 3. Each is nearer on its own part.
#[test]
fn crossing_triangles_need_a_depth_a_pixel() {
    let falling = [[2.0, 2.0, 10.0], [58.0, 4.0, 0.0], [6.0, 44.0, 0.0]];
    let level = falling.map(|[x, y, _]| [x, y, 3.0]);
    for triangles in [[falling, level], [level, falling]] {
        let (right, _) = hidden(Hidden::Exact, &triangles);
        let falling = if triangles[0] == falling { 1 } else { 2 };
        // Nearer where the first weight is over 0.3: a part of 0.7² of the area.
        let all = COUNT - count(&right, 0);
        let part = count(&right, falling) as f64 / all as f64;
        assert!((part - 0.49).abs() < 0.01, "{part}");
        for &method in Hidden::ALL {
            let (color, _) = hidden(method, &triangles);
            let wrong = color.iter().zip(&right).filter(|(a, b)| a != b).count();
            match method {
                Hidden::Exact | Hidden::Barycentric | Hidden::StripLinear | Hidden::PlaneF64 => {
                    assert_eq!(wrong, 0, "{method}");
                }
                Hidden::PlaneF32Origin | Hidden::PlaneF32Vertex => assert!(wrong < 3, "{method}: {wrong}"),
                // 10 against 9, or the mean of 3⅓ against 3: the falling one is nearer everywhere.
                Hidden::Sum | Hidden::Painter => assert_eq!(wrong, count(&right, 3 - falling), "{method}"),
                Hidden::Order => assert_eq!(wrong, count(&right, 1), "{method}"),
                _ => assert!(wrong > all / 5, "{method}: {wrong}"),
            }
        }
    }
}

#[test]
fn parallel_planes_tie_as_strips_are_printed() {
    let plane = |z| [[2.5, 2.0, z], [58.0, 4.0, z], [6.0, 44.0, z]];
    let (printed, buffer) = hidden(Hidden::StripPrinted, &[plane(5.0), plane(9.0)]);
    assert_eq!(count(&printed, 2), 0, "the nearer one comes second, and is never nearer than zero");
    assert_eq!(buffer.at(20, 15), Some(0.0));
    let (meant, buffer) = hidden(Hidden::StripLinear, &[plane(5.0), plane(9.0)]);
    assert_eq!((count(&meant, 1), buffer.at(20, 15)), (0, Some(9.0)));
}

/// Three triangles, each over the next and under the one before: no order of drawing is right.
#[test]
fn the_painter_fails_at_a_ring() {
    let blade = |k: usize| {
        let turn = |[x, y]: [f64; 2]| match k {
            0 => [x, y],
            1 => [-0.5 * x - 0.866 * y, 0.866 * x - 0.5 * y],
            _ => [-0.5 * x + 0.866 * y, -0.866 * x - 0.5 * y],
        };
        [([-20.0, -8.0], 0.2), ([20.0, -14.0], 0.8), ([20.0, -2.0], 0.8)].map(|(p, z)| {
            let [x, y] = turn(p);
            [x + 30.0, y + 23.0, z]
        })
    };
    let ring = [blade(0), blade(1), blade(2)];
    let (right, _) = hidden(Hidden::Exact, &ring);
    for order in [[0, 1, 2], [0, 2, 1], [1, 0, 2], [1, 2, 0], [2, 0, 1], [2, 1, 0]] {
        let (painted, _) = hidden(Hidden::Painter, &order.map(|k| ring[k]));
        let wrong =
            painted.iter().zip(&right).filter(|(p, r)| **p != 0 && order[**p as usize - 1] as u32 + 1 != **r);
        assert!(wrong.count() > 10, "{order:?}");
    }
    // Whatever the order, depth at each pixel gives one picture.
    let (turned, _) = hidden(Hidden::Exact, &[ring[2], ring[0], ring[1]]);
    assert!(turned.iter().zip(&right).all(|(t, r)| *t == [0, 2, 3, 1][*r as usize]));
}

/// The largest distance of stored depths from the rational plane, in units of 2⁻²⁴ of depth 1; NaN if one is NaN.
fn units(method: Hidden, size: [u32; 2], t: &[[i64; 2]; 3], z: [f32; 3]) -> f64 {
    let corners = [0, 1, 2].map(|k| [t[k][0] as f64 / 256.0, t[k][1] as f64 / 256.0, z[k].into()]);
    let mut color = vec![0_u8; (size[0] * size[1]) as usize];
    let mut target = Target::new(&mut color, Depth::None, size[0], size[1], size[0] as usize).unwrap();
    let mut buffer = ZBuffer::new();
    let methods = Methods { coverage: Coverage::Strips, hidden: method };
    draw_screen(&mut target, &mut buffer, methods, &State::default(), &[corners], |_| 1);
    let mut most = 0.0_f64;
    for (k, _) in (0..).zip(&color).filter(|(_, c)| **c != 0) {
        let (x, y) = (k % size[0], k / size[0]);
        let n = support::plane::numerators(t, x.into(), y.into(), [128; 2]);
        let area: i128 = n.iter().sum();
        // Below 2⁵⁰ each: the quotients are right to 2⁻⁵⁰.
        let exact: f64 = (0..3).map(|k| n[k] as f64 / area as f64 * f64::from(z[k])).sum();
        most = most.max((buffer.at(x, y).unwrap() - exact).abs() * 2_f64.powi(24));
    }
    most
}

#[test]
fn planes_lose_digits_where_exact_edges_do_not() {
    // Two pixels wide at (4000, 2000).
    let far =
        [[4000 * 256, 2000 * 256], [4002 * 256 + 50, 2000 * 256 + 30], [4000 * 256 + 20, 2002 * 256 + 77]];
    let error = |method| units(method, [4010, 2010], &far, [0.9, 0.2, 0.4]);
    assert!(error(Hidden::Exact) < 5.0 && error(Hidden::PlaneF64) < 1.0 && error(Hidden::Barycentric) < 1.0);
    assert!(error(Hidden::PlaneF32Origin) > 1_000.0, "{}", error(Hidden::PlaneF32Origin));
    assert!(error(Hidden::PlaneF32Vertex) < 100.0, "{}", error(Hidden::PlaneF32Vertex));

    let mut r = Rng::new(3);
    let slivers: Vec<_> = (0..400).map(|_| support::classes::triangle("sliver", &mut r, 400, 300)).collect();
    let error =
        |method| slivers.iter().map(|t| units(method, [400, 300], t, [0.9, 0.2, 0.4])).fold(0.0, f64::max);
    assert!(error(Hidden::Exact) < 5.0, "{}", error(Hidden::Exact));
    for method in [Hidden::PlaneF64, Hidden::Barycentric, Hidden::StripLinear] {
        assert!(error(method) < 1.0, "{method}: {}", error(method));
    }
    assert!(error(Hidden::PlaneF32Vertex) > 1e4, "{}", error(Hidden::PlaneF32Vertex));
    assert!(error(Hidden::PlaneF32Origin) > 1e4, "{}", error(Hidden::PlaneF32Origin));
}

/// S0's pair shares its weights between coverage and depth; the depths are those of the same formula on its own.
#[test]
fn the_first_seeds_pair_gives_the_depths_of_its_formula() {
    let t = [
        [[2.3, 2.1, 0.9], [58.7, 4.4, 0.1], [6.2, 44.9, 0.4]],
        [[40.0, 1.0, 0.2], [60.0, 40.0, 0.7], [1.0, 30.0, 0.6]],
    ];
    let drawn = |coverage| {
        let mut color = vec![0; COUNT];
        let mut buffer = ZBuffer::new();
        let mut target = Target::new(&mut color, Depth::None, WIDTH, HEIGHT, WIDTH as usize).unwrap();
        let methods = Methods { coverage, hidden: Hidden::Barycentric };
        draw_screen(&mut target, &mut buffer, methods, &State::default(), &t, |k| k + 1);
        let depths: Vec<_> =
            (0..COUNT as u32).map(|k| buffer.at(k % WIDTH, k / WIDTH).unwrap().to_bits()).collect();
        (color, depths)
    };
    assert_eq!(drawn(Coverage::Barycentric), drawn(Coverage::SameSide));
}

/// S4's pair likewise: its strip's ends are those that it would find by itself.
#[test]
fn the_strips_own_depth_is_that_of_the_strip_through_the_pixel() {
    let t = [[2.3, 2.1, 0.9], [58.7, 4.4, 0.1], [6.2, 44.9, 0.4]];
    let depths = |coverage| {
        let mut color = vec![0; COUNT];
        let mut buffer = ZBuffer::new();
        let mut target = Target::new(&mut color, Depth::None, WIDTH, HEIGHT, WIDTH as usize).unwrap();
        let methods = Methods { coverage, hidden: Hidden::StripLinear };
        draw_screen(&mut target, &mut buffer, methods, &State::default(), &[t], |k| k + 1);
        (0..COUNT as u32).map(|k| buffer.at(k % WIDTH, k / WIDTH).unwrap().to_bits()).collect::<Vec<_>>()
    };
    assert_eq!(depths(Coverage::VerticalStrips), depths(Coverage::SameSide));
}

/// A picture of the scene's own depth must not be disturbed.
#[test]
fn the_targets_own_depth_is_left_alone() {
    let (mut color, mut depth) = ([0_u32; 64], [0.25; 64]);
    let mut target = Target::new(&mut color, Depth::F32(&mut depth), 8, 8, 8).unwrap();
    let t = [[-9.0, -9.0, 0.1], [30.0, -9.0, 0.1], [-9.0, 30.0, 0.1]];
    draw_screen(&mut target, &mut ZBuffer::new(), Methods::default(), &State::default(), &[t], |_| 7);
    assert_eq!(target.color_at(3, 3), Some(7));
    assert_eq!(target.depth_at(3, 3), Some(StoredDepth::F32(0.25)));
}
