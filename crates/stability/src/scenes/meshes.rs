//! Triangles that share edges: no pixel is missed, none is drawn twice.

use crate::inputs::mesh::{Mesh, fan, grid, scattered};
use crate::inputs::rng::Rng;
use crate::judge::{Judge, Outcome, Times, place};

/// A regular grid and displaced ones, all vertices on samples.
pub(super) fn on_centres(judge: &mut Judge<'_>) -> Outcome {
    let mut r = Rng::new(80);
    let low = judge.sample;
    let high = low.map(|c| c + 256 * 60);
    let meshes = [
        grid(low, high, 12, |p| p),
        grid(low, high, 10, |p| p.map(|c| c + 256 * r.range(-2, 2))),
        scattered(low, high, 120, &mut Rng::new(81), 256),
    ];
    for mesh in meshes {
        judge.rectangle([64, 64], (&mesh.vertices, &mesh.triangles), low, high)?;
    }
    Ok(())
}

/// 64 triangles around a point of a picture that lies wholly inside: on a sample, on a corner, on neither.
fn fans(judge: &mut Judge<'_>, radius: f64) -> Outcome {
    let size = [256, 256];
    let centres = [[128 * 256; 2], judge.sample.map(|c| c + 100 * 256), [131 * 256 + 77, 90 * 256 + 201]];
    for centre in centres {
        let Mesh { vertices, triangles } = fan(centre, radius * 256.0);
        let v: Vec<_> = vertices.iter().map(|&v| place(v, size, 0.5)).collect();
        judge.mesh(size, &v, &triangles, |_| Times::Once)?;
    }
    Ok(())
}

pub(super) fn fan_400(judge: &mut Judge<'_>) -> Outcome {
    fans(judge, 400.0)
}

pub(super) fn fan_16_000(judge: &mut Judge<'_>) -> Outcome {
    fans(judge, 16_000.0)
}

/// Beyond what Direct3D's 16.8 bits hold: the spokes must be clipped, or be drawn with wider numbers.
/// (The rim is rounded to `f32`; neighbours share the rounded vertices.)
pub(super) fn fan_1_000_000(judge: &mut Judge<'_>) -> Outcome {
    fans(judge, 1_000_000.0)
}

/// 71 × 71 cells of .85 px, their corners displaced: most triangles cover no sample, the others one.
pub(super) fn fine(judge: &mut Judge<'_>) -> Outcome {
    let mut r = Rng::new(82);
    let (low, high) = ([520, 530], [520 + 71 * 217, 530 + 71 * 217]);
    let mesh = grid(low, high, 71, |p| p.map(|c| c + r.range(-43, 43)));
    judge.rectangle([64, 64], (&mesh.vertices, &mesh.triangles), low, high)
}

/// A mesh over the whole picture, its vertices anywhere that an `f32` can be.
pub(super) fn unsnapped(judge: &mut Judge<'_>) -> Outcome {
    let mut r = Rng::new(83);
    for n in [6, 20] {
        let mut mesh = grid([-2 * 256; 2], [66 * 256; 2], n, |p| p);
        let cell = 68.0 / n as f64 / 32.0; // In clip space.
        let v: Vec<_> = mesh
            .vertices
            .drain(..)
            .map(|v| {
                let [x, y, z, w] = place(v, [64, 64], 0.5);
                let mut beside =
                    |c: f32| if c.abs() > 1.0 { c } else { c + (cell * r.real(-0.3, 0.3)) as f32 };
                [beside(x), beside(y), z, w]
            })
            .collect();
        judge.mesh([64, 64], &v, &mesh.triangles, |_| Times::Once)?;
    }
    Ok(())
}
