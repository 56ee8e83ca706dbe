//! Claim: a triangle covers exactly the pixels of the definition, whatever its shape, size or place.
//!
//! Judge: half-planes in `i128` over the snapped vertices ([`support::oracle`]). Ten classes of
//! 100,000 triangles, every winding and every first vertex among them; not one pixel may differ.

mod support;

use polosa_raster::{Depth, Flat, Stats, Target};
use support::classes::{CLASSES, GUARD, large, permuted, triangle};
use support::oracle::{CENTRE, Vertex, area2, covers, near_boundary, row_span};
use support::picture::{on_screen, screen};
use support::rng::Rng;

/// A picture of bytes: 1 where the triangle was drawn.
struct Canvas {
    bytes: Vec<u8>,
    zeros: Vec<u8>,
    ones: Vec<u8>,
    width: usize,
    height: usize,
}

impl Canvas {
    fn new(width: usize, height: usize) -> Self {
        Self { bytes: vec![0; width * height], zeros: vec![0; width], ones: vec![1; width], width, height }
    }

    fn draw(&mut self, t: &[Vertex; 3]) -> Stats {
        self.bytes.fill(0);
        let (width, height) = (u32::try_from(self.width).unwrap(), u32::try_from(self.height).unwrap());
        let mut target = Target::new(&mut self.bytes, Depth::None, width, height, self.width).unwrap();
        target.triangles(&on_screen(), &t.map(|v| screen(v, 0.5)), &[[0, 1, 2]], &Flat(1))
    }

    /// Draws the triangle and compares every row with the oracle's; returns the pixels covered.
    #[track_caller]
    fn check(&mut self, name: &str, t: &[Vertex; 3]) -> usize {
        let stats = self.draw(t);
        assert_eq!((stats.submitted, stats.clipped), (1, 0), "{name} {t:?}: {stats:?}");
        assert_eq!(stats.degenerate == 1, area2(t) == 0, "{name} {t:?}: {stats:?}");
        let mut covered = 0;
        for (j, row) in self.bytes.chunks(self.width).enumerate() {
            let span = row_span(t, j as i64, CENTRE, self.width);
            let same = row[..span.start] == self.zeros[..span.start]
                && row[span.clone()] == self.ones[..span.len()]
                && row[span.end..] == self.zeros[span.end..];
            let drawn: Vec<_> = if same { vec![] } else { (0..row.len()).filter(|&i| row[i] != 0).collect() };
            assert!(same, "{name} {t:?}, row {j}: expected {span:?}, got {drawn:?}");
            covered += span.len();
        }
        covered
    }
}

#[test]
fn the_oracles_spans_are_its_definition() {
    let mut r = Rng::new(1);
    for class in CLASSES {
        for k in 0..300 {
            let t = permuted(&triangle(class, &mut r, 24, 16), k);
            let sample = [r.range(0, 255), r.range(0, 255)];
            for j in 0..16 {
                let span = row_span(&t, j, sample, 24);
                for i in 0..24 {
                    assert_eq!(
                        covers(&t, i, j, sample),
                        span.contains(&(i as usize)),
                        "{class} {t:?} ({i}, {j})"
                    );
                }
            }
        }
    }
}

/// 100,000 triangles of a class; at least `least` of them must cover a pixel, so that the test says something.
#[track_caller]
fn class_equals_oracle(class: &str, least: usize) {
    let (width, height) = (96, 48);
    let mut canvas = Canvas::new(width, height);
    let mut r = Rng::new(0x00C0_FFEE ^ class.len() as u64);
    let mut visible = 0;
    for k in 0..100_000 {
        let t = permuted(&triangle(class, &mut r, width as i64, height as i64), k);
        visible += usize::from(canvas.check(class, &t) > 0);
    }
    assert!(visible >= least, "{class}: only {visible} triangles cover a pixel");
}

#[test]
fn random_triangles_equal_the_oracle() {
    class_equals_oracle("random", 90_000);
}

#[test]
fn slivers_equal_the_oracle() {
    class_equals_oracle("sliver", 15_000);
}

#[test]
fn triangles_on_pixel_corners_equal_the_oracle() {
    class_equals_oracle("on-grid", 90_000);
}

#[test]
fn triangles_on_pixel_centres_equal_the_oracle() {
    class_equals_oracle("half-grid", 90_000);
}

#[test]
fn tiny_triangles_equal_the_oracle() {
    class_equals_oracle("tiny", 10_000);
}

#[test]
fn huge_triangles_equal_the_oracle() {
    class_equals_oracle("huge", 10_000);
}

#[test]
fn triangles_to_the_guard_band_equal_the_oracle() {
    class_equals_oracle("guard-band", 10_000);
}

#[test]
fn needle_fans_equal_the_oracle() {
    class_equals_oracle("needle-fan", 10_000);
}

#[test]
fn degenerate_triangles_equal_the_oracle() {
    class_equals_oracle("degenerate", 100);
}

