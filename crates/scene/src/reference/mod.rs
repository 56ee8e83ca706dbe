//! Shading, hues and spheres as five tutorials have them, kept to be drawn with and measured.
//!
//! polosa grew from five documents that teach how to draw a solid without a graphics library (S0 to S4, see
//! `docs/seeds.md` in the repository). Their methods are here as they are there, each beside what the rest of the
//! crate does, so that their error can be measured and seen. None is ever a default.
//!
//! | module | holds | in use instead |
//! |---|---|---|
//! | [`shading`] | from a colour and an amount of light to a colour | [`srgb`](crate::srgb) |
//! | [`hue`] | colours by a pseudo-longitude, and by the true one | none: nothing else needs hues |
//! | [`Methods`] | a picture of a world with any of the raster core's methods, and any shading | [`Renderer`](crate::Renderer) |
//! | [`sphere`] | spheres by inflation and by symmetry | [`shape::sphere`](crate::shape::sphere()) |

pub mod hue;
mod picture;
pub mod shading;
pub mod sphere;

pub use picture::Methods;
pub use shading::{Shading, UnknownShading};
pub use sphere::Sphere;
