//! Where a frame's time went.

use std::time::Duration;

/// The times of a frame's stages. On `wasm32-unknown-unknown`, which has no clock, they are 0.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, Default)]
pub struct Timings {
    /// Vertices to the screen, triangles prepared, lit and sorted by place.
    pub setup: Duration,
    /// Tiles drawn, shaded, and written out.
    pub fill: Duration,
    /// Edges and wire.
    pub lines: Duration,
}

/// A clock, where there is one.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Clock(#[cfg(not(all(target_family = "wasm", target_os = "unknown")))] std::time::Instant);

#[cfg(not(all(target_family = "wasm", target_os = "unknown")))]
impl Clock {
    pub(crate) fn start() -> Self {
        Self(std::time::Instant::now())
    }

    /// The time since the start.
    pub(crate) fn stop(self) -> Duration {
        self.0.elapsed()
    }
}

// There `Instant::now` panics.
#[cfg(all(target_family = "wasm", target_os = "unknown"))]
impl Clock {
    pub(crate) const fn start() -> Self {
        Self()
    }

    pub(crate) const fn stop(self) -> Duration {
        Duration::ZERO
    }
}
