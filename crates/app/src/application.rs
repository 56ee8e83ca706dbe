//! The application: a world, a camera, a light and settings, and whatever shows them.
//!
//! ```text
//!              events ─▶ input ─▶ program.event ─▶ controls ──▶ camera, light
//!                                                                    │
//!   time ─▶ program.update ─▶ world ─────────────────────────────────┤
//!                                                                    ▼
//!                              has anything changed? ─▶ paint ─▶ program.overlay ─▶ window, file, callback
//! ```
//!
//! There is a window only where [`Application::run`] or [`Application::update`] opens one; [`Application::run_headless`]
//! takes the same steps without.

mod camera;
mod paint;
mod recording;
mod statistics;
mod waker;

use std::time::{Duration, Instant};

use polosa_scene::{Camera, Light, LightSpace, Picture, Renderer, Revision, Style, World};

use self::paint::Painter;
pub(crate) use self::paint::new_renderer;
use self::recording::Recording;
pub use self::statistics::Statistics;
pub use self::waker::Waker;
use crate::canvas::Canvas;
use crate::controls::fly::Fly;
use crate::controls::navigation::Navigation;
use crate::error::Error;
use crate::event::{Event, Handled, Key};
use crate::input::Input;
use crate::program::Program;
use crate::settings::Settings;

/// The longest step that [`Program::update`] is told of: after a pause, things go on instead of jumping.
#[cfg(feature = "window")]
pub(crate) const LONGEST_STEP: Duration = Duration::from_millis(250);

/// No rate is slower than a frame a day.
const LONGEST_PERIOD: Duration = Duration::from_secs(86_400);

/// A window with 3D in it, or the same without the window.
///
/// ```no_run
/// use polosa::math::{axis_angle, glam::DVec3};
/// use polosa::scene::{Object, shape};
/// use polosa::Application;
///
/// let mut app = Application::new();
/// let mesh = app.world.add_mesh(shape::cube());
/// let cube = app.world.add(Object::new(mesh))?;
/// app.run(&mut move |app: &mut Application, step: std::time::Duration| {
///     let turn = axis_angle(DVec3::Y, step.as_secs_f64());
///     turn.and_then(|turn| app.world.turn(cube, turn).ok());
/// })?;
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Debug)]
pub struct Application {
    /// What there is to see. It can be changed at any time, also from hooks; another one can take its place.
    pub world: World,
    /// From where. Its aspect follows the size of what is drawn into.
    pub camera: Camera,
    /// In what light.
    pub light: Light,
    /// How surfaces look.
    pub style: Style,
    /// Everything else.
    pub settings: Settings,
    navigation: Navigation,
    fly: Fly,
    input: Input,
    /// Events that are still to be handled, those of [`send`](Self::send).
    sent: Vec<Event>,
    painter: Painter,
    size: [u32; 2],
    /// The settings' size when it was last obeyed.
    wished: [u32; 2],
    scale: f64,
    /// The time that has passed without a window.
    clock: Duration,
    /// What is on show.
    drawn: Option<Drawn>,
    asked: bool,
    started: bool,
    /// Whether a window says how large the picture is.
    pub(crate) has_window: bool,
    quit: bool,
    statistics: Statistics,
    waker: Waker,
    recording: Option<Recording>,
    /// Why a recording ended by itself.
    record_failed: Option<Error>,
    #[cfg(feature = "window")]
    pub(crate) window: Option<crate::window::Window>,
    /// Why there is no window, and never will be.
    #[cfg(feature = "window")]
    pub(crate) refused: Option<String>,
}

/// All that a picture without an overlay follows from. Numbers that need not be finite stand here as bits: NaN is not
/// what it was a moment ago, and would be drawn for ever.
#[derive(Clone, Debug, PartialEq)]
struct Drawn {
    world: Revision,
    camera: Camera,
    light: ([u64; 3], LightSpace, u32),
    style: Style,
    settings: Settings,
    size: [u32; 2],
}

impl Default for Application {
    fn default() -> Self {
        Self::new()
    }
}

/// # Making one
impl Application {
    /// An application with an empty world, and the settings of [`Settings::default`]. No window is open yet.
    #[must_use]
    pub fn new() -> Self {
        Self::with(Settings::default())
    }

    /// An application with these settings.
    ///
    /// # Panics
    ///
    /// In debug builds, when a side of the size is 0 or the frame rate is not more than 0. In others the size then
    /// counts as 1 and the rate as 60.
    #[must_use]
    pub fn with(settings: Settings) -> Self {
        debug_assert!(settings.size.iter().all(|side| *side > 0), "a window of {:?} pixels", settings.size);
        debug_assert!(settings.frame_rate > 0.0, "a frame rate of {}", settings.frame_rate);
        let (wished, size) = (settings.size, possible(settings.size));
        let mut camera = Camera::new();
        // What every camera can be set to.
        let _ = camera.set_aspect(f64::from(size[0]) / f64::from(size[1]));
        Self {
            world: World::new(),
            camera,
            light: Light::default(),
            style: Style::default(),
            settings,
            navigation: Navigation::default(),
            fly: Fly::default(),
            input: Input::default(),
            sent: Vec::new(),
            painter: Painter::default(),
            size,
            wished,
            scale: 1.0,
            clock: Duration::ZERO,
            drawn: None,
            asked: false,
            started: false,
            has_window: false,
            quit: false,
            statistics: Statistics::default(),
            waker: Waker::default(),
            recording: None,
            record_failed: None,
            #[cfg(feature = "window")]
            window: None,
            #[cfg(feature = "window")]
            refused: None,
        }
    }
}

