//! The ways in which polosa itself draws a soup: one adapter, so that benchmarks need not know them.

use polosa_raster::{Depth, DepthTest, PerTriangle, State, Stats, Target};

/// Colour and depth of a picture, kept warm from one drawing to the next.
#[derive(Clone, Debug)]
pub struct Picture {
    /// Rows from top to bottom.
    pub color: Vec<u32>,
    /// Likewise; larger is nearer.
    pub depth: Vec<f32>,
    /// Width and height.
    pub size: [u32; 2],
}

impl Picture {
    /// A picture of `size` pixels.
    #[must_use]
    pub fn new(size: [u32; 2]) -> Self {
        let pixels = size[0] as usize * size[1] as usize;
        Self { color: vec![0; pixels], depth: vec![0.0; pixels], size }
    }

    /// To be drawn into.
    ///
    /// # Panics
    ///
    /// When a side is 0 or too long.
    pub fn target(&mut self) -> Target<'_, u32> {
        let [width, height] = self.size;
        let depth = Depth::F32(&mut self.depth);
        Target::new(&mut self.color, depth, width, height, width as usize).expect("sizes fit")
    }
}

/// A way to draw; it keeps its working memory.
#[derive(Debug)]
pub enum Path {
    /// Triangle by triangle into the picture, without an allocator.
    Immediate,
}

impl Path {
    /// All ways that draw with this many threads.
    #[must_use]
    pub fn all(threads: usize) -> Vec<Self> {
        if threads == 1 { vec![Self::Immediate] } else { Vec::new() }
    }

    /// What it is called in reports.
    #[must_use]
    pub const fn name(&self) -> &'static str {
        match self {
            Self::Immediate => "immediate",
        }
    }

    /// Clears the picture to 0 and draws triangles from clip space, each in the value of its number.
    pub fn draw(
        &mut self,
        picture: &mut Picture,
        vertices: &[[f32; 4]],
        indices: &[[u32; 3]],
        value: &impl Fn(usize) -> u32,
    ) -> Stats {
        match self {
            Self::Immediate => {
                let mut target = picture.target();
                target.clear(0, DepthTest::Greater);
                target.triangles(&State::default(), vertices, indices, &PerTriangle(value))
            }
        }
    }
}
