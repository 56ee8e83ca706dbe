//! A whole picture by methods for comparison.

use polosa_raster::reference::{self, Coverage, Hidden, ZBuffer};
use polosa_raster::{Clip, Depth, Stats, Target, TargetError, transform};

use super::Shading;
use crate::draw::{Paint, SURFACES, Surface, View, shown};
use crate::{Camera, Color, DrawStats, Light, Picture, Style, World, picture, srgb};

/// How to draw a world: by default exactly.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, Default)]
pub struct Methods {
    /// Which pixels a triangle covers.
    pub coverage: Coverage,
    /// Which triangle is seen.
    pub hidden: Hidden,
    /// What becomes of a colour under a light.
    pub shading: Shading,
}

impl Methods {
    /// Draws the surfaces of a world into a new picture, by one thread, one sample a pixel.
    ///
    /// All triangles of all surfaces are handed over at once, in the order of drawing, each of one colour: where a mesh
    /// has colours at its vertices, a triangle gets their mean. So the default methods give the picture of
    /// [`Renderer::frame`](crate::Renderer::frame), but for such meshes. Edges and wire are not drawn.
    ///
    /// ```
    /// use polosa_raster::reference::Hidden;
    /// use polosa_scene::reference::Methods;
    /// use polosa_scene::{Camera, Color, Light, Object, Style, World, shape};
    ///
    /// let mut world = World::new();
    /// let torus = world.add_mesh(shape::torus(40, 20)?);
    /// world.add(Object::new(torus))?;
    /// let mut camera = Camera::new();
    /// camera.frame(&world.bounds(), [1.0, 0.3, 0.0].into(), [0.0, 1.0, 0.0].into(), 0.05)?;
    ///
    /// let picture = |hidden| {
    ///     let methods = Methods { hidden, ..Methods::default() };
    ///     methods.picture(&world, &camera, &Light::default(), &Style::default(), [64, 48], Color::BLACK)
    /// };
    /// assert_ne!(picture(Hidden::Order)?.pixels, picture(Hidden::Exact)?.pixels);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    ///
    /// # Errors
    ///
    /// When a side of the picture is 0 or more than 16,384 pixels.
    pub fn picture(
        self,
        world: &World,
        camera: &Camera,
        light: &Light,
        style: &Style,
        [width, height]: [u32; 2],
        background: Color,
    ) -> Result<Picture, TargetError> {
        let mut pixels = vec![background.to_u32(); picture::pixels(width, height)?];
        let mut target = Target::new(&mut pixels, Depth::None, width, height, width as usize)?;
        let view = View { world, camera, light, style };
        let mut scene = Scene::default();
        for (object, mesh) in shown(world, SURFACES) {
            scene.add(self.shading, &Surface::new(&view, object, mesh));
        }
        let Self { coverage, hidden, .. } = self;
        let triangles = reference::draw(
            &mut target,
            &mut ZBuffer::new(),
            reference::Methods { coverage, hidden },
            &style.state(),
            &scene.vertices,
            &scene.triangles,
            |triangle| scene.colors[triangle as usize],
        );
        let stats = DrawStats { objects: scene.objects, triangles, hidden: 0, lines: Stats::default() };
        Ok(Picture { width, height, pixels, alpha: None, distances: None, ids: None, stats })
    }
}

/// The triangles of all surfaces.
#[derive(Default)]
struct Scene {
    vertices: Vec<Clip>,
    triangles: Vec<[u32; 3]>,
    /// Of each triangle, under its light.
    colors: Vec<u32>,
    objects: u64,
}

impl Scene {
    fn add(&mut self, shading: Shading, surface: &Surface<'_>) {
        let (first, mesh) = (self.vertices.len(), surface.mesh);
        self.vertices.resize(first + mesh.positions().len(), [0.0; 4]);
        transform(&surface.matrix, mesh.positions(), &mut self.vertices[first..]);
        for (index, triangle) in mesh.triangles().iter().enumerate() {
            let color = match surface.paint {
                Paint::One(color) => color,
                Paint::Face(colors) => colors[index],
                Paint::Vertex(colors) => mean(triangle.map(|vertex| colors[vertex as usize])),
            };
            self.colors.push(shading.shade_color(color.to_u32(), surface.intensity(index)));
            // More than 2³² vertices name none, and are counted as such.
            let moved = |vertex: u32| u32::try_from(first + vertex as usize).unwrap_or(u32::MAX);
            self.triangles.push(triangle.map(moved));
        }
        self.objects += 1;
    }
}

/// The mean of three colours, in linear light.
fn mean(colors: [Color; 3]) -> Color {
    let channel = |of: fn(Color) -> u8| {
        let [a, b, c] = colors.map(|color| srgb::decode(of(color)));
        srgb::encode((a + b + c) / 3.0)
    };
    Color::new(channel(|c| c.r), channel(|c| c.g), channel(|c| c.b))
}
