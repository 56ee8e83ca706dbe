//! What is held and where the pointer is: the sum of all events so far.

use std::time::Duration;

use crate::event::{Button, Event, Key, Modifiers};

/// Two presses within this time make a double click; what most desktops have.
const DOUBLE_CLICK: Duration = Duration::from_millis(400);

/// And no farther apart than this, in pixels along either axis.
const DOUBLE_CLICK_PIXELS: f64 = 4.0;

/// The state of keyboard and mouse.
#[derive(Clone, Debug, Default)]
pub struct Input {
    keys: Vec<Key>,
    /// Keys that went down before the step that is being taken, and those for the next one.
    struck: [Vec<Key>; 2],
    buttons: Vec<Button>,
    modifiers: Modifiers,
    pointer: Option<[f64; 2]>,
    last_press: Option<(Duration, [f64; 2])>,
}

impl Input {
    /// Whether a key is held.
    #[must_use]
    pub fn is_held(&self, key: Key) -> bool {
        self.keys.contains(&key)
    }

    /// Whether a key went down since the last step: for programs that have their own loop, or act in
    /// [`Program::update`](crate::Program::update). A key that is held counts once.
    #[must_use]
    pub fn is_struck(&self, key: Key) -> bool {
        self.struck[0].contains(&key)
    }

    /// Whether a button is held.
    #[must_use]
    pub fn is_button_held(&self, button: Button) -> bool {
        self.buttons.contains(&button)
    }

    /// The modifier keys that are held.
    #[must_use]
    pub const fn modifiers(&self) -> Modifiers {
        self.modifiers
    }

    /// Where the pointer is, in pixels; `None` before it was seen.
    #[must_use]
    pub const fn pointer(&self) -> Option<[f64; 2]> {
        self.pointer
    }

    /// Takes in an event that happened at a time, counted from any one moment. The event that follows from it, if one
    /// does: a double click from a second press.
    pub fn take(&mut self, event: &Event, time: Duration) -> Option<Event> {
        match *event {
            Event::Key { key, pressed, repeat } => {
                hold(&mut self.keys, key, pressed);
                if pressed && !repeat && !self.struck[1].contains(&key) {
                    self.struck[1].push(key);
                }
            }
            Event::Modifiers(modifiers) => self.modifiers = modifiers,
            Event::Motion { at } | Event::Wheel { at, .. } => self.pointer = Some(at),
            Event::Button { button, pressed, at } => {
                hold(&mut self.buttons, button, pressed);
                self.pointer = Some(at);
                if pressed {
                    return self.press(button, at, time);
                }
            }
            Event::Focus(false) => {
                self.keys.clear();
                self.buttons.clear();
                self.modifiers = Modifiers::NONE;
                self.last_press = None;
            }
            _ => {}
        }
        None
    }

    /// A step begins: what was struck before belongs to it.
    pub fn step(&mut self) {
        self.struck[0] = std::mem::take(&mut self.struck[1]);
    }

    fn press(&mut self, button: Button, at: [f64; 2], time: Duration) -> Option<Event> {
        if button != Button::Left {
            self.last_press = None;
            return None;
        }
        let near = |before: [f64; 2]| (0..2).all(|k| (before[k] - at[k]).abs() <= DOUBLE_CLICK_PIXELS);
        let second = self.last_press.take();
        if second.is_some_and(|(then, place)| time.saturating_sub(then) <= DOUBLE_CLICK && near(place)) {
            return Some(Event::DoubleClick { at });
        }
        self.last_press = Some((time, at));
        None
    }
}

fn hold<T: PartialEq>(held: &mut Vec<T>, one: T, pressed: bool) {
    held.retain(|other| *other != one);
    if pressed {
        held.push(one);
    }
}

#[cfg(test)]
mod tests {
    use std::time::Duration;

    use super::Input;
    use crate::event::{Button, Event, Key, Modifiers};

    fn press(at: [f64; 2]) -> Event {
        Event::Button { button: Button::Left, pressed: true, at }
    }

    #[test]
    fn two_presses_make_a_double_click_only_if_soon_and_near() {
        let mut input = Input::default();
        let ms = Duration::from_millis;
        assert_eq!(input.take(&press([9.0, 9.0]), ms(0)), None);
        assert_eq!(input.take(&press([10.0, 9.0]), ms(300)), Some(Event::DoubleClick { at: [10.0, 9.0] }));
        assert_eq!(input.take(&press([10.0, 9.0]), ms(350)), None, "a third press begins anew");
        assert_eq!(input.take(&press([10.0, 9.0]), ms(900)), None, "too late");
        assert_eq!(input.take(&press([20.0, 9.0]), ms(950)), None, "too far");
        let right = Event::Button { button: Button::Right, pressed: true, at: [20.0, 9.0] };
        assert_eq!(input.take(&right, ms(960)), None);
        assert_eq!(input.take(&press([20.0, 9.0]), ms(970)), None, "another button came between");
    }

    #[test]
    fn what_is_held_is_released_when_the_focus_goes() {
        let mut input = Input::default();
        let key = |pressed| Event::Key { key: Key::Char('w'), pressed, repeat: false };
        input.take(&key(true), Duration::ZERO);
        input.take(&key(true), Duration::ZERO);
        input.take(&press([1.0, 2.0]), Duration::ZERO);
        input.take(&Event::Modifiers(Modifiers::SHIFT), Duration::ZERO);
        assert!(input.is_held(Key::Char('w')) && input.is_button_held(Button::Left));
        assert_eq!((input.modifiers(), input.pointer()), (Modifiers::SHIFT, Some([1.0, 2.0])));
        input.take(&Event::Focus(false), Duration::ZERO);
        assert!(!input.is_held(Key::Char('w')) && !input.is_button_held(Button::Left));
        assert_eq!(input.modifiers(), Modifiers::NONE);
    }

    #[test]
    fn a_key_that_went_down_and_up_between_two_steps_is_struck_in_one_step() {
        let mut input = Input::default();
        let feed = |input: &mut Input, pressed, repeat| {
            input.take(&Event::Key { key: Key::Tab, pressed, repeat }, Duration::ZERO);
        };
        feed(&mut input, true, false);
        feed(&mut input, false, false);
        assert!(!input.is_struck(Key::Tab), "its step is still to come");
        input.step();
        assert!(input.is_struck(Key::Tab) && !input.is_held(Key::Tab));
        feed(&mut input, true, true);
        input.step();
        assert!(!input.is_struck(Key::Tab), "a repetition is none");
    }

    #[test]
    fn one_release_releases_a_key_that_repeated() {
        let mut input = Input::default();
        for repeat in [false, true, true] {
            input.take(&Event::Key { key: Key::Up, pressed: true, repeat }, Duration::ZERO);
        }
        input.take(&Event::Key { key: Key::Up, pressed: false, repeat: false }, Duration::ZERO);
        assert!(!input.is_held(Key::Up));
    }
}
