//! `polosa render`: models become pictures.

use std::process::ExitCode;
use std::time::{Duration, Instant};

use polosa_math::Bounds;
use polosa_math::glam::DVec3;
use polosa_raster::MAX_SIDE;
use polosa_scene::{
    Camera, DrawStats, Light, LightSpace, Mesh, Object, Picture, PictureSettings, Renderer, Show, Style,
    World,
};

use super::args::{Background, ModelArg};
use super::job::{Job, jobs};
use super::load::Source;
use super::progress::Progress;
use super::render_args::RenderArgs;
use super::{complain, report, tell, unseen};
use crate::encode;
use crate::error::{Error, one_line};
use crate::guard::caught;
use crate::output::Destination;
use crate::pfm;
use crate::view::{Lens, Up, View};

/// The largest number that a 24-bit colour holds.
const MOST_IDS: u64 = (1 << 24) - 1;

/// Makes every picture that the options ask for. A failure does not stop those that follow.
pub(super) fn run(args: &RenderArgs) -> Result<ExitCode, Error> {
    check(args)?;
    let settings = settings(args)?;
    let jobs = jobs(args, settings.background.is_none())?;

    // A step for each model that is read, and two for drawing and writing a picture.
    let progress = Progress::new((args.models.len() + 2 * jobs.len()) as u64);
    let to_stderr = jobs.iter().flat_map(Job::destinations).any(|to| *to == Destination::Stdout);
    let mut renderer = Renderer::new();
    let mut status = ExitCode::SUCCESS;
    for job in &jobs {
        let made = caught(job.picture.0.name(), || make(job, args, &settings, &mut renderer, &progress));
        progress.aside(|| match made {
            Ok(made) if args.json => tell(&report::json(&made), to_stderr),
            Ok(made) if args.stats => tell(&report::text(&made), to_stderr),
            Ok(_) => {}
            Err(error) => {
                complain(&error);
                status = ExitCode::from(error.exit_status());
            }
        });
    }
    Ok(status)
}

/// A picture that was made, as reports tell about it.
#[derive(Debug)]
pub(super) struct Made<'a> {
    pub(super) job: &'a Job<'a>,
    pub(super) settings: &'a PictureSettings,
    pub(super) models: Vec<ModelFacts>,
    pub(super) bounds: Bounds,
    pub(super) camera: Camera,
    /// In degrees, as it was given.
    pub(super) view_angle: f64,
    pub(super) stats: DrawStats,
    /// What is missing from the picture that should be in it.
    pub(super) notes: Vec<String>,
    pub(super) read: Duration,
    pub(super) draw: Duration,
    pub(super) write: Duration,
}

/// What is told about a model after its meshes have gone into the world.
#[derive(Debug)]
pub(super) struct ModelFacts {
    pub(super) name: String,
    pub(super) kind: &'static str,
    pub(super) parts: usize,
    pub(super) vertices: u64,
    pub(super) triangles: u64,
    pub(super) remarks: Vec<String>,
}

/// Refuses options that contradict each other where clap does not.
fn check(args: &RenderArgs) -> Result<(), Error> {
    if args.camera_position.is_some() && args.camera_focal_point.is_some() && args.camera_direction.is_some()
    {
        return Err(Error::Usage(
            "--camera-position, --camera-focal-point and --camera-direction say twice where to look: leave one out"
                .to_owned(),
        ));
    }
    if args.camera_position.is_some() && args.camera_position == args.camera_focal_point {
        return Err(Error::Usage(
            "--camera-position and --camera-focal-point are one point, from which no direction follows: move one of \
             them"
                .to_owned(),
        ));
    }
    Ok(())
}

fn settings(args: &RenderArgs) -> Result<PictureSettings, Error> {
    let side = |side: u64| u32::try_from(side).ok().filter(|side| (1..=MAX_SIDE).contains(side));
    let (Some(width), Some(height)) = (side(args.resolution.width), side(args.resolution.height)) else {
        return Err(Error::file(
            args.output.path(),
            format!(
                "--resolution {},{} is no possible picture: each side must have 1 to {MAX_SIDE} pixels",
                args.resolution.width, args.resolution.height
            ),
        ));
    };
    Ok(PictureSettings {
        width,
        height,
        background: match args.background {
            Background::Nothing => None,
            Background::Color(color) => Some(color),
        },
        samples: args.samples,
        distances: args.depth_image.is_some(),
        ids: args.id_image.is_some(),
    })
}

fn make<'a>(
    job: &'a Job<'a>,
    args: &RenderArgs,
    settings: &'a PictureSettings,
    renderer: &mut Renderer,
    progress: &Progress,
) -> Result<Made<'a>, Error> {
    job.destinations().try_for_each(Destination::check)?;

    let start = Instant::now();
    let (world, models, up) = load(job.models, args, progress)?;
    let triangles: u64 = models.iter().map(|model| model.triangles).sum();
    if settings.ids && triangles > MOST_IDS {
        let name = job.ids.as_ref().map_or(job.picture.0.name(), |(to, _)| to.name());
        return Err(Error::file(
            name,
            format!(
                "{triangles} triangles are more than the {MOST_IDS} that 24 bits can number: simplify the models"
            ),
        ));
    }
    let loaded = Instant::now();

    let name = job.picture.0.name();
    reserve(settings).map_err(|bytes| {
        Error::file(
            name,
            format!("needs {} MiB of memory, which are not free: lower --resolution", bytes >> 20),
        )
    })?;
    progress.now(&format!("drawing {}", name.display()));
    let bounds = world.bounds();
    let aspect = f64::from(settings.width) / f64::from(settings.height);
    let camera = view(args, up)
        .camera(points(&world), &bounds, aspect)
        .map_err(|error| Error::file(name, error.to_string()))?;
    let picture = Picture::render(renderer, &world, &camera, &light(args), &style(args), settings)
        .map_err(|error| Error::file(name, error.to_string()))?;
    progress.step();
    let notes: Vec<String> = unseen::note(args, settings, &world, &camera, &picture).into_iter().collect();
    if !args.json {
        progress.aside(|| notes.iter().for_each(|text| note(&one_line(&name.to_string_lossy()), text)));
    }
    let drawn = Instant::now();

    progress.now(&format!("writing {}", name.display()));
    write(job, &picture)?;
    progress.step();

    Ok(Made {
        job,
        settings,
        models,
        bounds,
        camera,
        view_angle: args.camera_view_angle,
        stats: picture.stats,
        notes,
        read: loaded - start,
        draw: drawn - loaded,
        write: drawn.elapsed(),
    })
}

