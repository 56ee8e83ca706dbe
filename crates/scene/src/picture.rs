//! A finished picture, with whatever else of it was asked for.
//!
//! It is drawn in bands of rows: by several threads, and so that depth and the sums of samples take 80 MiB at most,
//! however large the picture is. A band has the same bytes as those rows of the whole, so that no number of threads
//! changes the picture.

use core::num::NonZeroUsize;
use core::ops::Range;
use std::panic::resume_unwind;
use std::thread;

use polosa_raster::{Depth, DepthTest, MAX_SIDE, Sample, Target, TargetError};

use crate::srgb;
use crate::{Camera, Color, DrawStats, Light, Renderer, Style, World};

/// The most pixels that are drawn at a time, by all threads: 16 MiB of depth, and four times that of sums when there
/// are several samples.
const BAND: usize = 1 << 22;

/// Pictures of fewer pixels are drawn sooner than a thread is started.
const WORTH_A_THREAD: usize = 1 << 17;

/// Every thread prepares all triangles anew, so that more than a few gain little.
const MOST_THREADS: usize = 8;

/// How many samples a pixel has, on a regular grid. They are averaged in linear light.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, Default)]
pub enum Samples {
    /// One, at the centre.
    #[default]
    One,
    /// 2 × 2.
    Four,
    /// 4 × 4.
    Sixteen,
}

impl Samples {
    /// Samples along a side.
    const fn side(self) -> u8 {
        match self {
            Self::One => 1,
            Self::Four => 2,
            Self::Sixteen => 4,
        }
    }

    fn grid(self) -> impl Iterator<Item = Sample> {
        let n = self.side();
        let place = move |k: u8| 128 / n * (2 * k + 1);
        (0..n).flat_map(move |y| (0..n).map(move |x| Sample { x: place(x), y: place(y) }))
    }
}

/// What to make.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct PictureSettings {
    /// In pixels, from 1 to 16,384.
    pub width: u32,
    /// In pixels, from 1 to 16,384.
    pub height: u32,
    /// Behind everything; `None`: nothing, the picture gets an alpha channel.
    pub background: Option<Color>,
    /// Samples of each pixel's colour. Distances and ids are taken at the pixel's centre, always.
    pub samples: Samples,
    /// Whether to keep the distance at each pixel.
    pub distances: bool,
    /// Whether to keep the triangle at each pixel.
    pub ids: bool,
    /// Threads that draw, 256 at most and no more than the picture has rows; no number of them changes a bit.
    /// `None`: as many as the machine runs at once, but no more than a picture of this size is worth.
    pub threads: Option<NonZeroUsize>,
}

impl Default for PictureSettings {
    /// 1024 × 768 on dark grey, one sample, colour alone.
    fn default() -> Self {
        Self {
            width: 1024,
            height: 768,
            background: Some(Color::new(0x2b, 0x2b, 0x2b)),
            samples: Samples::One,
            distances: false,
            ids: false,
            threads: None,
        }
    }
}

/// A finished picture; rows from top to bottom, without gaps.
#[derive(Clone, Debug, PartialEq)]
pub struct Picture {
    /// In pixels.
    pub width: u32,
    /// In pixels.
    pub height: u32,
    /// Colours, `0x00RRGGBB`, sRGB-encoded. Without a background, what nothing covers is 0.
    pub pixels: Vec<u32>,
    /// Without a background: the share of each pixel that is covered, 0 to 255. Colours are not multiplied by
    /// it (straight alpha).
    pub alpha: Option<Vec<u8>>,
    /// Distances along the viewing axis, in the world's units; infinite where nothing is.
    pub distances: Option<Vec<f32>>,
    /// Numbers of triangles plus one, as [`Renderer::draw_ids`] counts them; 0 where nothing is.
    pub ids: Option<Vec<u32>>,
    /// What became of the triangles and edges, at one sample.
    pub stats: DrawStats,
}

