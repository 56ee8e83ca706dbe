//! Mesa's llvmpipe, in a process of its own: `llvmpipe.c`, compiled when it is needed.

use std::io::{BufRead as _, BufReader, Read as _, Write as _};
use std::path::{Path, PathBuf};
use std::process::{Child, ChildStdin, ChildStdout, Command, Stdio};

use crate::contestant::Contestant;
use crate::job::{Job, Vertices, normal};

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
    let mut indices = job.indices.clone();
    let (vertices, components, matrix): (Vec<f32>, u32, _) = match (&job.vertices, &job.lit) {
        (Vertices::Clip(vertices), _) => (vertices.as_flattened().to_vec(), 4, &[[0.0; 4]; 4]),
        (Vertices::Model { positions, matrix }, None) => (positions.as_flattened().to_vec(), 3, matrix),
        (Vertices::Model { positions, matrix }, Some(_)) => {
            (provoking(positions, &mut indices).into_flattened(), 6, matrix)
        }
    };
    let count = vertices.len() as u32 / components;
    // Triangles in the order of the vertices need no indices, and are drawn faster without.
    if indices.iter().flatten().copied().eq(0..count) {
        indices.clear();
    }
    let lit = job.lit.as_ref();
    let [width, height] = job.size;
    let is_lit = u32::from(lit.is_some());
    let numbers = [is_lit, width, height, count, components, 3 * indices.len() as u32, is_lit];
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

/// Vertices with normals for flat faces: OpenGL takes a face's flat values from its last vertex, so each triangle
/// gets a last vertex of its own, one of its three where it can, else a copy. That is about a vertex a triangle, a
/// third of what triangles apart would need, and nothing to compute for a pixel.
fn provoking(positions: &[[f32; 3]], triangles: &mut [[u32; 3]]) -> Vec<[f32; 6]> {
    let mut vertices: Vec<[f32; 6]> = positions.iter().map(|&[x, y, z]| [x, y, z, 0.0, 0.0, 0.0]).collect();
    let mut taken = vec![false; vertices.len()];
    for triangle in triangles {
        let [a, b, c] = triangle.map(|k| positions[k as usize]);
        if let Some(free) = (0..3).find(|&k| !taken[triangle[k] as usize]) {
            triangle.rotate_left((free + 1) % 3);
        } else {
            vertices.push(vertices[triangle[2] as usize]);
            taken.push(true);
            triangle[2] = vertices.len() as u32 - 1;
        }
        let last = triangle[2] as usize;
        taken[last] = true;
        vertices[last][3..].copy_from_slice(&normal(a, b, c));
    }
    vertices
}
