//! Where an object stands, and the one step from `f64` to `f32`.
//!
//! A float of 32 bits tells points 10⁷ units from the origin apart by whole units only. So everything above the
//! vertex is composed in `f64`, and the large numbers cancel before anything else is done with them:
//!
//! ```text
//!   clip = projection · turn · move(placement − eye) · rotation · scale · vertex
//!                              ─────────────────────
//!                              first of all, in f64: small again
//!          ╰──────────────────── one matrix, rounded to f32 once ──────────╯
//! ```
//!
//! A scene at 10⁷ drawn through a camera there is then the scene at the origin, to the last bit if the
//! differences are exact.

use glam::{DMat3, DMat4, DQuat, DVec3};

use crate::{
    rotation::{normalized, turn},
    view::unit,
};

/// An object's place in the world: scaled along its own axes, then turned, then moved.
///
/// Any values are allowed: a rotation that is not of unit length counts as its direction, one that is zero or not
/// finite as no rotation; a negative scale mirrors.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Placement {
    /// Where the object's own origin comes to lie.
    pub translation: DVec3,
    /// The turn about the object's own origin.
    pub rotation: DQuat,
    /// The factors along the object's own axes.
    pub scale: DVec3,
}

impl Default for Placement {
    fn default() -> Self {
        Self::IDENTITY
    }
}

impl Placement {
    /// At the origin, not turned, not scaled.
    pub const IDENTITY: Self =
        Self { translation: DVec3::ZERO, rotation: DQuat::IDENTITY, scale: DVec3::ONE };

    /// Moved to `translation`, not turned, not scaled.
    #[must_use]
    pub const fn at(translation: DVec3) -> Self {
        Self { translation, rotation: DQuat::IDENTITY, scale: DVec3::ONE }
    }

    /// The matrix from the object's coordinates to the world's: translation · rotation · scale.
    #[must_use]
    pub fn matrix(&self) -> DMat4 {
        self.matrix_from(DVec3::ZERO)
    }

    /// The matrix from the object's coordinates to axes parallel to the world's with their origin in `eye`.
    #[must_use]
    pub fn matrix_from(&self, eye: DVec3) -> DMat4 {
        let turn = DMat3::from_quat(normalized(self.rotation));
        DMat4::from_cols(
            (turn.x_axis * self.scale.x).extend(0.0),
            (turn.y_axis * self.scale.y).extend(0.0),
            (turn.z_axis * self.scale.z).extend(0.0),
            (self.translation - eye).extend(1.0),
        )
    }

    /// Where a point given in the object's coordinates lies in the world.
    #[must_use]
    pub fn to_world(&self, point: DVec3) -> DVec3 {
        (self.matrix() * point.extend(1.0)).truncate()
    }

    /// Moved by `offset`, along the world's axes.
    #[must_use]
    pub fn moved(self, offset: DVec3) -> Self {
        Self { translation: self.translation + offset, ..self }
    }

    /// Turned by `by` about its own origin, the axis given in the world's coordinates.
    #[must_use]
    pub fn turned(self, by: DQuat) -> Self {
        Self { rotation: turn(self.rotation, by), ..self }
    }

    /// Turned by `by` about any point of the world, the axis given in the world's coordinates.
    ///
    /// To turn an object about the middle of its mesh: `p.turned_about(by, p.to_world(middle))`.
    #[must_use]
    pub fn turned_about(self, by: DQuat, point: DVec3) -> Self {
        let arm = DMat3::from_quat(normalized(by)) * (self.translation - point);
        Self { translation: point + arm, ..self.turned(by) }
    }

    /// Scaled along its own axes, its own origin staying where it is.
    #[must_use]
    pub fn scaled(self, factors: DVec3) -> Self {
        Self { scale: self.scale * factors, ..self }
    }

    /// Scaled alike in all directions, away from or towards a point of the world.
    #[must_use]
    pub fn scaled_about(self, factor: f64, point: DVec3) -> Self {
        Self { translation: point + (self.translation - point) * factor, scale: self.scale * factor, ..self }
    }

