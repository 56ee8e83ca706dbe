//! Where pictures go: slices that the caller lends.

use core::fmt;
use core::ops::Range;
use core::slice::ChunksMut;

use crate::depth::Stored;
use crate::{DepthTest, Rect};

/// The most pixels along a side of a picture.
///
/// Within it every sub-pixel of a picture lies well inside the guard band (± 32,768 pixels), and edge values
/// stay below 2⁴⁹.
pub const MAX_SIDE: u32 = 16_384;

/// Where depth is kept. Larger is nearer; 0 is what was cleared.
#[derive(Debug)]
pub enum Depth<'a> {
    /// Nowhere: what is drawn last stays.
    None,
    /// As it is computed.
    F32(&'a mut [f32]),
    /// Quantised to `1 + ⌊depth · 65534⌋` and compared as such. Pair it with a finite far plane or an
    /// orthographic projection: half of its values lie between the near plane and twice that distance.
    U16(&'a mut [u16]),
}

/// Depth as it is stored at a pixel.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum StoredDepth {
    /// Of a target with [`Depth::F32`].
    F32(f32),
    /// Of a target with [`Depth::U16`].
    U16(u16),
}

/// Why slices do not make a target.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum TargetError {
    /// A side is zero, or longer than [`MAX_SIDE`].
    Size {
        /// The picture's width.
        width: u32,
        /// The picture's height.
        height: u32,
    },
    /// Rows would overlap: the stride is less than the width.
    Stride {
        /// The stride that was given.
        stride: usize,
        /// The picture's width.
        width: u32,
    },
    /// The band's rows are not rows of the picture, or there are none.
    Rows {
        /// The first row that was given.
        start: u32,
        /// One past the last row that was given.
        end: u32,
        /// The picture's height.
        height: u32,
    },
    /// A frame was finished into a target of another picture's size.
    Frame {
        /// The frame's width and height.
        frame: [u32; 2],
        /// The target's.
        target: [u32; 2],
    },
    /// A frame was finished into a target whose depth has another format.
    Format,
    /// The slice of pixels is too short.
    Color {
        /// `(rows − 1) · stride + width`.
        needed: usize,
        /// The slice's length.
        given: usize,
    },
    /// The slice of depths is too short.
    Depth {
        /// `(rows − 1) · stride + width`.
        needed: usize,
        /// The slice's length.
        given: usize,
    },
}

impl fmt::Display for TargetError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Size { width, height } => {
                write!(f, "a picture of {width}×{height} pixels: each side must be from 1 to {MAX_SIDE}")
            }
            Self::Stride { stride, width } => {
                write!(f, "a stride of {stride} for rows of {width} pixels: it must be at least the width")
            }
            Self::Rows { start, end, height } => {
                write!(f, "rows {start}..{end} of a picture with {height}: name rows that it has")
            }
            Self::Frame { frame: [fw, fh], target: [tw, th] } => {
                write!(
                    f,
                    "a frame of {fw}×{fh} pixels for a picture of {tw}×{th}: begin it with the picture's size"
                )
            }
            Self::Format => {
                write!(
                    f,
                    "the target keeps depth in another format than the frame: begin it with the target's"
                )
            }
            Self::Color { needed, given } => {
                write!(f, "{given} pixels of colour given, {needed} needed")
            }
            Self::Depth { needed, given } => {
                write!(f, "{given} pixels of depth given, {needed} needed")
            }
        }
    }
}

impl core::error::Error for TargetError {}

