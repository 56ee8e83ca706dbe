//! The pictures of `docs/stability.md`: what fails beside what is right, and how much is wrong, counted:
//!
//! ```console
//! cargo run --release --example gallery -- docs/pictures/stability
//! ```
//!
//! Nothing is drawn by hand. The failing side comes from the methods that the crates keep for comparison
//! (`polosa_raster::reference` and its namesakes), the other one from what polosa uses. A test draws all of it again
//! and holds the pictures and the figures against the document (`examples/tests/gallery.rs`).
#![expect(clippy::print_stdout, reason = "says where the pictures are, and what was counted")]

mod cameras;
mod coverage;
mod depth;
mod far;
mod hidden;
mod kit;
mod shading;
mod turning;

use std::error::Error;

use polosa_examples::save;

use self::kit::Made;

/// Makes one picture.
pub(crate) type Make = fn() -> Made;

/// All of them, in the document's order.
pub(crate) const PICTURES: [(&str, Make); 27] = [
    ("shared.png", coverage::shared),
    ("box.png", coverage::line),
    ("whole.png", coverage::whole),
    ("jitter.png", coverage::jitter),
    ("fan.png", far::fan),
    ("scan.png", far::scan),
    ("tie.png", coverage::tie),
    ("closed.png", coverage::closed),
    ("order.png", hidden::order),
    ("cycle.png", hidden::cycle),
    ("pierce.png", hidden::pierce),
    ("sum.png", hidden::sum),
    ("strip.png", hidden::strip),
    ("origin.png", depth::origin),
    ("slivers.png", depth::slivers),
    ("formats.png", depth::formats),
    ("behind.png", cameras::behind),
    ("affine.png", cameras::affine),
    ("axes.png", cameras::axes),
    ("upright.png", cameras::upright),
    ("near.png", cameras::near),
    ("naive.png", shading::naive),
    ("power24.png", shading::power_24),
    ("power22.png", shading::power_22),
    ("hue.png", shading::hues),
    ("drift.png", turning::matrix),
    ("wander.png", turning::wander),
];

fn main() -> Result<(), Box<dyn Error>> {
    for (name, make) in PICTURES {
        let drawing = make()?;
        println!("{}: {}", save(name, &drawing.picture)?.display(), drawing.figures);
    }
    Ok(())
}
