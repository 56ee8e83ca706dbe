//! The second seed: a camera, and a cube in wire that turns before it, half a turn a second.
//!
//! What to see: three perspectives that look the same, from the angle of view, from planes, and without a far plane; a
//! parallel projection as large, and the seed's own, half a unit to each side, which the cube is too large for. It draws
//! three lines a triangle and cuts their ends off to whole pixels, so that corners tremble; its camera looks down with
//! axes shorter than 1, so that the cube is a tenth too small. E: as polosa draws it. Text is 2D, over what is 3D.

use std::error::Error;
use std::f64::consts::PI;
use std::process::ExitCode;
use std::time::Duration;

use polosa::canvas::embedded_graphics::prelude::{Drawable, Point, Primitive};
use polosa::canvas::embedded_graphics::primitives::{Line, PrimitiveStyle};
use polosa::canvas::{Canvas, rgb};
use polosa::event::{Event, Handled, Key};
use polosa::{Application, Program};
use polosa_examples::{application, label, redrawn, run, struck};
use polosa_math::glam::{DQuat, DVec3};
use polosa_math::reference::algebra::{Real, Rows, product, project};
use polosa_math::reference::camera::s1;
use polosa_math::{Placement, Planes, axis_angle, unit};
use polosa_scene::{Color, FieldOfView, Mesh, Object, ObjectKey, Projection, Shading, Show, shape};

pub(crate) const KEYS: &str = "\
P    the next projection
C    culling of back faces, on or off
E    the seed's picture, or polosa's
H    these keys
Esc  the end";

const EYE: DVec3 = DVec3::new(3.0, 4.0, 8.0);
const NAMES: [&str; 5] =
    ["perspective, 70 across", "perspective, planes", "perspective, no far", "parallel", "parallel, +-1/2"];

#[derive(Default)]
pub(crate) struct ViewCube {
    cube: ObjectKey,
    triangles: Vec<[DVec3; 3]>,
    /// About +Y by the negative angle.
    pub(crate) angle: f64,
    turned: DQuat,
    culled: bool,
    exact: bool,
    /// Which of the names.
    projection: usize,
}

pub(crate) fn new() -> Result<(Application, ViewCube), Box<dyn Error>> {
    let mut app = application("3D View", [400, 300]);
    (app.settings.frame_rate, app.settings.show_rate) = (60.0, true);
    // Without edges of its own, so that all sides of triangles are: three lines each, as in the seed.
    let mesh = Mesh::new(shape::cube().positions().to_vec(), shape::cube().triangles().to_vec())?;
    let mesh = app.world.add_mesh(mesh);
    let cube = app.world.add(Object::new(mesh))?;
    app.camera.set_position(EYE)?;
    app.camera.look_at(DVec3::ZERO)?;
    (app.style.edge_color, app.style.shading) = (Color::WHITE, Shading::Unlit);
    let triangles = app.world.faces(cube).into_iter().flatten().collect();
    Ok((app, ViewCube { cube, triangles, ..ViewCube::default() }))
}

/// The numbers of a projection: the seed's matrix, and polosa's lens, for a picture of this aspect.
fn lens(which: usize, aspect: f64) -> (Rows<f64, 4>, Projection) {
    let (fov, near, far) = (70_f64.to_radians(), 1.0, 1000.0);
    let (half, high) = (<f64 as Real>::tan(fov / 2.0), <f64 as Real>::tan(fov / 2.0) / aspect);
    let planes = |x: f64, y: f64| Planes { left: -x, right: x, bottom: -y, top: y, near, far };
    let angle = |far| Projection::Perspective { fov: FieldOfView::Horizontal(fov), near, far };
    let parallel = |x: f64, y: f64| {
        (s1::orthographic([-x, x], [-y, y], near, far), Projection::OrthographicPlanes(planes(x, y)))
    };
    match which {
        0 => (s1::perspective(fov, aspect, near, far), angle(far)),
        1 => (
            s1::perspective_planes([-half, half], [-high, high], near, far),
            Projection::PerspectivePlanes(planes(half, high)),
        ),
        2 => (s1::perspective_infinite(fov, aspect, near), angle(f64::INFINITY)),
        3 => parallel(half * EYE.length(), high * EYE.length()), // as large as the cube's middle
        _ => parallel(0.5, 0.5),
    }
}

impl ViewCube {
    /// The seed's 3D queue: per triangle three lines, from whole pixel to whole pixel.
    fn wire(&self, canvas: &mut Canvas<'_>) {
        let ([width, height], size) = (canvas.dimensions(), canvas.dimensions().map(f64::from));
        let mut camera = s1::Camera::<f64>::new(width, height);
        camera.set_location(EYE.to_array());
        camera.set_direction(unit(-EYE).unwrap_or_default().to_array());
        let projection = lens(self.projection, size[0] / size[1]).0;
        let matrix = product(&s1::viewport(size), &product(&projection, &camera.view()));
        let style = PrimitiveStyle::with_stroke(rgb(Color::WHITE), 1);
        for triangle in &self.triangles {
            let [a, b, c] = triangle.map(|corner| {
                let [x, y, _] = project(&matrix, self.turned.mul_vec3(corner).to_array());
                Point::new(x as i32, y as i32)
            });
            let [u, v] = [b - a, c - a];
            // y runs down: what is counter-clockwise to the viewer has a negative area.
            if self.culled && u.x * v.y - u.y * v.x >= 0 {
                continue;
            }
            for (from, to) in [(a, b), (b, c), (c, a)] {
                let Ok(()) = Line::new(from, to).into_styled(style).draw(canvas);
            }
        }
    }
}

impl Program for ViewCube {
    fn event(&mut self, app: &mut Application, event: &Event) -> Handled {
        match struck(event) {
            Some(Key::Char('p')) => self.projection = (self.projection + 1) % NAMES.len(),
            Some(Key::Char('c')) => self.culled = !self.culled,
            Some(Key::Char('e')) => self.exact = !self.exact,
            _ => return Handled::No,
        }
        redrawn(app)
    }

    fn update(&mut self, app: &mut Application, step: Duration) {
        self.angle += step.as_secs_f64() * PI;
        self.turned = axis_angle(DVec3::Y, -self.angle).unwrap_or_default();
        // None of these lenses is refused.
        let _ = app.camera.set_projection(lens(self.projection, app.camera.aspect()).1);
        if let Some(cube) = app.world.get_mut(self.cube) {
            cube.placement = Placement { rotation: self.turned, ..Placement::IDENTITY };
            cube.visible = self.exact;
            // Black faces hide the sides that are behind them.
            cube.show = if self.culled { Show::Both } else { Show::Wire };
            cube.color = Some(if self.culled { Color::BLACK } else { Color::WHITE });
        }
    }

    fn overlay(&mut self, _app: &Application, canvas: &mut Canvas<'_>) {
        if !self.exact {
            self.wire(canvas);
        }
        // The 2D queue.
        let text = NAMES[self.projection].to_owned() + if self.exact { ", polosa's" } else { "" };
        let lower = canvas.dimensions()[1] as i32 - canvas.pixels_of(26.0);
        label(canvas, [canvas.pixels_of(12.0), lower], &text);
    }
}

fn main() -> Result<ExitCode, Box<dyn Error>> {
    let (app, program) = new()?;
    Ok(run(app, program, KEYS))
}
