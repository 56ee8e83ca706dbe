//! Claim: the time of a frame grows in proportion to the triangles that are seen and to the pixels that they cover.
//!
//! ```text
//!   sheet, 1 triangle      4         16                 pair          2 triangles over
//!   ┌───────────╱      ┌─────╱     ┌──┬──┬──╱           ┌────────┐    1 px to the picture
//!   │        ╱         │  ╱  │╱    ├──┼──┼╱             │     ╱  │
//!   │     ╱            ├─────╱     ├──┼──╱              │  ╱     │    pile          256 of one size, each
//!   │  ╱               │  ╱        ├──┼╱                └────────┘    ▲▸◂▾          in a random place and
//!   ╱                  ╱           ├──╱                                             depth, over each other
//! ```
//!
//! *Triangles* grow while pixels do not: a sheet is halved again and again, from one triangle to 4,194,304, all corners
//! on the sub-pixel grid, so that each sheet covers the same pixels. *Balls* (`mesh.rs`) have a far side, too, that is
//! culled. *Dust* is triangles of 2 px in random places: more of them, and of their pixels.
//!
//! *Pixels* grow while triangles do not: a pair of triangles from one pixel to the whole picture, a pile in which most
//! is hidden, and the pair over the whole of pictures from 320×240 to 3840×2160.
//!
//! Every picture is cleared, its depth tested and written; every way to draw must give the same bytes.

mod figures;
mod job;

use polosa_benches::ours::Picture;

use crate::csv::Row;
use crate::measure::{Effort, interleaved};
pub(crate) use figures::draw;
use job::{Job, WAYS, Way};

/// The charts' names in the CSV file, and those of their files.
const TRIANGLES: &str = "cost-by-triangles";
const PIXELS: &str = "cost-by-pixels";

pub(crate) fn measure(effort: Effort) -> Result<Vec<Row>, String> {
    let jobs = Job::all(effort);
    let mut ways = Way::all();
    let mut pictures = Vec::new();
    let mut different = Vec::new();
    for job in &jobs {
        different.push(job.check(&mut ways, of_size(&mut pictures, job.size))?);
    }
    let timings = interleaved(jobs.len() * ways.len(), effort, |contestant| {
        let (job, way) = (&jobs[contestant / WAYS], &mut ways[contestant % WAYS]);
        job.draw(way, of_size(&mut pictures, job.size))
    });
    let mut rows = Vec::new();
    for ((job, timings), different) in jobs.iter().zip(timings.chunks(WAYS)).zip(different) {
        let measured = ways.iter().zip(timings).zip(different);
        rows.extend(job.rows(measured.map(|((way, &timing), different)| (way.name, timing, different))));
    }
    Ok(rows)
}

/// The picture of a size: all jobs of that size share it.
fn of_size(pictures: &mut Vec<Picture>, size: [u32; 2]) -> &mut Picture {
    let at = pictures.iter().position(|picture| picture.size == size).unwrap_or_else(|| {
        pictures.push(Picture::new(size));
        pictures.len() - 1
    });
    &mut pictures[at]
}
