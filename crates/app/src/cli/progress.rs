//! A progress bar for long work: on a terminal, after half a second; nothing anywhere else.

use std::io::IsTerminal as _;
use std::sync::mpsc::{self, RecvTimeoutError, Sender};
use std::thread;
use std::time::Duration;

use indicatif::{ProgressBar, ProgressDrawTarget, ProgressStyle};

/// Work that takes no longer shows no bar, which would only flicker.
const PATIENCE: Duration = Duration::from_millis(500);

/// Progress in steps.
#[derive(Debug)]
pub(super) struct Progress {
    /// The bar, and what keeps the thread waiting that is going to show it.
    shown: Option<(ProgressBar, Sender<()>)>,
}

impl Progress {
    /// Progress of so many steps.
    pub(super) fn new(steps: u64) -> Self {
        Self { shown: std::io::stderr().is_terminal().then(|| start(steps)) }
    }

    /// Says what is being done now.
    pub(super) fn now(&self, what: &str) {
        if let Some((bar, _)) = &self.shown {
            bar.set_message(crate::error::one_line(what));
        }
    }

    /// One step is done.
    pub(super) fn step(&self) {
        if let Some((bar, _)) = &self.shown {
            bar.inc(1);
        }
    }

    /// Does something that prints, with the bar out of the way.
    pub(super) fn aside(&self, print: impl FnOnce()) {
        match &self.shown {
            Some((bar, _)) => bar.suspend(print),
            None => print(),
        }
    }
}

impl Drop for Progress {
    fn drop(&mut self) {
        if let Some((bar, _)) = &self.shown {
            bar.finish_and_clear();
        }
    }
}

fn start(steps: u64) -> (ProgressBar, Sender<()>) {
    let bar = ProgressBar::with_draw_target(Some(steps), ProgressDrawTarget::hidden());
    if let Ok(style) = ProgressStyle::with_template("{elapsed:>4} [{bar:30}] {pos}/{len} {wide_msg}") {
        bar.set_style(style.progress_chars("=> "));
    }
    let (sender, receiver) = mpsc::channel::<()>();
    let shown = bar.clone();
    thread::spawn(move || {
        // The sender is dropped with the progress, which ends the waiting at once.
        if receiver.recv_timeout(PATIENCE) == Err(RecvTimeoutError::Timeout) && !shown.is_finished() {
            shown.set_draw_target(ProgressDrawTarget::stderr());
            shown.enable_steady_tick(Duration::from_millis(100));
        }
    });
    (bar, sender)
}
