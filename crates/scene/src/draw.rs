//! The drawing of a world: the whole pipeline on one screen.
//!
//! ```text
//!   world, camera ─▶ surfaces, in order ─▶ frame: set up, sorted into tiles ─▶ tiles filled ─▶ target
//!                           │                                                                    ▲
//!                           └─▶ or one by one, over what is there ───────────────────────────────┤
//!                    edges over surfaces, then wire ─────────────────────────────────────────────┘
//! ```
//!
//! [`Renderer::frame`] makes a whole picture, several times sooner and with several threads; [`Renderer::draw`] draws over
//! one. Both draw the same in the same order, and give the same bytes.

mod blended;
mod hidden;
mod over;
mod surface;

use std::thread;

use polosa_raster::{
    Clip, Depth, Frame, Level, State, Stats, StoredDepth, Target, TargetError, Triangles, Vertices, transform,
};

use self::blended::{Blended, Format};
use self::hidden::Hidden;
use self::surface::Take;
pub(crate) use self::surface::{Paint, Surface};
use crate::light::LANES;
use crate::shades::Shades;
use crate::share;
use crate::timings::{Clock, Timings};
use crate::{Camera, Color, Colors, DrawStats, Light, Mesh, Object, Show, Style, World};

/// Ways of showing that draw triangles.
pub(crate) const SURFACES: &[Show] = &[Show::Surface, Show::Both];
/// Ways of showing that draw lines.
const LINES: &[Show] = &[Show::Both, Show::Wire];

/// Draws worlds. It keeps its working memory from one frame to the next.
#[derive(Debug)]
pub struct Renderer {
    frame: Frame,
    /// The vector registers that light is computed in.
    level: fearless_simd::Level,
    /// The vertices of one object in clip space, where the frame has no use for them.
    clip: Vec<Clip>,
    /// The intensity of each triangle of one object.
    intensities: Vec<f32>,
    /// The pixels of the last colour that was worth a table.
    shades: Option<Shades>,
    /// What is blended when a frame's tiles are done.
    blended: Blended,
    /// Whether the frame has no surfaces, since they could not be numbered: they are drawn one by one.
    overflows: bool,
    /// What is left of a mesh that hides parts of itself.
    hidden: Hidden,
    /// For targets without.
    depth: Vec<f32>,
    timings: Timings,
}

/// What is looked at, and how.
#[derive(Clone, Copy)]
pub(crate) struct View<'a> {
    pub(crate) world: &'a World,
    pub(crate) camera: &'a Camera,
    pub(crate) light: &'a Light,
    pub(crate) style: &'a Style,
}

impl Default for Renderer {
    fn default() -> Self {
        Self::new()
    }
}

impl Clone for Renderer {
    /// One for as many threads, with memory of its own.
    fn clone(&self) -> Self {
        Self::with_threads(self.threads())
    }
}

/// # A whole picture
impl Renderer {
    /// A renderer for as many threads as the machine runs at once. It has no memory yet.
    #[must_use]
    pub fn new() -> Self {
        Self::with_threads(thread::available_parallelism().map_or(1, usize::from))
    }

    /// A renderer for so many threads, 1 to 256 (other numbers count as the nearest). No number of them changes a bit.
    ///
    /// The work is cut into so many pieces for rayon's threads; without the feature `parallel` one does them all.
    #[must_use]
    pub fn with_threads(threads: usize) -> Self {
        Self {
            frame: Frame::with(Level::detect(), threads),
            level: fearless_simd::Level::new(),
            clip: Vec::new(),
            intensities: Vec::new(),
            shades: None,
            blended: Blended::default(),
            overflows: false,
            hidden: Hidden::default(),
            depth: Vec::new(),
            timings: Timings::default(),
        }
    }

    /// Into how many pieces the work is cut.
    #[must_use]
    pub const fn threads(&self) -> usize {
        self.frame.threads()
    }

    /// Where the time of the last picture went, over all of its samples.
    #[must_use]
    pub const fn timings(&self) -> Timings {
        self.timings
    }

    pub(crate) fn forget_timings(&mut self) {
        self.timings = Timings::default();
    }

