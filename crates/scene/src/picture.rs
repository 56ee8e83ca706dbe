//! A finished picture, with whatever else of it was asked for.
//!
//! Each sample of its pixels is a frame of its own. Where depth or sums of samples are needed, the picture is filled in
//! bands of rows, so that those take 80 MiB at most, however large it is. A band has the same bytes as those rows of the
//! whole.

use core::num::NonZeroUsize;
use core::ops::Range;

use polosa_raster::{Depth, MAX_SIDE, Sample, StoredDepth, Target, TargetError};

use crate::draw::View;
use crate::{Camera, Color, DrawStats, Light, Renderer, Style, World};
use crate::{share, srgb};

/// The most pixels whose depth and sums are kept at a time: 16 MiB of depth, and four times that of sums when there are
/// several samples.
const BAND: usize = 1 << 22;

/// Bands are so many rows or a multiple of it, those of a frame's tiles, so that no tile is drawn for two of them.
const TILE: usize = 64;

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
    /// Threads that draw, 256 at most; no number of them changes a bit. `None`: as many as the renderer has. If it has
    /// another number, its memory is of no use to the picture.
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
        let size = pixels(width, height)?;
        let mut picture = Self {
            width,
            height,
            pixels: vec![0; size],
            alpha: settings.background.is_none().then(|| vec![0; size]),
            distances: settings.distances.then(|| vec![f32::INFINITY; size]),
            ids: settings.ids.then(|| vec![0; size]),
            stats: DrawStats::default(),
        };
        let view = View { world, camera, light, style };
        let mut other = None;
        let renderer = match settings.threads.map(|threads| threads.get().min(256)) {
            Some(threads) if threads != renderer.threads() => other.insert(Renderer::with_threads(threads)),
            _ => renderer,
        };
        renderer.forget_timings();
        if let Some(ids) = &mut picture.ids {
            let mut target = Target::new(ids, Depth::None, width, height, width as usize)?;
            let style = Style { sample: Sample::CENTER, ..*style };
            renderer.frame_ids(world, camera, &style, &mut target)?;
        }
        let several = settings.samples != Samples::One;
        let with_depth = settings.distances || settings.background.is_none() || renderer.needs_depth(world);
        let rows = if several || with_depth {
            (BAND / width as usize / TILE * TILE).min(height as usize)
        } else {
            height as usize
        };
        let length = width as usize * rows;
        let mut work = Work {
            settings,
            depth: with_depth.then(|| vec![0.0; length]),
            sums: vec![[0.0; 4]; if several { length } else { 0 }],
            set_up: None,
            stats: DrawStats::default(),
        };
        for band in picture.bands(rows) {
            work.band(renderer, &view, band)?;
        }
        picture.stats = work.stats;
        Ok(picture)
    }

    /// The picture in bands of so many rows.
    fn bands(&mut self, rows: usize) -> Vec<Band<'_>> {
        let size = [self.width, self.height];
        let length = self.width as usize * rows;
        let mut alpha = self.alpha.as_mut().map(|alpha| alpha.chunks_mut(length));
        let mut distances = self.distances.as_mut().map(|distances| distances.chunks_mut(length));
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
            })
            .collect()
    }
}

/// The number of pixels of a picture, if it is possible: to be asked before memory is taken for it.
pub(crate) fn pixels(width: u32, height: u32) -> Result<usize, TargetError> {
    if [width, height].iter().any(|side| !(1..=MAX_SIDE).contains(side)) {
        return Err(TargetError::Size { width, height });
    }
    Ok(width as usize * height as usize)
}

/// Some rows of a picture.
struct Band<'a> {
    size: [u32; 2],
    rows: Range<u32>,
    pixels: &'a mut [u32],
    alpha: Option<&'a mut [u8]>,
    distances: Option<&'a mut [f32]>,
}

