//! Light and flat shading, in linear light.

use fearless_simd::{Level, dispatch, f32x8, f64x4, prelude::*};
use polosa_math::Placement;
use polosa_math::glam::DVec3;
use polosa_math::view::unit;

use crate::srgb;
use crate::{Camera, Color, Mesh};

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
///
/// All of it in the model's own coordinates, so that a triangle needs no matrix. With L the linear part of the map
/// from the model to camera space, o where it sends the origin, and N its matrix of cofactors, a triangle's normal
/// n = (b − a) × (c − a) becomes N·n. Towards the light l and the viewer v = −(L·a + o):
///
/// ```text
///     (N·n)·l = n·(Nᵀ·l)                                        one vector an object
///     (N·n)·v = −n·(Nᵀ·o) − n·(Nᵀ·L·a) = n·(eye − det·a)         since Nᵀ·L = det·1; eye = −Nᵀ·o
///     |N·n|²  = n·(NᵀN)·n                                       six numbers an object
/// ```
///
/// N is scaled first so that its greatest entry is 1, which changes no ratio and keeps all this inside `f64`'s range.
/// The cosine is `f64` until its last step; its error is a few units of 2⁻⁵³ over the triangle's own sine (the
/// rounding of its cross product), far below the one rounding to `f32`.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Lighting {
    /// Towards the light: Nᵀ·l.
    light: [f64; 3],
    /// Towards the viewer: `eye − det·a`; in a parallel projection the same everywhere, and `det` is 0.
    eye: [f64; 3],
    det: f64,
    /// `NᵀN`: its diagonal, and twice its entries yz, zx, xy.
    square: [f64; 3],
    mixed: [f64; 3],
    ambient: f32,
    shading: Shading,
}

/// Triangles that are shaded at a time.
pub(crate) const LANES: usize = 8;

impl Lighting {
    pub(crate) fn new(light: &Light, shading: Shading, camera: &Camera, placement: &Placement) -> Self {
        let basis = camera.basis();
        let model = placement.matrix_from(camera.position());
        let axes = [model.x_axis, model.y_axis, model.z_axis];
        let [x, y, z] = axes.map(|axis| basis.to_camera(axis.truncate()));
        let origin = basis.to_camera(model.w_axis.truncate());
        let direction = match light.space {
            LightSpace::Camera => light.direction,
            LightSpace::World => basis.to_camera(light.direction),
        };
        let direction = unit(direction).unwrap_or(DVec3::ZERO);
        let cofactors = [y.cross(z), z.cross(x), x.cross(y)];
        let greatest = cofactors.iter().map(|column| column.abs().max_element()).fold(0.0, f64::max);
        let factor = if greatest > 0.0 { 1.0 / greatest } else { 1.0 };
        let [p, q, r] = cofactors.map(|column| column * factor);
        let (toward, det) = if camera.projection().is_parallel() {
            (DVec3::Z, 0.0)
        } else {
            (-origin, x.dot(y.cross(z)) * factor)
        };
        Self {
            light: [p, q, r].map(|column| column.dot(direction)),
            eye: [p, q, r].map(|column| column.dot(toward)),
            det,
            square: [p, q, r].map(|column| column.dot(column)),
            mixed: [2.0 * q.dot(r), 2.0 * r.dot(p), 2.0 * p.dot(q)],
            ambient: light.ambient.clamp(0.0, 1.0),
            shading,
        }
    }

    /// How much of its colour a triangle shows, from the ambient share to 1.
    pub(crate) fn intensity(&self, corners: [[f32; 3]; 3]) -> f32 {
        match self.shading {
            Shading::Unlit => 1.0,
            Shading::Flat => self.flat(corners.map(|corner| corner.map(f64::from))),
        }
    }

    /// The intensities of all triangles of a mesh, in order: the same bits as [`intensity`](Self::intensity)
    /// gives one by one, whatever the vector registers of the machine are.
    pub(crate) fn intensities(&self, level: Level, mesh: &Mesh, out: &mut Vec<f32>) {
        out.clear();
        out.resize(mesh.triangles().len(), 1.0);
        if self.shading == Shading::Flat {
            let (positions, triangles) = (mesh.positions(), mesh.triangles());
            dispatch!(level, simd => self.flat_all(simd, positions, triangles, out));
        }
    }

