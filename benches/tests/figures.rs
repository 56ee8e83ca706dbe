//! Claim: every figure of `docs/speed-vs-accuracy.md` is that of `docs/charts`, and no default has an error there that it
//! must not have.
//!
//! What stands between `<!--=KEY-->` and `<!--/-->` in the document is one figure or one table, made here from the CSV
//! files. After a new run: `UPDATE_FIGURES=1 cargo test -p polosa-benches --test figures` writes them anew. Then read
//! whether the words around them still hold.
//!
//! What the defaults promise is kept by tests that measure, not by this one: the document names them.

#[path = "../charts/csv.rs"]
mod csv;

use std::collections::BTreeMap;
use std::fmt::Write as _;
use std::fs;
use std::path::{Path, PathBuf};

use csv::Row;

const BEGIN: &str = "<!--=";
const END: &str = "<!--/-->";
const AREAS: [u32; 5] = [2, 50, 512, 5_000, 80_000];
const CORPORA: [&str; 5] = ["random", "pixel-centre", "guard-band", "sliver", "mesh"];

fn docs() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../docs")
}

fn rows(chart: &str) -> Vec<Row> {
    let path = docs().join("charts").join(chart).with_extension("csv");
    let text = fs::read_to_string(&path).unwrap_or_else(|error| panic!("{}: {error}", path.display()));
    csv::read(&text).unwrap_or_else(|error| panic!("{}: {error}", path.display()))
}

/// The one row of a method whose workload begins so and whose metric ends so.
fn row<'a>(rows: &'a [Row], method: &str, workload: &str, metric: &str) -> &'a Row {
    let is = |row: &&Row| {
        row.method == method && row.workload.starts_with(workload) && row.error_metric.ends_with(metric)
    };
    let mut found = rows.iter().filter(is);
    let row = found.next().unwrap_or_else(|| panic!("no row of {method}, {workload}, {metric}"));
    assert!(found.next().is_none(), "several rows of {method}, {workload}, {metric}");
    row
}

/// The methods, each once.
fn methods(rows: &[Row]) -> Vec<&str> {
    let mut methods: Vec<&str> = Vec::new();
    for row in rows {
        if !methods.contains(&row.method.as_str()) {
            methods.push(&row.method);
        }
    }
    methods
}

/// Whether no other row is as fast and as accurate, and better in one of both.
fn on_front(row: &Row, others: &[&Row]) -> bool {
    others.iter().all(|other| {
        other.time > row.time
            || other.error > row.error
            || (other.time == row.time && other.error == row.error)
    })
}

/// Two significant digits, thousands apart: more is not known.
fn number(value: f64) -> String {
    if value == 0.0 {
        return "0".to_owned();
    }
    if value.fract() == 0.0 && (0.0..100.0).contains(&value) {
        return value.to_string();
    }
    let decade = value.abs().log10().floor();
    if decade < -3.0 {
        let digits = value / 10_f64.powf(decade);
        let power = format!("{:.0}", -decade);
        let power: String =
            power.chars().filter_map(|c| "⁰¹²³⁴⁵⁶⁷⁸⁹".chars().nth(c.to_digit(10)? as usize)).collect();
        return format!("{digits:.0}·10⁻{power}");
    }
    let unit = 10_f64.powf(decade - 1.0);
    let rounded = (value / unit).round() * unit;
    // 0.999 becomes 1.0, a decade more.
    let decade = (rounded * 1.000_001).log10().floor();
    let places = (1.0 - decade).max(0.0) as usize;
    let text = format!("{rounded:.places$}");
    let (whole, rest) = text.split_once('.').map_or((text.as_str(), ""), |(whole, rest)| (whole, rest));
    let mut grouped = String::new();
    for (k, digit) in whole.chars().enumerate() {
        if k > 0 && (whole.len() - k).is_multiple_of(3) {
            grouped.push(',');
        }
        grouped.push(digit);
    }
    if rest.is_empty() { grouped } else { format!("{grouped}.{rest}") }
}

