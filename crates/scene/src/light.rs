//! Light and flat shading, in linear light.

use polosa_math::Placement;
use polosa_math::glam::{DMat3, DVec3};
use polosa_math::view::unit;

use crate::srgb;
use crate::{Camera, Color};

/// What a light's direction is fixed to.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, Default)]
pub enum LightSpace {
    /// The camera: (0, 0, 1) shines from the observer, wherever the camera looks.
    #[default]
    Camera,
    /// The world.
    World,
}

/// One directional light, and the ambient light that reaches every side.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Light {
    /// From the object towards the light; any length. Zero or not finite: ambient light alone.
    pub direction: DVec3,
    /// What the direction is fixed to.
    pub space: LightSpace,
    /// The share of ambient light, from 0 to 1; what is turned away from the light has no other.
    pub ambient: f32,
}

impl Default for Light {
    /// From the observer, with a tenth of ambient light.
    fn default() -> Self {
        Self { direction: DVec3::Z, space: LightSpace::Camera, ambient: 0.1 }
    }
}

/// How surfaces are shaded.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, Default)]
pub enum Shading {
    /// Not at all: colours are written as they are.
    Unlit,
    /// Each triangle by its own plane (Lambert's cosine law), on the side that the viewer sees.
    #[default]
    Flat,
}

/// What decides the shade of an object's triangles.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Lighting {
    /// Positions to places relative to the camera: the linear part, and where the model's origin goes.
    linear: DMat3,
    origin: DVec3,
    /// Normals likewise: the matrix of cofactors, which turns cross products of the one into the other's.
    normals: DMat3,
    /// Towards the light and, for a parallel projection, towards the viewer; unit vectors in camera space.
    light: DVec3,
    viewer: Option<DVec3>,
    ambient: f32,
    shading: Shading,
}

impl Lighting {
    pub(crate) fn new(light: &Light, shading: Shading, camera: &Camera, placement: &Placement) -> Self {
        let basis = camera.basis();
        let model = placement.matrix_from(camera.position());
        let axes = [model.x_axis, model.y_axis, model.z_axis];
        let [x, y, z] = axes.map(|axis| basis.to_camera(axis.truncate()));
        let direction = match light.space {
            LightSpace::Camera => light.direction,
            LightSpace::World => basis.to_camera(light.direction),
        };
        Self {
            linear: DMat3::from_cols(x, y, z),
            origin: basis.to_camera(model.w_axis.truncate()),
            normals: DMat3::from_cols(y.cross(z), z.cross(x), x.cross(y)),
            light: unit(direction).unwrap_or(DVec3::ZERO),
            viewer: camera.projection().is_parallel().then_some(DVec3::Z),
            ambient: light.ambient.clamp(0.0, 1.0),
            shading,
        }
    }

    /// How much of its colour a triangle shows, from the ambient share to 1.
    pub(crate) fn intensity(&self, corners: [[f32; 3]; 3]) -> f32 {
        if self.shading == Shading::Unlit {
            return 1.0;
        }
        let [a, b, c] = corners.map(|[x, y, z]| DVec3::new(x.into(), y.into(), z.into()));
        let normal = self.normals * (b - a).cross(c - a);
        let to_viewer = self.viewer.unwrap_or_else(|| -(self.linear * a + self.origin));
        let facing = if normal.dot(to_viewer) < 0.0 { -normal } else { normal };
        let cosine = facing.dot(self.light) / facing.dot(facing).sqrt();
        // A triangle without area has no normal: ambient light alone.
        let direct = if cosine > 0.0 { cosine.min(1.0) } else { 0.0 };
        self.ambient + (1.0 - self.ambient) * direct as f32
    }

    /// A colour at an intensity, as a pixel. At intensity 1 the codes come back unchanged.
    pub(crate) fn pixel(color: Color, intensity: f32) -> u32 {
        let shade = |code| srgb::encode(srgb::decode(code) * intensity);
        Color::new(shade(color.r), shade(color.g), shade(color.b)).to_u32()
    }

    /// Three colours blended by weights in linear light, at an intensity.
    pub(crate) fn blend(colors: [Color; 3], weights: [f32; 3], intensity: f32) -> u32 {
        let channel = |of: fn(Color) -> u8| {
            let [a, b, c] = colors.map(|color| srgb::decode(of(color)));
            let light = (a * weights[0] + b * weights[1]) + c * weights[2];
            srgb::encode(light * intensity)
        };
        Color::new(channel(|c| c.r), channel(|c| c.g), channel(|c| c.b)).to_u32()
    }
}
