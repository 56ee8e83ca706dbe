//! Ways of shading against codes rounded correctly in whole numbers, each error asserted as that of the way that has
//! it.

mod support;

use std::sync::LazyLock;

use polosa_scene::reference::Shading;
use polosa_scene::{Color, srgb};
use proptest::prelude::*;
use support::shade;

/// Code, thousandths of light, the nearest code, and whether the next lower one is as near.
type Shade = (u8, u16, u8, bool);

/// All 256 codes at 1,001 amounts of light.
static ALL: LazyLock<Vec<Shade>> = LazyLock::new(|| {
    let of = |code| {
        let shades = shade::all(code).into_iter().zip(0..);
        shades.map(move |((nearest, tie), thousandths)| (code, thousandths, nearest, tie))
    };
    (0..=255).flat_map(of).collect()
});

fn all() -> impl Iterator<Item = Shade> {
    ALL.iter().copied()
}

/// What is wrong with a way of shading, in codes against the nearest one.
#[derive(Debug, Default, PartialEq)]
struct Errors {
    wrong: u32,
    /// The largest error, and the first code and thousandths of light that have it.
    most: i16,
    at: (u8, u16),
    sum: i64,
}

fn errors(shading: Shading) -> Errors {
    let mut errors = Errors::default();
    for (code, thousandths, nearest, tie) in all() {
        let shaded = shading.shade(code, f32::from(thousandths) / 1000.0);
        if shaded == nearest || (tie && shaded + 1 == nearest) {
            continue;
        }
        let error = i16::from(shaded) - i16::from(nearest);
        errors.wrong += 1;
        errors.sum += i64::from(error.abs());
        if error.abs() > errors.most.abs() {
            (errors.most, errors.at) = (error, (code, thousandths));
        }
    }
    errors
}

/// The largest difference from the unrounded value, in codes: ½ is the least that whole codes allow.
fn off(shading: Shading) -> f64 {
    let decode = |c: f64| if c <= 0.04045 { c / 12.92 } else { ((c + 0.055) / 1.055).powf(2.4) };
    let encode = |x: f64| if x <= 0.003_130_8 { 12.92 * x } else { 1.055 * x.powf(1.0 / 2.4) - 0.055 };
    let off = all().map(|(code, thousandths, ..)| {
        let light = decode(f64::from(code) / 255.0) * f64::from(thousandths) / 1000.0;
        (f64::from(shading.shade(code, f32::from(thousandths) / 1000.0)) - 255.0 * encode(light)).abs()
    });
    off.fold(0.0, f64::max)
}

#[test]
fn the_judge_knows_what_is_known() {
    assert_eq!(ALL.len(), 256 * 1001);
    let at = |code: usize, thousandths: usize| ALL[code * 1001 + thousandths];
    assert!((0..=255_u8).all(|code| at(code.into(), 1000).2 == code && at(code.into(), 0).2 == 0));
    assert_eq!(at(255, 500).2, 188, "half the light of white");
    assert_eq!(at(255, 216).2, 128);
    assert_eq!(at(1, 500), (1, 500, 1, true), "in the straight part of the curve codes can be equally near");
    assert_eq!(all().filter(|shade| shade.3).count(), 27);
}

#[test]
fn scene_19_exact_shading_is_never_a_code_off() {
    assert_eq!(Shading::default(), Shading::Exact);
    assert_eq!(errors(Shading::Exact), Errors::default());
    let off = off(Shading::Exact);
    assert!(off <= 0.5 + 1e-12, "{off}");
}

#[test]
fn naive_shading_is_74_codes_too_dark() {
    let expected = Errors { wrong: 246_713, most: -74, at: (253, 233), sum: 5_858_524 };
    assert_eq!(errors(Shading::Naive), expected, "22.9 in the mean");
}

#[test]
fn the_power_2_4_is_13_codes_off_and_2_2_is_9() {
    let expected = Errors { wrong: 217_614, most: 13, at: (210, 4), sum: 874_439 };
    assert_eq!(errors(Shading::Power24), expected, "3.4 in the mean");
    let expected = Errors { wrong: 185_608, most: 9, at: (97, 19), sum: 411_268 };
    assert_eq!(errors(Shading::Power22), expected, "1.6 in the mean");
}

#[test]
fn tables_are_one_code_off_more_rarely_the_larger_they_are() {
    let expected = Errors { wrong: 15_488, most: 1, at: (1, 403), sum: 15_488 };
    assert_eq!(errors(Shading::Table4096), expected);
    let expected = Errors { wrong: 924, most: 1, at: (1, 478), sum: 924 };
    assert_eq!(errors(Shading::Table65536), expected);
    let [small, large] = [off(Shading::Table4096), off(Shading::Table65536)];
    assert!((0.843..0.845).contains(&small) && (0.523..0.524).contains(&large), "{small} {large}");
}

#[test]
fn full_light_changes_no_code_and_none_leaves_black() {
    for &shading in Shading::ALL {
        for code in 0..=255 {
            assert_eq!(shading.shade(code, 1.0), code, "{shading}");
            for (light, shaded) in
                [(0.0, 0), (-0.0, 0), (-1.0, 0), (f32::NAN, 0), (2.0, code), (f32::INFINITY, code)]
            {
                assert_eq!(shading.shade(code, light), shaded, "{shading} {code} {light}");
            }
        }
    }
}

#[test]
fn names_go_there_and_back_and_another_is_told_all_of_them() {
    for &shading in Shading::ALL {
        assert_eq!(shading.name().parse(), Ok(shading));
        assert_eq!(shading.to_string(), shading.name());
        assert!(!shading.about().contains('\n') && shading.about().len() > 20);
    }
    let error = "gamma".parse::<Shading>().unwrap_err().to_string();
    assert!(error.contains("`gamma`"), "{error}");
    assert!(Shading::ALL.iter().all(|shading| error.contains(shading.name())), "{error}");
    assert_eq!(Shading::ALL[0], Shading::default());
}

proptest! {
    #[test]
    fn more_light_is_never_darker(code in any::<u8>(), a in 0.0..=1.0_f32, b in 0.0..=1.0_f32) {
        for &shading in Shading::ALL {
            prop_assert!(shading.shade(code, a.min(b)) <= shading.shade(code, a.max(b)), "{}", shading);
        }
    }

    #[test]
    fn a_colour_is_its_three_channels(rgb in any::<u32>(), light in 0.0..=1.0_f32) {
        let Color { r, g, b } = Color::from_u32(rgb);
        for &shading in Shading::ALL {
            let [r, g, b] = [r, g, b].map(|code| shading.shade(code, light));
            prop_assert_eq!(shading.shade_color(rgb, light), Color::new(r, g, b).to_u32());
        }
    }

    #[test]
    fn exact_is_the_crates_own_shading(code in any::<u8>(), light in 0.0..=1.0_f32) {
        prop_assert_eq!(Shading::Exact.shade(code, light), srgb::encode(srgb::decode(code) * light));
    }

    #[test]
    fn no_text_panics(text in ".*") {
        prop_assert!(text.parse::<Shading>().is_err() || Shading::ALL.iter().any(|s| s.name() == text));
    }
}
