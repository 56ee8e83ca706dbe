//! Delays of an animation in whole hundredths of a second, whose sum is right for any frame rate.
//!
//! ```text
//!   24 frames a second      0     4.17    8.33    12.5    16.67   ...  hundredths
//!   begin at                0     4       8       13      17
//!   delays                    4       4       5       4
//! ```
//!
//! A frame's delay is known when the next one comes, so one is always held back. No frame is shorter than 2 hundredths;
//! one that comes too soon waits, and when it would be late by as much as that, it takes the place of the one before.

use std::time::Duration;

/// The least delay: what is shorter, browsers show for 10 hundredths.
const LEAST: u64 = 2;

/// Nanoseconds of a hundredth.
const HUNDREDTH: u128 = 10_000_000;

/// The frame that is held back, and when it begins.
#[derive(Debug)]
pub(super) struct Clock<T>(Option<(T, u64)>);

impl<T> Clock<T> {
    pub(super) const fn new() -> Self {
        Self(None)
    }

    /// A frame comes at this time; the one before it with its delay, if that is to be shown.
    pub(super) fn next(&mut self, frame: T, time: Duration) -> Option<(T, u64)> {
        let Some((before, begun)) = self.0.take() else {
            self.0 = Some((frame, hundredths(time)));
            return None;
        };
        let begins = hundredths(time).max(begun + LEAST);
        let late = (u128::from(begins) * HUNDREDTH).saturating_sub(time.as_nanos());
        if late >= u128::from(LEAST) * HUNDREDTH {
            self.0 = Some((frame, begun));
            return None;
        }
        self.0 = Some((frame, begins));
        Some((before, begins - begun))
    }

    /// It ends at this time; the last frame with its delay.
    pub(super) fn end(&mut self, time: Duration) -> Option<(T, u64)> {
        self.0.take().map(|(last, begun)| (last, hundredths(time).max(begun + LEAST) - begun))
    }
}

/// Rounded to the nearest, halves up.
fn hundredths(time: Duration) -> u64 {
    u64::try_from((time.as_nanos() + HUNDREDTH / 2) / HUNDREDTH).unwrap_or(u64::MAX / 2)
}

#[cfg(test)]
mod tests {
    use std::time::Duration;

    use super::Clock;

    /// The frames that are shown and their delays, when so many come at a rate.
    fn delays(fps: f64, frames: u32) -> Vec<(u32, u64)> {
        let time = |n: u32| Duration::from_secs_f64(f64::from(n) / fps);
        let mut clock = Clock::new();
        let mut shown: Vec<_> = (0..frames).filter_map(|n| clock.next(n, time(n))).collect();
        shown.extend(clock.end(time(frames)));
        shown
    }

    #[test]
    fn delays_sum_up_to_the_whole_time_at_any_rate() {
        for fps in [0.3, 1.0, 7.0, 12.5, 23.976, 24.0, 25.0, 29.97, 30.0, 48.0, 50.0] {
            for frames in [1, 2, 71, 72, 1000] {
                let shown = delays(fps, frames);
                assert_eq!(shown.len(), frames as usize, "{fps}");
                let sum: u64 = shown.iter().map(|(_, delay)| delay).sum();
                assert_eq!(sum, (100.0 * f64::from(frames) / fps + 0.5) as u64, "{frames} at {fps}");
                let exact = 100.0 / fps;
                assert!(shown.iter().all(|(_, delay)| (*delay as f64 - exact).abs() < 1.0), "{fps}");
            }
        }
        assert_eq!(delays(24.0, 4).iter().map(|(_, d)| *d).collect::<Vec<_>>(), [4, 4, 5, 4]);
    }

    #[test]
    fn what_is_too_fast_for_browsers_loses_frames_and_keeps_its_time() {
        for fps in [60.0, 75.0, 144.0, 1000.0] {
            let shown = delays(fps, 600);
            assert!(shown.iter().all(|(_, delay)| *delay >= 2), "{fps}");
            let sum: u64 = shown.iter().map(|(_, delay)| delay).sum();
            assert!(sum.abs_diff((60_000.0 / fps) as u64) <= 2, "{fps}: {sum}");
            let expected = 600.0 * 50.0 / fps;
            assert!((shown.len() as f64 - expected).abs() <= 2.0, "{fps}: {}", shown.len());
            assert_eq!(shown.last().unwrap().0, 599);
        }
    }

    #[test]
    fn a_frame_lasts_until_the_next_comes() {
        let mut clock = Clock::new();
        assert_eq!(clock.next('a', Duration::ZERO), None);
        assert_eq!(clock.next('b', Duration::from_millis(2_000)), Some(('a', 200)));
        assert_eq!(clock.next('c', Duration::from_millis(2_040)), Some(('b', 4)));
        assert_eq!(clock.end(Duration::from_secs(3)), Some(('c', 96)));
        assert_eq!(clock.end(Duration::from_secs(3)), None);
        assert_eq!(clock.next('d', Duration::MAX), None);
        assert_eq!(clock.next('e', Duration::MAX), Some(('d', 2)));
    }
}