    /// The intensities of up to eight triangles, those that `asked` has a bit for: the same bits again.
    pub(crate) fn eight(
        &self,
        level: Level,
        positions: &[[f32; 3]],
        triangles: &[[u32; 3]],
        asked: u32,
    ) -> [f32; LANES] {
        let mut out = [1.0; LANES];
        if self.shading != Shading::Flat {
            return out;
        }
        // One or two are sooner done alone.
        if asked.count_ones() > 2 && triangles.len() == LANES {
            dispatch!(level, simd => self.flat_all(simd, positions, triangles, &mut out));
        } else {
            for (lane, triangle) in triangles.iter().enumerate().filter(|(lane, _)| asked >> lane & 1 == 1) {
                out[lane] = self.flat(triangle.map(|vertex| positions[vertex as usize].map(f64::from)));
            }
        }
        out
    }

    #[inline(always)]
    fn flat_all<S: Simd>(&self, simd: S, positions: &[[f32; 3]], triangles: &[[u32; 3]], out: &mut [f32]) {
        let (triangles, rest) = triangles.as_chunks::<LANES>();
        let (out, out_rest) = out.as_chunks_mut::<LANES>();
        for (eight, out) in triangles.iter().zip(out) {
            // Corner by corner, coordinate by coordinate, lane by lane. Loops, since a closure handed to a function
            // of the standard library is compiled without the vector registers' instructions.
            let mut gathered = [[[0.0; LANES]; 3]; 3];
            for (lane, triangle) in eight.iter().enumerate() {
                for corner in 0..3 {
                    let place = &positions[triangle[corner] as usize];
                    for k in 0..3 {
                        gathered[corner][k][lane] = place[k];
                    }
                }
            }
            let mut low = [[f64x4::splat(simd, 0.0); 3]; 3];
            let mut high = low;
            for corner in 0..3 {
                for k in 0..3 {
                    (low[corner][k], high[corner][k]) = f32x8::from_slice(simd, &gathered[corner][k]).widen();
                }
            }
            let direct = self.flat_four(simd, &low).narrow(self.flat_four(simd, &high));
            (direct * (1.0 - self.ambient) + self.ambient).store_slice(out);
        }
        for (triangle, out) in rest.iter().zip(out_rest) {
            *out = self.flat(triangle.map(|vertex| positions[vertex as usize].map(f64::from)));
        }
    }

    /// The direct part of [`flat`](Self::flat) for four triangles: the same operations in the same order.
    #[inline(always)]
    fn flat_four<S: Simd>(&self, simd: S, [a, b, c]: &[[f64x4<S>; 3]; 3]) -> f64x4<S> {
        let (p, q) = ([b[0] - a[0], b[1] - a[1], b[2] - a[2]], [c[0] - a[0], c[1] - a[1], c[2] - a[2]]);
        let x = p[1] * q[2] - p[2] * q[1];
        let y = p[2] * q[0] - p[0] * q[2];
        let z = p[0] * q[1] - p[1] * q[0];
        let [zero, one, det] =
            [f64x4::splat(simd, 0.0), f64x4::splat(simd, 1.0), f64x4::splat(simd, self.det)];
        let ex = f64x4::splat(simd, self.eye[0]) - det * a[0];
        let ey = f64x4::splat(simd, self.eye[1]) - det * a[1];
        let ez = f64x4::splat(simd, self.eye[2]) - det * a[2];
        let toward = (x * ex + y * ey) + z * ez;
        let lit = (x * self.light[0] + y * self.light[1]) + z * self.light[2];
        let lit = toward.simd_lt(0.0).select(-lit, lit);
        let [sx, sy, sz] = self.square;
        let [yz, zx, xy] = self.mixed;
        let straight = (x * x * sx + y * y * sy) + z * z * sz;
        let length = straight + ((y * z * yz + z * x * zx) + x * y * xy);
        let cosine = lit / length.sqrt();
        let at_most_1 = cosine.simd_lt(1.0).select(cosine, one);
        cosine.simd_gt(0.0).select(at_most_1, zero)
    }

