//! The pictures of `docs/pipeline.md`, drawn with the library that they explain:
//!
//! ```console
//! cargo run --release --example pipeline -- docs/pictures
//! ```
//!
//! What the pictures show is not drawn after a textbook: pixels come from [`polosa_raster`], and each picture
//! asserts what its caption says.
#![expect(clippy::print_stdout, reason = "says where the pictures are")]

mod grid;
mod kit;
mod snap;
mod space;

use std::error::Error;

use polosa_examples::save;
use polosa_scene::Picture;

/// Makes one picture.
type Make = fn() -> Result<Picture, Box<dyn Error>>;

const PICTURES: [(&str, Make); 9] = [
    ("clip.png", space::clip),
    ("snap.png", snap::snap),
    ("samples.png", grid::samples),
    ("strips.png", grid::strips),
    ("shared.png", grid::shared),
    ("depth.png", space::depth),
    ("weights.png", space::weights),
    ("lines.png", grid::lines),
    ("edges.png", space::edges),
];

fn main() -> Result<(), Box<dyn Error>> {
    for (name, make) in PICTURES {
        println!("{}", save(name, &make()?)?.display());
    }
    Ok(())
}