    /// Draws a world as a camera sees it before a background (`None`: 0), a whole picture of pixels `0x00RRGGBB`:
    /// what [`draw`](Self::draw) gives on a cleared target with depth, to the last bit.
    ///
    /// What the target held is gone. It needs no depth; if it has some, it gets the picture's.
    ///
    /// ```
    /// use polosa_raster::{Depth, Target};
    /// use polosa_scene::{Camera, Color, Light, Object, Renderer, Style, World, shape};
    ///
    /// let mut world = World::new();
    /// let cube = world.add_mesh(shape::cube());
    /// world.add(Object::new(cube))?;
    /// let mut camera = Camera::new();
    /// camera.frame(&world.bounds(), [1.0, 0.7, 1.0].into(), [0.0, 1.0, 0.0].into(), 0.05)?;
    ///
    /// let mut pixels = [0; 40 * 30];
    /// let mut target = Target::new(&mut pixels, Depth::None, 40, 30, 40)?;
    /// let (light, style, mut renderer) = (Light::default(), Style::default(), Renderer::new());
    /// let stats = renderer.frame(&world, &camera, &light, &style, Some(Color::WHITE), &mut target)?;
    /// assert_eq!((stats.objects, stats.triangles.drawn), (1, 12));
    /// assert_eq!(pixels[0], 0xffffff);
    /// assert_ne!(pixels[15 * 40 + 20], 0xffffff);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    ///
    /// # Errors
    ///
    /// None, for targets as they can be made today.
    pub fn frame(
        &mut self,
        world: &World,
        camera: &Camera,
        light: &Light,
        style: &Style,
        background: Option<Color>,
        target: &mut Target<'_, u32>,
    ) -> Result<DrawStats, TargetError> {
        let view = View { world, camera, light, style };
        if !self.needs_depth(world) || depth_of(target).is_some() {
            return self.frame_with_depth(&view, background, target);
        }
        let mut depth = std::mem::take(&mut self.depth);
        // No more than the target's pixels reach: a row alone may have any stride.
        let before = (target.rows().len() - 1) * target.stride();
        depth.resize(before + target.width() as usize, 0.0);
        let with_depth = target.with_depth(Depth::F32(&mut depth));
        let stats = with_depth.and_then(|mut target| self.frame_with_depth(&view, background, &mut target));
        self.depth = depth;
        stats
    }

    /// Whether more than a frame's tiles must keep depth: what lines are hidden by, for one.
    pub(crate) fn needs_depth(&self, world: &World) -> bool {
        self.overflows_with(world) || shown(world, LINES).next().is_some()
    }

    fn overflows_with(&self, world: &World) -> bool {
        let blended = |(object, mesh): (&Object, &Mesh)| {
            if object.color.is_none() && matches!(mesh.colors(), Colors::Vertex(_)) {
                mesh.triangles().len() as u64
            } else {
                0
            }
        };
        shown(world, SURFACES).map(blended).sum::<u64>() > self.blended.most
    }

    fn frame_with_depth(
        &mut self,
        view: &View<'_>,
        background: Option<Color>,
        target: &mut Target<'_, u32>,
    ) -> Result<DrawStats, TargetError> {
        self.forget_timings();
        let depth = depth_of(target).unwrap_or(StoredDepth::F32(0.0));
        let mut stats = self.set_up(view, [target.width(), target.height()], background, depth)?;
        stats += self.fill(view, target)?;
        stats += self.lines(view, target);
        Ok(stats)
    }

    /// Starts a frame, and prepares all surfaces.
    pub(crate) fn set_up(
        &mut self,
        view: &View<'_>,
        size: [u32; 2],
        background: Option<Color>,
        depth: StoredDepth,
    ) -> Result<DrawStats, TargetError> {
        let clock = Clock::start();
        let mut stats = DrawStats::default();
        self.blended.clear();
        self.frame.begin(size, background.map_or(0, Color::to_u32), cleared(depth))?;
        self.overflows = self.overflows_with(view.world);
        if self.overflows {
            return Ok(stats);
        }
        for (object, mesh) in shown(view.world, SURFACES) {
            let surface = Surface::new(view, object, mesh);
            let first = if surface.paint.is_blended() { self.blended.number(&surface) } else { 0 };
            let hidden = self.hidden.leave_out(self.level, view, &surface, size, depth);
            stats.hidden += hidden.unwrap_or(0);
            let (vertices, triangles, places) = match hidden {
                Some(_) => {
                    let Hidden { clip, triangles, places, .. } = &self.hidden;
                    (Vertices::Clip(clip), triangles.as_slice(), Some(places.as_slice()))
                }
                None => (surface.vertices(), mesh.triangles(), None),
            };
            let state = view.style.state();
            let (frame, level) = (&mut self.frame, self.level);
            let into = IntoFrame { frame, level, state, surface: &surface, vertices, triangles, places };
            stats.triangles += surface.give(&mut self.shades, into, |index| first + index as u32);
            stats.objects += 1;
        }
        self.timings.setup += clock.stop();
        Ok(stats)
    }

    /// Fills a target, the whole picture or some rows of it, with the frame that was set up.
    pub(crate) fn fill(
        &mut self,
        view: &View<'_>,
        target: &mut Target<'_, u32>,
    ) -> Result<DrawStats, TargetError> {
        let clock = Clock::start();
        if self.blended.is_empty() {
            self.frame.finish(target)?;
        } else {
            let sixteen = matches!(depth_of(target), Some(StoredDepth::U16(_)));
            let format = Format { size: self.frame.size(), sixteen };
            let mut blender = self.blended.blender(view.world, &view.style.state(), format);
            self.frame.resolve(target, move |sampled| blender.pixel(sampled))?;
        }
        let stats = if self.overflows { self.surfaces(view, target) } else { DrawStats::default() };
        self.timings.fill += clock.stop();
        Ok(stats)
    }

