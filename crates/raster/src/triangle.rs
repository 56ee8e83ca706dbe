//! A triangle on the sub-pixel grid: sorted, its area and facing exact.

use crate::Corner;
use crate::snap::GUARD;

/// Which side of a triangle the viewer sees.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Facing {
    /// Its vertices run counter-clockwise on the screen.
    Front,
    /// Its vertices run clockwise on the screen.
    Back,
}

/// A triangle that covers an area, its corners sorted from top to bottom, then from left to right.
///
/// ```text
///          0 ●                 0 ●
///           ╱ ╲                 ╱ ╲          corner 1 lies right (left) of the side 0–2:
///          ╱   ● 1           1 ●   ╲         `middle_right` says which
///         ╱  ╱                  ╲   ╲
///      2 ●                        ╲  ╲ 2
/// ```
///
/// # Guarantees
///
/// The area is positive; corners stay inside the guard band, so that no product below overflows an `i64`.
/// Neither the order in which the vertices are given nor their winding changes anything but
/// [`facing`](Self::facing).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Triangle {
    corners: [Corner; 3],
    /// The place of each sorted corner among the given ones.
    given: [u8; 3],
    area: i64,
    middle_right: bool,
    facing: Facing,
}

impl Triangle {
    /// Sorts three corners; `None` when they lie on one line, or when one is no vertex that could be drawn: more
    /// than 2²³ − 2 sub-pixels (32,768 pixels) off, depth not from 0 to 1, w not positive and finite.
    ///
    /// ```
    /// use polosa_raster::{Corner, Facing, Rect, Sample, Triangle};
    ///
    /// let corner = |x: i32, y: i32, z| Corner { x: 256 * x, y: 256 * y, z, w: 1.0 };
    /// let triangle = Triangle::new([corner(0, 0, 0.0), corner(0, 4, 1.0), corner(4, 0, 0.0)]).unwrap();
    /// assert_eq!(triangle.facing(), Facing::Front);
    ///
    /// let clip = Rect { x0: 0, y0: 0, x1: 8, y1: 8 };
    /// let pixels: u32 = triangle.strips(Sample::CENTER, clip).map(|strip| strip.x1 - strip.x0).sum();
    /// assert_eq!(pixels, 3 + 2 + 1);
    /// assert_eq!(triangle.depth(Sample::CENTER).at(0, 2), 0.625);
    /// assert_eq!(triangle.weights(Sample::CENTER, None).at(0, 2), [0.25, 0.625, 0.125]);
    /// ```
    #[must_use]
    pub fn new(corners: [Corner; 3]) -> Option<Self> {
        let can_be_drawn = |corner: &Corner| {
            let on_grid = [corner.x, corner.y].iter().all(|v| (-GUARD..=GUARD).contains(v));
            on_grid && (0.0..=1.0).contains(&corner.z) && corner.w > 0.0 && corner.w.is_finite()
        };
        if corners.iter().all(can_be_drawn) { Self::sorted(corners) } else { None }
    }

    /// Sorts three corners that snapping made; `None` when they lie on one line.
    #[inline]
    pub(crate) fn sorted(given: [Corner; 3]) -> Option<Self> {
        let mut order: [u8; 3] = [0, 1, 2];
        let mut corners = given;
        let mut odd = false;
        // Three exchanges sort three corners; each turns the winding over.
        for (i, j) in [(0, 1), (1, 2), (0, 1)] {
            let (a, b) = (&corners[i], &corners[j]);
            if (b.y, b.x) < (a.y, a.x) {
                corners.swap(i, j);
                order.swap(i, j);
                odd = !odd;
            }
        }
        let [a, b, c] = corners;
        let area = cross(&a, &b, &c);
        // Positive: clockwise as seen with y down, which is corner 1 to the right of the side 0–2.
        let middle_right = area > 0;
        let facing = if middle_right == odd { Facing::Front } else { Facing::Back };
        (area != 0).then_some(Self { corners, given: order, area: area.abs(), middle_right, facing })
    }

    /// The corners, sorted by y, then x.
    #[must_use]
    pub const fn corners(&self) -> &[Corner; 3] {
        &self.corners
    }

    /// For each sorted corner, its place among the vertices as they were given: 0, 1 or 2.
    #[must_use]
    pub const fn given(&self) -> [u8; 3] {
        self.given
    }

    /// Twice the area, in sub-pixels squared; positive.
    #[must_use]
    pub const fn area(&self) -> i64 {
        self.area
    }

    /// The side that the viewer sees.
    #[must_use]
    pub const fn facing(&self) -> Facing {
        self.facing
    }

    /// Whether corner 1 lies to the right of the side from corner 0 to corner 2.
    #[must_use]
    pub const fn middle_right(&self) -> bool {
        self.middle_right
    }
}

/// Twice the signed area of three corners: positive clockwise on the screen, whose y runs down.
#[inline]
pub(crate) fn cross(a: &Corner, b: &Corner, c: &Corner) -> i64 {
    let [bx, by, cx, cy] = [b.x - a.x, b.y - a.y, c.x - a.x, c.y - a.y].map(i64::from);
    bx * cy - by * cx
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn order_and_winding_change_the_facing_alone() {
        let corner = |x, y| Corner { x, y, z: 0.5, w: 1.0 };
        let [a, b, c] = [corner(0, 0), corner(10, 90), corner(70, 20)];
        let first = Triangle::new([a, b, c]).unwrap();
        assert_eq!(first.facing(), Facing::Front, "counter-clockwise with y up");
        for (turn, facing) in [
            ([b, c, a], Facing::Front),
            ([c, a, b], Facing::Front),
            ([a, c, b], Facing::Back),
            ([c, b, a], Facing::Back),
            ([b, a, c], Facing::Back),
        ] {
            let other = Triangle::new(turn).unwrap();
            assert_eq!(other.facing(), facing);
            assert_eq!(other.corners(), first.corners());
            assert_eq!((other.area(), other.middle_right()), (first.area(), first.middle_right()));
            assert_eq!(other.given().map(|k| turn[usize::from(k)]), *other.corners());
        }
        assert!(Triangle::new([corner(0, 0), corner(50, 50), corner(100, 100)]).is_none());
    }

    #[test]
    fn corners_that_no_drawing_makes_are_refused() {
        let good = Corner { x: 0, y: 0, z: 0.5, w: 1.0 };
        let others = [Corner { x: 100, ..good }, Corner { y: 100, ..good }];
        let with = |corner| Triangle::new([corner, others[0], others[1]]);
        assert!(with(good).is_some() && with(Corner { x: -GUARD, ..good }).is_some());
        for bad in [
            Corner { x: GUARD + 1, ..good },
            Corner { y: i32::MIN, ..good },
            Corner { z: -0.1, ..good },
            Corner { z: f32::NAN, ..good },
            Corner { w: 0.0, ..good },
            Corner { w: f64::INFINITY, ..good },
        ] {
            assert!(with(bad).is_none(), "{bad:?}");
        }
    }
}