/// # What it is like now
impl Application {
    /// Width and height of the picture in pixels.
    #[must_use]
    pub const fn size(&self) -> [u32; 2] {
        self.size
    }

    /// How many pixels a unit of the desktop has.
    #[must_use]
    pub const fn scale(&self) -> f64 {
        self.scale
    }

    /// Keyboard and mouse.
    #[must_use]
    pub const fn input(&self) -> &Input {
        &self.input
    }

    /// Counts and times of the frames so far.
    #[must_use]
    pub const fn statistics(&self) -> &Statistics {
        &self.statistics
    }

    /// What other threads wake the application with.
    #[must_use]
    pub fn waker(&self) -> Waker {
        self.waker.clone()
    }
}

/// # What it is told to do
impl Application {
    /// Draws a frame even if nothing has changed: for overlays.
    pub fn redraw(&mut self) {
        self.asked = true;
    }

    /// Ends the application, after the frame that is being made.
    pub fn quit(&mut self) {
        self.quit = true;
    }

    /// Whether it was told to end.
    #[must_use]
    pub const fn is_quitting(&self) -> bool {
        self.quit
    }

    /// Has something happen, as if the user had done it: before the next update.
    pub fn send(&mut self, event: Event) {
        self.sent.push(event);
    }

    /// The picture as it is now, without anything in 2D over it.
    ///
    /// # Errors
    ///
    /// When there is not enough memory for it.
    pub fn picture(&mut self) -> Result<Picture, Error> {
        self.follow_size();
        let [width, height] = self.size;
        let mut pixels = self.blank()?;
        let stats = self.paint(&mut pixels)?;
        Ok(Picture { width, height, pixels, alpha: None, distances: None, ids: None, stats })
    }

    /// Takes so many frames' steps without a window, and hands each picture, numbered from 0, to `take`: to write it
    /// to a file, or to look at it. Every frame is drawn, and takes exactly its time at the frame rate (where that is
    /// infinite, 1/50 s).
    ///
    /// It ends early when the program says so ([`Application::quit`]) or `take` fails. Called again it goes on: the
    /// program is started once, and one that has ended stays so.
    ///
    /// # Errors
    ///
    /// What `take` returns; when there is not enough memory for a picture; and, while frames are [recorded](Self::record), when that fails.
    pub fn run_headless(
        &mut self,
        frames: u64,
        program: &mut impl Program,
        mut take: impl FnMut(u64, &Picture) -> Result<(), Error>,
    ) -> Result<(), Error> {
        let (start, step) = (Instant::now(), self.exact_step());
        self.begin(program);
        for frame in 0..frames {
            let time = step.saturating_mul(u32::try_from(frame).unwrap_or(u32::MAX));
            self.follow_size();
            self.feed_sent(program, self.clock);
            self.clock = self.clock.saturating_add(step);
            self.tick(program, step);
            if self.quit {
                break;
            }
            self.follow_size();
            let [width, height] = self.size;
            let mut pixels = self.blank()?;
            // Frames follow each other at the frame rate, however fast they are drawn.
            let stats = self.draw(program, &mut pixels, start + time)?;
            let picture = Picture { width, height, pixels, alpha: None, distances: None, ids: None, stats };
            self.record_step(&picture)?;
            take(frame, &picture)?;
        }
        Ok(())
    }
}

/// # The steps of a frame, for whoever shows it
impl Application {
    /// The least time between two frames.
    pub(crate) fn period(&self) -> Duration {
        let rate = self.settings.frame_rate;
        let seconds = if rate > 0.0 { 1.0 / rate } else { 1.0 / 60.0 };
        Duration::try_from_secs_f64(seconds).unwrap_or(LONGEST_PERIOD).min(LONGEST_PERIOD)
    }

    /// A frame's time without a window, which is never 0.
    fn exact_step(&self) -> Duration {
        let period = self.period();
        if period.is_zero() { Duration::from_millis(20) } else { period }
    }

    /// Whether there is something to handle.
    #[cfg(feature = "window")]
    pub(crate) const fn has_sent(&self) -> bool {
        !self.sent.is_empty()
    }

