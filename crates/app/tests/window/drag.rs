//! A hand that drags over a big model, for the figures in docs/performance.md:
//!
//! ```sh
//! cargo test --release -p polosa --test window -- --ignored --nocapture --test-threads=1 dragging
//! ```

use std::time::{Duration, Instant};

use crate::display::{Display, say};
use crate::models::sheet;
use crate::process::{Process, command};
use crate::screen::Screen;
use crate::session::{POLOSA, Tap};

/// What mice send.
const EVENTS_A_SECOND: u32 = 125;

/// How long is dragged.
const WHILE: Duration = Duration::from_secs(6);

fn drag(n: u32) {
    let Some(display) = Display::start() else { return };
    let folder = tempfile::tempdir().expect("a folder");
    std::fs::write(folder.path().join("model.stl"), sheet(n)).expect("room for the model");
    let mut command = command(POLOSA, Some(display.name()), folder.path());
    let process = Process::start(command.args(["view", "model.stl", "--resolution", "1280,720", "--json"]));
    let mut screen = Screen::connect(display.name());
    screen.find();
    screen.wait_for_title("model.stl");
    screen.settled();

    let step = Duration::from_secs(1) / EVENTS_A_SECOND;
    screen.point([640, 360]);
    screen.button(1, true);
    let begun = Instant::now();
    for event in 0.. {
        let due = step * event;
        if due >= WHILE {
            break;
        }
        std::thread::sleep((begun + due).saturating_duration_since(Instant::now()));
        // To and fro, 3 pixels an event, and a little up and down.
        let there = |k: u32, reach: u32| (k % (2 * reach)).abs_diff(reach);
        let [x, y] =
            [there(3 * event, 400), there(event, 60)].map(|x| i32::try_from(x).expect("a small number"));
        screen.point([440 + x, 330 + y]);
    }
    screen.button(1, false);
    screen.settled();
    screen.key(Tap::ESCAPE.0, true);
    let said = process.end();
    say(&format!("{} triangles: {}", 2 * n * n, said.stdout.trim()));
    let report: serde_json::Value = serde_json::from_str(&said.stdout).expect("a report in JSON");
    assert!(report["answered"].as_u64().is_some_and(|answered| answered > 20), "{report}");
}

#[test]
#[ignore = "takes seconds, and says something only on an idle machine in a release build"]
fn dragging_over_100_000_triangles() {
    drag(224);
}

#[test]
#[ignore = "takes seconds, and says something only on an idle machine in a release build"]
fn dragging_over_1_000_000_triangles() {
    drag(708);
}
