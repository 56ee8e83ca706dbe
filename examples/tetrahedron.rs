//! The first seed: a tetrahedron with two sliders, and the stages in which it learns to be seen.
//!
//! What to see: turn it in stage 2, and blue stays on top whatever lies before it, since it comes last in the list;
//! stage 3 puts that right; stage 4 shades, too darkly; stage 5 takes the screen's curve into account; stage 6 splits
//! each triangle into four, four times, and moves the corners out to a sphere. All of it by the seed's own formulas,
//! which look at the upper left corner of each pixel, and where two triangles meet draw both; E shows what polosa
//! itself draws.
//!
//! Drag the sliders: below the heading, at the side the pitch. y runs down the screen, z towards you.

use std::error::Error;
use std::process::ExitCode;

use polosa::canvas::Canvas;
use polosa::controls::slider::{Slider, SliderSide};
use polosa::event::{Event, Handled, Key};
use polosa::{Application, Program};
use polosa_examples::tetrahedron::{Solid, light_as_seed, place_as_seed, wire};
use polosa_examples::{application, label, redrawn, run, struck};
use polosa_math::reference::camera::angles::Seed;
use polosa_raster::reference::{Coverage, Hidden, Methods};
use polosa_scene::reference::Shading;
use polosa_scene::{self as scene, Color, Object, ObjectKey, Show};

pub(crate) const KEYS: &str = "\
Space  the next stage
E      the seed's picture, or polosa's
H      these keys
Esc    the end";

/// A stage of the guide.
struct Stage {
    name: &'static str,
    /// How what lies behind is hidden; `None`: wire, which hides nothing.
    hidden: Option<Hidden>,
    shading: Option<Shading>,
    /// Which of the solids.
    solid: usize,
}

const fn stage(name: &'static str, hidden: Option<Hidden>, shading: Option<Shading>, solid: usize) -> Stage {
    Stage { name, hidden, shading, solid }
}

const STAGES: [Stage; 6] = [
    stage("1 wire", None, None, 0),
    stage("2 filled, in the list's order", Some(Hidden::Order), None, 0),
    stage("3 z-buffer", Some(Hidden::Barycentric), None, 0),
    stage("4 shaded, codes as light", Some(Hidden::Barycentric), Some(Shading::Naive), 0),
    stage("5 shaded, exponent 2.4", Some(Hidden::Barycentric), Some(Shading::Power24), 0),
    stage("6 inflated", Some(Hidden::Barycentric), Some(Shading::Power24), 1),
];

pub(crate) struct Tetrahedron {
    heading: Slider,
    pitch: Slider,
    /// Which of the stages, from 0.
    stage: usize,
    exact: bool,
    /// The tetrahedron, and the sphere that it becomes; for polosa's picture both are objects, too.
    solids: [Solid; 2],
    objects: [ObjectKey; 2],
}

pub(crate) fn new() -> Result<(Application, Tetrahedron), Box<dyn Error>> {
    let mut app = application("Tetrahedron", [400; 2]);
    light_as_seed(&mut app);
    let solids = [Solid::new([0; 4])?, Solid::new([4; 4])?];
    let [plain, inflated] = solids.each_ref().map(Solid::mesh);
    let meshes = [app.world.add_mesh(plain?), app.world.add_mesh(inflated?)];
    let [plain, inflated] = meshes.map(|mesh| app.world.add(Object::new(mesh)));
    let program = Tetrahedron {
        heading: Slider::new(SliderSide::Below, [0.0, 360.0], 180.0),
        pitch: Slider::new(SliderSide::Right, [-90.0, 90.0], 0.0),
        stage: 0,
        exact: false,
        solids,
        objects: [plain?, inflated?],
    };
    Ok((app, program))
}

impl Tetrahedron {
    /// The sliders of the seed know whole degrees.
    fn degrees(&self) -> [i64; 2] {
        [&self.heading, &self.pitch].map(|slider| slider.value().round() as i64)
    }

    /// Has the world show what polosa's picture is to show: nothing, while the seed's is on show.
    fn arrange(&self, app: &mut Application) {
        let stage = &STAGES[self.stage];
        app.style.shading = stage.shading.map_or(scene::Shading::Unlit, |_| scene::Shading::Flat);
        for (number, key) in self.objects.into_iter().enumerate() {
            // The objects are never removed.
            let _ = place_as_seed(app, key, Seed::S0, self.degrees());
            if let Some(object) = app.world.get_mut(key) {
                object.visible = self.exact && number == stage.solid;
                object.show = if stage.hidden.is_some() { Show::Surface } else { Show::Wire };
                object.color = stage.hidden.is_none().then_some(Color::WHITE);
            }
        }
    }
}

impl Program for Tetrahedron {
    fn animated(&self) -> bool {
        false
    }

    fn start(&mut self, app: &mut Application) {
        self.arrange(app);
    }

    fn event(&mut self, app: &mut Application, event: &Event) -> Handled {
        let (size, scale) = (app.size(), app.scale());
        let dragged = [&mut self.heading, &mut self.pitch].map(|slider| slider.event(event, size, scale));
        match struck(event) {
            Some(Key::Space) => self.stage = (self.stage + 1) % STAGES.len(),
            Some(Key::Char('e')) => self.exact = !self.exact,
            _ if dragged.contains(&Handled::Yes) || matches!(event, Event::Resize { .. }) => {}
            _ => return Handled::No,
        }
        self.arrange(app);
        redrawn(app)
    }

    fn overlay(&mut self, _app: &Application, canvas: &mut Canvas<'_>) {
        let Stage { name, hidden, shading, solid } = STAGES[self.stage];
        if !self.exact {
            let solid = &self.solids[solid];
            let placed = solid.placed(Seed::S0, self.degrees(), canvas);
            match hidden {
                None => wire(canvas, &placed),
                Some(hidden) => {
                    let methods = Methods { coverage: Coverage::Barycentric, hidden };
                    solid.fill(canvas, &placed, methods, shading);
                }
            }
        }
        self.heading.draw(canvas);
        self.pitch.draw(canvas);
        let whose = if self.exact { ": polosa's picture" } else { "" };
        label(canvas, [canvas.pixels_of(12.0); 2], &format!("{name}{whose}"));
    }
}

fn main() -> Result<ExitCode, Box<dyn Error>> {
    let (app, program) = new()?;
    Ok(run(app, program, KEYS))
}
