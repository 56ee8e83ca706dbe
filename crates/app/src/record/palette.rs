//! Many colours brought down to a few: the same on every machine, and as near as squared errors of codes can tell.
//!
//! ```text
//!   the box of all colours ─▶ cut where it lowers the squared error most, again and again ─▶ means
//!   ┌──────┬───┐                                                        │
//!   │ .  . │ : │     means move to the middle of what is nearest to them ◀┘   (Lloyd's algorithm)
//!   │ ─────┤ : │     and where one colour has half of a cell, the cell gets that colour:
//!   │ .:.: │ : │     a background stays what it is
//!   └──────┴───┘
//! ```
//!
//! The cut is that of X. Wu, "Color quantization by dynamic programming and principal analysis", 1992, without the
//! principal axes: along red, green or blue. Sums are whole numbers; what is divided is compared in `f64`.

/// How often means are moved. Later rounds change little: see the test.
const ROUNDS: usize = 4;

/// A colour and how many pixels have it.
pub(super) type Counted = (u32, u64);

/// At most `most` colours, ascending, for those of a picture, which are told apart and counted.
pub(super) fn palette(colors: &[Counted], most: usize) -> Vec<u32> {
    if colors.len() <= most {
        let mut exact: Vec<u32> = colors.iter().map(|(color, _)| *color).collect();
        exact.sort_unstable();
        return exact;
    }
    let mut means = cut(colors, most);
    for round in 0..ROUNDS {
        let nearest = Nearest::new(&means);
        let mut cells = vec![Cell::default(); means.len()];
        for &(color, count) in colors {
            cells[usize::from(nearest.index(color))].add(color, count);
        }
        let last = round + 1 == ROUNDS;
        for (mean, cell) in means.iter_mut().zip(&cells).filter(|(_, cell)| cell.count > 0) {
            *mean = if last && cell.most.1 * 2 >= cell.count { cell.most.0 } else { cell.mean() };
        }
        means.sort_unstable();
        means.dedup();
    }
    means
}

/// Red, green and blue.
fn codes(color: u32) -> [i32; 3] {
    let [_, r, g, b] = color.to_be_bytes();
    [r, g, b].map(i32::from)
}

/// Colours that one takes the place of.
#[derive(Clone, Copy, Debug, Default)]
struct Cell {
    count: u64,
    sums: [u64; 3],
    most: Counted,
}

impl Cell {
    fn add(&mut self, color: u32, count: u64) {
        self.count += count;
        for (sum, code) in self.sums.iter_mut().zip(codes(color)) {
            *sum += count * code as u64;
        }
        if count > self.most.1 {
            self.most = (color, count);
        }
    }

    /// Rounded to the nearest.
    fn mean(&self) -> u32 {
        self.sums.iter().fold(0, |color, sum| color << 8 | ((sum + self.count / 2) / self.count) as u32)
    }
}

/// The means of boxes.
fn cut(colors: &[Counted], most: usize) -> Vec<u32> {
    let mut boxes = vec![Cut::new(colors.to_vec())];
    while boxes.len() < most {
        let best = boxes.iter().enumerate().fold(None, |best: Option<(usize, f64)>, (k, cut)| {
            if cut.gain > best.map_or(0.0, |(_, gain)| gain) { Some((k, cut.gain)) } else { best }
        });
        let Some((k, _)) = best else { break };
        let Cut { colors, axis, last, .. } = boxes.swap_remove(k);
        let (low, high) = colors.into_iter().partition(|(color, _)| codes(*color)[axis] <= last);
        boxes.extend([Cut::new(low), Cut::new(high)]);
    }
    boxes.iter().map(|cut| cut.mean).collect()
}

/// Colours in a box, and where it is cut best.
struct Cut {
    colors: Vec<Counted>,
    mean: u32,
    /// By how much the squared error becomes less.
    gain: f64,
    axis: usize,
    /// The last code of the lower part.
    last: i32,
}

impl Cut {
    fn new(colors: Vec<Counted>) -> Self {
        let mut slices = [[Cell::default(); 256]; 3];
        let mut all = Cell::default();
        for &(color, count) in &colors {
            all.add(color, count);
            for (slices, code) in slices.iter_mut().zip(codes(color)) {
                slices[code as usize].add(color, count);
            }
        }
        let mut best = Self { colors, mean: all.mean(), gain: 0.0, axis: 0, last: 0 };
        let whole = explained(all.count, all.sums);
        for (axis, slices) in slices.iter().enumerate() {
            let (mut count, mut sums) = (0, [0; 3]);
            for (code, slice) in (0..).zip(slices).filter(|(_, slice)| slice.count > 0) {
                count += slice.count;
                sums = [0, 1, 2].map(|k| sums[k] + slice.sums[k]);
                let above = [0, 1, 2].map(|k| all.sums[k] - sums[k]);
                let gain = explained(count, sums) + explained(all.count - count, above) - whole;
                if count < all.count && gain > best.gain {
                    (best.gain, best.axis, best.last) = (gain, axis, code);
                }
            }
        }
        best
    }
}

/// What a mean takes away from the sum of squares: |Σ|² / n.
fn explained(count: u64, sums: [u64; 3]) -> f64 {
    let [r, g, b] = sums.map(|sum| sum as f64);
    (r * r + g * g + b * b) / count.max(1) as f64
}

