//! Claim: reversed `f32` depth is the only common format that tells surfaces apart far away, with any far plane.
//!
//! Pairs of distances from the eye, evenly spread in their logarithm from the near plane at 0.1 to the far one (to 10⁵
//! where that is infinite), the second farther than the first by a relative separation. A *tie* is a pair stored as
//! equal, a *swap* one stored in the other order. Nothing is timed: all formats are stored in one instruction or two.

use polosa_raster::reference::DepthFormat;

use crate::chart::{Axis, Drawings, Figure, Line, Panel, Point, Series};
use crate::csv::Row;
use crate::measure::Effort;
use crate::style;

const NAME: &str = "format";
const NEAR: f64 = 0.1;
/// Far planes, and what they are called.
const FARS: [(f64, &str); 3] = [(1e3, "1e3"), (1e5, "1e5"), (f64::INFINITY, "infinite")];
/// The farthest distance before an infinite far plane.
const FARTHEST: f64 = 1e5;
const SEPARATIONS: [f64; 7] = [1e-3, 3e-4, 1e-4, 3e-5, 1e-5, 3e-6, 1e-6];

/// How many pairs of a hundred tie, and how many are swapped.
fn percent(format: DepthFormat, far: f64, apart: f64, pairs: u32) -> [f64; 2] {
    let last = if far.is_finite() { far } else { FARTHEST };
    let (mut ties, mut swaps) = (0, 0);
    for k in 0..pairs {
        // The farther one is before the far plane, too.
        let share = (f64::from(k) + 0.5) / f64::from(pairs);
        let w = NEAR * libm::pow(last / NEAR / (1.0 + apart), share);
        let [near, farther] = [w, w * (1.0 + apart)].map(|w| format.store(w, NEAR, far));
        ties += u32::from(near == farther);
        swaps += u32::from(near < farther);
    }
    [ties, swaps].map(|count| 100.0 * f64::from(count) / f64::from(pairs))
}

/// # Errors
///
/// When the default ties or swaps at 10⁻⁵ or more, or swaps at all. (A millionth is a few steps of an `f32`: the default
/// must not tie there either.)
pub(crate) fn measure(effort: Effort) -> Result<Vec<Row>, String> {
    let mut rows = Vec::new();
    for (far, named) in FARS {
        for &format in DepthFormat::ALL {
            // A w-buffer needs a far plane.
            if format == DepthFormat::WBuffer24 && far.is_infinite() {
                continue;
            }
            for apart in SEPARATIONS {
                let pairs = effort.either(20_000, 1_000_000);
                let [ties, swaps] = percent(format, far, apart, pairs);
                if format == DepthFormat::F32Reversed && ties + swaps > 0.0 {
                    return Err(format!("{format}: {ties} % ties, {swaps} % swaps at {apart}, far {named}"));
                }
                for (metric, error) in [("ties, %", ties), ("swaps, %", swaps)] {
                    rows.push(Row {
                        chart: NAME.to_owned(),
                        method: format.name().to_owned(),
                        workload: format!("far={named} separation={apart:e} near={NEAR} pairs={pairs}"),
                        time_unit: String::new(),
                        time: f64::NAN,
                        error_metric: metric.to_owned(),
                        error,
                        spread: f64::NAN,
                    });
                }
            }
        }
    }
    Ok(rows)
}

pub(crate) fn draw(rows: &[Row]) -> Result<Drawings, String> {
    let panels = FARS.map(|(_, far)| panel(rows, far)).to_vec();
    let swaps = rows.iter().filter(|row| row.error_metric.starts_with("swaps"));
    let swaps =
        if swaps.clone().all(|row| row.error == 0.0) { "No format swaps any." } else { "Some are swapped." };
    let figure = Figure {
        title: "Depth formats: surfaces that cannot be told apart".to_owned(),
        notes: vec![
            "Pairs of distances evenly spread in their logarithm, near plane at 0.1; the far plane as said, pairs up to 100,000 where it is infinite.".to_owned(),
            format!("A tie is stored as equal: which surface is seen is left to chance. {swaps} f32-standard, d24 and w-buffer-24 are nearly the same."),
        ],
        panels,
        columns: 2,
    };
    Ok(vec![(NAME, figure.svg()?)])
}

fn panel(rows: &[Row], far: &str) -> Panel {
    let of_far = format!("far={far} ");
    let mut series = Vec::new();
    for &format in DepthFormat::ALL {
        let of = |row: &&Row| {
            row.method == format.name()
                && row.error_metric.starts_with("ties")
                && row.workload.starts_with(&of_far)
        };
        let point = |row: &Row| Some(Point::new([row.number("separation")?, row.error], [0.0; 2]));
        let points: Vec<Point> = rows.iter().filter(of).filter_map(point).collect();
        let (color, mark, name) = style::of(format.name());
        if !points.is_empty() {
            series.push(Series { name, color, mark, line: Line::Solid, points });
        }
    }
    let title = if far == "infinite" { "no far plane".to_owned() } else { format!("far plane at {far}") };
    Panel {
        title: title.replace("1e3", "1,000").replace("1e5", "100,000"),
        x: Axis::of("distance between two surfaces, as a part of that from the eye"),
        y: Axis::of("pairs that tie, %").within(0.1, 100.0),
        series,
        guides: Vec::new(),
        front: false,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_default_never_ties_and_24_bits_do() {
        for (far, _) in FARS {
            for apart in SEPARATIONS {
                assert_eq!(percent(DepthFormat::F32Reversed, far, apart, 30_000), [0.0; 2], "{far} {apart}");
            }
            assert!(percent(DepthFormat::D24, far, 1e-5, 30_000)[0] > 20.0, "{far}");
        }
    }
}
