//! Where rasterisers fail: scenes to run any triangle rasteriser against, and exact oracles to judge it by.
//!
//! Most pictures look right whatever draws them. This suite holds those that do not: edges through pixel centres,
//! slivers, vertices far off the screen, floors that run through the eye, surfaces a hair apart, numbers that are
//! none. For each the right answer is known, from integers and rationals that share no formula with what they judge.
//!
//! ```text
//!   scene ─▶ Job ─▶ your Rasteriser ─▶ Drawn ─▶ compared with the oracle ─▶ Verdict ─▶ Report ─▶ Table
//! ```
//!
//! - [`Rasteriser`]: implement its one required method for what you want to know about.
//! - [`run`]: all scenes, one after the other; a [`Report`] prints as a table.
//! - [`Table`]: several methods side by side, and rows of your own.
//! - [`scenes`]: what is asked, what is expected; [`Scene::run`] for one of them.
//! - [`oracle`], [`inputs`]: what the scenes are judged by and made of, for tests of your own.
//!
//! # What is judged
//!
//! Coverage by the rule of Direct3D, Vulkan and OpenGL with 8 sub-pixel bits: vertices go to the nearest 1/256 pixel,
//! and a pixel belongs to a triangle if its sample is inside, or on a top or left edge. Nearly all vertices lie on
//! that grid already, so that a method without a snap is not judged by it; where they do not, a pixel may differ
//! whose sample lies within √2/512 pixel of a true edge. [`Abilities`] say what does not concern a method.
//!
//! A panic while drawing is caught and becomes a verdict; its message is not shown. A rasteriser that never comes
//! back is not stopped: nothing in the standard library could.
//!
//! # Example
//!
//! A rasteriser that leaves everything black passes only where nothing is to be seen:
//!
//! ```
//! use polosa_stability::{Drawn, Job, Rasteriser, run};
//!
//! struct Black;
//!
//! impl Rasteriser for Black {
//!     fn draw(&mut self, job: &Job<'_>) -> Drawn {
//!         Drawn { ids: vec![0; job.pixels()], depth: None }
//!     }
//! }
//!
//! let report = run(&mut Black);
//! assert!(!report.passed());
//! println!("{report}");
//! ```
#![forbid(unsafe_code)]

pub mod inputs;
pub mod oracle;

mod judge;
mod quiet;
mod report;
mod scenes;
mod table;

pub use report::{Report, Verdict};
pub use scenes::{Scene, scenes};
pub use table::{Row, Table};

/// What is to be drawn: a picture of `width` × `height` pixels, cleared first.
///
/// Pixels are numbered row by row from the top left; their samples are at their centres unless
/// [`Abilities::sample`] says otherwise. Triangles are drawn whichever side they show.
#[derive(Clone, Copy, Debug)]
pub struct Job<'a> {
    /// Pixels in a row: 1 to 4096, nearly always a power of two.
    pub width: u32,
    /// Rows: 1 to 2048, nearly always a power of two.
    pub height: u32,
    /// x, y, z, w in clip space: x right, y up, reversed z; visible where 0 ≤ z ≤ w, and nearer where z/w is larger.
    pub vertices: &'a [[f32; 4]],
    /// Indices of three vertices each; all of them exist.
    pub triangles: &'a [[u32; 3]],
}

impl Job<'_> {
    /// The number of pixels.
    #[must_use]
    pub const fn pixels(&self) -> usize {
        self.width as usize * self.height as usize
    }
}

/// What came out, a number per pixel, row by row from the top left.
#[derive(Clone, Debug, PartialEq)]
pub struct Drawn {
    /// 0 where nothing is seen, else 1 + the index of the triangle that is. What is missing counts as wrong.
    pub ids: Vec<u32>,
    /// z/w of what is seen, larger is nearer; read only where something is. `None`: scenes that judge it find nothing
    /// wrong with it, and if with nothing else either, end as [`Verdict::NotAsked`].
    pub depth: Option<Vec<f32>>,
}

/// What a rasteriser claims, so that scenes that do not concern it are not asked ([`Verdict::NotAsked`]).
///
/// That it has a depth is not claimed here but shown: by [`Drawn::depth`].
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Abilities {
    /// Triangles are cut off where they leave 0 ≤ z ≤ w, so that vertices may lie behind the eye.
    pub clips: bool,
    /// Of several triangles at a pixel the nearest is seen.
    pub hides: bool,
    /// Samples on a top or left edge are in, on others out. `false`: some other rule; then such pixels may go
    /// either way in triangles drawn alone, and still exactly one of two neighbours must have them.
    pub top_left: bool,
    /// Where a pixel is sampled, in 1/256 px from its top left corner.
    pub sample: [u8; 2],
}

impl Default for Abilities {
    /// All of them, sampled at the centre.
    fn default() -> Self {
        Self { clips: true, hides: true, top_left: true, sample: [128, 128] }
    }
}

/// What is put to the test.
pub trait Rasteriser {
    /// Draws the triangles of a job into a picture of its own.
    fn draw(&mut self, job: &Job<'_>) -> Drawn;

    /// What this rasteriser claims to be able to do: everything, unless it says otherwise.
    fn abilities(&self) -> Abilities {
        Abilities::default()
    }
}

/// Runs all scenes. After a panic it goes on with the next scene and the same rasteriser.
pub fn run(rasteriser: &mut dyn Rasteriser) -> Report {
    Report::new(scenes().iter().map(|scene| (*scene, scene.run(rasteriser))))
}

/// The example of the README is a test, too.
#[cfg(doctest)]
#[doc = include_str!("../README.md")]
struct Readme;
