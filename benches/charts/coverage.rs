//! What do pixels that are exactly right cost, beside those of methods that are not, at each size of triangle?
//!
//! ```text
//!   corpora, each triangle on the 1/256 px grid              soups of one size
//!   random  pixel-centre  guard-band  sliver  mesh                  │
//!        └────────┴────┬───────┴─────────┘                  interleaved rounds
//!            wrong pixels against the oracle                  ns a triangle
//! ```
//!
//! All methods get the same triangles, their corners on the 1/256 px grid: snapping moves none, and one answer is right
//! for all. What counts as *wrong* is in [`judge`]: each method is held to its own rule for centres on a side, and all to
//! one rule for a mesh, that each pixel is drawn once.
//!
//! Times are of a colour without depth over a cleared picture. A `frame` clears, sorts into tiles and writes out whole
//! pictures, all of which is in its time; the others fill the picture's memory at once, after a clear.

pub(crate) mod corpora;
mod figure;
mod judge;
mod time;

use crate::csv::Row;
use crate::measure::Effort;
use corpora::Corpus;
pub(crate) use figure::draw;
use judge::Wrong;
use time::Contestant;

/// The chart's name, in the file and as one.
const NAME: &str = "coverage";
const METRIC: &str = "wrong pixels in a million";

/// Areas of the triangles in pixels, and how many of them are timed in one picture.
const SIZES: [(u32, u32); 5] = [(2, 200_000), (50, 40_000), (512, 8_000), (5_000, 800), (80_000, 80)];

/// # Errors
///
/// When a default method, or one of the exact ones, has a wrong pixel.
pub(crate) fn measure(effort: Effort) -> Result<Vec<Row>, String> {
    let mut rows = Vec::new();
    for (area, count) in SIZES {
        let mut contestants = Contestant::all();
        let timings = time::measure(&mut contestants, area, effort.either(count / 8, count), effort);
        for (contestant, timing) in contestants.iter_mut().zip(timings) {
            let row = |workload: String, wrong: Wrong| Row {
                chart: NAME.to_owned(),
                method: contestant.name().to_owned(),
                workload,
                time_unit: "ns/triangle".to_owned(),
                time: timing.median,
                error_metric: METRIC.to_owned(),
                error: 1e6 * wrong.pixels as f64 / wrong.of as f64,
                spread: timing.spread,
            };
            let mut all = Wrong::default();
            for corpus in Corpus::ALL {
                let wrong = judge::judge(contestant.method, &corpus.triangles(area, effort));
                rows.push(row(format!("area={area} corpus={} pixels={}", corpus.name(), wrong.of), wrong));
                all += wrong;
            }
            rows.push(row(format!("area={area} corpus=all pixels={}", all.of), all));
            if contestant.method.is_exact() && all.pixels > 0 {
                return Err(format!("{}: {} wrong pixels at {area} px", contestant.name(), all.pixels));
            }
        }
    }
    Ok(rows)
}