    /// Memory for a picture.
    fn blank(&self) -> Result<Vec<u32>, Error> {
        let [width, height] = self.size;
        let count = width as usize * height as usize;
        let mut pixels = Vec::new();
        pixels.try_reserve_exact(count).map_err(|_| {
            let what = format!("not enough memory for {width}×{height} pixels: make it smaller");
            Error::file(&self.settings.title, what)
        })?;
        pixels.resize(count, 0);
        Ok(pixels)
    }

    /// Calls the start hook, the first time.
    pub(crate) fn begin(&mut self, program: &mut impl Program) {
        if !self.started {
            self.started = true;
            program.start(self);
        }
    }

    /// Handles an event that happened at a time, counted from any one moment.
    pub(crate) fn feed(&mut self, program: &mut impl Program, event: &Event, time: Duration) {
        let follows = self.input.take(event, time);
        self.handle(program, event);
        if let Some(event) = follows {
            self.handle(program, &event);
        }
    }

    /// Handles what was sent.
    pub(crate) fn feed_sent(&mut self, program: &mut impl Program, time: Duration) {
        for event in std::mem::take(&mut self.sent) {
            self.feed(program, &event, time);
        }
    }

    fn handle(&mut self, program: &mut impl Program, event: &Event) {
        if let Event::Resize { size, scale } = *event {
            self.size = possible(size);
            self.scale = scale;
            self.wished = self.settings.size;
            self.follow_size();
        }
        if program.event(self, event) == Handled::Yes {
            return;
        }
        match *event {
            Event::Close => self.quit = true,
            Event::Key { key, pressed: true, .. } if self.settings.quit_keys => {
                let control = self.input.modifiers().control;
                self.quit |= key == Key::Escape || control && key == Key::Char('q');
            }
            _ => {}
        }
        self.steer(event);
    }

    /// Moves the camera that flies, and calls the update hook.
    pub(crate) fn tick(&mut self, program: &mut impl Program, step: Duration) {
        self.input.step();
        self.fly_on(step);
        program.update(self, step);
    }

    /// Whether what is on show is not what it should be.
    #[cfg(feature = "window")]
    pub(crate) fn needs_frame(&self) -> bool {
        self.asked || self.settings.continuous || self.drawn.as_ref().is_none_or(|drawn| *drawn != self.now())
    }

    /// Draws a frame, which follows the last one at `due`, into `pixels`, as many as the size says.
    pub(crate) fn draw(
        &mut self,
        program: &mut impl Program,
        pixels: &mut [u32],
        due: Instant,
    ) -> Result<polosa_scene::DrawStats, Error> {
        let start = Instant::now();
        self.asked = false;
        self.follow_size();
        let stats = self.paint(pixels)?;
        self.statistics.frame(due, start.elapsed(), stats);
        let mut canvas = Canvas::new(pixels, self.size, self.scale);
        program.overlay(self, &mut canvas);
        if self.settings.show_rate {
            let text = format!("{:.0} frames/s", self.statistics.rate());
            canvas.text([canvas.pixels_of(6.0); 2], &text, polosa_scene::Color::WHITE);
        }
        self.drawn = Some(self.now());
        Ok(stats)
    }

    /// Draws with another renderer from now on: one whose memory is warm.
    pub(crate) fn adopt(&mut self, renderer: Renderer) {
        self.painter.adopt(renderer);
    }

    fn paint(&mut self, pixels: &mut [u32]) -> Result<polosa_scene::DrawStats, Error> {
        let Self { world, camera, light, style, settings, size, .. } = self;
        self.painter.paint(world, camera, light, style, settings, pixels, *size)
    }

    /// The picture has the size that the settings ask for, unless a window has another, and the camera the picture's
    /// aspect, whatever a program has set it to.
    fn follow_size(&mut self) {
        if self.wished != self.settings.size && !self.has_window {
            self.wished = self.settings.size;
            self.size = possible(self.wished);
        }
        let aspect = f64::from(self.size[0]) / f64::from(self.size[1]);
        if self.camera.aspect() != aspect {
            // A projection whose other angle would then reach 180° keeps its own, and the picture is stretched.
            let _ = self.camera.set_aspect(aspect);
        }
    }

    fn now(&self) -> Drawn {
        Drawn {
            world: self.world.revision(),
            camera: self.camera,
            light: (
                self.light.direction.to_array().map(f64::to_bits),
                self.light.space,
                self.light.ambient.to_bits(),
            ),
            style: self.style,
            // It decides when a picture is drawn, not what is in it.
            settings: Settings { frame_rate: 0.0, ..self.settings.clone() },
            size: self.size,
        }
    }

    /// Makes ready to be run again.
    #[cfg(feature = "window")]
    pub(crate) fn end(&mut self) {
        (self.quit, self.started) = (false, false);
        self.drawn = None;
    }

    #[cfg(feature = "window")]
    pub(crate) const fn statistics_mut(&mut self) -> &mut Statistics {
        &mut self.statistics
    }
}

/// Both sides as a picture can have them.
fn possible(size: [u32; 2]) -> [u32; 2] {
    size.map(|side| side.clamp(1, polosa_raster::MAX_SIDE))
}
