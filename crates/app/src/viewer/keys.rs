//! Which key does what: one table, from which the help is made, too.
//!
//! The keys are those of F3D where it has them. No key has two meanings in one mode: a test looks at every pair.

use crate::event::{Key, Modifiers};

/// What keys mean depends on how the camera moves.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, Default)]
#[non_exhaustive]
pub enum Mode {
    /// Round the model.
    #[default]
    Orbit,
    /// Through it: W, A, S, D, Q and E move, and no letter alone is a command.
    Fly,
}

/// What a viewer can be told by a key.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[non_exhaustive]
pub enum Command {
    /// See the model from the front.
    Front,
    /// From the right.
    Right,
    /// From above.
    Top,
    /// From a corner.
    Isometric,
    /// Perspective or parallel projection.
    Parallel,
    /// Camera, light and model as they were at first.
    Reset,
    /// Surfaces, with edges, edges alone.
    Edges,
    /// The floor's grid.
    Grid,
    /// The directions of the world's axes.
    Axes,
    /// All sides, without back faces, without front faces.
    Cull,
    /// Lit by the faces' planes, or not at all.
    Shading,
    /// The next method for deciding which pixels a triangle covers.
    Fill,
    /// How far away things are, instead of their colours.
    Depth,
    /// Whether the light goes with the camera or stays in the world.
    Light,
    /// Turning by itself.
    Turntable,
    /// What the keys do.
    Help,
    /// Times and counts.
    Statistics,
    /// Sliders for heading and pitch.
    Sliders,
    /// The picture to a file.
    Screenshot,
    /// The files once more.
    Reload,
    /// Turns the model: steps to the right, steps upward.
    Turn(i8, i8),
    /// Moves the camera round the model: steps to the right, steps upward.
    Orbit(i8, i8),
    /// Nearer, or farther away.
    Zoom(i8),
    /// Moves what is seen: steps to the right, steps upward.
    Pan(i8, i8),
    /// Moves the light round the model: steps to the right, steps upward.
    MoveLight(i8, i8),
    /// The point in the middle of the picture becomes the pivot.
    Pivot,
    /// To the other mode.
    Fly,
    /// The end.
    Quit,
}