/// What is needed for filling bands.
struct Work<'a> {
    settings: &'a PictureSettings,
    /// Of one band, if anybody asks for it.
    depth: Option<Vec<f32>>,
    /// Light and count of the samples of one band, if there are several.
    sums: Vec<[f32; 4]>,
    /// The sample that the renderer's frame is of, and what became of its triangles.
    set_up: Option<(Sample, DrawStats)>,
    /// What became of the whole scene's triangles, at the last sample.
    stats: DrawStats,
}

impl Work<'_> {
    /// Fills a band.
    fn band(&mut self, renderer: &mut Renderer, view: &View<'_>, band: Band<'_>) -> Result<(), TargetError> {
        let threads = renderer.threads();
        let PictureSettings { background, samples, distances, .. } = *self.settings;
        let length = band.pixels.len();
        let several = samples != Samples::One;
        if several {
            share::pieces(threads, &mut self.sums[..length], &|_, sums| sums.fill([0.0; 4]));
            for sample in samples.grid() {
                self.sample(renderer, view, sample, &band.rows, band.size, band.pixels)?;
                let depth = self.depth.as_deref().filter(|_| background.is_none());
                let pixels = &*band.pixels;
                share::pieces(threads, &mut self.sums[..length], &|first, sums| {
                    add_sample(sums, &pixels[first..], depth.map(|depth| &depth[first..]));
                });
            }
        }
        // The centre comes last, so that its depth is there for the distances.
        if !several || distances {
            self.sample(renderer, view, Sample::CENTER, &band.rows, band.size, band.pixels)?;
        }
        if several {
            let sums = &self.sums;
            share::pieces(threads, band.pixels, &|first, pixels| resolve(&sums[first..], pixels));
        }
        let (sums, depth) = (&self.sums, self.depth.as_deref().unwrap_or_default());
        if let Some(alpha) = band.alpha {
            let samples = f32::from(samples.side() * samples.side());
            share::pieces(threads, alpha, &|first, alpha| {
                for (k, alpha) in (first..).zip(alpha) {
                    let covered =
                        if several { sums[k][3] / samples } else { f32::from(u8::from(depth[k] > 0.0)) };
                    *alpha = (covered * 255.0 + 0.5) as u8;
                }
            });
        }
        if let Some(distances) = band.distances {
            share::pieces(threads, distances, &|first, distances| {
                for (distance, &depth) in distances.iter_mut().zip(&depth[first..]) {
                    *distance = if depth > 0.0 { view.camera.distance(depth) as f32 } else { f32::INFINITY };
                }
            });
        }
        Ok(())
    }

    /// Draws one sample of a band's pixels.
    fn sample(
        &mut self,
        renderer: &mut Renderer,
        view: &View<'_>,
        sample: Sample,
        rows: &Range<u32>,
        size: [u32; 2],
        pixels: &mut [u32],
    ) -> Result<(), TargetError> {
        let style = Style { sample, ..*view.style };
        let view = View { style: &style, ..*view };
        self.stats = match self.set_up {
            Some((same, stats)) if same == sample => stats,
            _ => renderer.set_up(&view, size, self.settings.background, StoredDepth::F32(0.0))?,
        };
        self.set_up = Some((sample, self.stats));
        let depth = match &mut self.depth {
            Some(depth) => Depth::F32(depth),
            None => Depth::None,
        };
        let mut target = Target::band(pixels, depth, size, size[0] as usize, rows.clone())?;
        self.stats += renderer.fill(&view, &mut target)?;
        // Every band counts all lines.
        self.stats += renderer.lines(&view, &mut target);
        Ok(())
    }
}

/// Adds the light of one sample, and whether it counts: with a background all do, without one what is covered, which
/// depth tells.
fn add_sample(sums: &mut [[f32; 4]], color: &[u32], depth: Option<&[f32]>) {
    for (k, (sum, &pixel)) in sums.iter_mut().zip(color).enumerate() {
        if depth.is_none_or(|depth| depth[k] > 0.0) {
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
