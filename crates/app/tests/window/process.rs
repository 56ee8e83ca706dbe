//! A program that is running, and what it says.

use std::path::Path;
use std::process::{Child, Command, Stdio};
use std::time::Duration;

use crate::wait::until;

/// A started program. It is killed when this goes, if it still runs.
#[derive(Debug)]
pub(crate) struct Process {
    child: Child,
}

/// What a program that has ended said.
#[derive(Debug)]
pub(crate) struct Said {
    pub(crate) status: Option<i32>,
    pub(crate) stdout: String,
    pub(crate) stderr: String,
}

/// A program's environment for a display, or for none.
pub(crate) fn command(program: impl AsRef<Path>, display: Option<&str>, folder: &Path) -> Command {
    let mut command = Command::new(program.as_ref());
    command.current_dir(folder);
    for name in ["DISPLAY", "WAYLAND_DISPLAY", "WAYLAND_SOCKET", "RUST_BACKTRACE", "RUST_LOG"] {
        command.env_remove(name);
    }
    // A pixel is a unit of the desktop, whatever size the server says that its screen has.
    command.env("WINIT_X11_SCALE_FACTOR", "1");
    if let Some(display) = display {
        command.env("DISPLAY", display);
    }
    command
}

impl Process {
    pub(crate) fn start(command: &mut Command) -> Self {
        let command = command.stdin(Stdio::null()).stdout(Stdio::piped()).stderr(Stdio::piped());
        Self { child: command.spawn().expect("the program starts") }
    }

    pub(crate) fn id(&self) -> u32 {
        self.child.id()
    }

    pub(crate) fn is_running(&mut self) -> bool {
        self.child.try_wait().expect("a child can be asked for").is_none()
    }

    /// Waits for its end.
    pub(crate) fn end(mut self) -> Said {
        until("the program's end", || (!self.is_running()).then_some(()));
        self.said()
    }

    fn said(&mut self) -> Said {
        let status = self.child.wait().expect("a child can be waited for").code();
        let read = |from: Option<&mut dyn std::io::Read>| {
            let mut bytes = Vec::new();
            from.map(|from| from.read_to_end(&mut bytes));
            String::from_utf8_lossy(&bytes).into_owned()
        };
        let stdout = read(self.child.stdout.as_mut().map(|out| out as _));
        let stderr = read(self.child.stderr.as_mut().map(|err| err as _));
        Said { status, stdout, stderr }
    }

    /// What its main thread has done so far: the processor's time, all threads together, and how often it went to sleep.
    #[cfg(target_os = "linux")]
    pub(crate) fn activity(&self) -> Activity {
        let read = |name: &str| {
            let path = format!("/proc/{}/{name}", self.id());
            std::fs::read_to_string(path).expect("a running program has its files")
        };
        let stat = read("stat");
        // After the name in parentheses, which may hold anything: user time is the 12th field, system time the 13th.
        let fields: Vec<_> = stat[stat.rfind(')').expect("a name")..].split(' ').collect();
        let ticks = |field: usize| fields[field].parse::<u64>().expect("a count");
        let status = read("status");
        let slept = status.lines().find_map(|line| line.strip_prefix("voluntary_ctxt_switches:"));
        let slept = slept.and_then(|count| count.trim().parse().ok()).expect("a count");
        Activity { time: Duration::from_millis(10 * (ticks(12) + ticks(13))), slept }
    }
}

impl Drop for Process {
    fn drop(&mut self) {
        let _ = self.child.kill();
        let _ = self.child.wait();
    }
}

/// See [`Process::activity`].
#[cfg(target_os = "linux")]
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Activity {
    pub(crate) time: Duration,
    pub(crate) slept: u64,
}
