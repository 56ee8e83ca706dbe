//! The command line.

use std::path::PathBuf;

use crate::job::Job;

pub(crate) const HELP: &str = "\
The same pictures by polosa and by other renderers, in turn, in one run.

cargo bench -p polosa-benches --features peers --bench peers -- [OPTIONS]

--workload NAME   draw only this (again for more); see --list
--list            the names of all workloads
--rounds N        rounds in which everybody has one turn (default 9)
--json FILE       write the figures as JSON
--record FILE     write the table with its provenance, as benches/record has it
--note TEXT       a line about this run, for the record
--pictures DIR    write every picture as DIR/WORKLOAD.RENDERER.ppm
--without NAME    leave out a renderer whose name begins so (again for more)";

pub(crate) struct Options {
    pub(crate) workloads: Vec<String>,
    pub(crate) rounds: usize,
    pub(crate) json: Option<PathBuf>,
    pub(crate) record: Option<PathBuf>,
    pub(crate) note: Option<String>,
    pub(crate) pictures: Option<PathBuf>,
    pub(crate) without: Vec<String>,
}

/// What to do.
pub(crate) enum Asked {
    Run(Options),
    Help,
    List,
    /// Cargo's `-- --test`: one small workload, one round.
    Test,
}

/// Reads the arguments after the program's name.
pub(crate) fn parse(arguments: impl IntoIterator<Item = String>) -> Result<Asked, String> {
    let mut options = Options {
        workloads: Vec::new(),
        rounds: 9,
        json: None,
        record: None,
        note: None,
        pictures: None,
        without: Vec::new(),
    };
    let mut arguments = arguments.into_iter();
    while let Some(argument) = arguments.next() {
        let mut value = || arguments.next().ok_or(format!("{argument} needs a value"));
        match argument.as_str() {
            "--workload" => {
                let name = value()?;
                if !Job::names().contains(&name) {
                    return Err(format!("no workload {name:?}: it is one of {}", Job::names().join(", ")));
                }
                options.workloads.push(name);
            }
            "--rounds" => {
                let text = value()?;
                let good = text.parse().ok().filter(|rounds| (1..=1000).contains(rounds));
                options.rounds = good.ok_or(format!("--rounds {text}: a number from 1 to 1000"))?;
            }
            "--json" => options.json = Some(value()?.into()),
            "--record" => options.record = Some(value()?.into()),
            "--note" => options.note = Some(value()?),
            "--pictures" => options.pictures = Some(value()?.into()),
            "--without" => options.without.push(value()?),
            "--help" | "-h" => return Ok(Asked::Help),
            "--list" => return Ok(Asked::List),
            "--test" => return Ok(Asked::Test),
            // Cargo says so to every benchmark.
            "--bench" => {}
            _ => return Err(format!("unknown argument {argument:?}; --help lists them")),
        }
    }
    if options.workloads.is_empty() {
        options.workloads = Job::quoted();
    }
    Ok(Asked::Run(options))
}
