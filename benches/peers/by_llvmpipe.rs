//! Mesa's llvmpipe, in a process of its own: `llvmpipe.c`, compiled when it is needed.

use std::io::{BufRead as _, BufReader, Read as _, Write as _};
use std::path::{Path, PathBuf};
use std::process::{Child, ChildStdin, ChildStdout, Command, Stdio};

use crate::contestant::Contestant;
use crate::job::{Job, Vertices};

/// Compiles the harness into the target folder.
pub(crate) fn compile() -> Result<PathBuf, String> {
    let source = Path::new(env!("CARGO_MANIFEST_DIR")).join("peers/llvmpipe.c");
    let program = Path::new(env!("CARGO_TARGET_TMPDIR")).join("llvmpipe");
    let compiler = std::env::var("CC").unwrap_or_else(|_| "cc".to_owned());
    let output = Command::new(&compiler)
        .args(["-O2", "-o"])
        .arg(&program)
        .arg(&source)
        .args(["-lEGL", "-lGL"])
        .output()
        .map_err(|error| format!("no C compiler ({compiler}: {error})"))?;
    if !output.status.success() {
        let said = String::from_utf8_lossy(&output.stderr);
        let first = said.lines().find(|line| line.contains("error")).unwrap_or("no reason given").to_owned();
        return Err(format!(
            "{compiler} does not compile the harness; it needs the headers and libraries of EGL and OpenGL: {first}"
        ));
    }
    Ok(program)
}

pub(crate) struct Llvmpipe {
    /// What OpenGL says of itself.
    pub(crate) renderer: String,
    /// `LP_NUM_THREADS`: 0 rasterises in the thread that calls.
    workers: usize,
    pixels: usize,
    child: Child,
    to: Option<ChildStdin>,
    from: BufReader<ChildStdout>,
}

impl Llvmpipe {
    /// Starts the harness and hands it the job.
    pub(crate) fn start(program: &Path, job: &Job, workers: usize) -> Result<Self, String> {
        let mut child = Command::new(program)
            .env("GALLIUM_DRIVER", "llvmpipe")
            .env("LIBGL_ALWAYS_SOFTWARE", "1")
            .env("LP_NUM_THREADS", workers.to_string())
            .stdin(Stdio::piped())
            .stdout(Stdio::piped())
            .spawn()
            .map_err(|error| format!("the harness does not start: {error}"))?;
        let (to, from) = (child.stdin.take(), child.stdout.take());
        let from = BufReader::new(from.ok_or("the harness has no output")?);
        let pixels = job.size[0] as usize * job.size[1] as usize;
        let mut this = Self { renderer: String::new(), workers, pixels, child, to, from };
        // What it says is the better reason when it has gone before it took everything.
        let sent = this.send(&message(job));
        this.from.read_line(&mut this.renderer).map_err(gone)?;
        this.renderer.truncate(this.renderer.trim_end().len());
        if let Some(error) = this.renderer.strip_prefix("error: ") {
            return Err(error.to_owned());
        }
        sent?;
        if !this.renderer.starts_with("llvmpipe") {
            return Err(format!("OpenGL is drawn by {:?} here, not by llvmpipe", this.renderer));
        }
        Ok(this)
    }

    fn send(&mut self, bytes: &[u8]) -> Result<(), String> {
        let to = self.to.as_mut().ok_or("the harness has no input")?;
        to.write_all(bytes).and_then(|()| to.flush()).map_err(gone)
    }

    fn receive(&mut self, bytes: usize) -> Result<Vec<u8>, String> {
        let mut buffer = vec![0; bytes];
        self.from.read_exact(&mut buffer).map_err(gone)?;
        Ok(buffer)
    }
}

impl Drop for Llvmpipe {
    fn drop(&mut self) {
        // The end of its input ends it.
        drop(self.to.take());
        let _ = self.child.wait();
    }
}

impl Contestant for Llvmpipe {
    fn name(&self) -> String {
        format!("llvmpipe LP_NUM_THREADS={}", self.workers)
    }

    fn threads(&self) -> usize {
        self.workers.max(1)
    }

    fn frames(&mut self, count: u32) -> Result<Vec<u64>, String> {
        let mut request = vec![b'F'];
        request.extend(count.to_ne_bytes());
        self.send(&request)?;
        let bytes = self.receive(8 * count as usize)?;
        Ok(bytes.as_chunks().0.iter().map(|&eight| u64::from_ne_bytes(eight)).collect())
    }

    fn picture(&mut self) -> Result<Vec<u32>, String> {
        self.send(b"P")?;
        let bytes = self.receive(4 * self.pixels)?;
        Ok(bytes.as_chunks().0.iter().map(|&four| u32::from_ne_bytes(four)).collect())
    }
}

fn gone(error: std::io::Error) -> String {
    format!("the harness has gone: {error}")
}

/// The job as the harness reads it: `struct header` of llvmpipe.c, vertices, indices.
fn message(job: &Job) -> Vec<u8> {
    let (vertices, components, matrix): (Vec<f32>, u32, _) = match &job.vertices {
        Vertices::Clip(vertices) => (vertices.iter().flatten().copied().collect(), 4, &[[0.0; 4]; 4]),
        Vertices::Model { positions, matrix } => (positions.iter().flatten().copied().collect(), 3, matrix),
    };
    // Triangles in the order of the vertices need no indices, and are drawn faster without.
    let plain = job.indices.iter().flatten().copied().eq(0..vertices.len() as u32 / components);
    let indices = if plain { &[][..] } else { &job.indices };
    let lit = job.lit.as_ref();
    let numbers = [
        u32::from(lit.is_some()),
        job.size[0],
        job.size[1],
        vertices.len() as u32 / components,
        components,
        3 * indices.len() as u32,
        u32::from(lit.is_some()),
    ];
    let light =
        lit.map_or([0.0; 4], |lit| [lit.direction[0], lit.direction[1], lit.direction[2], lit.ambient]);
    let color = lit.map_or([0.0; 4], |lit| [lit.linear()[0], lit.linear()[1], lit.linear()[2], 1.0]);
    let mut bytes = Vec::new();
    bytes.extend(numbers.iter().flat_map(|number| number.to_ne_bytes()));
    let floats = matrix.iter().flatten().chain(&light).chain(&color).chain(&vertices);
    bytes.extend(floats.flat_map(|number| number.to_ne_bytes()));
    bytes.extend(indices.iter().flatten().flat_map(|index| index.to_ne_bytes()));
    bytes
}
