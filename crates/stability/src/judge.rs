//! The bench: draws what a scene asks for and counts the pixels that are wrong.

use crate::oracle::coverage::{Vertex, area2, edge, row_span, sample_point};
use crate::quiet::Quiet;
use crate::{Abilities, Drawn, Job, Rasteriser, Verdict};

/// A triangle that is drawn alone.
pub(crate) const ALONE: [[u32; 3]; 1] = [[0, 1, 2]];

/// Why a scene ends before its end.
#[derive(Clone, Copy, Debug)]
pub(crate) enum Stop {
    Panic,
    NotAsked,
}

/// What a scene's function returns.
pub(crate) type Outcome = Result<(), Stop>;

/// How often a pixel may be drawn, of a mesh whose triangles are drawn one by one.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Times {
    Never,
    Once,
    AtMostOnce,
}

/// A rasteriser before its judge.
pub(crate) struct Judge<'a> {
    rasteriser: &'a mut dyn Rasteriser,
    quiet: Quiet,
    pub(crate) abilities: Abilities,
    pub(crate) sample: [i64; 2],
    wrong: u64,
    not_a_number: bool,
}

/// A snapped vertex in clip space, with w = 1: exact, where the sides of the picture are powers of two.
pub(crate) fn place(v: Vertex, size: [u32; 2], depth: f32) -> [f32; 4] {
    let [half_width, half_height] = size.map(|side| 128 * i64::from(side));
    let x = (v[0] - half_width) as f64 / half_width as f64;
    let y = (half_height - v[1]) as f64 / half_height as f64;
    [x as f32, y as f32, depth, 1.0]
}

impl<'a> Judge<'a> {
    pub(crate) fn new(rasteriser: &'a mut dyn Rasteriser) -> Self {
        let abilities = rasteriser.abilities();
        let sample = abilities.sample.map(i64::from);
        Self { rasteriser, quiet: Quiet::new(), abilities, sample, wrong: 0, not_a_number: false }
    }

    pub(crate) fn verdict(&self, outcome: Outcome) -> Verdict {
        match outcome {
            Err(Stop::Panic) => Verdict::Panic,
            // What was found before the scene had nothing more to ask stays found.
            _ if self.not_a_number => Verdict::NotANumber,
            _ if self.wrong > 0 => Verdict::Wrong { pixels: self.wrong },
            Err(Stop::NotAsked) => Verdict::NotAsked,
            Ok(()) => Verdict::Pass,
        }
    }

    /// Counts a pixel, unless it is right.
    pub(crate) fn check(&mut self, right: bool) {
        self.wrong += u64::from(!right);
    }

    /// Counts pixels.
    pub(crate) fn wrong(&mut self, pixels: usize) {
        self.wrong += pixels as u64;
    }

    /// Where the pixel of that number is sampled, in 1/256 px.
    pub(crate) fn sample_of(&self, pixel: usize, width: u32) -> Vertex {
        let (i, j) = ((pixel % width as usize) as i64, (pixel / width as usize) as i64);
        sample_point(i, j, self.sample)
    }

    /// A picture with a number for each pixel. Numbers that no triangle has are wrong at once; missing ones are such.
    pub(crate) fn draw(
        &mut self,
        size: [u32; 2],
        vertices: &[[f32; 4]],
        triangles: &[[u32; 3]],
    ) -> Result<Drawn, Stop> {
        let job = Job { width: size[0], height: size[1], vertices, triangles };
        let mut drawn = self.quiet.catch(|| self.rasteriser.draw(&job)).ok_or(Stop::Panic)?;
        drawn.ids.resize(job.pixels(), u32::MAX);
        self.wrong(drawn.ids.iter().filter(|&&id| id as usize > triangles.len()).count());
        if let Some(depth) = &mut drawn.depth {
            depth.resize(job.pixels(), f32::INFINITY);
            let nan = depth.iter().zip(&drawn.ids).any(|(depth, &id)| id != 0 && depth.is_nan());
            self.not_a_number |= nan;
        }
        Ok(drawn)
    }

