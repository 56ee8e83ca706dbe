//! One frame, drawn and taken apart into its stages: what stands between the measuring and the renderer.

use std::panic::resume_unwind;
use std::thread;
use std::time::{Duration, Instant};

use polosa_raster::{Depth, DepthTest, Target, TargetError};
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
    depth: Vec<f32>,
    /// One for each thread.
    renderers: Vec<Renderer>,
    background: Option<Color>,
    /// The last frame, if its pixels have several samples; `color` and `depth` are empty then.
    sampled: Option<Picture>,
}

impl Frames {
    /// Memory for frames of a scene, and as many threads' renderers as its settings say.
    pub(super) fn new(scene: &Scene<'_>) -> Self {
        let PictureSettings { width, height, background, samples, threads, .. } = *scene.settings;
        let pixels = if samples == Samples::One { width as usize * height as usize } else { 0 };
        let threads = threads.map_or(1, usize::from).min(height as usize);
        Self {
            size: [width, height],
            color: vec![0; pixels],
            depth: vec![0.0; pixels],
            renderers: vec![Renderer::new(); threads],
            background,
            sampled: None,
        }
    }

    /// Draws one frame: the target is cleared, then the world drawn.
    pub(super) fn draw(&mut self, scene: &Scene<'_>) -> Result<Drawn, TargetError> {
        if scene.settings.samples != Samples::One {
            return self.draw_samples(scene);
        }
        let pixel = self.background.map_or(0, Color::to_u32);
        let start = Instant::now();
        self.bands(|_, target| {
            target.clear(pixel, DepthTest::Greater);
            DrawStats::default()
        })?;
        let cleared = Instant::now();
        let Scene { world, camera, light, style, .. } = *scene;
        let stats = self.bands(|renderer, target| renderer.draw(world, camera, light, style, target))?;
        Ok(Drawn { stats, stages: vec![("clear", cleared - start), ("draw", cleared.elapsed())] })
    }

    /// Draws one frame of several samples a pixel: several of one sample, and their mean.
    fn draw_samples(&mut self, scene: &Scene<'_>) -> Result<Drawn, TargetError> {
        let Scene { world, camera, light, style, settings } = *scene;
        // The memory of the frame before is that of this one.
        self.sampled = None;
        let start = Instant::now();
        let picture = Picture::render(&mut self.renderers[0], world, camera, light, style, settings)?;
        let stages = vec![("samples", start.elapsed())];
        let stats = picture.stats;
        self.sampled = Some(picture);
        Ok(Drawn { stats, stages })
    }

    /// Does something with each thread's band of rows at once; what the first one says.
    fn bands(
        &mut self,
        work: impl Fn(&mut Renderer, &mut Target<'_, u32>) -> DrawStats + Sync,
    ) -> Result<DrawStats, TargetError> {
        let [width, height] = self.size;
        let rows = (height as usize).div_ceil(self.renderers.len());
        let length = width as usize * rows;
        let work = |k: usize, color: &mut [u32], depth: &mut [f32], renderer: &mut Renderer| {
            let first = (k * rows) as u32;
            let rows = first..first + (color.len() / width as usize) as u32;
            let mut target = Target::band(color, Depth::F32(depth), self.size, width as usize, rows)?;
            Ok(work(renderer, &mut target))
        };
        let bands = self.color.chunks_mut(length).zip(self.depth.chunks_mut(length)).zip(&mut self.renderers);
        let mut bands = bands.enumerate().map(|(k, ((color, depth), renderer))| (k, color, depth, renderer));
        let first = bands.next();
        thread::scope(|scope| {
            let others: Vec<_> = bands
                .map(|(k, color, depth, renderer)| scope.spawn(move || work(k, color, depth, renderer)))
                .collect();
            let first = first.map_or(Ok(DrawStats::default()), |(k, color, depth, renderer)| {
                work(k, color, depth, renderer)
            });
            others
                .into_iter()
                .map(|other| other.join().unwrap_or_else(|panic| resume_unwind(panic)))
                .fold(first, |first, other| first.and_then(|first| other.map(|_| first)))
        })
    }

    /// The last frame as a picture.
    pub(super) fn into_picture(self, stats: DrawStats) -> Picture {
        let covered = |depth: &f32| if *depth > 0.0 { 255 } else { 0 };
        self.sampled.unwrap_or_else(|| Picture {
            width: self.size[0],
            height: self.size[1],
            pixels: self.color,
            alpha: self.background.is_none().then(|| self.depth.iter().map(covered).collect()),
            distances: None,
            ids: None,
            stats,
        })
    }
}
