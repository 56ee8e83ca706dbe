//! The two figures: time as it is, and what each triangle or pixel adds to it.

use super::{PIXELS, TRIANGLES};
use crate::chart::{Axis, Color, Drawings, Figure, Guide, Line, Mark, Panel, Point, Series};
use crate::csv::Row;

/// Who draws, and in which colour and mark.
const WAYS: [(&str, Color, Mark); 2] =
    [("immediate", Color::Vermilion, Mark::Square), ("frame", Color::Blue, Mark::Disc)];

const SEEN: &str = "triangles that are seen";
const COVERED: &str = "pixels covered, each as often as it is covered";

/// A family of workloads in which one thing grows.
struct Growth {
    chart: &'static str,
    shape: &'static str,
    /// What stands before the name of who draws.
    name: &'static str,
    line: Line,
    /// Those who are shown.
    ways: &'static [&'static str],
}

const GROWTHS: [Growth; 6] = [
    Growth {
        chart: TRIANGLES,
        shape: "sheet",
        name: "sheet, ",
        line: Line::Solid,
        ways: &["immediate", "frame"],
    },
    Growth { chart: TRIANGLES, shape: "ball", name: "ball, ", line: Line::Dashed, ways: &["frame"] },
    Growth { chart: TRIANGLES, shape: "dust", name: "dust, ", line: Line::Dashed, ways: &["frame"] },
    Growth { chart: PIXELS, shape: "pile", name: "pile, ", line: Line::Solid, ways: &["immediate", "frame"] },
    Growth {
        chart: PIXELS,
        shape: "pair",
        name: "pair, ",
        line: Line::Dashed,
        ways: &["immediate", "frame"],
    },
    Growth { chart: PIXELS, shape: "whole", name: "whole, ", line: Line::Solid, ways: &["frame"] },
];

/// The figures of the rows, by the names of their files.
pub(crate) fn draw(rows: &[Row]) -> Result<Drawings, String> {
    let by_triangles = Figure {
        title: "Time grows with the triangles that are seen".to_owned(),
        notes: vec![
            format!(
                "1920×1080, one thread, clear included, depth tested and written. A sheet of {} thousand pixels is cut into ever more triangles,",
                thousands(rows, "sheet")
            ),
            format!(
                "and so is a ball of {} thousand, whose far half is culled; dust is ever more triangles of 2 px. Medians; bars: the median distance.",
                thousands(rows, "ball")
            ),
        ],
        panels: vec![
            times(rows, TRIANGLES, "triangles", SEEN, 1e6),
            shares(rows, TRIANGLES, "triangles", SEEN, "ns for each triangle"),
        ],
        columns: 2,
    };
    let by_pixels = Figure {
        title: "Time grows with the pixels that are covered".to_owned(),
        notes: vec![
            "One thread, clear included, depth tested and written. 1920×1080: a pair of triangles, from one pixel to the whole picture, and a pile of".to_owned(),
            "256 over each other. Whole: the pair over all of pictures from 320×240 to 3840×2160. Medians of rounds; bars: the median distance.".to_owned(),
        ],
        panels: vec![
            times(rows, PIXELS, "pixels", COVERED, 1e7),
            shares(rows, PIXELS, "pixels", COVERED, "ns for each pixel"),
        ],
        columns: 2,
    };
    Ok(vec![(TRIANGLES, by_triangles.svg()?), (PIXELS, by_pixels.svg()?)])
}

/// The rows of a growth in one way: how much there is, and the time of a frame with its spread in milliseconds.
fn points(rows: &[Row], growth: &Growth, way: &str, what: &str) -> Vec<[f64; 3]> {
    let shape = format!("shape={} ", growth.shape);
    let of =
        |row: &&Row| row.method == way && row.time_unit == "ms/frame" && row.workload.starts_with(&shape);
    let mut points: Vec<[f64; 3]> =
        rows.iter().filter(of).filter_map(|row| Some([row.number(what)?, row.time, row.spread])).collect();
    points.sort_by(|a, b| a[0].total_cmp(&b[0]));
    points
}

/// All lines of a chart, each by what becomes of its points.
fn lines(
    rows: &[Row],
    chart: &str,
    what: &str,
    point: impl Fn(&[[f64; 3]], usize) -> Option<Point>,
) -> Vec<Series> {
    let mut lines = Vec::new();
    for growth in GROWTHS.iter().filter(|growth| growth.chart == chart) {
        for (way, color, mark) in WAYS {
            if !growth.ways.contains(&way) {
                continue;
            }
            let all = points(rows, growth, way, what);
            let points: Vec<Point> = (0..all.len()).filter_map(|k| point(&all, k)).collect();
            let (color, mark) = match growth.shape {
                "ball" => (Color::Purple, Mark::Ring),
                "dust" | "whole" => (Color::Orange, Mark::Diamond),
                "pair" => (color, Mark::Ring),
                _ => (color, mark),
            };
            lines.push(Series {
                name: format!("{}{way}", growth.name),
                color,
                mark,
                line: growth.line,
                points,
            });
        }
    }
    lines
}

