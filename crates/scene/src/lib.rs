//! polosa-scene.
#![forbid(unsafe_code)]
pub mod color;
pub mod mesh;
pub use color::Color;
pub use mesh::{Colors, Corners, Mesh, MeshError};
