//! Claim: left and top sides are in, right and bottom ones out. To be seen with the naked eye.
//!
//! Every picture's corners lie on pixel centres or corners, so that all sides meet ties.

mod support;

use polosa_raster::{Flat, PerTriangle};
use support::picture::{Picture, assert_rows, on_screen, px};

/// Draws triangles, given by three (x, y) in pixels, in the colours 1, 2, ….
#[track_caller]
fn draws(triangles: &[[[f32; 2]; 3]], expected: &[&str]) {
    let mut picture = Picture::new(expected[0].len(), expected.len());
    let v: Vec<_> = triangles.iter().flatten().map(|&[x, y]| px(x, y, 0.5)).collect();
    let index: Vec<[u32; 3]> = (0..triangles.len() as u32).map(|k| [3 * k, 3 * k + 1, 3 * k + 2]).collect();
    picture.target().triangles(&on_screen(), &v, &index, &PerTriangle(|k: usize| k as u32 + 1));
    assert_rows(&picture.rows(), expected);
}

#[test]
fn a_triangle_on_pixel_corners() {
    draws(
        &[[[1.0, 1.0], [7.0, 1.0], [1.0, 7.0]]],
        &[
            "........", //
            ".11111..", ".1111...", ".111....", ".11.....", ".1......", "........", "........",
        ],
    );
}

/// Its top and its left side run through pixel centres; the long side does as well, and is out.
#[test]
fn a_triangle_on_pixel_centres_has_its_top_and_left_sides() {
    draws(
        &[[[1.5, 1.5], [6.5, 1.5], [1.5, 6.5]]],
        &[
            "........", //
            ".11111..", ".1111...", ".111....", ".11.....", ".1......", "........", "........",
        ],
    );
}

#[test]
fn a_triangle_on_pixel_centres_lacks_its_bottom_and_right_sides() {
    draws(
        &[[[6.5, 1.5], [6.5, 6.5], [1.5, 6.5]]],
        &[
            "........", //
            "........", ".....1..", "....11..", "...111..", "..1111..", "........", "........",
        ],
    );
}

/// The long side is a left one for the second triangle, which gets the ties.
#[test]
fn two_triangles_share_a_diagonal_through_centres_without_gap_or_overlap() {
    draws(
        &[[[1.5, 1.5], [6.5, 1.5], [1.5, 6.5]], [[6.5, 1.5], [6.5, 6.5], [1.5, 6.5]]],
        &[
            "........", //
            ".11111..", ".11112..", ".11122..", ".11222..", ".12222..", "........", "........",
        ],
    );
}

#[test]
fn four_triangles_around_a_pixel_centre_share_it_out_once() {
    let [n, e, s, w, c] = [[4.5, 0.5], [8.5, 4.5], [4.5, 8.5], [0.5, 4.5], [4.5, 4.5]];
    draws(
        &[[c, n, e], [c, e, s], [c, s, w], [c, w, n]],
        &[
            ".........", //
            "...41....",
            "..4411...",
            ".444111..",
            "33332222.",
            ".333222..",
            "..3322...",
            "...32....",
            ".........",
        ],
    );
}

#[test]
fn a_sliver_between_centres_draws_nothing_and_one_through_them_does() {
    draws(&[[[0.0, 1.51], [9.0, 1.51], [9.0, 2.49]]], &["........."; 4]);
    // Its lower side reaches the centres' height, y = 1.5, at 9·(384 − 381)/(392 − 381) = 2.45.
    draws(&[[[0.0, 1.49], [9.0, 1.49], [9.0, 1.53]]], &[".........", "..1111111", ".........", "........."]);
}

#[test]
fn a_line_is_one_pixel_thick() {
    let mut picture = Picture::new(12, 6);
    let v = [px(1.5, 1.5, 0.5), px(10.5, 4.5, 0.5)];
    picture.target().lines(&on_screen(), &v, &[[0, 1]], 1);
    let expected =
        ["............", ".11.........", "...111......", "......111...", ".........1..", "............"];
    assert_rows(&picture.rows(), &expected);
}

/// Clip space has y up and its origin in the middle; depth 1 is near.
#[test]
fn clip_space_is_upright_and_the_nearer_triangle_wins() {
    let mut picture = Picture::new(12, 8);
    let far = [[-1.0, -1.0, 0.25, 1.0], [1.0, -1.0, 0.25, 1.0], [-1.0, 1.0, 0.25, 1.0]];
    let near = [[0.0, -1.0, 1.5, 2.0], [2.0, -1.0, 1.5, 2.0], [0.0, 2.0, 1.5, 2.0]];
    for (v, color) in [(near, 2), (far, 1)] {
        picture.target().triangles(&polosa_raster::State::default(), &v, &[[0, 1, 2]], &Flat(color));
    }
    let expected = [
        "1...........", //
        "11....2.....",
        "1111..22....",
        "11111.222...",
        "1111112222..",
        "11111122222.",
        "1111111111..",
        "11111111111.",
    ];
    assert_rows(&picture.rows(), &expected);
}
