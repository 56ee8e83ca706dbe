//! An X server of a test's own, without a screen that anybody sees: Xvfb.

use std::io::{BufRead as _, BufReader};
use std::process::{Child, Command, Stdio};

/// A running X server. It ends with this value, and also when the test's process is killed: the shell that it runs
/// under waits for the end of its standard input, whose other end is here.
///
/// ```text
///   test ──stdin──▶ sh: cat; kill ──▶ Xvfb -displayfd 1 ──stdout──▶ test: the number of a free display
/// ```
#[derive(Debug)]
pub(crate) struct Display {
    shell: Child,
    name: String,
}

const SHELL: &str = r#"Xvfb -displayfd 1 -screen 0 1600x1200x24 -dpi 96 -nolisten tcp </dev/null 2>/dev/null & server=$!
exec >&-
cat >/dev/null
kill $server 2>/dev/null
wait $server"#;

impl Display {
    /// Starts one. `None`, and a notice, where there is no Xvfb; an error in CI, which must not pass by leaving out.
    pub(crate) fn start() -> Option<Self> {
        let shell = Command::new("sh")
            .args(["-c", SHELL])
            .stdin(Stdio::piped())
            .stdout(Stdio::piped())
            .spawn()
            .expect("a shell starts");
        let mut display = Self { shell, name: String::new() };
        let mut line = String::new();
        let out = display.shell.stdout.take().expect("it is piped");
        // Without a server the other end is closed, and this returns at once.
        BufReader::new(out).read_line(&mut line).expect("Xvfb tells its display's number in ASCII");
        if line.trim().is_empty() {
            let in_ci = std::env::var_os("CI").is_some_and(|ci| !ci.is_empty() && ci != "false");
            assert!(!in_ci, "Xvfb cannot be started: install the package xvfb");
            say("skipped: no Xvfb, which shows windows to nobody: install the package xvfb");
            return None;
        }
        display.name = format!(":{}", line.trim());
        Some(display)
    }

    /// What the variable `DISPLAY` is to be.
    pub(crate) fn name(&self) -> &str {
        &self.name
    }

    /// Ends the server, as when a desktop crashes.
    pub(crate) fn stop(&mut self) {
        drop(self.shell.stdin.take());
        let _ = self.shell.wait();
    }
}

impl Drop for Display {
    fn drop(&mut self) {
        self.stop();
    }
}

/// A line for whoever reads the tests' output, also where it is captured.
pub(crate) fn say(text: &str) {
    use std::io::Write as _;
    // What the test harness captures is what the macros print; this is not.
    let _ = writeln!(std::io::stderr(), "{text}");
}
