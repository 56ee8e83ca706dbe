//! A window, and its loop. The only file that knows of winit.
//!
//! ```text
//!   run      winit calls us: events ─▶ about to wait: update, ask for a frame ─▶ frame ─▶ about to wait ─▶ ...
//!   update   we call winit:  events until a frame is due ─▶ update ─▶ frame ─▶ back to the program
//! ```
//!
//! Nothing is drawn that is on show already, and without an animation nothing is done at all until something happens.

mod convert;

use core::fmt;
use std::sync::Arc;
use std::time::{Duration, Instant};

use polosa_raster::MAX_SIDE;
use winit::application::ApplicationHandler;
use winit::dpi::{LogicalSize, PhysicalSize};
use winit::event::{DeviceEvent, DeviceId, WindowEvent};
use winit::event_loop::{ActiveEventLoop, ControlFlow, EventLoop};
use winit::platform::pump_events::{EventLoopExtPumpEvents as _, PumpStatus};
use winit::platform::run_on_demand::EventLoopExtRunOnDemand as _;
use winit::window::{Window as OsWindow, WindowId};

use self::convert::Pointer;
use crate::application::{Application, LONGEST_STEP};
use crate::error::{Error, one_line};
use crate::event::Event;
use crate::guard;
use crate::log::critical;
use crate::present::Screen;
use crate::program::Program;

/// The connection to the windowing system, of which a process has one, and the window, while it is open.
pub(crate) struct Window {
    event_loop: EventLoop<()>,
    open: Option<Open>,
}

impl fmt::Debug for Window {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("Window").field("open", &self.open).finish_non_exhaustive()
    }
}

/// An open window.
#[derive(Debug)]
struct Open {
    window: Arc<OsWindow>,
    screen: Screen<Arc<OsWindow>>,
    title: String,
    pointer: Pointer,
    /// When the window was opened: events are timed from here.
    epoch: Instant,
    /// When the update hook was called last.
    updated: Instant,
    /// No frame before this.
    next: Instant,
    /// The first event that no frame has answered yet.
    unanswered: Option<Instant>,
    /// Whether there are events, or somebody woke us, since the last update.
    news: bool,
    /// Whether winit was asked to have us draw.
    asked: bool,
    /// Whether the last update was one of an animation.
    animated: bool,
    /// The size that the settings had when the window was last given it.
    wished: [u32; 2],
}

impl Window {
    fn connect() -> Result<Self, Error> {
        // Where a library of the windowing system is missing, winit panics.
        guard::quietly(|| EventLoop::with_user_event().build())
            .map_err(|panic| refused(&panic))?
            .map(|event_loop| Self { event_loop, open: None })
            .map_err(|error| refused(&error.to_string()))
    }
}

/// That there is no window, why, and what to do.
fn refused(what: &str) -> Error {
    // winit names the line of its source before the reason.
    let reason = what.strip_prefix("os error at ").and_then(|rest| rest.split_once(": "));
    let reason = one_line(reason.map_or(what, |(_, reason)| reason).trim_end_matches('.'));
    Error::Window(format!("no window can be opened: {}", with_advice(&reason)))
}

/// winit's reason, with what to do: where it is a library that is missing, to install it.
fn with_advice(reason: &str) -> String {
    if reason.contains("xlib") {
        // It does not say which.
        "libX11, libX11-xcb, libXcursor or libXi, or what they need, cannot be loaded: install them"
            .to_owned()
    } else if reason.starts_with("Library ") {
        format!("{reason}: install it")
    } else {
        format!("{reason}: start it on a desktop, or draw to a file")
    }
}

fn lost(what: &str) -> Error {
    Error::Window(format!("the window was lost: {}: start it again", one_line(what)))
}

