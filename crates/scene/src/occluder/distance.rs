//! How far a point is from a mesh, and how often the mesh winds around it.

use core::f64::consts::TAU;

use polosa_math::glam::DVec3;

use crate::Mesh;

fn corners(mesh: &Mesh) -> impl Iterator<Item = [DVec3; 3]> {
    let positions = mesh.positions();
    let place = |vertex: u32| DVec3::from_array(positions[vertex as usize].map(f64::from));
    mesh.triangles().iter().map(move |triangle| triangle.map(place))
}

/// The distance from a point to the nearest triangle, or a little less: what rounding could have added is taken off.
pub(super) fn clearance(mesh: &Mesh, point: DVec3) -> f64 {
    let mut least = f64::INFINITY;
    let mut largest = 0.0_f64;
    for [a, b, c] in corners(mesh) {
        let [a, b, c] = [a - point, b - point, c - point];
        largest = largest.max(a.abs().max_element());
        // No point of the triangle is farther from its first corner than the longer of the two sides there.
        let reach = (b - a).length_squared().max((c - a).length_squared()).sqrt();
        let bound = a.length() - reach;
        if bound < least {
            least = least.min(triangle_distance(a, b, c));
        }
    }
    (least * (1.0 - 1e-9) - largest * 1e-12).max(0.0)
}

/// From the origin to a triangle: to its plane if the nearest point of that is inside, else to the nearest side.
fn triangle_distance(a: DVec3, b: DVec3, c: DVec3) -> f64 {
    let sides = segment_distance(a, b).min(segment_distance(b, c)).min(segment_distance(c, a));
    let normal = (b - a).cross(c - a);
    let square = normal.length_squared();
    if square == 0.0 {
        return sides;
    }
    // The foot of the perpendicular, on the inner side of all three.
    let inside = [(a, b), (b, c), (c, a)].iter().all(|&(p, q)| (q - p).cross(-p).dot(normal) >= 0.0);
    if inside { sides.min(a.dot(normal).abs() / square.sqrt()) } else { sides }
}

fn segment_distance(p: DVec3, q: DVec3) -> f64 {
    let along = q - p;
    let square = along.length_squared();
    let t = if square > 0.0 { (-p.dot(along) / square).clamp(0.0, 1.0) } else { 0.0 };
    (p + along * t).length()
}

/// How often a closed mesh winds around a point off its surface: the solid angles of its triangles, in full spheres
/// (van Oosterom and Strackee, 1983). Their sum is a whole number but for rounding.
pub(super) fn winding(mesh: &Mesh, point: DVec3) -> i64 {
    let mut half = 0.0;
    for [a, b, c] in corners(mesh) {
        let [a, b, c] = [a - point, b - point, c - point];
        let (p, q, r) = (a.length(), b.length(), c.length());
        let below = p * q * r + a.dot(b) * r + b.dot(c) * p + c.dot(a) * q;
        half += libm::atan2(a.dot(b.cross(c)), below);
    }
    // A full sphere is 4π; these are half angles.
    let turns = half / TAU;
    let whole = turns.round();
    // Too near to the surface to be sure: nothing, which hides nothing.
    if (turns - whole).abs() < 0.01 { whole as i64 } else { 0 }
}

#[cfg(test)]
mod tests {
    use super::{clearance, winding};
    use crate::{Mesh, shape};
    use polosa_math::glam::DVec3;

    #[test]
    fn distances_to_faces_sides_and_corners_are_those_of_a_cube() {
        let cube = shape::cube();
        for (point, expected) in [
            (DVec3::ZERO, 1.0),
            (DVec3::new(0.5, 0.1, -0.2), 0.5),
            (DVec3::new(3.0, 0.0, 0.0), 2.0),
            (DVec3::new(2.0, 2.0, 0.5), 2.0_f64.sqrt()),
            (DVec3::new(-2.0, 2.0, 2.0), 3.0_f64.sqrt()),
        ] {
            let got = clearance(&cube, point);
            assert!((expected - 1e-8..expected).contains(&got), "{point}: {got}");
        }
    }

    #[test]
    fn a_surface_winds_once_around_its_inside_either_way_and_not_around_the_outside() {
        let torus = shape::torus(32, 16).unwrap();
        let turned = Mesh::new(
            torus.positions().to_vec(),
            torus.triangles().iter().map(|&[a, b, c]| [a, c, b]).collect(),
        );
        let bounds = polosa_math::Bounds::from_points(torus.positions().iter().copied()).0;
        let in_tube = DVec3::new(bounds.max().x - 0.5 * bounds.size().y, 0.0, 0.0);
        assert_eq!(winding(&torus, in_tube), 1);
        assert_eq!(winding(&turned.unwrap(), in_tube), -1);
        assert_eq!(winding(&torus, DVec3::ZERO), 0);
        assert_eq!(winding(&torus, DVec3::new(9.0, 0.0, 0.0)), 0);
    }
}