/// A key's meaning.
#[derive(Clone, Copy, Debug)]
pub struct Binding {
    /// Where it has this meaning; `None`: in every mode.
    pub mode: Option<Mode>,
    /// The key.
    pub key: Key,
    /// With exactly these.
    pub modifiers: Modifiers,
    /// What it does.
    pub command: Command,
    /// The keys' names and what they do, in the help; those that have none are told of by another's line.
    pub help: Option<[&'static str; 2]>,
}

const fn bind(mode: Option<Mode>, key: Key, modifiers: Modifiers, command: Command) -> Binding {
    Binding { mode, key, modifiers, command, help: None }
}

const fn orbit(key: char, command: Command, name: &'static str, about: &'static str) -> Binding {
    let help = Some([name, about]);
    Binding { help, ..bind(Some(Mode::Orbit), Key::Char(key), Modifiers::NONE, command) }
}

impl Binding {
    const fn told(self, name: &'static str, about: &'static str) -> Self {
        Self { help: Some([name, about]), ..self }
    }
}

/// All keys.
pub const BINDINGS: &[Binding] = &[
    orbit('1', Command::Front, "1 3 7 9", "front, right, top, corner"),
    bind(Some(Mode::Orbit), Key::Char('3'), Modifiers::NONE, Command::Right),
    bind(Some(Mode::Orbit), Key::Char('7'), Modifiers::NONE, Command::Top),
    bind(Some(Mode::Orbit), Key::Char('9'), Modifiers::NONE, Command::Isometric),
    orbit('5', Command::Parallel, "5", "perspective or parallel"),
    bind(None, Key::Enter, Modifiers::NONE, Command::Reset).told("Enter", "camera, model as at first"),
    orbit('e', Command::Edges, "E", "edges: over faces, alone"),
    orbit('g', Command::Grid, "G", "grid"),
    orbit('x', Command::Axes, "X", "axes"),
    orbit('c', Command::Cull, "C", "culling: back, front faces"),
    orbit('s', Command::Shading, "S", "shading"),
    orbit('f', Command::Fill, "F", "fill methods"),
    orbit('d', Command::Depth, "D", "depth"),
    orbit('l', Command::Light, "L", "light: camera's or world's"),
    orbit('t', Command::Turntable, "T", "turntable"),
    orbit('v', Command::Sliders, "V", "sliders"),
    orbit('i', Command::Statistics, "I", "statistics"),
    orbit('h', Command::Help, "H, F1", "this help"),
    bind(None, Key::F(1), Modifiers::NONE, Command::Help),
    bind(None, Key::F(12), Modifiers::NONE, Command::Screenshot).told("F12", "screenshot"),
    bind(None, Key::Char('r'), Modifiers::CONTROL, Command::Reload).told("Ctrl+R", "reload"),
    bind(None, Key::Left, Modifiers::NONE, Command::Turn(-1, 0)).told("arrows", "turn the model"),
    bind(None, Key::Right, Modifiers::NONE, Command::Turn(1, 0)),
    bind(None, Key::Up, Modifiers::NONE, Command::Turn(0, 1)),
    bind(None, Key::Down, Modifiers::NONE, Command::Turn(0, -1)),
    bind(None, Key::Left, Modifiers::SHIFT, Command::Orbit(-1, 0)).told("Shift+arrows", "go round it"),
    bind(None, Key::Right, Modifiers::SHIFT, Command::Orbit(1, 0)),
    bind(None, Key::Up, Modifiers::SHIFT, Command::Orbit(0, 1)),
    bind(None, Key::Down, Modifiers::SHIFT, Command::Orbit(0, -1)),
    bind(None, Key::Left, Modifiers::CONTROL, Command::Pan(-1, 0)).told("Ctrl+arrows", "pan"),
    bind(None, Key::Right, Modifiers::CONTROL, Command::Pan(1, 0)),
    bind(None, Key::Up, Modifiers::CONTROL, Command::Pan(0, 1)),
    bind(None, Key::Down, Modifiers::CONTROL, Command::Pan(0, -1)),
    bind(None, Key::Left, Modifiers::ALT, Command::MoveLight(-1, 0)).told("Alt+arrows", "move the light"),
    bind(None, Key::Right, Modifiers::ALT, Command::MoveLight(1, 0)),
    bind(None, Key::Up, Modifiers::ALT, Command::MoveLight(0, 1)),
    bind(None, Key::Down, Modifiers::ALT, Command::MoveLight(0, -1)),
    bind(None, Key::Home, Modifiers::NONE, Command::Pivot).told("Home", "pivot in the middle"),
    bind(None, Key::PageUp, Modifiers::NONE, Command::Zoom(1)).told("PgUp PgDn", "nearer, farther"),
    bind(None, Key::PageDown, Modifiers::NONE, Command::Zoom(-1)),
    bind(None, Key::Tab, Modifiers::NONE, Command::Fly).told("Tab", "fly: WASD, Q down, E up"),
    bind(Some(Mode::Fly), Key::Escape, Modifiers::NONE, Command::Fly),
    bind(Some(Mode::Orbit), Key::Escape, Modifiers::NONE, Command::Quit).told("Esc, Ctrl+Q", "quit"),
    bind(None, Key::Char('q'), Modifiers::CONTROL, Command::Quit),
];

/// What the mouse does, for the help.
pub const MOUSE: &[[&str; 2]] = &[
    ["left drag", "go round, in fly mode look"],
    ["middle, Shift+left", "pan"],
    ["wheel", "zoom to the pointer"],
    ["right drag", "move the light"],
    ["double click", "set the pivot"],
];

/// What a key means in a mode.
#[must_use]
pub fn command(mode: Mode, key: Key, modifiers: Modifiers) -> Option<Command> {
    // Whether a sign is had with Shift is the keyboard's affair: on a French one all digits are.
    let shift = modifiers.shift && !matches!(key, Key::Char(sign) if !sign.is_ascii_alphabetic());
    let modifiers = Modifiers { shift, ..modifiers };
    let meant = |binding: &&Binding| {
        binding.mode.is_none_or(|only| only == mode) && binding.key == key && binding.modifiers == modifiers
    };
    BINDINGS.iter().find(meant).map(|binding| binding.command)
}

#[cfg(test)]
mod tests {
    use super::{BINDINGS, Command, Mode, command};
    use crate::event::{Key, Modifiers};

    #[test]
    fn no_key_has_two_meanings_in_one_mode() {
        for (i, a) in BINDINGS.iter().enumerate() {
            for b in &BINDINGS[i + 1..] {
                let one_mode = a.mode.is_none() || b.mode.is_none() || a.mode == b.mode;
                let same = one_mode && a.key == b.key && a.modifiers == b.modifiers;
                assert!(!same, "{a:?} and {b:?}");
            }
        }
    }

    #[test]
    fn in_fly_mode_no_letter_alone_is_a_command() {
        for letter in 'a'..='z' {
            for modifiers in [Modifiers::NONE, Modifiers::SHIFT] {
                assert_eq!(command(Mode::Fly, Key::Char(letter), modifiers), None, "{letter}");
            }
        }
        assert_eq!(command(Mode::Fly, Key::Char('q'), Modifiers::CONTROL), Some(Command::Quit));
    }

    #[test]
    fn digits_count_whether_they_are_had_with_shift_or_without() {
        for modifiers in [Modifiers::NONE, Modifiers::SHIFT] {
            assert_eq!(command(Mode::Orbit, Key::Char('7'), modifiers), Some(Command::Top));
        }
        assert_eq!(command(Mode::Orbit, Key::Char('e'), Modifiers::SHIFT), None);
    }

    #[test]
    fn escape_ends_the_mode_or_the_program() {
        assert_eq!(command(Mode::Fly, Key::Escape, Modifiers::NONE), Some(Command::Fly));
        assert_eq!(command(Mode::Orbit, Key::Escape, Modifiers::NONE), Some(Command::Quit));
    }

    #[test]
    fn every_command_is_in_the_help() {
        for binding in BINDINGS {
            let kind = std::mem::discriminant(&binding.command);
            let views = [Command::Right, Command::Top, Command::Isometric];
            let told =
                BINDINGS.iter().any(|b| b.help.is_some() && std::mem::discriminant(&b.command) == kind);
            assert!(told || views.contains(&binding.command), "{:?}", binding.command);
        }
    }
}
