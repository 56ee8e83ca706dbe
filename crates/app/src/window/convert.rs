//! winit's events in our words.

use winit::event::{DeviceEvent, ElementState, MouseButton, MouseScrollDelta, WindowEvent};
use winit::keyboard::{Key as OsKey, KeyCode, NamedKey, PhysicalKey};
use winit::window::Window as OsWindow;

use crate::event::{Button, Event, Key, Modifiers};

/// How many pixels of a touch pad's scrolling make a notch, on a screen of usual density.
const PIXELS_PER_NOTCH: f64 = 50.0;

/// Where the pointer is: winit tells it only when it moves.
#[derive(Clone, Debug, Default)]
pub(super) struct Pointer {
    at: [f64; 2],
    /// Keys that are down, and what they counted as when they went down: with other modifiers they may be other signs
    /// when they come up.
    down: Vec<(PhysicalKey, Key)>,
    /// Whether what the wheel does next is that its button comes up.
    echo: bool,
}

impl Pointer {
    /// Takes note of what a device does, told before the window hears of it.
    ///
    /// Under X11 a wheel without an axis of its own, as remote desktops and XTEST have it, is the buttons 4 to 7. winit
    /// tells of a notch when such a button goes down, and of another one when it comes up again.
    pub(super) fn device_event(&mut self, event: &DeviceEvent) {
        if let DeviceEvent::Button { button, state } = *event
            && cfg!(all(unix, not(target_os = "macos")))
        {
            self.echo = (4..=7).contains(&button) && state == ElementState::Released;
        }
    }

    /// What a key counts as that goes down, or comes up again.
    fn counted(&mut self, physical: PhysicalKey, key: Key, pressed: bool) -> Key {
        let before = self.down.iter().position(|(place, _)| *place == physical);
        let before = before.map(|place| self.down.swap_remove(place).1);
        if pressed {
            self.down.push((physical, key));
            key
        } else {
            before.unwrap_or(key)
        }
    }

    /// An event in our words, if we have any for it.
    pub(super) fn event(&mut self, event: &WindowEvent, window: &OsWindow) -> Option<Event> {
        Some(match event {
            WindowEvent::CursorMoved { position, .. } => {
                self.at = [position.x, position.y];
                Event::Motion { at: self.at }
            }
            WindowEvent::MouseInput { state, button, .. } => {
                let button = match button {
                    MouseButton::Left => Button::Left,
                    MouseButton::Middle => Button::Middle,
                    MouseButton::Right => Button::Right,
                    _ => return None,
                };
                Event::Button { button, pressed: *state == ElementState::Pressed, at: self.at }
            }
            WindowEvent::MouseWheel { delta: MouseScrollDelta::LineDelta(..), .. }
                if std::mem::take(&mut self.echo) =>
            {
                return None;
            }
            WindowEvent::MouseWheel { delta, .. } => {
                let notches = match delta {
                    MouseScrollDelta::LineDelta(_, lines) => f64::from(*lines),
                    MouseScrollDelta::PixelDelta(by) => by.y / (PIXELS_PER_NOTCH * window.scale_factor()),
                };
                Event::Wheel { notches, at: self.at }
            }
            // Keys that were down when the focus came are no presses.
            WindowEvent::KeyboardInput { is_synthetic: true, event, .. } if event.state.is_pressed() => {
                return None;
            }
            WindowEvent::KeyboardInput { event, .. } => {
                let (key, pressed) = (key(&event.logical_key, event.physical_key), event.state.is_pressed());
                Event::Key {
                    key: self.counted(event.physical_key, key, pressed),
                    pressed,
                    repeat: event.repeat,
                }
            }
            WindowEvent::ModifiersChanged(modifiers) => {
                let state = modifiers.state();
                let command = cfg!(target_os = "macos") && state.super_key();
                Event::Modifiers(Modifiers {
                    shift: state.shift_key(),
                    control: state.control_key() || command,
                    alt: state.alt_key(),
                })
            }
            WindowEvent::Resized(size) => {
                Event::Resize { size: [size.width, size.height], scale: window.scale_factor() }
            }
            WindowEvent::ScaleFactorChanged { scale_factor, .. } => {
                Event::Resize { size: window.inner_size().into(), scale: *scale_factor }
            }
            WindowEvent::DroppedFile(path) => Event::Drop(path.clone()),
            WindowEvent::Focused(focus) => Event::Focus(*focus),
            WindowEvent::CloseRequested => Event::Close,
            _ => return None,
        })
    }
}

