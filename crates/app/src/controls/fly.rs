//! Flying through a scene: held keys move the camera, the mouse looks around.
//!
//! ```text
//!     Q  W  E          down  forward  up
//!     A  S  D          left  back     right         Shift: faster     wheel: the speed itself
//! ```
//!
//! Forward is where the camera looks, left and right are its own, up and down those of the world. With Control or Alt
//! held, keys are commands, and nothing moves.

use core::time::Duration;

use polosa_math::glam::DVec3;
use polosa_math::unit;

use super::navigation::{Navigation, Stage, is_place};
use super::{orbit, zoom};
use crate::event::{Button, Event, Handled, Key};
use crate::input::Input;
use crate::view::radius;

/// The speed at first: four seconds from one end of the scene to the other.
const SPEED: f64 = 0.25;

/// The least and the greatest speed.
const SPEEDS: [f64; 2] = [1e-4, 10.0];

/// How much faster it goes with Shift.
const FASTER: f64 = 4.0;

/// The most that the first step counts for: the key was pressed during it, and not before it.
const FIRST_STEP: Duration = Duration::from_micros(16_667);

/// The keys, and where they lead: to the right, upward, forward.
const KEYS: [(char, [f64; 3]); 6] = [
    ('w', [0.0, 0.0, 1.0]),
    ('s', [0.0, 0.0, -1.0]),
    ('d', [1.0, 0.0, 0.0]),
    ('a', [-1.0, 0.0, 0.0]),
    ('e', [0.0, 1.0, 0.0]),
    ('q', [0.0, -1.0, 0.0]),
];

/// The state of flying.
#[derive(Clone, Debug)]
pub struct Fly {
    speed: f64,
    /// Where the pointer was, while the mouse looks around.
    looking: Option<[f64; 2]>,
    moving: bool,
}

impl Default for Fly {
    fn default() -> Self {
        Self { speed: SPEED, looking: None, moving: false }
    }
}

impl Fly {
    /// The speed, in diagonals of the scene's box a second.
    #[must_use]
    pub const fn speed(&self) -> f64 {
        self.speed
    }

    /// Sets it, from 0.0001 to 10. What is not a number changes nothing.
    pub fn set_speed(&mut self, speed: f64) {
        if !speed.is_nan() {
            self.speed = speed.clamp(SPEEDS[0], SPEEDS[1]);
        }
    }

    /// Whether keys are held that move the camera, so that time must go on.
    #[must_use]
    pub fn is_moving(&self, input: &Input) -> bool {
        path(input) != DVec3::ZERO
    }

    /// Ends what is being done with the mouse.
    pub fn let_go(&mut self) {
        self.looking = None;
        self.moving = false;
    }

    /// Follows an event, after the input has taken it in. [`Handled::Yes`] if it was for the flight: also for its keys,
    /// which then are no commands.
    pub fn event(
        &mut self,
        event: &Event,
        input: &Input,
        navigation: &mut Navigation,
        stage: &mut Stage<'_>,
    ) -> Handled {
        match *event {
            Event::Key { key, .. }
                if !is_command(input) && KEYS.iter().any(|(k, _)| Key::Char(*k) == key) =>
            {
                Handled::Yes
            }
            Event::Button { button: Button::Left, pressed: true, at } => {
                self.looking = Some(at);
                Handled::Yes
            }
            Event::Button { button: Button::Left, pressed: false, at } if self.looking.is_some() => {
                self.look(at, navigation, stage);
                self.looking = None;
                Handled::Yes
            }
            Event::Motion { at } => {
                // The release may have been for somebody else.
                self.looking = self.looking.filter(|_| input.is_button_held(Button::Left));
                if self.looking.is_none() {
                    return Handled::No;
                }
                self.look(at, navigation, stage);
                Handled::Yes
            }
            Event::Wheel { notches, .. } => {
                self.set_speed(self.speed / zoom::factor(notches));
                Handled::Yes
            }
            Event::Focus(false) => {
                self.let_go();
                Handled::No
            }
            _ => Handled::No,
        }
    }

