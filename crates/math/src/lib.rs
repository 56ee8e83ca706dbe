//! polosa-math.
#![no_std]
#![forbid(unsafe_code)]
pub use glam;
pub mod viewport;
pub use viewport::{SUB_PIXELS, Viewport};
