//! The camera: where it stands, where it looks, and what of the world it shows.
//!
//! ```text
//!         V up
//!         │      ╱│ far
//!         │    ╱  │            position   the eye, or in a parallel projection the point it is measured from
//!         │  ╱ │  │            direction  along the axis, −N
//!    eye  o────┼──┼──▶         up         a hint: V is the nearest direction at right angles to the axis
//!        ╱ ╲ near │            projection how the axes are mapped to the picture; aspect = width / height
//!     N ╱    ╲ │  │
//!     U        ╲  │
//!                ╲│
//! ```
//!
//! The fields above are all that is stored. Every matrix is computed from them when asked for, so no setter can
//! leave a stale one behind; every setter refuses what has no matrix, so asking never fails.

mod frame;
#[cfg(test)]
mod tests;

use polosa_math::{
    Basis, Placement, Planes, Viewport, axis_angle, clip_from_model, clip_from_model_f64,
    glam::{DMat3, DMat4, DVec3},
    orthographic, orthographic_planes, perspective_horizontal, perspective_planes, perspective_vertical,
    unit,
};

/// An angle of view in radians, in (0, π).
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum FieldOfView {
    /// From the lower to the upper edge of the picture.
    Vertical(f64),
    /// From the left to the right edge of the picture.
    Horizontal(f64),
}

/// How the camera maps the world to the picture. Distances are in world units, measured along the viewing axis.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Projection {
    /// Things get smaller with distance. `0 < near < far`; `far` may be infinite.
    Perspective {
        /// The angle of view; the other one follows from the aspect.
        fov: FieldOfView,
        /// Distance of the near plane.
        near: f64,
        /// Distance of the far plane.
        far: f64,
    },
    /// Things keep their size. `near < far`, both finite; `near` may be negative.
    Orthographic {
        /// World units from the lower to the upper edge of the picture.
        height: f64,
        /// Distance of the near plane.
        near: f64,
        /// Distance of the far plane.
        far: f64,
    },
    /// A perspective through a window on the near plane. The camera's aspect has no influence.
    PerspectivePlanes(Planes),
    /// A parallel projection of the box between six planes. The camera's aspect has no influence.
    OrthographicPlanes(Planes),
}

impl Projection {
    /// The matrix from camera space to clip space, or `None` if these numbers make none (see
    /// [`polosa_math::projection`]). `aspect` is width / height of the picture.
    #[must_use]
    pub fn matrix(&self, aspect: f64) -> Option<DMat4> {
        match *self {
            Self::Perspective { fov: FieldOfView::Vertical(fov), near, far } => {
                perspective_vertical(fov, aspect, near, far)
            }
            Self::Perspective { fov: FieldOfView::Horizontal(fov), near, far } => {
                perspective_horizontal(fov, aspect, near, far)
            }
            Self::Orthographic { height, near, far } => orthographic(height, aspect, near, far),
            Self::PerspectivePlanes(ref planes) => perspective_planes(planes),
            Self::OrthographicPlanes(ref planes) => orthographic_planes(planes),
        }
    }

    /// Whether all lines of sight are parallel.
    #[must_use]
    pub const fn is_parallel(&self) -> bool {
        matches!(self, Self::Orthographic { .. } | Self::OrthographicPlanes(_))
    }
}

/// Why a [`Camera`] refused a value. It is left as it was.
#[derive(Clone, Copy, Debug, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum CameraError {
    /// The position has a coordinate that is infinite or not a number.
    #[error("the camera's position {0} is not finite")]
    Position(DVec3),
    /// The direction is zero, infinite or not a number.
    #[error("the camera cannot look along {0}: a direction is finite and not zero")]
    Direction(DVec3),
    /// The vector for up is zero, infinite or not a number.
    #[error("the camera cannot have {0} upward: a direction is finite and not zero")]
    Up(DVec3),
    /// The projection and the aspect together make no matrix.
    #[error("no projection: {projection:?} with aspect {aspect}")]
    Projection {
        /// The refused projection, or the one in use if the aspect was refused.
        projection: Projection,
        /// The refused aspect, or the one in use if the projection was refused.
        aspect: f64,
    },
    /// The angle is infinite or not a number.
    #[error("the camera cannot turn by {0}")]
    Angle(f64),
    /// The margin is outside [0, ½).
    #[error("a margin of {0} leaves no room: it must be at least 0 and less than 0.5")]
    Margin(f64),
    /// No place for the eye on the line through the box's middle shows the whole box.
    #[error(
        "the box cannot be framed: the middle of the view is outside the picture, or the box is too large"
    )]
    Frame,
}

/// A place in the picture, and how deep the point seen there lies.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ScreenPoint {
    /// Pixels from the picture's left edge.
    pub x: f64,
    /// Pixels from the picture's upper edge.
    pub y: f64,
    /// Reversed depth: 1 at the near plane, 0 at the far plane or at infinity.
    pub depth: f64,
}

/// Where a line of sight begins, and where it goes.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Ray {
    /// In perspective the eye, in a parallel projection the point on the near plane; in world coordinates.
    pub origin: DVec3,
    /// Unit length, away from the observer.
    pub direction: DVec3,
}

