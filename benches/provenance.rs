//! Where figures are from: what stands beside every record.

use std::process::Command;

/// The date and the time.
#[must_use]
pub fn date() -> String {
    said("date", &["-u", "+%Y-%m-%d %H:%M UTC"])
}

/// The commit that was built, and whether there were changes.
#[must_use]
pub fn commit() -> String {
    let root = env!("CARGO_MANIFEST_DIR");
    let commit = said("git", &["-C", root, "rev-parse", "--short=12", "HEAD"]);
    let changed = said("git", &["-C", root, "status", "--porcelain", "--untracked-files=no", ".."]);
    let made = |line: &&str| [".md", ".svg", ".csv"].iter().all(|end| !line.ends_with(end));
    match changed.lines().filter(made).count() {
        0 => commit,
        files => format!("{commit}, and changes not committed in {files} files"),
    }
}

/// The load averages of the last 1, 5 and 15 minutes.
#[must_use]
pub fn load() -> String {
    let text = std::fs::read_to_string("/proc/loadavg").unwrap_or_default();
    let averages: Vec<&str> = text.split_whitespace().take(3).collect();
    if averages.is_empty() { "?".to_owned() } else { averages.join(" ") }
}

/// The processor, and the widest vectors that it has.
#[must_use]
pub fn cpu() -> String {
    let text = std::fs::read_to_string("/proc/cpuinfo").unwrap_or_default();
    let field = |name: &str| {
        let line = text.lines().find(|line| line.split(':').next().is_some_and(|key| key.trim() == name))?;
        Some(line.split_once(':')?.1.trim().to_owned())
    };
    let Some(name) = field("model name") else { return "?".to_owned() };
    let number = |key| field(key).unwrap_or_else(|| "?".to_owned());
    let flags = field("flags").unwrap_or_default();
    let has = |flag: &str| flags.split(' ').any(|other| other == flag);
    let widest = ["avx512f", "avx2", "sse4_2"].into_iter().find(|flag| has(flag)).unwrap_or("");
    format!("{name}, family {} model {}, {widest}", number("cpu family"), number("model"))
}

/// How many threads can run at a time.
#[must_use]
pub fn cores() -> String {
    std::thread::available_parallelism().map_or_else(|_| "?".to_owned(), |n| n.to_string())
}

/// The compiler.
#[must_use]
pub fn compiler() -> String {
    said("rustc", &["-V"])
}

/// The first thing that a program says; `?` if it says nothing.
fn said(program: &str, arguments: &[&str]) -> String {
    let output = Command::new(program).args(arguments).output().ok().filter(|output| output.status.success());
    output.map_or_else(|| "?".to_owned(), |output| String::from_utf8_lossy(&output.stdout).trim().to_owned())
}