    /// Lambert's law for one triangle.
    #[inline]
    fn flat(&self, [a, b, c]: [[f64; 3]; 3]) -> f32 {
        let (p, q) = ([b[0] - a[0], b[1] - a[1], b[2] - a[2]], [c[0] - a[0], c[1] - a[1], c[2] - a[2]]);
        let x = p[1] * q[2] - p[2] * q[1];
        let y = p[2] * q[0] - p[0] * q[2];
        let z = p[0] * q[1] - p[1] * q[0];
        let [ex, ey, ez] = [0, 1, 2].map(|k| self.eye[k] - self.det * a[k]);
        let toward = (x * ex + y * ey) + z * ez;
        let lit = (x * self.light[0] + y * self.light[1]) + z * self.light[2];
        // The side that the viewer sees is the one that is lit.
        let lit = if toward < 0.0 { -lit } else { lit };
        let [sx, sy, sz] = self.square;
        let [yz, zx, xy] = self.mixed;
        let straight = (x * x * sx + y * y * sy) + z * z * sz;
        let length = straight + ((y * z * yz + z * x * zx) + x * y * xy);
        let cosine = lit / length.sqrt();
        // A triangle without area has no normal: ambient light alone.
        let direct = if cosine > 0.0 { if cosine < 1.0 { cosine } else { 1.0 } } else { 0.0 };
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

#[cfg(test)]
mod tests {
    use super::{Light, LightSpace, Lighting, Shading};
    use crate::{Camera, Mesh, Projection, shape};
    use fearless_simd::Level;
    use polosa_math::Placement;
    use polosa_math::glam::{DQuat, DVec3};
    use proptest::prelude::*;

    /// The definition, in camera space.
    fn cosine(light: &Light, camera: &Camera, placement: &Placement, corners: [[f32; 3]; 3]) -> f64 {
        let basis = camera.basis();
        let model = placement.matrix_from(camera.position());
        let [a, b, c] = corners.map(|corner| {
            let point = DVec3::from_array(corner.map(f64::from)).extend(1.0);
            basis.to_camera((model * point).truncate())
        });
        let normal = (b - a).cross(c - a).normalize();
        let viewer = if camera.projection().is_parallel() { DVec3::Z } else { -a };
        let normal = if normal.dot(viewer) < 0.0 { -normal } else { normal };
        let toward = match light.space {
            LightSpace::Camera => light.direction,
            LightSpace::World => basis.to_camera(light.direction),
        };
        normal.dot(toward.normalize()).clamp(0.0, 1.0)
    }

    #[test]
    fn eight_at_a_time_have_the_bits_of_one_by_one() {
        let mesh = shape::uv_sphere(37, 19).unwrap();
        // Rows of other lengths, a triangle without area, one that is not finite.
        let mut positions = mesh.positions().to_vec();
        positions.push([f32::NAN, f32::INFINITY, 1e38]);
        let last = positions.len() as u32 - 1;
        for take in [0, 1, 7, 8, 9, 23, 1000] {
            let mut triangles = mesh.triangles()[..take].to_vec();
            triangles.extend([[0, 0, 1], [0, 1, last], [5, 9, 70]]);
            let mesh = Mesh::new(positions.clone(), triangles).unwrap();
            for parallel in [false, true] {
                let mut camera = Camera::new();
                if parallel {
                    let lens = Projection::Orthographic { height: 2.0, near: 1.0, far: 99.0 };
                    camera.set_projection(lens).unwrap();
                }
                let light = Light { direction: DVec3::new(1.0, 2.0, 0.5), ..Light::default() };
                let placement = Placement { scale: DVec3::new(1.0, -2.0, 0.3), ..Placement::IDENTITY };
                for shading in [Shading::Flat, Shading::Unlit] {
                    let lighting = Lighting::new(&light, shading, &camera, &placement);
                    let mut all = Vec::new();
                    lighting.intensities(Level::new(), &mesh, &mut all);
                    assert_eq!(all.len(), mesh.triangles().len());
                    for (triangle, one) in mesh.triangles().iter().zip(&all) {
                        let corners = triangle.map(|k| mesh.positions()[k as usize]);
                        assert_eq!(one.to_bits(), lighting.intensity(corners).to_bits());
                    }
                }
            }
        }
    }

    proptest! {
        #[test]
        fn it_is_lamberts_cosine_in_camera_space(
            corners in prop::array::uniform3(prop::array::uniform3(-2.0..2.0_f32)),
            scale in prop::array::uniform3(0.01..3.0_f64),
            turn in prop::array::uniform4(-1.0..1.0_f64),
            place in prop::array::uniform3(-5.0..5.0_f64),
            toward in prop::array::uniform3(-1.0..1.0_f64),
            (mirrored, parallel, in_world) in any::<(bool, bool, bool)>(),
        ) {
            let mut camera = Camera::new();
            if parallel {
                camera.set_projection(Projection::Orthographic { height: 2.0, near: 1.0, far: 99.0 }).unwrap();
            }
            let scale = DVec3::from_array(scale) * if mirrored { DVec3::new(1.0, 1.0, -1.0) } else { DVec3::ONE };
            let placement = Placement {
                translation: DVec3::from_array(place),
                rotation: DQuat::from_array(turn).normalize(),
                scale,
            };
            let space = if in_world { LightSpace::World } else { LightSpace::Camera };
            let light = Light { direction: DVec3::from_array(toward), space, ambient: 0.0 };
            let expected = cosine(&light, &camera, &placement, corners);
            let got = Lighting::new(&light, Shading::Flat, &camera, &placement).intensity(corners);
            prop_assert!((f64::from(got) - expected).abs() < 1e-6, "{got} instead of {expected}");
        }
    }
}
