//! Placing the camera so that what it looks at fills the picture.

use polosa_math::{
    Basis, Bounds, Planes,
    glam::{DMat4, DVec3},
};

use super::{Camera, CameraError, Projection};

impl Camera {
    /// Frames the eight corners of a box: see [`frame_points`](Self::frame_points).
    ///
    /// # Errors
    ///
    /// As for that. An empty box is framed like one around the origin.
    pub fn frame(
        &mut self,
        bounds: &Bounds,
        to_eye: DVec3,
        up: DVec3,
        margin: f64,
    ) -> Result<(), CameraError> {
        let corners = if bounds.is_empty() { [DVec3::ZERO; 8] } else { bounds.corners() };
        self.frame_points(corners, to_eye, up, margin)
    }

    /// Stands where all the points just fit into the picture.
    ///
    /// - `to_eye`: from the points to the eye, of any length.
    /// - `up`: what the picture has upward, as [`set_view_up`](Self::set_view_up) takes it.
    /// - `margin`: the part of the picture's width and height that stays free on every side, in [0, ½). In the
    ///   direction in which the points fill the picture, two of them touch it on opposite sides.
    ///
    /// The kind of projection, its angle and the aspect stay. A perspective gets an infinite far plane and a near
    /// plane at a thousandth of the distance, nearer if the points come nearer. A parallel projection gets the
    /// height, and near and far planes that leave room before and behind; one from six planes keeps their
    /// proportions and is centred.
    ///
    /// Points without extent, or none at all, are framed like a ball of radius 1 around their place, or around the
    /// origin. Points that are not finite are left out. Works for extents between 10⁻¹⁰⁰ and 10¹⁰⁰. On an error
    /// the camera is left as it was.
    ///
    /// # Errors
    ///
    /// When the margin is out of range, a direction is zero or not finite, or the projection's axis lies outside
    /// of the picture.
    pub fn frame_points(
        &mut self,
        points: impl IntoIterator<Item = DVec3>,
        to_eye: DVec3,
        up: DVec3,
        margin: f64,
    ) -> Result<(), CameraError> {
        if !(0.0..0.5).contains(&margin) {
            return Err(CameraError::Margin(margin));
        }
        let mut framed = *self;
        framed.set_direction(-to_eye).map_err(|_| CameraError::Direction(to_eye))?;
        framed.set_view_up(up)?;

        let basis = framed.basis();
        let edge = 1.0 - 2.0 * margin;
        let lens = Lens::new(&self.projection_matrix(), edge);
        if !self.projection.is_parallel() && !lens.holds_axis() {
            return Err(CameraError::Frame);
        }
        let extent = Extent::of(points, &basis, &lens);
        let (eye, projection) = if self.projection.is_parallel() {
            extent.parallel(self.projection, self.aspect, edge)
        } else {
            extent.perspective(self.projection, &lens)
        };
        framed.position = extent.reference + basis.to_world(eye);
        if !framed.position.is_finite() {
            return Err(CameraError::Frame);
        }
        framed.set_projection(projection).map_err(|_| CameraError::Frame)?;
        *self = framed;
        Ok(())
    }
}

/// What a perspective does to a point's place across the picture, first x, then y.
///
/// A point at (u, v, n) in the camera's axes (right, up, towards the eye) is seen by an eye at (e, f, d) at
/// `x/w = a·(u − e)/(d − n) − c`, with the entries a and c of the projection matrix. For that to lie within ±edge
/// takes `d ≥ n + p·(u − e)` with `p = a/(edge + c)`, and `d ≥ n − m·(u − e)` with `m = a/(edge − c)`.
struct Lens {
    p: [f64; 2],
    m: [f64; 2],
}

impl Lens {
    fn new(projection: &DMat4, edge: f64) -> Self {
        let entries =
            [(projection.x_axis.x, projection.z_axis.x), (projection.y_axis.y, projection.z_axis.y)];
        Self { p: entries.map(|(a, c)| a / (edge + c)), m: entries.map(|(a, c)| a / (edge - c)) }
    }

    /// Whether the axis lies in the picture; if not, no distance brings anything into it.
    fn holds_axis(&self) -> bool {
        self.p.iter().chain(&self.m).all(|k| *k > 0.0 && k.is_finite())
    }
}