#[test]
fn triangles_beside_the_picture_equal_the_oracle() {
    class_equals_oracle("off-screen", 2_000);
}

#[test]
fn triangles_of_more_than_100_000_pixels_equal_the_oracle() {
    let (mut canvas, mut r) = (Canvas::new(1024, 512), Rng::new(7));
    let mut big = 0;
    for k in 0..2_400 {
        big += usize::from(canvas.check("large", &permuted(&large(&mut r), k)) > 100_000);
    }
    assert!(big >= 2_000, "only {big} triangles are over 100,000 px");
}

#[test]
fn order_and_winding_of_the_vertices_change_no_pixel() {
    let (mut canvas, mut r) = (Canvas::new(96, 80), Rng::new(8));
    for class in CLASSES {
        for _ in 0..1_000 {
            let t = triangle(class, &mut r, 96, 80);
            canvas.draw(&t);
            let first = canvas.bytes.clone();
            for k in 1..6 {
                canvas.draw(&permuted(&t, k));
                assert!(canvas.bytes == first, "{class} {t:?}, permutation {k}");
            }
        }
    }
}

#[test]
fn a_picture_of_16384_columns_or_rows_is_exact() {
    let mut r = Rng::new(9);
    for (width, height) in [(16_384, 3), (3, 16_384)] {
        let mut canvas = Canvas::new(width, height);
        for k in 0..120 {
            let t = [(); 3].map(|()| [r.range(-GUARD, GUARD), r.range(-GUARD, GUARD)]);
            canvas.check("wide", &permuted(&t, k));
            let t = [(); 3].map(|()| [r.range(0, 256 * width as i64), r.range(0, 256 * height as i64)]);
            canvas.check("wide", &permuted(&t, k));
        }
    }
}

/// Snapping is round-to-nearest, ties to even, and so moves a vertex by no more than half a sub-pixel.
#[test]
fn snapping_rounds_to_nearest_with_ties_to_even() {
    let mut canvas = Canvas::new(64, 64);
    let mut r = Rng::new(10);
    // Vertices in eighths of a sub-pixel: halfway cases are common, and everything is exact in f32.
    for k in 0..30_000 {
        let fine = permuted(&[(); 3].map(|()| [r.range(-4_096, 135_168), r.range(-4_096, 135_168)]), k);
        let snapped = fine.map(|v| v.map(|c| (c as f64 / 8.0).round_ties_even() as i64));
        canvas.bytes.fill(0);
        let mut target = Target::new(&mut canvas.bytes, Depth::None, 64, 64, 64).unwrap();
        let v = fine.map(|v| [v[0] as f32 / 2048.0, v[1] as f32 / 2048.0, 0.5, 1.0]);
        target.triangles(&on_screen(), &v, &[[0, 1, 2]], &Flat(1));
        for (j, row) in canvas.bytes.chunks(64).enumerate() {
            let span = row_span(&snapped, j as i64, CENTRE, 64);
            let drawn = row.iter().enumerate().all(|(i, &b)| (b == 1) == span.contains(&i));
            assert!(drawn, "{fine:?}, row {j}: expected {span:?}");
        }
    }
}

/// Against the triangle as it was *before* the snap: a pixel may differ only beside a true edge.
#[test]
fn snapping_moves_no_edge_by_more_than_its_half_diagonal() {
    let (mut canvas, mut r) = (Canvas::new(96, 80), Rng::new(11));
    let mut differing = 0;
    for k in 0..20_000 {
        // 1/65,536 px: 256 positions inside a sub-pixel, exact in f32 below 256 px.
        let t =
            permuted(&triangle("random", &mut r, 96, 80), k).map(|v| v.map(|c| 256 * c + r.range(-128, 128)));
        canvas.bytes.fill(0);
        let mut target = Target::new(&mut canvas.bytes, Depth::None, 96, 80, 96).unwrap();
        let v = t.map(|v| [v[0] as f32 / 65_536.0, v[1] as f32 / 65_536.0, 0.5, 1.0]);
        target.triangles(&on_screen(), &v, &[[0, 1, 2]], &Flat(1));
        for (j, row) in canvas.bytes.chunks(96).enumerate() {
            for (i, &byte) in row.iter().enumerate() {
                let p = [65_536 * i as i64 + 32_768, 65_536 * j as i64 + 32_768];
                if (byte == 1) != true_inside(&t, p) {
                    differing += 1;
                    assert!(near_boundary(&t, p, 256), "{t:?} differs at ({i}, {j}), far from its edges");
                }
            }
        }
    }
    assert!(differing > 100, "only {differing} pixels differ: the test shows nothing");
}

/// Whether `p` is inside a triangle or on its boundary, in any units.
fn true_inside(t: &[Vertex; 3], p: Vertex) -> bool {
    let e = [0, 1, 2].map(|k| support::oracle::edge(t[k], t[(k + 1) % 3], p));
    e.iter().all(|&e| e >= 0) || e.iter().all(|&e| e <= 0)
}
