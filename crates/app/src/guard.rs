//! A panic, made an error.
//!
//! Nothing here is expected to panic. Should it happen all the same, a user gets one line that names the file,
//! and the models that follow are still drawn. (With `panic = "abort"` nothing can be caught; the workspace does
//! not set that.)

use std::any::Any;
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
        Err(Error::Panic { file: one_line(&file.to_string_lossy()), message: message(&*payload) })
    })
}

/// What `work` returns, or the message of its panic, which is not printed.
///
/// While it runs, no panic of the process is: for short work, when nothing else goes on.
#[cfg(feature = "window")]
pub(crate) fn quietly<T>(work: impl FnOnce() -> T) -> Result<T, String> {
    let hook = panic::take_hook();
    panic::set_hook(Box::new(|_| {}));
    let done = panic::catch_unwind(AssertUnwindSafe(work)).map_err(|payload| message(&*payload));
    panic::set_hook(hook);
    done
}

fn message(payload: &(dyn Any + Send)) -> String {
    let text = payload.downcast_ref::<&str>().copied();
    let text = text.or_else(|| payload.downcast_ref::<String>().map(String::as_str)).unwrap_or("no message");
    one_line(&text.chars().take(200).collect::<String>())
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
