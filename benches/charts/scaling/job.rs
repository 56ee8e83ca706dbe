//! What is drawn, and the ways to draw it.

use polosa_benches::mesh::{RANGE, dented_ball};
use polosa_benches::ours::Picture;
use polosa_benches::workloads::{HEIGHT, Soup, TINY, WIDTH};
use polosa_raster::{
    Clip, Columns, Cull, Depth, DepthTest, Fragment, Frame, Level, PerTriangle, State, Stats, StoredDepth,
    Target, Triangles, Vertices, transform,
};

use super::{PIXELS, TRIANGLES};
use crate::csv::Row;
use crate::measure::{Effort, Timing};

const SIZE: [u32; 2] = [WIDTH, HEIGHT];
/// How often the finest sheet is halved: 4¹¹ triangles.
const FINEST: u32 = 11;
/// The sheet's legs in pixels: whole sub-pixels on every sheet, 2⁻¹¹ of each being 240 and 128 of them.
const LEGS: [u32; 2] = [1920, 1024];
/// Triangles of a pile.
const PILE: u32 = 256;

/// How many ways there are to draw.
pub(crate) const WAYS: usize = 2;

/// A way to draw; it keeps its working memory.
#[derive(Debug)]
pub(crate) struct Way {
    pub(crate) name: &'static str,
    /// None: triangle by triangle.
    frame: Option<Frame>,
    /// Vertices after their transform.
    clip: Vec<Clip>,
}

impl Way {
    /// Each by one thread: of two, the second would measure how busy the machine is. The first is what the other must
    /// equal.
    pub(crate) fn all() -> [Self; WAYS] {
        let way = |name, frame| Self { name, frame, clip: Vec::new() };
        [way("immediate", None), way("frame", Some(Frame::with(Level::detect(), 1)))]
    }
}

/// A picture to be drawn.
#[derive(Clone, Debug)]
pub(crate) struct Job {
    chart: &'static str,
    shape: &'static str,
    pub(crate) size: [u32; 2],
    points: Points,
    triangles: Vec<[u32; 3]>,
    cull: Cull,
}

#[derive(Clone, Debug)]
enum Points {
    Clip(Vec<Clip>),
    Model(Columns, Vec<[f32; 3]>),
}

impl Points {
    fn lent(&self) -> Vertices<'_> {
        match self {
            Self::Clip(vertices) => Vertices::Clip(vertices),
            Self::Model(matrix, positions) => Vertices::Model { matrix, positions },
        }
    }
}

impl Job {
    pub(crate) fn all(effort: Effort) -> Vec<Self> {
        let mut jobs = vec![Self::new(TRIANGLES, "nothing", SIZE, Vec::new(), Vec::new())];
        jobs.extend((0..=FINEST).step_by(effort.either(3, 1)).map(Self::sheet));
        let balls: &[u32] = effort
            .either(&[12, 16_000], &[12, 192, 1_200, 4_800, 19_200, 76_800, 307_200, 1_228_800, 4_000_000]);
        jobs.extend(balls.iter().map(|&count| Self::ball(count)));

        let dust: &[u32] = effort.either(&RANGE[..1], &RANGE);
        jobs.extend(dust.iter().map(|&count| {
            let soup = Soup::new(SIZE, count, TINY.side, 1);
            Self::new(TRIANGLES, "dust", SIZE, soup.flat(), soup.indices)
        }));

        let squares: &[u32] = effort.either(&[1, 32, 512], &[1, 2, 4, 8, 16, 32, 64, 128, 256, 512, 1024]);
        jobs.extend(squares.iter().map(|&side| Self::pair("pair", SIZE, [side, side])));
        jobs.push(Self::pair("pair", SIZE, SIZE));
        let areas: &[f32] = effort.either(
            &[1.0, 1e3, 1e5],
            &[1.0, 4.0, 16.0, 64.0, 250.0, 1e3, 4e3, 7e3, 16e3, 64e3, 250e3, 1e6, 2_073_600.0],
        );
        jobs.extend(areas.iter().map(|&area| {
            let soup = Soup::of_area(area, PILE);
            Self::new(PIXELS, "pile", SIZE, soup.flat(), soup.indices)
        }));
        let sizes: &[[u32; 2]] = effort.either(
            &[[320, 240], [1280, 720]],
            &[[320, 240], [640, 480], [1280, 720], [1920, 1080], [2560, 1440], [3840, 2160]],
        );
        jobs.extend(sizes.iter().map(|&size| Self::pair("whole", size, size)));
        jobs
    }