    fn look(&mut self, at: [f64; 2], navigation: &mut Navigation, stage: &mut Stage<'_>) {
        if let Some(from) = self.looking
            && is_place(at)
            && at != from
        {
            if is_place(from) {
                let [right, upward] = stage.angles(from, at);
                navigation.look_by(stage, -right, upward);
            }
            self.looking = Some(at);
        }
    }

    /// Moves the camera by what the held keys say, for the time `step`. The first step of a movement counts for a
    /// sixtieth of a second at most, however long nothing had happened before.
    pub fn update(
        &mut self,
        navigation: &mut Navigation,
        stage: &mut Stage<'_>,
        input: &Input,
        step: Duration,
    ) {
        let moving = self.is_moving(input);
        let goes_on = core::mem::replace(&mut self.moving, moving);
        let Some(path) = unit(path(input)) else { return };
        let step = if goes_on { step } else { step.min(FIRST_STEP) };
        let faster = if input.modifiers().shift { FASTER } else { 1.0 };
        let diagonal = 2.0 * radius(&navigation.bounds(stage.world));
        let distance = self.speed * faster * diagonal * step.as_secs_f64();
        let basis = stage.camera.basis();
        let up = orbit::axis(stage.camera, navigation.up());
        let along = basis.right() * path.x + up * path.y + basis.forward() * path.z;
        navigation.move_by(stage, along * distance);
    }
}

/// Where the held keys lead: keys against each other cancel.
fn path(input: &Input) -> DVec3 {
    if is_command(input) {
        return DVec3::ZERO;
    }
    let held = KEYS.iter().filter(|(key, _)| input.is_held(Key::Char(*key)));
    held.fold(DVec3::ZERO, |sum, (_, path)| sum + DVec3::from_array(*path))
}

fn is_command(input: &Input) -> bool {
    input.modifiers().control || input.modifiers().alt
}

#[cfg(test)]
mod tests {
    use core::time::Duration;

    use polosa_math::glam::DVec3;
    use polosa_scene::{Camera, Light, Object, World, shape};

    use super::Fly;
    use crate::controls::navigation::{Navigation, POLE, Stage};
    use crate::event::{Button, Event, Handled, Key, Modifiers};
    use crate::input::Input;

    struct Rig {
        world: World,
        camera: Camera,
        light: Light,
        navigation: Navigation,
        input: Input,
        fly: Fly,
    }

    impl Rig {
        /// At (0, 0, 10) before a cube, with +Y upward.
        fn new() -> Self {
            let mut world = World::new();
            let mesh = world.add_mesh(shape::cube());
            world.add(Object::new(mesh)).unwrap();
            Self {
                world,
                camera: Camera::new(),
                light: Light::default(),
                navigation: Navigation::default(),
                input: Input::default(),
                fly: Fly::default(),
            }
        }

        fn feed(&mut self, event: &Event) -> Handled {
            self.input.take(event, Duration::ZERO);
            self.with(|fly, navigation, input, stage| fly.event(event, input, navigation, stage))
        }

        fn with<R>(&mut self, act: impl FnOnce(&mut Fly, &mut Navigation, &Input, &mut Stage<'_>) -> R) -> R {
            let mut stage = Stage {
                world: &self.world,
                camera: &mut self.camera,
                light: &mut self.light,
                size: [400, 300],
                scale: 1.0,
                trackball: false,
            };
            act(&mut self.fly, &mut self.navigation, &self.input, &mut stage)
        }

        fn key(&mut self, key: char, pressed: bool) -> Handled {
            self.feed(&Event::Key { key: Key::Char(key), pressed, repeat: false })
        }

        fn update(&mut self, milliseconds: u64) {
            let step = Duration::from_millis(milliseconds);
            self.with(|fly, navigation, input, stage| fly.update(navigation, stage, input, step));
        }

        /// Where a key leads within a second.
        fn path(&mut self, key: char) -> DVec3 {
            assert_eq!(self.key(key, true), Handled::Yes);
            self.update(1);
            let before = self.camera.position();
            self.update(1000);
            self.key(key, false);
            self.update(1000);
            self.camera.position() - before
        }
    }

