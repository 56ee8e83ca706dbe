//! What a ray meets first.
//!
//! ```text
//!        ray, once an object ──▶ into the model's coordinates
//!                                    │
//!              misses the box? ──▶ next object
//!                                    │
//!        each triangle, slid along the ray onto a plane across it:
//!
//!               c                      the origin is the ray, seen end on. It is in the triangle if it lies
//!              ╱ ╲                     on the same side of ab, bc and ca; the three areas with it are the
//!             ╱ · ╲                    weights of the corners' depths.
//!            a─────b
//! ```
//!
//! The areas of two triangles over a shared edge differ in sign alone, to the last bit, so no ray slips through
//! between them (Woop, Benthin and Wald, "Watertight Ray/Triangle Intersection", 2013). Transforming the ray and not
//! the mesh leaves the distance along it as it is, since a parameter of a line is not changed by an affine map.

use polosa_math::glam::{DMat3, DVec3};
use polosa_math::{Bounds, Placement, normalized};

use crate::{Mesh, ObjectKey, Ray, Show, World};

/// Where a ray meets a surface.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Hit {
    /// The object.
    pub object: ObjectKey,
    /// The number of the triangle in the object's mesh, from 0.
    pub triangle: usize,
    /// How far from the ray's origin, as a multiple of its direction's length: in world units for a ray of
    /// [`Camera::pick_ray`](crate::Camera::pick_ray).
    pub distance: f64,
    /// Where, in world coordinates: on the ray.
    pub point: DVec3,
}

impl World {
    /// The nearest surface that a ray meets: of the objects that are visible and shown as surfaces, seen from either
    /// side. Of two surfaces at the same distance the first drawn is met.
    ///
    /// All triangles are looked at of each object whose box the ray meets. Triangles with a position that is not
    /// finite are met by no ray, and a ray that is not finite meets nothing.
    #[must_use]
    pub fn pick(&self, ray: &Ray) -> Option<Hit> {
        if !ray.origin.is_finite() || !ray.direction.is_finite() {
            return None;
        }
        let mut nearest: Option<Hit> = None;
        for (object, shown) in self.objects().filter(|(_, o)| o.visible && o.show != Show::Wire) {
            let Some((mesh, bounds)) = self.mesh(shown.mesh).zip(self.mesh_bounds(shown.mesh)) else {
                continue;
            };
            let limit = nearest.map_or(f64::INFINITY, |hit| hit.distance);
            let met = match Line::in_model(ray, &shown.placement) {
                Some(line) if line.meets(&bounds, limit) => line.first(mesh, limit, |place| place),
                Some(_) => None,
                // Squashed flat, or by numbers beyond any use: then the mesh is brought to the ray.
                None => {
                    let matrix = shown.placement.matrix();
                    let placed = |place: [f64; 3]| {
                        let place = matrix * DVec3::from_array(place).extend(1.0);
                        place.truncate().to_array()
                    };
                    Line::new(ray.origin, ray.direction).and_then(|line| line.first(mesh, limit, placed))
                }
            };
            if let Some((triangle, distance)) = met {
                let point = ray.origin + ray.direction * distance;
                nearest = Some(Hit { object, triangle, distance, point });
            }
        }
        nearest
    }
}

/// A ray in the coordinates of what it is held against.
struct Line {
    origin: [f64; 3],
    direction: DVec3,
    /// The axis along which it runs most.
    along: usize,
    /// What slides a point along the ray onto the plane across that axis: the ray's steps along the next two, and the
    /// factor that makes a step along it a distance.
    shear: [f64; 3],
}

impl Line {
    /// `None` if the direction is zero, or so short that its reciprocal is not finite.
    fn new(origin: DVec3, direction: DVec3) -> Option<Self> {
        let size = direction.abs();
        let along = if size.x >= size.y && size.x >= size.z {
            0
        } else if size.y >= size.z {
            1
        } else {
            2
        };
        let scale = 1.0 / direction[along];
        let shear = [direction[(along + 1) % 3] * scale, direction[(along + 2) % 3] * scale, scale];
        let sound = origin.is_finite() && shear.iter().all(|x| x.is_finite());
        sound.then_some(Self { origin: origin.to_array(), direction, along, shear })
    }

