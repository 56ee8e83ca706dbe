//! The tetrahedron of two seeds, S0 and S3: its triangles in pixels, drawn by their methods, and the same exactly.

use polosa::Application;
use polosa::canvas::Canvas;
use polosa_math::glam::DVec3;
use polosa_math::reference::algebra::{cross, normalized};
use polosa_math::reference::camera::angles::{self, Seed};
use polosa_math::{Placement, axis_angle, turn};
use polosa_raster::reference::{Corner, Methods, ZBuffer, draw_screen};
use polosa_raster::{Depth, Sample, Space, State, Target};
use polosa_scene::reference::Shading;
use polosa_scene::shape::{ShapeError, seed_tetrahedron};
use polosa_scene::{
    Camera, Color, Colors, Light, LightSpace, Mesh, MeshError, ObjectKey, Projection, WorldError,
};

/// Both seeds look at the upper left corner of each pixel.
pub const CORNER: Sample = Sample { x: 0, y: 0 };

/// Coloured triangles in the seed's own axes: x to the right, y **down**, z towards the observer.
#[derive(Clone, Debug)]
pub struct Solid {
    triangles: Vec<[[f64; 3]; 3]>,
    colors: Vec<u32>,
}

impl Solid {
    /// The faces white PQR, red PQS, green RSP and blue RSQ, each split and inflated so many times.
    ///
    /// # Errors
    ///
    /// When that makes too many triangles.
    pub fn new(levels: [u32; 4]) -> Result<Self, ShapeError> {
        let faces = [Color::WHITE, Color::new(255, 0, 0), Color::new(0, 255, 0), Color::new(0, 0, 255)];
        let mut solid = Self { triangles: Vec::new(), colors: Vec::new() };
        for (level, face) in levels.into_iter().zip(faces) {
            let mesh = seed_tetrahedron(level)?;
            let Colors::Face(colors) = mesh.colors() else { continue };
            let of_face = mesh.triangles().iter().zip(colors).filter(|(_, color)| **color == face);
            for (triangle, color) in of_face {
                solid.triangles.push(triangle.map(|k| mesh.positions()[k as usize].map(f64::from)));
                solid.colors.push(color.to_u32());
            }
        }
        Ok(solid)
    }

    /// The same as a mesh.
    ///
    /// # Errors
    ///
    /// None.
    pub fn mesh(&self) -> Result<Mesh, MeshError> {
        let positions = self.triangles.as_flattened().iter().map(|p| p.map(|x| x as f32)).collect();
        let indices = (0..self.triangles.len() as u32).map(|t| [3 * t, 3 * t + 1, 3 * t + 2]).collect();
        let colors = self.colors.iter().map(|code| Color::from_u32(*code)).collect();
        Mesh::new(positions, indices)?.with_colors(Colors::Face(colors))
    }

    /// Where the corners come to lie in a picture, turned by heading and pitch in whole degrees.
    #[must_use]
    pub fn placed(&self, seed: Seed, degrees: [i64; 2], canvas: &Canvas<'_>) -> Vec<[Corner; 3]> {
        let [heading, pitch] = degrees.map(|angle| (angle as f64).to_radians());
        let rotation = angles::rotation(seed, heading, pitch);
        let ([width, height], scale) = (canvas.dimensions(), canvas.scale());
        let place = |p: [f64; 3]| angles::pixels(seed, &rotation, p.map(|x| x * scale), width, height);
        self.triangles.iter().map(|triangle| triangle.map(place)).collect()
    }

    /// Fills placed triangles on black; `shading`: by the cosine between a triangle and the picture.
    pub fn fill(
        &self,
        canvas: &mut Canvas<'_>,
        placed: &[[Corner; 3]],
        methods: Methods,
        shading: Option<Shading>,
    ) {
        let color = |k: u32| {
            let code = self.colors[k as usize];
            shading.map_or(code, |shading| shading.shade_color(code, cosine(placed[k as usize]) as f32))
        };
        let state = State { sample: CORNER, ..State::default() };
        let Some(mut target) = black(canvas) else { return };
        draw_screen(&mut target, &mut ZBuffer::new(), methods, &state, placed, color);
    }
}

/// How much light falls on a triangle from behind the camera, on either side.
fn cosine([a, b, c]: [Corner; 3]) -> f64 {
    let minus = |p: Corner, q: Corner| [p[0] - q[0], p[1] - q[1], p[2] - q[2]];
    normalized(cross(minus(b, a), minus(c, a)))[2].abs()
}

/// Draws the sides of placed triangles in white on black.
pub fn wire(canvas: &mut Canvas<'_>, placed: &[[Corner; 3]]) {
    let vertices = placed.as_flattened().iter().map(|[x, y, _]| [*x as f32, *y as f32, 0.5, 1.0]);
    let vertices: Vec<_> = vertices.collect();
    let sides = (0..vertices.len() as u32).step_by(3).flat_map(|a| [[a, a + 1], [a + 1, a + 2], [a + 2, a]]);
    let state = State { space: Space::Screen, sample: CORNER, ..State::default() };
    let Some(mut target) = black(canvas) else { return };
    target.lines(&state, &vertices, &sides.collect::<Vec<_>>(), Color::WHITE.to_u32());
}

/// A canvas, cleared, for the raster core. `None` for sizes that no window has.
fn black<'a>(canvas: &'a mut Canvas<'_>) -> Option<Target<'a, u32>> {
    let [width, height] = canvas.dimensions();
    let pixels = canvas.pixels_mut();
    pixels.fill(Color::BLACK.to_u32());
    Target::new(pixels, Depth::None, width, height, width as usize).ok()
}

/// Turns an object of the world, and sets up the camera, so that polosa's own picture shows what the seed's does.
///
/// The seed's y runs down the screen: the object is mirrored, y ↦ −y, which turns its pitch round.
///
/// # Errors
///
/// When the object is gone.
pub fn place_as_seed(
    app: &mut Application,
    object: ObjectKey,
    seed: Seed,
    degrees: [i64; 2],
) -> Result<(), WorldError> {
    let [heading, pitch] = degrees.map(|angle| (angle as f64).to_radians());
    let heading = if seed == Seed::S0 { -heading } else { heading };
    let about = |axis, angle| axis_angle(axis, angle).unwrap_or_default();
    let rotation = turn(about(DVec3::Y, heading), about(DVec3::X, -pitch));
    let placement = Placement { translation: DVec3::ZERO, rotation, scale: DVec3::new(1.0, -1.0, 1.0) };
    app.world.set_placement(object, placement)?;

    let mut camera = Camera::new();
    let height = f64::from(app.size()[1]) / app.scale();
    // Neither a place nor a window of this kind is refused.
    let _ = camera.set_position(DVec3::new(0.0, 0.0, 1000.0));
    let _ = camera.set_projection(Projection::Orthographic { height, near: 1.0, far: 2000.0 });
    let _ = camera.set_aspect(app.camera.aspect());
    app.camera = camera;
    Ok(())
}

/// The light of both seeds, for polosa's own picture: from the observer and no other. Pixels are sampled at their corner.
pub fn light_as_seed(app: &mut Application) {
    app.light = Light { direction: DVec3::Z, space: LightSpace::Camera, ambient: 0.0 };
    app.style.sample = CORNER;
}
