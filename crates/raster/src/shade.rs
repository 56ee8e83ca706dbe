//! What is written: one value a triangle, or whatever a closure makes of a fragment.

use crate::Weights;

/// Decides what a covered, nearer pixel becomes.
///
/// [`Flat`] and [`PerTriangle`] are the fast ways; a closure `Fn(&Fragment, &mut P) -> bool` can look at the
/// fragment's place, depth and weights, blend with what is there, and discard by returning `false`, which
/// leaves pixel and stored depth as they were.
pub trait Shade<P> {
    /// Whether every fragment is kept and none looks at what is there already, so that none is kept for when it is discarded.
    const OPAQUE: bool = false;

    /// One value for a whole triangle, asked at most once for each; `None`: ask [`fragment`](Self::fragment).
    fn triangle(&self, index: usize) -> Option<P> {
        let _ = index;
        None
    }

    /// Writes a fragment to `pixel`, which holds what is there; `false` discards it, whatever was written.
    fn fragment(&self, fragment: &Fragment<'_>, pixel: &mut P) -> bool;
}

/// The same value everywhere.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Flat<P>(pub P);

impl<P: Copy> Shade<P> for Flat<P> {
    const OPAQUE: bool = true;

    #[inline]
    fn triangle(&self, _: usize) -> Option<P> {
        Some(self.0)
    }

    #[inline]
    fn fragment(&self, _: &Fragment<'_>, pixel: &mut P) -> bool {
        *pixel = self.0;
        true
    }
}

/// One value for each triangle, from its place in the draw call.
#[derive(Clone, Copy, Debug)]
pub struct PerTriangle<F>(pub F);

impl<P: Copy, F: Fn(usize) -> P> Shade<P> for PerTriangle<F> {
    const OPAQUE: bool = true;

    #[inline]
    fn triangle(&self, index: usize) -> Option<P> {
        Some((self.0)(index))
    }

    #[inline]
    fn fragment(&self, fragment: &Fragment<'_>, pixel: &mut P) -> bool {
        *pixel = (self.0)(fragment.triangle());
        true
    }
}

impl<P, F: Fn(&Fragment<'_>, &mut P) -> bool> Shade<P> for F {
    #[inline]
    fn fragment(&self, fragment: &Fragment<'_>, pixel: &mut P) -> bool {
        self(fragment, pixel)
    }
}

/// One triangle at one pixel.
#[derive(Clone, Copy, Debug)]
pub struct Fragment<'a> {
    pub(crate) x: u32,
    pub(crate) y: u32,
    pub(crate) depth: f32,
    pub(crate) triangle: usize,
    pub(crate) weights: &'a Weights,
}

impl Fragment<'_> {
    /// The pixel's column.
    #[must_use]
    pub const fn x(&self) -> u32 {
        self.x
    }

    /// The pixel's row in the whole picture, in a band too.
    #[must_use]
    pub const fn y(&self) -> u32 {
        self.y
    }

    /// The depth at the pixel's sample, from 0 (far) to 1 (near).
    #[must_use]
    pub const fn depth(&self) -> f32 {
        self.depth
    }

    /// The triangle's place in the draw call.
    #[must_use]
    pub const fn triangle(&self) -> usize {
        self.triangle
    }

    /// The perspective-correct weights of the triangle's three vertices; computed when asked.
    #[inline]
    #[must_use]
    pub fn weights(&self) -> [f32; 3] {
        self.weights.at(self.x, self.y)
    }
}