/// A picture, or a band of its rows, to draw into.
///
/// The slices stay the caller's: drawing allocates nothing, and what is drawn is there once the target is
/// dropped. A pixel is any `Copy` value.
///
/// # Guarantees
///
/// Both slices hold every pixel of the rows, and the picture is at most [`MAX_SIDE`] pixels on a side: drawing
/// relies on it.
///
/// ```
/// use polosa_raster::{Depth, DepthTest, Target};
///
/// let (mut color, mut depth) = ([7_u8; 6], [0.5; 6]);
/// let mut target = Target::new(&mut color, Depth::F32(&mut depth), 3, 2, 3)?;
/// target.clear(1, DepthTest::Greater);
/// assert_eq!(target.color_at(2, 1), Some(1));
/// assert_eq!(target.color_at(3, 1), None, "beside the picture");
///
/// let error = Target::new(&mut color, Depth::None, 4, 2, 4).unwrap_err();
/// assert_eq!(error.to_string(), "6 pixels of colour given, 8 needed");
/// # Ok::<(), polosa_raster::TargetError>(())
/// ```
#[derive(Debug)]
pub struct Target<'a, P> {
    pub(crate) color: &'a mut [P],
    pub(crate) depth: Depth<'a>,
    pub(crate) width: u32,
    pub(crate) height: u32,
    pub(crate) stride: usize,
    pub(crate) rows: Range<u32>,
}

impl<'a, P: Copy> Target<'a, P> {
    /// A whole picture; `stride` pixels lead from a row to the next, in both slices.
    ///
    /// # Errors
    ///
    /// When a side is out of range, the stride is less than the width, or a slice is too short.
    pub fn new(
        color: &'a mut [P],
        depth: Depth<'a>,
        width: u32,
        height: u32,
        stride: usize,
    ) -> Result<Self, TargetError> {
        Self::band(color, depth, [width, height], stride, 0..height)
    }

    /// The rows `rows` of a picture of `size` (width, height): the slices begin at the first of them. Drawing
    /// the same into all bands of a picture gives the bytes of the whole.
    ///
    /// # Errors
    ///
    /// As for [`new`](Self::new), and when the picture does not have these rows.
    pub fn band(
        color: &'a mut [P],
        depth: Depth<'a>,
        size: [u32; 2],
        stride: usize,
        rows: Range<u32>,
    ) -> Result<Self, TargetError> {
        let [width, height] = size;
        if !(1..=MAX_SIDE).contains(&width) || !(1..=MAX_SIDE).contains(&height) {
            return Err(TargetError::Size { width, height });
        }
        if stride < width as usize {
            return Err(TargetError::Stride { stride, width });
        }
        if rows.is_empty() || rows.end > height {
            return Err(TargetError::Rows { start: rows.start, end: rows.end, height });
        }
        let needed = (rows.len() - 1).saturating_mul(stride).saturating_add(width as usize);
        if color.len() < needed {
            return Err(TargetError::Color { needed, given: color.len() });
        }
        let given = match &depth {
            Depth::None => needed,
            Depth::F32(depth) => depth.len(),
            Depth::U16(depth) => depth.len(),
        };
        if given < needed {
            return Err(TargetError::Depth { needed, given });
        }
        Ok(Self { color, depth, width, height, stride, rows })
    }

    /// The same pixels with depth kept elsewhere, in rows as far apart as those of the pixels.
    ///
    /// # Errors
    ///
    /// When the slice is too short.
    pub fn with_depth<'b>(&'b mut self, depth: Depth<'b>) -> Result<Target<'b, P>, TargetError> {
        let size = [self.width, self.height];
        Target::band(self.color, depth, size, self.stride, self.rows.clone())
    }

