//! The fifth seed: a world of objects, moved by keyboard, in a loop of your own.
//!
//! What to see: standard objects as surface, as wire, or both, the pyramid OABCD in the middle. A spark is created and
//! removed again, second by second, while everything goes on. Choose an object and move, turn, scale, hide or remove
//! it; the camera walks. H shows the keys.
//!
//! What you do to an object that is gone is refused: the action's return value says so, which becomes the line below,
//! and all goes on. (Remove the chosen object, then press an arrow.) A failure of the system, such as no window, is
//! logged, and the call that draws returns it: the loop ends.
//!
//! `--headless OUT.png` is the static mode: a frame, saved.

pub(crate) mod keys;

use std::error::Error;
use std::f64::consts::TAU;
use std::process::ExitCode;

use polosa::{Application, Error as Failure, Settings};
use polosa_examples::{Headless, Help, application, report};
use polosa_math::glam::{DQuat, DVec3};
use polosa_math::{Placement, axis_angle};
use polosa_scene::{Color, MeshKey, Object, ObjectKey, Shape, Show, WorldError};

use self::keys::KEYS;

const SHAPES: [(&str, Show, u32); 8] = [
    ("cube", Show::Surface, 0xd9_8032),
    ("tetrahedron", Show::Wire, 0xe0_d8c8),
    ("torus:48:24", Show::Surface, 0x4a_7fc1),
    ("icosahedron", Show::Both, 0x5c_b8a4),
    ("sphere:icosahedron:3", Show::Surface, 0xc8_5a54),
    ("uv-sphere:16:8", Show::Wire, 0xe0_d8c8),
    ("cone:48", Show::Surface, 0x8a_78c0),
    ("cylinder:24", Show::Both, 0x9a_a85a),
];

pub(crate) struct Scene {
    pub(crate) help: Help,
    /// What the keys act on. It may have been removed.
    pub(crate) chosen: ObjectKey,
    /// What a spark looks like, and the one that is there, if one is.
    octahedron: MeshKey,
    pub(crate) spark: Option<ObjectKey>,
    steps: usize,
    created: usize,
}

pub(crate) fn new() -> Result<(Application, Scene), Box<dyn Error>> {
    let mut app = application("Scene - H: keys", [800, 600]);
    app.settings.background = Settings::default().background;
    let mut mesh = |name: &str| Ok::<_, Box<dyn Error>>(app.world.add_mesh(name.parse::<Shape>()?.mesh()?));
    let (plane, pyramid, octahedron) = (mesh("plane:1")?, mesh("pyramid")?, mesh("octahedron")?);
    let (translation, scale) = (DVec3::new(0.0, -1.05, 0.0), DVec3::new(6.5, 1.0, 6.5));
    let ground = Placement { translation, rotation: DQuat::IDENTITY, scale };
    app.world.add(Object::new(plane).placed(ground).colored(Color::new(70, 74, 80)))?;
    let pyramid = Object::new(pyramid).colored(Color::new(216, 180, 68)).shown(Show::Both);
    let chosen = app.world.add(pyramid)?;
    let mut scene = Scene { help: Help::new(KEYS), chosen, octahedron, spark: None, steps: 0, created: 0 };
    for _ in SHAPES {
        scene.create(&mut app)?;
    }
    scene.chosen = chosen;
    scene.say(&mut app, "the pyramid is chosen; Tab: the next one");
    app.camera.set_position(DVec3::new(0.0, 5.5, 9.5))?;
    app.camera.look_at(DVec3::new(0.0, -0.4, 0.0))?;
    app.light.direction = DVec3::new(0.4, 0.6, 1.0);
    Ok((app, scene))
}

impl Scene {
    /// The next of the standard objects, on a ring around the middle; it becomes the chosen one.
    fn create(&mut self, app: &mut Application) -> Result<(), Box<dyn Error>> {
        let (name, show, color) = SHAPES[self.created % SHAPES.len()];
        let mesh = app.world.add_mesh(name.parse::<Shape>()?.mesh()?);
        let turn =
            axis_angle(DVec3::Y, TAU * (self.created as f64 + 0.5) / SHAPES.len() as f64).unwrap_or_default();
        let object = Object::new(mesh).at(turn.mul_vec3(DVec3::new(0.0, 0.0, 4.2))).shown(show);
        self.chosen = app.world.add(object.colored(Color::from_u32(color)))?;
        self.created += 1;
        self.say(app, &format!("{name} is created"));
        Ok(())
    }

    fn say(&mut self, app: &mut Application, line: &str) {
        line.clone_into(&mut self.help.line);
        app.redraw();
    }

    /// What happens between two frames.
    pub(crate) fn step(&mut self, app: &mut Application) {
        if let Err(refused) = self.come_and_go(app).map_err(Into::into).and_then(|()| self.obey(app)) {
            self.say(app, &refused.to_string());
        }
        self.steps += 1;
    }

    /// A spark over the pyramid, for half of each second.
    fn come_and_go(&mut self, app: &mut Application) -> Result<(), WorldError> {
        if self.steps.is_multiple_of(60) {
            let spark = Object::new(self.octahedron).at(DVec3::new(0.0, 1.7, 0.0)).colored(Color::WHITE);
            let spark = app.world.add(spark)?;
            app.world.scale(spark, DVec3::splat(0.3))?;
            self.spark = Some(spark);
        } else if self.steps % 60 == 30
            && let Some(spark) = self.spark.take()
            // Gone already if it was chosen and removed.
            && app.world.remove(spark).is_some()
        {
            assert_eq!(app.world.move_by(spark, DVec3::Y), Err(WorldError::NoObject));
        }
        Ok(())
    }
}

fn play() -> Result<(), Failure> {
    let (mut app, mut scene) = new().map_err(|error| Failure::file("scene", error.to_string()))?;
    if let Some(headless) = Headless::from_args(KEYS)? {
        return headless.run(&mut app, &mut |app: &mut Application, _| scene.step(app));
    }
    while app.update_with(&mut scene.help)? {
        scene.step(&mut app);
    }
    Ok(())
}

fn main() -> ExitCode {
    report(play())
}
