//! Time, taken in turns.
//!
//! ```text
//!   round 1:  A B C D        a turn: once to warm the caches that others have used, then again and again
//!   round 2:  B C D A                until its share of time is over; its figure is the fastest run,
//!   round 3:  C D A B                which the rest of the machine disturbed least
//! ```
//!
//! A machine that is shared has slow minutes. Where everybody has a turn in every round, they are slow for all; the
//! median of the rounds is then near what a quiet machine would say, and their spread says how near.

use std::hint::black_box;
use std::time::{Duration, Instant};

/// How long measuring may take.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Effort {
    /// To see that everything works: seconds.
    Quick,
    /// For figures to be quoted: minutes.
    Full,
}

impl Effort {
    const fn rounds(self) -> usize {
        match self {
            Self::Quick => 3,
            Self::Full => 15,
        }
    }

    /// The length of a turn; one run may be longer.
    const fn turn(self) -> Duration {
        match self {
            Self::Quick => Duration::from_millis(4),
            Self::Full => Duration::from_millis(25),
        }
    }

    /// One of two, by the effort.
    pub(crate) fn either<T>(self, quick: T, full: T) -> T {
        match self {
            Self::Quick => quick,
            Self::Full => full,
        }
    }
}

/// What a contestant's turns took, in nanoseconds a run.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Timing {
    pub(crate) median: f64,
    /// The median of the turns' distances from the median.
    pub(crate) spread: f64,
}

impl Timing {
    /// Of at least one turn.
    fn of(turns: &mut [f64]) -> Self {
        let median = median(turns);
        turns.iter_mut().for_each(|turn| *turn = (*turn - median).abs());
        Self { median, spread: self::median(turns) }
    }
}

/// The middle one, or the mean of the middle two; NaN if there are none.
fn median(values: &mut [f64]) -> f64 {
    values.sort_unstable_by(f64::total_cmp);
    let half = values.len() / 2;
    match values {
        [] => f64::NAN,
        _ if values.len() % 2 == 1 => values[half],
        _ => f64::midpoint(values[half - 1], values[half]),
    }
}

/// Times so many contestants against each other; `run` runs one of them.
pub(crate) fn interleaved<T>(
    contestants: usize,
    effort: Effort,
    mut run: impl FnMut(usize) -> T,
) -> Vec<Timing> {
    let mut turns = vec![Vec::with_capacity(effort.rounds()); contestants];
    for round in 0..effort.rounds() {
        for place in 0..contestants {
            let contestant = (place + round) % contestants;
            turns[contestant].push(turn(effort.turn(), || drop(black_box(run(contestant)))));
        }
    }
    turns.iter_mut().map(|turns| Timing::of(turns)).collect()
}

/// The fastest run of a turn, in nanoseconds.
fn turn(length: Duration, mut run: impl FnMut()) -> f64 {
    let began = Instant::now();
    run();
    let mut fastest = Duration::MAX;
    loop {
        let start = Instant::now();
        run();
        fastest = fastest.min(start.elapsed());
        if began.elapsed() >= length {
            return fastest.as_nanos() as f64;
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_median_and_the_spread_are_those_of_the_turns() {
        let timing = |turns: &[f64]| Timing::of(&mut turns.to_vec());
        assert_eq!(timing(&[5.0]), Timing { median: 5.0, spread: 0.0 });
        assert_eq!(timing(&[9.0, 1.0]), Timing { median: 5.0, spread: 4.0 });
        assert_eq!(timing(&[3.0, 900.0, 1.0, 4.0, 2.0]), Timing { median: 3.0, spread: 1.0 });
        assert!(timing(&[]).median.is_nan());
    }

    #[test]
    fn everybody_has_a_turn_in_every_round_and_another_is_first() {
        let mut first = Vec::new();
        let mut runs = [0; 3];
        let timings = interleaved(3, Effort::Quick, |contestant| {
            if first.last() != Some(&contestant) {
                first.push(contestant);
            }
            runs[contestant] += 1;
        });
        assert_eq!(first, [0, 1, 2, 1, 2, 0, 2, 0, 1]);
        assert!(timings.len() == 3 && runs.iter().all(|&runs| runs >= 6));
    }
}
