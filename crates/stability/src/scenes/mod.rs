//! The scenes: what is drawn, and what must come out.

mod clipping;
mod coverage;
mod depth;
mod hidden;
mod lattice;
mod meshes;
mod motion;
mod numbers;

use core::fmt;

use self::Needs::{Clipping, Hiding, Nothing};
use crate::judge::{Judge, Outcome, Stop};
use crate::{Rasteriser, Verdict};

/// Something to draw, and what is expected of it.
///
/// Several scenes may share a number; names are different. Numbers 18 to 21 are free: they belong to attributes,
/// shades and shapes, which are no business of a rasteriser ([`Table::set`](crate::Table::set) adds rows for them).
#[derive(Clone, Copy)]
pub struct Scene {
    /// Its number, by which tables are sorted.
    pub number: u32,
    /// Its name, a few words.
    pub name: &'static str,
    /// What must come out.
    pub expected: &'static str,
    needs: Needs,
    check: fn(&mut Judge<'_>) -> Outcome,
}

/// What a rasteriser must be able to do for a scene to concern it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Needs {
    Nothing,
    Clipping,
    Hiding,
}

impl Scene {
    /// Puts a rasteriser to this test.
    pub fn run(&self, rasteriser: &mut dyn Rasteriser) -> Verdict {
        let mut judge = Judge::new(rasteriser);
        let concerns = match self.needs {
            Nothing => true,
            Clipping => judge.abilities.clips,
            Hiding => judge.abilities.hides,
        };
        let outcome = if concerns { (self.check)(&mut judge) } else { Err(Stop::NotAsked) };
        judge.verdict(outcome)
    }
}

impl fmt::Debug for Scene {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "Scene({}, {:?})", self.number, self.name)
    }
}

impl PartialEq for Scene {
    fn eq(&self, other: &Self) -> bool {
        (self.number, self.name) == (other.number, other.name)
    }
}

impl Eq for Scene {}

const fn scene(
    number: u32,
    name: &'static str,
    expected: &'static str,
    needs: Needs,
    check: fn(&mut Judge<'_>) -> Outcome,
) -> Scene {
    Scene { number, name, expected, needs, check }
}

const NEAR_EDGES: &str = "differs from the true triangle only within √2/512 px of an edge";

static SCENES: &[Scene] = &[
    scene(1, "quad cut through pixel centres", "36 px, each once", Nothing, coverage::quad),
    scene(2, "collinear triangle", "no pixel", Nothing, coverage::collinear),
    scene(3, "micro-triangles, every tie", "the half-planes' pixels", Nothing, lattice::micro),
    scene(4, "mesh on pixel centres", "each pixel once", Nothing, meshes::on_centres),
    scene(5, "fan, R = 400 px", "each pixel once", Nothing, meshes::fan_400),
    scene(5, "fan, R = 16,000 px", "each pixel once", Nothing, meshes::fan_16_000),
    scene(5, "fan, R = 1,000,000 px", "each pixel once", Nothing, meshes::fan_1_000_000),
    scene(6, "sliver, 1000 × 1/256 px", "the half-planes' pixels", Nothing, depth::slivers),
    scene(6, "depth of such slivers", "depth ≤ 5·2⁻²⁴", Nothing, depth::sliver_depths),
    scene(7, "quads, straight and turned", "each pixel once", Nothing, coverage::quads),
    scene(8, "turned quads beyond the viewport", "each pixel once", Nothing, clipping::full),
    scene(9, "projected quad, w 0.1 to 4", "each pixel once", Nothing, clipping::projected),
    scene(10, "up to ±32,767 px", "the half-planes' pixels", Nothing, coverage::guard),
    scene(10, "beyond ±32,767 px", NEAR_EDGES, Nothing, clipping::beyond),
    scene(11, "floor through the near plane", NEAR_EDGES, Clipping, clipping::floor),
    scene(12, "1, 2 or 3 vertices clipped", NEAR_EDGES, Clipping, clipping::vertices),
    scene(
        13,
        "edge clipped from both sides",
        "no pixel missed or drawn twice",
        Clipping,
        clipping::both_sides,
    ),
    scene(14, "depth (10, 0, 0) through 3", "they change places at 0.3", Hiding, hidden::switch),
    scene(15, "doubled triangles, shuffled", "always the same of the two", Hiding, hidden::doubled),
    scene(16, "floors 1e-3 to 1e-6 apart", "none swaps, none ties", Hiding, hidden::nested),
    scene(17, "2 px triangles at (4000, 2000)", "depth ≤ 5·2⁻²⁴", Nothing, depth::far_off),
    scene(22, "NaN and infinity", "no pixel", Nothing, numbers::not_finite),
    scene(22, "−0 and denormals", "ordinary numbers", Nothing, numbers::ordinary),
    scene(22, "w of 0 or less", "no pixel", Clipping, numbers::behind),
    scene(23, "first vertex, winding, twice", "the same picture", Nothing, motion::orders),
    scene(24, "slivers between pixel centres", "no pixel", Nothing, lattice::between),
    scene(25, "slow motion, 1/16 px a step", "the half-planes' pixels", Nothing, motion::slow),
    scene(26, "random triangles, ten classes", "the half-planes' pixels", Nothing, coverage::classes),
    scene(27, "10,082 triangles finer than pixels", "each pixel once", Nothing, meshes::fine),
    scene(28, "vertices finer than 1/256 px", NEAR_EDGES, Nothing, coverage::unsnapped),
    scene(29, "mesh finer than 1/256 px", "each pixel once", Nothing, meshes::unsnapped),
    scene(30, "up to the largest number", "each pixel once", Nothing, clipping::largest),
    scene(31, "fan whose rim is behind the eye", "each pixel once", Clipping, clipping::rim),
    scene(32, "cyclic overlap", "the nearest at each pixel", Hiding, hidden::cycle),
    scene(33, "parallel planes", "the nearer one", Hiding, hidden::parallel),
    scene(34, "a soup of triangles", "the nearest at each pixel", Hiding, hidden::soup),
    scene(35, "depth of steep floors", "depth ≤ 5·2⁻²⁴", Nothing, depth::steep),
    scene(36, "pictures 1 px wide, and empty ones", "the half-planes' pixels", Nothing, coverage::narrow),
];

/// All scenes, sorted by number.
#[must_use]
pub fn scenes() -> &'static [Scene] {
    SCENES
}
