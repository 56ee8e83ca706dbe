//! polosa's own methods as rasterisers, and the table of what becomes of each in every scene.
//!
//! The chart of stability (`benches/charts/stability.rs`) is drawn by this file, too.

use std::thread;

use polosa_raster::reference::{Coverage, Hidden, Methods, ZBuffer, draw};
use polosa_raster::{Depth, Frame, Level, PerTriangle, State, StoredDepth, Target, Triangles, Vertices};
use polosa_stability::{Abilities, Drawn, Job, Rasteriser, Report, Table, run};

/// Triangle by triangle.
struct Immediate;

impl Rasteriser for Immediate {
    fn draw(&mut self, job: &Job<'_>) -> Drawn {
        let (mut ids, mut depth) = (vec![0; job.pixels()], vec![0.0; job.pixels()]);
        let width = job.width as usize;
        let mut target = Target::new(&mut ids, Depth::F32(&mut depth), job.width, job.height, width).unwrap();
        target.triangles(
            &State::default(),
            job.vertices,
            job.triangles,
            &PerTriangle(|k: usize| k as u32 + 1),
        );
        Drawn { ids, depth: Some(depth) }
    }
}

/// Whole frames in tiles.
struct Frames(Frame);

impl Rasteriser for Frames {
    fn draw(&mut self, job: &Job<'_>) -> Drawn {
        let (mut ids, mut depth) = (vec![0; job.pixels()], vec![0.0; job.pixels()]);
        let frame = &mut self.0;
        frame.begin([job.width, job.height], 0, StoredDepth::F32(0.0)).unwrap();
        let (vertices, triangles) = (Vertices::Clip(job.vertices), Triangles::Indexed(job.triangles));
        frame.draw(&State::default(), 0, vertices, triangles, |k| k as u32 + 1);
        let mut target =
            Target::new(&mut ids, Depth::F32(&mut depth), job.width, job.height, job.width as usize).unwrap();
        frame.finish(&mut target).unwrap();
        Drawn { ids, depth: Some(depth) }
    }
}

/// A pair of methods of the reference module; the columns of the table that are about coverage are asked for that.
struct Reference {
    methods: Methods,
    abilities: Abilities,
    depth: ZBuffer,
}

impl Reference {
    fn new(coverage: Coverage, hidden: Hidden, hides: bool) -> Self {
        let abilities = Abilities { hides, ..Abilities::default() };
        Self { methods: Methods { coverage, hidden }, abilities, depth: ZBuffer::new() }
    }
}

impl Rasteriser for Reference {
    fn draw(&mut self, job: &Job<'_>) -> Drawn {
        let mut ids = vec![0; job.pixels()];
        let mut target =
            Target::new(&mut ids, Depth::None, job.width, job.height, job.width as usize).unwrap();
        let state = State::default();
        draw(&mut target, &mut self.depth, self.methods, &state, job.vertices, job.triangles, |k| k + 1);
        let at = |k: usize| self.depth.at(k as u32 % job.width, k as u32 / job.width).unwrap_or(0.0) as f32;
        let has_depth = self.abilities.hides && self.methods.hidden.has_buffer();
        let depth = || (0..).zip(&ids).map(|(k, &id)| if id == 0 { 0.0 } else { at(k) }).collect();
        let depth = has_depth.then(depth);
        Drawn { ids, depth }
    }

    fn abilities(&self) -> Abilities {
        self.abilities
    }
}

/// The verdicts on all methods, by name, in the order of the table.
pub(crate) fn table() -> Table {
    let mut methods: Vec<(String, Box<dyn Rasteriser + Send>)> = vec![
        ("immediate".to_owned(), Box::new(Immediate)),
        ("frame".to_owned(), Box::new(Frames(Frame::with(Level::detect(), 1)))),
    ];
    // Coverage is judged without depth, hidden surfaces over exact coverage.
    for &coverage in Coverage::ALL {
        let method = Reference::new(coverage, Hidden::Order, false);
        methods.push((format!("fill {coverage}"), Box::new(method)));
    }
    for &hidden in Hidden::ALL {
        let method = Reference::new(Coverage::Strips, hidden, true);
        methods.push((format!("hidden {hidden}"), Box::new(method)));
    }
    let (names, methods): (Vec<_>, Vec<_>) = methods.into_iter().unzip();
    let reports: Vec<Report> = thread::scope(|scope| {
        let running: Vec<_> =
            methods.into_iter().map(|mut method| scope.spawn(move || run(method.as_mut()))).collect();
        running.into_iter().map(|thread| thread.join().unwrap()).collect()
    });
    let mut table = Table::new();
    for (name, report) in names.iter().zip(&reports) {
        table.add(name, report);
    }
    table
}