impl Picture {
    /// Draws a world into a new picture. The camera's aspect should be that of the picture, else it is stretched.
    ///
    /// ```
    /// use polosa_scene::{Camera, Light, Picture, PictureSettings, Renderer, Style, World};
    ///
    /// let settings = PictureSettings { width: 8, height: 6, ..PictureSettings::default() };
    /// let nothing = Picture::render(
    ///     &mut Renderer::new(), &World::new(), &Camera::new(), &Light::default(), &Style::default(), &settings,
    /// )?;
    /// assert_eq!(nothing.pixels, [0x2b2b2b; 8 * 6]);
    /// # Ok::<(), polosa_raster::TargetError>(())
    /// ```
    ///
    /// # Errors
    ///
    /// When a side of the picture is 0 or more than 16,384 pixels.
    pub fn render(
        renderer: &mut Renderer,
        world: &World,
        camera: &Camera,
        light: &Light,
        style: &Style,
        settings: &PictureSettings,
    ) -> Result<Self, TargetError> {
        let PictureSettings { width, height, .. } = *settings;
        if [width, height].iter().any(|side| !(1..=MAX_SIDE).contains(side)) {
            return Err(TargetError::Size { width, height });
        }
        let size = width as usize * height as usize;
        let mut picture = Self {
            width,
            height,
            pixels: vec![0; size],
            alpha: settings.background.is_none().then(|| vec![0; size]),
            distances: settings.distances.then(|| vec![f32::INFINITY; size]),
            ids: settings.ids.then(|| vec![0; size]),
            stats: DrawStats::default(),
        };
        let scene = Scene { world, camera, light, style, settings };
        let threads = settings.threads.map_or_else(|| worthwhile_threads(size), NonZeroUsize::get);
        let threads = threads.min(256).min(height as usize);
        let rows = (BAND / threads / width as usize).clamp(1, (height as usize).div_ceil(threads));
        // Bands are dealt out in turn: neighbours, which cost much the same, go to different threads.
        let mut hands: Vec<Vec<Band<'_>>> = (0..threads).map(|_| Vec::new()).collect();
        for (number, band) in picture.bands(rows).into_iter().enumerate() {
            hands[number % threads].push(band);
        }
        let draw = |renderer: &mut Renderer, bands: Vec<Band<'_>>| {
            let mut depth = vec![0.0; width as usize * rows];
            let draws = bands.into_iter().map(|band| band.draw(renderer, &scene, &mut depth));
            draws.reduce(|all, one| all.and(one)).unwrap_or(Ok(DrawStats::default()))
        };
        let first = hands.swap_remove(0);
        let stats = thread::scope(|scope| {
            let start = |bands| scope.spawn(|| draw(&mut Renderer::new(), bands));
            let others: Vec<_> = hands.into_iter().filter(|bands| !bands.is_empty()).map(start).collect();
            let first = draw(renderer, first);
            let joined =
                others.into_iter().map(|other| other.join().unwrap_or_else(|panic| resume_unwind(panic)));
            joined.fold(first, |all, one| one.and(all))
        });
        picture.stats = stats?;
        Ok(picture)
    }

    /// The picture in bands of so many rows.
    fn bands(&mut self, rows: usize) -> Vec<Band<'_>> {
        let size = [self.width, self.height];
        let length = self.width as usize * rows;
        let mut alpha = self.alpha.as_mut().map(|alpha| alpha.chunks_mut(length));
        let mut distances = self.distances.as_mut().map(|distances| distances.chunks_mut(length));
        let mut ids = self.ids.as_mut().map(|ids| ids.chunks_mut(length));
        let firsts = (0..self.height).step_by(rows);
        self.pixels
            .chunks_mut(length)
            .zip(firsts)
            .map(|(pixels, first)| Band {
                size,
                rows: first..first + (pixels.len() / size[0] as usize) as u32,
                pixels,
                alpha: alpha.as_mut().and_then(Iterator::next),
                distances: distances.as_mut().and_then(Iterator::next),
                ids: ids.as_mut().and_then(Iterator::next),
            })
            .collect()
    }
}

/// How many threads a picture of so many pixels is drawn by when nobody says so.
fn worthwhile_threads(pixels: usize) -> usize {
    if pixels < WORTH_A_THREAD {
        return 1;
    }
    thread::available_parallelism().map_or(1, usize::from).min(MOST_THREADS)
}

