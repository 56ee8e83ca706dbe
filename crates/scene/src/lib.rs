//! polosa-scene.
#![forbid(unsafe_code)]
pub mod camera;
pub mod color;
pub mod mesh;
pub use camera::{Camera, CameraError, FieldOfView, Projection, Ray, ScreenPoint};
pub use color::Color;
pub use mesh::{Colors, Corners, Mesh, MeshError};
