//! What the benchmarks draw: soups of random triangles of one size, the same on every machine.
//!
//! ```text
//!      large, 64            medium, 20,000           tiny, 500,000
//!    ___________            .  ▲ ▸ ◂  . ▾           . · . ·  . · .
//!   ╱ ╲  ╱     ╲             ▾  ▴ .  ▸ ◂             · .· . .· . ·
//!  ╱___╲╱_______╲           ◂  .▸  ▾ ▴ .            . · . · .·. ·.
//! ```
//!
//! Every triangle is equilateral on the screen; its place and turn are random, and so is the depth of each of its
//! corners: planes are steep, and triangles pass through each other.
//!
//! The same triangles come in three forms (all with reversed depth: 1 at the near plane, 0 far away):
//!
//! - [`Soup::flat`]: clip space with w = 1, as after a parallel projection;
//! - [`Soup::perspective`]: clip space with w = 1/depth and z = 1. Depth z/w is then 1/w itself, so that a renderer
//!   which tests 1/w instead of z/w tests the same;
//! - [`Soup::positions`] with [`Soup::matrix`]: points in front of a camera, to be multiplied to the second form.

use crate::Random;

/// The picture that all workloads are drawn into, unless said otherwise: its width in pixels.
pub const WIDTH: u32 = 1920;
/// The picture's height in pixels.
pub const HEIGHT: u32 = 1080;

/// A soup to be made: how many triangles, how large.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Size {
    /// What it is called in reports.
    pub name: &'static str,
    /// Triangles.
    pub count: u32,
    /// The length of a side in pixels.
    pub side: f32,
}

/// 64 triangles of 433,000 px each; a quarter of that is outside of the picture, and ten layers cover the rest.
pub const LARGE: Size = Size { name: "large", count: 64, side: 1000.0 };
/// 20,000 triangles of 130 px: the size of faces in a game of the nineties, or of a far object today.
pub const MEDIUM: Size = Size { name: "medium", count: 20_000, side: 17.33 };
/// 500,000 triangles of 2 px: scans, and what subdivision makes.
pub const TINY: Size = Size { name: "tiny", count: 500_000, side: 2.15 };

/// The three soups whose figures are quoted.
pub const SIZES: [Size; 3] = [LARGE, MEDIUM, TINY];

/// Soups from 2 pixels a triangle to the full screen: an area in pixels, and how many of it. The counts keep a
/// picture of each at some milliseconds.
pub const AREAS: [(f32, u32); 7] = [
    (2.0, 100_000),
    (10.0, 50_000),
    (50.0, 20_000),
    (512.0, 4_000),
    (5_000.0, 400),
    (80_000.0, 40),
    (2_000_000.0, 8),
];

/// Corners of random triangles on the screen.
#[derive(Clone, Debug)]
pub struct Soup {
    /// The picture's width and height in pixels.
    pub size: [u32; 2],
    /// x and y from −1 to 1 (y up; some lie outside), and depth in (0, 1): three for each triangle.
    corners: Vec<[f32; 3]>,
    /// Which corners make a triangle: 0, 1, 2; 3, 4, 5; and so on.
    pub indices: Vec<[u32; 3]>,
}

impl Soup {
    /// `count` triangles with sides of `side` pixels in a picture of `size` pixels; `seed` is what makes them.
    #[must_use]
    pub fn new(size: [u32; 2], count: u32, side: f32, seed: u64) -> Self {
        let mut random = Random::new(seed);
        let [width, height] = size.map(|pixels| pixels as f32);
        // From the centre of an equilateral triangle to a corner.
        let radius = side / 3_f32.sqrt();
        let mut corners = Vec::with_capacity(3 * count as usize);
        for _ in 0..count {
            let (x, y) = (random.between(0.0, width), random.between(0.0, height));
            let [dx, dy] = random.direction();
            // A third of a turn: cosine −½, sine √¾.
            let s = 0.75_f32.sqrt();
            let turned =
                [[dx, dy], [-0.5 * dx - s * dy, s * dx - 0.5 * dy], [s * dy - 0.5 * dx, -s * dx - 0.5 * dy]];
            for [dx, dy] in turned {
                let (x, y) = (x + radius * dx, y + radius * dy);
                corners.push([2.0 * x / width - 1.0, 1.0 - 2.0 * y / height, random.between(0.05, 0.95)]);
            }
        }
        let indices = (0..count).map(|k| [3 * k, 3 * k + 1, 3 * k + 2]).collect();
        Self { size, corners, indices }
    }

    /// One of the three soups whose figures are quoted, at 1920×1080.
    #[must_use]
    pub fn of(size: Size) -> Self {
        Self::new([WIDTH, HEIGHT], size.count, size.side, 0x9e37_79b9_7f4a_7c15)
    }

    /// Triangles of about `area` pixels each, at 1920×1080.
    #[must_use]
    pub fn of_area(area: f32, count: u32) -> Self {
        // Equilateral: area = √3/4 · side².
        Self::new([WIDTH, HEIGHT], count, (area / 0.433).sqrt(), 0x2545_f491_4f6c_dd1d)
    }

    /// Corners in clip space with w = 1.
    #[must_use]
    pub fn flat(&self) -> Vec<[f32; 4]> {
        self.corners.iter().map(|&[x, y, depth]| [x, y, depth, 1.0]).collect()
    }

    /// Corners in clip space with w = 1/depth, from 1.05 to 20, and z = 1.
    #[must_use]
    pub fn perspective(&self) -> Vec<[f32; 4]> {
        self.corners
            .iter()
            .map(|&[x, y, depth]| {
                let w = 1.0 / depth;
                [x * w, y * w, 1.0, w]
            })
            .collect()
    }

    /// Corners before the camera (x right, y up, looking down −z): [`matrix`](Self::matrix) takes them to clip
    /// space, where they are those of [`perspective`](Self::perspective) but for rounding.
    #[must_use]
    pub fn positions(&self) -> Vec<[f32; 3]> {
        let [fx, fy] = self.focal();
        self.perspective().iter().map(|&[x, y, _, w]| [x / fx, y / fy, -w]).collect()
    }

    /// The projection of a camera with an angle of view of 60° and its near plane at 1, as columns; infinite and
    /// reversed, so that z = 1 and w = −z of the position.
    #[must_use]
    pub fn matrix(&self) -> [[f32; 4]; 4] {
        let [fx, fy] = self.focal();
        [[fx, 0.0, 0.0, 0.0], [0.0, fy, 0.0, 0.0], [0.0, 0.0, 0.0, -1.0], [0.0, 0.0, 1.0, 0.0]]
    }

    /// Focal lengths in halves of the picture's sides.
    fn focal(&self) -> [f32; 2] {
        let [width, height] = self.size.map(|pixels| pixels as f32);
        let fy = 3_f32.sqrt();
        [fy * height / width, fy]
    }
}
