//! The shades of one colour: from an intensity to a pixel without arithmetic.
//!
//! A pixel of a colour at an intensity is, channel by channel, the nearest sRGB code of the product. The product
//! never falls as the intensity rises, nor does its code, so the pixel is a staircase: a channel of code c has c
//! steps.
//!
//! ```text
//!   pixel                     ┌────────     steps       the least intensity of each pixel, to the last bit,
//!                    ┌────────┘             ▲           sorted
//!         ┌──────────┘        ▲             │
//!   ──────┘          ▲        │             starts      for each cell of intensity, the step in force at its
//!   │     ▲    │     │  │     │  │                      beginning
//!   0        cell       cell       1
//! ```
//!
//! A look into the cell, and as many comparisons as steps lie between its beginning and the intensity: for most
//! colours less than one. The answer is that of the formula, for every `f32` from 0 to 1 (tested at every step).
//!
//! Making a table costs about as much as shading a thousand triangles by the formula, so it is made for objects that
//! have more, and kept for the next one of the same colour.

use crate::Color;
use crate::srgb;

/// Cells of intensity from 0 to 1. The curve is steepest in the dark, where a channel of code 255 takes 3,294 steps
/// to the unit: cells are then about as narrow as its steps. With fewer, dark shades take more comparisons.
const CELLS: usize = 4096;

/// All the pixels that one colour can become.
#[derive(Clone, Debug)]
pub(crate) struct Shades {
    color: Color,
    /// Pixels with the least intensity that has them, from 0 on; the last is above all intensities.
    steps: Vec<(f32, u32)>,
    /// For each cell, the last step at or below its beginning.
    starts: Vec<u16>,
}

impl Shades {
    pub(crate) fn new(color: Color) -> Self {
        let mut rises: Vec<(f32, u32)> = Vec::with_capacity(3 * 255);
        for (code, unit) in [(color.r, 0x1_0000), (color.g, 0x100), (color.b, 1)] {
            let light = srgb::decode(code);
            rises.extend((0..code).map(|below| (least_factor(light, srgb::least_above(below)), unit)));
        }
        rises.sort_unstable_by(|a, b| a.0.total_cmp(&b.0));
        let mut pixel = 0;
        let mut steps = vec![(0.0, 0)];
        for (intensity, unit) in rises {
            pixel += unit;
            match steps.last_mut() {
                Some(last) if last.0 == intensity => last.1 = pixel,
                _ => steps.push((intensity, pixel)),
            }
        }
        let mut step = 0;
        let starts = (0..=CELLS).map(|cell| {
            let begin = cell as f32 / CELLS as f32;
            while steps.get(step + 1).is_some_and(|&(least, _)| least <= begin) {
                step += 1;
            }
            // At most 766 steps.
            step as u16
        });
        let starts = starts.collect();
        steps.push((f32::INFINITY, 0));
        Self { color, steps, starts }
    }

    /// The colour whose shades these are.
    pub(crate) const fn color(&self) -> Color {
        self.color
    }

    /// The pixel at an intensity from 0 to 1; what is outside goes to the nearer end.
    #[inline]
    pub(crate) fn pixel(&self, intensity: f32) -> u32 {
        // The product is exact, a power of two; the conversion rounds down, and takes NaN for 0.
        let cell = (intensity * CELLS as f32) as usize;
        let mut step = usize::from(self.starts[cell.min(CELLS)]);
        while self.steps[step + 1].0 <= intensity && step + 2 < self.steps.len() {
            step += 1;
        }
        self.steps[step].1
    }
}

/// The least factor by which `light`, rounded, reaches `bound`: 0 < bound ≤ light ≤ 1.
fn least_factor(light: f32, bound: f32) -> f32 {
    // Within an ulp or two of the quotient; the rounded product never falls as the factor rises.
    let mut factor = bound / light;
    while light * factor >= bound {
        factor = factor.next_down();
    }
    while light * factor < bound {
        factor = factor.next_up();
    }
    factor
}

#[cfg(test)]
mod tests {
    use super::Shades;
    use crate::Color;
    use crate::light::Lighting;

    #[test]
    fn the_table_is_the_formula_beside_every_step_of_every_code() {
        for code in 0..=255_u8 {
            let color = Color::new(code, 255 - code, code.wrapping_mul(37));
            let shades = Shades::new(color);
            assert!(shades.steps.is_sorted_by(|a, b| a.0 < b.0), "no intensity twice");
            for &(least, pixel) in &shades.steps[..shades.steps.len() - 1] {
                assert_eq!(Lighting::pixel(color, least), pixel);
                for near in [least.next_down().max(0.0), least, least.next_up().min(1.0)] {
                    assert_eq!(shades.pixel(near), Lighting::pixel(color, near), "{color} at {near}");
                }
            }
            for shade in 0..=1000_u16 {
                let intensity = f32::from(shade) / 1000.0;
                assert_eq!(shades.pixel(intensity), Lighting::pixel(color, intensity));
            }
            assert_eq!(shades.pixel(1.0), color.to_u32());
        }
    }

    #[test]
    fn every_intensity_between_has_the_pixel_of_the_formula() {
        // A walk through all exponents, 37 mantissas each.
        let color = Color::new(255, 128, 1);
        let shades = Shades::new(color);
        for bits in (0..=1.0_f32.to_bits()).step_by(226_719) {
            let intensity = f32::from_bits(bits);
            assert_eq!(shades.pixel(intensity), Lighting::pixel(color, intensity), "{intensity}");
        }
    }

    #[test]
    fn what_is_no_intensity_goes_to_an_end() {
        let shades = Shades::new(Color::WHITE);
        for (intensity, pixel) in
            [(-1.0, 0), (f32::NAN, 0), (2.0, 0xff_ffff), (f32::INFINITY, 0xff_ffff), (-0.0, 0)]
        {
            assert_eq!(shades.pixel(intensity), pixel, "{intensity}");
        }
    }
}
