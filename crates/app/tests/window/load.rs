//! A big model is read beside the window.

use std::time::{Duration, Instant};

use crate::display::{Display, say};
use crate::models::sheet;
use crate::process::{Process, command};
use crate::screen::Screen;
use crate::session::POLOSA;
use crate::wait::LIMIT;

/// How soon a key is answered while one million triangles are read.
const PROMISE: Duration = Duration::from_millis(50);

/// A machine that does other work, too, is not held to it: this is for machines of which nobody knows how busy they are.
const SLACK: Duration = Duration::from_millis(450);

#[test]
fn a_key_is_answered_while_a_million_triangles_are_read() {
    let Some(display) = Display::start() else { return };
    let folder = tempfile::tempdir().expect("a folder");
    std::fs::write(folder.path().join("big.stl"), sheet(708)).expect("room for 50 MB");
    let mut command = command(POLOSA, Some(display.name()), folder.path());
    let process = Process::start(command.args(["view", "big.stl", "--resolution", "640,480"]));
    let mut screen = Screen::connect(display.name());
    screen.find();

    // The axes come and go at the lower left, where nothing else is drawn until the model is there.
    let (at, size) = ([8, 320], [100, 110]);
    let look = || screen.part(at, size).expect("a window that is open");
    let begun = Instant::now();
    let mut answers = Vec::new();
    while !screen.title().contains("big.stl") {
        let before = look();
        let pressed = Instant::now();
        screen.key(u32::from('x'), true);
        screen.key(u32::from('x'), false);
        while look() == before {
            assert!(pressed.elapsed() < LIMIT, "no answer to key {}", answers.len());
        }
        answers.push(pressed.elapsed());
        // Not in step with anything that the program does by the clock.
        std::thread::sleep(Duration::from_micros(3100 + 1700 * (answers.len() as u64 % 5)));
    }
    drop(process);
    let whole = begun.elapsed();
    answers.sort();
    let (count, longest) = (answers.len(), *answers.last().expect("an answer"));
    let median = answers[count / 2];
    say(&format!(
        "1,002,528 triangles in {whole:.0?}: {count} keys, answered in {median:.1?} (median), {longest:.1?} (longest)"
    ));
    assert!(count >= 3, "only {count} keys while it was read");
    assert!(longest <= PROMISE + SLACK, "the longest answer took {longest:.1?}");
}
