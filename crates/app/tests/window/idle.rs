//! A window that nothing happens to does nothing.
#![cfg(target_os = "linux")]

use std::time::Duration;

use crate::session::{Session, Tap};
use crate::wait::until;

const IDLE: Duration = Duration::from_secs(2);

#[test]
fn an_idle_window_draws_nothing_and_its_program_sleeps() {
    let Some(mut session) = Session::of(&["shape:teapot:3"]) else { return };
    session.check("before");
    session.screen.settled();
    let redraws = session.screen.watch();
    let before = session.process.activity();
    std::thread::sleep(IDLE);
    let after = session.process.activity();
    assert_eq!(redraws.count(), 0, "redraws in {IDLE:?}");
    assert_eq!(after.slept, before.slept, "the program woke up");
    assert!(after.time - before.time <= Duration::from_millis(10), "{before:?}, {after:?}");

    // The same means see what there is to be seen.
    session.screen.key(u32::from('x'), true);
    until("a redraw", || (redraws.count() > 0).then_some(()));
    assert!(session.process.activity().slept > after.slept);
}

#[test]
fn after_a_message_has_gone_the_window_is_idle_again() {
    let Some(mut session) = Session::of(&["shape:cube"]) else { return };
    session.check("before");
    let plain = session.screen.settled();
    // Shading twice: as it was, with a message.
    session.screen.key(u32::from('s'), true);
    session.screen.key(u32::from('s'), false);
    session.screen.key(u32::from('s'), true);
    session.screen.key(u32::from('s'), false);
    until("the message", || session.screen.shot().filter(|shot| *shot != plain));
    until("the message's end", || session.screen.shot().filter(|shot| *shot == plain));
    let before = session.process.activity();
    std::thread::sleep(Duration::from_millis(500));
    assert_eq!(session.process.activity().slept, before.slept, "the program woke up");
}

#[test]
fn two_idle_seconds_add_no_frames_to_the_count() {
    let frames = |idle: Duration| {
        let mut session = Session::with(&["shape:cube"], &["--json"], &[])?;
        session.check("before");
        session.screen.settled();
        std::thread::sleep(idle);
        session.tap(Tap::ESCAPE);
        let said = session.end();
        let report: serde_json::Value = serde_json::from_str(&said.stdout).expect("a report in JSON");
        Some(report["frames"].as_u64().expect("a count of frames"))
    };
    let (Some(without), Some(with)) = (frames(Duration::ZERO), frames(IDLE)) else { return };
    // Until a window stands, a frame more or less is a matter of luck.
    assert!(without >= 1 && with.abs_diff(without) <= 3, "{without} frames, with idle time {with}");
}
