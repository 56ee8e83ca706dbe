//! Perspective-correct weights: how much each vertex of a triangle counts at a pixel.
//!
//! An attribute is linear in clip space, not on the screen. With the edge functions E as weights on the
//! screen, those in clip space are `E/w`, divided by their sum (Blinn, *Hyperbolic Interpolation*, 1992). No
//! term is negative, so nothing cancels; the division is a true one, at every pixel.

use crate::edge::{Edge, PixelEdge};
use crate::{Sample, Triangle};

/// A triangle's weights at every pixel it covers.
#[derive(Clone, Copy, Debug)]
pub struct Weights {
    edges: [PixelEdge; 3],
    /// 1/w of each sorted corner, times the least w: at most 1.
    inverse_w: [f32; 3],
    given: [u8; 3],
    clip: Option<[[f32; 3]; 3]>,
}

impl Triangle {
    /// The weights of the triangle's vertices at the sample of each pixel.
    ///
    /// For a piece of a clipped triangle, `clip` holds for each of the piece's vertices, as they were given,
    /// the weights of the whole triangle's; the result is then the whole triangle's weights.
    #[inline]
    #[must_use]
    pub fn weights(&self, sample: Sample, clip: Option<&[[f32; 3]; 3]>) -> Weights {
        let w = self.corners().map(|corner| corner.w);
        let least = w[0].min(w[1]).min(w[2]);
        Weights {
            edges: [0, 1, 2].map(|k| Edge::opposite(self, k).at_pixels(sample)),
            inverse_w: w.map(|w| ratio(least, w)),
            given: self.given(),
            clip: clip.copied(),
        }
    }
}

/// Kept above 2⁻¹⁰⁰, far below what any sum can show, so that no pixel's weights are all zero.
#[inline]
#[expect(clippy::cast_possible_truncation, reason = "the one rounding of 1/w")]
fn ratio(least: f64, w: f64) -> f32 {
    const LEAST: f32 = f32::from_bits((127 - 100) << 23);
    ((least / w) as f32).max(LEAST)
}

impl Weights {
    /// The three vertices' weights at a pixel that the triangle covers, as the vertices were given. They are
    /// from 0 to 1 and add up to 1, each to within a few units of 2⁻²⁴.
    #[inline]
    #[must_use]
    #[expect(clippy::cast_precision_loss, reason = "correctly rounded, a half of 2⁻²⁴")]
    pub fn at(&self, x: u32, y: u32) -> [f32; 3] {
        let mut n = [0.0; 3];
        for (n, (edge, inverse_w)) in n.iter_mut().zip(self.edges.iter().zip(self.inverse_w)) {
            *n = edge.whole(x, y) as f32 * inverse_w;
        }
        // Summed as sorted, so that turning the vertices over changes nothing.
        let sum = (n[0] + n[1]) + n[2];
        let sorted = n.map(|n| n / sum);
        let mut weights = [0.0; 3];
        match &self.clip {
            None => {
                for (weight, given) in sorted.into_iter().zip(self.given) {
                    weights[usize::from(given)] = weight;
                }
            }
            Some(clip) => {
                let clip = self.given.map(|given| clip[usize::from(given)]);
                for (k, weight) in weights.iter_mut().enumerate() {
                    *weight = (sorted[0] * clip[0][k] + sorted[1] * clip[1][k]) + sorted[2] * clip[2][k];
                }
            }
        }
        weights
    }
}
