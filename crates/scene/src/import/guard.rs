//! A library's panic, made an error.
//!
//! The readers refuse what they can before a library sees it. Should one panic all the same, the panic is
//! caught, its message goes into the error, and nothing is printed: the process-wide panic hook is wrapped once,
//! by one that stays silent on a thread that is inside [`run`] and calls the former hook everywhere else.
//! (With `panic = "abort"` nothing can be caught; the workspace does not set that.)

use std::cell::Cell;
use std::panic::{self, AssertUnwindSafe};
use std::sync::Once;

use super::error::{Fault, Parsed, quote};

thread_local! {
    static SILENT: Cell<bool> = const { Cell::new(false) };
}

static WRAP_HOOK: Once = Once::new();

/// `read()`, or an error that holds the panic's message.
pub(super) fn run<T>(read: impl FnOnce() -> Parsed<T>) -> Parsed<T> {
    WRAP_HOOK.call_once(|| {
        let former = panic::take_hook();
        panic::set_hook(Box::new(move |info| {
            if !SILENT.get() {
                former(info);
            }
        }));
    });
    let outer = SILENT.replace(true);
    // The closure's captures are dropped with it when it unwinds: nothing half-done can be seen afterwards.
    let result = panic::catch_unwind(AssertUnwindSafe(read));
    SILENT.set(outer);
    result.unwrap_or_else(|payload| {
        let what = payload
            .downcast_ref::<&str>()
            .copied()
            .or_else(|| payload.downcast_ref::<String>().map(String::as_str))
            .unwrap_or("no message");
        Err(Fault::new(format!(
            "the reader stopped at something that it does not expect ({}): the file is broken, export it again",
            quote(what.as_bytes(), 120)
        )))
    })
}

#[cfg(test)]
mod tests {
    use super::run;
    use crate::import::error::ImportError;

    #[test]
    fn a_panic_becomes_one_line_with_its_message() {
        let empty: Vec<u8> = Vec::new();
        let fault = run(|| Ok(empty[3])).unwrap_err();
        let text = ImportError::new("x.ply", fault).to_string();
        assert!(text.starts_with("x.ply: the reader stopped"), "{text}");
        assert!(text.contains("index out of bounds"), "{text}");
        assert_eq!(run(|| Ok(5)), Ok(5));
    }
}
