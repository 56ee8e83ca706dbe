//! A logarithmic axis, with a place of its own for zero.
//!
//! ```text
//!   0   ┆   10⁻⁶    10⁻⁵    10⁻⁴          zero is farther than any power of ten: it stands alone,
//!   ●   ┆     ●  ●      ●                 before a gap, and does not say how far it is
//! ```

/// What an axis shows.
#[derive(Clone, Debug, Default)]
pub(crate) struct Axis {
    /// What is measured, in which unit.
    pub(crate) label: String,
    /// The range begins here or below, if anything does.
    pub(crate) from: Option<f64>,
    /// The range ends here or above.
    pub(crate) to: Option<f64>,
}

impl Axis {
    pub(crate) fn of(label: &str) -> Self {
        Self { label: label.to_owned(), ..Self::default() }
    }

    pub(crate) fn within(self, from: f64, to: f64) -> Self {
        Self { from: Some(from), to: Some(to), ..self }
    }
}

/// An axis laid out: from values to pixels.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Scale {
    /// Decimal logarithms of the ends.
    from: f64,
    to: f64,
    /// The pixels of the ends; the second may be less than the first.
    start: f64,
    end: f64,
    /// Where zero is, if the axis shows it.
    zero: Option<f64>,
}

impl Scale {
    /// An axis from pixel `start` to `end` for these values. Those that are negative or not finite have no place.
    pub(crate) fn new(axis: &Axis, values: impl IntoIterator<Item = f64>, start: i32, end: i32) -> Self {
        let (mut from, mut to) = (f64::INFINITY, f64::NEG_INFINITY);
        let mut zero = false;
        for value in values.into_iter().chain(axis.from).chain(axis.to) {
            zero |= value == 0.0;
            if value > 0.0 && value.is_finite() {
                (from, to) = (from.min(value.log10()), to.max(value.log10()));
            }
        }
        if from > to {
            (from, to) = (-1.0, 1.0);
        }
        // Never less than a decade, with some air at both ends.
        let middle = f64::midpoint(from, to);
        let half = ((to - from) / 2.0).max(0.5) * 1.06;
        let (start, end) = (f64::from(start), f64::from(end));
        let room =
            if zero { (end - start).signum() * ((end - start).abs() * 0.12).clamp(40.0, 120.0) } else { 0.0 };
        let at_zero = zero.then_some(start + room * 0.45);
        Self { from: middle - half, to: middle + half, start: start + room, end, zero: at_zero }
    }

    /// The pixel of a value, if it has one.
    pub(crate) fn at(&self, value: f64) -> Option<i32> {
        if value == 0.0 {
            return self.zero.map(|at| at.round() as i32);
        }
        let part = (value.log10() - self.from) / (self.to - self.from);
        (value > 0.0 && part.is_finite())
            .then(|| (self.start + (self.end - self.start) * part).round() as i32)
    }

    /// The pixel of a value, or of the end that it lies beyond.
    pub(crate) fn nearest(&self, value: f64) -> i32 {
        let [from, to] = [self.from, self.to].map(|end| 10_f64.powf(end));
        let inside = if value > from { value.min(to) } else { from };
        self.at(inside).unwrap_or_else(|| self.start.round() as i32)
    }

    /// Whether a value lies between the ends.
    pub(crate) fn holds(&self, value: f64) -> bool {
        value == 0.0 && self.zero.is_some() || value > 0.0 && (self.from..=self.to).contains(&value.log10())
    }

    /// The pixel where zero's place ends.
    pub(crate) fn gap(&self) -> Option<i32> {
        self.zero.map(|_| self.start.round() as i32)
    }

