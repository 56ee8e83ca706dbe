//! The fourth seed: the tetrahedron again, turned by the mouse, and inflated in part.
//!
//! What to see: while the left button is down, the pointer's place *is* the angles, in whole degrees: half a turn from
//! side to side, and half a turn from top to bottom. So the solid jumps when it is first touched. Each triangle has one
//! depth, the sum of its corners', which is enough here, where nothing is hollow and nothing pierces anything; E shows
//! what polosa itself draws, and the two differ at the rims alone.

use std::error::Error;
use std::process::ExitCode;

use polosa::canvas::Canvas;
use polosa::event::{Button, Event, Handled, Key};
use polosa::{Application, Program};
use polosa_examples::tetrahedron::{Solid, light_as_seed, place_as_seed};
use polosa_examples::{application, redrawn, run, struck};
use polosa_math::reference::camera::angles::{Seed, pointed};
use polosa_raster::reference::{Coverage, Hidden, Methods};
use polosa_scene::reference::Shading;
use polosa_scene::{Object, ObjectKey};

pub(crate) const KEYS: &str = "\
1    the tetrahedron
2    its white face split 5 times
3    all four split 5 times: a sphere
4    all four split twice
E    the seed's picture, or polosa's
H    these keys
Esc  the end";

/// How many times each face is split, by key.
const LEVELS: [[u32; 4]; 4] = [[0; 4], [5, 0, 0, 0], [5; 4], [2; 4]];

pub(crate) struct MouseTetrahedron {
    degrees: [i64; 2],
    exact: bool,
    shown: usize,
    /// What the keys choose from, as the seed draws it and as polosa does.
    choice: Vec<(Solid, ObjectKey)>,
}

pub(crate) fn new() -> Result<(Application, MouseTetrahedron), Box<dyn Error>> {
    let mut app = application("Tetrahedron", [600; 2]);
    light_as_seed(&mut app);
    let mut choice = Vec::new();
    for levels in LEVELS {
        let solid = Solid::new(levels)?;
        let mesh = app.world.add_mesh(solid.mesh()?);
        choice.push((solid, app.world.add(Object::new(mesh))?));
    }
    Ok((app, MouseTetrahedron { degrees: [0, 0], exact: false, shown: 0, choice }))
}

impl MouseTetrahedron {
    /// Has the world show what polosa's picture is to show: nothing, while the seed's is on show.
    fn arrange(&self, app: &mut Application) {
        for (number, (_, key)) in self.choice.iter().enumerate() {
            // The objects are never removed.
            let _ = place_as_seed(app, *key, Seed::S3, self.degrees);
            if let Some(object) = app.world.get_mut(*key) {
                object.visible = self.exact && number == self.shown;
            }
        }
    }
}

impl Program for MouseTetrahedron {
    fn animated(&self) -> bool {
        false
    }

    fn start(&mut self, app: &mut Application) {
        self.arrange(app);
    }

    fn event(&mut self, app: &mut Application, event: &Event) -> Handled {
        match (event, struck(event)) {
            (_, Some(Key::Char('e'))) => self.exact = !self.exact,
            (_, Some(Key::Char(sign @ '1'..='4'))) => self.shown = sign as usize - '1' as usize,
            (Event::Button { button: Button::Left, pressed: true, at } | Event::Motion { at }, _)
                if app.input().is_button_held(Button::Left) =>
            {
                let ([x, y], [width, height]) = (at.map(|x| x as i32), app.size());
                self.degrees = pointed(x, y, width, height);
            }
            (Event::Resize { .. }, _) => {}
            _ => return Handled::No,
        }
        self.arrange(app);
        redrawn(app)
    }

    fn overlay(&mut self, _app: &Application, canvas: &mut Canvas<'_>) {
        if self.exact {
            return;
        }
        let (solid, _) = &self.choice[self.shown];
        let placed = solid.placed(Seed::S3, self.degrees, canvas);
        let methods = Methods { coverage: Coverage::SameSide, hidden: Hidden::Sum };
        solid.fill(canvas, &placed, methods, Some(Shading::Power22));
    }
}

fn main() -> Result<ExitCode, Box<dyn Error>> {
    let (app, program) = new()?;
    Ok(run(app, program, KEYS))
}
