//! From light to codes, and from directions to hues.

use polosa_scene::reference::Shading;
use polosa_scene::reference::hue::{from_hsv, longitude, pseudo_longitude};

use super::kit::{Drawing, GREY, Made, PAPER, Panel, RED, count, marks, sheet};

/// Steps of light in the picture.
const LIGHTS: u32 = 176;
/// Heights of a ramp, and of the error's chart.
const RAMP: u32 = 36;
const CHART: u32 = 84;

/// White under ever more light, by the method above and exactly below; under it how many codes it is off.
fn ramp(shading: Shading) -> Made {
    let light = |x: u32| x as f32 / (LIGHTS - 1) as f32;
    let grey = |shading: Shading, x: u32| u32::from(shading.shade(255, light(x))) * 0x01_0101;
    let off = |x: u32| grey(shading, x).abs_diff(grey(Shading::Exact, x)) / 0x01_0101;
    let panel = Panel::new([LIGHTS, 2 * RAMP + CHART], |x, y| {
        if y < 2 * RAMP {
            return grey(if y < RAMP { shading } else { Shading::Exact }, x);
        }
        // One row a code, from the bottom, a line at each tenth one.
        let code = 2 * RAMP + CHART - 1 - y;
        match code {
            _ if code < off(x) => RED,
            _ if code.is_multiple_of(10) => GREY,
            _ => PAPER,
        }
    });
    let (mut most, mut sum, mut shades) = (0, 0, 0_u32);
    for code in 0..=255 {
        for step in 0..=1000_u16 {
            let light = f32::from(step) / 1000.0;
            let off = u32::from(shading.shade(code, light).abs_diff(Shading::Exact.shade(code, light)));
            most = most.max(off);
            sum += off;
            shades += 1;
        }
    }
    let figures = format!(
        "{shading}: up to {most} codes off, {:.1} in the mean of {} shades",
        f64::from(sum) / f64::from(shades),
        count(shades as usize)
    );
    Ok(Drawing { picture: sheet(&[panel], 2)?, figures })
}

/// Codes multiplied as if they were light.
pub(crate) fn naive() -> Made {
    ramp(Shading::Naive)
}

/// S0's exponent.
pub(crate) fn power_24() -> Made {
    ramp(Shading::Power24)
}

/// S3's exponent.
pub(crate) fn power_22() -> Made {
    ramp(Shading::Power22)
}

/// A disc of directions, each with its hue: evenly in the cosine, and in the angle.
pub(crate) fn hues() -> Made {
    const SIZE: [u32; 2] = [64, 64];
    let direction = |x: u32, y: u32| [f64::from(x) + 0.5 - 32.0, 32.0 - f64::from(y) - 0.5, 0.0];
    let inside = |[x, y, _]: [f64; 3]| x * x + y * y < 31.0 * 31.0;
    // Sectors of 15°, to make edges that can be seen.
    let color = |hue: f64| from_hsv(f64::from((hue / 15.0) as u32 * 15), 0.7, 0.9).to_u32();
    let of = |hue: &dyn Fn([f64; 3]) -> f64| {
        Panel::new(SIZE, |x, y| {
            let way = direction(x, y);
            if inside(way) { color(hue(way)) } else { PAPER }
        })
    };
    let exact = |way: [f64; 3]| longitude(way).unwrap_or(0.0);
    let mut most = 0.0_f64;
    let wrong: Vec<bool> = (0..SIZE[0] * SIZE[1])
        .map(|k| {
            let way = direction(k % SIZE[0], k / SIZE[0]);
            let off = (pseudo_longitude(way) - exact(way)).abs();
            most = most.max(if inside(way) { off } else { 0.0 });
            inside(way) && color(pseudo_longitude(way)) != color(exact(way))
        })
        .collect();
    let covered = (0..SIZE[0] * SIZE[1]).filter(|k| inside(direction(k % SIZE[0], k / SIZE[0]))).count();
    let figures = format!(
        "pseudo-longitude: up to {most:.1}° off, {} of {} pixels in another sector",
        marks(&wrong),
        count(covered)
    );
    // Hues are red, too: what is wrong stands out on grey alone.
    let disc = Panel::new(SIZE, |x, y| if inside(direction(x, y)) { GREY } else { PAPER });
    let panels = [of(&pseudo_longitude), disc.marked(&wrong), of(&exact)];
    Ok(Drawing { picture: sheet(&panels, 4)?, figures })
}
