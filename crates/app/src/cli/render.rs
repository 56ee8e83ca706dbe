//! `polosa render`: models become pictures.

use std::process::ExitCode;
use std::time::{Duration, Instant};

use polosa_math::Bounds;
use polosa_scene::reference::Methods;
use polosa_scene::{Camera, Colors, DrawStats, Picture, PictureSettings, Renderer, World};

use super::job::{Job, jobs};
use super::models::{self, ModelFacts};
use super::progress::Progress;
use super::render_args::RenderArgs;
use super::{complain, report, tell, unseen};
use crate::encode;
use crate::error::{Error, one_line};
use crate::guard::caught;
use crate::output::Destination;
use crate::pfm;

/// The largest number that a 24-bit colour holds.
const MOST_IDS: u64 = (1 << 24) - 1;

/// Makes every picture that the options ask for. A failure does not stop those that follow.
pub(super) fn run(args: &RenderArgs) -> Result<ExitCode, Error> {
    args.view.check()?;
    let settings = PictureSettings {
        distances: args.depth_image.is_some(),
        ids: args.id_image.is_some(),
        ..args.view.settings(args.output.path())?
    };
    let jobs = jobs(args, settings.background.is_none())?;
    if args.methods().is_some() && settings.background.is_none() {
        return Err(Error::Usage(
            "--background none: pictures by --fill, --hidden or --shade have no transparency: name a colour"
                .to_owned(),
        ));
    }

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
    /// What it was drawn by.
    pub(super) methods: Methods,
    pub(super) stats: DrawStats,
    /// What is missing from the picture that should be in it.
    pub(super) notes: Vec<String>,
    pub(super) read: Duration,
    pub(super) draw: Duration,
    pub(super) write: Duration,
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
    let (world, models, up) = models::load(job.models, &args.view, args.json, progress)?;
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
    // What drawing needs beside the picture is a band of rows.
    let layers = [settings.background.is_none(), settings.distances, settings.ids].map(usize::from);
    let mut pixel = 4 + layers[0] + 4 * layers[1] + 4 * layers[2];
    let mut triangle = 0;
    if let Some(methods) = args.methods() {
        // All triangles of all models at once, in clip space; the painter's are sorted, too.
        triangle = if methods.hidden.has_buffer() { 64 } else { 64 + 96 };
        pixel += if methods.hidden.has_buffer() { 8 } else { 0 };
    }
    models::reserve(settings, pixel, triangles.saturating_mul(triangle), name)?;
    progress.now(&format!("drawing {}", name.display()));
    let bounds = world.bounds();
    let camera = models::camera(&world, &args.view, up, settings, name)?;
    let (light, style) = (args.view.light(), args.view.style());
    let picture = match (args.methods(), settings.background) {
        (Some(methods), Some(background)) => {
            let size = [settings.width, settings.height];
            methods.picture(&world, &camera, &light, &style, size, background)
        }
        _ => Picture::render(renderer, &world, &camera, &light, &style, settings),
    };
    let picture = picture.map_err(|error| Error::file(name, error.to_string()))?;
    progress.step();
    let mut notes: Vec<String> =
        unseen::note(&args.view, settings, &world, &camera, &picture).into_iter().collect();
    if args.methods().is_some() && has_vertex_colors(&world) {
        notes.push(
            "colours run between vertices: by --fill, --hidden or --shade each face has their mean"
                .to_owned(),
        );
    }
    if !args.json {
        progress
            .aside(|| notes.iter().for_each(|text| models::note(&one_line(&name.to_string_lossy()), text)));
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
        view_angle: args.view.camera_view_angle,
        methods: args.methods().unwrap_or_default(),
        stats: picture.stats,
        notes,
        read: loaded - start,
        draw: drawn - loaded,
        write: drawn.elapsed(),
    })
}

/// Whether a colour runs over the faces of something that is drawn.
fn has_vertex_colors(world: &World) -> bool {
    world.objects().any(|(_, object)| {
        let mesh = world.mesh(object.mesh()).filter(|_| object.color.is_none() && object.visible);
        mesh.is_some_and(|mesh| matches!(mesh.colors(), Colors::Vertex(_)))
    })
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
