//! 3D pictures without a GPU: exact, and the same bytes on every machine.
//!
//! This is the library of the program `polosa`: an [`Application`], a window with 3D in it or the same without one, and
//! what it is made of ([`event`], [`input`], [`controls`], [`canvas`], [`record`]); a [`viewer`] of [models](model);
//! pictures as files ([`encode`], [`pfm`], [`output`]), read back
//! ([`decode`]) and held against each other ([`compare`]), and the [command line](cli) itself. What draws is in the
//! layers below, which are re-exported so that one dependency is enough: [`scene`] (meshes, importers, world,
//! camera), [`raster`] (triangles into slices), [`math`].
//!
//! # A picture of a model
//!
//! ```
//! use polosa::encode::{ImageFormat, write_picture};
//! use polosa::math::glam::DVec3;
//! use polosa::scene::{
//!     Camera, Color, Light, Object, Picture, PictureSettings, Renderer, Style, World, shape,
//! };
//!
//! let mut world = World::new();
//! let torus = world.add_mesh(shape::torus(48, 24)?);
//! world.add(Object::new(torus).colored(Color::new(0xd9, 0x80, 0x32)))?;
//!
//! let settings = PictureSettings { width: 160, height: 120, ..PictureSettings::default() };
//! let mut camera = Camera::new();
//! camera.frame(&world.bounds(), DVec3::new(1.0, 0.7, 1.0), DVec3::Y, 0.05)?;
//!
//! let picture = Picture::render(
//!     &mut Renderer::new(), &world, &camera, &Light::default(), &Style::default(), &settings,
//! )?;
//! let mut png = Vec::new();
//! write_picture(&mut png, ImageFormat::Png, &picture)?;
//! assert!(png.starts_with(b"\x89PNG"));
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
//! # What is promised
//!
//! - The same input gives the same bytes: no clock, no threads and no machine has a say in a picture or a file.
//! - An output is complete or not there ([`output`]).
//! - Nothing from outside, be it a file or an option, makes it panic; if a defect does, it is caught and becomes
//!   one line that names the file ([`Error`]).

#![forbid(unsafe_code)]

pub mod application;
pub mod canvas;
pub mod cli;
pub mod compare;
pub mod controls;
pub mod decode;
pub mod demo;
pub mod encode;
pub mod error;
pub mod event;
mod guard;
pub mod input;
#[cfg(feature = "window")]
mod log;
pub mod model;
pub mod output;
pub mod pfm;
#[cfg(feature = "window")]
mod present;
mod program;
pub mod record;
mod settings;
pub mod view;
pub mod viewer;
#[cfg(feature = "window")]
mod window;

pub use application::{Application, Waker};
pub use error::Error;
pub use polosa_math as math;
pub use polosa_raster as raster;
pub use polosa_scene as scene;
pub use program::Program;
pub use settings::{Look, Navigate, Settings};

/// The README's program is compiled with the tests.
#[cfg(doctest)]
#[doc = include_str!("../README.md")]
struct Readme;
