//! What the scenes are made of: random numbers, classes of triangles, meshes. The same on every machine.

pub mod circle;
pub mod classes;
pub mod mesh;
pub mod rng;
