//! How to draw: the settings that a draw call takes.

use polosa_math::{SUB_PIXELS, Viewport};

/// What the four numbers of a vertex mean.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, Default)]
pub enum Space {
    /// Clip space: x right, y up, reversed z (1 at the near plane, 0 at the far one), w. Visible where
    /// `0 <= z <= w`.
    #[default]
    Clip,
    /// On the screen already: x and y in pixels from the top left corner, y down; z the depth from 0 to 1; w
    /// the clip-space w, which only [weights](crate::Fragment::weights) depend on (1 for affine weights).
    Screen,
}

impl Space {
    pub(crate) const fn viewport(self, width: u32, height: u32) -> Viewport {
        match self {
            Self::Clip => Viewport::new(width, height),
            Self::Screen => Viewport::SCREEN,
        }
    }
}

/// Which triangles are left out. Front faces are counter-clockwise as the viewer sees them.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, Default)]
pub enum Cull {
    /// None: both sides are drawn.
    #[default]
    None,
    /// Those that face the viewer.
    Front,
    /// Those that face away.
    Back,
}

/// Which of two values at a pixel stays. Depth is reversed: larger is nearer.
///
/// A tie goes to what was drawn first.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, Default)]
pub enum DepthTest {
    /// The nearer, greater depth; cleared to 0.
    #[default]
    Greater,
    /// The farther, lesser depth, or the nearer one for those whose depth grows with distance. Cleared to
    /// infinity, or 65535 in `u16`: there a vertex of depth exactly 1 ties with what was cleared.
    Less,
    /// The last drawn. Depth is written all the same, unless [`State::write`] says no.
    Off,
}

/// A rectangle of pixels: columns `x0..x1`, rows `y0..y1`.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct Rect {
    /// The first column.
    pub x0: u32,
    /// The first row.
    pub y0: u32,
    /// One past the last column.
    pub x1: u32,
    /// One past the last row.
    pub y1: u32,
}

impl Rect {
    /// What two rectangles have in common; empty rectangles have `x0 >= x1` or `y0 >= y1`.
    #[must_use]
    pub fn intersection(self, other: Self) -> Self {
        Self {
            x0: self.x0.max(other.x0),
            y0: self.y0.max(other.y0),
            x1: self.x1.min(other.x1),
            y1: self.y1.min(other.y1),
        }
    }
}

/// Where inside a pixel it is asked whether a triangle covers it, in sub-pixels from its top left corner.
///
/// The centre, unless pixels are sampled more than once.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct Sample {
    /// To the right, 0 to 255.
    pub x: u8,
    /// Down, 0 to 255.
    pub y: u8,
}

impl Sample {
    /// The centre of the pixel.
    pub const CENTER: Self = Self { x: HALF, y: HALF };

    /// The sample as sub-pixels of the pixel (0, 0).
    #[must_use]
    pub(crate) const fn sub_pixels(self) -> [i32; 2] {
        [self.x as i32, self.y as i32]
    }
}

#[expect(clippy::cast_possible_truncation, reason = "128")]
const HALF: u8 = (SUB_PIXELS / 2) as u8;

impl Default for Sample {
    fn default() -> Self {
        Self::CENTER
    }
}

/// How triangles and lines are drawn.
///
/// ```
/// use polosa_raster::{Cull, State};
///
/// let closed_solids = State { cull: Cull::Back, ..State::default() };
/// assert!(closed_solids.write);
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct State {
    /// What the vertices' numbers mean; clip space by default.
    pub space: Space,
    /// Which triangles are left out; none by default.
    pub cull: Cull,
    /// Which of two values stays; the nearer by default.
    pub test: DepthTest,
    /// Whether what is drawn leaves its depth; yes by default.
    pub write: bool,
    /// Draw only inside this rectangle; everywhere by default.
    pub scissor: Option<Rect>,
    /// Where pixels are sampled; at their centre by default.
    pub sample: Sample,
}

impl Default for State {
    fn default() -> Self {
        Self {
            space: Space::default(),
            cull: Cull::default(),
            test: DepthTest::default(),
            write: true,
            scissor: None,
            sample: Sample::default(),
        }
    }
}
