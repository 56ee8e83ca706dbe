//! Counts and times of frames.

use std::collections::VecDeque;
use std::time::{Duration, Instant};

use polosa_scene::DrawStats;

/// How many of the last frames times are kept of.
const KEPT: usize = 4096;

/// The rate is that of the frames within this time.
const RATE_OVER: Duration = Duration::from_secs(1);

/// Counts and times of an application's frames.
#[derive(Clone, Debug, Default)]
pub struct Statistics {
    frames: u64,
    last: DrawStats,
    /// When frames were begun.
    begun: VecDeque<Instant>,
    drawing: VecDeque<Duration>,
    latencies: VecDeque<Duration>,
}

impl Statistics {
    /// How many frames were drawn.
    #[must_use]
    pub const fn frames(&self) -> u64 {
        self.frames
    }

    /// What became of the last frame's triangles and edges.
    #[must_use]
    pub const fn last(&self) -> &DrawStats {
        &self.last
    }

    /// How long the last frame took to draw, without what is drawn over it; 0 before the first.
    #[must_use]
    pub fn time(&self) -> Duration {
        self.drawing.back().copied().unwrap_or_default()
    }

    /// Frames a second: how many were begun within the last second before the last one, that one included.
    #[must_use]
    pub fn rate(&self) -> f64 {
        let Some(&last) = self.begun.back() else { return 0.0 };
        let within = self.begun.iter().rev().take_while(|then| last.duration_since(**then) <= RATE_OVER);
        let (count, first) = within.fold((0_u32, last), |(count, _), then| (count + 1, *then));
        let span = last.duration_since(first).as_secs_f64();
        if span > 0.0 { f64::from(count - 1) / span } else { 0.0 }
    }

    /// How long each of the last frames (4,096 at most) took to draw, the oldest first.
    pub fn times(&self) -> impl ExactSizeIterator<Item = Duration> {
        self.drawing.iter().copied()
    }

    /// From the first event that a frame answers to its being handed to the screen, for the last frames (4,096 at most)
    /// that answered one, the oldest first.
    pub fn latencies(&self) -> impl ExactSizeIterator<Item = Duration> {
        self.latencies.iter().copied()
    }

    /// A frame was drawn that follows the last one at `begun`.
    pub(super) fn frame(&mut self, begun: Instant, took: Duration, stats: DrawStats) {
        self.frames += 1;
        self.last = stats;
        keep(&mut self.begun, begun);
        keep(&mut self.drawing, took);
    }

    /// A frame that answers an event of this age is on the screen.
    #[cfg(feature = "window")]
    pub(crate) fn answered(&mut self, age: Duration) {
        keep(&mut self.latencies, age);
    }
}

fn keep<T>(kept: &mut VecDeque<T>, one: T) {
    if kept.len() == KEPT {
        kept.pop_front();
    }
    kept.push_back(one);
}

#[cfg(test)]
mod tests {
    use std::time::{Duration, Instant};

    use polosa_scene::DrawStats;

    use super::{KEPT, Statistics};

    #[test]
    fn the_rate_is_that_of_the_last_second() {
        let (start, mut statistics) = (Instant::now(), Statistics::default());
        assert_eq!(statistics.rate(), 0.0);
        let mut at =
            |ms| statistics.frame(start + Duration::from_millis(ms), Duration::ZERO, DrawStats::default());
        at(0); // long before
        (0..=10).for_each(|k| at(5000 + 40 * k));
        assert_eq!((statistics.rate(), statistics.frames()), (25.0, 12));
    }

    #[test]
    fn times_are_kept_of_so_many_frames_and_no_more() {
        let (start, mut statistics) = (Instant::now(), Statistics::default());
        for k in 0..KEPT as u64 + 5 {
            statistics.frame(start, Duration::from_micros(k), DrawStats::default());
        }
        assert_eq!(
            (statistics.times().len(), statistics.times().next()),
            (KEPT, Some(Duration::from_micros(5)))
        );
        assert_eq!(statistics.time(), Duration::from_micros(KEPT as u64 + 4));
    }
}