/// # Windows
impl Application {
    /// Opens a window and runs the program until the user, or the program, ends it.
    ///
    /// A process has one window: of two applications the second is refused one. The same may be run again.
    ///
    /// # Errors
    ///
    /// When no window can be opened, it can no longer be drawn into, or a [recording](Self::record) that went on to the
    /// end cannot be completed. The error is logged: to the program's `tracing`
    /// subscriber, or where there is none to standard error. World and camera are as they were.
    pub fn run(&mut self, program: &mut impl Program) -> Result<(), Error> {
        critical(self.run_unlogged(program))
    }

    /// The same, for a caller who tells of errors himself.
    pub(crate) fn run_unlogged(&mut self, program: &mut impl Program) -> Result<(), Error> {
        let mut window = self.take_window()?;
        let proxy = window.event_loop.create_proxy();
        self.waker().set(move || _ = proxy.send_event(()));
        let mut shell = Shell { app: self, program, open: &mut window.open, failed: None, own: Own::No };
        let ended = window.event_loop.run_app_on_demand(&mut shell);
        let failed = shell.failed.take();
        self.waker().forget();
        self.has_window = false;
        self.window = Some(window);
        self.end();
        let recorded = self.complete_recording();
        failed.map_or(recorded, Err)?;
        ended.map_err(|error| lost(&error.to_string()))
    }

    /// The connection to the windowing system. A process may ask for it once: what was the answer is the answer.
    fn take_window(&mut self) -> Result<Window, Error> {
        if let Some(reason) = &self.refused {
            return Err(Error::Window(reason.clone()));
        }
        let window = self.window.take().map_or_else(Window::connect, Ok);
        self.refused = window.as_ref().err().map(Error::to_string);
        window
    }

    /// For programs that have their own loop: handles what happened, waits until a frame is due, and shows it if
    /// something has changed. The first call opens the window. Whether the application goes on: once this is `false`,
    /// further calls do nothing.
    ///
    /// ```no_run
    /// use polosa::scene::{Object, shape};
    /// use polosa::{Application, math::glam::DVec3};
    ///
    /// let mut app = Application::new();
    /// let mesh = app.world.add_mesh(shape::cube());
    /// let cube = app.world.add(Object::new(mesh))?;
    /// while app.update()? {
    ///     app.world.move_by(cube, DVec3::new(0.01, 0.0, 0.0))?;
    /// }
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    ///
    /// # Errors
    ///
    /// As [`run`](Self::run). After an error the next call tries again.
    pub fn update(&mut self) -> Result<bool, Error> {
        self.update_with(&mut ())
    }

    /// [`update`](Self::update) with hooks.
    ///
    /// # Errors
    ///
    /// As that.
    pub fn update_with(&mut self, program: &mut impl Program) -> Result<bool, Error> {
        critical(self.step(program))
    }

    fn step(&mut self, program: &mut impl Program) -> Result<bool, Error> {
        if self.is_quitting() {
            return Ok(false);
        }
        let mut window = self.take_window()?;
        let mut failed = None;
        loop {
            let due = window.open.as_ref().map(|open| open.next.saturating_duration_since(Instant::now()));
            failed = failed.or(window.pump(self, program, due.unwrap_or_default(), Own::Runs));
            let waits = window.open.as_ref().is_none_or(|open| Instant::now() < open.next);
            if !waits || failed.is_some() || self.is_quitting() {
                break;
            }
        }
        if window.open.is_some() && failed.is_none() && !self.is_quitting() {
            let open = &mut window.open;
            let mut shell = Shell { app: self, program, open, failed: None, own: Own::Runs };
            shell.tick(true);
            shell.schedule();
            if shell.app.needs_frame() {
                shell.frame();
            } else if let Some(open) = shell.open {
                open.unanswered = None;
            }
            failed = shell.failed.take();
        }
        let mut recorded = Ok(());
        if failed.is_some() || self.is_quitting() {
            // Once more, for the system to hear of it.
            let _ = window.pump(self, program, Duration::ZERO, Own::Ends);
            self.has_window = false;
            recorded = self.complete_recording();
        }
        self.window = Some(window);
        failed.map_or(recorded, Err)?;
        Ok(!self.is_quitting())
    }
}

