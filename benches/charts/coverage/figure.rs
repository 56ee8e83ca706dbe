//! The figure: a panel for each size.

use super::{METRIC, NAME, SIZES};
use crate::chart::{Axis, Drawings, Figure, Line, Panel, Point, Series};
use crate::csv::Row;
use crate::style;

pub(crate) fn draw(rows: &[Row]) -> Result<Drawings, String> {
    let panels = SIZES.map(|(area, _)| panel(rows, area)).to_vec();
    let figure = Figure {
        title: "Filling: time against wrong pixels".to_owned(),
        notes: vec![
            "Time of a triangle of one colour at 1920×1080, clear included, without depth. Wrong pixels of five corpora (random, on pixel centres,".to_owned(),
            "to ±32,767 px, slivers, meshes) against an exact oracle; a centre on a side counts by the method's own rule, in meshes by \"exactly once\".".to_owned(),
            "Broad line: the Pareto front. Medians of rounds; bars: the median distance from them.".to_owned(),
        ],
        panels,
        columns: 2,
    };
    Ok(vec![(NAME, figure.svg()?)])
}

fn panel(rows: &[Row], area: u32) -> Panel {
    let of_size = format!("area={area} corpus=all ");
    let mut series = Vec::new();
    for row in rows.iter().filter(|row| row.chart == NAME && row.workload.starts_with(&of_size)) {
        let (color, mark, name) = style::of(&row.method);
        let point = Point::new([row.time, row.error], [row.spread, 0.0]);
        series.push(Series { name, color, mark, line: Line::None, points: vec![point] });
    }
    Panel {
        title: format!("triangles of {} px", grouped(area)),
        x: Axis::of("ns a triangle"),
        y: Axis::of(METRIC),
        series,
        guides: Vec::new(),
        front: true,
    }
}

/// Thousands stand apart.
fn grouped(area: u32) -> String {
    if area < 1_000 { area.to_string() } else { format!("{},{:03}", area / 1_000, area % 1_000) }
}
