//! What a user's program adds to an [`Application`]: hooks, all of which may be left out.

use std::time::Duration;

use crate::application::Application;
use crate::canvas::Canvas;
use crate::event::{Event, Handled};

/// The hooks of a program.
///
/// A closure `|app, step| …` is a program that only has [`update`](Self::update); `()` is one without any hook.
///
/// ```
/// use std::time::Duration;
/// use polosa::event::{Event, Handled, Key};
/// use polosa::scene::{Object, ObjectKey, shape};
/// use polosa::{Application, Program};
///
/// /// A cube that the space bar makes and removes.
/// #[derive(Default)]
/// struct Toggle(Option<ObjectKey>);
///
/// impl Program for Toggle {
///     fn event(&mut self, app: &mut Application, event: &Event) -> Handled {
///         let Event::Key { key: Key::Space, pressed: true, .. } = event else { return Handled::No };
///         self.0 = match self.0 {
///             Some(cube) => app.world.remove(cube).and(None),
///             None => {
///                 let mesh = app.world.add_mesh(shape::cube());
///                 app.world.add(Object::new(mesh)).ok()
///             }
///         };
///         Handled::Yes
///     }
/// }
///
/// let mut app = Application::new();
/// app.send(Event::Key { key: Key::Space, pressed: true, repeat: false });
/// app.run_headless(1, &mut Toggle::default(), |_, picture| {
///     assert_eq!(picture.stats.objects, 1);
///     Ok(())
/// })?;
/// # Ok::<(), polosa::Error>(())
/// ```
pub trait Program {
    /// Called once, before anything else: the window, if there is one, is open.
    fn start(&mut self, _app: &mut Application) {}

    /// Called before a frame: at the frame rate if the program is [`animated`](Self::animated), else after events, and
    /// after a [wake](crate::Waker). `step` is the time since the last call, a quarter of a second at most; without a
    /// window it is exactly one frame's time.
    fn update(&mut self, _app: &mut Application, _step: Duration) {}

    /// Whether [`update`](Self::update) is called all the time. What it leaves unchanged is not drawn anew.
    fn animated(&self) -> bool {
        true
    }

    /// Something happened. The camera and the light follow the mouse unless this says [`Handled::Yes`].
    fn event(&mut self, _app: &mut Application, _event: &Event) -> Handled {
        Handled::No
    }

    /// Draws over a finished frame. What it draws must follow from what the application holds, or the program must ask
    /// for a frame ([`Application::redraw`]) when it would draw something else.
    fn overlay(&mut self, _app: &Application, _canvas: &mut Canvas<'_>) {}
}

impl<F: FnMut(&mut Application, Duration)> Program for F {
    fn update(&mut self, app: &mut Application, step: Duration) {
        self(app, step);
    }
}

impl Program for () {
    fn animated(&self) -> bool {
        false
    }
}
