//! Work done side by side whose results come back in order.
//!
//! ```text
//!   push ─▶ ○ ○ ○ ─▶ thread, thread, … ─▶ ● ● waiting for those before them ─▶ taken in order
//!           └───── at most one more than there are threads ─────┘
//! ```

use core::num::NonZeroUsize;
use std::collections::BTreeMap;
use std::fmt;
use std::path::{Path, PathBuf};
use std::sync::mpsc::{self, Receiver, Sender};
use std::sync::{Arc, Mutex, PoisonError};
use std::thread::{self, JoinHandle};

use crate::error::Error;
use crate::guard::caught;

type Done<R> = (u64, Result<R, Error>);
type Job<R> = Box<dyn FnOnce() -> Done<R> + Send>;

/// Threads, and what they are doing.
pub(super) struct Workers<R> {
    /// What is worked for, in messages about defects.
    file: PathBuf,
    /// `None` once no more is to come.
    jobs: Option<Sender<Job<R>>>,
    done: Receiver<Done<R>>,
    /// Results that wait for those before them.
    early: BTreeMap<u64, Result<R, Error>>,
    begun: u64,
    taken: u64,
    threads: Vec<JoinHandle<()>>,
}

impl<R> fmt::Debug for Workers<R> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { begun, taken, threads, .. } = self;
        f.debug_struct("Workers")
            .field("begun", begun)
            .field("taken", taken)
            .field("threads", &threads.len())
            .finish_non_exhaustive()
    }
}

impl<R: Send + 'static> Workers<R> {
    /// So many threads that wait for work.
    pub(super) fn new(file: &Path, threads: NonZeroUsize) -> Result<Self, Error> {
        let (jobs, queue) = mpsc::channel::<Job<R>>();
        let queue = Arc::new(Mutex::new(queue));
        let (sender, done) = mpsc::channel();
        let threads: Result<_, _> = (0..threads.get())
            .map(|_| {
                let (queue, sender) = (Arc::clone(&queue), sender.clone());
                thread::Builder::new().name("polosa-encode".to_owned()).spawn(move || work(&queue, &sender))
            })
            .collect();
        let threads = threads.map_err(|error| {
            Error::file(file, format!("no thread can be started to encode frames: {error}"))
        })?;
        let (file, early) = (file.to_owned(), BTreeMap::new());
        Ok(Self { file, jobs: Some(jobs), done, early, begun: 0, taken: 0, threads })
    }

    /// Has a thread do this. First waits, if too much is under way; results that are there go to `take`, in order.
    ///
    /// # Errors
    ///
    /// The first of the work or of `take`. Nothing more should then be pushed.
    pub(super) fn push(
        &mut self,
        work: impl FnOnce() -> Result<R, Error> + Send + 'static,
        take: &mut dyn FnMut(R) -> Result<(), Error>,
    ) -> Result<(), Error> {
        self.drain(self.threads.len() as u64, take)?;
        let (number, file) = (self.begun, self.file.clone());
        let job: Job<R> = Box::new(move || (number, caught(&file, work)));
        self.begun += 1;
        self.jobs.as_ref().and_then(|jobs| jobs.send(job).ok()).ok_or_else(|| self.gone())
    }

    /// Waits until no more than `left` are under way; their results go to `take`, in order.
    ///
    /// # Errors
    ///
    /// As [`push`](Self::push).
    pub(super) fn drain(
        &mut self,
        left: u64,
        take: &mut dyn FnMut(R) -> Result<(), Error>,
    ) -> Result<(), Error> {
        loop {
            self.early.extend(self.done.try_iter());
            while let Some(result) = self.early.remove(&self.taken) {
                self.taken += 1;
                take(result?)?;
            }
            if self.begun - self.taken <= left {
                return Ok(());
            }
            let (number, result) = self.done.recv().map_err(|_| self.gone())?;
            self.early.insert(number, result);
        }
    }

    /// What cannot be: a thread ends only when there is no more to do.
    fn gone(&self) -> Error {
        Error::file(&self.file, "the threads that encode frames have ended: begin a new recording")
    }
}

/// What a thread does until there is no more to come.
fn work<R>(queue: &Mutex<Receiver<Job<R>>>, done: &Sender<Done<R>>) {
    loop {
        let next = queue.lock().unwrap_or_else(PoisonError::into_inner).recv();
        let Ok(job) = next else { return };
        if done.send(job()).is_err() {
            return;
        }
    }
}

impl<R> Drop for Workers<R> {
    /// Waits for what is under way: a program that ended meanwhile would leave half a file behind.
    fn drop(&mut self) {
        self.jobs = None;
        for thread in self.threads.drain(..) {
            // Panics of the work are caught; there is nobody to tell of another.
            let _ = thread.join();
        }
    }
}

#[cfg(test)]
mod tests {
    use core::num::NonZeroUsize;
    use std::path::Path;
    use std::sync::Arc;
    use std::sync::atomic::{AtomicU64, Ordering};
    use std::time::Duration;

    use super::Workers;
    use crate::error::Error;

    fn workers(threads: usize) -> Workers<u64> {
        Workers::new(Path::new("x"), NonZeroUsize::new(threads).unwrap()).unwrap()
    }

    fn keep(taken: &mut Vec<u64>) -> impl FnMut(u64) -> Result<(), Error> {
        |n| {
            taken.push(n);
            Ok(())
        }
    }

    #[test]
    fn results_come_in_order_and_no_more_are_under_way_than_allowed() {
        for threads in [1, 3] {
            let (mut workers, mut taken) = (workers(threads), Vec::new());
            let ended = Arc::new(AtomicU64::new(0));
            for n in 0..40_u64 {
                let counter = Arc::clone(&ended);
                let work = move || {
                    // The later, the sooner.
                    std::thread::sleep(Duration::from_micros(40 * (40 - n)));
                    counter.fetch_add(1, Ordering::SeqCst);
                    Ok(n)
                };
                workers.push(work, &mut keep(&mut taken)).unwrap();
                assert!(n + 1 - ended.load(Ordering::SeqCst) <= threads as u64 + 1);
            }
            workers.drain(0, &mut keep(&mut taken)).unwrap();
            assert_eq!(taken, (0..40).collect::<Vec<_>>());
        }
    }

    #[test]
    fn failures_and_panics_come_back_as_errors() {
        let mut failing = workers(2);
        failing.push(|| Err(Error::file("y", "no")), &mut |_| Ok(())).unwrap();
        assert_eq!(failing.drain(0, &mut |_| Ok(())).unwrap_err().to_string(), "y: no");

        let mut panicking = workers(1);
        let empty: Vec<u64> = Vec::new();
        panicking.push(move || Ok(empty[1]), &mut |_| Ok(())).unwrap();
        let error = panicking.drain(0, &mut |_| Ok(())).unwrap_err().to_string();
        assert!(error.starts_with("x: ") && error.contains("out of bounds"), "{error}");
    }
}