/// What is drawn, and how.
struct Scene<'a> {
    world: &'a World,
    camera: &'a Camera,
    light: &'a Light,
    style: &'a Style,
    settings: &'a PictureSettings,
}

/// Some rows of a picture.
struct Band<'a> {
    size: [u32; 2],
    rows: Range<u32>,
    pixels: &'a mut [u32],
    alpha: Option<&'a mut [u8]>,
    distances: Option<&'a mut [f32]>,
    ids: Option<&'a mut [u32]>,
}

impl Band<'_> {
    /// Draws the band; what became of the whole scene's triangles. `depth` is long enough for its rows.
    fn draw(
        self,
        renderer: &mut Renderer,
        scene: &Scene<'_>,
        depth: &mut [f32],
    ) -> Result<DrawStats, TargetError> {
        let Scene { world, camera, light, style, settings } = *scene;
        let depth = &mut depth[..self.pixels.len()];
        if let Some(ids) = self.ids {
            let mut target = cleared(ids, depth, self.size, &self.rows, 0)?;
            renderer.draw_ids(world, camera, style, &mut target);
        }
        let clear = settings.background.map_or(0, Color::to_u32);
        // The centre comes last, so that its depth is there for the distances.
        let several = settings.samples != Samples::One;
        let mut sums = vec![[0.0_f32; 4]; if several { self.pixels.len() } else { 0 }];
        let grid = settings.samples.grid().filter(|_| several);
        let centre = core::iter::once(Sample::CENTER).filter(|_| !several || settings.distances);
        let mut stats = DrawStats::default();
        for (sample, summed) in grid.map(|sample| (sample, true)).chain(centre.map(|sample| (sample, false)))
        {
            let mut target = cleared(self.pixels, depth, self.size, &self.rows, clear)?;
            stats = renderer.draw(world, camera, light, &Style { sample, ..*style }, &mut target);
            if summed {
                add_sample(&mut sums, self.pixels, depth, settings.background.is_some());
            }
        }
        if several {
            resolve(&sums, self.pixels);
        }
        if let Some(alpha) = self.alpha {
            let samples = f32::from(settings.samples.side() * settings.samples.side());
            for (k, alpha) in alpha.iter_mut().enumerate() {
                let covered =
                    if several { sums[k][3] / samples } else { f32::from(u8::from(depth[k] > 0.0)) };
                *alpha = (covered * 255.0 + 0.5) as u8;
            }
        }
        if let Some(distances) = self.distances {
            for (distance, &depth) in distances.iter_mut().zip(depth.iter()) {
                *distance = if depth > 0.0 { camera.distance(depth) as f32 } else { f32::INFINITY };
            }
        }
        Ok(stats)
    }
}

/// A cleared target over some rows of a picture.
fn cleared<'a>(
    color: &'a mut [u32],
    depth: &'a mut [f32],
    size: [u32; 2],
    rows: &Range<u32>,
    clear: u32,
) -> Result<Target<'a, u32>, TargetError> {
    let mut target = Target::band(color, Depth::F32(depth), size, size[0] as usize, rows.clone())?;
    target.clear(clear, DepthTest::Greater);
    Ok(target)
}

/// Adds the light of one sample, and whether it counts: with a background all do, without one what is covered.
fn add_sample(sums: &mut [[f32; 4]], color: &[u32], depth: &[f32], background: bool) {
    for ((sum, &pixel), &depth) in sums.iter_mut().zip(color).zip(depth) {
        if background || depth > 0.0 {
            let Color { r, g, b } = Color::from_u32(pixel);
            for (sum, code) in sum.iter_mut().zip([r, g, b]) {
                *sum += srgb::decode(code);
            }
            sum[3] += 1.0;
        }
    }
}

/// Averages over the samples that count.
fn resolve(sums: &[[f32; 4]], color: &mut [u32]) {
    for (pixel, &[r, g, b, count]) in color.iter_mut().zip(sums) {
        let [r, g, b] = [r, g, b].map(|sum| if count > 0.0 { srgb::encode(sum / count) } else { 0 });
        *pixel = Color::new(r, g, b).to_u32();
    }
}
