//! A finished frame, to be drawn over in 2D with [`embedded_graphics`]: lines, rectangles, circles, text, and whatever
//! else draws on a [`DrawTarget`].
//!
//! ```
//! use polosa::canvas::{Canvas, embedded_graphics as eg};
//! use eg::{pixelcolor::Rgb888, prelude::*, primitives::{Circle, PrimitiveStyle}};
//!
//! let mut pixels = [0; 8 * 6];
//! let mut canvas = Canvas::new(&mut pixels, [8, 6], 1.0);
//! Circle::new(Point::new(-2, -2), 5).into_styled(PrimitiveStyle::with_fill(Rgb888::RED)).draw(&mut canvas)?;
//! assert_eq!((pixels[0], pixels[47]), (0xff0000, 0));
//! # Ok::<(), core::convert::Infallible>(())
//! ```

use core::convert::Infallible;

pub use embedded_graphics;
use embedded_graphics::Pixel;
use embedded_graphics::draw_target::DrawTarget;
use embedded_graphics::geometry::{Dimensions, OriginDimensions, Point, Size};
use embedded_graphics::mono_font::{MonoFont, MonoTextStyle, iso_8859_1};
use embedded_graphics::pixelcolor::{Rgb888, RgbColor as _};
use embedded_graphics::primitives::Rectangle;
use embedded_graphics::text::{Baseline, Text};
use polosa_scene::Color;

/// Pixels of a frame, `0x00RRGGBB`. What is drawn beside them is left out.
#[derive(Debug)]
pub struct Canvas<'a> {
    pixels: &'a mut [u32],
    size: [u32; 2],
    scale: f64,
    font: Option<&'static MonoFont<'static>>,
}

impl<'a> Canvas<'a> {
    /// A canvas of `width` × `height` pixels, row by row. `scale` is how many pixels a unit of the desktop has.
    ///
    /// # Panics
    ///
    /// When there are not `width` × `height` pixels.
    #[must_use]
    pub fn new(pixels: &'a mut [u32], [width, height]: [u32; 2], scale: f64) -> Self {
        assert_eq!(pixels.len(), width as usize * height as usize, "pixels of a canvas of {width}×{height}");
        Self { pixels, size: [width, height], scale, font: None }
    }

    /// Width and height in pixels.
    #[must_use]
    pub const fn dimensions(&self) -> [u32; 2] {
        self.size
    }

    /// How many pixels a unit of the desktop has: what should look the same on every screen is multiplied by this.
    #[must_use]
    pub const fn scale(&self) -> f64 {
        self.scale
    }

    /// The pixels, row by row, for a program that draws them itself: as a [`Target`](polosa_raster::Target), say.
    #[must_use]
    pub const fn pixels_mut(&mut self) -> &mut [u32] {
        self.pixels
    }

    /// A length in units of the desktop as whole pixels, 1 at least.
    #[must_use]
    pub fn pixels_of(&self, units: f64) -> i32 {
        ((units * self.scale + 0.5) as i32).max(1)
    }

    /// The font of overlays: of a size that suits the screen, unless another was [set](Self::set_font).
    #[must_use]
    pub fn font(&self) -> &'static MonoFont<'static> {
        if let Some(font) = self.font {
            return font;
        }
        match self.scale {
            scale if scale < 1.25 => &iso_8859_1::FONT_7X13,
            scale if scale < 1.75 => &iso_8859_1::FONT_9X18,
            _ => &iso_8859_1::FONT_10X20,
        }
    }

    /// Writes in another font from now on; `None`: in the usual one.
    pub const fn set_font(&mut self, font: Option<&'static MonoFont<'static>>) {
        self.font = font;
    }

    /// Writes lines of text, the first one's upper left corner at `at`, in the font of overlays. Signs beyond
    /// Latin-1 become question marks.
    pub fn text(&mut self, at: [i32; 2], text: &str, color: Color) {
        let style = MonoTextStyle::new(self.font(), rgb(color));
        let text = Text::with_baseline(text, Point::new(at[0], at[1]), style, Baseline::Top);
        let Ok(_) = embedded_graphics::Drawable::draw(&text, self);
    }

