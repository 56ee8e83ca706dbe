//! The drawing of a world: the whole pipeline on one screen.

use polosa_raster::{Clip, Fragment, PerTriangle, Target, transform};

use crate::light::Lighting;
use crate::{Camera, Colors, DrawStats, Light, Mesh, Object, Show, Style, World};

/// Draws worlds. It keeps its working memory from one frame to the next.
#[derive(Clone, Debug, Default)]
pub struct Renderer {
    /// The vertices of one object in clip space.
    clip: Vec<Clip>,
    /// The intensity of each triangle of one object.
    intensities: Vec<f32>,
}

impl Renderer {
    /// A renderer without memory yet.
    #[must_use]
    pub fn new() -> Self {
        Self::default()
    }

    /// Draws a world as a camera sees it, over what the target holds: surfaces in the order in which the objects
    /// were added, then edges over surfaces, then wire. Pixels are `0x00RRGGBB`; depth is reversed, so clear it
    /// with [`DepthTest::Greater`](polosa_raster::DepthTest::Greater).
    ///
    /// The target's width to height should be the camera's aspect; nothing is lost if not, but the picture is
    /// stretched.
    pub fn draw(
        &mut self,
        world: &World,
        camera: &Camera,
        light: &Light,
        style: &Style,
        target: &mut Target<'_, u32>,
    ) -> DrawStats {
        let mut stats = DrawStats::default();
        let state = style.state();
        for (object, mesh) in shown(world, &[Show::Surface, Show::Both]) {
            self.transform(camera, object, mesh);
            let lighting = Lighting::new(light, style.shading, camera, &object.placement);
            stats.triangles += self.surface(object, mesh, &lighting, style, target);
            stats.objects += 1;
        }
        for (object, mesh) in shown(world, &[Show::Both]) {
            let Some(outline) = world.outline(object.mesh()) else { continue };
            self.transform(camera, object, mesh);
            let color = style.edge_color.to_u32();
            let around = |edge| outline.around(mesh, edge);
            stats.lines += target.edges(&state, &self.clip, &outline.edges, around, color);
        }
        for (object, mesh) in shown(world, &[Show::Wire]) {
            let Some(outline) = world.outline(object.mesh()) else { continue };
            self.transform(camera, object, mesh);
            let color = object.color.unwrap_or(style.color).to_u32();
            stats.lines += target.lines(&state, &self.clip, &outline.edges, color);
            stats.objects += 1;
        }
        stats
    }

    /// Draws, instead of colours, the number of each triangle plus one: its place among all the triangles of
    /// the visible surfaces, in the order of drawing. Where nothing is, the target keeps what it holds.
    pub fn draw_ids(
        &mut self,
        world: &World,
        camera: &Camera,
        style: &Style,
        target: &mut Target<'_, u32>,
    ) -> DrawStats {
        let mut stats = DrawStats::default();
        let mut first = 1_u32;
        for (object, mesh) in shown(world, &[Show::Surface, Show::Both]) {
            self.transform(camera, object, mesh);
            let triangles = mesh.triangles();
            let id = PerTriangle(|index: usize| first.wrapping_add(index as u32));
            stats.triangles += target.triangles(&style.state(), &self.clip, triangles, &id);
            stats.objects += 1;
            first = first.wrapping_add(triangles.len() as u32);
        }
        stats
    }

    fn transform(&mut self, camera: &Camera, object: &Object, mesh: &Mesh) {
        let matrix = camera.clip_from_model(&object.placement);
        self.clip.resize(mesh.positions().len(), [0.0; 4]);
        transform(&matrix, mesh.positions(), &mut self.clip);
    }

    fn surface(
        &mut self,
        object: &Object,
        mesh: &Mesh,
        lighting: &Lighting,
        style: &Style,
        target: &mut Target<'_, u32>,
    ) -> polosa_raster::Stats {
        let (positions, triangles) = (mesh.positions(), mesh.triangles());
        let intensity = |index: usize| lighting.intensity(triangles[index].map(|k| positions[k as usize]));
        let state = &style.state();
        let colors = if object.color.is_some() { &Colors::None } else { mesh.colors() };
        match colors {
            Colors::None => {
                let color = object.color.unwrap_or(style.color);
                let shade = PerTriangle(|index| Lighting::pixel(color, intensity(index)));
                target.triangles(state, &self.clip, triangles, &shade)
            }
            Colors::Face(colors) => {
                let shade = PerTriangle(|index: usize| Lighting::pixel(colors[index], intensity(index)));
                target.triangles(state, &self.clip, triangles, &shade)
            }
            Colors::Vertex(colors) => {
                self.intensities.clear();
                self.intensities.extend((0..triangles.len()).map(intensity));
                let shade = |fragment: &Fragment<'_>, pixel: &mut u32| {
                    let index = fragment.triangle();
                    let corners = triangles[index].map(|k| colors[k as usize]);
                    *pixel = Lighting::blend(corners, fragment.weights(), self.intensities[index]);
                    true
                };
                target.triangles(state, &self.clip, triangles, &shade)
            }
        }
    }
}

/// The visible objects that are shown in one of some ways, in the order in which they were added.
fn shown<'a>(world: &'a World, ways: &'a [Show]) -> impl Iterator<Item = (&'a Object, &'a Mesh)> {
    world
        .objects()
        .map(|(_, object)| object)
        .filter(|object| object.visible && ways.contains(&object.show))
        .filter_map(|object| Some((object, world.mesh(object.mesh())?)))
}
