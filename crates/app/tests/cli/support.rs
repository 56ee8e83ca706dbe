//! A folder, the program run in it, and what it made.

use std::io::Write as _;
use std::path::{Path, PathBuf};
use std::process::{Command, Output, Stdio};

use image::{Rgba, RgbaImage};

/// A temporary folder with a few models.
pub(crate) struct Folder(tempfile::TempDir);

/// What the program said.
#[derive(Debug)]
pub(crate) struct Said {
    pub(crate) status: Option<i32>,
    pub(crate) stdout: Vec<u8>,
    pub(crate) stderr: String,
}

impl Said {
    pub(crate) fn text(&self) -> String {
        String::from_utf8(self.stdout.clone()).expect("a report is text")
    }
}

impl Folder {
    pub(crate) fn new() -> Self {
        Self(tempfile::tempdir().unwrap())
    }

    pub(crate) fn path(&self, name: &str) -> PathBuf {
        self.0.path().join(name)
    }

    /// A file in the folder.
    pub(crate) fn with(self, name: &str, content: impl AsRef<[u8]>) -> Self {
        std::fs::write(self.path(name), content).unwrap();
        self
    }

    pub(crate) fn command(&self) -> Command {
        let mut command = Command::new(env!("CARGO_BIN_EXE_polosa"));
        command.current_dir(self.0.path()).env_remove("RUST_BACKTRACE");
        // No test here opens a window, whoever runs them.
        for name in ["DISPLAY", "WAYLAND_DISPLAY", "WAYLAND_SOCKET"] {
            command.env_remove(name);
        }
        command
    }

    /// Runs the program with arguments separated by spaces, `input` on its standard input.
    pub(crate) fn run_with(&self, arguments: &str, input: &[u8]) -> Said {
        let mut command = self.command();
        command.args(arguments.split_whitespace());
        command.stdin(Stdio::piped()).stdout(Stdio::piped()).stderr(Stdio::piped());
        let mut child = command.spawn().unwrap();
        // It may end without having read everything.
        let _ = child.stdin.take().unwrap().write_all(input);
        said(child.wait_with_output().unwrap())
    }

    pub(crate) fn run(&self, arguments: &str) -> Said {
        self.run_with(arguments, b"")
    }

    /// Runs the program and expects that it succeeds silently.
    pub(crate) fn done(&self, arguments: &str) -> Said {
        let said = self.run(arguments);
        assert_eq!((said.status, said.stderr.as_str()), (Some(0), ""), "polosa {arguments}");
        said
    }

    /// Renders with these arguments and reads the picture.
    pub(crate) fn render(&self, arguments: &str) -> RgbaImage {
        self.done(&format!("render {arguments} -o made.png"));
        self.picture("made.png")
    }

    /// Renders with these arguments what turns out to be a picture of nothing; the note about it.
    pub(crate) fn blank(&self, arguments: &str) -> String {
        let said = self.run(&format!("render {arguments} -o made.png"));
        assert_eq!(said.status, Some(0), "{arguments}: {}", said.stderr);
        assert_eq!(said.stderr.lines().count(), 1, "{arguments}: {}", said.stderr);
        let note = said.stderr.strip_prefix("polosa: made.png: note: nothing to see: ");
        note.unwrap_or_else(|| panic!("{arguments}: {}", said.stderr)).trim_end().to_owned()
    }

    pub(crate) fn picture(&self, name: &str) -> RgbaImage {
        image::open(self.path(name)).unwrap().into_rgba8()
    }

    pub(crate) fn bytes(&self, name: &str) -> Vec<u8> {
        std::fs::read(self.path(name)).unwrap()
    }

    /// Names of all files, sorted.
    pub(crate) fn names(&self) -> Vec<String> {
        names(self.0.path())
    }
}

fn names(folder: &Path) -> Vec<String> {
    let mut names: Vec<String> = std::fs::read_dir(folder)
        .unwrap()
        .map(|entry| entry.unwrap().file_name().into_string().unwrap())
        .collect();
    names.sort();
    names
}

pub(crate) fn said(output: Output) -> Said {
    Said {
        status: output.status.code(),
        stdout: output.stdout,
        stderr: String::from_utf8(output.stderr).expect("messages are text"),
    }
}

