//! Which models make which picture, and where it goes: settled before anything is read.

use std::collections::HashSet;
use std::io::IsTerminal as _;
use std::path::{Path, PathBuf};

use super::args::{ModelArg, OutputArg, STEM};
use super::render_args::RenderArgs;
use crate::encode::ImageFormat;
use crate::error::Error;
pub(super) use crate::output::is_special;
use crate::output::{Destination, followed};

/// One picture to make.
#[derive(Debug)]
pub(super) struct Job<'a> {
    /// Of what.
    pub(super) models: &'a [ModelArg],
    /// The picture.
    pub(super) picture: (Destination, ImageFormat),
    /// The distances.
    pub(super) depth: Option<Destination>,
    /// The numbers of the triangles.
    pub(super) ids: Option<(Destination, ImageFormat)>,
}

impl Job<'_> {
    /// All that is written.
    pub(super) fn destinations(&self) -> impl Iterator<Item = &Destination> {
        [Some(&self.picture.0), self.depth.as_ref(), self.ids.as_ref().map(|(to, _)| to)]
            .into_iter()
            .flatten()
    }
}

/// The pictures that the options ask for.
///
/// Refuses what cannot end well: an extension without a format, one standard output for two pictures, two
/// pictures of one name, of which the second would replace the first.
pub(super) fn jobs<'a>(args: &'a RenderArgs, transparent: bool) -> Result<Vec<Job<'a>>, Error> {
    let outputs = Outputs::new(args, transparent)?;
    let chunk = if args.output.has_stem() { 1 } else { args.models.len().max(1) };
    let jobs: Vec<Job<'a>> = args.models.chunks(chunk).map(|models| outputs.job(models)).collect();

    ModelArg::check_stdin(&args.models)?;
    let mut taken = HashSet::new();
    for destination in jobs.iter().flat_map(Job::destinations) {
        if !taken.insert(identity(destination)) && !is_bottomless(destination) {
            return usage(format!(
                "{} would be written twice: rename one of the models, or render them one by one",
                crate::error::one_line(&destination.name().to_string_lossy())
            ));
        }
    }
    Ok(jobs)
}

fn usage<T>(message: String) -> Result<T, Error> {
    Err(Error::Usage(message))
}

/// The options' outputs, checked.
struct Outputs<'a> {
    picture: (&'a OutputArg, ImageFormat),
    depth: Option<&'a OutputArg>,
    ids: Option<(&'a OutputArg, ImageFormat)>,
}

impl<'a> Outputs<'a> {
    fn new(args: &'a RenderArgs, transparent: bool) -> Result<Self, Error> {
        let picture = (&args.output, format("--output", &args.output)?);
        if transparent && !picture.1.has_alpha() {
            return usage(format!(
                "--background none: {} keeps no transparency: use .png, .bmp, .tga or .qoi",
                shown(&args.output)
            ));
        }
        let depth = args.depth_image.as_ref();
        if let Some(depth) = depth
            && !depth.is_stdout()
            && !depth.path().extension().is_some_and(|extension| extension.eq_ignore_ascii_case("pfm"))
            && !is_special(depth.path())
        {
            return usage(format!("--depth-image {}: distances are written as PFM: use .pfm", shown(depth)));
        }
        let ids = match &args.id_image {
            Some(ids) => Some((ids, format("--id-image", ids)?)),
            None => None,
        };
        if let Some((ids, format)) = ids
            && !format.is_lossless()
        {
            return usage(format!("--id-image {}: JPEG changes the numbers: use .png", shown(ids)));
        }
        let outputs = Self { picture, depth, ids };
        outputs.check(args)?;
        Ok(outputs)
    }

    /// What the outputs are to each other and to the models.
    fn check(&self, args: &RenderArgs) -> Result<(), Error> {
        let others = || [self.depth, self.ids.map(|(ids, _)| ids)].into_iter().flatten();
        if [self.picture.0].into_iter().chain(others()).filter(|output| output.is_stdout()).count() > 1 {
            return usage("only one picture can go to standard output: name a file for the other".to_owned());
        }
        let to_stdout = self.picture.0.is_stdout() || others().any(OutputArg::is_stdout);
        if to_stdout && std::io::stdout().is_terminal() {
            return usage("standard output is a terminal: name a file, or let a program read it".to_owned());
        }
        if args.models.len() > 1 {
            for other in others() {
                if other.has_stem() != self.picture.0.has_stem() {
                    return usage(format!(
                        "{} and {}: {STEM} must be in both, for a picture a model, or in neither, for one of all",
                        shown(self.picture.0),
                        shown(other)
                    ));
                }
            }
        }
        Ok(())
    }

    fn job<'m>(&self, models: &'m [ModelArg]) -> Job<'m> {
        let stem = models.first().map(ModelArg::stem).unwrap_or_default();
        Job {
            models,
            picture: (self.picture.0.with_stem(&stem), self.picture.1),
            depth: self.depth.map(|depth| depth.with_stem(&stem)),
            ids: self.ids.map(|(ids, format)| (ids.with_stem(&stem), format)),
        }
    }
}

fn shown(output: &OutputArg) -> String {
    crate::error::one_line(&output.path().to_string_lossy())
}

/// The format of an output. What has no extension to go by (standard output, a device, a pipe) gets PNG.
pub(super) fn format(option: &str, output: &OutputArg) -> Result<ImageFormat, Error> {
    if output.is_stdout() {
        return Ok(ImageFormat::Png);
    }
    let by_name = ImageFormat::from_path(output.path());
    match by_name {
        Err(_) if is_special(output.path()) => Ok(ImageFormat::Png),
        Err(error) => usage(format!("{option} {}: {error}", shown(output))),
        Ok(format) => Ok(format),
    }
}

/// Whether any number of pictures can be written there.
fn is_bottomless(destination: &Destination) -> bool {
    matches!(destination, Destination::File(path) if is_special(path))
}

/// The same for two names of one file.
pub(super) fn identity(destination: &Destination) -> PathBuf {
    match destination {
        Destination::Stdout => PathBuf::from("-"),
        Destination::File(path) => {
            let path = &followed(path).unwrap_or_else(|_| path.clone());
            let folder =
                path.parent().filter(|folder| !folder.as_os_str().is_empty()).unwrap_or(Path::new("."));
            let folder = folder.canonicalize().unwrap_or_else(|_| folder.to_owned());
            path.canonicalize().unwrap_or_else(|_| folder.join(path.file_name().unwrap_or_default()))
        }
    }
}
