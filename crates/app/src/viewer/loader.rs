//! Models are read beside the window, which goes on showing what it has.

use core::num::NonZeroUsize;
use std::sync::mpsc::{self, Receiver, TryRecvError};
use std::sync::{Arc, Mutex, PoisonError};
use std::thread;
use std::time::Instant;

use polosa_raster::{Depth, Target};
use polosa_scene::{Camera, Light, Renderer, Show, Style, World};

use crate::application::{Waker, new_renderer};
use crate::demo;
use crate::error::{Error, one_line};
use crate::model::{Model, Source, common_up, points};
use crate::view::{Up, View};

/// What was read.
#[derive(Debug)]
pub(super) struct Loaded {
    pub(super) world: World,
    /// The axis that the models have upward.
    pub(super) up: Up,
    /// What the user should know, one line each.
    pub(super) notes: Vec<String>,
    /// How the built-in scene is looked at.
    pub(super) look: Option<(Camera, Light)>,
    /// The camera for the window that the load was begun for, if there can be one, and that window's aspect.
    pub(super) framed: Option<(Camera, f64)>,
    /// One that has drawn the models already, if they are large: the first picture, for which all memory is new, takes
    /// twice as long as any other.
    pub(super) warm: Option<Renderer>,
}

/// Models of fewer triangles are drawn at once, however cold the memory is.
const LARGE: usize = 100_000;

/// What the models are to be seen through: to look at every vertex takes milliseconds, which a window does not have.
#[derive(Clone, Copy, Debug)]
pub(super) struct Aim {
    /// From where. Its upward axis is that of the models unless `up` has one.
    pub(super) view: View,
    pub(super) up: Option<Up>,
    /// Width and height of the window.
    pub(super) size: [u32; 2],
    /// How many threads draw.
    pub(super) threads: Option<NonZeroUsize>,
    /// Whether a window waits for the first picture, which is then to be drawn beside it, too.
    pub(super) warms: bool,
}

impl Aim {
    /// Width / height.
    pub(super) fn aspect(&self) -> f64 {
        f64::from(self.size[0]) / f64::from(self.size[1])
    }

    /// A renderer that has drawn the world once, if it is large.
    fn warm(&self, world: &World, camera: &Camera) -> Option<Renderer> {
        let triangles = world.meshes().map(|(_, mesh)| mesh.triangles().len());
        if !self.warms || triangles.sum::<usize>() < LARGE {
            return None;
        }
        let mut renderer = new_renderer(self.threads);
        let [width, height] = self.size;
        let mut pixels = Vec::new();
        let count = width as usize * height as usize;
        pixels.try_reserve_exact(count).ok()?;
        pixels.resize(count, 0);
        let mut target = Target::new(&mut pixels, Depth::None, width, height, width as usize).ok()?;
        renderer.frame(world, camera, &Light::default(), &Style::default(), None, &mut target).ok()?;
        Some(renderer)
    }
}

/// Reads models, one load at a time.
#[derive(Debug, Default)]
pub(super) struct Loader {
    running: Option<Running>,
    /// What is read next, whatever becomes of what is being read: the last that was asked for.
    next: Option<(Vec<Model>, Show, Aim, Waker)>,
}

#[derive(Debug)]
struct Running {
    result: Receiver<Result<Loaded, Error>>,
    stage: Arc<Mutex<String>>,
    since: Instant,
}

impl Loader {
    /// Begins to read; without a model, makes the built-in scene. What is being read already is read to its end, and
    /// then forgotten.
    pub(super) fn start(&mut self, models: Vec<Model>, show: Show, aim: Aim, waker: Waker) {
        if self.running.is_some() {
            self.next = Some((models, show, aim, waker));
            return;
        }
        let (sender, result) = mpsc::channel();
        let stage = Arc::new(Mutex::new(String::new()));
        let told = Arc::clone(&stage);
        let now = move |what: String| *told.lock().unwrap_or_else(PoisonError::into_inner) = what;
        let work = move || {
            // Nobody waits for it any more where another load was begun.
            let _ = sender.send(load(&models, show, aim, &now));
            waker.wake();
        };
        if let Err(error) = thread::Builder::new().name("load".to_owned()).spawn(work) {
            let (sender, failed) = mpsc::channel();
            let what = format!("no thread can be started to read it: {error}: end other programs");
            let _ = sender.send(Err(Error::file("the models", what)));
            self.running = Some(Running { result: failed, stage, since: Instant::now() });
            return;
        }
        self.running = Some(Running { result, stage, since: Instant::now() });
    }

    /// What was read, once it is.
    pub(super) fn poll(&mut self) -> Option<Result<Loaded, Error>> {
        match self.running.as_ref()?.result.try_recv() {
            Err(TryRecvError::Empty) => None,
            Err(TryRecvError::Disconnected) => {
                self.running = None;
                Some(Err(broken_off()))
            }
            Ok(result) => {
                self.running = None;
                let Some((models, show, aim, waker)) = self.next.take() else { return Some(result) };
                self.start(models, show, aim, waker);
                None
            }
        }
    }

    /// Waits until it is read.
    pub(super) fn wait(&mut self) -> Option<Result<Loaded, Error>> {
        let result = self.running.take()?.result.recv().ok();
        let Some((models, show, aim, waker)) = self.next.take() else { return result };
        self.start(models, show, aim, waker);
        self.wait()
    }

    pub(super) const fn is_running(&self) -> bool {
        self.running.is_some()
    }

    /// What is being done, and for how many seconds the load goes on.
    pub(super) fn stage(&self) -> Option<(String, f64)> {
        let running = self.running.as_ref()?;
        let stage = running.stage.lock().unwrap_or_else(PoisonError::into_inner).clone();
        Some((stage, running.since.elapsed().as_secs_f64()))
    }
}

/// That nobody will ever say what has been read.
pub(super) fn broken_off() -> Error {
    Error::file("the models", "the reading was broken off by a defect of the program: please report it")
}

fn load(models: &[Model], show: Show, aim: Aim, now: &impl Fn(String)) -> Result<Loaded, Error> {
    if models.is_empty() {
        let failed = |what: String| Error::file(demo::FILE, what);
        let world = demo::world().map_err(|error| failed(error.to_string()))?;
        let camera = demo::camera(16, 9).map_err(|error| failed(error.to_string()))?;
        return Ok(Loaded {
            world,
            up: Up::PlusY,
            notes: Vec::new(),
            look: Some((camera, demo::light())),
            framed: None,
            warm: None,
        });
    }
    let mut world = World::new();
    let (mut ups, mut notes) = (Vec::new(), Vec::new());
    for (number, model) in models.iter().enumerate() {
        let name = one_line(&model.name().to_string_lossy());
        let of =
            if models.len() > 1 { format!(" ({} of {})", number + 1, models.len()) } else { String::new() };
        now(format!("reading {name}{of}"));
        let source = Source::open(model)?;
        ups.push(source.up());
        notes.extend(source.notes.iter().map(|note| one_line(&format!("{name}: {note}"))));
        now(format!("preparing {name}{of}"));
        source.add_to(&mut world, show, &model.name())?;
    }
    if show != Show::Surface {
        world.prepare_edges();
    }
    let up = common_up(&ups);
    let view = View { up: aim.up.unwrap_or(up), ..aim.view };
    // Why there is none is told by whoever tries again.
    let camera = view.camera(points(&world), &world.bounds(), aim.aspect()).ok();
    let warm = camera.as_ref().and_then(|camera| aim.warm(&world, camera));
    let framed = camera.map(|camera| (camera, aim.aspect()));
    Ok(Loaded { world, up, notes, look: None, framed, warm })
}
