//! polosa-scene.
#![forbid(unsafe_code)]
pub mod camera;
pub mod color;
pub mod mesh;
pub use camera::{Camera, CameraError, FieldOfView, Projection, Ray, ScreenPoint};
pub use color::Color;
pub use mesh::{Colors, Corners, Mesh, MeshError};
pub mod shape;
pub use shape::{Shape, ShapeError};
pub mod subdivide;
pub use subdivide::subdivide;
pub mod world;
pub use world::{MeshKey, Object, ObjectKey, Show, World, WorldError};
pub mod draw;
pub use draw::Renderer;
pub mod light;
pub use light::{Light, LightSpace, Shading};
pub mod picture;
pub use picture::{Picture, PictureSettings, Samples};
pub mod srgb;
mod stats;
pub use stats::DrawStats;
mod style;
pub use style::Style;
mod outline;
pub mod import;
pub mod topology;

/// The examples of the README are tests, too.
#[cfg(doctest)]
#[doc = include_str!("../README.md")]
struct Readme;
