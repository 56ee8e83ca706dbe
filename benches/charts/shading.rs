//! What does the nearest sRGB code cost, beside rougher ones?
//!
//! Each way of shading makes, of a colour `0x00RRGGBB` and an amount of light, the colour that is shown. Error: against
//! the nearest code, found in whole numbers of 400 bits, of all 256 codes at 1,001 amounts of light: the largest
//! difference, and how many of a million are not the nearest. (Where two codes are equally near, both are right.)
//!
//! Beside the scene's own ways: the crate `fast-srgb8` between a table that decodes and its encoder for four, and the
//! standard's formula both ways with the platform's `powf` in `f64`, which no other method here would use.

use std::hint::black_box;

use polosa_scene::reference::Shading;
use polosa_scene::{Color, srgb};
use polosa_stability::inputs::rng::Rng;

use crate::chart::{Axis, Drawings, Figure, Line, Panel, Point, Series};
use crate::csv::Row;
use crate::measure::{Effort, interleaved};
use crate::style;

#[path = "../../crates/scene/tests/support/shade.rs"]
pub(crate) mod oracle;

const NAME: &str = "shading";
const LARGEST: &str = "largest error in codes";
const WRONG: &str = "wrong codes in a million";

/// A way to shade.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Way {
    Ours(Shading),
    FastSrgb8,
    PowF64,
}

impl Way {
    fn all() -> Vec<Self> {
        Shading::ALL
            .iter()
            .map(|&shading| Self::Ours(shading))
            .chain([Self::FastSrgb8, Self::PowF64])
            .collect()
    }

    const fn name(self) -> &'static str {
        match self {
            Self::Ours(shading) => shading.name(),
            Self::FastSrgb8 => "fast-srgb8",
            Self::PowF64 => "powf in f64",
        }
    }

    fn shade(self, color: u32, light: f32) -> u32 {
        match self {
            Self::Ours(shading) => shading.shade_color(color, light),
            Self::FastSrgb8 => {
                let Color { r, g, b } = Color::from_u32(color);
                let [r, g, b] = [r, g, b].map(|code| srgb::decode(code) * light);
                let [r, g, b, _] = fast_srgb8::f32x4_to_srgb8([r, g, b, 0.0]);
                Color::new(r, g, b).to_u32()
            }
            Self::PowF64 => {
                let Color { r, g, b } = Color::from_u32(color);
                let [r, g, b] = [r, g, b].map(|code| by_formula(code, light.into()));
                Color::new(r, g, b).to_u32()
            }
        }
    }
}

/// IEC 61966-2-1, both ways, rounded to the nearest.
fn by_formula(code: u8, light: f64) -> u8 {
    let code = f64::from(code) / 255.0;
    let linear = light * if code <= 0.04045 { code / 12.92 } else { ((code + 0.055) / 1.055).powf(2.4) };
    let encoded = if linear <= 0.003_130_8 { 12.92 * linear } else { 1.055 * linear.powf(1.0 / 2.4) - 0.055 };
    (255.0 * encoded + 0.5) as u8
}

/// The largest error in codes, and how many of a million are wrong.
fn errors(way: Way, nearest: &[Vec<(u8, bool)>]) -> [f64; 2] {
    let (mut most, mut wrong, mut all) = (0, 0_u32, 0_u32);
    for (code, shades) in (0..=255_u8).zip(nearest) {
        for (&(right, tie), thousandths) in shades.iter().zip(0_u16..) {
            let shaded =
                way.shade(Color::new(code, code, code).to_u32(), f32::from(thousandths) / 1000.0) as u8;
            all += 1;
            if shaded != right && !(tie && shaded + 1 == right) {
                wrong += 1;
                most = most.max(shaded.abs_diff(right));
            }
        }
    }
    [most.into(), 1e6 * f64::from(wrong) / f64::from(all)]
}

