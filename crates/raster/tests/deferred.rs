//! Claim: weights that are asked for afterwards, once it is known what is seen at a pixel, are to the last bit those
//! that a shader gets while drawing, whatever planes cut the triangle.

mod support;

use polosa_raster::{Clip, Cull, Deferred, Depth, DepthTest, Fragment, Sample, State, StoredDepth, Target};
use support::rng::Rng;

type Pixel = (usize, [u32; 3]);

fn corner(r: &mut Rng) -> Clip {
    let w = if r.index(4) == 0 { r.real(-1.0, 0.5) } else { r.real(0.1, 3.0) };
    let reach = [1.0, 1.0, 4.0, 400.0][r.index(4)];
    let z = if r.index(3) == 0 { r.real(-0.5, 2.0) } else { r.real(0.0, w.max(0.01)) };
    [r.real(-reach, reach), r.real(-reach, reach), z, w].map(|v| v as f32)
}

/// Draws triangles with weights for pixels; then asks for those of every pixel afterwards.
fn check(r: &mut Rng, size: [u32; 2], clear: StoredDepth, state: &State) -> usize {
    let vertices: Vec<Clip> = (0..60).map(|_| corner(r)).collect();
    let triangles: Vec<[u32; 3]> = (0..20).map(|k| [3 * k, 3 * k + 1, 3 * k + 2]).collect();
    let pixels = (size[0] * size[1]) as usize;
    let mut color: Vec<Pixel> = vec![(usize::MAX, [0; 3]); pixels];
    let (mut f32s, mut u16s) = (vec![0.0; pixels], vec![0; pixels]);
    let depth = match clear {
        StoredDepth::F32(_) => Depth::F32(&mut f32s),
        StoredDepth::U16(_) => Depth::U16(&mut u16s),
    };
    let mut target = Target::new(&mut color, depth, size[0], size[1], size[0] as usize).unwrap();
    target.clear((usize::MAX, [0; 3]), state.test);
    let shade = |fragment: &Fragment<'_>, pixel: &mut Pixel| {
        *pixel = (fragment.triangle(), fragment.weights().map(f32::to_bits));
        true
    };
    target.triangles(state, &vertices, &triangles, &shade);
    let mut deferred = Deferred::new(state, size);
    let mut seen = 0;
    for (x, y) in (0..size[1]).flat_map(|y| (0..size[0]).map(move |x| (x, y))) {
        let (triangle, weights) = target.color_at(x, y).unwrap();
        let Some(indices) = triangles.get(triangle) else { continue };
        assert!(deferred.prepare(indices.each_ref().map(|&k| &vertices[k as usize])));
        let got = deferred.weights(x, y, target.depth_at(x, y).unwrap()).unwrap();
        assert_eq!(got.map(f32::to_bits), weights, "triangle {triangle} at {x}, {y}");
        seen += 1;
    }
    seen
}

#[test]
fn weights_afterwards_are_those_while_drawing() {
    let mut r = Rng::new(0xDEFE4);
    let mut seen = 0;
    for round in 0..300 {
        let size = [1 + r.index(60) as u32, 1 + r.index(40) as u32];
        let (test, clear) = [
            (DepthTest::Greater, StoredDepth::F32(0.0)),
            (DepthTest::Greater, StoredDepth::U16(0)),
            (DepthTest::Less, StoredDepth::F32(0.0)),
        ][round % 3];
        let cull = [Cull::None, Cull::Back, Cull::Front][r.index(3)];
        let sample = [Sample::CENTER, Sample { x: r.index(256) as u8, y: r.index(256) as u8 }][r.index(2)];
        seen += check(&mut r, size, clear, &State { test, cull, sample, ..State::default() });
    }
    assert!(seen > 50_000, "{seen}");
}

#[test]
fn of_what_is_not_drawn_there_are_no_weights() {
    let (a, b, c) = ([-1.0, -1.0, 0.5, 1.0], [1.0, -1.0, 0.5, 1.0], [0.0, 1.0, 0.5, 1.0]);
    let mut deferred = Deferred::new(&State { cull: Cull::Back, ..State::default() }, [8, 8]);
    let depth = StoredDepth::F32(0.5);
    assert_eq!(deferred.weights(4, 4, depth), None, "nothing is prepared");
    assert!(deferred.prepare([&a, &b, &c]));
    assert!(deferred.weights(4, 4, depth).is_some());
    assert_eq!(deferred.weights(u32::MAX, 4, depth), None, "in no picture");
    assert!(!deferred.prepare([&a, &c, &b]), "a back face");
    assert!(!deferred.prepare([&a, &b, &[f32::NAN; 4]]));
    assert_eq!(deferred.weights(4, 4, depth), None);
}
