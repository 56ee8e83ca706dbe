//! What an application shows, to a file.

use std::path::Path;
use std::time::Instant;

use polosa_scene::Picture;

use super::Application;
use crate::error::Error;
use crate::program::Program;
use crate::record::{self, Options, Recorder};

/// A recording that goes on.
#[derive(Debug)]
pub(super) struct Recording {
    recorder: Recorder,
    /// When the first frame was shown in a window; `None` before that, and without a window, where each frame lasts as
    /// long as any other.
    first: Option<Instant>,
}

/// # Recording
impl Application {
    /// Records every frame that is drawn from now on, with what is drawn over it in 2D, to `OUT.gif` or to a numbered
    /// sequence such as `OUT_%04d.png`: see [`record`].
    ///
    /// Without a window each frame lasts as long as the frame rate says, the one at this moment. In a window frames are
    /// recorded at the times at which they are shown: while nothing changes, the animation stands still as well. A
    /// sequence has a file for each frame that was drawn.
    ///
    /// A recording that goes on already is completed first. When the window is closed, so is its recording.
    ///
    /// # Errors
    ///
    /// As [`record::to`]: a name that is none, a folder that is not there. As
    /// [`stop_recording`](Self::stop_recording), if a recording goes on.
    pub fn record(&mut self, path: impl AsRef<Path>) -> Result<(), Error> {
        // What failed in a window has been logged; it is over.
        self.record_failed = None;
        self.complete_recording()?;
        let fps = 1.0 / self.exact_step().as_secs_f64();
        let recorder = record::to(path, Options { fps, threads: self.settings.threads })?;
        self.recording = Some(Recording { recorder, first: None });
        Ok(())
    }

    /// Whether frames are recorded.
    #[must_use]
    pub const fn is_recording(&self) -> bool {
        self.recording.is_some()
    }

    /// Completes the recording. Nothing is recorded? Then nothing happens.
    ///
    /// # Errors
    ///
    /// When it cannot be written, or no frame was drawn meanwhile; then a GIF is not there. What failed while frames were
    /// shown in a window has been logged, and is returned here.
    pub fn stop_recording(&mut self) -> Result<(), Error> {
        let failed = self.record_failed.take().map_or(Ok(()), Err);
        failed.and(self.complete_recording())
    }

    /// The same without what has failed, and was logged, before.
    pub(crate) fn complete_recording(&mut self) -> Result<(), Error> {
        self.recording.take().map_or(Ok(()), Recording::finish)
    }

    /// [`run_headless`](Self::run_headless), with every frame recorded to a file.
    ///
    /// ```
    /// use polosa::math::{axis_angle, glam::DVec3};
    /// use polosa::scene::{Object, shape};
    /// use polosa::{Application, Settings};
    ///
    /// let mut app = Application::with(Settings { size: [80, 60], frame_rate: 25.0, ..Settings::default() });
    /// let mesh = app.world.add_mesh(shape::cube());
    /// let cube = app.world.add(Object::new(mesh))?;
    /// app.frame_world();
    /// let mut program = move |app: &mut Application, step: std::time::Duration| {
    ///     axis_angle(DVec3::Y, step.as_secs_f64()).and_then(|turn| app.world.turn(cube, turn).ok());
    /// };
    /// # let folder = tempfile::tempdir()?;
    /// # let path = folder.path().join("cube.gif");
    /// app.record_headless(10, &mut program, &path)?;
    /// assert!(std::fs::read(&path)?.starts_with(b"GIF89a"));
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    ///
    /// # Errors
    ///
    /// As [`record`](Self::record) and [`stop_recording`](Self::stop_recording); and when a frame has another size than
    /// the first. Where it fails, a GIF is not there.
    pub fn record_headless(
        &mut self,
        frames: u64,
        program: &mut impl Program,
        path: impl AsRef<Path>,
    ) -> Result<(), Error> {
        self.record(path)?;
        let ran = self.run_headless(frames, program, |_, _| Ok(()));
        if ran.is_err() {
            self.recording = None;
        }
        ran.and(self.stop_recording())
    }

    /// A frame was drawn without a window.
    pub(super) fn record_step(&mut self, picture: &Picture) -> Result<(), Error> {
        match &mut self.recording {
            Some(recording) => recording.recorder.frame(&picture.pixels, [picture.width, picture.height]),
            None => Ok(()),
        }
    }

    /// A frame is about to be shown in a window. A recording that fails ends, and is completed as far as it goes; that is
    /// logged, and told when it is stopped. The window goes on.
    #[cfg(feature = "window")]
    pub(crate) fn record_live(&mut self, pixels: &[u32]) {
        let Some(recording) = &mut self.recording else { return };
        let now = Instant::now();
        let first = *recording.first.get_or_insert(now);
        let recorded = recording.recorder.frame_at(pixels, self.size, now.duration_since(first));
        if let Err(error) = crate::log::critical(recorded) {
            // Of a recording that cannot be written the reason is told already.
            let _ = self.recording.take().map(Recording::finish);
            self.record_failed = Some(error);
        }
    }
}

impl Recording {
    fn finish(self) -> Result<(), Error> {
        match self.first {
            Some(first) => self.recorder.finish_at(first.elapsed()),
            None => self.recorder.finish(),
        }
    }
}
