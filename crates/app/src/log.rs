//! Failures of the system, told to whoever keeps the log.

use std::io::{self, Write as _};

use tracing::subscriber::NoSubscriber;

use crate::error::Error;

/// Passes a result on; a failure is logged first: to the program's `tracing` subscriber, or where it has set none to
/// standard error.
pub(crate) fn critical<T>(result: Result<T, Error>) -> Result<T, Error> {
    if let Err(error) = &result {
        if tracing::dispatcher::get_default(|dispatch| dispatch.is::<NoSubscriber>()) {
            // Where standard error is closed, nobody listens.
            let _ = writeln!(io::stderr(), "polosa: {error}");
        } else {
            tracing::error!("{error}");
        }
    }
    result
}