    fn new(
        chart: &'static str,
        shape: &'static str,
        size: [u32; 2],
        vertices: Vec<Clip>,
        triangles: Vec<[u32; 3]>,
    ) -> Self {
        Self { chart, shape, size, points: Points::Clip(vertices), triangles, cull: Cull::None }
    }

    /// A right triangle, cut into 4ⁿ: row by row, pairs of triangles but for the last of each row.
    fn sheet(n: u32) -> Self {
        let cells = 1_u32 << n;
        let mut vertices = Vec::new();
        let mut triangles = Vec::new();
        for j in 0..=cells {
            // Row j has cells − j cells; its first vertex is the number of those in the rows before.
            let first = vertices.len() as u32;
            let below = first + cells - j + 1;
            for i in 0..=cells - j {
                let along = |k: u32, leg: usize| k as f32 * LEGS[leg] as f32 / cells as f32;
                vertices.push(on_screen(SIZE, [along(i, 0), along(j, 1)], 0.5 + along(i, 0) / 8192.0));
                if i + j < cells {
                    triangles.push([first + i, below + i, first + i + 1]);
                }
                if i + j + 1 < cells {
                    triangles.push([first + i + 1, below + i, below + i + 1]);
                }
            }
        }
        Self::new(TRIANGLES, "sheet", SIZE, vertices, triangles)
    }

    /// A ball over half of the picture's height, seen along −z without perspective; its far side is culled.
    fn ball(count: u32) -> Self {
        let mesh = dented_ball(count);
        let scale = [0.75 * HEIGHT as f32 / WIDTH as f32, 0.75];
        let matrix = [
            [scale[0], 0.0, 0.0, 0.0],
            [0.0, scale[1], 0.0, 0.0],
            [0.0, 0.0, 0.4, 0.0],
            [0.0, 0.0, 0.5, 1.0],
        ];
        let points = Points::Model(matrix, mesh.positions);
        Self {
            chart: TRIANGLES,
            shape: "ball",
            size: SIZE,
            points,
            triangles: mesh.triangles,
            cull: Cull::Back,
        }
    }

    /// Two triangles that make a rectangle in the middle of the picture.
    fn pair(shape: &'static str, size: [u32; 2], sides: [u32; 2]) -> Self {
        let [left, top] = [0, 1].map(|k| (size[k] - sides[k]) / 2);
        let (right, bottom) = (left + sides[0], top + sides[1]);
        let corners = [[left, top], [left, bottom], [right, bottom], [right, top]];
        let vertices = corners.map(|corner| on_screen(size, corner.map(|c| c as f32), 0.5));
        Self::new(PIXELS, shape, size, vertices.to_vec(), vec![[0, 1, 2], [0, 2, 3]])
    }

    fn state(&self) -> State {
        State { cull: self.cull, ..State::default() }
    }

    /// Clears the picture and draws.
    pub(crate) fn draw(&self, way: &mut Way, picture: &mut Picture) -> Stats {
        let value = |triangle: usize| triangle as u32 + 1;
        if let Some(frame) = &mut way.frame {
            frame.begin(self.size, 0, StoredDepth::F32(0.0)).expect("the size is in range");
            let triangles = Triangles::Indexed(&self.triangles);
            let stats = frame.draw(&self.state(), 0, self.points.lent(), triangles, value);
            frame.finish(&mut picture.target()).expect("frame and picture are alike");
            return stats;
        }
        let clip = match &self.points {
            Points::Clip(vertices) => vertices,
            Points::Model(matrix, positions) => {
                way.clip.resize(positions.len(), [0.0; 4]);
                transform(matrix, positions, &mut way.clip);
                &way.clip
            }
        };
        let mut target = picture.target();
        target.clear(0, DepthTest::Greater);
        target.triangles(&self.state(), clip, &self.triangles, &PerTriangle(value))
    }

