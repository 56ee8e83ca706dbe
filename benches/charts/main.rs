//! The charts of `docs/charts`: measured, written as CSV, drawn as SVG.
//!
//! ```sh
//! cargo run --release -p polosa-benches --features charts --bin charts -- --help
//! ```
//!
//! ```text
//!   workloads ─▶ measure ─▶ rows ─▶ docs/charts/NAME.csv ─▶ figure ─▶ docs/charts/*.svg
//!   (one file    (rounds,           (csv)                   (chart)
//!    a chart)     in turn)
//! ```
//!
//! A drawing is made of the rows of its CSV file and nothing else: `--redraw` does without measuring. To add a chart,
//! write a file like `scaling.rs` and name it in [`CHARTS`].
#![expect(clippy::print_stdout, clippy::print_stderr, reason = "a program that reports to its user")]

mod chart;
mod coverage;
mod csv;
mod depth;
mod detail;
mod format;
mod measure;
mod options;
mod scaling;
mod shading;
mod stability;
mod style;

use std::fs;
use std::path::Path;
use std::process::ExitCode;

use polosa_benches::provenance;

use chart::Drawings;
use csv::Row;
use measure::Effort;
use options::{Asked, Options};

/// One CSV file, and the figures that are drawn of it.
struct Chart {
    name: &'static str,
    about: &'static str,
    /// Measures; it says what it is about to do by [`Effort`] and checks its own pictures.
    measure: fn(Effort) -> Result<Vec<Row>, String>,
    draw: fn(&[Row]) -> Result<Drawings, String>,
}

const CHARTS: [Chart; 7] = [
    Chart {
        name: "coverage",
        about: "filling: time against wrong pixels, at five sizes",
        measure: coverage::measure,
        draw: coverage::draw,
    },
    Chart {
        name: "depth",
        about: "depth: time against the largest error",
        measure: depth::measure,
        draw: depth::draw,
    },
    Chart {
        name: "format",
        about: "depth formats: surfaces that cannot be told apart",
        measure: format::measure,
        draw: format::draw,
    },
    Chart {
        name: "shading",
        about: "shading: time against wrong codes",
        measure: shading::measure,
        draw: shading::draw,
    },
    Chart {
        name: "detail",
        about: "spheres: triangles and time against the error of an outline",
        measure: detail::measure,
        draw: detail::draw,
    },
    Chart {
        name: "stability",
        about: "which method passes which scene",
        measure: stability::measure,
        draw: stability::draw,
    },
    Chart {
        name: "scaling",
        about: "how the time of a frame grows with triangles and with pixels",
        measure: scaling::measure,
        draw: scaling::draw,
    },
];

fn main() -> ExitCode {
    let names = CHARTS.map(|chart| chart.name);
    let result = match options::parse(std::env::args().skip(1), &names) {
        Ok(Asked::Run(options)) => run(&options),
        Ok(Asked::Help) => {
            println!("{}", options::HELP);
            Ok(())
        }
        Ok(Asked::List) => {
            CHARTS.iter().for_each(|chart| println!("{:<12} {}", chart.name, chart.about));
            Ok(())
        }
        Err(reason) => Err(reason),
    };
    match result {
        Ok(()) => ExitCode::SUCCESS,
        Err(reason) => {
            eprintln!("charts: {reason}");
            ExitCode::FAILURE
        }
    }
}

fn run(options: &Options) -> Result<(), String> {
    fs::create_dir_all(&options.out).map_err(|error| format!("{}: {error}", options.out.display()))?;
    for chart in &CHARTS {
        if !options.charts.iter().any(|name| name == chart.name) {
            continue;
        }
        let path = options.out.join(chart.name).with_extension("csv");
        let rows = if options.redraw {
            csv::read(&read(&path)?).map_err(|reason| format!("{}: {reason}", path.display()))?
        } else {
            println!("{}: {}", chart.name, chart.about);
            let load = provenance::load();
            let rows = (chart.measure)(options.effort)?;
            write(&path, &csv::text(&header(options, &load), &rows))?;
            rows
        };
        for (name, text) in (chart.draw)(&rows).map_err(|reason| format!("{}: {reason}", path.display()))? {
            write(&options.out.join(name).with_extension("svg"), &text)?;
        }
    }
    Ok(())
}

/// Where figures are from: the first lines of a CSV file.
fn header(options: &Options, load_before: &str) -> Vec<(&'static str, String)> {
    let quick = if options.effort == Effort::Quick { " --quick" } else { "" };
    vec![
        ("date", provenance::date()),
        ("commit", provenance::commit()),
        (
            "command",
            format!("cargo run --release -p polosa-benches --features charts --bin charts --{quick}")
                .trim_end_matches(" --")
                .to_owned(),
        ),
        ("CPU", provenance::cpu()),
        ("cores", provenance::cores()),
        ("load", format!("{load_before} before, {} after (1, 5, 15 minutes)", provenance::load())),
        ("compiler", provenance::compiler()),
    ]
}

fn read(path: &Path) -> Result<String, String> {
    fs::read_to_string(path).map_err(|error| format!("{}: {error}", path.display()))
}

fn write(path: &Path, text: &str) -> Result<(), String> {
    fs::write(path, text).map_err(|error| format!("{}: {error}", path.display()))?;
    println!("{}", path.display());
    Ok(())
}