    /// Whether the pixel's sample lies on an edge of the triangle: other rules may decide it otherwise.
    pub(crate) fn may_differ(&self, t: &[Vertex; 3], p: Vertex) -> bool {
        !self.abilities.top_left && (0..3).any(|k| edge(t[k], t[(k + 1) % 3], p) == 0)
    }

    /// Draws a snapped triangle alone, with depths at its vertices, and compares it with the half-planes.
    pub(crate) fn compare(&mut self, size: [u32; 2], t: &[Vertex; 3], z: [f32; 3]) -> Result<Drawn, Stop> {
        let v = [0, 1, 2].map(|k| place(t[k], size, z[k]));
        let drawn = self.draw(size, &v, &ALONE)?;
        self.covers(size, t, &drawn.ids);
        Ok(drawn)
    }

    /// Compares a picture of one triangle with the half-planes.
    pub(crate) fn covers(&mut self, [width, _]: [u32; 2], t: &[Vertex; 3], ids: &[u32]) {
        for (j, row) in ids.chunks(width as usize).enumerate() {
            let span = row_span(t, j as i64, self.sample, width as usize);
            for (i, &id) in row.iter().enumerate() {
                if id != u32::from(span.contains(&i)) {
                    let p = sample_point(i as i64, j as i64, self.sample);
                    self.check(area2(t) != 0 && self.may_differ(t, p));
                }
            }
        }
    }

    /// How often each pixel is drawn by the triangles, each drawn alone.
    pub(crate) fn times(
        &mut self,
        size: [u32; 2],
        vertices: &[[f32; 4]],
        triangles: &[[u32; 3]],
    ) -> Result<Vec<u32>, Stop> {
        let mut times = vec![0; (size[0] * size[1]) as usize];
        for t in triangles {
            let corners = t.map(|k| vertices[k as usize]);
            let drawn = self.draw(size, &corners, &ALONE)?;
            for (times, &id) in times.iter_mut().zip(&drawn.ids) {
                *times += id.min(1);
            }
        }
        Ok(times)
    }

    /// Draws a mesh triangle by triangle and whole: each pixel as often as it may be, and the whole picture shows
    /// where any of them is.
    pub(crate) fn mesh(
        &mut self,
        size: [u32; 2],
        vertices: &[[f32; 4]],
        triangles: &[[u32; 3]],
        expected: impl Fn(Vertex) -> Times,
    ) -> Outcome {
        let times = self.times(size, vertices, triangles)?;
        let whole = self.draw(size, vertices, triangles)?;
        for (pixel, (&times, &id)) in times.iter().zip(&whole.ids).enumerate() {
            let right = match expected(self.sample_of(pixel, size[0])) {
                Times::Never => times == 0,
                Times::Once => times == 1,
                Times::AtMostOnce => times <= 1,
            };
            self.check(right && (times > 0) == (id > 0));
        }
        Ok(())
    }

    /// Draws a mesh with snapped vertices that fills the rectangle from `low` to `high`.
    pub(crate) fn rectangle(
        &mut self,
        size: [u32; 2],
        (vertices, triangles): (&[Vertex], &[[u32; 3]]),
        low: Vertex,
        high: Vertex,
    ) -> Outcome {
        let v: Vec<_> = vertices.iter().map(|&v| place(v, size, 0.5)).collect();
        let top_left = self.abilities.top_left;
        self.mesh(size, &v, triangles, |p| {
            let within = (0..2).all(|c| low[c] <= p[c] && p[c] <= high[c]);
            let on_border = within && (0..2).any(|c| p[c] == low[c] || p[c] == high[c]);
            match (within, on_border) {
                (true, true) if !top_left => Times::AtMostOnce,
                (true, _) if (0..2).all(|c| p[c] < high[c]) => Times::Once,
                _ => Times::Never,
            }
        })
    }
}
