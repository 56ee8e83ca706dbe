//! The scene that `polosa` draws when it is not told what, at the size that the README shows it in.
#![expect(clippy::print_stdout, reason = "says where the picture is")]

use std::error::Error;

use polosa_examples::save;
use polosa_scene::Samples;

fn main() -> Result<(), Box<dyn Error>> {
    let picture = polosa::demo::picture(960, 600, Samples::Sixteen)?;
    let stats = picture.stats.triangles;
    assert_eq!(stats.drawn, stats.submitted, "nothing is lost");
    println!("{}", save("demo.png", &picture)?.display());
    Ok(())
}
