//! The figures of two pictures, in one pass over their rows.
//!
//! Sums of codes are whole numbers, so that no order of summing has a say in them; those of distances are taken in
//! reading order.

use super::rows::{Rgba, code_limit, colors, common_depth, difference, gap};
use super::silhouette::distance;
use super::{Background, CompareError, Comparison, Image, Pixels, Settings};

/// Compares two pictures.
///
/// # Errors
///
/// When one has colours and the other distances, whatever their sizes; else when their sizes differ.
pub fn compare(a: &Image<'_>, b: &Image<'_>, settings: &Settings) -> Result<Comparison, CompareError> {
    // First what no size would mend: with two sizes it is known that the pictures differ, with two kinds nothing is.
    check_kinds(a, b)?;
    if a.size() != b.size() {
        return Err(CompareError::Sizes { a: a.size(), b: b.size() });
    }
    let (tally, silhouettes, largest_code) = match (a.pixels, b.pixels, common_depth(a, b)) {
        (Pixels::Distances(a), Pixels::Distances(b), _) => {
            let silhouettes = [a, b].map(|values| values.iter().map(|value| value.is_finite()).collect());
            (Tally::of_distances(a, b, settings.threshold), silhouettes, None)
        }
        (_, _, Some(largest)) => {
            let (tally, silhouettes) = of_colors(a, b, largest, settings);
            (tally, silhouettes, Some(largest))
        }
        (_, _, None) => return Err(CompareError::Kinds),
    };
    let [width, height] = a.size();
    let [of_a, of_b]: [Vec<bool>; 2] = silhouettes;
    Ok(Comparison {
        same: tally.beyond <= settings.allowed_pixels,
        width,
        height,
        largest_code,
        differing: tally.differing,
        beyond: tally.beyond,
        max_difference: tally.most,
        max_at: tally
            .most_at
            .map(|at| [at % u64::from(width), at / u64::from(width)].map(|side| side as u32)),
        mean_difference: tally.mean,
        psnr_db: tally.psnr,
        silhouette_px: distance(&of_a, &of_b, width as usize),
    })
}

/// Refuses colours on one side and distances on the other.
pub(super) fn check_kinds(a: &Image<'_>, b: &Image<'_>) -> Result<(), CompareError> {
    let [a, b] = [a, b].map(|image| image.pixels.largest_code().is_some());
    if a == b { Ok(()) } else { Err(CompareError::Kinds) }
}

/// What is counted.
struct Tally {
    differing: u64,
    beyond: u64,
    most: f64,
    most_at: Option<u64>,
    mean: f64,
    psnr: Option<f64>,
}

impl Tally {
    fn of_distances(a: &[f32], b: &[f32], threshold: f64) -> Self {
        // `max` takes the number of a number and NaN.
        let threshold = threshold.max(0.0);
        let mut tally = Self { differing: 0, beyond: 0, most: 0.0, most_at: None, mean: 0.0, psnr: None };
        let mut sum = 0.0;
        for (at, (a, b)) in (0..).zip(a.iter().zip(b)) {
            let gap = gap(*a, *b);
            sum += gap;
            tally.differing += u64::from(gap > 0.0);
            tally.beyond += u64::from(gap > threshold);
            if gap > tally.most {
                (tally.most, tally.most_at) = (gap, Some(at));
            }
        }
        tally.mean = sum / a.len() as f64;
        tally
    }
}

/// The sums over the channels of colours.
#[derive(Default)]
struct Sums {
    differing: u64,
    beyond: u64,
    most: u16,
    most_at: u64,
    differences: u64,
    /// 2²⁸ pixels of four channels of 2³² need more than 64 bits.
    squares: u128,
    transparent: bool,
}

impl Sums {
    /// Two rows, of which the first pixel is number `start`.
    fn add(&mut self, a: &[Rgba], b: &[Rgba], start: u64, largest: u16, limit: u16) {
        let opaque = |row: &[Rgba]| row.iter().all(|pixel| pixel[3] == largest);
        if !self.transparent {
            self.transparent = !(opaque(a) && opaque(b));
        }
        // The usual case, soon done with.
        if a == b {
            return;
        }
        for (at, (a, b)) in (start..).zip(a.iter().zip(b)) {
            let most = difference(*a, *b);
            if most == 0 {
                continue;
            }
            self.differing += 1;
            self.beyond += u64::from(most > limit);
            if most > self.most {
                (self.most, self.most_at) = (most, at);
            }
            let each = [0, 1, 2, 3].map(|c| u64::from(a[c].abs_diff(b[c])));
            self.differences += each.iter().sum::<u64>();
            self.squares += u128::from(each.iter().map(|each| each * each).sum::<u64>());
        }
    }

    fn tally(&self, pixels: u64, largest: u16) -> Tally {
        let values = (pixels * if self.transparent { 4 } else { 3 }) as f64;
        let differ = self.differing > 0;
        let peak = f64::from(largest) * f64::from(largest);
        Tally {
            differing: self.differing,
            beyond: self.beyond,
            most: f64::from(self.most),
            most_at: differ.then_some(self.most_at),
            mean: self.differences as f64 / values,
            psnr: differ.then(|| 10.0 * libm::log10(peak * values / self.squares as f64)),
        }
    }
}

/// The sums of two pictures of one size, and which of their pixels show something.
fn of_colors(a: &Image<'_>, b: &Image<'_>, largest: u16, settings: &Settings) -> (Tally, [Vec<bool>; 2]) {
    let width = a.width as usize;
    let limit = code_limit(settings.threshold);
    let mut rows = [vec![[0; 4]; width], vec![[0; 4]; width]];
    colors(a, 0, largest, &mut rows[0]);
    let nothing = Nothing::new(settings.background, rows[0][0], largest);
    let mut sums = Sums::default();
    let mut silhouettes = [(); 2].map(|()| vec![false; a.pixels.len()]);
    for y in 0..a.height as usize {
        let start = y * width;
        for ((image, row), silhouette) in [a, b].into_iter().zip(&mut rows).zip(&mut silhouettes) {
            colors(image, y, largest, row);
            for (shown, pixel) in silhouette[start..].iter_mut().zip(&*row) {
                *shown = !nothing.is(*pixel, limit);
            }
        }
        sums.add(&rows[0], &rows[1], start as u64, largest, limit);
    }
    (sums.tally(a.pixels.len() as u64, largest), silhouettes)
}

/// The background, at the depth of the comparison.
#[derive(Clone, Copy)]
enum Nothing {
    Transparent,
    Color(Rgba),
}

impl Nothing {
    fn new(background: Background, corner: Rgba, largest: u16) -> Self {
        match background {
            Background::Corner if corner[3] > 0 => Self::Color(corner),
            Background::Corner | Background::Transparent => Self::Transparent,
            Background::Color(color) => {
                let step = largest / u16::from(u8::MAX);
                Self::Color([color.r, color.g, color.b, u8::MAX].map(|code| u16::from(code) * step))
            }
        }
    }

    fn is(self, pixel: Rgba, limit: u16) -> bool {
        match self {
            Self::Transparent => pixel[3] <= limit,
            Self::Color(color) => difference(pixel, color) <= limit,
        }
    }
}

#[cfg(test)]
#[path = "tests.rs"]
mod tests;
