//! The ways in which polosa itself draws a soup: one adapter, so that benchmarks need not know them.

use polosa_raster::{
    Depth, DepthTest, Frame, Level, PerTriangle, State, Stats, StoredDepth, Target, Triangles, Vertices,
};

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
        let depth = Depth::F32(&mut self.depth);
        let [width, height] = self.size;
        Target::new(&mut self.color, depth, width, height, width as usize).expect("sizes fit")
    }

    /// The colours alone.
    ///
    /// # Panics
    ///
    /// When a side is 0 or too long.
    pub fn colors(&mut self) -> Target<'_, u32> {
        let [width, height] = self.size;
        Target::new(&mut self.color, Depth::None, width, height, width as usize).expect("sizes fit")
    }
}

/// A way to draw; it keeps its working memory.
#[derive(Debug)]
pub struct Path {
    name: String,
    threads: usize,
    way: Way,
}

#[derive(Debug)]
enum Way {
    /// Triangle by triangle into the picture, without an allocator. Keeps vertices after their transform.
    Immediate(Vec<[f32; 4]>),
    /// In tiles; with or without the depths written out.
    Frame(Frame, bool),
}

impl Path {
    /// Triangle by triangle, by the one thread that calls.
    #[must_use]
    pub fn immediate() -> Self {
        Self { name: "immediate".to_owned(), threads: 1, way: Way::Immediate(Vec::new()) }
    }

    /// In tiles, by some threads, at the machine's best level.
    #[must_use]
    pub fn frame(threads: usize) -> Self {
        let name = if threads == 1 { "frame".to_owned() } else { format!("frame, {threads} threads") };
        Self { name, threads, way: Way::Frame(Frame::with(Level::detect(), threads), true) }
    }

    /// In tiles by one thread; depth is tested, but stays in the tiles.
    #[must_use]
    pub fn without_depth() -> Self {
        let name = "frame, depth not written out".to_owned();
        Self { name, threads: 1, way: Way::Frame(Frame::new(), false) }
    }

    /// In tiles by one thread, at each level below the machine's best.
    #[must_use]
    pub fn levels() -> Vec<Self> {
        let mut levels: Vec<_> = Level::available()
            .map(|level| Self {
                name: format!("frame, {level}"),
                threads: 1,
                way: Way::Frame(Frame::with(level, 1), true),
            })
            .collect();
        levels.pop();
        levels
    }

    /// All ways that draw colour and depth with this many threads at the best level.
    #[must_use]
    pub fn all(threads: usize) -> Vec<Self> {
        let frame = Self::frame(threads);
        if threads == 1 { vec![Self::immediate(), frame] } else { vec![frame] }
    }

    /// What it is called in reports.
    #[must_use]
    pub fn name(&self) -> &str {
        &self.name
    }

    /// Threads that draw.
    #[must_use]
    pub const fn threads(&self) -> usize {
        self.threads
    }

    /// Whether the picture's depths are written.
    #[must_use]
    pub const fn writes_depth(&self) -> bool {
        !matches!(self.way, Way::Frame(_, false))
    }

    /// Clears the picture to 0 and draws a soup, each triangle in the value of its number. `indices` are those of
    /// consecutive vertices: who need not read them does not.
    ///
    /// # Panics
    ///
    /// When the picture's size is out of range.
    pub fn draw(
        &mut self,
        picture: &mut Picture,
        vertices: Vertices<'_>,
        indices: &[[u32; 3]],
        value: &(impl Fn(usize) -> u32 + Sync),
    ) -> Stats {
        let state = State::default();
        match &mut self.way {
            Way::Immediate(clip) => {
                let vertices = match vertices {
                    Vertices::Clip(vertices) => vertices,
                    Vertices::Model { matrix, positions } => {
                        clip.resize(positions.len(), [0.0; 4]);
                        polosa_raster::transform(matrix, positions, clip);
                        clip
                    }
                };
                let mut target = picture.target();
                target.clear(0, DepthTest::Greater);
                target.triangles(&state, vertices, indices, &PerTriangle(value))
            }
            Way::Frame(frame, depth) => {
                frame.begin(picture.size, 0, StoredDepth::F32(0.0)).expect("the size is in range");
                let stats = frame.draw(&state, 0, vertices, Triangles::Consecutive, value);
                let mut target = if *depth { picture.target() } else { picture.colors() };
                frame.finish(&mut target).expect("frame and target are alike");
                stats
            }
        }
    }
}