    #[test]
    fn keys_lead_where_they_say_at_a_quarter_of_the_scene_a_second() {
        let mut rig = Rig::new();
        let pace = 0.25 * 12_f64.sqrt();
        for (key, along) in [
            ('w', DVec3::NEG_Z),
            ('s', DVec3::Z),
            ('a', DVec3::NEG_X),
            ('d', DVec3::X),
            ('q', DVec3::NEG_Y),
            ('e', DVec3::Y),
        ] {
            let path = rig.path(key);
            assert!((path - along * pace).length() < 1e-12, "{key}: {path}");
        }
        rig.feed(&Event::Modifiers(Modifiers::SHIFT));
        assert!((rig.path('w') - DVec3::NEG_Z * 4.0 * pace).length() < 1e-12);
        rig.feed(&Event::Modifiers(Modifiers::NONE));
        rig.feed(&Event::Wheel { notches: 2.0, at: [0.0; 2] });
        assert!((rig.path('w').length() / (1.44 * pace) - 1.0).abs() < 1e-12);
    }

    #[test]
    fn two_keys_are_no_faster_than_one_and_against_each_other_they_cancel() {
        let mut rig = Rig::new();
        rig.key('d', true);
        rig.key('w', true);
        rig.update(1);
        let before = rig.camera.position();
        rig.update(1000);
        let path = rig.camera.position() - before;
        assert!((path.length() / (0.25 * 12_f64.sqrt()) - 1.0).abs() < 1e-12 && path.y == 0.0, "{path}");
        rig.key('w', false);
        assert!(rig.fly.is_moving(&rig.input));
        rig.key('a', true);
        assert!(!rig.fly.is_moving(&rig.input));
    }

    #[test]
    fn commands_and_lost_focus_move_nothing_and_the_first_step_is_short() {
        let mut rig = Rig::new();
        let before = rig.camera.position();
        rig.feed(&Event::Modifiers(Modifiers::CONTROL));
        assert_eq!(rig.key('q', true), Handled::No);
        rig.update(250);
        assert_eq!(rig.camera.position(), before);
        rig.feed(&Event::Modifiers(Modifiers::NONE));
        rig.feed(&Event::Focus(false));
        rig.update(250);
        assert_eq!(rig.camera.position(), before);
        rig.key('w', true);
        rig.update(250);
        let first = (rig.camera.position() - before).length();
        assert!(first > 0.0 && first < 0.02, "as long as a frame: {first}");
    }

    #[test]
    fn looking_around_keeps_the_place_and_stops_at_the_poles() {
        let mut rig = Rig::new();
        let before = rig.camera.position();
        let at = [200.0, 150.0];
        rig.feed(&Event::Button { button: Button::Left, pressed: true, at });
        rig.feed(&Event::Motion { at });
        assert_eq!(rig.camera, Camera::new(), "no jump");
        rig.feed(&Event::Motion { at: [380.0, 150.0] });
        assert_eq!(rig.camera.position(), before);
        assert!((rig.camera.direction() - DVec3::X).length() < 1e-12, "to the right");
        assert!((rig.navigation.pivot() - DVec3::new(10.0, 0.0, 10.0)).length() < 1e-9, "still ahead");
        for y in [-9000.0, 9000.0] {
            rig.feed(&Event::Motion { at: [380.0, y] });
            let [heading, pitch] = rig.navigation.heading_pitch(&rig.camera);
            assert!((pitch + POLE * y.signum()).abs() < 1e-9);
            assert!((heading - 1.5 * std::f64::consts::PI).abs() < 1e-6);
        }
        rig.feed(&Event::Button { button: Button::Left, pressed: false, at: [380.0, 9000.0] });
        let still = rig.camera;
        rig.feed(&Event::Motion { at });
        assert_eq!(rig.camera, still);
    }

    #[test]
    fn speeds_stay_speeds() {
        let mut rig = Rig::new();
        for notches in [1e9, -1e9, f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
            rig.feed(&Event::Wheel { notches, at: [0.0; 2] });
            assert!((1e-4..=10.0).contains(&rig.fly.speed()));
        }
    }
}
