//! Pixels to the screen. The only file that knows of softbuffer.

use core::fmt;
use core::num::NonZeroU32;

use winit::raw_window_handle::{HasDisplayHandle, HasWindowHandle};

use crate::error::Error;

/// What a window shows: pixels, drawn straight into the memory that the system takes them from.
pub(crate) struct Screen<W> {
    surface: softbuffer::Surface<W, W>,
    size: [u32; 2],
}

impl<W> fmt::Debug for Screen<W> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("Screen").field("size", &self.size).finish_non_exhaustive()
    }
}

impl<W: HasDisplayHandle + HasWindowHandle + Clone> Screen<W> {
    /// That of a window.
    pub(crate) fn new(window: &W) -> Result<Self, Error> {
        let context = softbuffer::Context::new(window.clone()).map_err(failed)?;
        let surface = softbuffer::Surface::new(&context, window.clone()).map_err(failed)?;
        Ok(Self { surface, size: [0; 2] })
    }

    /// Has `draw` draw `width` × `height` pixels, `0x00RRGGBB`, row by row, and shows them. A window without pixels,
    /// one that is minimised, shows nothing.
    pub(crate) fn present(
        &mut self,
        size: [u32; 2],
        draw: impl FnOnce(&mut [u32]) -> Result<(), Error>,
    ) -> Result<(), Error> {
        let [Some(width), Some(height)] = size.map(NonZeroU32::new) else { return Ok(()) };
        if self.size != size {
            self.surface.resize(width, height).map_err(failed)?;
            self.size = size;
        }
        let mut pixels = self.surface.buffer_mut().map_err(failed)?;
        draw(&mut pixels)?;
        pixels.present().map_err(failed)
    }
}

#[expect(clippy::needless_pass_by_value, reason = "what `map_err` hands over")]
fn failed(error: softbuffer::SoftBufferError) -> Error {
    Error::Window(format!("the picture cannot be shown: {error}"))
}