/// A camera in `f64`. See the [module's documentation](self).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Camera {
    position: DVec3,
    direction: DVec3,
    up: DVec3,
    projection: Projection,
    aspect: f64,
}

impl Default for Camera {
    /// At (0, 0, 10), looking along −Z with +Y upward, 70° from left to right, from 1 to 1000 units away, in a
    /// picture of 4 : 3.
    fn default() -> Self {
        Self {
            position: DVec3::new(0.0, 0.0, 10.0),
            direction: DVec3::NEG_Z,
            up: DVec3::Y,
            projection: Projection::Perspective {
                fov: FieldOfView::Horizontal(70_f64.to_radians()),
                near: 1.0,
                far: 1000.0,
            },
            aspect: 4.0 / 3.0,
        }
    }
}

impl Camera {
    /// The camera of [`Camera::default`].
    #[must_use]
    pub fn new() -> Self {
        Self::default()
    }

    /// Where the eye is.
    #[must_use]
    pub const fn position(&self) -> DVec3 {
        self.position
    }

    /// Moves the eye. Refused unless finite.
    pub fn set_position(&mut self, position: DVec3) -> Result<(), CameraError> {
        if !position.is_finite() {
            return Err(CameraError::Position(position));
        }
        self.position = position;
        Ok(())
    }

    /// Where the camera looks; unit length.
    #[must_use]
    pub const fn direction(&self) -> DVec3 {
        self.direction
    }

    /// Looks along `direction`, of any length. Refused if zero or not finite.
    pub fn set_direction(&mut self, direction: DVec3) -> Result<(), CameraError> {
        self.direction = unit(direction).ok_or(CameraError::Direction(direction))?;
        Ok(())
    }

    /// Looks at a point of the world from where the camera stands. Refused if it stands there, or if not finite.
    pub fn look_at(&mut self, focal: DVec3) -> Result<(), CameraError> {
        self.set_direction(focal - self.position)
    }

    /// The hint for upward, as it was set; unit length. [`up`](Self::up) is what the picture has upward.
    #[must_use]
    pub const fn view_up(&self) -> DVec3 {
        self.up
    }

    /// Has `up`, of any length, upward in the picture. Refused if zero or not finite.
    ///
    /// It need not be at right angles to the direction. Parallel to it, +Y is used instead while that lasts, or −Z
    /// ([`Basis::looking`]).
    pub fn set_view_up(&mut self, up: DVec3) -> Result<(), CameraError> {
        self.up = unit(up).ok_or(CameraError::Up(up))?;
        Ok(())
    }

    /// How the world is mapped to the picture.
    #[must_use]
    pub const fn projection(&self) -> Projection {
        self.projection
    }

    /// Changes the mapping. Refused if it makes no matrix with the aspect in use.
    pub fn set_projection(&mut self, projection: Projection) -> Result<(), CameraError> {
        self.set_lens(projection, self.aspect)
    }

    /// Width / height of the picture.
    #[must_use]
    pub const fn aspect(&self) -> f64 {
        self.aspect
    }

    /// Changes width / height of the picture. Refused unless positive and finite.
    pub fn set_aspect(&mut self, aspect: f64) -> Result<(), CameraError> {
        self.set_lens(self.projection, aspect)
    }

    /// Projection and aspect together, as only together they are sound or not.
    fn set_lens(&mut self, projection: Projection, aspect: f64) -> Result<(), CameraError> {
        let sound = aspect > 0.0 && aspect.is_finite() && projection.matrix(aspect).is_some();
        if !sound {
            return Err(CameraError::Projection { projection, aspect });
        }
        (self.projection, self.aspect) = (projection, aspect);
        Ok(())
    }

    /// The camera's axes.
    #[must_use]
    pub fn basis(&self) -> Basis {
        Basis::looking(self.direction, self.up)
    }

    /// U: what the picture has to the right; unit length.
    #[must_use]
    pub fn right(&self) -> DVec3 {
        self.basis().right()
    }

    /// V: what the picture has upward; unit length, at right angles to the direction.
    #[must_use]
    pub fn up(&self) -> DVec3 {
        self.basis().up()
    }

    /// The matrix from the world to camera space.
    #[must_use]
    pub fn view(&self) -> DMat4 {
        self.basis().view(self.position)
    }

    /// The matrix from camera space to clip space.
    #[must_use]
    pub fn projection_matrix(&self) -> DMat4 {
        // Every setter has made sure that there is one.
        self.projection.matrix(self.aspect).unwrap_or(DMat4::IDENTITY)
    }

    /// The matrix from the world to clip space.
    #[must_use]
    pub fn view_projection(&self) -> DMat4 {
        self.projection_matrix() * self.view()
    }

    /// The matrix that drawing transforms an object's vertices by: columns of `f32`, composed relative to the eye
    /// in `f64`, so that a scene far from the origin does not jitter.
    #[must_use]
    pub fn clip_from_model(&self, model: &Placement) -> [[f32; 4]; 4] {
        clip_from_model(&self.projection_matrix(), &self.basis().rotation(), self.position, model)
    }