/// A table from its lines; the first names the columns.
fn table(lines: Vec<Vec<String>>) -> String {
    let mut text = "\n\n".to_owned();
    for (k, line) in lines.iter().enumerate() {
        let _ = writeln!(text, "| {} |", line.join(" | "));
        if k == 0 {
            let _ = writeln!(text, "|{}", "---|".repeat(line.len()));
        }
    }
    text.push('\n');
    text
}

fn line(first: &str, rest: impl IntoIterator<Item = String>) -> Vec<String> {
    [first.to_owned()].into_iter().chain(rest).collect()
}

/// All figures that the document may quote, by key.
fn figures() -> BTreeMap<String, String> {
    let mut all = BTreeMap::new();
    coverage(&rows("coverage"), &mut all);
    depth(&rows("depth"), &mut all);
    formats(&rows("format"), &mut all);
    shading(&rows("shading"), &mut all);
    detail(&rows("detail"), &mut all);
    stability(&rows("stability"), &mut all);
    all
}

fn coverage(rows: &[Row], all: &mut BTreeMap<String, String>) {
    let at = |method: &str, area: u32| row(rows, method, &format!("area={area} corpus=all "), "million");
    let sizes = || ["2 px", "50 px", "512 px", "5,000 px", "80,000 px"].map(str::to_owned);
    let mut times = vec![line("ns a triangle", sizes())];
    let mut errors = vec![line("wrong in a million", sizes())];
    for method in methods(rows) {
        times.push(line(
            method,
            AREAS.map(|area| {
                let others: Vec<&Row> = methods(rows).iter().map(|other| at(other, area)).collect();
                let time = number(at(method, area).time);
                if on_front(at(method, area), &others) { format!("**{time}**") } else { time }
            }),
        ));
        errors.push(line(method, AREAS.map(|area| number(at(method, area).error))));
        for area in AREAS {
            let ratio = |other: &str| number(at(method, area).time / at(other, area).time);
            for other in methods(rows) {
                all.insert(format!("coverage {method} / {other} at {area}"), ratio(other));
            }
        }
    }
    all.insert("coverage times".to_owned(), table(times));
    all.insert("coverage errors".to_owned(), table(errors));
    let mut corpora = vec![line("wrong in a million, 50 px", CORPORA.map(str::to_owned))];
    for method in methods(rows) {
        corpora.push(line(
            method,
            CORPORA.map(|corpus| {
                number(row(rows, method, &format!("area=50 corpus={corpus} "), "million").error)
            }),
        ));
    }
    all.insert("coverage corpora".to_owned(), table(corpora));
    // The fastest without a wrong pixel, and the fastest with some.
    for area in AREAS {
        let of = |exact: bool| {
            let some = methods(rows).into_iter().map(|method| at(method, area));
            let some = some.filter(|row| (row.error == 0.0) == exact);
            some.min_by(|a, b| a.time.total_cmp(&b.time)).expect("there are both")
        };
        all.insert(format!("coverage fastest right at {area}"), of(true).method.clone());
        all.insert(format!("coverage fastest wrong at {area}"), of(false).method.clone());
        all.insert(format!("coverage right / wrong at {area}"), number(of(true).time / of(false).time));
    }
}

fn depth(rows: &[Row], all: &mut BTreeMap<String, String>) {
    let header = ["ns a pixel", "triangles, 2⁻²⁴", "slivers, 2⁻²⁴"].map(str::to_owned);
    let mut lines = vec![line("method", header)];
    for method in methods(rows) {
        let [plain, thin] = ["kind=triangles ", "kind=slivers "].map(|kind| row(rows, method, kind, "depth"));
        let others: Vec<&Row> = rows.iter().filter(|row| row.workload.starts_with("kind=slivers ")).collect();
        let time = number(plain.time);
        let time = if on_front(thin, &others) { format!("**{time}**") } else { time };
        lines.push(line(method, [time, number(plain.error), number(thin.error)]));
        for other in methods(rows) {
            let ratio = plain.time / row(rows, other, "kind=triangles ", "depth").time;
            all.insert(format!("depth {method} / {other}"), number(ratio));
        }
    }
    all.insert("depth table".to_owned(), table(lines));
}

