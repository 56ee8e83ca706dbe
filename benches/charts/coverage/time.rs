//! The time that a triangle takes.

use std::ops::Range;

use polosa_benches::workloads::{HEIGHT, WIDTH};
use polosa_raster::reference::{Corner, Coverage, Visit};
use polosa_raster::{
    Clip, Depth, Frame, PerTriangle, Rect, Sample, StoredDepth, Target, Triangles, Vertices,
};
use polosa_stability::inputs::rng::Rng;

use super::corpora::random;
use super::judge::{Method, on_screen, vertices};
use crate::measure::{Effort, Timing, interleaved};

/// Somebody who draws; it keeps its working memory.
pub(crate) struct Contestant {
    pub(crate) method: Method,
    frame: Frame,
}

/// The same triangles, as each method takes them.
struct Soup {
    corners: Vec<[Corner; 3]>,
    vertices: Vec<Clip>,
    indices: Vec<[u32; 3]>,
}

impl Soup {
    /// Triangles of `area` pixels in random places.
    fn new(area: u32, count: u32) -> Self {
        let mut r = Rng::new(u64::from(area));
        let mut soup = Self { corners: Vec::new(), vertices: Vec::new(), indices: Vec::new() };
        for k in 0..count {
            let place = [r.range(0, 256 * i64::from(WIDTH)), r.range(0, 256 * i64::from(HEIGHT))];
            let corners = random(&mut r, area.into(), place);
            soup.corners.push(corners.map(|[x, y]| [x as f64 / 256.0, y as f64 / 256.0, 0.5]));
            soup.vertices.extend(vertices(&corners));
            soup.indices.push([3 * k, 3 * k + 1, 3 * k + 2]);
        }
        soup
    }
}

impl Contestant {
    /// The default methods, then the reference methods.
    pub(crate) fn all() -> Vec<Self> {
        let methods = [Method::Frame, Method::Immediate].into_iter();
        let methods = methods.chain(Coverage::ALL.iter().map(|&coverage| Method::Reference(coverage)));
        methods.map(|method| Self { method, frame: Frame::new() }).collect()
    }

    pub(crate) const fn name(&self) -> &'static str {
        match self.method {
            Method::Frame => "frame",
            Method::Immediate => "immediate",
            Method::Reference(coverage) => coverage.name(),
        }
    }

    /// Clears the picture and draws the soup.
    fn draw(&mut self, soup: &Soup, color: &mut [u32]) {
        let value = |k: usize| k as u32 + 1;
        if let Method::Reference(coverage) = self.method {
            color.fill(0);
            let all = Rect { x0: 0, y0: 0, x1: WIDTH, y1: HEIGHT };
            let mut fill = Fill { color, value: 0 };
            for (k, corners) in soup.corners.iter().enumerate() {
                fill.value = value(k);
                coverage.visit(all, Sample::CENTER, corners, &mut fill);
            }
            return;
        }
        if self.method == Method::Frame {
            self.frame.begin([WIDTH, HEIGHT], 0, StoredDepth::F32(0.0)).expect("the size is in range");
            self.frame.draw(&on_screen(), 0, Vertices::Clip(&soup.vertices), Triangles::Consecutive, value);
        } else {
            color.fill(0);
        }
        let mut target =
            Target::new(color, Depth::None, WIDTH, HEIGHT, WIDTH as usize).expect("the size is in range");
        if self.method == Method::Frame {
            self.frame.finish(&mut target).expect("frame and picture are alike");
        } else {
            target.triangles(&on_screen(), &soup.vertices, &soup.indices, &PerTriangle(value));
        }
    }
}

/// Nanoseconds a triangle of all contestants, in turns.
pub(crate) fn measure(all: &mut [Contestant], area: u32, count: u32, effort: Effort) -> Vec<Timing> {
    let soup = Soup::new(area, count);
    let mut color = vec![0; WIDTH as usize * HEIGHT as usize];
    let mut timings = interleaved(all.len(), effort, |k| all[k].draw(&soup, &mut color));
    for timing in &mut timings {
        timing.median /= f64::from(count);
        timing.spread /= f64::from(count);
    }
    timings
}

/// Fills memory, run by run where the method finds one.
struct Fill<'a> {
    color: &'a mut [u32],
    value: u32,
}

impl Visit for Fill<'_> {
    #[inline]
    fn pixel(&mut self, x: u32, y: u32) {
        self.color[(y * WIDTH + x) as usize] = self.value;
    }

    #[inline]
    fn row(&mut self, y: u32, columns: Range<u32>) {
        let first = (y * WIDTH) as usize;
        self.color[first + columns.start as usize..first + columns.end as usize].fill(self.value);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn all_exact_methods_draw_the_same_picture() {
        let soup = Soup::new(512, 300);
        let mut first: Option<Vec<u32>> = None;
        for mut contestant in Contestant::all() {
            let mut color = vec![9; WIDTH as usize * HEIGHT as usize];
            contestant.draw(&soup, &mut color);
            let first = first.get_or_insert_with(|| color.clone());
            let wrong = first.iter().zip(&color).filter(|(a, b)| a != b).count();
            // The others draw the same triangles, too: whole pixels move sides by less than one, which is a twentieth
            // of what is covered.
            let covered = first.iter().filter(|&&pixel| pixel != 0).count();
            assert!(wrong < covered / 10, "{}: {wrong} of {covered}", contestant.name());
            assert!(wrong == 0 || !contestant.method.is_exact(), "{}: {wrong}", contestant.name());
        }
        assert!(first.unwrap().iter().filter(|&&pixel| pixel != 0).count() > 100_000);
    }
}
