//! Claim: for an error that is asked for, the icosahedron needs the fewest triangles, and the tetrahedron twice the
//! octahedron's.
//!
//! A sphere of 200 px radius, by subdivision of three solids, level by level. Error: how far the triangles lie inside the
//! sphere at most, in pixels: no outline is farther inside than that. *Measured* on the mesh, and *bound* by the formula
//! that a level is chosen by. Half a pixel is what a scene needs: what is below is drawn for nothing.
//!
//! Triangles are drawn as frames, over shared vertices for all three: 640×480, clear, transform and depth included.

use polosa_benches::ours::Picture;
use polosa_raster::{Frame, State, StoredDepth, Triangles, Vertices};
use polosa_scene::Mesh;
use polosa_scene::reference::Sphere;
use polosa_scene::reference::sphere::radial_error;
use polosa_scene::shape::{self, Solid};

use crate::chart::{Axis, Drawings, Figure, Guide, Line, Mark, Panel, Point, Series};
use crate::csv::Row;
use crate::measure::{Effort, interleaved};
use crate::style;

const NAME: &str = "detail";
/// In pixels.
const RADIUS: f64 = 200.0;
const SIZE: [u32; 2] = [640, 480];
/// What a viewer shows by default, in pixels.
const ENOUGH: f64 = 0.5;

/// How far inside the triangles of a level lie at most, as a part of the radius.
pub(crate) fn bound(sphere: Sphere, level: u32) -> f64 {
    let first = match sphere {
        Sphere::Tetrahedron => 4.0,
        Sphere::Octant => 1.0,
        Sphere::Icosahedron => 0.292,
    };
    first / f64::from(1_u32 << (2 * level))
}

/// The same triangles over shared vertices.
fn mesh(sphere: Sphere, level: u32) -> Result<Mesh, String> {
    let solid = match sphere {
        Sphere::Tetrahedron => Solid::Tetrahedron,
        Sphere::Octant => Solid::Octahedron,
        Sphere::Icosahedron => Solid::Icosahedron,
    };
    shape::sphere(solid, level).map_err(|error| error.to_string())
}

/// # Errors
///
/// When a sphere is farther from the round one than its bound.
pub(crate) fn measure(effort: Effort) -> Result<Vec<Row>, String> {
    let mut jobs = Vec::new();
    for &sphere in Sphere::ALL {
        for level in 0..effort.either(6, 8) {
            jobs.push((sphere, level, mesh(sphere, level)?));
        }
    }
    let (mut frame, mut picture) = (Frame::new(), Picture::new(SIZE));
    // Seen along −z, without perspective.
    let [x, y] = SIZE.map(|side| (2.0 * RADIUS / f64::from(side)) as f32);
    let matrix = [[x, 0.0, 0.0, 0.0], [0.0, y, 0.0, 0.0], [0.0, 0.0, 0.4, 0.0], [0.0, 0.0, 0.5, 1.0]];
    let timings = interleaved(jobs.len(), effort, |k| {
        let mesh = &jobs[k].2;
        frame.begin(SIZE, 0, StoredDepth::F32(0.0)).expect("the size is in range");
        let vertices = Vertices::Model { matrix: &matrix, positions: mesh.positions() };
        let triangles = Triangles::Indexed(mesh.triangles());
        frame.draw(&State::default(), 0, vertices, triangles, |k| k as u32 + 1);
        frame.finish(&mut picture.target()).expect("frame and picture are alike");
    });
    let mut rows = Vec::new();
    for ((sphere, level, mesh), timing) in jobs.iter().zip(timings) {
        // Of the sphere as its seed makes it.
        let seed = sphere.mesh(*level).map_err(|error| error.to_string())?;
        let (measured, bound) = (RADIUS * radial_error(&seed, 1.0), RADIUS * bound(*sphere, *level));
        // Positions are f32: at the last levels that is seen in the last digits.
        if measured > bound + RADIUS * 1e-6 {
            return Err(format!("{sphere} {level}: {measured} px inside, not {bound}"));
        }
        for (metric, error) in [("px inside, measured", measured), ("px inside, bound", bound)] {
            rows.push(Row {
                chart: NAME.to_owned(),
                method: sphere.name().to_owned(),
                workload: format!("level={level} triangles={} radius={RADIUS}", mesh.triangles().len()),
                time_unit: "ms/frame".to_owned(),
                time: timing.median * 1e-6,
                error_metric: metric.to_owned(),
                error,
                spread: timing.spread * 1e-6,
            });
        }
    }
    Ok(rows)
}

pub(crate) fn draw(rows: &[Row]) -> Result<Drawings, String> {
    let panels = vec![
        panel(rows, "triangles", "triangles", |row| {
            Some(Point::new([row.number("triangles")?, row.error], [0.0; 2]))
        }),
        panel(rows, "time", "ms a frame", |row| Some(Point::new([row.time, row.error], [row.spread, 0.0]))),
    ];
    let figure = Figure {
        title: "Detail: triangles against the error of an outline".to_owned(),
        notes: vec![
            "A sphere of 200 px radius, level by level. Filled: measured; hollow: the bound that a level is chosen by.".to_owned(),
            "Below half a pixel nobody sees a difference: there triangles are drawn for nothing.".to_owned(),
        ],
        panels,
        columns: 2,
    };
    Ok(vec![(NAME, figure.svg()?)])
}

fn panel(rows: &[Row], title: &str, label: &str, point: impl Fn(&Row) -> Option<Point>) -> Panel {
    let mut series = Vec::new();
    for &sphere in Sphere::ALL {
        let (color, mark, name) = style::of(sphere.name());
        let of = |metric: &str| -> Vec<Point> {
            let rows =
                rows.iter().filter(|row| row.method == sphere.name() && row.error_metric.ends_with(metric));
            rows.filter_map(&point).collect()
        };
        series.push(Series {
            name: String::new(),
            color,
            mark: Mark::Ring,
            line: Line::Dashed,
            points: of("bound"),
        });
        series.push(Series { name, color, mark, line: Line::Solid, points: of("measured") });
    }
    Panel {
        title: title.to_owned(),
        x: Axis::of(label),
        y: Axis::of("how far inside the sphere, px"),
        series,
        guides: vec![Guide::Level(ENOUGH, "½ px".to_owned())],
        front: true,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn no_sphere_is_farther_inside_than_its_bound_which_is_not_ten_times_too_large() {
        for &sphere in Sphere::ALL {
            for level in 0..6 {
                let measured = radial_error(&sphere.mesh(level).unwrap(), 1.0);
                let bound = bound(sphere, level);
                assert!(measured <= bound + 1e-6, "{sphere} {level}: {measured} > {bound}");
                assert!(level == 0 || measured * 4.0 > bound, "{sphere} {level}: {measured} of {bound}");
            }
        }
    }
}
