//! Panics that are caught and not shown.
//!
//! What prints a panic's message is a hook of the whole process. The first suite that starts puts one in its place
//! that leaves out the panics of drawing threads and hands all others on; the last one that ends puts the old one back.

use std::cell::Cell;
use std::panic::{AssertUnwindSafe, PanicHookInfo, catch_unwind, set_hook, take_hook};
use std::sync::{Arc, Mutex, MutexGuard, PoisonError};

type Hook = Box<dyn Fn(&PanicHookInfo<'_>) + Send + Sync>;

/// How many suites are running, and the hook that was there before the first.
static RUNNING: Mutex<(usize, Option<Arc<Hook>>)> = Mutex::new((0, None));

thread_local! {
    static DRAWING: Cell<bool> = const { Cell::new(false) };
}

fn running() -> MutexGuard<'static, (usize, Option<Arc<Hook>>)> {
    RUNNING.lock().unwrap_or_else(PoisonError::into_inner)
}

/// As long as it lives, panics inside of [`catch`](Self::catch) are not shown.
#[derive(Debug)]
pub(crate) struct Quiet(());

impl Quiet {
    pub(crate) fn new() -> Self {
        let mut running = running();
        if running.0 == 0 {
            let before: Arc<Hook> = Arc::new(take_hook());
            running.1 = Some(Arc::clone(&before));
            set_hook(Box::new(move |info| {
                // A thread that is gone shows what it has to say.
                if !DRAWING.try_with(Cell::get).unwrap_or(false) {
                    before(info);
                }
            }));
        }
        running.0 += 1;
        Self(())
    }

    /// What `draw` returns, or `None` if it panics.
    #[expect(clippy::unused_self, reason = "only as long as the hook is there")]
    pub(crate) fn catch<T>(&self, draw: impl FnOnce() -> T) -> Option<T> {
        DRAWING.set(true);
        let result = catch_unwind(AssertUnwindSafe(draw));
        DRAWING.set(false);
        result.ok()
    }
}

impl Drop for Quiet {
    fn drop(&mut self) {
        let mut running = running();
        running.0 -= 1;
        // A thread that panics must not change the hook.
        if running.0 > 0 || std::thread::panicking() {
            return;
        }
        let Some(before) = running.1.take() else { return };
        drop(take_hook());
        match Arc::try_unwrap(before) {
            Ok(hook) => set_hook(hook),
            // Another thread is inside it at this moment: it then stays wrapped.
            Err(hook) => set_hook(Box::new(move |info| hook(info))),
        }
    }
}
