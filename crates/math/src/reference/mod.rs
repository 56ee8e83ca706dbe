//! Cameras and rotations as five tutorials have them, kept to be measured. Nothing else in the crate uses them.
//!
//! polosa grew from five documents that teach how to draw a solid without a graphics library (S0 to S4, see
//! `docs/seeds.md` in the repository). Their methods are here as they were printed, beside the obvious mending where
//! there is one, in `f32` and in `f64`, so that each can be set against the same method with more digits and against
//! what the rest of the crate does.
//!
//! | module | holds | in use instead |
//! |---|---|---|
//! | [`rotation`] | six ways to turn by a million small steps | [`turn`](crate::turn), one of the six |
//! | [`camera`] | S1's camera, S4's six steps, the angles of S0 and S3 | [`Basis`](crate::Basis), [`projection`](crate::projection) |
//! | [`algebra`] | what these are computed with: rows of numbers, `f32` or `f64` | glam |
//!
//! Unlike the rest of the crate, what is here refuses nothing: a method that divides by zero gives what a division by
//! zero gives, since that is its failure. Nothing panics.

pub mod algebra;
pub mod camera;
pub mod rotation;
