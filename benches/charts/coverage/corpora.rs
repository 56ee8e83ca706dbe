//! The triangles of which wrong pixels are counted: five kinds, of any size, each with its own way to be wrong.
//!
//! ```text
//!   random    pixel-centre   guard-band            sliver          mesh
//!     ▲          •──•        ═══════════▶          ────────╱       ┌╱┌╱┐
//!    ╱ ╲         │ ╱         to 32,767 px          area /100 px    ├╱├╱┤  its sides are shared
//!   ╱___╲        •           off the picture       thick           └─┴─┘
//! ```

use polosa_stability::inputs::circle::{part, rational, turn, turns};
use polosa_stability::inputs::classes::GUARD;
use polosa_stability::inputs::mesh::grid;
use polosa_stability::inputs::rng::Rng;
use polosa_stability::oracle::coverage::{Vertex, area2};

use crate::measure::Effort;

/// The picture in which wrong pixels are counted: width and height.
pub(crate) const SIZE: [u32; 2] = [1024, 512];

/// A triangle in 1/256 px.
pub(crate) type Corners = [Vertex; 3];

/// Triangles of one kind.
#[derive(Clone, Debug)]
pub(crate) struct Triangles {
    pub(crate) corners: Vec<Corners>,
    /// Whether they share their sides.
    pub(crate) mesh: bool,
}

/// A kind of triangles.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Corpus {
    Random,
    PixelCentre,
    GuardBand,
    Sliver,
    Mesh,
}

impl Corpus {
    pub(crate) const ALL: [Self; 5] =
        [Self::Random, Self::PixelCentre, Self::GuardBand, Self::Sliver, Self::Mesh];

    pub(crate) const fn name(self) -> &'static str {
        match self {
            Self::Random => "random",
            Self::PixelCentre => "pixel-centre",
            Self::GuardBand => "guard-band",
            Self::Sliver => "sliver",
            Self::Mesh => "mesh",
        }
    }

    /// Triangles of about `area` pixels; of those in the guard band, so much is in the picture.
    pub(crate) fn triangles(self, area: u32, effort: Effort) -> Triangles {
        let mut r = Rng::new(u64::from(area) * 8 + self as u64);
        let [width, height] = SIZE.map(|side| 256 * i64::from(side));
        if self == Self::Mesh {
            return Triangles { corners: mesh(area, effort, &mut r), mesh: true };
        }
        // As many as cover so many pixels, but where boxes are much larger than triangles not so many.
        let pixels = match self {
            Self::Sliver | Self::GuardBand => effort.either(4_000, 200_000),
            _ => effort.either(20_000, 1_000_000),
        };
        let count = (pixels / area).clamp(effort.either(4, 16), effort.either(400, 6_000));
        let mut one = || {
            let place = [r.range(0, width), r.range(0, height)];
            match self {
                Self::Random => random(&mut r, area.into(), place),
                Self::PixelCentre => {
                    let t = random(&mut r, area.into(), place);
                    t.map(|v| v.map(|c| c.div_euclid(256) * 256 + 128))
                }
                Self::GuardBand => guard_band(&mut r, area.into(), place),
                _ => sliver(&mut r, area.into(), place),
            }
        };
        Triangles { corners: (0..count).map(|_| one()).collect(), mesh: false }
    }
}

/// A random direction, of length 1.
fn direction(r: &mut Rng) -> [f64; 2] {
    turn(turns(part(2), r.range(0, 3) as u32), rational(r.unit()))
}

/// The place, and so many pixels along a direction.
fn away(place: Vertex, pixels: f64, [x, y]: [f64; 2]) -> Vertex {
    [place[0] + (256.0 * pixels * x).round() as i64, place[1] + (256.0 * pixels * y).round() as i64]
}

