//! Whether two renderers drew the same picture.
//!
//! Rules of coverage and precisions of depth differ between renderers, so a few pixels on edges, and where two
//! triangles meet in depth, may differ. More than [`MOST`] of the picture, and a row is not comparable: it may have
//! been timed for drawing less.

/// The share of a picture's pixels that may differ.
pub(crate) const MOST: f64 = 0.001;

/// What a lit pixel's channels may differ by, in codes of 255: others compute normals in `f32`, and llvmpipe encodes
/// sRGB by an approximate power. Numbers of triangles must be equal.
const LIT: u8 = 2;

/// How a picture compares with ours.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Difference {
    /// Pixels that differ, as a share of the picture.
    pub(crate) share: f64,
    /// Of those, pixels where one of the two drew nothing: edges against the background.
    pub(crate) coverage: f64,
    /// Pixels of ours, and of theirs, on which something was drawn, as shares of the picture.
    pub(crate) covered: [f64; 2],
}

impl Difference {
    pub(crate) fn of(ours: &[u32], theirs: &[u32], lit: bool) -> Self {
        let pixels = ours.len().max(1) as f64;
        let most = if lit { LIT } else { 0 };
        let differ = |a: u32, b: u32| {
            a.to_be_bytes().into_iter().zip(b.to_be_bytes()).any(|(a, b)| a.abs_diff(b) > most)
        };
        let differing = || ours.iter().zip(theirs).filter(|&(&a, &b)| differ(a, b));
        let covered = |picture: &[u32]| picture.iter().filter(|&&pixel| pixel != 0).count() as f64 / pixels;
        let missing = ours.len().abs_diff(theirs.len());
        Self {
            share: (differing().count() + missing) as f64 / pixels,
            coverage: differing().filter(|&(&a, &b)| (a == 0) != (b == 0)).count() as f64 / pixels,
            covered: [covered(ours), covered(theirs)],
        }
    }

    /// Whether times may be compared.
    pub(crate) fn comparable(&self) -> bool {
        self.share <= MOST && self.covered[0] > 0.0
    }
}
