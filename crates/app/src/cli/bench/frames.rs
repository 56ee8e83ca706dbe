//! One frame, drawn and taken apart into its stages: what stands between the measuring and the renderer.

use std::time::Duration;

use polosa_raster::{Depth, Target, TargetError};
use polosa_scene::{
    Camera, Color, DrawStats, Light, Picture, PictureSettings, Renderer, Samples, Style, World,
};

/// What is drawn, and how.
#[derive(Clone, Copy, Debug)]
pub(super) struct Scene<'a> {
    pub(super) world: &'a World,
    pub(super) camera: &'a Camera,
    pub(super) light: &'a Light,
    pub(super) style: &'a Style,
    pub(super) settings: &'a PictureSettings,
}

/// A frame that was drawn.
#[derive(Debug)]
pub(super) struct Drawn {
    pub(super) stats: DrawStats,
    /// Where the time went, in the order of the work.
    pub(super) stages: Vec<(&'static str, Duration)>,
}

/// A picture in memory that is drawn again and again.
#[derive(Debug)]
pub(super) struct Frames {
    size: [u32; 2],
    color: Vec<u32>,
    /// Kept if it says what is covered: without a background.
    depth: Option<Vec<f32>>,
    renderer: Renderer,
    background: Option<Color>,
    /// The last frame, if its pixels have several samples; `color` and `depth` are empty then.
    sampled: Option<Picture>,
}

impl Frames {
    /// Memory for frames of a scene, and a renderer for as many threads as its settings say.
    pub(super) fn new(scene: &Scene<'_>) -> Self {
        let PictureSettings { width, height, background, samples, threads, .. } = *scene.settings;
        let pixels = if samples == Samples::One { width as usize * height as usize } else { 0 };
        Self {
            size: [width, height],
            color: vec![0; pixels],
            depth: background.is_none().then(|| vec![0.0; pixels]),
            renderer: Renderer::with_threads(threads.map_or(1, usize::from)),
            background,
            sampled: None,
        }
    }

    /// Draws one frame.
    pub(super) fn draw(&mut self, scene: &Scene<'_>) -> Result<Drawn, TargetError> {
        let Scene { world, camera, light, style, settings } = *scene;
        let stats = if settings.samples == Samples::One {
            let depth = self.depth.as_deref_mut().map_or(Depth::None, Depth::F32);
            let [width, height] = self.size;
            let mut target = Target::new(&mut self.color, depth, width, height, width as usize)?;
            self.renderer.frame(world, camera, light, style, self.background, &mut target)?
        } else {
            // Several frames of one sample, and their mean. The memory of the last picture is that of this one.
            self.sampled = None;
            let picture = Picture::render(&mut self.renderer, world, camera, light, style, settings)?;
            self.sampled.insert(picture).stats
        };
        let timings = self.renderer.timings();
        let stages = vec![("setup", timings.setup), ("fill", timings.fill), ("lines", timings.lines)];
        Ok(Drawn { stats, stages })
    }

    /// The last frame as a picture.
    pub(super) fn into_picture(self, stats: DrawStats) -> Picture {
        let covered = |depth: &f32| if *depth > 0.0 { 255 } else { 0 };
        self.sampled.unwrap_or_else(|| Picture {
            width: self.size[0],
            height: self.size[1],
            pixels: self.color,
            alpha: self.depth.map(|depth| depth.iter().map(covered).collect()),
            distances: None,
            ids: None,
            stats,
        })
    }
}