    /// Takes a matrix apart into translation, rotation and scale.
    ///
    /// `None` if that cannot give the matrix back to 1 part in 10⁹ of each column: it shears, or is not affine, or
    /// not finite. A mirroring matrix gets a negative scale along x.
    #[must_use]
    pub fn from_matrix(matrix: &DMat4) -> Option<Self> {
        if !matrix.is_finite() || matrix.row(3).to_array() != [0.0, 0.0, 0.0, 1.0] {
            return None;
        }
        let columns = [matrix.x_axis, matrix.y_axis, matrix.z_axis].map(glam::DVec4::truncate);
        let mut scale = DVec3::from_array(columns.map(length));
        let mut axes = completed(columns.map(unit));
        if axes[0].cross(axes[1]).dot(axes[2]) < 0.0 {
            scale.x = -scale.x;
            axes[0] = -axes[0];
        }
        let rotation = normalized(DQuat::from_rotation_axes(axes[0], axes[1], axes[2]));
        let placement = Self { translation: matrix.w_axis.truncate(), rotation, scale };

        let again = placement.matrix();
        let again = [again.x_axis, again.y_axis, again.z_axis].map(glam::DVec4::truncate);
        let close = (0..3).all(|i| (again[i] - columns[i]).abs().max_element() <= 1e-9 * scale[i].abs());
        close.then_some(placement)
    }
}

/// The length of a finite vector, without overflow or underflow on the way.
fn length(v: DVec3) -> f64 {
    let largest = v.abs().max_element();
    if largest == 0.0 { 0.0 } else { (v / largest).length() * largest }
}

/// Unit axes for the columns that are zero (an object squashed flat), at right angles to the others.
fn completed(axes: [Option<DVec3>; 3]) -> [DVec3; 3] {
    let perpendicular = |a: DVec3| {
        let least = if a.x.abs() < 0.6 { DVec3::X } else { DVec3::Y };
        unit(a.cross(least)).unwrap_or(DVec3::Z)
    };
    match axes {
        [Some(x), Some(y), Some(z)] => [x, y, z],
        [None, Some(y), Some(z)] => [unit(y.cross(z)).unwrap_or(DVec3::X), y, z],
        [Some(x), None, Some(z)] => [x, unit(z.cross(x)).unwrap_or(DVec3::Y), z],
        [Some(x), Some(y), None] => [x, y, unit(x.cross(y)).unwrap_or(DVec3::Z)],
        [Some(x), None, None] => [x, perpendicular(x), x.cross(perpendicular(x))],
        [None, Some(y), None] => [perpendicular(y), y, perpendicular(y).cross(y)],
        [None, None, Some(z)] => [perpendicular(z), z.cross(perpendicular(z)), z],
        [None, None, None] => [DVec3::X, DVec3::Y, DVec3::Z],
    }
}

/// The matrix from an object's coordinates to clip space, in `f64`: what culling and bounds reckon with.
///
/// `rotation` is the turning part of the view ([`Basis::rotation`](crate::Basis::rotation)), `eye` its position.
#[must_use]
pub fn clip_from_model_f64(projection: &DMat4, rotation: &DMat4, eye: DVec3, model: &Placement) -> DMat4 {
    *projection * (*rotation * model.matrix_from(eye))
}

/// The matrix from an object's coordinates to clip space as drawing wants it: columns of `f32`, composed in `f64`
/// by [`clip_from_model_f64`] and rounded once.
///
/// An entry beyond `f32`'s range becomes infinite, one that is not a number stays so; the raster core rejects and
/// counts what such a matrix does to vertices.
#[must_use]
pub fn clip_from_model(projection: &DMat4, rotation: &DMat4, eye: DVec3, model: &Placement) -> [[f32; 4]; 4] {
    rounded(&clip_from_model_f64(projection, rotation, eye, model))
}

/// The columns of a matrix, each entry rounded to the nearest `f32`.
#[must_use]
pub fn rounded(matrix: &DMat4) -> [[f32; 4]; 4] {
    matrix.to_cols_array_2d().map(|column| column.map(|x| x as f32))
}