/// How far points reach, in the camera's axes, measured from one of them.
struct Extent {
    reference: DVec3,
    low: DVec3,
    high: DVec3,
    /// For x and y the greatest `n + p·u` and `n − m·u`: how far the eye must stand off for either side.
    sides: [[f64; 2]; 2],
}

impl Extent {
    fn of(points: impl IntoIterator<Item = DVec3>, basis: &Basis, lens: &Lens) -> Self {
        let mut points = points.into_iter().filter(|point| point.is_finite());
        let reference = points.next().unwrap_or(DVec3::ZERO);
        let mut extent = Self::at(reference);
        points.for_each(|point| extent.insert(basis.to_camera(point - reference), lens));
        // A point, as far as the precision of its place can tell: there must be something to stand back from.
        let magnitude = reference.abs().max_element();
        let size = (extent.high - extent.low).max_element();
        if size <= 64.0 * f64::EPSILON * magnitude || size == 0.0 {
            let radius = (1e-9 * magnitude).max(1.0);
            extent = Self::at(reference);
            for axis in DVec3::AXES {
                extent.insert(axis * radius, lens);
                extent.insert(-axis * radius, lens);
            }
        }
        extent
    }

    /// One point, which is its own reference.
    const fn at(reference: DVec3) -> Self {
        Self { reference, low: DVec3::ZERO, high: DVec3::ZERO, sides: [[0.0; 2]; 2] }
    }

    fn insert(&mut self, point: DVec3, lens: &Lens) {
        self.low = self.low.min(point);
        self.high = self.high.max(point);
        for (k, across) in [point.x, point.y].into_iter().enumerate() {
            let [plus, minus] = &mut self.sides[k];
            *plus = plus.max(point.z + lens.p[k] * across);
            *minus = minus.max(point.z - lens.m[k] * across);
        }
    }

    /// Half the diagonal.
    fn radius(&self) -> f64 {
        (self.high - self.low).length() / 2.0
    }

    /// The place of the eye, and the projection as it should be.
    ///
    /// Both sides just fit where `d = plus − p·e` meets `d = minus + m·e`.
    fn perspective(&self, projection: Projection, lens: &Lens) -> (DVec3, Projection) {
        let [x, y] = [0, 1].map(|k| {
            let ([plus, minus], p, m) = (self.sides[k], lens.p[k], lens.m[k]);
            ((plus - minus) / (p + m), (plus * m + minus * p) / (p + m))
        });
        // Never in the box itself, which a very wide angle or points in one plane would allow.
        let nearest = self.high.z;
        let eye = DVec3::new(x.0, y.0, x.1.max(y.1).max(nearest + self.radius() / 100.0));
        let distance = eye.z - (self.low.z + nearest) / 2.0;
        let near = (distance / 1000.0).min((eye.z - nearest) / 2.0);
        let projection = match projection {
            Projection::PerspectivePlanes(planes) => {
                let scale = near / planes.near;
                Projection::PerspectivePlanes(Planes {
                    left: planes.left * scale,
                    right: planes.right * scale,
                    bottom: planes.bottom * scale,
                    top: planes.top * scale,
                    near,
                    far: f64::INFINITY,
                })
            }
            Projection::Perspective { fov, .. } => Projection::Perspective { fov, near, far: f64::INFINITY },
            other => other,
        };
        (eye, projection)
    }

    fn parallel(&self, projection: Projection, aspect: f64, edge: f64) -> (DVec3, Projection) {
        let aspect = match projection {
            Projection::OrthographicPlanes(planes) => {
                (planes.right - planes.left) / (planes.top - planes.bottom)
            }
            _ => aspect,
        };
        let (size, radius) = (self.high - self.low, self.radius());
        let needed = size.y.max(size.x / aspect) / 2.0 / edge;
        // A line seen end on has no height of its own.
        let half = if needed > 1e-9 * radius { needed } else { radius };
        let middle = (self.low + self.high) / 2.0;
        let (distance, near, far) = (2.0 * radius, 0.5 * radius, 3.5 * radius);
        let projection = match projection {
            Projection::OrthographicPlanes(_) => Projection::OrthographicPlanes(Planes {
                left: -half * aspect,
                right: half * aspect,
                bottom: -half,
                top: half,
                near,
                far,
            }),
            _ => Projection::Orthographic { height: 2.0 * half, near, far },
        };
        (middle + DVec3::Z * distance, projection)
    }
}