fn formats(rows: &[Row], all: &mut BTreeMap<String, String>) {
    let columns = [
        ("1e3", "1e-3"),
        ("1e3", "1e-5"),
        ("1e5", "1e-3"),
        ("1e5", "1e-5"),
        ("infinite", "1e-3"),
        ("infinite", "1e-5"),
    ];
    let name = |text: &str| match text {
        "1e3" => "10³",
        "1e5" => "10⁵",
        "1e-3" => "10⁻³",
        "1e-5" => "10⁻⁵",
        _ => "∞",
    };
    let header = columns.map(|(far, apart)| format!("f = {}, {}", name(far), name(apart)));
    let mut lines = vec![line("ties, %", header)];
    for method in methods(rows) {
        lines.push(line(
            method,
            columns.map(|(far, apart)| {
                let workload = format!("far={far} separation={apart} ");
                let known =
                    rows.iter().any(|row| row.method == method && row.workload.starts_with(&workload));
                if known { number(row(rows, method, &workload, "ties, %").error) } else { "–".to_owned() }
            }),
        ));
    }
    all.insert("format table".to_owned(), table(lines));
}

fn shading(rows: &[Row], all: &mut BTreeMap<String, String>) {
    let header = ["ns a pixel", "largest error, codes", "wrong in a million"].map(str::to_owned);
    let mut lines = vec![line("method", header)];
    for method in methods(rows) {
        let [most, wrong] = ["codes", "million"].map(|metric| row(rows, method, "codes=256 ", metric));
        let others: Vec<&Row> = rows.iter().filter(|row| row.error_metric == wrong.error_metric).collect();
        let time = number(most.time);
        let time = if on_front(wrong, &others) { format!("**{time}**") } else { time };
        lines.push(line(method, [time, number(most.error), number(wrong.error)]));
        for other in methods(rows) {
            let ratio = most.time / row(rows, other, "codes=256 ", "codes").time;
            all.insert(format!("shading {method} / {other}"), number(ratio));
        }
        all.insert(format!("shading {method} wrong, %"), number(wrong.error / 1e4));
    }
    all.insert("shading table".to_owned(), table(lines));
}

fn detail(rows: &[Row], all: &mut BTreeMap<String, String>) {
    let header = ["triangles", "px inside, measured", "px inside, bound", "ms a frame"].map(str::to_owned);
    let mut lines = vec![line("the first level within ½ px", header)];
    for method in methods(rows) {
        let bounds = rows.iter().filter(|row| row.method == method && row.error_metric.ends_with("bound"));
        let bound = bounds.clone().find(|row| row.error <= 0.5).expect("levels that are fine enough");
        let measured = row(rows, method, &bound.workload, "measured");
        let triangles = bound.number("triangles").expect("a count");
        let cells = [triangles.to_string(), number(measured.error), number(bound.error), number(bound.time)];
        lines.push(line(method, cells));
    }
    all.insert("detail table".to_owned(), table(lines));
}

fn stability(rows: &[Row], all: &mut BTreeMap<String, String>) {
    let mut lines = vec![line("method", ["scenes asked", "failed"].map(str::to_owned))];
    for method in methods(rows) {
        let of =
            |kind: &str| rows.iter().filter(|row| row.method == method && row.error_metric == kind).count();
        let failed = of("wrong") + of("NaN") + of("panic");
        lines.push(line(method, [(failed + of("passed")).to_string(), failed.to_string()]));
    }
    all.insert("stability table".to_owned(), table(lines));
}

