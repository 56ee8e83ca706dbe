//! Figures as a table, as JSON, and where they are from.

use std::fmt::Write as _;

use polosa_benches::provenance;
use serde_json::{Value, json};

use crate::compare::{Difference, MOST};
use crate::job::Job;

/// One renderer's times for one workload.
pub(crate) struct Row {
    pub(crate) name: String,
    pub(crate) threads: usize,
    /// Nanoseconds a frame, sorted.
    pub(crate) times: Vec<u64>,
    /// How its picture differs, if it draws one.
    pub(crate) difference: Option<Difference>,
    /// Whether it is one of ours, and draws.
    pub(crate) ours: bool,
}

impl Row {
    /// Whether its times may be compared with ours: not those of another picture.
    pub(crate) fn comparable(&self) -> bool {
        self.difference.is_none_or(|difference| difference.comparable())
    }

    fn median(&self) -> f64 {
        self.times.get(self.times.len() / 2).map_or(f64::NAN, |&ns| ns as f64 * 1e-6)
    }

    fn min(&self) -> f64 {
        self.times.first().map_or(f64::NAN, |&ns| ns as f64 * 1e-6)
    }
}

/// The rows of a workload.
pub(crate) struct Table {
    pub(crate) workload: String,
    pub(crate) triangles: usize,
    pub(crate) size: [u32; 2],
    pub(crate) rows: Vec<Row>,
}

impl Table {
    pub(crate) fn new(job: &Job, rows: Vec<Row>) -> Self {
        Self { workload: job.name.clone(), triangles: job.indices.len(), size: job.size, rows }
    }

    /// Our best median with as many threads; with one, if there is none.
    fn ours(&self, threads: usize) -> f64 {
        let best = |threads| {
            let medians = self.rows.iter().filter(|row| row.ours && row.threads == threads).map(Row::median);
            medians.reduce(f64::min)
        };
        best(threads).or_else(|| best(1)).unwrap_or(f64::NAN)
    }

    pub(crate) fn text(&self) -> String {
        let [width, height] = self.size;
        let mut text = format!(
            "{}: {} triangles, {width}×{height}\n  {:<26} {:>7} {:>10} {:>10} {:>9}  {:>9}\n",
            self.workload, self.triangles, "", "threads", "median ms", "min ms", "× ours", "differs"
        );
        for row in &self.rows {
            let (median, min) = (row.median(), row.min());
            let ratio = median / self.ours(row.threads);
            let _ =
                write!(text, "  {:<26} {:>7} {median:>10.3} {min:>10.3} {ratio:>9.2}", row.name, row.threads);
            if let Some(difference) = &row.difference {
                let _ = write!(text, "  {:>8.4}%", 100.0 * difference.share);
                if !difference.comparable() {
                    let _ = write!(text, "  NOT COMPARABLE: {}", why_not(difference));
                }
            }
            text.push('\n');
        }
        text
    }

    pub(crate) fn json(&self) -> Value {
        let rows: Vec<Value> = self
            .rows
            .iter()
            .map(|row| {
                json!({
                    "renderer": row.name,
                    "threads": row.threads,
                    "ours": row.ours,
                    "frames": row.times.len(),
                    "median_ms": row.median(),
                    "min_ms": row.min(),
                    "times_ours": row.median() / self.ours(row.threads),
                    "differs": row.difference.map(|difference| difference.share),
                    "differs_in_coverage": row.difference.map(|difference| difference.coverage),
                    "comparable": row.comparable(),
                })
            })
            .collect();
        let [width, height] = self.size;
        json!({
            "workload": self.workload, "triangles": self.triangles, "width": width, "height": height, "rows": rows,
        })
    }
}

fn why_not(difference: &Difference) -> String {
    let Difference { coverage, covered: [ours, theirs], .. } = difference;
    format!(
        "more than {} % of the pixels differ, {:.3} % by coverage; we cover {:.2} %, they {:.2} %",
        100.0 * MOST,
        100.0 * coverage,
        100.0 * ours,
        100.0 * theirs
    )
}

/// Where figures are from: pairs of a word and a line.
pub(crate) fn provenance(
    rounds: usize,
    load_before: &str,
    renderer: Option<&str>,
) -> Vec<(&'static str, String)> {
    let command =
        format!("cargo bench -p polosa-benches --features peers --bench peers -- {}", telling_arguments());
    vec![
        ("date", provenance::date()),
        ("commit", provenance::commit()),
        ("command", command.trim_end_matches([' ', '-']).to_owned()),
        ("CPU", provenance::cpu()),
        ("cores", provenance::cores()),
        ("load", format!("{load_before} before, {} after (1, 5, 15 minutes)", provenance::load())),
        ("compiler", provenance::compiler()),
        ("RUSTFLAGS", std::env::var("RUSTFLAGS").unwrap_or_else(|_| "(none)".to_owned())),
        ("OpenGL", renderer.unwrap_or("(left out)").to_owned()),
        ("peers", ["euc", "retrofire-core"].map(version).join(", ")),
        ("rounds", rounds.to_string()),
    ]
}

/// The command line without what says only where the figures go.
fn telling_arguments() -> String {
    let mut arguments = std::env::args().skip(1);
    let mut telling = Vec::new();
    while let Some(argument) = arguments.next() {
        match argument.as_str() {
            "--record" | "--json" | "--pictures" | "--note" => drop(arguments.next()),
            "--bench" => {}
            _ => telling.push(argument),
        }
    }
    telling.join(" ")
}

/// The version of a crate, by the lock file.
fn version(name: &str) -> String {
    let lock =
        std::fs::read_to_string(concat!(env!("CARGO_MANIFEST_DIR"), "/../Cargo.lock")).unwrap_or_default();
    let after = lock.split(&format!("name = \"{name}\"\nversion = \"")).nth(1);
    format!("{name} {}", after.and_then(|rest| rest.split('"').next()).unwrap_or("?"))
}
