//! What a renderer needs beside [`glam`] and glam leaves out: projections, views, the viewport, frustums, bounds,
//! rotations that do not drift, and placements that do not jitter.
//!
//! # Conventions
//!
//! | thing | convention |
//! |---|---|
//! | world | right-handed, +Y up |
//! | camera | looks down its own −Z; its axes are U right, V up, N backward |
//! | matrices | glam's: column vectors, `clip = projection * view * model * p` |
//! | clip space | x right, y up, reversed z: 1 at the near plane, 0 at the far plane or at infinity; visible where `0 <= z <= w` |
//! | screen | pixels, the origin at the top left, y down, the centre of pixel (i, j) at (i + ½, j + ½) |
//! | angles | radians, turning by the right-hand rule |
//!
//! Each line is a test in `tests/conventions.rs`.
//!
//! # The same bits everywhere
//!
//! All functions here but those of [`mod@reference`] work in `f64` with + − × ÷ √ in a fixed order, and take sines
//! and tangents from `libm`, never from the platform. Three facts about glam 0.34 make its double types fit for that:
//!
//! - `DVec3`, `DQuat`, `DMat4` and the others are plain scalar code on all targets. Only the `f32` types come in
//!   SSE2, NEON and WebAssembly versions, and these differ in their last bits: do not let them decide a pixel.
//! - With its feature `libm`, which this crate turns on, glam's own `sin`, `cos`, `tan`, … are libm's **even when
//!   another crate in the build turns on its feature `std`**: the standard library's are compiled in only
//!   without `libm` (`f64/math.rs`).
//! - `mul_add` is the only fused operation; nothing here calls it.
//!
//! # An example
//!
//! ```
//! use polosa_math::glam::DVec3;
//! use polosa_math::{Basis, Placement, Viewport, clip_from_model, perspective_vertical};
//!
//! // A camera far from the origin, looking at an object three units in front of it, one to the right.
//! let eye = DVec3::new(1e7, 0.0, 1e7);
//! let basis = Basis::looking(DVec3::NEG_Z, DVec3::Y);
//! let projection = perspective_vertical(90_f64.to_radians(), 4.0 / 3.0, 1.0, f64::INFINITY).unwrap();
//! let object = Placement::at(eye + DVec3::new(1.0, 0.0, -3.0));
//!
//! // One matrix of f32, composed in f64: the ten millions have cancelled before rounding.
//! let m = clip_from_model(&projection, &basis.rotation(), eye, &object);
//! let [x, y, z, w] = m[3].map(f64::from); // where the object's own origin goes
//!
//! let pixel = Viewport::new(800, 600).to_pixels(x, y, w);
//! assert!((pixel[0] - 500.0).abs() < 1e-4 && pixel[1] == 300.0);
//! assert_eq!(z / w, 1.0 / 3.0); // reversed: near / distance
//! ```

#![no_std]
#![forbid(unsafe_code)]

pub use glam;

pub mod bounds;
pub mod frustum;
pub mod matrix;
pub mod placement;
pub mod projection;
pub mod reference;
pub mod rotation;
pub mod view;
pub mod viewport;

pub use bounds::Bounds;
pub use frustum::{Containment, Frustum, Plane};
pub use matrix::{Matrix, coordinates};
pub use placement::{Placement, clip_from_model, clip_from_model_f64, rounded};
pub use projection::{
    Planes, orthographic, orthographic_planes, perspective_horizontal, perspective_planes,
    perspective_vertical,
};
pub use rotation::{axis_angle, heading_pitch_roll, normalized, to_heading_pitch_roll, turn};
pub use view::{Basis, unit};
pub use viewport::{SUB_PIXELS, Viewport};

/// The examples of the README are tests, too.
#[cfg(doctest)]
#[doc = include_str!("../README.md")]
struct Readme;
