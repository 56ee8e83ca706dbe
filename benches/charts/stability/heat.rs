//! A map of verdicts: a row a method, a column a scene.

use std::fmt::Write as _;

use crate::csv::Row;

/// Width and height of a cell, and what is left free for the names of methods and scenes.
const CELL: [usize; 2] = [53, 36];
const LEFT: usize = 380;
const TOP: usize = 660;
const BOTTOM: usize = 90;

/// Groups of methods stand apart by a gap; what a name begins with is its group.
const GAP: usize = 14;

/// The map as SVG, opaque, with the reader's sans-serif.
pub(super) fn map(rows: &[Row]) -> String {
    let mut methods: Vec<&str> = Vec::new();
    let mut scenes: Vec<&str> = Vec::new();
    for row in rows {
        if !methods.contains(&row.method.as_str()) {
            methods.push(&row.method);
        }
        if !scenes.contains(&row.workload.as_str()) {
            scenes.push(&row.workload);
        }
    }
    // The default first; else as they came.
    methods.sort_by_key(|method| group(method));
    let mut tops = Vec::new();
    let mut top = TOP;
    for (k, method) in methods.iter().enumerate() {
        let begins = k > 0 && group(method) != group(methods[k - 1]);
        top += if begins { GAP } else { 0 };
        tops.push(top);
        top += CELL[1];
    }
    let (width, height) = (LEFT + CELL[0] * scenes.len() + 40, top + BOTTOM);
    let mut svg = format!(
        "<svg width=\"{width}\" height=\"{height}\" viewBox=\"0 0 {width} {height}\" \
         xmlns=\"http://www.w3.org/2000/svg\" font-family=\"sans-serif\">\n\
         <rect width=\"{width}\" height=\"{height}\" fill=\"#FFFFFF\"/>\n\
         <text x=\"40\" y=\"58\" font-size=\"40\" font-weight=\"bold\" fill=\"#222222\">Which method passes which scene</text>\n"
    );
    svg.push_str(
        "<text x=\"40\" y=\"104\" font-size=\"27\" fill=\"#595959\">Pale blue: passed. Red: so many pixels are wrong, \
         k for thousands; darker: more. Empty: not asked.</text>\n",
    );
    for (k, scene) in scenes.iter().enumerate() {
        let x = LEFT + CELL[0] * k + CELL[0] / 2 + 9;
        let y = TOP - 12;
        let _ = writeln!(
            svg,
            "<text x=\"{x}\" y=\"{y}\" transform=\"rotate(-90 {x} {y})\" font-size=\"27\" fill=\"#222222\">{}</text>",
            escaped(scene)
        );
    }
    for (method, top) in methods.iter().zip(&tops) {
        let (y, x) = (top + CELL[1] - 9, LEFT - 14);
        let is_default = group(method) == 0;
        let (weight, color) = if is_default { ("bold", "#0072B2") } else { ("normal", "#222222") };
        let _ = writeln!(
            svg,
            "<text x=\"{x}\" y=\"{y}\" text-anchor=\"end\" font-size=\"27\" font-weight=\"{weight}\" fill=\"{color}\">{}</text>",
            escaped(method)
        );
    }
    for row in rows {
        let (Some(line), Some(column)) = (
            methods.iter().position(|method| *method == row.method),
            scenes.iter().position(|scene| *scene == row.workload),
        ) else {
            continue;
        };
        cell(&mut svg, row, [LEFT + CELL[0] * column, tops[line]]);
    }
    let y = top + 46;
    let _ = writeln!(
        svg,
        "<text x=\"40\" y=\"{y}\" font-size=\"27\" fill=\"#595959\">Scene 19 counts codes, 20 spheres and 21 kinds of steps instead of pixels. Ways to hide are drawn over exact strips, ways to fill without depth.</text>"
    );
    svg.push_str("</svg>\n");
    svg
}

fn cell(svg: &mut String, row: &Row, [x, y]: [usize; 2]) {
    let (fill, ink, text) = match row.error_metric.as_str() {
        "passed" => ("#D6E8F5".to_owned(), "#0072B2", String::new()),
        "wrong" => {
            // From pale to dark over five decades.
            let share = (row.error.max(1.0).log10() / 5.0).clamp(0.0, 1.0);
            let mix = |from: f64, to: f64| (from + (to - from) * share).round() as u8;
            let fill = format!("#{:02X}{:02X}{:02X}", mix(250.0, 165.0), mix(205.0, 50.0), mix(175.0, 0.0));
            (fill, if share > 0.55 { "#FFFFFF" } else { "#222222" }, short(row.error))
        }
        "not asked" => return,
        other => ("#222222".to_owned(), "#FFFFFF", other.to_owned()),
    };
    let [width, height] = CELL.map(|side| side - 3);
    let _ =
        writeln!(svg, "<rect x=\"{x}\" y=\"{y}\" width=\"{width}\" height=\"{height}\" fill=\"{fill}\"/>");
    if !text.is_empty() {
        let (x, y) = (x + width / 2, y + height - 8);
        let _ = writeln!(
            svg,
            "<text x=\"{x}\" y=\"{y}\" text-anchor=\"middle\" font-size=\"20\" fill=\"{ink}\">{text}</text>"
        );
    }
}

/// Which methods stand together, the default before all.
fn group(method: &str) -> usize {
    let kinds = ["fill", "hidden", "attribute", "shade", "sphere", "turn"];
    kinds.iter().position(|kind| method.starts_with(kind)).map_or(0, |k| k + 1)
}

/// A count in four signs at most.
fn short(count: f64) -> String {
    if count < 1_000.0 {
        format!("{count:.0}")
    } else if count < 999_500.0 {
        format!("{:.0}k", count / 1e3)
    } else {
        format!("{:.1}M", count / 1e6)
    }
}

fn escaped(text: &str) -> String {
    text.replace('&', "&amp;").replace('<', "&lt;")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn counts_are_short() {
        let counts = [1.0, 999.0, 1_000.0, 9_949.0, 246_713.0, 1_250_000.0].map(short);
        assert_eq!(counts, ["1", "999", "1k", "10k", "247k", "1.2M"]);
    }

    #[test]
    fn each_verdict_is_a_cell_and_what_is_not_asked_none() {
        let row = |method: &str, kind: &str, error| Row {
            chart: String::new(),
            method: method.to_owned(),
            workload: "1 a < b".to_owned(),
            time_unit: String::new(),
            time: f64::NAN,
            error_metric: kind.to_owned(),
            error,
            spread: f64::NAN,
        };
        let rows = [
            row("fill x", "wrong", 12_345.0),
            row("frame", "passed", 0.0),
            row("fill y", "NaN", 0.0),
            row("fill z", "not asked", 0.0),
        ];
        let svg = map(&rows);
        assert_eq!(svg.matches("<rect").count(), 1 + 3, "{svg}");
        for text in [">12k<", ">NaN<", ">1 a &lt; b<", ">fill z<"] {
            assert!(svg.contains(text), "{text} is missing");
        }
        assert!(svg.find(">frame<") < svg.find(">fill x<"), "the default stands first");
    }
}
