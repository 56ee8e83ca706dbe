//! The Bézier patches of the Utah teapot.
//!
//! Martin Newell's data set of 1975 lists 306 control points for 32 bicubic patches. 290 of them are different
//! and in use (the rim of the bottom is listed twice, four points belong to no patch), and they are far from
//! independent: the pot, its bottom and its lid are four equal quarters around the axis, the handle and the
//! spout two mirrored halves. This file holds what is left: profiles for the first three, one half of the other
//! two. Units and axes are Newell's: z up, 3.15 high.

/// Control points `patch[j][i]`, i along u and j along v. Seen from outside, u and v run so that ∂S/∂v × ∂S/∂u
/// points outward.
pub(super) type Patch = [[[f64; 3]; 4]; 4];

/// A ring of control points on which a quarter turn is (r, 0), (r, k), (k, r), (0, r) at the height z.
///
/// k/r is 0.56 (0.5625 at the lid's knob) where a circle would ask for 0.5523: the teapot is not quite round.
#[derive(Clone, Copy)]
struct Ring {
    r: f64,
    k: f64,
    z: f64,
}

const fn ring(r: f64, k: f64, z: f64) -> Ring {
    Ring { r, k, z }
}

/// Rim, body (upper, lower) and bottom, from the inside of the rim to the middle of the bottom; every third
/// ring belongs to two patches.
const POT: [Ring; 13] = [
    ring(1.4, 0.784, 2.4),
    ring(1.3375, 0.749, 2.53125),
    ring(1.4375, 0.805, 2.53125),
    ring(1.5, 0.84, 2.4),
    ring(1.75, 0.98, 1.875),
    ring(2.0, 1.12, 1.35),
    ring(2.0, 1.12, 0.9),
    ring(2.0, 1.12, 0.45),
    ring(1.5, 0.84, 0.225),
    ring(1.5, 0.84, 0.15),
    ring(1.5, 0.84, 0.075),
    ring(1.425, 0.798, 0.0),
    ring(0.0, 0.0, 0.0),
];

/// Knob and lid, from the top of the knob to the lid's rim.
const LID: [Ring; 7] = [
    ring(0.0, 0.0, 3.15),
    ring(0.8, 0.45, 3.15),
    ring(0.0, 0.0, 2.85),
    ring(0.2, 0.112, 2.7),
    ring(0.4, 0.224, 2.55),
    ring(1.3, 0.728, 2.55),
    ring(1.3, 0.728, 2.4),
];

/// A row across one half of a tube: points (x, −width, z), the first and the last in the plane y = 0.
#[derive(Clone, Copy)]
struct Row {
    first: [f64; 2],
    last: [f64; 2],
    width: f64,
}

const fn row(first: [f64; 2], last: [f64; 2], width: f64) -> Row {
    Row { first, last, width }
}

/// The handle, from its upper end to its lower; (x, z) of the inner and of the outer line.
const HANDLE: [Row; 7] = [
    row([-1.6, 2.025], [-1.5, 2.25], 0.3),
    row([-2.3, 2.025], [-2.5, 2.25], 0.3),
    row([-2.7, 2.025], [-3.0, 2.25], 0.3),
    row([-2.7, 1.8], [-3.0, 1.8], 0.3),
    row([-2.7, 1.575], [-3.0, 1.35], 0.3),
    row([-2.5, 1.125], [-2.65, 0.9375], 0.3),
    row([-2.0, 0.9], [-1.9, 0.6], 0.3),
];

/// The spout, from the pot to its mouth; (x, z) of the upper and of the lower line.
const SPOUT: [Row; 7] = [
    row([1.7, 1.425], [1.7, 0.6], 0.66),
    row([2.6, 1.425], [3.1, 0.825], 0.66),
    row([2.3, 2.1], [2.4, 2.025], 0.25),
    row([2.7, 2.4], [3.3, 2.4], 0.25),
    row([2.8, 2.475], [3.525, 2.49375], 0.25),
    row([2.9, 2.475], [3.45, 2.5125], 0.15),
    row([2.8, 2.4], [3.2, 2.4], 0.15),
];

/// The patches of the teapot's four parts: pot (16), lid (8), handle (4), spout (4). Patches of one part share
/// their borders, exactly; the parts do not touch by borders, but run into each other.
pub(super) fn parts() -> [Vec<Patch>; 4] {
    [turned(&POT), turned(&LID), mirrored(&HANDLE), mirrored(&SPOUT)]
}

