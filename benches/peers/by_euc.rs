//! euc: triangles through a vertex and a fragment function, depth in a buffer.
//!
//! Its triangles take three vertices each, so that a shared vertex is transformed as often as it is used. A value
//! that is the same over a triangle travels as an attribute whose interpolation is to take the first.

use ::euc::buffer::Buffer2d;
use ::euc::rasterizer::{BackfaceCullingDisabled, BackfaceCullingEnabled, Triangles};
use ::euc::{DepthStrategy, Interpolate, Pipeline, Target as _};

use crate::contestant::{Contestant, time};
use crate::job::{Job, Vertices};

/// The number of a vertex, and that of the triangle which asks for it.
type Corner = [u32; 2];

pub(crate) struct Euc<'a> {
    job: &'a Job,
    corners: Vec<Corner>,
    /// The pixels of lit triangles; empty if they are not lit.
    pixels: Vec<u32>,
    color: Buffer2d<u32>,
    depth: Buffer2d<f32>,
}

impl<'a> Euc<'a> {
    pub(crate) fn new(job: &'a Job) -> Self {
        let size = job.size.map(|side| side as usize);
        let (color, depth) = (Buffer2d::new(size, 0), Buffer2d::new(size, 0.0));
        Self { job, corners: corners(job), pixels: Vec::new(), color, depth }
    }
}

/// The vertices of each triangle, one after the other.
pub(crate) fn corners(job: &Job) -> Vec<Corner> {
    (0..).zip(&job.indices).flat_map(|(number, triangle)| triangle.map(|k| [k, number])).collect()
}

impl Contestant for Euc<'_> {
    fn name(&self) -> String {
        "euc".to_owned()
    }

    fn threads(&self) -> usize {
        1
    }

    fn frames(&mut self, count: u32) -> Result<Vec<u64>, String> {
        let Self { job, corners, pixels, color, depth } = self;
        Ok(time(count, || {
            color.clear(0);
            depth.clear(0.0);
            match (&job.vertices, &job.lit) {
                (Vertices::Clip(vertices), _) => {
                    Clip(vertices).draw::<Triangles<'_, _, BackfaceCullingDisabled>, _>(
                        corners,
                        color,
                        Some(depth),
                    );
                }
                (Vertices::Model { positions, matrix }, None) => {
                    let model = Model { positions, matrix, pixels: &[] };
                    model.draw::<Triangles<'_, _, BackfaceCullingDisabled>, _>(corners, color, Some(depth));
                }
                (Vertices::Model { positions, matrix }, Some(lit)) => {
                    lit.pixels(positions, &job.indices, pixels);
                    let model = Model { positions, matrix, pixels };
                    model.draw::<Triangles<'_, _, BackfaceCullingEnabled>, _>(corners, color, Some(depth));
                }
            }
        }))
    }

    fn picture(&mut self) -> Result<Vec<u32>, String> {
        Ok(self.color.as_ref().to_vec())
    }
}

/// A value that is the same at a triangle's three corners.
#[derive(Clone)]
struct Flat(u32);

impl Interpolate for Flat {
    #[inline(always)]
    fn lerp2(a: Self, _: Self, _: f32, _: f32) -> Self {
        a
    }

    #[inline(always)]
    fn lerp3(a: Self, _: Self, _: Self, _: f32, _: f32, _: f32) -> Self {
        a
    }
}

/// Vertices in clip space; a triangle's number is its colour.
struct Clip<'a>(&'a [[f32; 4]]);

impl Pipeline for Clip<'_> {
    type Vertex = Corner;
    type VsOut = Flat;
    type Pixel = u32;

    #[inline(always)]
    fn vert(&self, &[vertex, triangle]: &Corner) -> ([f32; 4], Flat) {
        (self.0[vertex as usize], Flat(triangle + 1))
    }

    #[inline(always)]
    fn frag(&self, value: &Flat) -> u32 {
        value.0
    }

    #[inline(always)]
    fn get_depth_strategy(&self) -> DepthStrategy {
        DepthStrategy::IfMoreWrite
    }
}

/// Vertices to be transformed; a triangle's pixel, or its number where there are no pixels.
struct Model<'a> {
    positions: &'a [[f32; 3]],
    matrix: &'a [[f32; 4]; 4],
    pixels: &'a [u32],
}

impl Pipeline for Model<'_> {
    type Vertex = Corner;
    type VsOut = Flat;
    type Pixel = u32;

    #[inline(always)]
    fn vert(&self, &[vertex, triangle]: &Corner) -> ([f32; 4], Flat) {
        let place = polosa_raster::transform_point(self.matrix, self.positions[vertex as usize]);
        (place, Flat(self.pixels.get(triangle as usize).copied().unwrap_or(triangle + 1)))
    }

    #[inline(always)]
    fn frag(&self, value: &Flat) -> u32 {
        value.0
    }

    #[inline(always)]
    fn get_depth_strategy(&self) -> DepthStrategy {
        DepthStrategy::IfMoreWrite
    }
}