/// Finds the nearest of some colours.
#[derive(Debug)]
pub(super) struct Nearest {
    /// By green, with their places among the colours.
    sorted: Vec<([i32; 3], u8)>,
}

impl Nearest {
    /// Of 1 to 256 colours.
    pub(super) fn new(colors: &[u32]) -> Self {
        let mut sorted: Vec<_> = colors.iter().map(|color| codes(*color)).zip(0..=u8::MAX).collect();
        sorted.sort_unstable_by_key(|(codes, place)| (codes[1], *place));
        Self { sorted }
    }

    /// The place of the nearest, of several the first.
    ///
    /// It is looked for from the same green outward, until green alone is farther than the best so far.
    pub(super) fn index(&self, color: u32) -> u8 {
        let wanted = codes(color);
        let (mut best, mut least) = (0, i32::MAX);
        let mut consider = |&(codes, place): &([i32; 3], u8)| {
            let [r, g, b] = [0, 1, 2].map(|k| codes[k] - wanted[k]);
            if g * g > least {
                return false;
            }
            let distance = r * r + g * g + b * b;
            if distance < least || distance == least && place < best {
                (best, least) = (place, distance);
            }
            true
        };
        let middle = self.sorted.partition_point(|(codes, _)| codes[1] < wanted[1]);
        let (mut below, mut above) = (self.sorted[..middle].iter().rev(), self.sorted[middle..].iter());
        let (mut down, mut up) = (true, true);
        while down || up {
            up = up && above.next().is_some_and(&mut consider);
            down = down && below.next().is_some_and(&mut consider);
        }
        best
    }
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::{Counted, Nearest, codes, palette};

    fn distance(a: u32, b: u32) -> i32 {
        codes(a).into_iter().zip(codes(b)).map(|(a, b)| (a - b) * (a - b)).sum()
    }

    /// The mean squared error of a channel.
    fn error(colors: &[Counted], palette: &[u32]) -> f64 {
        let nearest = Nearest::new(palette);
        let sum: f64 = colors
            .iter()
            .map(|&(color, count)| {
                f64::from(distance(color, palette[usize::from(nearest.index(color))])) * count as f64
            })
            .sum();
        sum / 3.0 / colors.iter().map(|(_, count)| *count as f64).sum::<f64>()
    }

    proptest! {
        #[test]
        fn the_nearest_is_found(
            colors in proptest::collection::vec(0..=0xff_ffff_u32, 1..=256),
            color in 0..=0xff_ffff_u32,
        ) {
            let found = Nearest::new(&colors).index(color);
            let expected = (0..colors.len()).min_by_key(|k| distance(colors[*k], color)).unwrap();
            prop_assert_eq!(usize::from(found), expected);
        }

        #[test]
        fn few_colors_stay_and_many_become_no_more_than_asked(
            colors in proptest::collection::btree_map(0..=0xff_ffff_u32, 1..1000_u64, 1..400),
            most in 1..=256_usize,
        ) {
            let colors: Vec<Counted> = colors.into_iter().collect();
            let made = palette(&colors, most);
            prop_assert!((1..=most).contains(&made.len()));
            prop_assert!(made.is_sorted());
            if colors.len() <= most {
                prop_assert_eq!(made, colors.iter().map(|(color, _)| *color).collect::<Vec<_>>());
            }
        }
    }

    /// Shades of five colours, and a background: what several objects look like.
    fn shades() -> Vec<Counted> {
        let mut colors = vec![(0x2b_2b2b, 400_000)];
        for base in [0xd9_8032_u32, 0x4a_7fc1, 0xe8_e0d0, 0x5c_b8a4, 0xc9_4f5b] {
            for shade in 1..=200_u64 {
                let [r, g, b] = codes(base).map(|code| code as u32 * shade as u32 / 200);
                colors.push((r << 16 | g << 8 | b, 100 + shade));
            }
        }
        colors.sort_unstable();
        colors.dedup_by_key(|(color, _)| *color);
        colors
    }

    #[test]
    fn the_background_is_exact_and_shades_are_within_three_codes() {
        let colors = shades();
        assert!(colors.len() > 900);
        let made = palette(&colors, 255);
        assert!(made.binary_search(&0x2b_2b2b).is_ok());
        assert!(error(&colors, &made) < 0.3, "{}", error(&colors, &made));
        let nearest = Nearest::new(&made);
        let worst =
            colors.iter().map(|(c, _)| distance(*c, made[usize::from(nearest.index(*c))])).max().unwrap();
        assert!(worst < 4 * 4, "{worst}");
    }

    #[test]
    fn a_full_cube_is_cut_no_worse_than_into_a_grid() {
        let colors: Vec<Counted> =
            (0..1 << 15).map(|k: u32| ((k >> 10 << 16 | (k >> 5 & 31) << 8 | k & 31) << 3, 1)).collect();
        let made = palette(&colors, 256);
        assert_eq!(made.len(), 256);
        // No worse than a grid of 8 × 8 × 4 cells. Codes that are 8 apart, n in a cell, have the variance 64·(n² − 1)/12.
        let variance = |n: f64| 64.0 * (n * n - 1.0) / 12.0;
        let grid = (2.0 * variance(4.0) + variance(8.0)) / 3.0;
        assert!(error(&colors, &made) <= grid, "{} {grid}", error(&colors, &made));
    }
}