/// Four quarters about the axis; four rings a patch, the last of which is the next one's first.
fn turned(profile: &[Ring]) -> Vec<Patch> {
    let mut patches = Vec::new();
    for rings in profile.windows(4).step_by(3) {
        for quarter in 0..4 {
            patches.push(std::array::from_fn(|j| {
                let Ring { r, k, z } = rings[j];
                [[r, 0.0], [r, k], [k, r], [0.0, r]].map(|[x, y]| match quarter {
                    0 => [x, y, z],
                    1 => [-y, x, z],
                    2 => [-x, -y, z],
                    _ => [y, -x, z],
                })
            }));
        }
    }
    patches
}

/// The half with y ≤ 0, and its mirror image, which runs the other way round.
fn mirrored(rows: &[Row]) -> Vec<Patch> {
    let mut patches = Vec::new();
    for rows in rows.windows(4).step_by(3) {
        for side in [-1.0, 1.0] {
            patches.push(std::array::from_fn(|j| {
                let Row { first: [x0, z0], last: [x3, z3], width } = rows[j];
                let y = side * width;
                let half = [[x0, 0.0, z0], [x0, y, z0], [x3, y, z3], [x3, 0.0, z3]];
                if side < 0.0 { [half[3], half[2], half[1], half[0]] } else { half }
            }));
        }
    }
    patches
}

#[cfg(test)]
mod tests {
    use super::{Patch, parts};

    fn key(p: [f64; 3]) -> [u64; 3] {
        p.map(|x| (x + 0.0).to_bits())
    }

    #[test]
    fn there_are_32_patches_over_newells_control_points() {
        let patches: Vec<Patch> = parts().concat();
        assert_eq!(patches.len(), 32);
        let mut points: Vec<_> = patches.as_flattened().as_flattened().iter().map(|&p| key(p)).collect();
        points.sort_unstable();
        points.dedup();
        // Of the 306 listed, 12 repeat the ring at z = 0.15 and 4 lie 0.002 beside the knob's top, unused.
        assert_eq!(points.len(), 306 - 12 - 4);
    }

    /// Every border of a patch is, point by point, either a border of exactly one other patch of its part, or
    /// shrunk to a pole, or one of those where the surface ends.
    #[test]
    fn patches_of_a_part_join_at_their_borders() {
        let open: [usize; 4] = parts().map(|patches| {
            let mut borders: Vec<[[u64; 3]; 4]> = Vec::new();
            for p in &patches {
                let column = |i: usize| [p[0][i], p[1][i], p[2][i], p[3][i]];
                for border in [p[0], p[3], column(0), column(3)] {
                    let border = border.map(key);
                    if border.iter().any(|point| *point != border[0]) {
                        let back = [border[3], border[2], border[1], border[0]];
                        borders.push(border.min(back));
                    }
                }
            }
            borders.sort_unstable();
            let same: Vec<usize> = borders.chunk_by(|a, b| a == b).map(<[_]>::len).collect();
            assert!(same.iter().all(|&n| n <= 2));
            same.iter().filter(|&&n| n == 1).count()
        });
        // The inside of the rim, the lid's rim, both ends of the handle, both ends of the spout.
        assert_eq!(open, [4, 4, 4, 4]);
    }

    /// Across every border the tangents of both patches are in line, so that one normal serves both.
    #[test]
    fn joins_are_smooth() {
        let mut joins = 0;
        for patches in parts() {
            let turned: Vec<Patch> =
                patches.iter().map(|p| std::array::from_fn(|i| std::array::from_fn(|j| p[j][i]))).collect();
            for patches in [patches, turned] {
                for (a, b) in patches.iter().flat_map(|a| patches.iter().map(move |b| (a, b))) {
                    if a[3].map(key) != b[0].map(key) || a[3].map(key) == [key(a[3][0]); 4] {
                        continue;
                    }
                    joins += 1;
                    for i in 0..4 {
                        let s = [0, 1, 2].map(|axis| a[3][i][axis] - a[2][i][axis]);
                        let t = [0, 1, 2].map(|axis| b[1][i][axis] - b[0][i][axis]);
                        let dot = |s: [f64; 3], t: [f64; 3]| s[0] * t[0] + s[1] * t[1] + s[2] * t[2];
                        let lengths = (dot(s, s) * dot(t, t)).sqrt();
                        // At the poles, and where the knob's control points meet, both are zero.
                        assert!(dot(s, t) >= 0.999_999 * lengths, "{s:?} {t:?}");
                        assert_eq!(dot(s, s) == 0.0, dot(t, t) == 0.0);
                    }
                }
            }
        }
        // Pot 3 × 4 rings and 4 × 4 meridians, lid 4 and 2 × 4, handle and spout 2 and 2 × 2 each.
        assert_eq!(joins, 12 + 16 + 4 + 8 + 2 * (2 + 4));
    }
}