    /// Fills a target with the number of the triangle at each pixel, plus one: its place among all the triangles of
    /// the visible surfaces, in the order of drawing. Where nothing is: 0.
    ///
    /// What the target held is gone. It needs no depth; if it has some, it gets the picture's.
    ///
    /// # Errors
    ///
    /// None, for targets as they can be made today.
    pub fn frame_ids(
        &mut self,
        world: &World,
        camera: &Camera,
        style: &Style,
        target: &mut Target<'_, u32>,
    ) -> Result<DrawStats, TargetError> {
        let mut stats = DrawStats::default();
        let mut first = 1_u32;
        let depth = cleared(depth_of(target).unwrap_or(StoredDepth::F32(0.0)));
        self.frame.begin([target.width(), target.height()], 0, depth)?;
        for (object, mesh) in shown(world, SURFACES) {
            let matrix = camera.clip_from_model(&object.placement);
            let vertices = Vertices::Model { matrix: &matrix, positions: mesh.positions() };
            let triangles = Triangles::Indexed(mesh.triangles());
            let id = |index: usize| first.wrapping_add(index as u32);
            stats.triangles += self.frame.draw(&style.state(), 0, vertices, triangles, id);
            stats.objects += 1;
            first = first.wrapping_add(mesh.triangles().len() as u32);
        }
        self.frame.finish(target)?;
        Ok(stats)
    }
}

/// # Lines
impl Renderer {
    /// Draws edges over surfaces, then wire.
    pub(crate) fn lines(&mut self, view: &View<'_>, target: &mut Target<'_, u32>) -> DrawStats {
        let clock = Clock::start();
        let mut stats = DrawStats::default();
        let state = view.style.state();
        let threads = self.threads();
        for (object, mesh) in shown(view.world, &[Show::Both]) {
            let Some(outline) = view.world.outline(object.mesh()) else { continue };
            self.transform(view.camera, object, mesh);
            let (clip, edges) = (&self.clip, &outline.edges);
            let color = view.style.edge_color.to_u32();
            let around = |edge| outline.around(mesh, edge);
            stats.lines += share::bands(threads, edges.len(), target, |band| {
                band.edges(&state, clip, edges, around, color)
            });
        }
        for (object, mesh) in shown(view.world, &[Show::Wire]) {
            let Some(outline) = view.world.outline(object.mesh()) else { continue };
            self.transform(view.camera, object, mesh);
            let (clip, edges) = (&self.clip, &outline.edges);
            let color = object.color.unwrap_or(view.style.color).to_u32();
            stats.lines +=
                share::bands(threads, edges.len(), target, |band| band.lines(&state, clip, edges, color));
            stats.objects += 1;
        }
        self.timings.lines += clock.stop();
        stats
    }

    fn transform(&mut self, camera: &Camera, object: &Object, mesh: &Mesh) {
        let matrix = camera.clip_from_model(&object.placement);
        self.clip.resize(mesh.positions().len(), [0.0; 4]);
        transform(&matrix, mesh.positions(), &mut self.clip);
    }
}

/// Draws a surface, or what is left of it, into a frame.
struct IntoFrame<'a> {
    frame: &'a mut Frame,
    level: fearless_simd::Level,
    state: State,
    surface: &'a Surface<'a>,
    vertices: Vertices<'a>,
    triangles: &'a [[u32; 3]],
    /// The triangles' places among all of the surface's; `None`: they are all.
    places: Option<&'a [u32]>,
}

impl Take<Stats> for IntoFrame<'_> {
    fn take(self, shade: impl Fn(usize, f32) -> u32 + Sync) -> Stats {
        let Self { frame, level, state, surface, vertices, triangles, places } = self;
        let positions = surface.mesh.positions();
        let blended = surface.paint.is_blended();
        let values = |first: usize, asked: u32, values: &mut [u32; LANES]| {
            let eight = &triangles[first..triangles.len().min(first + LANES)];
            // What is blended is lit when it is.
            let asked_of_light = if blended { 0 } else { asked };
            let intensities = surface.lighting.eight(level, positions, eight, asked_of_light);
            for lane in (0..LANES).filter(|lane| asked >> lane & 1 == 1) {
                let place = places.map_or(first + lane, |places| places[first + lane] as usize);
                values[lane] = shade(place, intensities[lane]);
            }
        };
        frame.draw_eights(&state, 0, vertices, Triangles::Indexed(triangles), values)
    }
}

/// What is stored for a target's first pixel, if it keeps depth.
fn depth_of(target: &Target<'_, u32>) -> Option<StoredDepth> {
    target.depth_at(0, target.rows().start)
}

/// The depth that anything is nearer than, in the format of another.
const fn cleared(format: StoredDepth) -> StoredDepth {
    match format {
        StoredDepth::F32(_) => StoredDepth::F32(0.0),
        StoredDepth::U16(_) => StoredDepth::U16(0),
    }
}

/// The visible objects that are shown in one of some ways, in the order in which they were added.
pub(crate) fn shown<'a>(world: &'a World, ways: &'a [Show]) -> impl Iterator<Item = (&'a Object, &'a Mesh)> {
    world
        .objects()
        .map(|(_, object)| object)
        .filter(|object| object.visible && ways.contains(&object.show))
        .filter_map(|object| Some((object, world.mesh(object.mesh())?)))
}
