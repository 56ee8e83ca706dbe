//! Claim: the default passes every scene that breaks something else.
//!
//! The suite's scenes for every method that fills or hides, as `crates/stability/tests/table.txt` has them, and four
//! rows that are no business of a rasteriser:
//!
//! | scene | asks | counts |
//! |---|---|---|
//! | 18 | a value across triangles whose w differ by a factor of 100 | pixels off by more than 2⁻²⁰ |
//! | 19 | all 256 codes at 1,001 amounts of light | codes that are not the nearest |
//! | 20 | spheres of 20 to 1,000 px radius, at the level that the bound for ½ px chooses | those that are off by more |
//! | 21 | a million steps of two kinds | those after which ‖MMᵀ−1‖ is 10⁻⁵ or more, or is no number |
//!
//! Nothing is timed. As CSV a verdict is its kind and a count.

mod heat;
mod rows;

use polosa_stability::{Table, Verdict};

use crate::chart::Drawings;
use crate::csv::Row;
use crate::measure::Effort;

#[path = "../../crates/stability/tests/support/ours.rs"]
mod ours;

const NAME: &str = "stability";

/// What a verdict is called.
const KINDS: [&str; 5] = ["passed", "wrong", "NaN", "panic", "not asked"];

/// # Errors
///
/// When a default does not pass.
pub(crate) fn measure(_: Effort) -> Result<Vec<Row>, String> {
    let mut table = ours::table();
    rows::add(&mut table);
    for row in table.rows() {
        for ours in
            ["immediate", "frame", "hidden exact", "attribute perspective", "shade exact", "turn quaternion"]
        {
            let verdict = table.get(&row.scene, ours);
            if !matches!(verdict, Verdict::Pass | Verdict::NotAsked) {
                return Err(format!("{ours}: {}: {verdict}", row.scene));
            }
        }
    }
    Ok(written(&table))
}

fn written(table: &Table) -> Vec<Row> {
    let mut rows = Vec::new();
    for row in table.rows() {
        for method in table.methods() {
            let (kind, count) = match table.get(&row.scene, method) {
                Verdict::Pass => (0, 0),
                Verdict::Wrong { pixels } => (1, pixels),
                Verdict::NotANumber => (2, 0),
                Verdict::Panic => (3, 0),
                Verdict::NotAsked => (4, 0),
            };
            rows.push(Row {
                chart: NAME.to_owned(),
                method: method.clone(),
                workload: format!("{} {}", row.number, row.scene),
                time_unit: String::new(),
                time: f64::NAN,
                error_metric: KINDS[kind].to_owned(),
                error: count as f64,
                spread: f64::NAN,
            });
        }
    }
    rows
}

pub(crate) fn draw(rows: &[Row]) -> Result<Drawings, String> {
    Ok(vec![(NAME, heat::map(rows))])
}