    /// Where lines across the chart stand, and what is written at those that are named.
    pub(crate) fn ticks(&self) -> Vec<(i32, Option<String>)> {
        let decades = self.from.ceil() as i32..=self.to.floor() as i32;
        // As many names as there is room for.
        let room = (self.end - self.start).abs() / (self.to - self.from);
        let step = (80.0 / room).ceil().max(1.0) as i32;
        let mut ticks: Vec<_> =
            self.zero.iter().map(|at| (at.round() as i32, Some("0".to_owned()))).collect();
        for decade in self.from.floor() as i32..=self.to.ceil() as i32 {
            for digit in 1..10 {
                let value = f64::from(digit) * 10_f64.powi(decade);
                if !self.holds(value) {
                    continue;
                }
                let Some(at) = self.at(value) else { continue };
                // Where hardly a decade is shown, twos and fives are named, too.
                let few = decades.clone().count() < 2 && [2, 5].contains(&digit);
                let named = digit == 1 && decade.rem_euclid(step) == 0 || few;
                if digit == 1 || room > 100.0 {
                    ticks.push((at, named.then(|| name(value))));
                }
            }
        }
        ticks
    }
}

/// A number of one digit, in as few signs as it takes.
fn name(value: f64) -> String {
    let decade = value.log10().floor() as i32;
    let (unit, letter) = match decade {
        -3..3 => (0, ""),
        3..6 => (3, "k"),
        6..9 => (6, "M"),
        9..12 => (9, "G"),
        _ => {
            let digit = (value / 10_f64.powi(decade)).round();
            let factor = if digit == 1.0 { String::new() } else { format!("{digit} · ") };
            return format!("{factor}10{}", superscript(decade));
        }
    };
    let rest = value / 10_f64.powi(unit);
    let digits = usize::try_from(-(decade - unit)).unwrap_or(0);
    format!("{rest:.digits$}{letter}")
}

fn superscript(number: i32) -> String {
    let sign = |c: char| match c {
        '-' => '⁻',
        '1' => '¹',
        '2' => '²',
        '3' => '³',
        _ => char::from_u32(u32::from('⁰') + u32::from(c) - u32::from('0')).unwrap_or(c),
    };
    number.to_string().chars().map(sign).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn decades_are_equally_far_and_zero_stands_before_them() {
        let scale = Scale::new(&Axis::of("x"), [0.0, 1e-6, 1e-3, f64::NAN, -4.0, f64::INFINITY], 100, 900);
        let at = |value| scale.at(value).unwrap();
        assert!(100 < at(0.0) && at(0.0) < scale.gap().unwrap() && scale.gap().unwrap() < at(1e-6));
        let steps = [at(1e-5) - at(1e-6), at(1e-4) - at(1e-5), at(1e-3) - at(1e-4)];
        assert!(steps.iter().all(|step| (step - steps[0]).abs() <= 1), "{steps:?}");
        assert!(at(1e-3) < 900);
        assert_eq!((scale.nearest(1e-5), scale.nearest(-1.0)), (at(1e-5), scale.gap().unwrap()));
        assert_eq!((scale.nearest(7.0), scale.nearest(f64::INFINITY)), (900, 900));
        assert_eq!((scale.at(f64::NAN), scale.at(-1.0)), (None, None));
        let up = Scale::new(&Axis::of("y"), [1.0, 10.0], 900, 100);
        assert!(up.at(10.0) < up.at(1.0) && up.at(0.0).is_none() && up.gap().is_none());
    }

    #[test]
    fn whatever_is_measured_there_is_a_scale() {
        for values in [vec![], vec![0.0], vec![7.0], vec![f64::NAN], vec![1e-300, 1e300], vec![1e-300]] {
            let scale = Scale::new(&Axis::of("x"), values.clone(), 0, 500);
            let ticks = scale.ticks();
            assert!(ticks.iter().filter(|tick| tick.1.is_some()).count() >= 1, "{values:?}");
            assert!(ticks.len() < 700 && ticks.iter().all(|&(at, _)| (0..=500).contains(&at)), "{values:?}");
            assert!(values.iter().all(|&v| v.is_nan() || scale.at(v).is_some()));
        }
    }

    #[test]
    fn numbers_are_short() {
        let names = [0.001, 0.02, 0.5, 1.0, 200.0, 1e3, 5e4, 1e6, 2e9, 1e-4, 5e-12, 1e13].map(name);
        let short =
            ["0.001", "0.02", "0.5", "1", "200", "1k", "50k", "1M", "2G", "10⁻⁴", "5 · 10⁻¹²", "10¹³"];
        assert_eq!(names, short);
    }
}
