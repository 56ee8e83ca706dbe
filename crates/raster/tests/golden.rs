//! Claim: the same input gives the same bytes on every machine, in every build.
//!
//! The hashes are of all colours and of all depths' bits. They change only with a definition: the snap,
//! the fill rule, the depth formula, the weights. Then say so where it is written down, and here.

mod support;

use polosa_raster::{Clip, DepthTest, Flat, Fragment, PerTriangle, Sample, State};
use support::classes::{CLASSES, triangle};
use support::picture::{Picture, on_screen, screen};
use support::rng::Rng;

#[track_caller]
fn has_hash(picture: &Picture, expected: u64) {
    assert_eq!(picture.hash(), expected, "{:#018X} is new", picture.hash());
}

#[test]
fn all_classes_of_triangles() {
    let mut r = Rng::new(0x0060_1DE4);
    let mut picture = Picture::new(160, 120);
    // Not the needle fans: their corners come from the platform's sine.
    let classes = CLASSES.map(|class| if class == "needle-fan" { "random" } else { class });
    for k in 0..600_usize {
        let t = triangle(classes[k % 10], &mut r, 160, 120);
        let v = t.map(|p| screen(p, r.unit() as f32));
        picture.target().triangles(&on_screen(), &v, &[[0, 1, 2]], &Flat(k as u32 + 1));
    }
    has_hash(&picture, 0x3F90_AA0C_2769_0192);
}

/// Vertices through the near plane, behind the eye and beyond the guard band. The numbers are made by
/// additions, multiplications and divisions alone.
fn cloud(r: &mut Rng, triangles: u32) -> (Vec<Clip>, Vec<[u32; 3]>) {
    let v = (0..3 * triangles).map(|k| {
        let reach = [1.5, 3.0, 4000.0][k as usize % 3];
        [r.real(-reach, reach) as f32, r.real(-reach, reach) as f32, 0.1, r.real(-0.5, 3.0) as f32]
    });
    (v.collect(), (0..triangles).map(|k| [3 * k, 3 * k + 1, 3 * k + 2]).collect())
}

#[test]
fn clipped_triangles() {
    let (v, triangles) = cloud(&mut Rng::new(1), 60);
    let mut picture = Picture::new(160, 120);
    picture.target().triangles(&State::default(), &v, &triangles, &PerTriangle(|k: usize| k as u32 + 1));
    has_hash(&picture, 0xAC94_D81C_3CB2_273E);
}

#[test]
fn weights_as_colours() {
    let (v, triangles) = cloud(&mut Rng::new(2), 40);
    let mut picture = Picture::cleared(160, 120, DepthTest::Less);
    let state = State { sample: Sample { x: 32, y: 224 }, test: DepthTest::Less, ..State::default() };
    picture.target().triangles(&state, &v, &triangles, &|f: &Fragment<'_>, p: &mut u32| {
        let [a, b, c] = f.weights();
        *p = a.to_bits() ^ b.to_bits().rotate_left(11) ^ c.to_bits().rotate_left(22);
        f.x() % 5 != 0
    });
    has_hash(&picture, 0xA363_7DBC_08D2_CFEF);
}

#[test]
fn lines_and_outlines() {
    let (v, triangles) = cloud(&mut Rng::new(3), 30);
    let mut picture = Picture::new(160, 120);
    picture.target().triangles(&State::default(), &v, &triangles, &Flat(1));
    let edges: Vec<[u32; 2]> = triangles.iter().flat_map(|&[a, b, c]| [[a, b], [b, c], [c, a]]).collect();
    picture.target().edges(&State::default(), &v, &edges, |k| [triangles[k / 3]], 2);
    picture.target().lines(&State::default(), &v, &[[0, 5], [9, 2], [30, 70]], 3);
    has_hash(&picture, 0xC744_8524_B209_E359);
}
