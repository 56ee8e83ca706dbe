//! Drawing over what a target holds, triangle by triangle.

use polosa_raster::{Clip, Fragment, PerTriangle, State, Stats, Target};

use super::surface::{Paint, Surface, Take};
use super::{Renderer, SURFACES, View, shown};
use crate::light::Lighting;
use crate::timings::Clock;
use crate::{Camera, DrawStats, Light, Style, World};

/// # Over what is there
impl Renderer {
    /// Draws a world as a camera sees it, over what the target holds: surfaces in the order in which the objects
    /// were added, then edges over surfaces, then wire. Pixels are `0x00RRGGBB`; depth is reversed, so clear it
    /// with [`DepthTest::Greater`](polosa_raster::DepthTest::Greater).
    ///
    /// The target's width to height should be the camera's aspect; nothing is lost if not, but the picture is
    /// stretched.
    ///
    /// Triangles are drawn one by one, by one thread. For a whole picture [`frame`](Self::frame) is faster.
    pub fn draw(
        &mut self,
        world: &World,
        camera: &Camera,
        light: &Light,
        style: &Style,
        target: &mut Target<'_, u32>,
    ) -> DrawStats {
        let view = View { world, camera, light, style };
        self.forget_timings();
        let clock = Clock::start();
        let mut stats = self.surfaces(&view, target);
        self.timings.fill = clock.stop();
        stats += self.lines(&view, target);
        stats
    }

    pub(super) fn surfaces(&mut self, view: &View<'_>, target: &mut Target<'_, u32>) -> DrawStats {
        let mut stats = DrawStats::default();
        let state = view.style.state();
        for (object, mesh) in shown(view.world, SURFACES) {
            let surface = Surface::new(view, object, mesh);
            self.transform(view.camera, object, mesh);
            stats.objects += 1;
            let Paint::Vertex(colors) = surface.paint else {
                let onto = OntoTarget { target, state, clip: &self.clip, surface: &surface };
                stats.triangles += surface.give(&mut self.shades, onto, |_| 0);
                continue;
            };
            surface.lighting.intensities(self.level, mesh, &mut self.intensities);
            let shade = |fragment: &Fragment<'_>, pixel: &mut u32| {
                let index = fragment.triangle();
                let corners = mesh.triangles()[index].map(|k| colors[k as usize]);
                *pixel = Lighting::blend(corners, fragment.weights(), self.intensities[index]);
                true
            };
            stats.triangles += target.triangles(&state, &self.clip, mesh.triangles(), &shade);
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
        for (object, mesh) in shown(world, SURFACES) {
            self.transform(camera, object, mesh);
            let triangles = mesh.triangles();
            let id = PerTriangle(|index: usize| first.wrapping_add(index as u32));
            stats.triangles += target.triangles(&style.state(), &self.clip, triangles, &id);
            stats.objects += 1;
            first = first.wrapping_add(triangles.len() as u32);
        }
        stats
    }
}

/// Draws a surface onto a target.
struct OntoTarget<'a, 'b> {
    target: &'a mut Target<'b, u32>,
    state: State,
    clip: &'a [Clip],
    surface: &'a Surface<'a>,
}

impl Take<Stats> for OntoTarget<'_, '_> {
    fn take(self, shade: impl Fn(usize, f32) -> u32 + Sync) -> Stats {
        let value = PerTriangle(|index| shade(index, self.surface.intensity(index)));
        self.target.triangles(&self.state, self.clip, self.surface.mesh.triangles(), &value)
    }
}
