//! Waiting for something, never for a time.

use std::time::{Duration, Instant};

/// How long anything may take. Far more than it does, even on a busy machine; what is too slow has tests of its own.
pub(crate) const LIMIT: Duration = Duration::from_secs(30);

/// How often one looks.
const PAUSE: Duration = Duration::from_millis(3);

/// Looks until there is something. Fails, naming what was waited for, when there is nothing for too long.
pub(crate) fn until<T>(what: &str, mut look: impl FnMut() -> Option<T>) -> T {
    let begun = Instant::now();
    loop {
        if let Some(found) = look() {
            return found;
        }
        assert!(begun.elapsed() < LIMIT, "waited {LIMIT:?} in vain for {what}");
        std::thread::sleep(PAUSE);
    }
}
