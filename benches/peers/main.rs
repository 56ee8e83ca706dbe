//! The same pictures by polosa and by what a user could pick instead: euc, retrofire-core, Mesa's llvmpipe.
//!
//! ```sh
//! cargo bench -p polosa-benches --features peers --bench peers -- --help
//! ```
//!
//! ```text
//!             ┌ polosa ┐
//!   workload ─┼ euc    ┼▶ pictures compared ─▶ rounds: each in turn, another first ─▶ medians, ratios
//!             ├ retro… ┤   0.1 % may differ      every time
//!             └ llvm…  ┘
//! ```
//!
//! Everybody draws the same triangles at the same resolution, and clears, tests and writes depth in every frame. A
//! turn is one frame that is not timed, to warm the caches that others have used, and then some that are. Where
//! Mesa or a C compiler is missing, llvmpipe is left out with a word about it.
//!
//! How far this is fair stands in `BIAS.md`; figures with their provenance are in `record/`.
#![expect(clippy::print_stdout, clippy::print_stderr, reason = "a program that reports to its user")]

mod by_euc;
mod by_llvmpipe;
mod by_retrofire;
mod by_us;
mod compare;
mod contestant;
mod job;
mod options;
mod report;

use std::path::{Path, PathBuf};
use std::process::ExitCode;

use polosa_benches::provenance;
use serde_json::json;

use compare::Difference;
use job::Job;
use options::{Asked, Options};
use report::{Row, Table};

/// What a renderer's turn in a round should take at least, if one frame takes less.
const TURN_NS: u64 = 40_000_000;

/// `LP_NUM_THREADS`: 0 has no worker, 1 and 2 have workers beside the thread that calls.
const WORKERS: [usize; 3] = [0, 1, 2];

fn main() -> ExitCode {
    let result = match options::parse(std::env::args().skip(1)) {
        Ok(Asked::Run(options)) => run(&options),
        Ok(Asked::Help) => {
            println!("{}", options::HELP);
            Ok(())
        }
        Ok(Asked::List) => {
            println!("{}", Job::names().join("\n"));
            Ok(())
        }
        Ok(Asked::Test) => {
            let arguments = ["--workload", "medium", "--workload", "mesh-23k", "--rounds", "1"];
            match options::parse(arguments.map(str::to_owned)) {
                Ok(Asked::Run(options)) => run(&options),
                _ => unreachable!("these are options"),
            }
        }
        Err(reason) => Err(reason),
    };
    match result {
        Ok(()) => ExitCode::SUCCESS,
        Err(reason) => {
            eprintln!("peers: {reason}");
            ExitCode::FAILURE
        }
    }
}

fn run(options: &Options) -> Result<(), String> {
    let load = provenance::load();
    let harness = by_llvmpipe::compile().map_err(|reason| notice(&reason)).ok();
    let mut renderer = None;
    let mut tables = Vec::new();
    for name in &options.workloads {
        let job = Job::named(name).ok_or_else(|| format!("no workload {name:?}"))?;
        let table = measure(&job, options, harness.as_deref(), &mut renderer)?;
        println!("{}", table.text());
        for row in table.rows.iter().filter(|row| !row.comparable()) {
            eprintln!("WARNING: {} on {name} drew another picture; its time says nothing.\n", row.name);
        }
        tables.push(table);
    }
    let mut provenance = report::provenance(options.rounds, &load, renderer.as_deref());
    provenance.extend(options.note.clone().map(|note| ("note", note)));
    let lines: String = provenance.iter().map(|(key, value)| format!("{key:<10} {value}\n")).collect();
    println!("{lines}");
    if let Some(path) = &options.record {
        let texts: Vec<String> = tables.iter().map(Table::text).collect();
        write(path, format!("{lines}\n{}", texts.join("\n")).as_bytes())?;
    }
    if let Some(path) = &options.json {
        let provenance: serde_json::Map<_, _> =
            provenance.into_iter().map(|(key, value)| (key.to_owned(), value.into())).collect();
        let tables: Vec<_> = tables.iter().map(Table::json).collect();
        let whole = json!({ "provenance": provenance, "workloads": tables });
        write(path, format!("{whole:#}\n").as_bytes())?;
    }
    Ok(())
}

/// Loudly: a column is missing.
fn notice(reason: &str) {
    eprintln!("********\n** llvmpipe is LEFT OUT: {reason}\n********\n");
}

fn measure(
    job: &Job,
    options: &Options,
    harness: Option<&Path>,
    renderer: &mut Option<String>,
) -> Result<Table, String> {
    let mut contestants = by_us::all(job, &[1, 2]);
    let ours = contestants.len();
    contestants.push(Box::new(by_euc::Euc::new(job)));
    contestants.push(Box::new(by_retrofire::Retrofire::new(job)));
    for workers in WORKERS {
        match harness.map(|program| by_llvmpipe::Llvmpipe::start(program, job, workers)) {
            Some(Ok(llvmpipe)) => {
                *renderer = Some(llvmpipe.renderer.clone());
                contestants.push(Box::new(llvmpipe));
            }
            Some(Err(reason)) => notice(&reason),
            None => {}
        }
    }
    let mut index = 0;
    contestants.retain(|contestant| {
        index += 1;
        // Ours are what the others are compared with.
        index <= ours || !options.without.iter().any(|name| contestant.name().starts_with(name.as_str()))
    });

    let mut rows = Vec::new();
    let mut frames = Vec::new();
    let mut first: Option<Vec<u32>> = None;
    for (index, contestant) in contestants.iter_mut().enumerate() {
        let times = contestant.frames(2)?;
        frames.push((TURN_NS / times[1].max(1)).clamp(1, 20) as u32);
        let mut row = Row {
            name: contestant.name(),
            threads: contestant.threads(),
            times: Vec::new(),
            difference: None,
            ours: index < ours && contestant.draws(),
        };
        if !contestant.draws() {
            rows.push(row);
            continue;
        }
        let picture = contestant.picture()?;
        if let Some(folder) = &options.pictures {
            dump(folder, job, &contestant.name(), &picture)?;
        }
        row.difference =
            Some(Difference::of(first.as_ref().unwrap_or(&picture), &picture, job.lit.is_some()));
        first.get_or_insert(picture);
        rows.push(row);
    }

    for round in 0..options.rounds {
        for turn in 0..contestants.len() {
            let index = (round + turn) % contestants.len();
            let times = contestants[index].frames(1 + frames[index])?;
            rows[index].times.extend(&times[1..]);
        }
    }
    for row in &mut rows {
        row.times.sort_unstable();
    }
    Ok(Table::new(job, rows))
}

/// A picture to be looked at.
fn dump(folder: &Path, job: &Job, name: &str, picture: &[u32]) -> Result<(), String> {
    let [width, height] = job.size;
    let mut bytes = format!("P6\n{width} {height}\n255\n").into_bytes();
    for pixel in picture {
        // Numbers of triangles are small: spread over the colours.
        let shown = if job.lit.is_some() { *pixel } else { pixel.wrapping_mul(0x009e_3779) };
        bytes.extend(&shown.to_be_bytes()[1..]);
    }
    let name = name.replace([' ', '='], "-");
    write(&folder.join(format!("{}.{name}.ppm", job.name)), &bytes)
}

fn write(path: &PathBuf, bytes: &[u8]) -> Result<(), String> {
    std::fs::write(path, bytes).map_err(|error| format!("{} cannot be written: {error}", path.display()))
}
