//! The third seed: a sphere made from an octahedron, in all hues, turned and lit with the mouse.
//!
//! What to see: drag with the left button, and the sphere's axes turn, one degree a pixel; with the right one, and the
//! light goes round it, as fast. A triangle's hue is the seed's own pseudo-longitude of its middle before all turning,
//! even in the cosine of the angle and not in the angle, so that red and cyan are too wide, and what lies between them
//! is too narrow; T shows true longitudes. Its value is the cosine between it and the light: black, where the light does
//! not reach.

use std::error::Error;
use std::f64::consts::FRAC_PI_4;
use std::process::ExitCode;

use polosa::canvas::Canvas;
use polosa::event::{Button, Event, Handled, Key};
use polosa::{Application, Program};
use polosa_examples::{application, redrawn, run, struck};
use polosa_math::glam::{DQuat, DVec3};
use polosa_math::reference::rotation::{Turned, Turning};
use polosa_math::{axis_angle, turn, unit};
use polosa_raster::reference::{Coverage, Hidden, Methods, ZBuffer, draw_screen};
use polosa_raster::{Depth, State, Target};
use polosa_scene::reference::{Sphere, hue};

pub(crate) const KEYS: &str = "\
Up, Down  more or less saturation
L         with the light, or without
T         true longitudes, or the seed's
H         these keys
Esc       the end";

const RADIUS: f64 = 200.0;
const LEVELS: u32 = 5;

/// One of the 8,192 triangles.
struct Facet {
    /// On the sphere of radius 1, turned as the seed turns them at the start.
    corners: [DVec3; 3],
    normal: DVec3,
    /// The middle, before any turning.
    middle: [f64; 3],
}

pub(crate) struct HueSphere {
    facets: Vec<Facet>,
    /// The axes to the right, down and towards the viewer: X, Y and Z = X × Y.
    axes: Turned,
    /// Where the light comes from, in the world.
    pub(crate) light: DVec3,
    lit: bool,
    longitude: bool,
    pub(crate) saturation: f64,
    pointer: [f64; 2],
}

pub(crate) fn new() -> Result<(Application, HueSphere), Box<dyn Error>> {
    let eighth = |axis| axis_angle(axis, FRAC_PI_4).unwrap_or_default();
    let turns = [DVec3::X, DVec3::Y, DVec3::Z].map(eighth);
    let start = turns.into_iter().chain(turns).fold(DQuat::IDENTITY, turn);
    let mesh = Sphere::Octant.mesh(LEVELS)?;
    let facet = |triangle: &[u32; 3]| {
        let before = triangle.map(|k| DVec3::from_array(mesh.positions()[k as usize].map(f64::from)));
        let corners @ [a, b, c] = before.map(|corner| start.mul_vec3(corner));
        let normal = unit((b - a).cross(c - a)).unwrap_or_default();
        Facet { corners, normal, middle: ((before[0] + before[1] + before[2]) / 3.0).to_array() }
    };
    let third = (1.0_f64 / 3.0).sqrt();
    let program = HueSphere {
        facets: mesh.triangles().iter().map(facet).collect(),
        axes: Turned::new(Turning::AxesF32),
        light: DVec3::new(third, -third, third),
        lit: true,
        longitude: false,
        saturation: 1.0,
        pointer: [0.0; 2],
    };
    Ok((application("Sphere", [640, 480]), program))
}

impl HueSphere {
    pub(crate) fn axes(&self) -> [DVec3; 3] {
        let m = self.axes.matrix();
        [0, 1, 2].map(|k| DVec3::new(m[0][k], m[1][k], m[2][k]))
    }

    /// The light goes round by `dx` in the plane of Z and X, then by `dy` in that of Z and Y.
    fn turn_light(&mut self, dx: f64, dy: f64) {
        let [x, y, z] = self.axes();
        for (to, angle) in [(x, dx), (y, dy)] {
            // From Z towards `to`, about the axis across.
            self.light = axis_angle(z.cross(to), angle).map_or(self.light, |by| by.mul_vec3(self.light));
        }
        self.light = unit(self.light).unwrap_or(self.light);
    }

    fn color(&self, facet: &Facet, toward: DVec3) -> u32 {
        let seeds = hue::pseudo_longitude(facet.middle);
        let degrees = hue::longitude(facet.middle).filter(|_| self.longitude).unwrap_or(seeds);
        hue::from_hsv(hue::whole(degrees), self.saturation, facet.normal.dot(toward).max(0.0)).to_u32()
    }
}

impl Program for HueSphere {
    fn animated(&self) -> bool {
        false
    }

    fn event(&mut self, app: &mut Application, event: &Event) -> Handled {
        match (event, struck(event)) {
            (_, Some(Key::Up)) => self.saturation = (self.saturation + 0.05).min(1.0),
            (_, Some(Key::Down)) => self.saturation = (self.saturation - 0.05).max(0.0),
            (_, Some(Key::Char('l'))) => self.lit = !self.lit,
            (_, Some(Key::Char('t'))) => self.longitude = !self.longitude,
            (Event::Button { pressed: true, at, .. }, _) => self.pointer = *at,
            (Event::Motion { at }, _) => {
                let degrees = [0, 1].map(|k| (at[k] - self.pointer[k]) / app.scale());
                let [dx, dy] = degrees.map(f64::to_radians);
                self.pointer = *at;
                match [Button::Left, Button::Right].map(|button| app.input().is_button_held(button)) {
                    [true, _] => self.axes.step(dx, dy),
                    [_, true] => self.turn_light(dx, dy),
                    _ => return Handled::No,
                }
            }
            _ => return Handled::No,
        }
        redrawn(app)
    }

    /// What faces the viewer, in any order: nothing of a sphere hides another part of its front.
    fn overlay(&mut self, _app: &Application, canvas: &mut Canvas<'_>) {
        let [x, y, z] = self.axes();
        let toward = if self.lit { self.light } else { z };
        let ([width, height], radius) = (canvas.dimensions(), RADIUS * canvas.scale());
        let seen: Vec<&Facet> = self.facets.iter().filter(|facet| facet.normal.dot(z) > 0.0).collect();
        let place = |p: DVec3| {
            [f64::from(width) / 2.0 + radius * p.dot(x), f64::from(height) / 2.0 + radius * p.dot(y), 0.0]
        };
        let placed: Vec<_> = seen.iter().map(|facet| facet.corners.map(place)).collect();
        let color = |k: u32| self.color(seen[k as usize], toward);
        let methods = Methods { coverage: Coverage::Strips, hidden: Hidden::Order };
        let target = Target::new(canvas.pixels_mut(), Depth::None, width, height, width as usize);
        let Ok(mut target) = target else { return };
        draw_screen(&mut target, &mut ZBuffer::new(), methods, &State::default(), &placed, color);
    }
}

fn main() -> Result<ExitCode, Box<dyn Error>> {
    let (app, program) = new()?;
    Ok(run(app, program, KEYS))
}