/// Milliseconds a frame.
fn times(rows: &[Row], chart: &str, what: &str, label: &str, guide_at: f64) -> Panel {
    let series = lines(rows, chart, what, |all, k| {
        let [x, y, spread] = all[k];
        Some(Point::new([x, y], [0.0, spread]))
    });
    let mut guides = Vec::new();
    let nothing = rows.iter().find(|row| {
        row.method == "frame" && row.time_unit == "ms/frame" && row.workload.starts_with("shape=nothing ")
    });
    if let Some(nothing) = nothing {
        guides.push(Guide::Level(nothing.time, "an empty frame of 1920×1080".to_owned()));
    }
    // Below all lines.
    let lowest = series.iter().flat_map(|series| &series.points).map(|p| p.at[1] / p.at[0].max(1.0));
    if let Some(share) = lowest.reduce(f64::min) {
        guides.push(Guide::Proportional([guide_at, guide_at * share * 0.6], "proportional".to_owned()));
    }
    Panel {
        title: "the whole frame".to_owned(),
        x: Axis::of(label).within(1.0, most_of(chart)),
        y: Axis::of("ms a frame"),
        series,
        guides,
        front: false,
    }
}

/// What each adds to the least of its line, where that is more than noise.
fn shares(rows: &[Row], chart: &str, what: &str, names: &str, label: &str) -> Panel {
    let series = lines(rows, chart, what, |all, k| {
        let [[least, floor, noise], [x, y, spread]] = [all[0], all[k]];
        let (more, spread) = (y - floor, spread + noise);
        (x > 2.0 * least && more > 3.0 * spread)
            .then(|| Point::new([x, 1e6 * more / x], [0.0, 1e6 * spread / x]))
    });
    Panel {
        title: "beyond the first point of its line".to_owned(),
        x: Axis::of(names),
        y: Axis::of(label),
        series,
        guides: Vec::new(),
        front: false,
    }
}

/// The pixels of the last workload of a shape, in thousands.
fn thousands(rows: &[Row], shape: &str) -> String {
    let shape = format!("shape={shape} ");
    let last = rows.iter().rfind(|row| row.workload.starts_with(&shape));
    last.and_then(|row| row.number("pixels")).map_or("?".to_owned(), |pixels| format!("{:.0}", pixels / 1e3))
}

/// Where the axis of triangles or pixels ends at least: there may be less in a quick run.
fn most_of(chart: &str) -> f64 {
    if chart == TRIANGLES { 4.2e6 } else { 5e8 }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn row(shape: &str, triangles: f64, time: f64, spread: f64) -> Row {
        Row {
            chart: TRIANGLES.to_owned(),
            method: "frame".to_owned(),
            workload: format!("shape={shape} triangles={triangles} submitted=9 pixels=5000 size=8x8"),
            time_unit: "ms/frame".to_owned(),
            time,
            error_metric: String::new(),
            error: 0.0,
            spread,
        }
    }

    #[test]
    fn shares_are_what_each_adds_where_that_is_more_than_noise() {
        let times = [(1.0, 2.0, 0.1), (10.0, 2.1, 0.1), (100.0, 3.0, 0.1), (1000.0, 12.0, 0.1)];
        let rows: Vec<Row> = times.into_iter().map(|(n, t, s)| row("sheet", n, t, s)).collect();
        let panel = shares(&rows, TRIANGLES, "triangles", SEEN, "ns");
        let frame = panel.series.iter().find(|series| series.name == "sheet, frame").unwrap();
        let at: Vec<[f64; 2]> = frame.points.iter().map(|point| point.at).collect();
        assert_eq!(at, [[100.0, 10_000.0], [1000.0, 10_000.0]]);
    }

    #[test]
    fn all_rows_are_drawn_in_two_figures() {
        let rows = [row("nothing", 0.0, 1.0, 0.0), row("sheet", 4.0, 2.0, 0.0), row("sheet", 8.0, 3.0, 0.5)];
        let drawings = draw(&rows).unwrap();
        assert_eq!(drawings.iter().map(|drawing| drawing.0).collect::<Vec<_>>(), [TRIANGLES, PIXELS]);
        assert!(drawings[0].1.contains("an empty frame") && drawings[0].1.contains("A sheet of 5 thousand"));
        assert!(draw(&[]).is_ok(), "nothing was measured");
    }
}
