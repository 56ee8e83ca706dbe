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

use winit::application::ApplicationHandler;
use winit::dpi::LogicalSize;
use winit::event::WindowEvent;
use winit::event_loop::{ActiveEventLoop, ControlFlow, EventLoop};
use winit::platform::pump_events::EventLoopExtPumpEvents as _;
use winit::platform::run_on_demand::EventLoopExtRunOnDemand as _;
use winit::window::{Window as OsWindow, WindowId};

use self::convert::Pointer;
use crate::application::Application;
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
}

impl Window {
    fn connect() -> Result<Self, Error> {
        let failed = |what: &str| {
            // winit names the line of its source before the reason.
            let reason = what.strip_prefix("os error at ").and_then(|rest| rest.split_once(": "));
            let reason = reason.map_or(what, |(_, reason)| reason).trim_end_matches('.');
            Error::Window(format!("no window can be opened: {}", one_line(reason)))
        };
        // Where a library of the windowing system is missing, winit panics.
        guard::quietly(|| EventLoop::with_user_event().build())
            .map_err(|panic| failed(&panic))?
            .map(|event_loop| Self { event_loop, open: None })
            .map_err(|error| failed(&error.to_string()))
    }
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
        let mut window = self.window.take().map_or_else(Window::connect, Ok)?;
        let proxy = window.event_loop.create_proxy();
        self.waker().set(move || _ = proxy.send_event(()));
        let mut shell = Shell { app: self, program, open: &mut window.open, failed: None, own_loop: false };
        let ended = window.event_loop.run_app_on_demand(&mut shell);
        let failed = shell.failed.take();
        window.open = None;
        self.window = Some(window);
        self.end();
        let recorded = self.complete_recording();
        failed.map_or(recorded, Err)?;
        ended.map_err(|error| Error::Window(format!("the window was lost: {error}")))
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
        let mut window = self.window.take().map_or_else(Window::connect, Ok)?;
        let mut failed = None;
        loop {
            let due = window.open.as_ref().map(|open| open.next.saturating_duration_since(Instant::now()));
            let open = &mut window.open;
            let mut shell = Shell { app: self, program, open, failed: None, own_loop: true };
            let _ = window.event_loop.pump_app_events(Some(due.unwrap_or_default()), &mut shell);
            failed = failed.or(shell.failed.take());
            let waits = window.open.as_ref().is_none_or(|open| Instant::now() < open.next);
            if !waits || failed.is_some() || self.is_quitting() {
                break;
            }
        }
        if window.open.is_some() && failed.is_none() && !self.is_quitting() {
            let mut shell =
                Shell { app: self, program, open: &mut window.open, failed: None, own_loop: true };
            shell.tick();
            shell.schedule();
            if shell.app.needs_frame() {
                shell.frame();
            }
            failed = shell.failed.take();
        }
        let mut recorded = Ok(());
        if failed.is_some() || self.is_quitting() {
            window.open = None;
            recorded = self.complete_recording();
        }
        self.window = Some(window);
        failed.map_or(recorded, Err)?;
        Ok(!self.is_quitting())
    }
}

/// What winit calls.
struct Shell<'a, P> {
    app: &'a mut Application,
    program: &'a mut P,
    open: &'a mut Option<Open>,
    failed: Option<Error>,
    /// Whether the program has its own loop, so that updates and frames are not for the events to bring about.
    own_loop: bool,
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
    fn tick(&mut self) {
        let Some(open) = self.open else { return };
        let now = Instant::now();
        let step = now.duration_since(open.updated);
        open.updated = now;
        open.news = false;
        let time = open.epoch.elapsed();
        self.app.feed_sent(self.program, time);
        self.app.tick(self.program, step);
        if open.title != self.app.settings.title {
            open.title.clone_from(&self.app.settings.title);
            open.window.set_title(&open.title);
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
        let [width, height] = self.app.settings.size;
        let title = self.app.settings.title.clone();
        let attributes = OsWindow::default_attributes()
            .with_title(&title)
            .with_inner_size(LogicalSize::new(width.max(1), height.max(1)));
        let window = event_loop.create_window(attributes);
        let window = window.map_err(|error| Error::Window(format!("no window can be opened: {error}")))?;
        let window = Arc::new(window);
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
        });
        self.app.feed(self.program, &Event::Resize { size, scale }, Duration::ZERO);
        self.app.begin(self.program);
        Ok(())
    }

    /// Ends the loop when there is a reason to.
    fn leave(&self, event_loop: &ActiveEventLoop) {
        if !self.own_loop && (self.failed.is_some() || self.app.is_quitting()) {
            event_loop.exit();
        }
    }
}

impl<P: Program> ApplicationHandler<()> for Shell<'_, P> {
    fn resumed(&mut self, event_loop: &ActiveEventLoop) {
        if self.open.is_none() && self.failed.is_none() {
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
            if !self.own_loop {
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

    fn about_to_wait(&mut self, event_loop: &ActiveEventLoop) {
        // A window that was lost is opened anew when the program asks for the next frame.
        self.resumed(event_loop);
        if self.own_loop || self.failed.is_some() {
            return;
        }
        let Some(open) = self.open else { return };
        let animated = self.program.animated() || self.app.is_flying();
        let due = Instant::now() >= open.next;
        // An animation goes on at its own pace, whatever happens meanwhile; else news are looked at when they come.
        let updates = if animated { due && !open.asked } else { open.news };
        if updates {
            self.tick();
        }
        self.leave(event_loop);
        let wanted = self.app.needs_frame();
        let Some(open) = self.open else { return };
        if updates && !wanted {
            // What happened changed nothing: no frame will answer it.
            open.unanswered = None;
        }
        if wanted && due && !open.asked {
            open.asked = true;
            open.window.request_redraw();
        } else if updates && animated {
            self.schedule();
        }
        let Some(open) = self.open else { return };
        let wakes = (animated || wanted) && !open.asked;
        event_loop.set_control_flow(if wakes {
            ControlFlow::WaitUntil(open.next)
        } else {
            ControlFlow::Wait
        });
    }
}
