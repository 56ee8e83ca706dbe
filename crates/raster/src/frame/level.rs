//! Which vector instructions are used. They decide how fast a picture is drawn, never a byte of it.

use core::fmt;

use fearless_simd::Simd;

/// A set of vector instructions that this machine has.
#[derive(Clone, Copy, Debug)]
pub struct Level(fearless_simd::Level);

impl Level {
    /// The best that the machine has. Without the feature `std`: the best that the program was compiled for.
    #[must_use]
    pub fn detect() -> Self {
        Self(fearless_simd::Level::try_detect().unwrap_or(fearless_simd::Level::baseline()))
    }

    /// All that the machine has, from the plainest to the best: what a test of sameness goes through. The scalar one
    /// is among them where there is no other, or with the feature `scalar`.
    pub fn available() -> impl Iterator<Item = Self> {
        let best = Self::detect().0;
        let mut levels = [None; 6];
        #[cfg(feature = "scalar")]
        {
            levels[0] = Some(fearless_simd::Fallback::new().level());
        }
        #[cfg(any(target_arch = "x86", target_arch = "x86_64"))]
        {
            levels[1] = best.as_sse2().map(Simd::level);
            levels[2] = best.as_sse4_2().map(Simd::level);
            levels[3] = best.as_avx2().map(Simd::level);
            levels[4] = best.as_avx512().map(Simd::level);
        }
        #[cfg(not(any(target_arch = "x86", target_arch = "x86_64")))]
        {
            levels[5] = Some(best).filter(|best| !best.is_fallback() || levels[0].is_none());
        }
        levels.into_iter().flatten().map(Self)
    }

    /// The level for `fearless_simd::dispatch`.
    #[inline]
    pub(crate) const fn inner(self) -> fearless_simd::Level {
        self.0
    }
}

impl Default for Level {
    fn default() -> Self {
        Self::detect()
    }
}

impl fmt::Display for Level {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let level = self.0;
        #[cfg(any(target_arch = "x86", target_arch = "x86_64"))]
        let name = if level.as_avx512().is_some() {
            "AVX-512"
        } else if level.as_avx2().is_some() {
            "AVX2"
        } else if level.as_sse4_2().is_some() {
            "SSE4.2"
        } else if level.as_sse2().is_some() {
            "SSE2"
        } else {
            "scalar"
        };
        #[cfg(target_arch = "aarch64")]
        let name = if level.is_fallback() { "scalar" } else { "NEON" };
        #[cfg(target_arch = "wasm32")]
        let name = if level.is_fallback() { "scalar" } else { "SIMD128" };
        #[cfg(not(any(
            target_arch = "x86",
            target_arch = "x86_64",
            target_arch = "aarch64",
            target_arch = "wasm32"
        )))]
        let name = if level.is_fallback() { "scalar" } else { "vectors" };
        f.pad(name)
    }
}
