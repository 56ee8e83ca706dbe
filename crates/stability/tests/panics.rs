//! Claim: a panic is a verdict, shown to nobody, and the process has its own hook again afterwards.
//!
//! Alone in its file: the hook belongs to the process.

use std::panic;
use std::sync::atomic::{AtomicUsize, Ordering};
use std::thread;

use polosa_stability::{Drawn, Job, Rasteriser, Verdict, run};

struct Panics;

impl Rasteriser for Panics {
    fn draw(&mut self, _: &Job<'_>) -> Drawn {
        panic!("as ever");
    }
}

#[test]
fn a_panic_is_a_verdict_shown_to_nobody_and_the_hook_comes_back() {
    static SHOWN: AtomicUsize = AtomicUsize::new(0);
    panic::set_hook(Box::new(|_| {
        SHOWN.fetch_add(1, Ordering::SeqCst);
    }));
    // Two at a time: the last to end restores what the first found.
    thread::scope(|scope| {
        for _ in 0..2 {
            scope.spawn(|| {
                let report = run(&mut Panics);
                assert!(report.rows().iter().all(|&(_, verdict)| verdict == Verdict::Panic), "{report}");
                assert!(!report.passed());
            });
        }
    });
    assert_eq!(SHOWN.load(Ordering::SeqCst), 0, "messages shown");
    assert!(panic::catch_unwind(|| panic!("shown")).is_err());
    let shown = SHOWN.load(Ordering::SeqCst);
    drop(panic::take_hook());
    assert_eq!(shown, 1, "the hook is not the one that was there");
}