impl Window {
    /// Handles what has happened, and what happens within a time.
    fn pump(
        &mut self,
        app: &mut Application,
        program: &mut impl Program,
        time: Duration,
        own: Own,
    ) -> Option<Error> {
        let mut shell = Shell { app, program, open: &mut self.open, failed: None, own };
        let status = self.event_loop.pump_app_events(Some(time), &mut shell);
        let failed = shell.failed.take();
        match status {
            PumpStatus::Continue => failed,
            PumpStatus::Exit(_) => failed.or_else(|| Some(lost("the desktop has ended"))),
        }
    }
}

/// Whether the program has its own loop, so that updates and frames are not for the events to bring about.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Own {
    No,
    Runs,
    /// The window is closed.
    Ends,
}

/// A size in units of the desktop.
fn logical([width, height]: [u32; 2]) -> LogicalSize<u32> {
    LogicalSize::new(width.clamp(1, MAX_SIDE), height.clamp(1, MAX_SIDE))
}

/// What winit calls.
struct Shell<'a, P> {
    app: &'a mut Application,
    program: &'a mut P,
    open: &'a mut Option<Open>,
    failed: Option<Error>,
    own: Own,
}

impl<P: Program> Shell<'_, P> {
    /// Handles an event.
    fn feed(&mut self, event: &Event) {
        let Some(open) = self.open else { return };
        open.news = true;
        open.unanswered.get_or_insert_with(Instant::now);
        let time = open.epoch.elapsed();
        self.app.feed(self.program, event, time);
    }

    /// Has the program updated.
    fn tick(&mut self, animated: bool) {
        let Some(open) = self.open else { return };
        let (now, period) = (Instant::now(), self.app.period());
        // An animation that begins after a rest has no time to catch up with.
        let longest = if open.animated { LONGEST_STEP.max(period) } else { period };
        let step = now.duration_since(open.updated).min(longest);
        open.updated = now;
        open.news = false;
        open.animated = animated;
        let time = open.epoch.elapsed();
        self.app.feed_sent(self.program, time);
        self.app.tick(self.program, step);
        if open.title != self.app.settings.title {
            open.title.clone_from(&self.app.settings.title);
            open.window.set_title(&open.title);
        }
        if open.wished != self.app.settings.size {
            open.wished = self.app.settings.size;
            // Where the answer is no event, the desktop decides alone.
            let _ = open.window.request_inner_size(logical(open.wished));
        }
    }

    /// Settles, when a frame is begun, when the next may be: a period after this one was due, or after now if that is
    /// past already. What a frame takes is no pause to wait for.
    fn schedule(&mut self) {
        if let Some(open) = self.open {
            let (now, period) = (Instant::now(), self.app.period());
            open.next = if now < open.next + period { open.next + period } else { now + period };
        }
    }

    /// Draws and shows a frame.
    fn frame(&mut self) {
        let Some(open) = self.open else { return };
        open.asked = false;
        let size = open.window.inner_size();
        if size.width == 0 || size.height == 0 {
            open.unanswered = None;
            return;
        }
        let (app, program) = (&mut *self.app, &mut *self.program);
        // Both sides up to the greatest: a window across more screens than that keeps its last columns as they were.
        let shown = open.screen.present(app.size(), |pixels| {
            app.draw(program, pixels, Instant::now())?;
            app.record_live(pixels);
            Ok(())
        });
        match shown {
            Ok(()) => {
                if let Some(event) = open.unanswered.take() {
                    self.app.statistics_mut().answered(event.elapsed());
                }
            }
            Err(error) => self.failed = Some(error),
        }
    }

    fn open_window(&mut self, event_loop: &ActiveEventLoop) -> Result<(), Error> {
        let title = self.app.settings.title.clone();
        let wished = self.app.settings.size;
        // Larger sides than that are no pictures, and some systems have no number for them.
        let attributes = OsWindow::default_attributes()
            .with_title(&title)
            .with_inner_size(logical(wished))
            .with_max_inner_size(PhysicalSize::new(MAX_SIDE, MAX_SIDE));
        let window = event_loop.create_window(attributes);
        let window = Arc::new(window.map_err(|error| refused(&error.to_string()))?);
        let screen = Screen::new(&window)?;
        let now = Instant::now();
        let (size, scale) = (<[u32; 2]>::from(window.inner_size()), window.scale_factor());
        *self.open = Some(Open {
            window,
            screen,
            title,
            pointer: Pointer::default(),
            epoch: now,
            updated: now,
            next: now,
            unanswered: None,
            news: true,
            asked: false,
            animated: false,
            wished,
        });
        self.app.has_window = true;
        self.app.feed(self.program, &Event::Resize { size, scale }, Duration::ZERO);
        self.app.begin(self.program);
        Ok(())
    }

    /// Ends the loop when there is a reason to.
    fn leave(&self, event_loop: &ActiveEventLoop) {
        if self.own == Own::No && (self.failed.is_some() || self.app.is_quitting()) {
            event_loop.exit();
        }
    }
}

