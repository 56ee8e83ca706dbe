//! How near a pixel's depth comes to the plane through the depths of the vertices.

use crate::inputs::classes::permuted;
use crate::inputs::rng::Rng;
use crate::judge::{ALONE, Judge, Outcome, Stop, place};
use crate::oracle::coverage::{Vertex, area2, covers, row_span};
use crate::oracle::depth::depth_units_at;

/// Units of 2⁻²⁴, relative, that a depth may be wrong.
const UNITS: f64 = 5.0;

/// Three depths of one of several kinds: anywhere, small, 1, nearly equal.
fn depths(r: &mut Rng) -> [f32; 3] {
    [(); 3].map(|()| {
        let z = match r.index(4) {
            0 => r.unit(),
            1 => r.real(0.5, 1.0) / f64::from(1 << r.index(20)),
            2 => 1.0,
            _ => 0.5 + r.range(-4, 4) as f64 / f64::from(1 << 24),
        };
        (z as f32).max(1e-6)
    })
}

/// A snapped triangle and the depths of its vertices.
type Sheet = ([Vertex; 3], [f32; 3]);

/// Counts the covered pixels of a triangle whose depth is wrong.
fn compare(judge: &mut Judge<'_>, width: usize, (t, z): &Sheet, ids: &[u32], depth: &[f32]) {
    for (j, (depth, ids)) in depth.chunks(width).zip(ids.chunks(width)).enumerate() {
        for i in row_span(t, j as i64, judge.sample, width) {
            if ids[i] == 1 {
                let units = depth_units_at(t, *z, i as i64, j as i64, judge.sample, depth[i]);
                judge.check(units <= UNITS);
            }
        }
    }
}

const SLIVERS: [u32; 2] = [1024, 64];

/// 1,000 px long, one sub-pixel thick; a slope takes them through some samples.
fn all_slivers(sample: [i64; 2]) -> Vec<Sheet> {
    let mut r = Rng::new(110);
    let sliver = |k: usize| {
        let y = sample[1] + 256 * r.range(0, 40);
        let rise = r.range(-3, 3) * 128;
        let (x, off) = if k.is_multiple_of(2) { (6, 0) } else { (500, rise / 2) };
        let t = [[6 * 256, y], [1006 * 256, y + rise], [x * 256, y + 1 + off]];
        let z = if k < 40 { [1.0, 1e-6, 0.5] } else { depths(&mut r) };
        let order = permuted(&[0, 1, 2], k);
        (area2(&t) != 0).then(|| (order.map(|k| t[k]), order.map(|k| z[k])))
    };
    (0..80).filter_map(sliver).collect()
}

/// Which pixels slivers cover.
pub(super) fn slivers(judge: &mut Judge<'_>) -> Outcome {
    for (t, z) in all_slivers(judge.sample) {
        judge.compare(SLIVERS, &t, z)?;
    }
    Ok(())
}

/// Their depth, of which one without has nothing to say.
pub(super) fn sliver_depths(judge: &mut Judge<'_>) -> Outcome {
    for sheet in all_slivers(judge.sample) {
        let v = [0, 1, 2].map(|k| place(sheet.0[k], SLIVERS, sheet.1[k]));
        let drawn = judge.draw(SLIVERS, &v, &ALONE)?;
        let depth = drawn.depth.ok_or(Stop::NotAsked)?;
        // A pixel that is missing has no depth either.
        judge.covers(SLIVERS, &sheet.0, &drawn.ids);
        compare(judge, SLIVERS[0] as usize, &sheet, &drawn.ids, &depth);
    }
    Ok(())
}

/// Forty triangles of up to 2 px around (4000, 2000) of a picture of 4096 × 2048 px, none over another: each covered
/// pixel must show its own, at its depth.
pub(super) fn far_off(judge: &mut Judge<'_>) -> Outcome {
    let size = [4096, 2048];
    let mut r = Rng::new(111);
    let all: Vec<Sheet> = (0..40)
        .map(|k| {
            let corner = [256 * (3990 + 3 * (k % 8)), 256 * (1990 + 3 * (k / 8))];
            ([(); 3].map(|()| corner.map(|c| c + r.range(0, 512))), depths(&mut r))
        })
        .collect();
    let v: Vec<_> = all.iter().flat_map(|(t, z)| [0, 1, 2].map(|k| place(t[k], size, z[k]))).collect();
    let triangles: Vec<_> = (0..40).map(|k| [3 * k, 3 * k + 1, 3 * k + 2]).collect();
    let drawn = judge.draw(size, &v, &triangles)?;
    let depth = drawn.depth.ok_or(Stop::NotAsked)?;
    for (k, (t, z)) in all.iter().enumerate() {
        let (left, top) = (3989 + 3 * (k as i64 % 8), 1989 + 3 * (k as i64 / 8));
        for (i, j) in (0..16).map(|n| (left + n % 4, top + n / 4)) {
            let pixel = (j * 4096 + i) as usize;
            if covers(t, i, j, judge.sample) {
                let units = depth_units_at(t, *z, i, j, judge.sample, depth[pixel]);
                judge.check(drawn.ids[pixel] == k as u32 + 1 && units <= UNITS);
            }
        }
    }
    Ok(())
}

/// From depth 1 at the near plane to a millionth of it. The vertex to start from decides how much is lost.
///
/// Without a depth only pixels can be wrong here; where none is, nothing was asked.
pub(super) fn steep(judge: &mut Judge<'_>) -> Outcome {
    let mut r = Rng::new(112);
    let size = [64, 64];
    let mut asked = true;
    for k in 0..120 {
        let mut x = || r.range(-256 * 100, 256 * 164);
        let xs = [x(), x(), x()];
        let t = [[xs[0], r.range(0, 1280)], [xs[1], r.range(15_000, 20_000)], [xs[2], r.range(0, 20_000)]];
        let z = [1e-6, 1.0, [1e-6, 1.0, 1e-3][r.index(3)]];
        if area2(&t) != 0 {
            let order = permuted(&[0, 1, 2], k);
            let sheet = (order.map(|k| t[k]), order.map(|k| z[k]));
            let drawn = judge.compare(size, &sheet.0, sheet.1)?;
            match &drawn.depth {
                Some(depth) => compare(judge, size[0] as usize, &sheet, &drawn.ids, depth),
                None => asked = false,
            }
        }
    }
    if asked { Ok(()) } else { Err(Stop::NotAsked) }
}
