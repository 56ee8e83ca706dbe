//! Claim: whatever a rasteriser does, short of never coming back, the suite ends with the verdict that belongs to it.

use polosa_stability::oracle::coverage::row_span;
use polosa_stability::oracle::snap::snap;
use polosa_stability::{Abilities, Drawn, Job, Rasteriser, Verdict, run, scenes};

/// A closure that draws, and what it claims.
struct Fake<F>(F, Abilities);

impl<F: FnMut(&Job<'_>) -> Drawn> Rasteriser for Fake<F> {
    fn draw(&mut self, job: &Job<'_>) -> Drawn {
        self.0(job)
    }

    fn abilities(&self) -> Abilities {
        self.1
    }
}

fn verdicts(draw: impl FnMut(&Job<'_>) -> Drawn) -> Vec<Verdict> {
    run(&mut Fake(draw, Abilities::default())).rows().iter().map(|&(_, verdict)| verdict).collect()
}

fn of(draw: impl FnMut(&Job<'_>) -> Drawn, name: &str) -> Verdict {
    let scene = scenes().iter().find(|scene| scene.name == name).unwrap();
    scene.run(&mut Fake(draw, Abilities::default()))
}

#[test]
fn names_are_different_and_numbers_ascend() {
    for (k, scene) in scenes().iter().enumerate() {
        assert!(scenes()[..k].iter().all(|before| before.name != scene.name), "{scene:?}");
        assert!(scenes()[..k].iter().all(|before| before.number <= scene.number), "{scene:?}");
        assert!(!(18..=21).contains(&scene.number), "{scene:?}: a number for others");
    }
}

#[test]
fn pictures_that_are_too_small_or_too_large_are_wrong_and_no_panic() {
    for verdict in verdicts(|_| Drawn { ids: Vec::new(), depth: Some(Vec::new()) }) {
        assert!(matches!(verdict, Verdict::Wrong { .. } | Verdict::NotANumber), "{verdict}");
    }
    let black =
        |job: &Job<'_>| Drawn { ids: vec![0; job.pixels() + 9], depth: Some(vec![0.0; job.pixels() + 1]) };
    assert_eq!(of(black, "collinear triangle"), Verdict::Pass);
    assert_eq!(of(black, "mesh on pixel centres"), Verdict::Wrong { pixels: 3 * 60 * 60 });
}

#[test]
fn any_bits_at_all_end_in_a_verdict() {
    for bits in [u32::MAX, 0x7F80_0000, 1] {
        let depth = f32::from_bits(bits);
        let draw =
            |job: &Job<'_>| Drawn { ids: vec![bits; job.pixels()], depth: Some(vec![depth; job.pixels()]) };
        let all = verdicts(draw);
        let wrong = all.iter().filter(|v| matches!(v, Verdict::Wrong { .. } | Verdict::NotANumber)).count();
        assert!(wrong >= all.len() - 1, "only one scene compares pictures with each other: {all:?}");
        assert!(!all.contains(&Verdict::Panic), "{all:?}");
        assert_eq!(all.contains(&Verdict::NotANumber), depth.is_nan());
    }
}

#[test]
fn what_is_not_claimed_is_not_asked() {
    let able = Abilities { clips: false, hides: false, ..Abilities::default() };
    let black = |job: &Job<'_>| Drawn { ids: vec![0; job.pixels()], depth: None };
    let report = run(&mut Fake(black, able));
    for name in ["floor through the near plane", "a soup of triangles", "2 px triangles at (4000, 2000)"] {
        assert_eq!(report.verdict(name), Some(Verdict::NotAsked), "{name}");
    }
    assert_eq!(report.verdict("no such scene"), None);
}

/// A rasteriser of its own sample and rule: the half-planes themselves, drawn in order.
fn half_planes(job: &Job<'_>, sample: [i64; 2], closed_left: bool) -> Drawn {
    let mut ids = vec![0; job.pixels()];
    for (t, id) in job.triangles.iter().zip(1..) {
        let finite = t.iter().all(|&k| job.vertices[k as usize].iter().all(|c| c.is_finite()));
        if !finite {
            continue;
        }
        let corners = t.map(|k| snap(job.vertices[k as usize], job.width, job.height));
        let [Some(a), Some(b), Some(c)] = corners else { continue };
        // Right and bottom edges in instead of left and top ones: the picture of the mirrored triangle, mirrored.
        let mirror = |v: [i64; 2]| if closed_left { v } else { v.map(|c| -c) };
        let ys = [a, b, c].map(|v| v[1].div_euclid(256));
        let [top, bottom] = [ys.into_iter().min(), ys.into_iter().max()].map(Option::unwrap);
        for j in top.max(0)..=bottom.min(i64::from(job.height) - 1) {
            let t = [a, b, c].map(mirror);
            let width = job.width as usize;
            let row = if closed_left { j } else { -j - 1 };
            let shifted = t.map(|v| if closed_left { v } else { [v[0] + 256 * i64::from(job.width), v[1]] });
            let sample = if closed_left { sample } else { sample.map(|s| 256 - s) };
            for i in row_span(&shifted, row, sample, width) {
                let i = if closed_left { i } else { width - 1 - i };
                ids[j as usize * width + i] = id;
            }
        }
    }
    Drawn { ids, depth: None }
}

#[test]
fn another_sample_and_another_rule_pass_if_they_are_claimed() {
    let able = |sample, top_left| Abilities { clips: false, hides: false, top_left, sample };
    let failures = |draw: &mut dyn FnMut(&Job<'_>) -> Drawn, able| {
        let report = run(&mut Fake(draw, able));
        let failed = report.rows().iter().filter(|(_, v)| !matches!(v, Verdict::Pass | Verdict::NotAsked));
        // The rational snap has no answer for numbers of very different size.
        failed
            .filter(|(scene, _)| ![22, 30].contains(&scene.number))
            .map(|(scene, _)| scene.name)
            .collect::<Vec<_>>()
    };
    assert_eq!(failures(&mut |job| half_planes(job, [128, 128], true), able([128, 128], true)), [""; 0]);
    assert_eq!(failures(&mut |job| half_planes(job, [64, 200], true), able([64, 200], true)), [""; 0]);
    assert_eq!(failures(&mut |job| half_planes(job, [128, 128], false), able([128, 128], false)), [""; 0]);
    let other_rule = failures(&mut |job| half_planes(job, [128, 128], false), able([128, 128], true));
    assert!(other_rule.contains(&"micro-triangles, every tie"), "{other_rule:?}");
}

#[test]
fn without_a_depth_scenes_of_depth_are_not_asked_and_pixels_they_find_wrong_stay_wrong() {
    let [slivers, depths, steep] =
        ["sliver, 1000 × 1/256 px", "depth of such slivers", "depth of steep floors"];
    let right = |job: &Job<'_>| half_planes(job, [128, 128], true);
    assert_eq!(of(right, slivers), Verdict::Pass);
    assert_eq!(of(right, depths), Verdict::NotAsked);
    assert_eq!(of(right, steep), Verdict::NotAsked);
    let black = |job: &Job<'_>| Drawn { ids: vec![0; job.pixels()], depth: None };
    assert!(matches!(of(black, slivers), Verdict::Wrong { .. }));
    assert_eq!(of(black, depths), Verdict::NotAsked);
    assert!(matches!(of(black, steep), Verdict::Wrong { .. }));
    let everywhere_at_the_far_plane =
        |job: &Job<'_>| Drawn { depth: Some(vec![0.0; job.pixels()]), ..half_planes(job, [128, 128], true) };
    assert!(matches!(of(everywhere_at_the_far_plane, depths), Verdict::Wrong { .. }));
    assert!(matches!(of(everywhere_at_the_far_plane, steep), Verdict::Wrong { .. }));
}
