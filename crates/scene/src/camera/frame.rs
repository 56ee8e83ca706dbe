//! Placing the camera so that a box fills the picture.

use polosa_math::{
    Basis, Bounds, Planes,
    glam::{DMat4, DVec3},
};

use super::{Camera, CameraError, Projection};

impl Camera {
    /// Stands back from a box until it just fits, looking at its middle.
    ///
    /// - `to_eye`: from the middle of the box to the eye, of any length.
    /// - `up`: what the picture has upward, as [`set_view_up`](Self::set_view_up) takes it.
    /// - `margin`: the part of the picture's width and height that stays free on every side, in [0, ½). The corner
    ///   that reaches out furthest touches it exactly.
    ///
    /// The kind of projection, its angle and the aspect stay. A perspective gets an infinite far plane and a near
    /// plane at a thousandth of the distance, nearer if the box comes nearer. A parallel projection gets the
    /// height, and near and far planes that leave half a box's diagonal free before and behind it; one from six
    /// planes keeps their proportions and is centred.
    ///
    /// A box without extent is framed like one of diagonal 2 around its point, an empty one like that around the
    /// origin. Works for boxes of any size between 10⁻¹⁰⁰ and 10¹⁰⁰. On an error the camera is left as it was.
    pub fn frame(
        &mut self,
        bounds: &Bounds,
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

        let subject = Subject::new(bounds, &framed.basis());
        let edge = 1.0 - 2.0 * margin;
        let (distance, projection) = if self.projection.is_parallel() {
            subject.parallel(self.projection, self.aspect, edge)
        } else {
            subject.perspective(self.projection, &self.projection_matrix(), edge).ok_or(CameraError::Frame)?
        };
        framed.position = subject.center + framed.basis().back() * distance;
        if !framed.position.is_finite() {
            return Err(CameraError::Frame);
        }
        framed.set_projection(projection).map_err(|_| CameraError::Frame)?;
        *self = framed;
        Ok(())
    }
}

/// A box as the camera sees it.
struct Subject {
    center: DVec3,
    /// Half its diagonal.
    radius: f64,
    /// Its corners in the camera's axes, measured from the centre: right, up, towards the eye.
    corners: [DVec3; 8],
}

impl Subject {
    fn new(bounds: &Bounds, basis: &Basis) -> Self {
        let center = bounds.center().unwrap_or(DVec3::ZERO);
        let magnitude = center.abs().max_element();
        let mut half = bounds.size() * 0.5;
        // A point, as far as the precision of its place can tell: there must be something to stand back from.
        if half.max_element() <= 64.0 * f64::EPSILON * magnitude || half == DVec3::ZERO {
            half = DVec3::splat((1e-9 * magnitude).max(1.0) / libm::sqrt(3.0));
        }
        let corners = Bounds::new(-half, half).corners().map(|corner| basis.to_camera(corner));
        Self { center, radius: half.length(), corners }
    }

    /// The distance of the eye, and the projection as it should be.
    ///
    /// A corner at (u, v, n) is seen, from the distance d, at x/w = a·u/(d − n) − c, with the entries a and c of the
    /// projection matrix. For that to lie within ±edge takes d ≥ n + a·u / (edge + c), if u is to the right, and
    /// n − a·u / (edge − c), if it is to the left; likewise upward.
    fn perspective(&self, projection: Projection, lens: &DMat4, edge: f64) -> Option<(f64, Projection)> {
        let (x, y) = ((lens.x_axis.x, lens.z_axis.x), (lens.y_axis.y, lens.z_axis.y));
        // With the axis outside the picture no distance brings the middle of the box into it.
        if x.1.abs() >= edge || y.1.abs() >= edge {
            return None;
        }
        let reach = |(a, c): (f64, f64), u: f64| (a * u / (edge + c)).max(-a * u / (edge - c));
        let nearest = self.corners.iter().map(|p| p.z).fold(0.0, f64::max);
        let fits = self.corners.iter().map(|p| p.z + reach(x, p.x).max(reach(y, p.y))).fold(0.0, f64::max);
        // Never in the box itself, which a very wide angle or a box without width would allow.
        let distance = fits.max(nearest + self.radius / 100.0);
        let near = (distance / 1000.0).min((distance - nearest) / 2.0);
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
        Some((distance, projection))
    }

    fn parallel(&self, projection: Projection, aspect: f64, edge: f64) -> (f64, Projection) {
        let aspect = match projection {
            Projection::OrthographicPlanes(planes) => {
                (planes.right - planes.left) / (planes.top - planes.bottom)
            }
            _ => aspect,
        };
        let needed =
            self.corners.iter().map(|p| p.y.abs().max(p.x.abs() / aspect)).fold(0.0, f64::max) / edge;
        // A line seen end on has no height of its own.
        let half = if needed > 1e-9 * self.radius { needed } else { self.radius };
        let (distance, near, far) = (2.0 * self.radius, 0.5 * self.radius, 3.5 * self.radius);
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
        (distance, projection)
    }
}