    /// Width and height of lines of text in the font of overlays.
    #[must_use]
    pub fn text_size(&self, text: &str) -> [i32; 2] {
        let style = MonoTextStyle::new(self.font(), Rgb888::WHITE);
        let bounds = Text::with_baseline(text, Point::zero(), style, Baseline::Top).bounding_box();
        [bounds.size.width as i32, bounds.size.height as i32]
    }

    /// Darkens a rectangle, so that text over it can be read: each code is brought to a quarter.
    pub fn dim(&mut self, at: [i32; 2], size: [i32; 2]) {
        let area =
            Rectangle::new(Point::new(at[0], at[1]), Size::new(size[0].max(0) as u32, size[1].max(0) as u32));
        let area = area.intersection(&self.bounding_box());
        let width = self.size[0] as usize;
        for y in area.rows() {
            let first = y as usize * width + area.top_left.x as usize;
            for pixel in &mut self.pixels[first..first + area.size.width as usize] {
                *pixel = *pixel >> 2 & 0x3f_3f3f;
            }
        }
    }
}

/// A colour as `embedded-graphics` has it.
#[must_use]
pub fn rgb(color: Color) -> Rgb888 {
    Rgb888::new(color.r, color.g, color.b)
}

fn code(color: Rgb888) -> u32 {
    Color::new(color.r(), color.g(), color.b()).to_u32()
}

impl OriginDimensions for Canvas<'_> {
    fn size(&self) -> Size {
        Size::new(self.size[0], self.size[1])
    }
}

impl DrawTarget for Canvas<'_> {
    type Color = Rgb888;
    type Error = Infallible;

    fn draw_iter<I: IntoIterator<Item = Pixel<Self::Color>>>(&mut self, pixels: I) -> Result<(), Infallible> {
        let [width, height] = self.size;
        for Pixel(Point { x, y }, color) in pixels {
            if let (Ok(x), Ok(y)) = (u32::try_from(x), u32::try_from(y))
                && x < width
                && y < height
            {
                self.pixels[y as usize * width as usize + x as usize] = code(color);
            }
        }
        Ok(())
    }

    fn fill_solid(&mut self, area: &Rectangle, color: Rgb888) -> Result<(), Infallible> {
        let area = area.intersection(&self.bounding_box());
        let width = self.size[0] as usize;
        for y in area.rows() {
            let first = y as usize * width + area.top_left.x as usize;
            self.pixels[first..first + area.size.width as usize].fill(code(color));
        }
        Ok(())
    }
}

#[cfg(test)]
mod tests {
    use embedded_graphics::prelude::*;
    use embedded_graphics::primitives::{PrimitiveStyle, Rectangle};
    use polosa_scene::Color;

    use super::{Canvas, rgb};

    #[test]
    fn what_lies_beside_the_frame_is_left_out() {
        let mut pixels = vec![7; 6];
        let mut canvas = Canvas::new(&mut pixels, [3, 2], 1.0);
        let style = PrimitiveStyle::with_fill(rgb(Color::WHITE));
        for at in [Point::new(2, 1), Point::new(i32::MAX - 9, 0), Point::new(-9, -9)] {
            let Ok(()) = Rectangle::new(at, Size::new(9, 9)).into_styled(style).draw(&mut canvas);
        }
        assert_eq!(pixels, [7, 7, 7, 7, 7, 0xff_ffff]);
    }

    #[test]
    fn text_is_as_large_as_is_said_and_dimmed_pixels_keep_their_hue() {
        let mut pixels = vec![0x80_4020; 100 * 40];
        let mut canvas = Canvas::new(&mut pixels, [100, 40], 1.0);
        let size = canvas.text_size("ab\nc");
        canvas.dim([-5, -5], [30, 300]);
        canvas.text([30, 3], "ab\nc", Color::WHITE);
        assert_eq!((pixels[0], pixels[24], pixels[25]), (0x20_1008, 0x20_1008, 0x80_4020));
        let white: Vec<_> = (0..4000).filter(|k| pixels[*k] == 0xff_ffff).collect();
        assert!(!white.is_empty());
        let [right, lower] = [30 + size[0] as usize, 3 + size[1] as usize];
        assert!(white.iter().all(|k| (30..right).contains(&(k % 100)) && (3..lower).contains(&(k / 100))));
    }
}
