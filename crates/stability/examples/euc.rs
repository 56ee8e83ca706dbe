//! Runs the suite on [euc](https://crates.io/crates/euc) and prints the table.
//!
//! ```sh
//! cargo run --release -p polosa-stability --example euc
//! ```
//!
//! euc takes triangles in clip space and tests depth, but cuts nothing off at the near plane; a triangle's number
//! travels to its pixels as a value that is not interpolated.

use euc::buffer::Buffer2d;
use euc::rasterizer::{BackfaceCullingDisabled, Triangles};
use euc::{DepthStrategy, Interpolate, Pipeline};
use polosa_stability::{Abilities, Drawn, Job, Rasteriser, Verdict, run};

struct Euc;

impl Rasteriser for Euc {
    fn draw(&mut self, job: &Job<'_>) -> Drawn {
        let size = [job.width as usize, job.height as usize];
        let (mut ids, mut depth) = (Buffer2d::new(size, 0), Buffer2d::new(size, 0.0));
        let corners: Vec<_> = (1..).zip(job.triangles).flat_map(|(id, t)| t.map(|k| (k, Id(id)))).collect();
        Scene(job.vertices).draw::<Triangles<'_, _, BackfaceCullingDisabled>, _>(
            &corners,
            &mut ids,
            Some(&mut depth),
        );
        Drawn { ids: ids.as_ref().to_vec(), depth: Some(depth.as_ref().to_vec()) }
    }

    fn abilities(&self) -> Abilities {
        Abilities { clips: false, ..Abilities::default() }
    }
}

/// A number that is the same all over a triangle.
#[derive(Clone)]
struct Id(u32);

impl Interpolate for Id {
    fn lerp2(a: Self, _: Self, _: f32, _: f32) -> Self {
        a
    }

    fn lerp3(a: Self, _: Self, _: Self, _: f32, _: f32, _: f32) -> Self {
        a
    }
}

struct Scene<'a>(&'a [[f32; 4]]);

impl Pipeline for Scene<'_> {
    type Vertex = (u32, Id);
    type VsOut = Id;
    type Pixel = u32;

    fn vert(&self, (k, id): &(u32, Id)) -> ([f32; 4], Id) {
        (self.0[*k as usize], id.clone())
    }

    fn frag(&self, id: &Id) -> u32 {
        id.0
    }

    fn get_depth_strategy(&self) -> DepthStrategy {
        DepthStrategy::IfMoreWrite
    }
}

#[expect(clippy::print_stdout, reason = "the table is what it is for")]
fn main() {
    let report = run(&mut Euc);
    println!("{report}");
    assert_eq!(report.verdict("collinear triangle"), Some(Verdict::Pass));
    assert_eq!(report.verdict("floor through the near plane"), Some(Verdict::NotAsked));
}
