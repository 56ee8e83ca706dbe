//! Times and what follows from them.

use core::hint::black_box;
use std::time::{Duration, Instant};

/// Times of the same work, done again and again.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) struct Spread {
    /// From short to long; never empty.
    sorted: Vec<Duration>,
}

impl Spread {
    /// Of these times; of none, one of 0.
    pub(super) fn of(mut times: Vec<Duration>) -> Self {
        if times.is_empty() {
            times.push(Duration::ZERO);
        }
        times.sort_unstable();
        Self { sorted: times }
    }

    /// How many times there are.
    pub(super) fn count(&self) -> usize {
        self.sorted.len()
    }

    /// The shortest.
    pub(super) fn min(&self) -> Duration {
        self.sorted[0]
    }

    /// The longest.
    pub(super) fn max(&self) -> Duration {
        self.sorted[self.sorted.len() - 1]
    }

    /// The middle one, of an even number the mean of the middle two.
    pub(super) fn median(&self) -> Duration {
        self.quantile(2)
    }

    /// What `k` quarters of the times are below, between two of them in proportion.
    pub(super) fn quantile(&self, k: u32) -> Duration {
        let place = (self.sorted.len() - 1) * k as usize;
        let (below, rest) = (place / 4, (place % 4) as u32);
        let above = self.sorted[(below + 1).min(self.sorted.len() - 1)];
        self.sorted[below] + (above - self.sorted[below]) * rest / 4
    }
}

/// How fast one thread fills memory with one byte: a yardstick for whatever writes every pixel's colour and depth.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Memset {
    /// Bytes that were filled.
    bytes: usize,
    /// How long that took, the median.
    pub(super) time: Duration,
}

impl Memset {
    /// Measures it, for at most a fifth of a second after having touched the memory.
    pub(super) fn measure(bytes: usize) -> Self {
        let mut buffer = vec![0_u8; bytes];
        let mut fill = |value: u8| {
            let start = Instant::now();
            black_box(&mut buffer).fill(value);
            black_box(&buffer);
            start.elapsed()
        };
        // The first one waits for the system to hand the memory over.
        fill(1);
        fill(2);
        let start = Instant::now();
        let mut times = vec![fill(3)];
        while times.len() < 1000 && start.elapsed() < Duration::from_millis(200) {
            times.push(fill(times.len() as u8));
        }
        Self { bytes, time: Spread::of(times).median() }
    }

    /// 10⁹ bytes a second.
    pub(super) fn gigabytes_per_second(self) -> f64 {
        per_second(self.bytes as f64, self.time) / 1e9
    }
}

/// So many in a time, a second.
pub(super) fn per_second(count: f64, time: Duration) -> f64 {
    // Clocks that are too coarse for a tiny picture say 0.
    count / time.max(Duration::from_nanos(1)).as_secs_f64()
}

/// Milliseconds with all digits that the clock gives.
pub(super) fn milliseconds(time: Duration) -> f64 {
    time.as_nanos() as f64 / 1e6
}

/// A number that stands for the pixels: FNV-1a with 64 bits over red, green and blue of each. It is the same on every
/// machine and with every number of threads, so that figures of different pictures are not taken for comparable.
pub(super) fn fingerprint(pixels: &[u32]) -> u64 {
    let bytes = pixels.iter().flat_map(|pixel| pixel.to_be_bytes().into_iter().skip(1));
    bytes.fold(0xcbf2_9ce4_8422_2325, |hash, byte| (hash ^ u64::from(byte)).wrapping_mul(0x100_0000_01b3))
}

#[cfg(test)]
mod tests {
    use std::time::Duration;

    use proptest::prelude::{prop, proptest};

    use super::{Memset, Spread, fingerprint, milliseconds, per_second};

    fn of(times: &[u64]) -> Spread {
        Spread::of(times.iter().copied().map(Duration::from_nanos).collect())
    }

    #[test]
    fn the_median_is_the_middle_or_the_mean_of_the_middle_two() {
        for (times, median) in
            [(vec![], 0), (vec![7], 7), (vec![9, 1], 5), (vec![30, 10, 20], 20), (vec![4, 1, 2, 3], 2)]
        {
            assert_eq!(of(&times).median().as_nanos(), median, "{times:?}");
        }
        let spread = of(&[50, 10, 40, 20, 30]);
        assert_eq!([1, 3].map(|k| spread.quantile(k).as_nanos()), [20, 40]);
        assert_eq!((spread.min().as_nanos(), spread.max().as_nanos(), spread.count()), (10, 50, 5));
    }

    proptest! {
        #[test]
        fn quarters_are_in_order_and_halve_the_times(times in prop::collection::vec(0..1_000_000_u64, 1..40)) {
            let spread = of(&times);
            let quarters = [0, 1, 2, 3, 4].map(|k| spread.quantile(k));
            assert!(quarters.is_sorted());
            assert_eq!((quarters[0], quarters[4]), (spread.min(), spread.max()));
            let below = times.iter().filter(|&&time| u128::from(time) < quarters[2].as_nanos()).count();
            let above = times.iter().filter(|&&time| u128::from(time) > quarters[2].as_nanos() + 1).count();
            assert!(2 * below <= times.len() && 2 * above <= times.len());
        }
    }

    #[test]
    fn rates_are_counts_over_times_and_finite_even_for_no_time() {
        assert_eq!(per_second(500.0, Duration::from_millis(250)), 2000.0);
        assert!(per_second(1e6, Duration::ZERO).is_finite());
        assert_eq!(milliseconds(Duration::from_nanos(1_234_567)), 1.234_567);
        let memset = Memset::measure(100_000);
        assert!(memset.gigabytes_per_second() > 0.0);
        assert_eq!(memset.bytes, 100_000);
    }

    #[test]
    fn fingerprints_are_fnv_1a_over_the_three_bytes() {
        // The published values for the texts "" and "foobar".
        assert_eq!(fingerprint(&[]), 0xcbf2_9ce4_8422_2325);
        assert_eq!(fingerprint(&[0x66_6f6f, 0x62_6172]), 0x8594_4171_f739_67e8);
    }
}
