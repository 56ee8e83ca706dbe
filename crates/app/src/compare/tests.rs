//! The figures on pictures that are small enough for the hand.

use polosa_scene::Color;
use proptest::prelude::*;

use super::super::{Background, CompareError, Comparison, Image, Pixels, Settings};
use super::compare;

const BLACK: [u8; 4] = [0, 0, 0, 255];

fn bytes(pixels: &[[u8; 4]], width: u32) -> Image<'_> {
    Image::new(width, pixels.len() as u32 / width, Pixels::Rgba8(pixels)).unwrap()
}

fn settings(threshold: f64, allowed_pixels: u64) -> Settings {
    Settings { threshold, allowed_pixels, ..Settings::default() }
}

fn figures(a: &[[u8; 4]], b: &[[u8; 4]], width: u32) -> Comparison {
    compare(&bytes(a, width), &bytes(b, width), &Settings::default()).unwrap()
}

#[test]
fn every_figure_of_a_small_pair() {
    let a = [BLACK, [100, 150, 200, 255], BLACK, [1, 2, 3, 255]];
    let b = [BLACK, [103, 150, 190, 255], BLACK, [1, 4, 3, 255]];
    let found = figures(&a, &b, 2);
    assert_eq!((found.width, found.height, found.pixels()), (2, 2, 4));
    assert_eq!(found.largest_code, Some(255));
    assert_eq!((found.differing, found.beyond, found.same), (2, 2, false));
    assert_eq!((found.max_difference, found.max_at), (10.0, Some([1, 0])));
    assert_eq!(found.mean_difference, (3.0 + 10.0 + 2.0) / 12.0);
    // 10·log₁₀(255² · 12 / (9 + 100 + 4)) = 10·log₁₀(6905.309…)
    assert!((found.psnr_db.unwrap() - 38.391_831).abs() < 1e-5, "{found:?}");
    assert_eq!(found.silhouette_px, Some(0.0));
}

#[test]
fn the_same_picture_has_no_difference_and_no_ratio() {
    let a = [BLACK, [9, 9, 9, 255]];
    let found = figures(&a, &a, 2);
    assert!(found.same);
    assert_eq!((found.differing, found.max_difference, found.mean_difference), (0, 0.0, 0.0));
    assert_eq!((found.max_at, found.psnr_db), (None, None));
}

#[test]
fn a_threshold_lets_codes_pass_and_a_number_lets_pixels_pass() {
    let (a, b) = ([BLACK; 4], [BLACK, [2, 0, 0, 255], [0, 3, 0, 255], [0, 0, 0, 251]]);
    for (threshold, allowed, beyond, same) in [
        (0.0, 0, 3, false),
        (2.0, 0, 2, false),
        (2.9, 0, 2, false),
        (3.0, 0, 1, false),
        (4.0, 0, 0, true),
        (3.0, 1, 1, true),
        (0.0, 2, 3, false),
        (0.0, 3, 3, true),
        (f64::NAN, 0, 3, false),
    ] {
        let found = compare(&bytes(&a, 4), &bytes(&b, 4), &settings(threshold, allowed)).unwrap();
        assert_eq!((found.beyond, found.same), (beyond, same), "{threshold} {allowed}");
        assert_eq!(
            (found.differing, found.max_difference),
            (3, 4.0),
            "what differs at all is another figure"
        );
    }
}

#[test]
fn alpha_is_a_channel_as_soon_as_a_pixel_is_not_opaque() {
    let (opaque, clear) = ([[0, 0, 0, 255]; 2], [[0, 0, 0, 255], [0, 0, 0, 0]]);
    let found = figures(&opaque, &clear, 2);
    assert_eq!((found.differing, found.max_difference), (1, 255.0));
    assert_eq!(found.mean_difference, 255.0 / 8.0);
    assert_eq!(found.psnr_db, Some(10.0 * libm::log10(8.0)));
    // Codes that nobody sees differ all the same.
    let hidden = [[0, 0, 0, 255], [50, 0, 0, 0]];
    assert_eq!(figures(&clear, &hidden, 2).max_difference, 50.0);
    assert_eq!(figures(&clear, &hidden, 2).mean_difference, 50.0 / 8.0);
}