/// A key by what is printed on it, or, where that is no sign of ASCII, by its place.
fn key(logical: &OsKey, physical: PhysicalKey) -> Key {
    let named = match logical {
        OsKey::Named(named) => named,
        OsKey::Character(text) => {
            let mut signs = text.chars();
            return match (signs.next(), signs.next()) {
                (Some(sign), None) if sign.is_ascii_graphic() => Key::Char(sign.to_ascii_lowercase()),
                _ => in_place(physical),
            };
        }
        _ => return in_place(physical),
    };
    match named {
        NamedKey::Enter => Key::Enter,
        NamedKey::Escape => Key::Escape,
        NamedKey::Tab => Key::Tab,
        NamedKey::Space => Key::Space,
        NamedKey::ArrowLeft => Key::Left,
        NamedKey::ArrowRight => Key::Right,
        NamedKey::ArrowUp => Key::Up,
        NamedKey::ArrowDown => Key::Down,
        NamedKey::PageUp => Key::PageUp,
        NamedKey::PageDown => Key::PageDown,
        NamedKey::Home => Key::Home,
        NamedKey::End => Key::End,
        NamedKey::Backspace => Key::Backspace,
        NamedKey::Delete => Key::Delete,
        NamedKey::F1 => Key::F(1),
        NamedKey::F2 => Key::F(2),
        NamedKey::F3 => Key::F(3),
        NamedKey::F4 => Key::F(4),
        NamedKey::F5 => Key::F(5),
        NamedKey::F6 => Key::F(6),
        NamedKey::F7 => Key::F(7),
        NamedKey::F8 => Key::F(8),
        NamedKey::F9 => Key::F(9),
        NamedKey::F10 => Key::F(10),
        NamedKey::F11 => Key::F(11),
        NamedKey::F12 => Key::F(12),
        _ => Key::Other,
    }
}

/// The letter that an American keyboard has where this key is.
fn in_place(physical: PhysicalKey) -> Key {
    const LETTERS: [KeyCode; 26] = [
        KeyCode::KeyA,
        KeyCode::KeyB,
        KeyCode::KeyC,
        KeyCode::KeyD,
        KeyCode::KeyE,
        KeyCode::KeyF,
        KeyCode::KeyG,
        KeyCode::KeyH,
        KeyCode::KeyI,
        KeyCode::KeyJ,
        KeyCode::KeyK,
        KeyCode::KeyL,
        KeyCode::KeyM,
        KeyCode::KeyN,
        KeyCode::KeyO,
        KeyCode::KeyP,
        KeyCode::KeyQ,
        KeyCode::KeyR,
        KeyCode::KeyS,
        KeyCode::KeyT,
        KeyCode::KeyU,
        KeyCode::KeyV,
        KeyCode::KeyW,
        KeyCode::KeyX,
        KeyCode::KeyY,
        KeyCode::KeyZ,
    ];
    let letter = |code| (b'a'..).zip(LETTERS).find(|(_, other)| *other == code);
    match physical {
        PhysicalKey::Code(code) => {
            letter(code).map_or(Key::Other, |(letter, _)| Key::Char(char::from(letter)))
        }
        PhysicalKey::Unidentified(_) => Key::Other,
    }
}

#[cfg(test)]
mod tests {
    use winit::keyboard::{Key as OsKey, KeyCode, NamedKey, PhysicalKey};

    use super::{Pointer, key};
    use crate::event::Key;

    #[test]
    fn what_went_down_comes_up_whatever_sign_it_is_by_then() {
        let (mut pointer, one) = (Pointer::default(), PhysicalKey::Code(KeyCode::Digit1));
        assert_eq!(pointer.counted(one, Key::Char('1'), true), Key::Char('1'));
        assert_eq!(pointer.counted(one, Key::Char('!'), false), Key::Char('1'));
        assert_eq!(pointer.counted(one, Key::Char('!'), false), Key::Char('!'), "it was not down");
    }

    #[test]
    fn keys_are_named_by_their_sign_and_of_other_scripts_by_their_place() {
        let at = PhysicalKey::Code;
        let sign = |text: &str| OsKey::Character(text.into());
        assert_eq!(key(&sign("q"), at(KeyCode::KeyA)), Key::Char('q'));
        assert_eq!(key(&sign("E"), at(KeyCode::KeyE)), Key::Char('e'));
        assert_eq!(
            key(&sign("у"), at(KeyCode::KeyE)),
            Key::Char('e'),
            "the Cyrillic letter in the place of E"
        );
        assert_eq!(key(&sign("1"), at(KeyCode::Numpad1)), Key::Char('1'));
        assert_eq!(key(&OsKey::Named(NamedKey::F12), at(KeyCode::F12)), Key::F(12));
        assert_eq!(key(&sign("é"), at(KeyCode::Digit2)), Key::Other);
    }
}
