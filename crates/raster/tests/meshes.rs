//! Claim: triangles that share vertices share no pixel and leave none out.
//!
//! The domain of each mesh is known, so that every pixel inside must be drawn exactly once.

mod support;

use polosa_raster::{Depth, State, Target};
use support::mesh::{Mesh, fan, grid, scattered};
use support::oracle::{CENTRE, Vertex, edge, sample_point};
use support::picture::{Picture, count, on_screen, screen};
use support::rng::Rng;

fn draw(mesh: &Mesh, width: usize, height: usize) -> Picture {
    let mut picture = Picture::new(width, height);
    let v: Vec<_> = mesh.vertices.iter().map(|&v| screen(v, 0.5)).collect();
    let (w, h) = (u32::try_from(width).unwrap(), u32::try_from(height).unwrap());
    let mut target = Target::new(&mut picture.color, Depth::None, w, h, width).unwrap();
    let stats = target.triangles(&on_screen(), &v, &mesh.triangles, &count);
    assert_eq!(stats.drawn + stats.degenerate, stats.submitted, "{stats:?}");
    picture
}

/// Every pixel whose centre is in the half-open rectangle is drawn once, every other never.
#[track_caller]
fn rectangle_is_drawn_once(name: &str, mesh: &Mesh, low: Vertex, high: Vertex, width: usize, height: usize) {
    let picture = draw(mesh, width, height);
    for (k, &times) in picture.color.iter().enumerate() {
        let p = sample_point((k % width) as i64, (k / width) as i64, CENTRE);
        let inside = (0..2).all(|c| low[c] <= p[c] && p[c] < high[c]);
        assert_eq!(times, u32::from(inside), "{name}: pixel ({}, {})", k % width, k / width);
    }
}

#[test]
fn grids_on_pixel_centres_draw_every_pixel_once() {
    let (low, high) = ([128, 128], [128 + 256 * 120, 128 + 256 * 96]);
    for n in [1, 2, 3, 4, 6, 8, 12, 24] {
        let mesh = grid(low, high, n, |p| p);
        rectangle_is_drawn_once(&format!("{n} cells"), &mesh, low, high, 128, 100);
    }
}

#[test]
fn grids_with_displaced_vertices_draw_every_pixel_once() {
    let mut r = Rng::new(20);
    // The grain of the displacement: pixels (so that vertices stay on centres), quarter-pixels, sub-pixels.
    for grain in [256, 64, 1] {
        for n in [4, 8, 16] {
            let (low, high) = ([128, 128], [128 + 256 * 160, 128 + 256 * 128]);
            let reach = (256 * 128 / n) / 4 / grain;
            let mesh = grid(low, high, n, |p| p.map(|c| c + grain * r.range(-reach, reach)));
            rectangle_is_drawn_once(&format!("grain {grain}, {n} cells"), &mesh, low, high, 170, 140);
        }
    }
}

#[test]
fn grids_finer_than_pixels_draw_every_pixel_once() {
    let mut r = Rng::new(21);
    for size in [37, 100, 171, 256] {
        let (low, high) = ([40, 70], [40 + 100 * size, 70 + 100 * size]);
        let mesh = grid(low, high, 100, |p| p.map(|c| c + r.range(-size / 5, size / 5)));
        rectangle_is_drawn_once(&format!("cells of {size}/256 px"), &mesh, low, high, 104, 104);
    }
}

#[test]
fn scattered_triangulations_draw_every_pixel_once() {
    let mut r = Rng::new(22);
    for (round, grain) in [256, 256, 64, 64, 16, 1, 1, 1].into_iter().enumerate() {
        let (low, high) = ([128, 128], [128 + 256 * 128, 128 + 256 * 96]);
        let mesh = scattered(low, high, 300, &mut r, grain);
        assert!(mesh.triangles.len() > 100, "{} triangles", mesh.triangles.len());
        rectangle_is_drawn_once(&format!("round {round}, grain {grain}"), &mesh, low, high, 132, 100);
    }
}

