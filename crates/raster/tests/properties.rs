//! Claim: whatever is handed over, nothing panics, every triangle is counted once, and the picture is
//! the same however it is cut into bands.

mod support;

use polosa_raster::{Cull, Depth, DepthTest, Flat, Fragment, Rect, Sample, Space, State, Stats, Target};
use proptest::prelude::*;
use support::picture::Picture;

/// Any bit pattern, numbers of every magnitude, ordinary numbers, and the edges of what is allowed.
fn number() -> impl Strategy<Value = f32> {
    prop_oneof![
        2 => any::<u32>().prop_map(f32::from_bits),
        2 => (-40..40_i32, -1.0..1.0_f32).prop_map(|(e, m)| m * 2_f32.powi(e)),
        4 => -2.0..2.0_f32,
        2 => prop::sample::select(vec![
            0.0, -0.0, 1.0, -1.0, 0.5, f32::MIN_POSITIVE, f32::MAX, f32::MIN, f32::EPSILON, 16_384.0,
            32_767.0, 32_767.99, 32_768.0, -32_768.0, 1e20, -1e20, f32::INFINITY, f32::NAN,
        ]),
    ]
}

fn vertex() -> impl Strategy<Value = [f32; 4]> {
    let positive = prop_oneof![3 => 0.01..4.0_f32, 1 => number()];
    (number(), number(), prop_oneof![2 => 0.0..1.0_f32, 1 => number()], positive)
        .prop_map(|(x, y, z, w)| [x, y, z, w])
}

fn state() -> impl Strategy<Value = State> {
    let scissor = prop::option::weighted(
        0.2,
        [0..40_u32, 0..40, 0..40, 0..40].prop_map(|[x0, y0, x1, y1]| Rect { x0, y0, x1, y1 }),
    );
    let choices = (
        prop::sample::select(vec![Space::Clip, Space::Screen]),
        prop::sample::select(vec![Cull::None, Cull::Front, Cull::Back]),
        prop::sample::select(vec![DepthTest::Greater, DepthTest::Less, DepthTest::Off]),
    );
    (choices, any::<bool>(), scissor, any::<(u8, u8)>()).prop_map(
        |((space, cull, test), write, scissor, (x, y))| State {
            space,
            cull,
            test,
            write,
            scissor,
            sample: Sample { x, y },
        },
    )
}

fn counted_once(s: &Stats) -> bool {
    s.submitted == s.not_finite + s.bad_index + s.outside + s.culled + s.degenerate + s.drawn
        && s.clipped <= s.submitted
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 4_000, ..ProptestConfig::default() })]

    #[test]
    fn any_triangles_are_counted_once_and_drawn_the_same_in_bands(
        state in state(),
        v in prop::collection::vec(vertex(), 3..12),
        triangles in prop::collection::vec([0..13_u32, 0..13, 0..13], 0..12),
    ) {
        let draw = |target: &mut Target<'_, u32>| {
            target.clear(0, state.test);
            target.triangles(&state, &v, &triangles, &|f: &Fragment<'_>, p: &mut u32| {
                let sum: f32 = f.weights().iter().sum();
                assert!((sum - 1.0).abs() < 1e-6, "weights {:?}", f.weights());
                assert!((0.0..=1.0).contains(&f.depth()), "depth {}", f.depth());
                *p = 1 + f.triangle() as u32;
                true
            })
        };
        let mut whole = Picture::new(37, 29);
        let stats = draw(&mut whole.target());
        prop_assert!(counted_once(&stats), "{stats:?}");
        prop_assert_eq!(stats.submitted, triangles.len() as u64);
        if stats.drawn == 0 {
            prop_assert!(whole.painted().is_empty());
        }
        let mut banded = Picture::new(37, 29);
        for (k, (color, depth)) in banded.color.chunks_mut(37 * 10).zip(banded.depth.chunks_mut(37 * 10)).enumerate() {
            let rows = 10 * k as u32..(10 * k as u32 + 10).min(29);
            let mut band = Target::band(color, Depth::F32(depth), [37, 29], 37, rows).unwrap();
            prop_assert_eq!(draw(&mut band), stats);
        }
        prop_assert_eq!(banded, whole);
    }

    #[test]
    fn any_lines_and_outlines_are_counted_once(
        state in state(),
        v in prop::collection::vec(vertex(), 2..12),
        lines in prop::collection::vec([0..13_u32, 0..13], 0..12),
        faces in prop::collection::vec([0..13_u32, 0..13, 0..13], 0..12),
    ) {
        let mut picture = Picture::new(37, 29);
        picture.target().clear(0, state.test);
        picture.target().triangles(&state, &v, &faces, &Flat(1));
        let stats = picture.target().lines(&state, &v, &lines, 2);
        prop_assert!(counted_once(&stats), "{stats:?}");
        let again = picture.target().edges(&state, &v, &lines, |_| faces.iter().copied(), 3);
        prop_assert_eq!(again, stats);
    }

    #[test]
    fn a_triangle_never_paints_beyond_the_box_of_its_vertices(
        v in prop::collection::vec([-60.0..60.0_f32, -60.0..60.0_f32], 3),
    ) {
        let state = State { space: Space::Screen, ..State::default() };
        let corners: Vec<_> = v.iter().map(|&[x, y]| [x, y, 0.5, 1.0]).collect();
        let mut picture = Picture::new(50, 40);
        picture.target().triangles(&state, &corners, &[[0, 1, 2]], &Flat(1));
        let range = |k: usize| {
            let all = v.iter().map(|p| p[k]);
            (all.clone().fold(f32::MAX, f32::min) - 0.002, all.fold(f32::MIN, f32::max) + 0.002)
        };
        let (x_range, y_range) = (range(0), range(1));
        for (x, y) in picture.painted() {
            let (x, y) = (x as f32 + 0.5, y as f32 + 0.5);
            prop_assert!(x_range.0 <= x && x <= x_range.1 && y_range.0 <= y && y <= y_range.1, "({x}, {y}) of {v:?}");
        }
    }

    #[test]
    fn transform_is_the_documented_sum(
        m in prop::array::uniform4(prop::array::uniform4(-1e3..1e3_f32)),
        p in prop::array::uniform3(-1e3..1e3_f32),
    ) {
        let mut out = [[0.0; 4]; 1];
        polosa_raster::transform(&m, &[p], &mut out);
        for (k, &got) in out[0].iter().enumerate() {
            let [a, b, c] = [m[0][k] * p[0], m[1][k] * p[1], m[2][k] * p[2]];
            let ab = a + b;
            let abc = ab + c;
            prop_assert_eq!(got.to_bits(), (abc + m[3][k]).to_bits());
        }
    }
}