/// Asks whether there is memory for a picture, since running out of it on the way would end the program without a
/// word. The bytes that are needed, if there is not.
fn reserve(settings: &PictureSettings) -> Result<(), usize> {
    let layers = 4
        + usize::from(settings.background.is_none())
        + 4 * usize::from(settings.distances)
        + 4 * usize::from(settings.ids);
    // No more than 2²⁸ pixels: `settings` has seen to that. What drawing needs beside is a band of rows.
    let bytes = layers * settings.width as usize * settings.height as usize;
    Vec::<u8>::new().try_reserve_exact(bytes).map_err(|_| bytes)
}

/// All models in one world, in the order of the command line.
fn load(
    models: &[ModelArg],
    args: &RenderArgs,
    progress: &Progress,
) -> Result<(World, Vec<ModelFacts>, Up), Error> {
    let show = if args.wire {
        Show::Wire
    } else if args.edges {
        Show::Both
    } else {
        Show::Surface
    };
    let mut world = World::new();
    let mut facts = Vec::new();
    let mut ups = Vec::new();
    for model in models {
        let name = one_line(&model.name().to_string_lossy());
        progress.now(&format!("reading {name}"));
        let source = Source::open(model)?;
        ups.push(source.up());
        let fact = ModelFacts {
            kind: source.kind(),
            parts: source.parts.len(),
            vertices: source.vertices(),
            triangles: source.triangles(),
            remarks: source.remarks(),
            name,
        };
        if !args.json {
            progress.aside(|| warn(&fact, &source));
        }
        facts.push(fact);
        for part in source.parts {
            let mesh = world.add_mesh(part.mesh);
            let mut object = Object::new(mesh).placed(part.placement).shown(show);
            object.color = part.color;
            world.add(object).map_err(|error| Error::file(model.name(), error.to_string()))?;
        }
        progress.step();
    }
    // Together only when all agree: a mixture keeps its own coordinates, with +Y upward.
    let agreed = ups.first().copied().filter(|first| ups.iter().all(|up| up == first));
    Ok((world, facts, args.up.or(agreed).unwrap_or(Up::PlusY)))
}

/// Says what of a model the picture does not show.
fn warn(fact: &ModelFacts, source: &Source) {
    source.notes.iter().for_each(|text| note(&fact.name, text));
}

/// A line about a file that is no failure.
fn note(name: &str, text: &str) {
    tell(&format!("polosa: {name}: note: {}\n", one_line(text)), true);
}

/// Every vertex of every object.
pub(super) fn points(world: &World) -> impl Iterator<Item = DVec3> {
    world.objects().flat_map(|(_, object)| {
        let matrix = object.placement.matrix();
        let positions = world.mesh(object.mesh()).map(Mesh::positions).unwrap_or_default();
        positions.iter().map(move |position| matrix.transform_point3(position.map(f64::from).into()))
    })
}

fn view(args: &RenderArgs, up: Up) -> View {
    let lens = match (args.camera_orthographic, args.camera_height) {
        (false, _) => Lens::Perspective(args.camera_view_angle),
        (true, None) => Lens::Parallel,
        (true, Some(height)) => Lens::ParallelTo(height),
    };
    View {
        position: args.camera_position,
        focal_point: args.camera_focal_point,
        direction: args.camera_direction,
        view_up: args.camera_view_up,
        // A drawing to scale shows x and y, whatever the file's own upward axis is, unless told otherwise.
        up: if args.camera_height.is_some() { args.up.unwrap_or(Up::PlusY) } else { up },
        azimuth: args.camera_azimuth_angle,
        elevation: args.camera_elevation_angle,
        lens,
    }
}

fn light(args: &RenderArgs) -> Light {
    Light {
        direction: args.light.unwrap_or(Light::default().direction),
        space: if args.light_world { LightSpace::World } else { LightSpace::Camera },
        ambient: args.ambient,
    }
}

fn style(args: &RenderArgs) -> Style {
    Style { shading: args.shading.into(), cull: args.cull.into(), color: args.color, ..Style::default() }
}

/// Writes the picture and what belongs to it; each gets its name only when all are complete.
fn write(job: &Job<'_>, picture: &Picture) -> Result<(), Error> {
    let mut outputs = Vec::new();
    let (to, format) = &job.picture;
    let mut output = to.create()?;
    output.fill(|out| encode::write_picture(out, *format, picture))?;
    outputs.push(output);
    if let (Some(to), Some(distances)) = (&job.depth, &picture.distances) {
        let mut output = to.create()?;
        output.fill(|out| pfm::write(out, picture.width, picture.height, distances))?;
        outputs.push(output);
    }
    if let (Some((to, format)), Some(ids)) = (&job.ids, &picture.ids) {
        let mut output = to.create()?;
        output.fill(|out| encode::write_ids(out, *format, picture.width, picture.height, ids))?;
        outputs.push(output);
    }
    outputs.into_iter().try_for_each(|output| output.commit())
}
