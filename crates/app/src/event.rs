//! What happens to a window, in words of our own: nothing here knows of a windowing system, so that controls can be
//! tested, and programs run, without one.
//!
//! Places are in pixels from the picture's upper left corner, y downward, as everywhere.

use std::path::PathBuf;

/// Something that happened.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub enum Event {
    /// A key went down, or came up again.
    Key {
        /// Which one.
        key: Key,
        /// Whether it went down.
        pressed: bool,
        /// Whether it is held, and counts as pressed once more.
        repeat: bool,
    },
    /// A button of the mouse went down, or came up again.
    Button {
        /// Which one.
        button: Button,
        /// Whether it went down.
        pressed: bool,
        /// Where the pointer is.
        at: [f64; 2],
    },
    /// The left button went down twice in one place, in short succession. It follows the second press.
    DoubleClick {
        /// Where the pointer is.
        at: [f64; 2],
    },
    /// The pointer moved. While a button is held it may be outside of the picture.
    Motion {
        /// Where it is now.
        at: [f64; 2],
    },
    /// The wheel turned.
    Wheel {
        /// By how many notches, positive away from the user; touch pads give fractions.
        notches: f64,
        /// Where the pointer is.
        at: [f64; 2],
    },
    /// The modifier keys that are held have changed.
    Modifiers(Modifiers),
    /// The window has another size, or another scale.
    Resize {
        /// Width and height in pixels.
        size: [u32; 2],
        /// How many pixels a unit of the desktop has: 2 on a screen of twice the usual density.
        scale: f64,
    },
    /// A file was dropped on the window.
    Drop(PathBuf),
    /// The keyboard's focus came or went. When it goes, all keys and buttons count as released.
    Focus(bool),
    /// The user asked to close the window. Unless a program handles this, the application ends.
    Close,
}

/// A key, by what is printed on it.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[non_exhaustive]
pub enum Key {
    /// A letter, in lower case, a digit or another sign. A key of another script than Latin counts as the letter that
    /// an American keyboard has in its place.
    Char(char),
    /// Enter, on the number pad too.
    Enter,
    /// Escape.
    Escape,
    /// Tab.
    Tab,
    /// The space bar.
    Space,
    /// The arrow to the left.
    Left,
    /// The arrow to the right.
    Right,
    /// The arrow upward.
    Up,
    /// The arrow downward.
    Down,
    /// A function key, 1 to 35.
    F(u8),
    /// Page up.
    PageUp,
    /// Page down.
    PageDown,
    /// Home.
    Home,
    /// End.
    End,
    /// Backspace.
    Backspace,
    /// Delete.
    Delete,
    /// Any other key.
    Other,
}

/// A button of the mouse.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[non_exhaustive]
pub enum Button {
    /// The left one.
    Left,
    /// The middle one, or the wheel when it is pressed.
    Middle,
    /// The right one.
    Right,
}

/// Which modifier keys are held.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, Default)]
pub struct Modifiers {
    /// Either shift key.
    pub shift: bool,
    /// Either control key; on macOS the command key, too.
    pub control: bool,
    /// Either alt key.
    pub alt: bool,
}

impl Modifiers {
    /// None.
    pub const NONE: Self = Self { shift: false, control: false, alt: false };
    /// Shift alone.
    pub const SHIFT: Self = Self { shift: true, ..Self::NONE };
    /// Control alone.
    pub const CONTROL: Self = Self { control: true, ..Self::NONE };
    /// Alt alone.
    pub const ALT: Self = Self { alt: true, ..Self::NONE };
}

/// What a program says of an event that it was told of.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, Default)]
pub enum Handled {
    /// It is done with; nobody else hears of it.
    Yes,
    /// The application's own controls have their turn.
    #[default]
    No,
}