    /// The same before it is rounded: for culling by [`polosa_math::Frustum`] and for bounds on the screen.
    #[must_use]
    pub fn clip_from_model_f64(&self, model: &Placement) -> DMat4 {
        clip_from_model_f64(&self.projection_matrix(), &self.basis().rotation(), self.position, model)
    }

    /// Where a point of the world is seen in a picture of `width` × `height` pixels, be it beside the picture.
    ///
    /// `None` if it is not between the near and the far plane, or not finite, or the picture has no pixels.
    #[must_use]
    pub fn project_point(&self, point: DVec3, width: u32, height: u32) -> Option<ScreenPoint> {
        let at = self.projection_matrix() * self.basis().to_camera(point - self.position).extend(1.0);
        let seen = at.w > 0.0 && 0.0 <= at.z && at.z <= at.w && width > 0 && height > 0;
        let [x, y] =
            if seen { Viewport::new(width, height).to_pixels(at.x, at.y, at.w) } else { return None };
        (x.is_finite() && y.is_finite()).then_some(ScreenPoint { x, y, depth: at.z / at.w })
    }

    /// The line of sight through a place in a picture of `width` × `height` pixels, given in pixels from its upper
    /// left corner. The centre of pixel (i, j) is `[i + 0.5, j + 0.5]`.
    ///
    /// `None` if the place is not finite or the picture has no pixels.
    #[must_use]
    pub fn pick_ray(&self, pixel: [f64; 2], width: u32, height: u32) -> Option<Ray> {
        if width == 0 || height == 0 {
            return None;
        }
        let [x, y] = Viewport::new(width, height).from_pixels(pixel);
        let basis = self.basis();
        let lens = self.projection_matrix();
        let ray = if self.projection.is_parallel() {
            // clip = scale · p + shift, and z = 1 on the near plane.
            let p = (DVec3::new(x, y, 1.0) - lens.w_axis.truncate()) / lens.diagonal().truncate();
            Ray { origin: self.position + basis.to_world(p), direction: basis.forward() }
        } else {
            // At distance 1, where w = 1: clip = scale · p − shift.
            let p =
                DVec3::new((x + lens.z_axis.x) / lens.x_axis.x, (y + lens.z_axis.y) / lens.y_axis.y, -1.0);
            Ray { origin: self.position, direction: unit(basis.to_world(p))? }
        };
        (ray.origin.is_finite() && ray.direction.is_finite()).then_some(ray)
    }

    /// How far from the eye, along the viewing axis and in world units, a stored depth lies: near for 1, far for 0
    /// (infinite if the far plane is).
    #[must_use]
    pub fn distance(&self, depth: f32) -> f64 {
        let lens = self.projection_matrix();
        let (a, b) = (lens.z_axis.z, lens.w_axis.z);
        let depth = f64::from(depth);
        // Parallel: depth = b − a·d.  Perspective: depth = (b − a·d) / d.
        if self.projection.is_parallel() { (b - depth) / a } else { b / (depth + a) }
    }

    /// Goes round `focal` by `angle` radians, the axis being [`view_up`](Self::view_up): what was seen from the
    /// front is then seen from the right. The meaning is that of VTK's `Azimuth` and F3D's
    /// `--camera-azimuth-angle`; the camera is moved and turned as a whole and need not look at `focal`.
    pub fn azimuth(&mut self, angle: f64, focal: DVec3) -> Result<(), CameraError> {
        self.go_round(self.up, angle, focal)
    }

    /// Rises over `focal` by `angle` radians, the axis being the camera's own −U: from the front towards the top.
    /// The meaning is that of VTK's `Elevation` and F3D's `--camera-elevation-angle`.
    ///
    /// Unlike VTK's picture this one does not flip beyond the pole: the camera then stands on its head, and
    /// [`view_up`](Self::view_up) is turned round to say so.
    pub fn elevation(&mut self, angle: f64, focal: DVec3) -> Result<(), CameraError> {
        let (axis, up) = (-self.right(), self.up());
        self.go_round(axis, angle, focal)?;
        let turned = axis_angle(axis, angle).map_or(up, |by| DMat3::from_quat(by) * up);
        // At the pole itself the hint says nothing any more (its part along the picture's up is rounding), and the
        // turned axis takes its place.
        let along = self.up.dot(turned);
        if along.abs() < 1e-9 {
            self.set_view_up(turned)?;
        } else if along < 0.0 {
            self.up = -self.up;
        }
        Ok(())
    }

    /// Turns position and direction about a line through `focal`.
    fn go_round(&mut self, axis: DVec3, angle: f64, focal: DVec3) -> Result<(), CameraError> {
        let turn = DMat3::from_quat(axis_angle(axis, angle).ok_or(CameraError::Angle(angle))?);
        let mut moved = *self;
        moved.set_position(focal + turn * (self.position - focal))?;
        moved.set_direction(turn * self.direction)?;
        *self = moved;
        Ok(())
    }
}
