//! What a rasteriser is judged by: integers and rationals, each part short enough to be checked by reading.
//!
//! Nothing is shared with the code under test, neither a formula nor a width of integers:
//!
//! - [`snap`]: the nearest sub-pixel of a vertex in clip space, as an exact quotient
//! - [`coverage`]: half-planes in `i128` over snapped vertices, and how far a pixel is from a true edge
//! - [`depth`]: the rational plane through the depths of the vertices, and perspective weights
//! - [`homogeneous`]: coverage and depth in clip space without clipping anything (Olano and Greer)

pub mod coverage;
pub mod depth;
pub mod homogeneous;
pub mod snap;
