//! What the benchmarks share: the workloads, the loop that bounds them all, and where figures are from.
//!
//! The benchmarks themselves are the files beside this one. How to run them, and what they are worth, stands at
//! the head of each and in `BIAS.md`.

pub mod ceiling;
pub mod mesh;
pub mod ours;
pub mod provenance;
mod random;
pub mod workloads;

pub use random::Random;
