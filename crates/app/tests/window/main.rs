//! Real windows: the program `polosa` under an X server of the test's own (Xvfb), with real key and mouse events, and
//! screenshots that must equal, byte for byte, what the library draws without a window after the same events.
//!
//! ```text
//!   display.rs   an X server          screen.rs   hands and eyes: XTEST, GetImage       xdnd.rs   dropping files
//!   process.rs   a running program    session.rs  a window and its twin without one     wait.rs   until, not for
//!
//!   mouse.rs keys.rs files.rs ends.rs idle.rs load.rs drag.rs   the tests
//! ```
//!
//! They need Xvfb (Debian: `xvfb`) and the libraries that windows need under X11, which the program loads when it opens
//! one: libX11, libX11-xcb, libXcursor, libXi, libxcb, libxkbcommon and libxkbcommon-x11 (Debian: `libx11-xcb1`,
//! `libxcursor1`, `libxi6`, `libxkbcommon-x11-0`, which bring the others). Without Xvfb each test prints a notice and
//! passes; where the variable `CI` is set it fails.
//!
//! Pictures of a comparison that fails are in `target/tmp/window`. With `POLOSA_WINDOW_PICTURES=FOLDER` those of all
//! others are written, too: look at them.

#![cfg(all(unix, feature = "window"))]

mod display;
mod drag;
mod ends;
mod files;
mod idle;
mod keys;
mod load;
mod models;
mod mouse;
mod process;
mod screen;
mod session;
mod wait;
mod xdnd;