    /// The target in bands of so many rows (at least one; the last may have fewer), from top to bottom: for several
    /// threads to draw on.
    pub fn bands(&mut self, rows: u32) -> impl Iterator<Item = Target<'_, P>> {
        let length = (rows.max(1) as usize).saturating_mul(self.stride);
        let Self { width, height, stride, .. } = *self;
        let end = self.rows.end;
        let firsts = self.rows.clone().step_by(rows.max(1) as usize);
        let mut color = self.color.chunks_mut(length);
        let mut depth = match &mut self.depth {
            Depth::None => Depths::None,
            Depth::F32(depth) => Depths::F32(depth.chunks_mut(length)),
            Depth::U16(depth) => Depths::U16(depth.chunks_mut(length)),
        };
        firsts.map_while(move |first| {
            let (color, depth) = (color.next()?, depth.next()?);
            Some(Target {
                color,
                depth,
                width,
                height,
                stride,
                rows: first..end.min(first.saturating_add(rows.max(1))),
            })
        })
    }

    /// The picture's width in pixels.
    #[must_use]
    pub const fn width(&self) -> u32 {
        self.width
    }

    /// The whole picture's height in pixels, in a band too.
    #[must_use]
    pub const fn height(&self) -> u32 {
        self.height
    }

    /// How many pixels lead from a row to the next.
    #[must_use]
    pub const fn stride(&self) -> usize {
        self.stride
    }

    /// The picture's rows that this target holds.
    #[must_use]
    pub const fn rows(&self) -> &Range<u32> {
        &self.rows
    }

    /// Sets every pixel, and every depth to what anything passes `test` against: 0 for
    /// [`Greater`](DepthTest::Greater) and [`Off`](DepthTest::Off), infinity or 65535 for
    /// [`Less`](DepthTest::Less). Values between the rows, where the stride exceeds the width, are not touched.
    pub fn clear(&mut self, pixel: P, test: DepthTest) {
        for y in self.rows.clone() {
            let row = self.span(0, y, self.width);
            self.color[row.clone()].fill(pixel);
            match (&mut self.depth, test) {
                (Depth::None, _) => {}
                (Depth::F32(depth), DepthTest::Less) => depth[row].fill(f32::INFINITY),
                (Depth::F32(depth), _) => depth[row].fill(0.0),
                (Depth::U16(depth), DepthTest::Less) => depth[row].fill(u16::MAX),
                (Depth::U16(depth), _) => depth[row].fill(0),
            }
        }
    }

    /// The value of a pixel; `None` outside of the target's rows.
    #[must_use]
    pub fn color_at(&self, x: u32, y: u32) -> Option<P> {
        self.index(x, y).map(|at| self.color[at])
    }

    /// The depth that is stored for a pixel; `None` outside of the target's rows, or without depth.
    #[must_use]
    pub fn depth_at(&self, x: u32, y: u32) -> Option<StoredDepth> {
        let at = self.index(x, y)?;
        match &self.depth {
            Depth::None => None,
            Depth::F32(depth) => Some(StoredDepth::F32(depth[at])),
            Depth::U16(depth) => Some(StoredDepth::U16(depth[at])),
        }
    }

    fn index(&self, x: u32, y: u32) -> Option<usize> {
        (x < self.width && self.rows.contains(&y)).then(|| self.span(x, y, x + 1).start)
    }

    /// Where the pixels `x0..x1` of a row lie in the slices.
    #[inline]
    pub(crate) fn span(&self, x0: u32, y: u32, x1: u32) -> Range<usize> {
        let row = (y - self.rows.start) as usize * self.stride;
        row + x0 as usize..row + x1 as usize
    }

    /// The pixels that may be drawn on: `x0 <= x1 <= width`, and `y0 <= y1` among the rows, also if none are left.
    pub(crate) fn clip(&self, scissor: Option<Rect>) -> Rect {
        let all = Rect { x0: 0, y0: self.rows.start, x1: self.width, y1: self.rows.end };
        let clip = scissor.map_or(all, |scissor| scissor.intersection(all));
        if clip.x0 < clip.x1 && clip.y0 < clip.y1 { clip } else { Rect { x1: all.x0, y1: all.y0, ..all } }
    }
}

/// Pieces of a slice of depths.
enum Depths<'a> {
    None,
    F32(ChunksMut<'a, f32>),
    U16(ChunksMut<'a, u16>),
}

impl<'a> Depths<'a> {
    fn next(&mut self) -> Option<Depth<'a>> {
        match self {
            Self::None => Some(Depth::None),
            Self::F32(depths) => depths.next().map(Depth::F32),
            Self::U16(depths) => depths.next().map(Depth::U16),
        }
    }
}

impl DepthTest {
    /// Whether a new depth takes a pixel from an old one.
    #[inline]
    pub(crate) fn passes<S: Stored>(self, new: S, old: S) -> bool {
        match self {
            Self::Greater => new > old,
            Self::Less => new < old,
            Self::Off => true,
        }
    }
}
