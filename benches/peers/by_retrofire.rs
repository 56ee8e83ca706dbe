//! retrofire-core: vertex function, clip, scanlines, fragment function.
//!
//! Its depth is 1/w, whatever z is. Clip space with w = 1 would be without depth, so it is given the perspective
//! form of such vertices: the same places on the screen, and 1/w where z/w was.

use ::retrofire_core::geom::{Tri, Vertex, tri, vertex};
use ::retrofire_core::math::mat::viewport;
use ::retrofire_core::math::vary::{Iter, ZDiv};
use ::retrofire_core::math::{Color4, Lerp, Mat4, ProjVec3, Vary, pt2, rgba};
use ::retrofire_core::render::ctx::{Context, FaceCull};
use ::retrofire_core::render::target::{Colorbuf, Framebuf};
use ::retrofire_core::render::{Frag, Ndc, Screen, render, shader};
use ::retrofire_core::util::pixfmt::Xrgb8888;
use ::retrofire_core::util::{Buf2, Dims};

use crate::by_euc::corners;
use crate::contestant::{Contestant, time};
use crate::job::{Job, Vertices};

pub(crate) struct Retrofire<'a> {
    job: &'a Job,
    /// Clip vertices in perspective; empty if there is a transform.
    clip: Vec<[f32; 4]>,
    corners: Vec<[u32; 2]>,
    triangles: Vec<Tri<usize>>,
    pixels: Vec<u32>,
    frame: Framebuf<Colorbuf<Buf2<u32>, Xrgb8888>, Buf2<f32>>,
    to_screen: Mat4<Ndc, Screen>,
    context: Context,
}

/// What the shaders see.
#[derive(Clone, Copy)]
struct Uniform<'a> {
    clip: &'a [[f32; 4]],
    positions: &'a [[f32; 3]],
    matrix: &'a [[f32; 4]; 4],
    pixels: &'a [u32],
}

impl<'a> Retrofire<'a> {
    pub(crate) fn new(job: &'a Job) -> Self {
        let [width, height] = job.size;
        let clip = match &job.vertices {
            Vertices::Clip(vertices) => vertices.iter().map(|&vertex| perspective(vertex)).collect(),
            Vertices::Model { .. } => Vec::new(),
        };
        let color_buf = Colorbuf::new(Buf2::new(Dims(width, height)));
        let frame = Framebuf { color_buf, depth_buf: Buf2::new(Dims(width, height)) };
        // Rows from top to bottom: y is turned over, and with it what is taken for a front face.
        let to_screen = viewport(pt2(0, height)..pt2(width, 0));
        let face_cull = job.lit.is_some().then_some(FaceCull::Front);
        let context = Context { face_cull, ..Context::default() };
        let corners = corners(job);
        let triangles = (0..job.indices.len()).map(|k| tri(3 * k, 3 * k + 1, 3 * k + 2)).collect();
        Self { job, clip, corners, triangles, pixels: Vec::new(), frame, to_screen, context }
    }
}

/// The vertex with w = 1/depth.
fn perspective([x, y, z, w]: [f32; 4]) -> [f32; 4] {
    if w == 1.0 { [x / z, y / z, 1.0, 1.0 / z] } else { [x, y, z, w] }
}

impl Contestant for Retrofire<'_> {
    fn name(&self) -> String {
        "retrofire-core".to_owned()
    }

    fn threads(&self) -> usize {
        1
    }

    fn frames(&mut self, count: u32) -> Result<Vec<u64>, String> {
        let Self { job, clip, corners, triangles, pixels, frame, to_screen, context } = self;
        Ok(time(count, || {
            frame.color_buf.buf.fill(0);
            frame.depth_buf.fill(0.0);
            let uniform = match &job.vertices {
                Vertices::Clip(_) => Uniform { clip, positions: &[], matrix: &[[0.0; 4]; 4], pixels: &[] },
                Vertices::Model { positions, matrix } => {
                    if let Some(lit) = &job.lit {
                        lit.pixels(positions, &job.indices, pixels);
                    }
                    Uniform { clip: &[], positions, matrix, pixels }
                }
            };
            let shader = shader::new(place, paint);
            render(&triangles[..], &corners[..], &shader, uniform, *to_screen, frame, context);
        }))
    }

    fn picture(&mut self) -> Result<Vec<u32>, String> {
        Ok(self.frame.color_buf.buf.data().to_vec())
    }
}

#[inline(always)]
fn place([number, triangle]: [u32; 2], uniform: Uniform<'_>) -> Vertex<ProjVec3, Flat> {
    let at = match uniform.clip.get(number as usize) {
        Some(&at) => at,
        None => polosa_raster::transform_point(uniform.matrix, uniform.positions[number as usize]),
    };
    let [_, r, g, b] = uniform.pixels.get(triangle as usize).copied().unwrap_or(triangle + 1).to_be_bytes();
    vertex(ProjVec3::new(at), Flat(rgba(r, g, b, 0)))
}

#[inline(always)]
fn paint(fragment: Frag<Flat>, _: Uniform<'_>) -> Color4 {
    fragment.var.0
}

/// A value that is the same at a triangle's three corners.
#[derive(Clone, Debug)]
struct Flat(Color4);

impl Lerp for Flat {
    #[inline(always)]
    fn lerp(&self, _: &Self, _: f32) -> Self {
        self.clone()
    }
}

impl ZDiv for Flat {}

impl Vary for Flat {
    type Iter = Iter<Self>;
    type Diff = ();

    #[inline(always)]
    fn vary(self, (): (), n: Option<u32>) -> Iter<Self> {
        Iter { val: self, step: (), n }
    }

    #[inline(always)]
    fn dv_dt(&self, _: &Self, _: f32) {}

    #[inline(always)]
    fn step(&self, (): &()) -> Self {
        self.clone()
    }
}
