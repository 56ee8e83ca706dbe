//! What the keys do, to the chosen object, to the world and to the camera.

use std::error::Error;
use std::path::Path;

use polosa::Application;
use polosa::event::Key;
use polosa::input::Input;
use polosa_examples::write;
use polosa_math::axis_angle;
use polosa_math::glam::DVec3;
use polosa_scene::{Color, Show, WorldError};

use super::{SHAPES, Scene};

pub(crate) const KEYS: &str = "\
Tab              choose the next object
arrows, PgUp/Dn  move it
X, Y, Z          turn it
+, -             larger, smaller
C, V, O          colour; hide or show; surface, wire, both
N, Del           a new object; remove the chosen one
W A S D, Q R     the camera walks, turns
P                save a picture
H                these keys
Esc              the end";

/// Units of the world, or radians, a step.
const WALK: f64 = 0.06;
const TURN: f64 = 0.03;

impl Scene {
    /// Does what the keys say. The error is that of the action that was refused.
    pub(super) fn obey(&mut self, app: &mut Application) -> Result<(), Box<dyn Error>> {
        let input = app.input().clone();
        walk(app, &input)?;
        self.choose(app, &input)?;

        let (world, one) = (&mut app.world, self.chosen);
        let offset = along(&input, Key::Right, Key::Left, DVec3::X)
            + along(&input, Key::PageUp, Key::PageDown, DVec3::Y)
            + along(&input, Key::Down, Key::Up, DVec3::Z);
        if offset != DVec3::ZERO {
            world.move_by(one, offset * WALK)?;
        }
        for (sign, axis) in [('x', DVec3::X), ('y', DVec3::Y), ('z', DVec3::Z)] {
            if pressed(&input, Key::Char(sign)) {
                world.turn(one, axis_angle(axis, TURN).unwrap_or_default())?;
            }
        }
        for (sign, factor) in [('+', 1.02), ('=', 1.02), ('-', 1.0 / 1.02)] {
            if pressed(&input, Key::Char(sign)) {
                world.scale(one, DVec3::splat(factor))?;
            }
        }
        if input.is_struck(Key::Char('c')) {
            world.recolor(one, Some(Color::from_u32(SHAPES[self.steps % SHAPES.len()].2)))?;
        }
        if input.is_struck(Key::Char('v')) {
            let object = world.get_mut(one).ok_or(WorldError::NoObject)?;
            object.visible = !object.visible;
        }
        if input.is_struck(Key::Char('o')) {
            let shown = world.get(one).ok_or(WorldError::NoObject)?.show;
            let next = match shown {
                Show::Surface => Show::Wire,
                Show::Wire => Show::Both,
                Show::Both => Show::Surface,
            };
            world.show(one, next)?;
        }
        Ok(())
    }

    fn choose(&mut self, app: &mut Application, input: &Input) -> Result<(), Box<dyn Error>> {
        if input.is_struck(Key::Char('n')) {
            self.create(app)?;
        }
        if input.is_struck(Key::Delete) {
            app.world.remove(self.chosen).ok_or(WorldError::NoObject)?;
            self.say(app, "removed; it is still the chosen one: Tab for another");
        }
        if input.is_struck(Key::Tab) {
            // In the order of drawing; after the last, or what is gone, the first.
            let keys: Vec<_> = app.world.objects().map(|(key, _)| key).collect();
            let place = keys.iter().position(|key| *key == self.chosen).map_or(0, |place| place + 1);
            self.chosen = keys.get(place).or(keys.first()).copied().unwrap_or(self.chosen);
            let place = app.world.center(self.chosen).unwrap_or_default();
            self.say(app, &format!("chosen: the object at ({:.1}, {:.1}, {:.1})", place.x, place.y, place.z));
        }
        if input.is_struck(Key::Char('p')) {
            write(Path::new("scene.png"), &app.picture()?)?;
            self.say(app, "saved: scene.png");
        }
        Ok(())
    }
}

/// The camera goes ahead, back and sideways, and turns left and right.
fn walk(app: &mut Application, input: &Input) -> Result<(), Box<dyn Error>> {
    let sign = Key::Char;
    let (ahead, right) = (app.camera.basis().forward(), app.camera.right());
    let step = along(input, sign('w'), sign('s'), ahead) + along(input, sign('d'), sign('a'), right);
    if step != DVec3::ZERO {
        app.camera.set_position(app.camera.position() + step * WALK)?;
    }
    let about = along(input, sign('q'), sign('r'), DVec3::Y);
    if let Some(turn) = axis_angle(about, TURN) {
        app.camera.set_direction(turn.mul_vec3(app.camera.direction()))?;
    }
    Ok(())
}

/// `axis`, its opposite, or nothing, as two keys are pressed.
fn along(input: &Input, more: Key, less: Key, axis: DVec3) -> DVec3 {
    axis * (f64::from(pressed(input, more)) - f64::from(pressed(input, less)))
}

/// Whether a key is held, or was for a moment between two frames.
fn pressed(input: &Input, key: Key) -> bool {
    input.is_held(key) || input.is_struck(key)
}