impl<P: Program> ApplicationHandler<()> for Shell<'_, P> {
    fn resumed(&mut self, event_loop: &ActiveEventLoop) {
        if self.open.is_none() && self.failed.is_none() && self.own != Own::Ends {
            self.failed = self.open_window(event_loop).err();
            self.leave(event_loop);
        }
    }

    fn user_event(&mut self, _: &ActiveEventLoop, (): ()) {
        if let Some(open) = self.open {
            open.news = true;
        }
    }

    fn window_event(&mut self, event_loop: &ActiveEventLoop, _: WindowId, event: WindowEvent) {
        let Some(open) = self.open else { return };
        if matches!(event, WindowEvent::RedrawRequested) {
            // Also when a part of the window was uncovered: what it shows may be gone.
            if self.own == Own::No {
                self.schedule();
                self.frame();
            } else {
                self.app.redraw();
            }
        } else if let Some(event) = open.pointer.event(&event, &open.window) {
            self.feed(&event);
        }
        self.leave(event_loop);
    }

    fn device_event(&mut self, _: &ActiveEventLoop, _: DeviceId, event: DeviceEvent) {
        if let Some(open) = self.open {
            open.pointer.device_event(&event);
        }
    }

    fn about_to_wait(&mut self, event_loop: &ActiveEventLoop) {
        if self.own == Own::Ends {
            *self.open = None;
            return;
        }
        // A window that was lost is opened anew when the program asks for the next frame.
        self.resumed(event_loop);
        if self.own == Own::Runs || self.failed.is_some() {
            return;
        }
        let Some(open) = self.open else { return };
        let animated = self.program.animated() || self.app.is_flying();
        let due = Instant::now() >= open.next;
        // An animation goes on at its own pace, whatever happens meanwhile; else news are looked at when they come.
        let updates = if animated { due && !open.asked } else { open.news || self.app.has_sent() };
        if updates {
            self.tick(animated);
        }
        self.leave(event_loop);
        let wanted = self.app.needs_frame();
        let Some(open) = self.open else { return };
        if updates && !wanted {
            // What happened changed nothing: no frame will answer it.
            open.unanswered = None;
        }
        // The update may have begun an animation, or ended one.
        let animated = self.program.animated() || self.app.is_flying();
        if wanted && due && !open.asked {
            open.asked = true;
            open.window.request_redraw();
        } else if updates && animated {
            self.schedule();
        }
        let Some(open) = self.open else { return };
        event_loop.set_control_flow(if self.app.has_sent() && !animated {
            ControlFlow::Poll
        } else if (animated || wanted) && !open.asked {
            ControlFlow::WaitUntil(open.next)
        } else {
            ControlFlow::Wait
        });
    }

    fn exiting(&mut self, _: &ActiveEventLoop) {
        // Now, while the system is still told of it.
        *self.open = None;
    }
}