#[test]
fn meshes_larger_than_the_picture_draw_every_pixel_once() {
    let mut r = Rng::new(23);
    for reach in [1_000, 10_000, 32_000] {
        let (low, high) = ([-256 * reach; 2], [256 * reach; 2]);
        let mesh = scattered(low, high, 150, &mut r, 1);
        rectangle_is_drawn_once(&format!("±{reach} px"), &mesh, low, high, 128, 128);
    }
}

/// Scene 5: around the centre of a fan of 64 spokes no pixel is missed and none is drawn twice.
#[track_caller]
fn fan_is_drawn_once(radius: f64, centre: Vertex) {
    let mesh = fan(centre, radius * 256.0);
    let picture = draw(&mesh, 1024, 1024);
    if radius > 2_000.0 {
        assert!(picture.color.iter().all(|&times| times == 1), "R = {radius}: {:?}", picture.painted().len());
        return;
    }
    let rim = &mesh.vertices[1..];
    for (k, &times) in picture.color.iter().enumerate() {
        let p = sample_point((k % 1024) as i64, (k / 1024) as i64, CENTRE);
        // All spokes turn the same way, so that the rim is a convex polygon of positive area.
        let from = [0, 1].map(|c| (p[c] - centre[c]) as f64 / 256.0);
        if from[0] * from[0] + from[1] * from[1] < (0.99 * radius).powi(2) {
            assert_eq!(times, 1, "R = {radius}: pixel ({}, {})", k % 1024, k / 1024);
            continue; // Well inside of the rim, which is at cos(π/64) = 0.998 of the radius at least.
        }
        let inside = (0..64).map(|s| edge(rim[s], rim[(s + 1) % 64], p)).min().unwrap();
        let allowed = match inside.signum() {
            1 => 1..=1,
            0 => 0..=1,
            _ => 0..=0,
        };
        assert!(allowed.contains(&times), "R = {radius}: pixel ({}, {}) {times} times", k % 1024, k / 1024);
    }
}

#[test]
fn scene_05_a_fan_of_400_px_draws_every_pixel_once() {
    fan_is_drawn_once(400.0, [512 * 256, 512 * 256]);
    fan_is_drawn_once(400.0, [512 * 256 + 128, 512 * 256 + 128]);
    fan_is_drawn_once(400.0, [512 * 256 + 77, 512 * 256 + 201]);
}

#[test]
fn scene_05_a_fan_of_16_000_px_draws_every_pixel_once() {
    fan_is_drawn_once(16_000.0, [512 * 256, 512 * 256]);
    fan_is_drawn_once(16_000.0, [300 * 256 + 128, 700 * 256 + 128]);
}

/// Beyond the guard band: every spoke is clipped, and both its neighbours must get the same cut.
#[test]
fn scene_05_a_fan_of_a_million_px_draws_every_pixel_once() {
    fan_is_drawn_once(1e6, [512 * 256, 512 * 256]);
    fan_is_drawn_once(1e6, [300 * 256 + 128, 700 * 256 + 128]);
}

#[test]
fn every_sample_position_sees_every_mesh_once() {
    let mut r = Rng::new(24);
    let (low, high) = ([0, 0], [256 * 64, 256 * 64]);
    let mesh = scattered(low, high, 200, &mut r, 1);
    let v: Vec<_> = mesh.vertices.iter().map(|&v| screen(v, 0.5)).collect();
    for (x, y) in [(0, 0), (255, 255), (0, 255), (32, 96), (160, 224), (17, 3)] {
        let mut picture = Picture::new(64, 64);
        let state = State { sample: polosa_raster::Sample { x, y }, ..on_screen() };
        let mut target = Target::new(&mut picture.color, Depth::None, 64, 64, 64).unwrap();
        target.triangles(&state, &v, &mesh.triangles, &count);
        assert!(picture.color.iter().all(|&times| times == 1), "sample ({x}, {y})");
    }
}