#[test]
fn eight_bits_beside_sixteen_are_widened_without_a_difference() {
    let (narrow, wide) = ([[1, 128, 255, 255]], [[257, 128 * 257, 65_535, 65_535]]);
    let wide = Image::new(1, 1, Pixels::Rgba16(&wide)).unwrap();
    let found = compare(&bytes(&narrow, 1), &wide, &Settings::default()).unwrap();
    assert_eq!((found.same, found.largest_code), (true, Some(65_535)));
    let next = [[258, 128 * 257, 65_535, 65_535]];
    let next = Image::new(1, 1, Pixels::Rgba16(&next)).unwrap();
    let found = compare(&wide, &next, &Settings::default()).unwrap();
    assert_eq!((found.max_difference, found.mean_difference), (1.0, 1.0 / 3.0));
    let peak: f64 = 65_535.0;
    assert_eq!(found.psnr_db, Some(10.0 * libm::log10(peak * peak * 3.0)));
}

#[test]
fn the_largest_possible_sums_fit() {
    let (a, b) = (vec![[0_u16; 4]; 1 << 16], vec![[65_535_u16; 4]; 1 << 16]);
    let [a, b] = [&a, &b].map(|pixels| Image::new(256, 256, Pixels::Rgba16(pixels)).unwrap());
    let found = compare(&a, &b, &Settings::default()).unwrap();
    assert_eq!((found.mean_difference, found.psnr_db), (65_535.0, Some(0.0)));
}

