//! What is drawn, and the drawing of it: meshes, shapes, a world, a camera, light, pictures, and importers. No
//! window, no files but a model's: those are the business of [polosa](https://docs.rs/polosa).
//!
//! # The contract
//!
//! - A [`Mesh`] has only indices that are in range; its constructors refuse the rest. Positions may be anything.
//! - Handles of the [`World`] stay valid until what they name is removed, and name nothing ever after.
//! - Objects are drawn in the order in which they were added; of two surfaces in one place the first is seen.
//! - The [`Camera`] computes its matrices when asked; none is ever out of date.
//! - Places are `f64` and composed relative to the camera: what is drawn ten million units from the origin is
//!   drawn as it would be at the origin.
//! - Light is computed in linear light and encoded once, to the nearest code. Unlit colours come out as they went
//!   in.
//! - The same calls give the same bytes, on every machine.
//!
//! # The way of a frame
//!
//! ```text
//! import ─▶ mesh ◀─ shape, subdivide
//!             │
//!           world ─▶ draw ─▶ picture ─▶ your pixels
//!             ▲      ▲  ▲
//!           object   │  └ light, srgb, style
//!                  camera
//! ```
//!
//! Read [`draw`] first: it is the whole pipeline on one screen.
//!
//! # Example
//!
//! ```
//! use polosa_math::glam::DVec3;
//! use polosa_scene::{Camera, Light, Object, Picture, PictureSettings, Renderer, Style, World, shape};
//!
//! let mut world = World::new();
//! let cube = world.add_mesh(shape::cube());
//! world.add(Object::new(cube))?;
//!
//! let mut camera = Camera::new();
//! camera.frame(&world.bounds(), DVec3::new(1.0, 0.7, 1.0), DVec3::Y, 0.05)?;
//!
//! let settings = PictureSettings { width: 64, height: 48, ..PictureSettings::default() };
//! let (light, style) = (Light::default(), Style::default());
//! let picture = Picture::render(&mut Renderer::new(), &world, &camera, &light, &style, &settings)?;
//! assert_ne!(picture.pixels[24 * 64 + 32], 0x2b2b2b, "the cube is in the middle");
//! assert_eq!(picture.pixels[0], 0x2b2b2b, "the background in the corner");
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
#![forbid(unsafe_code)]

pub mod camera;
pub mod color;
pub mod draw;
pub mod import;
pub mod light;
pub mod mesh;
mod object;
pub mod occluder;
mod outline;
mod pick;
pub mod picture;
pub mod reference;
mod shades;
pub mod shape;
mod share;
pub mod srgb;
mod stats;
mod style;
pub mod subdivide;
mod timings;
pub mod topology;
pub mod world;

pub use camera::{Camera, CameraError, FieldOfView, Projection, Ray, ScreenPoint};
pub use color::{Color, ParseColorError};
pub use draw::Renderer;
pub use light::{Light, LightSpace, Shading};
pub use mesh::{Colors, Corners, Mesh, MeshError};
pub use object::{Object, Show};
pub use pick::Hit;
pub use picture::{Picture, PictureSettings, Samples};
pub use shape::{Shape, ShapeError};
pub use stats::DrawStats;
pub use style::Style;
pub use subdivide::subdivide;
pub use timings::Timings;
pub use world::{MeshKey, ObjectKey, Revision, World, WorldError};

/// The examples of the README are tests, too.
#[cfg(doctest)]
#[doc = include_str!("../README.md")]
struct Readme;
