//! Points of a circle without a sine: complex numbers of length 1, doubled and halved by + − × ÷ √ alone, so that a
//! scene is the same to the last bit on every machine.

/// cos and sin of the angle that is half of that of `[c, s]`; both not negative.
fn half([c, s]: [f64; 2]) -> [f64; 2] {
    // cos²(α/2) = (1 + cos α)/2, sin(α/2) = sin α / (2·cos(α/2))
    let cos = (0.5 * (1.0 + c)).sqrt();
    [cos, s / (2.0 * cos)]
}

/// The product of two complex numbers: angles add.
#[must_use]
pub fn turn([a, b]: [f64; 2], [c, d]: [f64; 2]) -> [f64; 2] {
    [a * c - b * d, a * d + b * c]
}

/// cos and sin of 1/2ⁿ of a full turn, for n = `halvings`.
#[must_use]
pub fn part(halvings: u32) -> [f64; 2] {
    match halvings {
        0 => [1.0, 0.0],
        1 => [-1.0, 0.0],
        2 => [0.0, 1.0],
        _ => (2..halvings).fold([0.0, 1.0], |angle, _| half(angle)),
    }
}

/// `steps` times the angle `[c, s]`.
#[must_use]
pub fn turns(angle: [f64; 2], steps: u32) -> [f64; 2] {
    (0..steps).fold([1.0, 0.0], |sum, _| turn(sum, angle))
}

/// The point of the circle at the angle whose half has the tangent `t`.
///
/// (1 − t², 2t) / (1 + t²): all of the circle for t from −∞ to ∞, the quarter from east to north for 0 to 1.
#[must_use]
pub fn rational(t: f64) -> [f64; 2] {
    let d = 1.0 + t * t;
    [(1.0 - t * t) / d, 2.0 * t / d]
}

#[cfg(test)]
mod tests {
    use super::{part, rational, turns};

    #[test]
    fn points_are_those_of_sine_and_cosine() {
        for (halvings, steps) in [(3, 5), (6, 63), (6, 17), (0, 3), (1, 1), (2, 3)] {
            let angle = std::f64::consts::TAU * f64::from(steps) / f64::from(1_u32 << halvings);
            let [c, s] = turns(part(halvings), steps);
            assert!(
                (c - angle.cos()).abs() + (s - angle.sin()).abs() < 1e-13,
                "{steps}/2^{halvings}: {c}, {s}"
            );
        }
        assert_eq!(rational(1.0), [0.0, 1.0]);
    }
}
