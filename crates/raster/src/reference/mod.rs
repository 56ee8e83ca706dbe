//! The methods that polosa is measured against: small, plain, in scalar code, chosen by name and never by default.
//!
//! They come from five documents that teach drawing solids without a graphics library, and from what rasterisers
//! commonly do. Each is kept as its source has it: no slower, no worse. Where something had to be completed or
//! mended, its own page says so.
//!
//! | source | fills by | hides by |
//! |---|---|---|
//! | S0, a tetrahedron viewer in Java (Russian) | [`Coverage::Barycentric`] | [`Hidden::Order`], then [`Hidden::Barycentric`] |
//! | S1, a camera in Java (Chinese): draws lines | [`Coverage::WholePixels`] | |
//! | S2, a sphere in C++ (Chinese) | | [`Hidden::Order`] |
//! | S3, a rewrite of S0 (English) | [`Coverage::SameSide`] | [`Hidden::Sum`] |
//! | S4, a renderer in C++ (Russian) | [`Coverage::VerticalStripsClosed`], mended [`Coverage::VerticalStrips`] | [`Hidden::StripPrinted`], mended [`Hidden::StripLinear`] |
//! | common practice | [`Coverage::FloatEdges`], [`Coverage::FloatScan`] | [`Hidden::Painter`], [`Hidden::PlaneF32Origin`], [`Hidden::PlaneF32Vertex`], [`Hidden::PlaneF64`] |
//! | this crate | [`Coverage::Strips`], [`Coverage::Edges`] | [`Hidden::Exact`] |
//!
//! ```text
//!  vertices ─ clip, ÷w, map ─▶ corners in pixels, f64 ─ coverage ─▶ pixels, runs ─ hidden ─▶ your pixels
//!            (the crate's own)          ▲              which pixels?              which triangle?
//!                                 draw_screen
//! ```
//!
//! Coverage and hidden surfaces combine freely. A pair that one seed has together, S0's, shares its work as it does
//! there. Where a way to hide needs what a way to fill does not have (S4's strip), it makes it for itself.
//!
//! Beside them: [`attribute`], which is how a value runs over a triangle, and [`DepthFormat`], which is what becomes of a
//! depth that is stored.
//!
//! Whatever the input, no method panics and none takes longer than the picture is large: their failures are wrong
//! pixels. What an integer cannot hold saturates, as in Java.

pub mod attribute;
mod barycentric;
mod coverage;
mod draw;
mod exact;
mod float_edges;
mod float_scan;
mod format;
mod grid;
mod hidden;
mod names;
mod pieces;
mod same_side;
mod surface;
mod vertical;
mod zbuffer;

pub use coverage::{Coverage, Visit};
pub use draw::{draw, draw_screen};
pub use format::DepthFormat;
pub use hidden::Hidden;
pub use names::UnknownName;
pub use zbuffer::ZBuffer;

/// A triangle's corner on the screen: x to the right and y down, in pixels, not snapped; z the depth, larger is nearer.
pub type Corner = [f64; 3];

/// How to draw: by default exactly.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, Default)]
pub struct Methods {
    /// Which pixels a triangle covers.
    pub coverage: Coverage,
    /// Which triangle is seen.
    pub hidden: Hidden,
}
