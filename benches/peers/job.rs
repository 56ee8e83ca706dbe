//! What is to be drawn, in the terms that all renderers share.

use polosa_benches::mesh::{self, COUNTS, dented_ball};
use polosa_benches::workloads::{HEIGHT, SIZES, Soup, TINY, WIDTH};
use polosa_math::Placement;
use polosa_math::glam::DVec3;
use polosa_scene::{Camera, Color, Light, srgb};

/// Where vertices come from.
pub(crate) enum Vertices {
    /// Clip space.
    Clip(Vec<[f32; 4]>),
    /// Positions, and the matrix (by columns) that takes them to clip space.
    Model { positions: Vec<[f32; 3]>, matrix: [[f32; 4]; 4] },
}

/// One colour, and a light that shines on flat faces: Lambert's law in linear light, encoded as sRGB.
pub(crate) struct Lit {
    pub(crate) color: Color,
    /// Towards the light, in model space, of length 1.
    pub(crate) direction: [f32; 3],
    pub(crate) ambient: f32,
    /// The camera that the job's matrix is from: polosa's renderer is asked for the whole frame.
    pub(crate) camera: Camera,
}

/// A picture to be drawn: cleared to 0 first, tested and written depth.
pub(crate) struct Job {
    pub(crate) name: String,
    pub(crate) size: [u32; 2],
    pub(crate) vertices: Vertices,
    pub(crate) indices: Vec<[u32; 3]>,
    /// `None`: the number of the triangle plus one is its colour, and both its sides are drawn. Otherwise back
    /// faces are left out.
    pub(crate) lit: Option<Lit>,
}

impl Job {
    /// The names of all jobs, those that `--workload` may name.
    pub(crate) fn names() -> Vec<String> {
        let mut names = Vec::new();
        for size in SIZES {
            names.push(size.name.to_owned());
            names.push(format!("{}-perspective", size.name));
        }
        names.push("tiny-transform".to_owned());
        names.extend(COUNTS.map(mesh_name));
        names
    }

    /// The jobs that are run when none is named: the quoted figures.
    pub(crate) fn quoted() -> Vec<String> {
        Self::names().into_iter().filter(|name| !name.ends_with("perspective")).collect()
    }

    /// The job of a name.
    pub(crate) fn named(name: &str) -> Option<Self> {
        if let Some(count) = COUNTS.into_iter().find(|&count| mesh_name(count) == name) {
            return Some(Self::mesh(count));
        }
        let (base, form) = name.split_once('-').unwrap_or((name, ""));
        let soup = Soup::of(SIZES.into_iter().find(|size| size.name == base)?);
        let vertices = match form {
            "" => Vertices::Clip(soup.flat()),
            "perspective" => Vertices::Clip(soup.perspective()),
            "transform" if base == TINY.name => {
                Vertices::Model { positions: soup.positions(), matrix: soup.matrix() }
            }
            _ => return None,
        };
        Some(Self { name: name.to_owned(), size: soup.size, vertices, indices: soup.indices, lit: None })
    }

    /// A dented ball of about `count` triangles, stretched to fill two thirds of the picture, seen from a little
    /// right and above, with the light at the observer.
    fn mesh(count: u32) -> Self {
        let mesh::Mesh { mut positions, triangles } = dented_ball(count);
        for [x, _, _] in &mut positions {
            *x *= 1.75;
        }
        let mut camera = Camera::new();
        camera.set_aspect(f64::from(WIDTH) / f64::from(HEIGHT)).expect("the aspect is positive");
        let points = positions.iter().map(|p| DVec3::from_array(p.map(f64::from)));
        camera
            .frame_points(points, DVec3::new(0.2, 0.3, 1.0), DVec3::Y, 0.01)
            .expect("the ball can be framed");
        let matrix = camera.clip_from_model(&Placement::IDENTITY);
        let direction = (-camera.direction().normalize()).to_array().map(|x| x as f32);
        let ambient = Light::default().ambient;
        let lit = Lit { color: Color::LIGHT_GREY, direction, ambient, camera };
        Self {
            name: mesh_name(count),
            size: [WIDTH, HEIGHT],
            vertices: Vertices::Model { positions, matrix },
            indices: triangles,
            lit: Some(lit),
        }
    }

    /// The colour of a triangle that is not lit.
    pub(crate) fn number(triangle: usize) -> u32 {
        triangle as u32 + 1
    }
}

impl Lit {
    /// The colour in linear light.
    pub(crate) fn linear(&self) -> [f32; 3] {
        let Color { r, g, b, .. } = self.color;
        [r, g, b].map(srgb::decode)
    }

    /// The pixel of each triangle, for the renderers that have no stage for this: in `f32`, once a triangle.
    pub(crate) fn pixels(&self, positions: &[[f32; 3]], triangles: &[[u32; 3]], out: &mut Vec<u32>) {
        let linear = self.linear();
        out.clear();
        out.extend(triangles.iter().map(|triangle| {
            let [a, b, c] = triangle.map(|k| positions[k as usize]);
            let normal = normal(a, b, c);
            let direct = (0..3).map(|k| normal[k] * self.direction[k]).sum::<f32>().max(0.0);
            let intensity = self.ambient + (1.0 - self.ambient) * direct;
            let [r, g, b] = linear.map(|light| u32::from(srgb::encode(light * intensity)));
            r << 16 | g << 8 | b
        }));
    }
}

/// The normal of a face, of length 1; not a number if the face has no area.
pub(crate) fn normal(a: [f32; 3], b: [f32; 3], c: [f32; 3]) -> [f32; 3] {
    let minus = |p: [f32; 3], q: [f32; 3]| [p[0] - q[0], p[1] - q[1], p[2] - q[2]];
    let (u, v) = (minus(b, a), minus(c, a));
    let [x, y, z] = [u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]];
    let length = (x * x + y * y + z * z).sqrt();
    [x, y, z].map(|part| part / length)
}

fn mesh_name(count: u32) -> String {
    format!("mesh-{}k", count / 1000)
}