/// The document with its figures replaced; each key that it has and nobody knows is an error.
fn renewed(text: &str, figures: &BTreeMap<String, String>) -> String {
    let mut parts = text.split(BEGIN);
    let mut out = parts.next().unwrap_or("").to_owned();
    for part in parts {
        let (key, rest) = part.split_once("-->").expect("a key that ends");
        let (_, after) = rest.split_once(END).unwrap_or_else(|| panic!("{key} has no end"));
        let figure = figures.get(key).unwrap_or_else(|| panic!("no figure is called {key:?}"));
        out += &format!("{BEGIN}{key}-->{figure}{END}{after}");
    }
    out
}

#[test]
fn the_documents_figures_are_those_of_the_charts() {
    let path = docs().join("speed-vs-accuracy.md");
    let text = fs::read_to_string(&path).unwrap();
    let renewed = renewed(&text, &figures());
    if std::env::var_os("UPDATE_FIGURES").is_some() {
        fs::write(&path, &renewed).unwrap();
        return;
    }
    for (k, (found, expected)) in text.lines().zip(renewed.lines()).enumerate() {
        assert_eq!(found, expected, "line {} of {}", k + 1, path.display());
    }
    assert_eq!(text, renewed);
    assert!(text.matches(BEGIN).count() > 12, "most figures stand elsewhere");
}

#[test]
fn no_measured_figure_stands_outside_of_the_marks() {
    let text = fs::read_to_string(docs().join("speed-vs-accuracy.md")).unwrap();
    let mut plain = String::new();
    for part in text.split(END) {
        plain += part.split(BEGIN).next().unwrap_or("");
        plain.push('#');
    }
    for unit in ["ns", "ms", "%", "times", "in a million", "codes off", "percent"] {
        for (at, _) in plain.match_indices(unit) {
            let before = plain[..at].trim_end();
            let last = before.chars().next_back().unwrap_or(' ');
            let around: String =
                before.chars().rev().take(30).collect::<Vec<_>>().into_iter().rev().collect();
            assert!(!last.is_ascii_digit(), "a figure without a mark: {around} {unit}");
        }
    }
}

#[test]
fn no_default_has_an_error_that_it_must_not_have() {
    let coverage = rows("coverage");
    for method in ["frame", "immediate", "strips", "edges"] {
        let of: Vec<&Row> = coverage.iter().filter(|row| row.method == method).collect();
        assert_eq!(of.len(), AREAS.len() * (CORPORA.len() + 1));
        assert!(of.iter().all(|row| row.error == 0.0), "{method}");
    }
    for method in ["frame", "immediate", "exact"] {
        for kind in ["kind=triangles ", "kind=slivers "] {
            let error = row(&rows("depth"), method, kind, "depth").error;
            assert!(error <= 5.0, "{method}, {kind}: {error}");
        }
    }
    let formats = rows("format");
    let reversed: Vec<&Row> = formats.iter().filter(|row| row.method == "f32-reversed").collect();
    assert!(reversed.len() >= 24 && reversed.iter().all(|row| row.error == 0.0), "{reversed:?}");
    assert!(rows("shading").iter().filter(|row| row.method == "exact").all(|row| row.error == 0.0));
    let stability = rows("stability");
    for method in ["immediate", "frame", "hidden exact", "shade exact", "turn quaternion"] {
        let failed = |row: &&Row| {
            row.method == method && !["passed", "not asked"].contains(&row.error_metric.as_str())
        };
        assert_eq!(stability.iter().find(failed), None);
    }
}

#[test]
fn numbers_have_two_digits() {
    let numbers = [0.0, 0.00123, 0.5, 0.9999, 1.0, 2.349, 99.6, 246_713.0, 7.2e-9].map(number);
    assert_eq!(numbers, ["0", "0.0012", "0.50", "1.0", "1", "2.3", "100", "250,000", "7·10⁻⁹"]);
}
