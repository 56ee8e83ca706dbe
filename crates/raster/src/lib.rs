//! The raster core of [polosa](https://docs.rs/polosa): triangles and lines from clip space into slices that
//! you own, exactly. No `std`, no `unsafe`, and no allocator unless you want whole [frames](#frames).
//!
//! # The contract
//!
//! A vertex is four `f32` in clip space. From there to the pixel everything is defined to the last bit, on
//! every machine:
//!
//! - **Snap.** Vertices go to the nearest 1/256 pixel, ties to even.
//! - **Coverage.** A pixel belongs to a triangle if its centre lies inside the snapped one; a centre on a side
//!   belongs to it if that is a left or a top side. Triangles that share a side share no pixel and leave none
//!   out.
//! - **Depth.** Within 5·2⁻²⁴ of the plane through the vertices' depths, relative, however thin or steep the
//!   triangle. Larger is nearer; the first drawn wins a tie.
//! - **Weights.** Perspective-correct, by true division.
//! - **Order.** Triangles are drawn in the order given. In which order a triangle's vertices are given changes
//!   only which side it shows.
//!
//! Coordinates that are infinite or NaN, indices that are out of range, triangles behind the eye: counted in
//! [`Stats`], never drawn, never a panic.
//!
//! # The way of a triangle
//!
//! ```text
//! vertices ─ transform ─▶ clip ─▶ snap ─▶ triangle ─▶ strip ─▶ depth ─▶ fill ─▶ your pixels
//!                                          (sort)                        ▲
//!                                                                        shade: a value or a closure
//! ```
//!
//! Read the modules in this order.
//!
//! # Frames
//!
//! With the feature `alloc`, a `Frame` takes all triangles of a picture before it draws the first, sorts them into
//! tiles, and draws each tile in the nearest cache, eight pixels at a time: the same stages in another sequence, the
//! same bytes, sooner. The feature `std` finds the vector instructions of the machine that runs it,
//! `parallel` shares the work between threads, `scalar` adds the scalar level for comparison; none changes a pixel.
//! [`Target::triangles`] needs none of this, and can blend and discard, which frames cannot.
//!
//! # Example
//!
//! A triangle into an array:
//!
//! ```
//! use polosa_raster::{Depth, DepthTest, Flat, State, Target};
//!
//! let (mut color, mut depth) = ([b' '; 16 * 8], [0.0; 16 * 8]);
//! let mut target = Target::new(&mut color, Depth::F32(&mut depth), 16, 8, 16)?;
//! target.clear(b'.', DepthTest::Greater);
//!
//! let corners = [[-0.8, -0.8, 0.5, 1.0], [0.8, -0.8, 0.5, 1.0], [0.0, 0.9, 0.5, 1.0]];
//! let stats = target.triangles(&State::default(), &corners, &[[0, 1, 2]], &Flat(b'#'));
//!
//! assert_eq!(stats.drawn, 1);
//! assert_eq!(target.color_at(8, 4), Some(b'#'));
//! assert_eq!(target.color_at(0, 0), Some(b'.'));
//! # Ok::<(), polosa_raster::TargetError>(())
//! ```
#![no_std]
#![forbid(unsafe_code)]
#![warn(
    clippy::cast_possible_truncation,
    clippy::cast_possible_wrap,
    clippy::cast_sign_loss,
    clippy::cast_precision_loss,
    clippy::std_instead_of_core,
    clippy::std_instead_of_alloc,
    reason = "every conversion of the core says what it rounds"
)]

#[cfg(feature = "alloc")]
extern crate alloc;
#[cfg(feature = "std")]
extern crate std;

mod clip;
mod deferred;
mod depth;
mod edge;
mod fill;
#[cfg(feature = "alloc")]
mod frame;
mod line;
mod outline;
#[cfg(feature = "alloc")]
pub mod reference;
mod setup;
mod shade;
mod snap;
mod state;
mod stats;
mod strip;
mod target;
mod transform;
mod triangle;
mod weights;

/// A vertex in clip space: x right, y up, reversed z (1 at the near plane, 0 at the far one), w; visible where
/// `0 <= z <= w`.
pub type Clip = [f32; 4];

pub use deferred::Deferred;
pub use depth::DepthPlane;
#[cfg(feature = "alloc")]
pub use frame::{Frame, Level, Sampled, Triangles, Vertices};
pub use shade::{Flat, Fragment, PerTriangle, Shade};
pub use snap::Corner;
pub use state::{Cull, DepthTest, Rect, Sample, Space, State};
pub use stats::Stats;
pub use strip::{Strip, Strips};
pub use target::{Depth, MAX_SIDE, StoredDepth, Target, TargetError};
pub use transform::{Columns, transform, transform_point};
pub use triangle::{Facing, Triangle};
pub use weights::Weights;

/// The examples of the README are tests, too.
#[cfg(all(doctest, feature = "alloc"))]
#[doc = include_str!("../README.md")]
struct Readme;
