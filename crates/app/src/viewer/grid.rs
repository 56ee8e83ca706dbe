//! A grid on the floor below a model.

use polosa_math::Bounds;
use polosa_math::glam::DVec3;
use polosa_scene::{Mesh, MeshError};

use crate::view::Up;

/// Fields along the longer side: at least so many, and no more than five times as many.
const FEWEST: f64 = 6.0;

/// Lines one, two, five, ten, ... units apart, under all of the model and a field around it.
pub(super) fn grid(bounds: &Bounds, up: Up) -> Result<Mesh, MeshError> {
    let (low, high) = (upright(bounds.min(), up), upright(bounds.max(), up));
    // Turning may have exchanged the ends.
    let (low, high) = (low.min(high), low.max(high));
    let longer = (high.x - low.x).max(high.z - low.z).max((high.y - low.y) / 4.0);
    let step = spacing(longer);
    let from = |low: f64| (low / step).floor() - 1.0;
    let to = |high: f64| (high / step).ceil() + 1.0;
    let (x0, x1, z0, z1) = (from(low.x), to(high.x), from(low.z), to(high.z));
    let mut positions = Vec::new();
    let mut line = |a: [f64; 2], b: [f64; 2]| {
        for [x, z] in [a, b] {
            let point = up.turned(DVec3::new(x * step, low.y, z * step));
            positions.push(point.as_vec3().to_array());
        }
    };
    (0..=(x1 - x0) as u32).for_each(|k| line([x0 + f64::from(k), z0], [x0 + f64::from(k), z1]));
    (0..=(z1 - z0) as u32).for_each(|k| line([x0, z0 + f64::from(k)], [x1, z0 + f64::from(k)]));
    let edges = (0..positions.len() as u32 / 2).map(|k| [2 * k, 2 * k + 1]).collect();
    Mesh::new(positions, Vec::new())?.with_edges(edges)
}

/// A vector in axes in which +Y is upward: the inverse of [`Up::turned`].
fn upright(v: DVec3, up: Up) -> DVec3 {
    // Turning keeps lengths and angles, so that its inverse takes each part along a turned axis.
    let [x, y, z] = DVec3::AXES.map(|axis| v.dot(up.turned(axis)));
    DVec3::new(x, y, z)
}

/// One, two or five times a power of ten, so that `length` has 6 to 30 of it.
fn spacing(length: f64) -> f64 {
    if !(length > 0.0 && length.is_finite()) {
        return 1.0;
    }
    let power = libm::pow(10.0, libm::floor(libm::log10(length / FEWEST)));
    let fits = |factor: &f64| length / (power * factor) >= FEWEST;
    let factor = [5.0, 2.0].into_iter().find(fits).unwrap_or(1.0);
    power * factor
}

#[cfg(test)]
mod tests {
    use polosa_math::Bounds;
    use polosa_math::glam::DVec3;

    use super::{grid, spacing, upright};
    use crate::view::Up;

    #[test]
    fn any_length_has_a_handy_number_of_fields() {
        for length in [1e-30, 0.006, 0.0599, 1.0, 3.0, 59.0, 60.0, 61.0, 1e30] {
            let fields = length / spacing(length);
            assert!((5.999..30.001).contains(&fields), "{fields} fields along {length}");
        }
        assert_eq!([spacing(0.0), spacing(f64::NAN), spacing(f64::INFINITY)], [1.0; 3]);
    }

    #[test]
    fn it_lies_below_the_model_and_reaches_beyond_it_whatever_is_upward() {
        let bounds = Bounds::new(DVec3::new(-1.0, -2.0, -3.0), DVec3::new(4.0, 5.0, 6.0));
        for up in [Up::PlusX, Up::MinusX, Up::PlusY, Up::MinusY, Up::PlusZ, Up::MinusZ] {
            let mesh = grid(&bounds, up).unwrap();
            let ends = bounds.corners().map(|corner| corner.dot(up.axis()));
            let lowest = ends.into_iter().fold(f64::INFINITY, f64::min);
            let (around, _) = Bounds::from_points(mesh.positions().iter().copied());
            for position in mesh.positions() {
                assert_eq!(DVec3::from_array(position.map(f64::from)).dot(up.axis()), lowest, "{up:?}");
            }
            let (low, high) = (upright(around.min(), up), upright(around.max(), up));
            let (inner_low, inner_high) = (upright(bounds.min(), up), upright(bounds.max(), up));
            let (low, high) = (low.min(high), low.max(high));
            let (inner_low, inner_high) = (inner_low.min(inner_high), inner_low.max(inner_high));
            assert!(
                low.x < inner_low.x && low.z < inner_low.z && high.x > inner_high.x && high.z > inner_high.z
            );
        }
    }
}