    /// How many pixels of each way's picture are not those of the first way's, in colour or depth: none, or it is
    /// an error.
    pub(crate) fn check(&self, ways: &mut [Way], picture: &mut Picture) -> Result<Vec<usize>, String> {
        let mut first: Option<Picture> = None;
        let mut counts = Vec::new();
        for way in ways {
            self.draw(way, picture);
            let first = first.get_or_insert_with(|| picture.clone());
            let same = |k: &usize| {
                first.color[*k] == picture.color[*k]
                    && first.depth[*k].to_bits() == picture.depth[*k].to_bits()
            };
            let different = (0..picture.color.len()).filter(|k| !same(k)).count();
            if different > 0 {
                return Err(format!(
                    "{}, {}: {different} pixels differ",
                    self.workload(self.counts()),
                    way.name
                ));
            }
            counts.push(different);
        }
        Ok(counts)
    }

    /// Pixels that triangles cover, each as often as it is covered; and triangles that are not culled.
    fn counts(&self) -> [u64; 2] {
        let clip: Vec<Clip> = match &self.points {
            Points::Clip(vertices) => vertices.clone(),
            Points::Model(matrix, positions) => {
                let mut clip = vec![[0.0; 4]; positions.len()];
                transform(matrix, positions, &mut clip);
                clip
            }
        };
        let [width, height] = self.size;
        let mut color = vec![0_u32; width as usize * height as usize];
        let count = |_: &Fragment<'_>, pixel: &mut u32| {
            *pixel += 1;
            true
        };
        let mut target = Target::new(&mut color, Depth::None, width, height, width as usize)
            .expect("the size is in range");
        let state = State { test: DepthTest::Off, write: false, ..self.state() };
        let stats = target.triangles(&state, &clip, &self.triangles, &count);
        [color.iter().map(|&pixel| u64::from(pixel)).sum(), stats.drawn]
    }

    /// What is drawn, for the CSV file.
    fn workload(&self, [pixels, triangles]: [u64; 2]) -> String {
        let ([width, height], submitted) = (self.size, self.triangles.len());
        let shape = self.shape;
        format!(
            "shape={shape} triangles={triangles} submitted={submitted} pixels={pixels} size={width}x{height}"
        )
    }

    /// What is written of it: the time of a frame, and its share for each triangle or pixel, by way, timing and
    /// number of wrong pixels.
    pub(crate) fn rows<'a>(&self, measured: impl IntoIterator<Item = (&'a str, Timing, usize)>) -> Vec<Row> {
        let counts @ [pixels, triangles] = self.counts();
        let (unit, count) =
            if self.chart == TRIANGLES { ("ns/triangle", triangles) } else { ("ns/pixel", pixels) };
        let mut rows = Vec::new();
        for (method, timing, different) in measured {
            let row = |time_unit: &str, share: f64| Row {
                chart: self.chart.to_owned(),
                method: method.to_owned(),
                workload: self.workload(counts),
                time_unit: time_unit.to_owned(),
                time: timing.median * share,
                error_metric: "pixels that differ from the immediate picture".to_owned(),
                error: different as f64,
                spread: timing.spread * share,
            };
            rows.push(row("ms/frame", 1e-6));
            if count > 0 {
                rows.push(row(unit, 1.0 / count as f64));
            }
        }
        rows
    }
}

/// A place on the screen in clip space with w = 1, so that snapping brings it back exactly.
fn on_screen([width, height]: [u32; 2], [x, y]: [f32; 2], depth: f32) -> Clip {
    [2.0 * x / width as f32 - 1.0, 1.0 - 2.0 * y / height as f32, depth, 1.0]
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_sheet_covers_the_same_pixels() {
        let expected = Job::sheet(0).counts();
        assert_eq!(expected[1], 1);
        for n in 1..8 {
            assert_eq!(Job::sheet(n).counts(), [expected[0], 1 << (2 * n)], "{n} times halved");
        }
    }

    #[test]
    fn pairs_cover_their_rectangle_and_balls_show_half_of_themselves() {
        for side in [1, 2, 64, 513, 1080] {
            assert_eq!(Job::pair("pair", SIZE, [side, side]).counts(), [u64::from(side * side), 2]);
        }
        assert_eq!(Job::pair("whole", [320, 240], [320, 240]).counts(), [320 * 240, 2]);
        let ball = Job::ball(19_200);
        let [pixels, seen] = ball.counts();
        assert!((9_000..11_000).contains(&seen) && pixels > 400_000, "{seen} triangles, {pixels} px");
    }

    #[test]
    fn every_way_draws_the_same() {
        let mut ways = Way::all();
        for job in Job::all(Effort::Quick) {
            let zeros = vec![0; WAYS];
            assert_eq!(job.check(&mut ways, &mut Picture::new(job.size)), Ok(zeros));
        }
    }
}