/// # Errors
///
/// When the default is not always the nearest code.
pub(crate) fn measure(effort: Effort) -> Result<Vec<Row>, String> {
    let nearest: Vec<_> = (0..=255).map(oracle::all).collect();
    let mut r = Rng::new(19);
    let pixels: Vec<(u32, f32)> =
        (0..65_536).map(|_| (r.range(0, 0xff_ffff) as u32, r.unit() as f32)).collect();
    let mut out = vec![0_u32; pixels.len()];
    let ways = Way::all();
    let timings = interleaved(ways.len(), effort, |k| {
        shade_all(ways[k], &pixels, &mut out);
        black_box(out[0])
    });
    let mut rows = Vec::new();
    for (&way, timing) in ways.iter().zip(timings) {
        let errors = errors(way, &nearest);
        if way == Way::Ours(Shading::default()) && errors != [0.0; 2] {
            return Err(format!("the default shading is wrong: {errors:?}"));
        }
        for (metric, error) in [LARGEST, WRONG].into_iter().zip(errors) {
            rows.push(Row {
                chart: NAME.to_owned(),
                method: way.name().to_owned(),
                workload: "codes=256 shades=1001".to_owned(),
                time_unit: "ns/pixel".to_owned(),
                time: timing.median / pixels.len() as f64,
                error_metric: metric.to_owned(),
                error,
                spread: timing.spread / pixels.len() as f64,
            });
        }
    }
    Ok(rows)
}

/// Each way in a loop of its own, so that none asks at every pixel which it is.
fn shade_all(way: Way, pixels: &[(u32, f32)], out: &mut [u32]) {
    fn run(pixels: &[(u32, f32)], out: &mut [u32], shade: impl Fn(u32, f32) -> u32) {
        for (out, &(color, light)) in out.iter_mut().zip(pixels) {
            *out = shade(color, light);
        }
    }
    macro_rules! each {
        ($($way:pat => $constant:expr),*) => {
            match way { $($way => run(pixels, out, |color, light| $constant.shade(color, light)),)* }
        };
    }
    use Shading::{Exact, Naive, Power22, Power24, Table4096, Table65536};
    each! {
        Way::Ours(Exact) => Way::Ours(Exact),
        Way::Ours(Naive) => Way::Ours(Naive),
        Way::Ours(Power24) => Way::Ours(Power24),
        Way::Ours(Power22) => Way::Ours(Power22),
        Way::Ours(Table4096) => Way::Ours(Table4096),
        Way::Ours(Table65536) => Way::Ours(Table65536),
        Way::FastSrgb8 => Way::FastSrgb8,
        Way::PowF64 => Way::PowF64
    }
}

pub(crate) fn draw(rows: &[Row]) -> Result<Drawings, String> {
    let figure = Figure {
        title: "Shading: time against wrong codes".to_owned(),
        notes: vec![
            "A colour of three codes times an amount of light, to three codes. All 256 codes at 1,001 amounts of light,".to_owned(),
            "against the nearest code. Broad line: the Pareto front. Medians of rounds; bars: the median distance from them.".to_owned(),
        ],
        panels: vec![
            panel(rows, LARGEST, "how far off the worst code is", "largest error, in codes of 255"),
            panel(rows, WRONG, "how many codes are not the nearest", "wrong codes in a million"),
        ],
        columns: 2,
    };
    Ok(vec![(NAME, figure.svg()?)])
}

fn panel(rows: &[Row], metric: &str, title: &str, label: &str) -> Panel {
    let mut series = Vec::new();
    for row in rows.iter().filter(|row| row.error_metric == metric) {
        let (color, mark, name) = style::of(&row.method);
        let point = Point::new([row.time, row.error], [row.spread, 0.0]);
        series.push(Series { name, color, mark, line: Line::None, points: vec![point] });
    }
    Panel {
        title: title.to_owned(),
        x: Axis::of("ns a pixel"),
        y: Axis::of(label),
        series,
        guides: Vec::new(),
        front: true,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn errors_are_those_that_the_scene_asserts() {
        let nearest: Vec<_> = (0..=255).map(oracle::all).collect();
        let of = |way| errors(way, &nearest);
        assert_eq!(of(Way::Ours(Shading::Exact)), [0.0; 2]);
        assert_eq!(of(Way::Ours(Shading::Naive))[0], 74.0);
        assert_eq!(of(Way::FastSrgb8)[0], 1.0);
        // The platform's powf is not always the nearest, but never far from it.
        assert!(of(Way::PowF64)[0] <= 1.0 && of(Way::PowF64)[1] < 100.0);
    }
}
