//! From clip space to sub-pixels: the one definition of where a point lands on the screen.
//!
//! ```text
//!   clip space (after division by w)            screen
//!
//!        +1 ┌───────────┐                  (0,0) ┌───────────┐──▶ x
//!           │     ▲ y   │                        │           │
//!           │     └──▶x │          ───▶          │           │
//!        -1 └───────────┘                        └───────────┘
//!          -1          +1                        ▼ y      (W, H) pixels, 256 sub-pixels each
//! ```
//!
//! The raster core snaps with it, the camera projects points with it and casts pick rays back through it, so
//! that all three agree. Everything is `f64`: the map never decides a rounding, its callers do.

use core::ops::{Add, Div, Mul};

/// Sub-pixels along one side of a pixel.
///
/// Direct3D 11 asks for exactly this precision. All bounds on overflow in the raster core rest on it.
pub const SUB_PIXELS: i32 = 256;

/// Where one coordinate lands: the expression itself, for numbers and for lanes of them alike.
#[inline(always)]
pub fn sub_pixels<T>(v: T, w: T, scale: T, offset: T) -> T
where
    T: Div<Output = T> + Mul<Output = T> + Add<Output = T>,
{
    v / w * scale + offset
}

/// The linear map from clip space to the sub-pixels of a picture.
///
/// A point `(x, y, w)` lands at `x / w * scale + offset`, evaluated in `f64` in exactly this order.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Viewport {
    /// Sub-pixels to one unit of `x / w` and of `y / w`.
    pub scale: [f64; 2],
    /// Where the origin of clip space lands, in sub-pixels.
    pub offset: [f64; 2],
}

impl Viewport {
    /// For vertices that are in pixels already: x to the right, y down, the picture's corner at (0, 0).
    pub const SCREEN: Self = Self { scale: [SUB_PIXELS as f64; 2], offset: [0.0; 2] };

    /// Maps the clip cube's front onto a whole picture of `width` × `height` pixels.
    ///
    /// Both factors are exact for every size, so are the picture's corners and its centre.
    #[must_use]
    pub const fn new(width: u32, height: u32) -> Self {
        let half = (SUB_PIXELS / 2) as f64;
        let (w, h) = (half * width as f64, half * height as f64);
        Self { scale: [w, -h], offset: [w, h] }
    }

    /// Where a point of clip space lands, in sub-pixels, not rounded. `w` must not be zero.
    #[inline]
    #[must_use]
    pub fn to_sub_pixels(&self, x: f64, y: f64, w: f64) -> [f64; 2] {
        [sub_pixels(x, w, self.scale[0], self.offset[0]), sub_pixels(y, w, self.scale[1], self.offset[1])]
    }

    /// Where a point of clip space lands, in pixels. `w` must not be zero.
    #[must_use]
    pub fn to_pixels(&self, x: f64, y: f64, w: f64) -> [f64; 2] {
        self.to_sub_pixels(x, y, w).map(|s| s / f64::from(SUB_PIXELS))
    }

    /// The inverse of [`to_pixels`](Self::to_pixels) at `w = 1`: a place on the screen, in pixels, back to
    /// clip space's x and y.
    #[must_use]
    pub fn from_pixels(&self, pixel: [f64; 2]) -> [f64; 2] {
        [0, 1].map(|k| (pixel[k] * f64::from(SUB_PIXELS) - self.offset[k]) / self.scale[k])
    }
}
