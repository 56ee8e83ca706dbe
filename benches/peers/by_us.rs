//! polosa: soups by the raster core, lit meshes by the scene's renderer.

use polosa_raster::{Cull, DepthTest};
use polosa_scene::{Light, Mesh, Object, Renderer, Style, World};

use crate::contestant::{Contestant, time};
use crate::job::{Job, Lit, Vertices};
use polosa_benches::ours::{Path, Picture};

/// Everything of ours that can draw a job.
pub(crate) fn all<'a>(job: &'a Job, threads: &[usize]) -> Vec<Box<dyn Contestant + 'a>> {
    let mut all: Vec<Box<dyn Contestant + 'a>> = vec![Box::new(Floor(Picture::new(job.size)))];
    for &threads in threads {
        match &job.lit {
            Some(lit) => all.push(Box::new(Whole::new(job, lit, threads))),
            None => all.extend(
                Path::all(threads)
                    .into_iter()
                    .map(|path| Box::new(Core::new(job, path)) as Box<dyn Contestant + 'a>),
            ),
        }
    }
    all
}

/// Nothing but clearing colour and depth: what every frame writes at least.
struct Floor(Picture);

impl Contestant for Floor {
    fn name(&self) -> String {
        "clearing alone".to_owned()
    }

    fn threads(&self) -> usize {
        1
    }

    fn draws(&self) -> bool {
        false
    }

    fn frames(&mut self, count: u32) -> Result<Vec<u64>, String> {
        Ok(time(count, || self.0.target().clear(0, DepthTest::Greater)))
    }

    fn picture(&mut self) -> Result<Vec<u32>, String> {
        Ok(self.0.color.clone())
    }
}

/// The raster core.
struct Core<'a> {
    job: &'a Job,
    path: Path,
    picture: Picture,
}

impl<'a> Core<'a> {
    fn new(job: &'a Job, path: Path) -> Self {
        Self { job, path, picture: Picture::new(job.size) }
    }
}

impl Contestant for Core<'_> {
    fn name(&self) -> String {
        format!("polosa {}", self.path.name())
    }

    fn threads(&self) -> usize {
        self.path.threads()
    }

    fn frames(&mut self, count: u32) -> Result<Vec<u64>, String> {
        let Self { job, path, picture } = self;
        let vertices = match &job.vertices {
            Vertices::Clip(vertices) => polosa_raster::Vertices::Clip(vertices),
            Vertices::Model { positions, matrix } => polosa_raster::Vertices::Model { matrix, positions },
        };
        Ok(time(count, || {
            path.draw(picture, vertices, &job.indices, &Job::number);
        }))
    }

    fn picture(&mut self) -> Result<Vec<u32>, String> {
        Ok(self.picture.color.clone())
    }
}

/// The scene's renderer: transform, cull, light, fill.
struct Whole<'a> {
    lit: &'a Lit,
    world: World,
    renderer: Renderer,
    style: Style,
    picture: Picture,
}

impl<'a> Whole<'a> {
    fn new(job: &'a Job, lit: &'a Lit, threads: usize) -> Self {
        let Vertices::Model { positions, .. } = &job.vertices else { unreachable!("lit jobs are meshes") };
        let mut world = World::new();
        let mesh =
            Mesh::new(positions.clone(), job.indices.clone()).expect("the mesh's indices are in range");
        let mesh = world.add_mesh(mesh);
        world.add(Object::new(mesh)).expect("the mesh is there");
        let style = Style { cull: Cull::Back, color: lit.color, ..Style::default() };
        let renderer = Renderer::with_threads(threads);
        Self { lit, world, renderer, style, picture: Picture::new(job.size) }
    }
}

impl Contestant for Whole<'_> {
    fn name(&self) -> String {
        match self.renderer.threads() {
            1 => "polosa scene".to_owned(),
            threads => format!("polosa scene, {threads} threads"),
        }
    }

    fn threads(&self) -> usize {
        self.renderer.threads()
    }

    fn frames(&mut self, count: u32) -> Result<Vec<u64>, String> {
        let light = Light { ambient: self.lit.ambient, ..Light::default() };
        let Self { lit, world, renderer, style, picture } = self;
        Ok(time(count, || {
            let drawn = renderer.frame(world, &lit.camera, &light, style, None, &mut picture.target());
            drawn.expect("a frame fits a target of its size");
        }))
    }

    fn picture(&mut self) -> Result<Vec<u32>, String> {
        Ok(self.picture.color.clone())
    }
}
