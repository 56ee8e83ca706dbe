//! What every renderer must do to take part.

/// A renderer with a job loaded and its memory warm.
pub(crate) trait Contestant {
    /// What it is called in the table.
    fn name(&self) -> String;

    /// Threads that draw.
    fn threads(&self) -> usize;

    /// Clears and draws some frames; how long each took, in nanoseconds.
    fn frames(&mut self, count: u32) -> Result<Vec<u64>, String>;

    /// Whether it draws at all: what does not is a floor that no renderer gets below, and is compared with nobody.
    fn draws(&self) -> bool {
        true
    }

    /// The last frame: `0x00RRGGBB`, rows from top to bottom.
    fn picture(&mut self) -> Result<Vec<u32>, String>;
}

/// Times a closure, again and again.
pub(crate) fn time(count: u32, mut frame: impl FnMut()) -> Vec<u64> {
    (0..count)
        .map(|_| {
            let start = std::time::Instant::now();
            frame();
            u64::try_from(start.elapsed().as_nanos()).unwrap_or(u64::MAX)
        })
        .collect()
}
