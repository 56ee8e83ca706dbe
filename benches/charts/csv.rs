//! What was measured, as text and back.
//!
//! Lines that begin with `#` say where the figures are from; then a line of names, then the rows. A cell that holds a
//! comma, a quote or a line break stands in quotes, and quotes inside of it are doubled (RFC 4180).

use std::fmt::Write as _;

/// The names of the columns.
const COLUMNS: &str = "chart,method,workload,time_unit,time,error_metric,error,spread";

/// One point of a chart.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Row {
    /// The chart that shows it.
    pub(crate) chart: String,
    pub(crate) method: String,
    /// What was drawn; numbers as `name=value`, separated by spaces: see [`Row::number`].
    pub(crate) workload: String,
    /// `ms/frame`, for example.
    pub(crate) time_unit: String,
    /// The median.
    pub(crate) time: f64,
    /// What `error` counts.
    pub(crate) error_metric: String,
    pub(crate) error: f64,
    /// The median of the distances from the median of the time, in the unit of the time.
    pub(crate) spread: f64,
}

impl Row {
    /// The number that the workload gives a name: 64 is that of `triangles` in `triangles=64 size=320x240`.
    pub(crate) fn number(&self, name: &str) -> Option<f64> {
        let words = self.workload.split(' ').filter_map(|word| word.split_once('='));
        words.filter(|&(key, _)| key == name).find_map(|(_, value)| value.parse().ok())
    }
}

/// A whole file.
pub(crate) fn text(header: &[(&str, String)], rows: &[Row]) -> String {
    let mut text = String::new();
    for (name, value) in header {
        let _ = writeln!(text, "# {name}: {}", value.replace(['\n', '\r'], " "));
    }
    let _ = writeln!(text, "{COLUMNS}");
    for row in rows {
        let Row { chart, method, workload, time_unit, time, error_metric, error, spread } = row;
        let cells = [
            quoted(chart),
            quoted(method),
            quoted(workload),
            quoted(time_unit),
            number(*time),
            quoted(error_metric),
            number(*error),
            number(*spread),
        ];
        let _ = writeln!(text, "{}", cells.join(","));
    }
    text
}

/// The rows of a file.
pub(crate) fn read(text: &str) -> Result<Vec<Row>, String> {
    let mut lines = records(text).into_iter();
    let names = lines.next().ok_or("no line of names")?;
    if names.join(",") != COLUMNS {
        return Err(format!("the columns are {}, not {COLUMNS}", names.join(",")));
    }
    lines
        .map(|cells| {
            let [chart, method, workload, time_unit, time, error_metric, error, spread] =
                <[String; 8]>::try_from(cells).map_err(|cells| format!("not eight cells: {cells:?}"))?;
            let [time, error, spread] = [time, error, spread].map(|cell| cell.parse());
            let wrong = |error| format!("{chart}, {method}, {workload}: {error}");
            let [time, error, spread] = [time.map_err(wrong)?, error.map_err(wrong)?, spread.map_err(wrong)?];
            Ok(Row { chart, method, workload, time_unit, time, error_metric, error, spread })
        })
        .collect()
}

fn quoted(cell: &str) -> String {
    if cell.contains([',', '"', '\n', '\r']) || cell.starts_with('#') {
        format!("\"{}\"", cell.replace('"', "\"\""))
    } else {
        cell.to_owned()
    }
}

/// Five significant digits, which is more than is known.
fn number(value: f64) -> String {
    let rounded: f64 = format!("{value:.4e}").parse().unwrap_or(value);
    if rounded == 0.0 || (1e-4..1e9).contains(&rounded.abs()) {
        rounded.to_string()
    } else {
        format!("{rounded:e}")
    }
}

/// Lines of cells; comments and empty lines are left out.
fn records(text: &str) -> Vec<Vec<String>> {
    let mut records = Vec::new();
    let mut rest = text;
    while !rest.is_empty() {
        if rest.starts_with(['#', '\n', '\r']) {
            rest = rest.split_once('\n').map_or("", |(_, after)| after);
            continue;
        }
        let mut cells = Vec::new();
        loop {
            let (cell, after) = cell(rest);
            cells.push(cell);
            rest = after;
            let Some(after) = rest.strip_prefix(',') else { break };
            rest = after;
        }
        records.push(cells);
        rest = rest.split_once('\n').map_or("", |(_, after)| after);
    }
    records
}

/// The first cell, and what follows it.
fn cell(text: &str) -> (String, &str) {
    let Some(mut rest) = text.strip_prefix('"') else {
        let end = text.find([',', '\n', '\r']).unwrap_or(text.len());
        return (text[..end].to_owned(), &text[end..]);
    };
    let mut cell = String::new();
    while let Some(end) = rest.find('"') {
        cell.push_str(&rest[..end]);
        rest = &rest[end + 1..];
        if !rest.starts_with('"') {
            return (cell, rest);
        }
        cell.push('"');
        rest = &rest[1..];
    }
    cell.push_str(rest);
    (cell, "")
}

#[cfg(test)]
mod tests {
    use super::*;

    fn row(method: &str, time: f64, error: f64) -> Row {
        Row {
            chart: "a".to_owned(),
            method: method.to_owned(),
            workload: "triangles=64 size=320x240 pixels=1e6".to_owned(),
            time_unit: "ms/frame".to_owned(),
            time,
            error_metric: "px".to_owned(),
            error,
            spread: 0.25,
        }
    }

    #[test]
    fn what_is_written_is_read_again() {
        let rows = [
            row("plain", 0.0123, 0.0),
            row("#a, \"b\"\nc", 1.5e-9, 4e12),
            row("", f64::INFINITY, -1.0),
            row(",", 123_450.0, 7.0),
        ];
        let text = text(&[("CPU", "a\nb, c".to_owned())], &rows);
        assert!(text.starts_with("# CPU: a b, c\nchart,method,"), "{text}");
        assert_eq!(read(&text).unwrap(), rows);
        assert_eq!(read(&text.replace("\n", "\r\n").replace("b\"\"\r\n", "b\"\"\n")).unwrap(), rows);
    }

    #[test]
    fn numbers_stand_in_the_workload() {
        let row = row("m", 1.0, 0.0);
        assert_eq!((row.number("triangles"), row.number("pixels")), (Some(64.0), Some(1e6)));
        assert_eq!((row.number("size"), row.number("tri")), (None, None));
    }

    #[test]
    fn another_file_is_refused() {
        assert_eq!(read("").unwrap_err(), "no line of names");
        assert!(read("x,y\n1,2\n").unwrap_err().starts_with("the columns are x,y"));
        assert!(read(&format!("{COLUMNS}\na,b\n")).unwrap_err().starts_with("not eight cells"));
        assert!(read(&format!("{COLUMNS}\na,b,c,d,five,f,0,0\n")).unwrap_err().starts_with("a, b, c: "));
        assert_eq!(read(&format!("{COLUMNS}\na,b,c,d,5,f,0,\"0")).unwrap().len(), 1);
    }
}