/// The frames of a GIF as they are shown, and how long, in hundredths of a second.
pub(crate) fn play(bytes: &[u8]) -> Vec<(RgbaImage, u16)> {
    let mut options = gif::DecodeOptions::new();
    options.set_color_output(gif::ColorOutput::RGBA);
    let mut decoder = options.read_info(bytes).unwrap();
    let mut shown = RgbaImage::new(decoder.width().into(), decoder.height().into());
    let mut frames = Vec::new();
    while let Some(frame) = decoder.read_next_frame().unwrap() {
        let (left, top) = (u32::from(frame.left), u32::from(frame.top));
        let places =
            (0..u32::from(frame.height)).flat_map(|y| (0..u32::from(frame.width)).map(move |x| (x, y)));
        for ((x, y), pixel) in places.clone().zip(frame.buffer.chunks_exact(4)).filter(|(_, p)| p[3] > 0) {
            shown.put_pixel(left + x, top + y, Rgba([pixel[0], pixel[1], pixel[2], 255]));
        }
        frames.push((shown.clone(), frame.delay));
        if frame.dispose == gif::DisposalMethod::Background {
            places.for_each(|(x, y)| shown.put_pixel(left + x, top + y, Rgba([0; 4])));
        }
    }
    frames
}

/// A pixel of these codes, opaque.
pub(crate) const fn rgb(r: u8, g: u8, b: u8) -> Rgba<u8> {
    Rgba([r, g, b, 255])
}

/// The default background.
pub(crate) const BACKGROUND: Rgba<u8> = rgb(0x2b, 0x2b, 0x2b);

/// Pixels of a colour.
pub(crate) fn count(picture: &RgbaImage, color: Rgba<u8>) -> usize {
    picture.pixels().filter(|pixel| **pixel == color).count()
}

/// The least and greatest x and y of what is not of the background's colour.
pub(crate) fn extent(picture: &RgbaImage, background: Rgba<u8>) -> Option<[u32; 4]> {
    let shown = picture.enumerate_pixels().filter(|(_, _, pixel)| **pixel != background);
    shown.fold(None, |extent, (x, y, _)| {
        let [x0, y0, x1, y1] = extent.unwrap_or([x, y, x, y]);
        Some([x0.min(x), y0.min(y), x1.max(x), y1.max(y)])
    })
}

/// A PFM's width, height and values, rows from top to bottom.
pub(crate) fn pfm(bytes: &[u8]) -> (usize, usize, Vec<f32>) {
    let mut lines = bytes.splitn(4, |byte| *byte == b'\n');
    let mut line = || lines.next().unwrap();
    assert_eq!(line(), b"Pf");
    let size: Vec<usize> =
        std::str::from_utf8(line()).unwrap().split(' ').map(|number| number.parse().unwrap()).collect();
    assert_eq!(line(), b"-1.0", "little-endian");
    let values: Vec<f32> =
        line().chunks_exact(4).map(|bytes| f32::from_le_bytes(bytes.try_into().unwrap())).collect();
    assert_eq!(values.len(), size[0] * size[1]);
    (size[0], size[1], values.chunks_exact(size[0]).rev().flatten().copied().collect())
}

/// A square of two triangles from (0, 0) to (10, 5) in the plane z = 2, counter-clockwise seen from +Z.
pub(crate) const SQUARE: &str = "\
v 0 0 2
v 10 0 2
v 10 5 2
v 0 5 2
f 1 2 3 4
";

/// A cube from −1 to 1 of triangles, as ASCII STL.
pub(crate) fn cube_stl() -> String {
    let corner = |i: usize| [0, 1, 2].map(|axis| if i >> axis & 1 == 1 { 1 } else { -1 });
    let faces = [
        [0, 2, 3],
        [0, 3, 1],
        [4, 5, 7],
        [4, 7, 6],
        [0, 1, 5],
        [0, 5, 4],
        [2, 6, 7],
        [2, 7, 3],
        [0, 4, 6],
        [0, 6, 2],
        [1, 3, 7],
        [1, 7, 5],
    ];
    let mut text = String::from("solid cube\n");
    for face in faces {
        text += "facet normal 0 0 0\nouter loop\n";
        for [x, y, z] in face.map(corner) {
            text += &format!("vertex {x} {y} {z}\n");
        }
        text += "endloop\nendfacet\n";
    }
    text + "endsolid cube\n"
}
