//! What a closed surface hides behind itself, known before anything is drawn.
//!
//! It is tempting to leave out the back faces of a closed mesh. That changes pixels: beside an outline, and where walls
//! are thin, snapping to the sub-pixel grid moves what is behind by as much as what is before it, so that a back face
//! can be the nearest at a sample (one pixel in a million on a plain box; thousands where a wall is thinner than 1/256
//! pixel, and a whole lobe where a mesh passes through itself). So nothing here looks at facing. Instead, once a
//! mesh, a few *balls* are found that lie wholly inside it; and once a view, what lies in their shadow is left out.
//!
//! ```text
//!            surface                       · a vertex counts as hidden by a ball when it lies in the ball's
//!         ╭───────────╮                      shadow, farther than its centre;
//!        ╱    ╭───╮┄┄┄┄╲┄┄┄┄┄┄┄┄┄          · a triangle is hidden when one ball hides all of its corners:
//!   eye │    │  c  │    │  shadow            on the screen the shadow is an ellipse, and convex.
//!        ╲    ╰───╯┄┄┄┄╱┄┄┄┄┄┄┄┄┄
//!         ╰───────────╯
//! ```
//!
//! # Why no pixel changes
//!
//! Let the triangles close as a whole (each edge is run along as often one way as the other), and let no clip plane
//! touch the mesh. Then each point off the surface has a winding number, and along the line from a point to the
//! viewer the triangles crossed, counted by the side that they show, sum to that number.
//!
//! 1. *What is drawn is the surface, moved a little.* On the screen, depth included, a projected triangle is flat,
//!    and its snapped image has each point moved by the mean of its corners' movements: at most e = ½ + η sub-pixels
//!    along x and y and ζ in depth, where η and ζ bound the rounding of the transform. This holds for triangles that
//!    snapping turns over or flattens, too.
//! 2. Take a sample S inside the ellipse of the shadow, and X, the point seen there at the depth of the ball's centre.
//!    The surface on its way from the true place to the snapped one does not pass through X, if no part of the true
//!    surface is within (e, e, ζ) of X, for which it is enough that X is deeper inside the ball than δ, the length of
//!    that in space. So the drawn surface has the same winding number around X as the true one around the ball.
//! 3. That number is not 0. So a drawn triangle covers S before X. The fill rule agrees: it is what one sees when S is
//!    moved by infinitely little, to the same side for all triangles, and adjacent ones share sides exactly.
//! 4. That triangle's depth at S, as computed, is at least z(X)·(1 − 5·2⁻²⁴). A hidden triangle's depth is, as
//!    computed, at most that of its nearest corner (the depth formula clamps it), and this is less: strictly, so that
//!    no tie is decided otherwise. The hidden triangle loses at S, in whatever order the two are drawn.
//! 5. The nearest triangle at S is never hidden, or 2 to 4 would show a nearer one. So all that is seen is drawn, and
//!    nothing that is not seen matters.
//!
//! Neither orientation nor freedom from self-crossings is needed, nor thickness: where there is no room for a ball
//! nothing is hidden. It holds for two-sided drawing with an `f32` depth buffer and [`DepthTest::Greater`], for
//! every sample position and every scissor, and for what else is in the buffer already.
//!
//! [`DepthTest::Greater`]: polosa_raster::DepthTest::Greater

mod distance;
mod grid;
mod shadow;

pub use shadow::Shadows;

use polosa_math::glam::DVec3;

use crate::Mesh;
use crate::topology::closes;
use distance::{clearance, winding};

/// At most so many balls, a bit of a byte each. More would hide little more: the first few are the largest.
pub(crate) const MOST: usize = 8;

/// A ball that holds no part of the surface, where its winding number is not 0.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Ball {
    /// In the mesh's coordinates.
    pub center: DVec3,
    /// Positive.
    pub radius: f64,
}

/// Balls inside a mesh; none if it is not closed, or has no room for them.
///
/// ```
/// use polosa_scene::occluder::Occluders;
/// use polosa_scene::shape;
///
/// let balls = Occluders::of(&shape::cube()).balls().to_vec();
/// assert!(balls[0].center.length() < 1e-9 && (0.999..1.0).contains(&balls[0].radius));
/// ```
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Occluders {
    balls: Vec<Ball>,
}

impl Occluders {
    /// Looks for room inside a mesh. Time grows with its triangles; it is about that of drawing some tens of frames,
    /// so do it once, for what is drawn often.
    #[must_use]
    pub fn of(mesh: &Mesh) -> Self {
        let mut balls: Vec<Ball> = Vec::new();
        if mesh.triangles().len() < WORTH_IT || !closes(mesh) {
            return Self { balls };
        }
        // The grid proposes; what is sound is decided by the triangles themselves.
        let mut tried = 0;
        let mut windings: Vec<(usize, bool)> = Vec::new();
        for candidate in grid::candidates(mesh) {
            if balls.len() == MOST || tried == 4 * MOST {
                break;
            }
            let center = candidate.center;
            if balls.iter().any(|ball| ball.center.distance(center) < 0.8 * ball.radius) {
                continue;
            }
            tried += 1;
            let known = windings.iter().find(|(room, _)| *room == candidate.room).map(|&(_, inside)| inside);
            let inside = known.unwrap_or_else(|| {
                let inside = winding(mesh, center) != 0;
                windings.push((candidate.room, inside));
                inside
            });
            let radius = if inside { clearance(mesh, center) } else { 0.0 };
            let largest = balls.first().map_or(radius, |ball| ball.radius);
            if radius > 0.0 && radius >= WORTH_ASKING * largest {
                balls.push(Ball { center, radius });
            }
        }
        Self { balls }
    }

    /// The balls, at most 8; the larger ones first, as far as a coarse grid can tell.
    #[must_use]
    pub fn balls(&self) -> &[Ball] {
        &self.balls
    }
}

/// Smaller balls hide less than it costs to ask about them; this one a tenth of what the largest does.
const WORTH_ASKING: f64 = 0.3;

/// Meshes of fewer triangles are drawn faster than they are looked at.
const WORTH_IT: usize = 12;