    /// The ray in an object's coordinates: distances along it are those in the world. `None` if there is no way back
    /// from the world into them.
    fn in_model(ray: &Ray, placement: &Placement) -> Option<Self> {
        let back = DMat3::from_quat(normalized(placement.rotation)).transpose();
        let [origin, direction] =
            [ray.origin - placement.translation, ray.direction].map(|v| (back * v) / placement.scale);
        Self::new(origin, direction)
    }

    /// Whether it meets a box before `limit`; rounding never says no.
    fn meets(&self, bounds: &Bounds, limit: f64) -> bool {
        /// A few roundings, to be on the safe side.
        const SLACK: f64 = 1.0 + 1e-14;
        let (mut from, mut to) = (0.0_f64, limit);
        for k in 0..3 {
            let (low, high) = (bounds.min()[k] - self.origin[k], bounds.max()[k] - self.origin[k]);
            if self.direction[k] == 0.0 {
                if low > 0.0 || high < 0.0 {
                    return false;
                }
                continue;
            }
            let (a, b) = (low / self.direction[k], high / self.direction[k]);
            from = from.max(a.min(b));
            to = to.min(a.max(b) * SLACK);
        }
        !bounds.is_empty() && from <= to * SLACK
    }

    /// The first of a mesh's triangles on it that is nearer than `limit`, and how far along it is.
    fn first(&self, mesh: &Mesh, limit: f64, place: impl Fn([f64; 3]) -> [f64; 3]) -> Option<(usize, f64)> {
        // The axis is known when this is compiled; a million times looked up, it takes as long as all the rest.
        match self.along {
            0 => self.first_along::<0>(mesh, limit, place),
            1 => self.first_along::<1>(mesh, limit, place),
            _ => self.first_along::<2>(mesh, limit, place),
        }
    }

    fn first_along<const AXIS: usize>(
        &self,
        mesh: &Mesh,
        limit: f64,
        place: impl Fn([f64; 3]) -> [f64; 3],
    ) -> Option<(usize, f64)> {
        let positions = mesh.positions();
        let (mut nearest, mut limit) = (None, limit);
        for (number, &[a, b, c]) in mesh.triangles().iter().enumerate() {
            let a = self.slid::<AXIS>(place(positions[a as usize].map(f64::from)));
            let b = self.slid::<AXIS>(place(positions[b as usize].map(f64::from)));
            let c = self.slid::<AXIS>(place(positions[c as usize].map(f64::from)));
            if let Some(distance) = self.distance([a, b, c])
                && distance < limit
            {
                (nearest, limit) = (Some((number, distance)), distance);
            }
        }
        nearest
    }

    /// A point as the ray has it: beside it by the first two coordinates, and so far along.
    #[inline(always)]
    fn slid<const AXIS: usize>(&self, place: [f64; 3]) -> [f64; 3] {
        let [k, l] = [(AXIS + 1) % 3, (AXIS + 2) % 3];
        let (x, y, z) =
            (place[k] - self.origin[k], place[l] - self.origin[l], place[AXIS] - self.origin[AXIS]);
        [x - self.shear[0] * z, y - self.shear[1] * z, z]
    }

    /// How far along a triangle is met, if it is, and in front of the origin.
    #[inline(always)]
    fn distance(&self, [a, b, c]: [[f64; 3]; 3]) -> Option<f64> {
        // Most triangles lie wholly to one side, above or below, which is seen without a product.
        let apart = |k: usize| {
            (a[k] > 0.0) & (b[k] > 0.0) & (c[k] > 0.0) | (a[k] < 0.0) & (b[k] < 0.0) & (c[k] < 0.0)
        };
        if apart(0) | apart(1) {
            return None;
        }
        let u = c[0] * b[1] - c[1] * b[0];
        let v = a[0] * c[1] - a[1] * c[0];
        let w = b[0] * a[1] - b[1] * a[0];
        // Without a branch for each: which of them says no is hard to foretell.
        let beside = ((u < 0.0) | (v < 0.0) | (w < 0.0)) & ((u > 0.0) | (v > 0.0) | (w > 0.0));
        if beside {
            return None;
        }
        let distance = (u * a[2] + v * b[2] + w * c[2]) / (u + v + w) * self.shear[2];
        // Not a number where the triangle is seen edge on, or is not finite.
        (distance > 0.0).then_some(distance)
    }
}
