//! What the raster core's tests judge by.
//!
//! Nothing here shares a formula with the crate under test: the oracles of `polosa-stability` are half-planes in
//! `i128`, rational planes and exact homogeneous lines, each short enough to be checked by reading.
//!
//! - [`oracle`]: which pixels a snapped triangle covers, and how far a pixel is from a true edge
//! - [`plane`]: the rational depth plane and the perspective weights
//! - [`homogeneous`]: coverage of a triangle in clip space without clipping it (Olano and Greer)
//! - [`classes`]: the ten classes of random triangles
//! - [`mesh`]: triangulations with integer vertices
//! - [`picture`]: targets, vertices and readable pictures
//! - [`rng`]: a deterministic source of random numbers

#![allow(dead_code, unused_imports, reason = "each test binary uses its own part of the support code")]

pub(crate) mod picture;

pub(crate) use polosa_stability::inputs::{classes, mesh, rng};
pub(crate) use polosa_stability::oracle::{coverage as oracle, depth as plane, homogeneous};
