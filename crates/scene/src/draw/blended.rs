//! Vertex colours in a frame: each pixel that is seen is blended once all is drawn.
//!
//! A frame's value has 32 bits, a colour 24. The top bit says that the rest is no colour but a number: that of a
//! triangle among all whose corners have colours of their own.

use polosa_raster::{Columns, Deferred, Sampled, State, StoredDepth, transform_point};

use super::surface::Surface;
use crate::light::Lighting;
use crate::{Color, Colors, MeshKey, World};

/// The mark of a number.
const NUMBER: u32 = 1 << 31;

/// Surfaces with vertex colours, in the order of their numbers.
#[derive(Clone, Debug)]
pub(super) struct Blended {
    surfaces: Vec<Numbered>,
    next: u32,
    /// So many triangles can be numbered.
    pub(super) most: u64,
}

impl Default for Blended {
    fn default() -> Self {
        Self { surfaces: Vec::new(), next: 0, most: NUMBER.into() }
    }
}

#[derive(Clone, Debug)]
struct Numbered {
    /// The number of its first triangle.
    first: u32,
    mesh: MeshKey,
    matrix: Columns,
    lighting: Lighting,
}

impl Blended {
    pub(super) fn clear(&mut self) {
        self.surfaces.clear();
        self.next = 0;
    }

    pub(super) fn is_empty(&self) -> bool {
        self.surfaces.is_empty()
    }

    /// Gives numbers to a surface's triangles; the value of the first, the others' follow.
    pub(super) fn number(&mut self, surface: &Surface<'_>) -> u32 {
        let first = self.next;
        let Surface { object, mesh, matrix, lighting, .. } = *surface;
        self.surfaces.push(Numbered { first, mesh: object.mesh(), matrix, lighting });
        self.next = first.wrapping_add(mesh.triangles().len() as u32);
        NUMBER | first
    }

    /// Makes pixels of a frame's values; a copy for each thread.
    pub(super) fn blender<'a>(&'a self, world: &'a World, state: &State, frame: Format) -> Blender<'a> {
        Blender {
            blended: self,
            world,
            sixteen: frame.sixteen,
            deferred: Deferred::new(state, frame.size),
            value: 0,
            colors: [Color::BLACK; 3],
            intensity: 0.0,
        }
    }
}

/// What a frame's values and depths are of.
#[derive(Clone, Copy, Debug)]
pub(super) struct Format {
    pub(super) size: [u32; 2],
    /// Whether depths are stored in 16 bits.
    pub(super) sixteen: bool,
}

/// Makes pixels of values. It remembers the triangle it was last asked for, as the next pixel is often its.
#[derive(Clone, Debug)]
pub(super) struct Blender<'a> {
    blended: &'a Blended,
    world: &'a World,
    sixteen: bool,
    deferred: Deferred,
    /// The value whose triangle is prepared; no number at first.
    value: u32,
    colors: [Color; 3],
    intensity: f32,
}

impl Blender<'_> {
    #[inline]
    pub(super) fn pixel(&mut self, sampled: Sampled) -> u32 {
        let Sampled { x, y, value, depth } = sampled;
        if value & NUMBER == 0 {
            return value;
        }
        if value != self.value {
            self.value = value;
            // Numbers come from surfaces of this world, so that there always is a triangle.
            let _ = self.prepare(value & !NUMBER);
        }
        let depth = if self.sixteen { StoredDepth::U16(depth as u16) } else { StoredDepth::F32(depth) };
        let weights = self.deferred.weights(x, y, depth).unwrap_or_default();
        Lighting::blend(self.colors, weights, self.intensity)
    }

    #[inline(never)]
    fn prepare(&mut self, number: u32) -> Option<()> {
        let surfaces = &self.blended.surfaces;
        let surface = surfaces.partition_point(|surface| surface.first <= number).checked_sub(1)?;
        let Numbered { first, mesh, matrix, lighting } = &surfaces[surface];
        let mesh = self.world.mesh(*mesh)?;
        let Colors::Vertex(colors) = mesh.colors() else { return None };
        let triangle = mesh.triangles().get((number - first) as usize)?;
        let corners = triangle.map(|vertex| mesh.positions()[vertex as usize]);
        self.colors = triangle.map(|vertex| colors[vertex as usize]);
        self.intensity = lighting.intensity(corners);
        self.deferred.prepare(corners.map(|corner| transform_point(matrix, corner)).each_ref());
        Some(())
    }
}

#[cfg(test)]
mod tests {
    use polosa_math::glam::DVec3;
    use polosa_raster::{Depth, Target};

    use crate::{
        Camera, Color, Colors, Light, Object, Picture, PictureSettings, Renderer, Style, World, shape,
    };

    /// Nobody can wait for 2³¹ triangles, so the renderer is told that fewer are too many.
    #[test]
    fn what_cannot_be_numbered_is_drawn_one_by_one() {
        let ball = shape::uv_sphere(30, 20).unwrap();
        let shades = (0..ball.positions().len() as u32).map(|k| Color::from_u32(k * 40_503 % (1 << 24)));
        let ball = ball.clone().with_colors(Colors::Vertex(shades.collect())).unwrap();
        let most = 2 * ball.triangles().len() as u64;
        let mut world = World::new();
        let key = world.add_mesh(ball);
        for x in [0.0, 0.5] {
            world.add(Object::new(key).at(DVec3::new(x, 0.0, x))).unwrap();
        }
        let mut camera = Camera::new();
        camera.frame(&world.bounds(), DVec3::ONE, DVec3::Y, 0.1).unwrap();
        let (light, style) = (Light::default(), Style::default());
        let frame = |most| {
            let mut renderer = Renderer::with_threads(2);
            renderer.blended.most = most;
            let mut pixels = vec![0; 80 * 60];
            let mut target = Target::new(&mut pixels, Depth::None, 80, 60, 80).unwrap();
            let stats = renderer.frame(&world, &camera, &light, &style, None, &mut target).unwrap();
            let settings = PictureSettings { width: 80, height: 60, background: None, ..Default::default() };
            let picture = Picture::render(&mut renderer, &world, &camera, &light, &style, &settings).unwrap();
            assert_eq!((picture.stats, &picture.pixels), (stats, &pixels));
            (renderer.overflows, picture)
        };
        let (fits, expected) = frame(most);
        let (overflows, got) = frame(most - 1);
        assert!(!fits && overflows);
        assert!(got == expected && expected.pixels.iter().any(|&pixel| pixel != 0));
    }
}
