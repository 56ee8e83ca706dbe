//! How the program ends, and how it begins where it cannot.

use std::fs;

use crate::display::Display;
use crate::process::{Process, Said, command};
use crate::session::{Hold, POLOSA, Session, Tap};
use crate::wait::until;

const MODEL: &str = "shape:cube";

/// A good end says nothing.
fn assert_good(said: &Said) {
    assert_eq!((said.status, said.stdout.as_str(), said.stderr.as_str()), (Some(0), "", ""));
}

/// A failure is one line that begins with the program's name and holds these words.
fn assert_line(said: &Said, words: &[&str]) {
    assert_eq!(said.stderr.lines().count(), 1, "{said:?}");
    assert!(said.stderr.starts_with("polosa: "), "{said:?}");
    words.iter().for_each(|word| assert!(said.stderr.contains(word), "no {word:?} in {said:?}"));
}

#[test]
fn escape_ends_the_program() {
    let Some(mut session) = Session::of(&[MODEL]) else { return };
    session.tap(Tap::ESCAPE);
    assert_good(&session.end());
}

#[test]
fn ctrl_q_ends_the_program() {
    let Some(mut session) = Session::of(&[MODEL]) else { return };
    session.type_sign('q');
    session.type_sign('x');
    session.check("after Q without Ctrl, which ends nothing");
    session.screen.key(Hold::CONTROL.0, true);
    session.screen.key(u32::from('q'), true);
    assert_good(&session.end());
}

#[test]
fn closing_the_window_ends_the_program() {
    let Some(session) = Session::of(&[MODEL]) else { return };
    session.screen.close();
    assert_good(&session.end());
}

#[test]
fn a_file_that_is_not_there_or_no_model_ends_with_one_line() {
    let Some(display) = Display::start() else { return };
    let folder = tempfile::tempdir().expect("a folder");
    fs::write(folder.path().join("broken.obj"), crate::models::BROKEN).expect("a file");
    for name in ["missing.obj", "broken.obj"] {
        let said =
            Process::start(command(POLOSA, Some(display.name()), folder.path()).args(["view", name])).end();
        assert_eq!(said.status, Some(1), "{said:?}");
        assert_line(&said, &[name]);
    }
}

#[test]
fn a_desktop_that_goes_away_ends_the_program_with_a_line() {
    let Some(mut session) = Session::of(&[MODEL]) else { return };
    session.check("before the end of the desktop");
    session.display.stop();
    let said = session.end();
    assert_eq!(said.status, Some(1), "{said:?}");
    assert!(!said.stderr.trim().is_empty() && !said.stderr.contains("panicked"), "{said:?}");
}

#[test]
fn without_a_display_the_picture_goes_to_a_file() {
    let folder = tempfile::tempdir().expect("a folder");
    let said = Process::start(command(POLOSA, None, folder.path()).args(["view", MODEL])).end();
    assert_line(&said, &["DISPLAY"]);
    assert_picture(&said, folder.path());
}

#[test]
fn a_display_that_nobody_serves_is_named() {
    let folder = tempfile::tempdir().expect("a folder");
    let said = Process::start(command(POLOSA, Some(":32123"), folder.path()).args(["view", MODEL])).end();
    assert_line(&said, &["no window can be opened"]);
    assert_picture(&said, folder.path());
}

#[cfg(target_os = "linux")]
#[test]
fn where_a_library_of_windows_is_missing_it_is_named_and_the_picture_goes_to_a_file() {
    let Some(display) = Display::start() else { return };
    // The others are looked for where they were when the program was built, if they were there.
    let libraries = ["libxcb.so.1", "libxkbcommon.so.0", "libxkbcommon-x11.so.0"];
    for library in libraries {
        let folder = tempfile::tempdir().expect("a folder");
        let shadows = folder.path().join("shadows");
        fs::create_dir(&shadows).expect("a folder");
        // What is found first is no library: for the loader as good as none. Where a compiler's files are installed there
        // is another name, without a number, that is tried, too.
        let (stem, _) = library.split_once(".so").expect("a library's name");
        for name in [library, &format!("{stem}.so")] {
            fs::write(shadows.join(name), "no library").expect("a file");
        }
        let mut command = command(POLOSA, Some(display.name()), folder.path());
        let said = Process::start(command.env("LD_LIBRARY_PATH", &shadows).args(["view", MODEL])).end();
        // libxcb is needed by the others, and winit does not tell by which.
        let word = if library == "libxcb.so.1" { "what they need" } else { stem };
        assert_line(&said, &["no window can be opened", word, "install"]);
        assert_picture(&said, folder.path());
    }
}

/// The program ended well, and told where the picture is.
fn assert_picture(said: &Said, folder: &std::path::Path) {
    assert_eq!(said.status, Some(0), "{said:?}");
    let path = folder.join("polosa.png");
    assert_eq!(fs::canonicalize(said.stdout.trim()).ok(), fs::canonicalize(&path).ok(), "{said:?}");
    let image = image::open(&path).expect("a picture").into_rgb8();
    assert_eq!(image.dimensions(), (1024, 768));
    let first = image.get_pixel(0, 0);
    assert!(image.pixels().any(|pixel| pixel != first), "something is seen");
}

#[test]
fn the_window_is_gone_before_the_program_is() {
    let Some(mut session) = Session::of(&[MODEL]) else { return };
    session.tap(Tap::ESCAPE);
    until("the window to close", || session.screen.is_closed().then_some(()));
    assert_good(&session.end());
}