/// Three points of a circle, not nearly on a line, scaled to the area.
pub(crate) fn random(r: &mut Rng, area: f64, place: Vertex) -> Corners {
    loop {
        let points = [(); 3].map(|()| {
            let ([x, y], length) = (direction(r), r.real(0.3, 1.0));
            [length * x, length * y]
        });
        let [[ax, ay], [bx, by], [cx, cy]] = points;
        let found = ((bx - ax) * (cy - ay) - (by - ay) * (cx - ax)).abs() / 2.0;
        if found > 0.2 {
            return points.map(|point| away(place, (area / found).sqrt(), point));
        }
    }
}

/// Up to a thousand pixels long, and as thick as the area asks for: a hundredth of that, or less.
pub(crate) fn sliver(r: &mut Rng, area: f64, place: Vertex) -> Corners {
    let length = (200.0 * area).sqrt().min(1_000.0);
    let ([x, y], share) = (direction(r), r.real(0.0, 1.0));
    let near = away(place, -length / 2.0, [x, y]);
    let beside = away(place, length * (share - 0.5), [x, y]);
    [near, away(place, length / 2.0, [x, y]), away(beside, 2.0 * area / length, [-y, x])]
}

/// One corner as far away as a corner may be, the others beside the place: what shows is a band.
fn guard_band(r: &mut Rng, area: f64, place: Vertex) -> Corners {
    let [x, y] = direction(r);
    // A band is about half of the picture long.
    let thick = (area / 500.0).max(1.0 / 64.0);
    let far = away(place, 32_000.0, [x, y]).map(|c| c.clamp(-GUARD, GUARD));
    [away(place, thick / 2.0, [-y, x]), away(place, -thick / 2.0, [-y, x]), far]
}

/// Two sheets of triangles of that area, over the picture if they are not tiny: corners anywhere, and on centres.
fn mesh(area: u32, effort: Effort, r: &mut Rng) -> Vec<Corners> {
    // Two triangles a cell; whole pixels, so that the second sheet's corners are centres.
    let cell = f64::from(2 * area).sqrt().round() as i64;
    // So many cells across the whole picture; where they are small, a part of it is enough.
    let reach = i64::from(SIZE[0]) + 2 * cell;
    let cells = (reach / cell + 1).min(effort.either(32, 200));
    let low = [-cell * 256 + 128, -cell * 256 + 128];
    let high = low.map(|c| c + cells * cell * 256);
    let mut corners = Vec::new();
    for grain in [1, 256] {
        let most = cell * 256 / 4 / grain;
        let sheet = grid(low, high, cells, |[x, y]| {
            [x + r.range(-most, most) * grain, y + r.range(-most, most) * grain]
        });
        let triangles = sheet.triangles.iter().map(|t| t.map(|index| sheet.vertices[index as usize]));
        corners.extend(triangles.filter(|t| area2(t) != 0));
    }
    corners
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn triangles_have_the_area_that_is_asked_for() {
        for area in [50, 512, 5_000] {
            for corpus in [Corpus::Random, Corpus::Sliver, Corpus::Mesh] {
                let triangles = corpus.triangles(area, Effort::Quick).corners;
                let sum: f64 = triangles.iter().map(|t| area2(t).unsigned_abs() as f64 / 131_072.0).sum();
                let mean = sum / triangles.len() as f64;
                assert!((mean / f64::from(area) - 1.0).abs() < 0.1, "{corpus:?} {area}: {mean}");
            }
        }
    }

    #[test]
    fn corners_stay_in_the_guard_band_and_those_on_centres_are_there() {
        for area in [2, 80_000] {
            for corpus in Corpus::ALL {
                let triangles = corpus.triangles(area, Effort::Quick).corners;
                assert!(triangles.as_flattened().as_flattened().iter().all(|c| c.abs() <= GUARD));
                let centres = |t: &Corners| t.as_flattened().iter().all(|c| c.rem_euclid(256) == 128);
                assert!(corpus != Corpus::PixelCentre || triangles.iter().all(centres));
            }
        }
    }
}
