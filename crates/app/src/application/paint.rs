//! A frame's 3D part, into pixels that somebody lends.

use core::num::NonZeroUsize;

use polosa_raster::{Depth, Target, TargetError};
use polosa_scene::{Camera, DrawStats, Light, Picture, PictureSettings, Renderer, Samples, Style, World};

use crate::error::Error;
use crate::settings::{Look, Settings};

/// The code of the farthest pixel in a picture of depths, so that it is told from a black background.
const FARTHEST: f64 = 40.0;

/// Draws frames. It keeps its working memory from one to the next.
#[derive(Debug, Default)]
pub(super) struct Painter {
    renderer: Option<Renderer>,
    depth: Vec<f32>,
}

/// A renderer for so many threads; `None`: as many as the machine runs at once.
pub(crate) fn new_renderer(threads: Option<NonZeroUsize>) -> Renderer {
    threads.map_or_else(Renderer::new, |threads| Renderer::with_threads(threads.get()))
}

impl Painter {
    pub(super) fn adopt(&mut self, renderer: Renderer) {
        self.renderer = Some(renderer);
    }

    #[expect(clippy::too_many_arguments, reason = "all of an application that a picture follows from")]
    pub(super) fn paint(
        &mut self,
        world: &World,
        camera: &Camera,
        light: &Light,
        style: &Style,
        settings: &Settings,
        pixels: &mut [u32],
        size: [u32; 2],
    ) -> Result<DrawStats, Error> {
        let threads = settings.threads.map(|threads| threads.get().min(256));
        if self.renderer.as_ref().is_none_or(|renderer| threads.is_some_and(|t| t != renderer.threads())) {
            self.renderer = Some(new_renderer(settings.threads));
        }
        let renderer = self.renderer.get_or_insert_default();
        let failed = |error: TargetError| Error::file(&settings.title, error.to_string());

        let [width, height] = size;
        let background = settings.background;
        if settings.look == Look::Depth {
            self.depth.resize(pixels.len(), 0.0);
            let depth = Depth::F32(&mut self.depth);
            let mut target = Target::new(pixels, depth, width, height, width as usize).map_err(failed)?;
            let stats =
                renderer.frame(world, camera, light, style, Some(background), &mut target).map_err(failed)?;
            show_depth(camera, &self.depth, pixels);
            return Ok(stats);
        }
        let picture = match settings.methods {
            Some(methods) => methods.picture(world, camera, light, style, size, background),
            None if settings.samples != Samples::One => {
                let (background, samples) = (Some(background), settings.samples);
                let picture = PictureSettings { width, height, background, samples, ..Default::default() };
                Picture::render(renderer, world, camera, light, style, &picture)
            }
            None => {
                let mut target =
                    Target::new(pixels, Depth::None, width, height, width as usize).map_err(failed)?;
                let stats = renderer.frame(world, camera, light, style, Some(background), &mut target);
                return stats.map_err(failed);
            }
        };
        let picture = picture.map_err(failed)?;
        pixels.copy_from_slice(&picture.pixels);
        Ok(picture.stats)
    }
}

/// Greys by distance, where something is.
fn show_depth(camera: &Camera, depth: &[f32], pixels: &mut [u32]) {
    let seen = depth.iter().copied().filter(|depth| *depth > 0.0);
    let (nearest, farthest) = seen.fold((0.0_f32, f32::INFINITY), |(n, f), d| (n.max(d), f.min(d)));
    let nearest = camera.distance(nearest);
    let range = camera.distance(farthest) - nearest;
    for (pixel, &depth) in pixels.iter_mut().zip(depth).filter(|(_, depth)| **depth > 0.0) {
        let share = if range > 0.0 { (camera.distance(depth) - nearest) / range } else { 0.0 };
        let code = (255.0 - (255.0 - FARTHEST) * share + 0.5) as u32;
        *pixel = code << 16 | code << 8 | code;
    }
}
