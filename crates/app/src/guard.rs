//! A panic, made an error.
//!
//! Nothing here is expected to panic. Should it happen all the same, a user gets one line that names the file,
//! and the models that follow are still drawn. (With `panic = "abort"` nothing can be caught; the workspace does
//! not set that.)

use std::panic::{self, AssertUnwindSafe};
use std::path::Path;

use crate::error::{Error, one_line};

/// Keeps panics from printing on their own, for the rest of the process: [`caught`] tells about them.
/// With the environment variable `RUST_BACKTRACE` set they print as ever, for those who look for the defect.
pub(crate) fn silence_panics() {
    if std::env::var_os("RUST_BACKTRACE").is_none() {
        panic::set_hook(Box::new(|_| {}));
    }
}

/// What `work` returns, or [`Error::Panic`] with the panic's message.
pub(crate) fn caught<T>(file: &Path, work: impl FnOnce() -> Result<T, Error>) -> Result<T, Error> {
    // What the closure holds is dropped when it unwinds, or is a renderer, which keeps nothing between frames
    // that it relies on.
    panic::catch_unwind(AssertUnwindSafe(work)).unwrap_or_else(|payload| {
        let message = payload
            .downcast_ref::<&str>()
            .copied()
            .or_else(|| payload.downcast_ref::<String>().map(String::as_str))
            .unwrap_or("no message");
        Err(Error::Panic {
            file: one_line(&file.to_string_lossy()),
            message: one_line(&message.chars().take(200).collect::<String>()),
        })
    })
}

#[cfg(test)]
mod tests {
    use std::path::Path;

    use super::caught;

    #[test]
    fn a_panic_becomes_one_line_with_file_and_message() {
        let empty: Vec<u8> = Vec::new();
        let error = caught(Path::new("x.obj"), || Ok(empty[3])).unwrap_err();
        let text = error.to_string();
        assert!(text.starts_with("x.obj: ") && text.contains("out of bounds"), "{text}");
        assert_eq!(error.exit_status(), 1);
    }
}
