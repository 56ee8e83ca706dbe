//! Targets, vertices and readable pictures.

use polosa_raster::{Clip, Depth, DepthTest, Fragment, Space, State, Target};

use super::oracle::Vertex;

/// The state of most tests: vertices come in screen space.
pub(crate) fn on_screen() -> State {
    State { space: Space::Screen, ..State::default() }
}

/// A snapped vertex as screen-space input: exact, since its 24 bits fit `f32`.
pub(crate) fn screen(v: Vertex, depth: f32) -> Clip {
    [v[0] as f32 / 256.0, v[1] as f32 / 256.0, depth, 1.0]
}

/// A vertex given in pixels.
pub(crate) const fn px(x: f32, y: f32, depth: f32) -> Clip {
    [x, y, depth, 1.0]
}

/// A picture of its own: colour and `f32` depth.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Picture {
    pub(crate) width: usize,
    pub(crate) height: usize,
    pub(crate) color: Vec<u32>,
    pub(crate) depth: Vec<f32>,
}

impl Picture {
    /// A picture of zeros.
    pub(crate) fn new(width: usize, height: usize) -> Self {
        Self { width, height, color: vec![0; width * height], depth: vec![0.0; width * height] }
    }

    /// The picture cleared for the depth test.
    pub(crate) fn cleared(width: usize, height: usize, test: DepthTest) -> Self {
        let mut picture = Self::new(width, height);
        picture.target().clear(0, test);
        picture
    }

    /// The whole picture to draw into.
    pub(crate) fn target(&mut self) -> Target<'_, u32> {
        let (width, height) = (u32::try_from(self.width).unwrap(), u32::try_from(self.height).unwrap());
        Target::new(&mut self.color, Depth::F32(&mut self.depth), width, height, self.width).unwrap()
    }

    /// Colour at (x, y).
    pub(crate) fn at(&self, x: usize, y: usize) -> u32 {
        self.color[y * self.width + x]
    }

    /// Depth at (x, y).
    pub(crate) fn depth_at(&self, x: usize, y: usize) -> f32 {
        self.depth[y * self.width + x]
    }

    /// (x, y) of all pixels that are not zero.
    pub(crate) fn painted(&self) -> Vec<(usize, usize)> {
        (0..self.color.len())
            .filter(|&k| self.color[k] != 0)
            .map(|k| (k % self.width, k / self.width))
            .collect()
    }

    /// Rows of characters: `.` for zero, else the digit.
    pub(crate) fn rows(&self) -> Vec<String> {
        let digit = |&c: &u32| if c == 0 { '.' } else { char::from_digit(c % 36, 36).unwrap() };
        self.color.chunks(self.width).map(|row| row.iter().map(digit).collect()).collect()
    }

    /// A 64-bit hash (FNV-1a) of all colours and depth bits.
    pub(crate) fn hash(&self) -> u64 {
        let bytes = self
            .color
            .iter()
            .copied()
            .chain(self.depth.iter().map(|z| z.to_bits()))
            .flat_map(u32::to_le_bytes);
        bytes.fold(0xCBF2_9CE4_8422_2325, |h, b| (h ^ u64::from(b)).wrapping_mul(0x0100_0000_01B3))
    }
}

/// A shade that counts how often each pixel is drawn.
pub(crate) fn count(_: &Fragment<'_>, pixel: &mut u32) -> bool {
    *pixel += 1;
    true
}

/// Fails with both pictures side by side if they differ.
#[track_caller]
pub(crate) fn assert_rows(got: &[String], expected: &[&str]) {
    let line = |y: usize| {
        let (g, e) = (got.get(y).map_or("", String::as_str), expected.get(y).copied().unwrap_or(""));
        format!("{y:3}  {e}   {g}{}", if g == e { "" } else { "   <──" })
    };
    let all: Vec<_> = (0..got.len().max(expected.len())).map(line).collect();
    assert!(
        got.iter().map(String::as_str).eq(expected.iter().copied()),
        "\nexpected, got:\n{}\n",
        all.join("\n")
    );
}
