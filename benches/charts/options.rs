//! The command line.

use std::path::PathBuf;

use crate::measure::Effort;

pub(crate) const HELP: &str = "\
Measures, and draws what it measured: SVG charts and the data that they show as CSV.

cargo run --release -p polosa-benches --features charts --bin charts -- [OPTIONS]

--quick        fewer workloads and rounds: to see that it works
--out DIR      where to write (default: docs/charts)
--chart NAME   this chart only (again for more); see --list
--list         the names of all charts
--redraw       draw the CSV files that are there; measure nothing";

#[derive(Debug, PartialEq)]
pub(crate) struct Options {
    pub(crate) effort: Effort,
    pub(crate) out: PathBuf,
    pub(crate) charts: Vec<String>,
    pub(crate) redraw: bool,
}

/// What to do.
#[derive(Debug, PartialEq)]
pub(crate) enum Asked {
    Run(Options),
    Help,
    List,
}

/// Reads the arguments after the program's name; `known` are the names of the charts.
pub(crate) fn parse(arguments: impl IntoIterator<Item = String>, known: &[&str]) -> Result<Asked, String> {
    let mut options = Options {
        effort: Effort::Full,
        out: concat!(env!("CARGO_MANIFEST_DIR"), "/../docs/charts").into(),
        charts: Vec::new(),
        redraw: false,
    };
    let mut arguments = arguments.into_iter();
    while let Some(argument) = arguments.next() {
        let mut value = || arguments.next().ok_or(format!("{argument} needs a value"));
        match argument.as_str() {
            "--quick" => options.effort = Effort::Quick,
            "--out" => options.out = value()?.into(),
            "--chart" => {
                let name = value()?;
                if !known.contains(&name.as_str()) {
                    return Err(format!("no chart {name:?}: it is one of {}", known.join(", ")));
                }
                options.charts.push(name);
            }
            "--redraw" => options.redraw = true,
            "--help" | "-h" => return Ok(Asked::Help),
            "--list" => return Ok(Asked::List),
            _ => return Err(format!("unknown argument {argument:?}\n\n{HELP}")),
        }
    }
    if options.charts.is_empty() {
        options.charts = known.iter().map(|&name| name.to_owned()).collect();
    }
    Ok(Asked::Run(options))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn asked(line: &str) -> Result<Asked, String> {
        parse(line.split_whitespace().map(str::to_owned), &["one", "two"])
    }

    #[test]
    fn without_arguments_everything_is_drawn() {
        let Ok(Asked::Run(options)) = asked("") else { panic!("not a run") };
        assert_eq!((options.effort, options.redraw), (Effort::Full, false));
        assert_eq!(options.charts, ["one", "two"]);
        assert!(options.out.ends_with("docs/charts"));
    }

    #[test]
    fn each_option_is_heard() {
        let Ok(Asked::Run(options)) = asked("--quick --out x/y --chart two --redraw") else {
            panic!("not a run")
        };
        assert_eq!((options.effort, options.redraw), (Effort::Quick, true));
        assert_eq!((options.charts, options.out), (vec!["two".to_owned()], PathBuf::from("x/y")));
        assert_eq!(asked("--quick -h"), Ok(Asked::Help));
        assert_eq!(asked("--list"), Ok(Asked::List));
    }

    #[test]
    fn what_is_unknown_is_told_what_there_is() {
        assert!(asked("--fast").unwrap_err().contains("--quick"));
        assert_eq!(asked("--chart three").unwrap_err(), "no chart \"three\": it is one of one, two");
        assert_eq!(asked("--out").unwrap_err(), "--out needs a value");
    }
}