#[test]
fn distances_have_figures_in_their_own_unit() {
    let inf = f32::INFINITY;
    let images =
        |a, b| [a, b].map(|values: &'static [f32; 4]| Image::new(2, 2, Pixels::Distances(values)).unwrap());
    let [a, b] = images(&[1.0, 2.0, f32::INFINITY, f32::NAN], &[1.0, 2.5, f32::INFINITY, f32::NAN]);
    let found = compare(&a, &b, &settings(0.5, 0)).unwrap();
    assert_eq!((found.same, found.differing, found.beyond), (true, 1, 0));
    assert_eq!((found.max_difference, found.max_at, found.mean_difference), (0.5, Some([1, 0]), 0.125));
    assert_eq!((found.largest_code, found.psnr_db, found.silhouette_px), (None, None, Some(0.0)));
    let nothing = [inf; 4];
    let nothing = Image::new(2, 2, Pixels::Distances(&nothing)).unwrap();
    let found = compare(&a, &nothing, &settings(1e9, 2)).unwrap();
    assert_eq!((found.differing, found.beyond, found.same), (3, 3, false));
    assert_eq!((found.max_difference, found.max_at), (f64::INFINITY, Some([0, 0])));
    assert_eq!((found.mean_difference, found.silhouette_px), (f64::INFINITY, None));
}

/// A dot of a colour at a place on a background, 5 pixels wide and 4 high.
fn dot(background: [u8; 4], at: usize, color: [u8; 4]) -> [[u8; 4]; 20] {
    let mut pixels = [background; 20];
    pixels[at] = color;
    pixels
}

#[test]
fn the_background_is_the_first_corners_unless_it_is_named() {
    let red = [255, 0, 0, 255];
    let silhouettes = |a: &[[u8; 4]], b: &[[u8; 4]], background, threshold| {
        let settings = Settings { background, threshold, ..Settings::default() };
        compare(&bytes(a, 5), &bytes(b, 5), &settings).unwrap().silhouette_px
    };
    let corner = Background::Corner;
    // From (1, 0) to (4, 0), then to (4, 3).
    assert_eq!(silhouettes(&dot(BLACK, 1, red), &dot(BLACK, 4, red), corner, 0.0), Some(3.0));
    assert_eq!(silhouettes(&dot(BLACK, 1, red), &dot(BLACK, 19, red), corner, 0.0), Some(18.0_f64.sqrt()));
    // Another background behind the same dot: everything shows something, and has no outline.
    let grey = [50, 50, 50, 255];
    assert_eq!(silhouettes(&dot(BLACK, 7, red), &dot(grey, 7, red), corner, 0.0), None);
    // Something in the first picture's corner.
    let (a, b) = (dot(BLACK, 0, red), dot(BLACK, 2, red));
    assert_eq!(silhouettes(&a, &b, Background::Color(Color::BLACK), 0.0), Some(2.0));
    // A transparent corner stands for all that is transparent, whatever its codes.
    let mut noisy = dot([0, 0, 0, 0], 9, red);
    noisy[3] = [7, 7, 7, 0];
    let clear = dot([0, 0, 0, 0], 9, red);
    assert_eq!(silhouettes(&clear, &noisy, corner, 0.0), Some(0.0));
    assert_eq!(silhouettes(&noisy, &clear, Background::Transparent, 0.0), Some(0.0));
    assert_eq!(silhouettes(&clear, &dot(BLACK, 9, red), Background::Color(Color::BLACK), 0.0), None);
    // What the threshold lets pass is background, too.
    let mut speckled = dot(BLACK, 9, red);
    speckled[15] = [2, 0, 1, 255];
    assert_eq!(silhouettes(&dot(BLACK, 9, red), &speckled, corner, 1.0), Some(20.0_f64.sqrt()));
    assert_eq!(silhouettes(&dot(BLACK, 9, red), &speckled, corner, 2.0), Some(0.0));
}

#[test]
fn pictures_of_other_sizes_and_kinds_are_not_compared() {
    let pixels = [BLACK; 4];
    let [a, b] = [bytes(&pixels, 4), bytes(&pixels, 2)];
    let error = compare(&a, &b, &Settings::default()).unwrap_err();
    assert_eq!(error, CompareError::Sizes { a: [4, 1], b: [2, 2] });
    assert_eq!(error.to_string(), "4×1 and 2×2 pixels: only pictures of one size are compared");
    let values = [0.0; 4];
    let distances = Image::new(4, 1, Pixels::Distances(&values)).unwrap();
    assert_eq!(compare(&a, &distances, &Settings::default()), Err(CompareError::Kinds));
    assert_eq!(compare(&distances, &a, &Settings::default()), Err(CompareError::Kinds));
}

fn pairs() -> impl Strategy<Value = (u32, Vec<[u8; 4]>, Vec<[u8; 4]>)> {
    (1..9_u32, 1..9_u32).prop_flat_map(|(width, height)| {
        // Few codes, so that pixels are often equal.
        let pixel = || [0..=2_u8, 0..=2_u8, 0..=2_u8, 253..=255_u8];
        let pixels = || proptest::collection::vec(pixel(), (width * height) as usize);
        (Just(width), pixels(), pixels())
    })
}

proptest! {
    #[test]
    fn a_and_b_may_change_places_and_storage_but_for_the_corner((width, a, b) in pairs()) {
        let settings = Settings { background: Background::Color(Color::BLACK), ..Settings::default() };
        let [one, other] = [bytes(&a, width), bytes(&b, width)];
        let found = compare(&one, &other, &settings).unwrap();
        prop_assert_eq!(found, compare(&other, &one, &settings).unwrap());
        prop_assert_eq!(found.same, a == b);
        prop_assert_eq!(found.differing, a.iter().zip(&b).filter(|(a, b)| a != b).count() as u64);
        let words: Vec<u32> = a.iter().map(|p| u32::from_be_bytes([0, p[0], p[1], p[2]])).collect();
        let alpha: Vec<u8> = a.iter().map(|p| p[3]).collect();
        let stored = Pixels::Rgb { colors: &words, alpha: Some(&alpha) };
        let stored = Image::new(width, one.size()[1], stored).unwrap();
        prop_assert_eq!(found, compare(&stored, &other, &settings).unwrap());
    }
}
