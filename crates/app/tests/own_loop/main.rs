//! Windows of applications that are no viewer: a loop of their own, a second window after the first, a close button that
//! is refused, a thread that wakes them.
//!
//! Windows belong to a program's first thread, which test harnesses keep for themselves. So this has none: without
//! arguments it makes the claims below, and for each of them starts itself as the program that the claim is about.

#[cfg(all(unix, feature = "window"))]
mod programs;

#[cfg(all(unix, feature = "window"))]
#[path = "../window"]
mod shared {
    //! What the tests of the viewer have.
    #![allow(dead_code, reason = "each of the two uses a part")]

    pub(super) mod display;
    pub(super) mod process;
    pub(super) mod screen;
    pub(super) mod wait;
}

#[cfg(all(unix, feature = "window"))]
use shared::{display, process, screen, wait};

#[cfg(not(all(unix, feature = "window")))]
fn main() {}

#[cfg(all(unix, feature = "window"))]
fn main() {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    match arguments.as_slice() {
        [first, name] if first == "program" => programs::run(name),
        // As test harnesses do it: a word chooses the claims whose names have it. None is left out otherwise.
        arguments => claims::all(arguments.iter().find(|argument| !argument.starts_with('-'))),
    }
}

#[cfg(all(unix, feature = "window"))]
mod claims {
    use std::time::{Duration, Instant};

    use crate::display::{Display, say};
    use crate::process::{Process, Said, command};
    use crate::programs::{self, BLUE, FRAMES, GREEN, RED};
    use crate::screen::{Screen, Shot};
    use crate::wait::until;

    /// A program under an X server of its own.
    struct Running {
        screen: Screen,
        process: Process,
        _display: Display,
    }

    impl Running {
        fn start(program: &str) -> Option<Self> {
            let display = Display::start()?;
            let folder = std::env::temp_dir();
            let this = std::env::current_exe().expect("a path to this program");
            let process =
                Process::start(command(this, Some(display.name()), &folder).args(["program", program]));
            let mut screen = Screen::connect(display.name());
            screen.find();
            Some(Self { screen, process, _display: display })
        }

        /// Waits for a picture.
        fn shows(&self, what: &str, picture: &Shot) {
            until(what, || (self.screen.shot().as_ref() == Some(picture)).then_some(()));
        }

        /// Waits until the background has a colour.
        fn is_behind(&self, color: u32) {
            until(&format!("a background of {color:06x}"), || {
                (self.screen.part([0, 0], [1, 1])?.pixels == [color]).then_some(())
            });
        }

        fn end(self) -> Said {
            self.process.end()
        }
    }

    pub(super) fn all(word: Option<&String>) {
        let claims: [(&str, fn()); 6] = [
            ("a_program_with_its_own_loop_shows_what_it_would_without_a_window", own_loop),
            ("an_own_loop_draws_nothing_when_nothing_has_changed_and_waits_for_its_frames", own_loop_waits),
            ("an_own_loop_sees_events_and_draws_the_size_that_its_window_gets", own_loop_sees),
            ("a_program_may_refuse_to_close_its_window", refusal),
            ("an_application_may_be_run_again_when_its_window_was_closed", twice),
            ("another_thread_wakes_an_idle_program", woken),
        ];
        for (name, claim) in claims {
            if word.is_none_or(|word| name.contains(word.as_str())) {
                claim();
                say(&format!("{name}: ok"));
            }
        }
    }

    fn own_loop() {
        let Some(running) = Running::start("own-loop") else { return };
        running.shows("the last of the frames", &programs::headless());
        running.screen.close();
        let said = running.end();
        assert_eq!((said.status, said.stderr.as_str()), (Some(0), ""), "{said:?}");
        assert!(said.stdout.starts_with("ended after "), "{said:?}");
    }

    fn own_loop_waits() {
        let Some(running) = Running::start("own-loop") else { return };
        running.shows("the last of the frames", &programs::headless());
        let begun = Instant::now();
        let redraws = running.screen.watch();
        std::thread::sleep(Duration::from_secs(1));
        assert_eq!(redraws.count(), 0, "redraws of what is shown already");
        drop(redraws);
        running.screen.close();
        // Each call of `update` takes a frame's time, so that a loop does not spin.
        let said = running.end();
        let seconds = begun.elapsed().as_secs_f64();
        let calls = said.stdout.trim().rsplit(' ').next().and_then(|calls| calls.parse::<f64>().ok());
        let calls = calls.expect("a count") - f64::from(FRAMES);
        assert!(calls > 5.0 && calls < 62.0 * (seconds + 1.0), "{calls} calls in {seconds} s");
    }

    fn own_loop_sees() {
        let Some(running) = Running::start("own-loop") else { return };
        running.shows("the last of the frames", &programs::headless());
        running.screen.resize([160, 200]);
        running
            .shows("the last of the frames, in a window of another size", &programs::headless_of([160, 200]));
        running.screen.point([80, 100]);
        running.screen.button(1, true);
        running.screen.point([120, 110]);
        running.screen.button(1, false);
        let before = programs::headless_of([160, 200]);
        let after = running.screen.settled();
        assert!(after != before && after.size == before.size, "a drag goes round the cube");
        running.screen.key(crate::screen::keysym::ESCAPE, true);
        assert_eq!(running.end().status, Some(0));
    }

    fn refusal() {
        let Some(running) = Running::start("refuses-once") else { return };
        running.is_behind(RED);
        running.screen.close();
        running.is_behind(GREEN);
        running.screen.close();
        assert_eq!(running.end().status, Some(0));
    }

    fn twice() {
        let Some(mut running) = Running::start("twice") else { return };
        running.is_behind(RED);
        running.screen.close();
        until("the first window's end", || running.screen.is_closed().then_some(()));
        running.screen.find();
        running.is_behind(BLUE);
        running.screen.close();
        let said = running.end();
        assert_eq!((said.status, said.stdout.as_str(), said.stderr.as_str()), (Some(0), "twice\n", ""));
    }

    fn woken() {
        let Some(running) = Running::start("woken") else { return };
        running.is_behind(RED);
        running.is_behind(GREEN);
        running.screen.close();
        assert_eq!(running.end().status, Some(0));
    }
}
