//! What of an [`Application`](crate::Application) is settled by values alone. All of it may be changed at any time.

use core::num::NonZeroUsize;

use polosa_scene::reference::Methods;
use polosa_scene::{Color, Samples};

/// Settings of an application.
#[derive(Clone, Debug, PartialEq)]
pub struct Settings {
    /// The window's title.
    pub title: String,
    /// Width and height: of a new window in units of the desktop (pixels times its scale), without a window in pixels.
    /// A user may resize the window; what it has then, [`Application::size`](crate::Application::size) tells.
    pub size: [u32; 2],
    /// The most frames and updates a second; infinite: as many as there is time for.
    pub frame_rate: f64,
    /// Shows the measured frame rate over the picture.
    pub show_rate: bool,
    /// Draws all the time, also when nothing has changed.
    pub continuous: bool,
    /// The colour behind everything.
    pub background: Color,
    /// Samples of a pixel.
    pub samples: Samples,
    /// What is shown of the surfaces.
    pub look: Look,
    /// Draws by methods for comparison instead of exactly: one sample a pixel, surfaces alone.
    pub methods: Option<Methods>,
    /// Threads that draw; `None`: as many as the machine runs at once.
    pub threads: Option<NonZeroUsize>,
    /// What the mouse does to camera and light.
    pub navigation: Navigate,
    /// Whether Esc and Ctrl+Q end the application.
    pub quit_keys: bool,
}

/// What is shown of the surfaces.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, Default)]
#[non_exhaustive]
pub enum Look {
    /// Their colours.
    #[default]
    Shaded,
    /// How far away they are: white for the nearest pixel, dark grey for the farthest.
    Depth,
}

/// What the mouse does, and in flight the keys: see [`controls::navigation`](crate::controls::navigation).
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, Default)]
#[non_exhaustive]
pub enum Navigate {
    /// Nothing.
    Off,
    /// The left button goes round the pivot, up to the poles.
    #[default]
    Orbit,
    /// The left button goes round the pivot any way; there are no poles.
    Trackball,
    /// The keys W, A, S, D, Q and E move the camera, the left button looks around: see
    /// [`controls::fly`](crate::controls::fly).
    Fly,
}

impl Default for Settings {
    /// A window of 1024×768 named "polosa", at most 60 frames a second, drawn when something has changed.
    fn default() -> Self {
        Self {
            title: "polosa".to_owned(),
            size: [1024, 768],
            frame_rate: 60.0,
            show_rate: false,
            continuous: false,
            background: Color::new(0x2b, 0x2b, 0x2b),
            samples: Samples::One,
            look: Look::Shaded,
            methods: None,
            threads: None,
            navigation: Navigate::Orbit,
            quit_keys: true,
        }
    }
}
