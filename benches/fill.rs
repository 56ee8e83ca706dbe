//! The fill of the raster core: triangles of one size each, with depth, beside what the machine itself can do.
//!
//! ```sh
//! cargo bench -p polosa-benches --no-default-features --bench fill
//! cargo bench --bench fill -- soup/          # one group, or whatever matches
//! cargo bench --bench fill -- --save-baseline before
//! ```
//!
//! | group | what it draws, or does |
//! |---|---|
//! | `quoted` | the three soups of the tables in the docs: from clip space by every path, with one thread and two and at every level of vector instructions, in perspective, and with transform |
//! | `soup` | triangles of 2 px to the full screen, with depth |
//! | `no depth` | the full screen as a triangle pair, without depth |
//! | `clear` | colour and depth |
//! | `memset` | `fill` of a slice, from what fits in the nearest cache to what fits in none |
//! | `ceiling` | depth test and store over a tile in the nearest cache: see `ceiling.rs` |
//!
//! The triangles are the same in every run (own generator, fixed seed). Before a soup is timed its picture is drawn
//! by every path and by asking for each fragment: all must be the same, in colour and in depth.

use std::hint::black_box;
use std::time::Duration;

use criterion::{BenchmarkId, Criterion, Throughput, criterion_group, criterion_main};
use fearless_simd::Level;
use polosa_benches::ceiling::{self, Plane, SIDE, Tile};
use polosa_benches::ours::{Path, Picture};
use polosa_benches::workloads::{AREAS, HEIGHT, SIZES, Soup, TINY, WIDTH};
use polosa_raster::{Depth, DepthTest, Flat, Fragment, State, Target, Vertices};

/// Three seconds a figure at most: the whole stays under three minutes.
fn brief() -> Criterion {
    Criterion::default()
        .warm_up_time(Duration::from_millis(300))
        .measurement_time(Duration::from_millis(1_500))
        .sample_size(20)
}

/// The value of a triangle: what a shaded mesh would have computed for it.
fn value(triangle: usize) -> u32 {
    triangle as u32 + 1
}

/// Every path, and every fragment asked for, must give one picture, and one that shows something.
fn check(vertices: &[[f32; 4]], indices: &[[u32; 3]]) {
    let mut asked = Picture::new([WIDTH, HEIGHT]);
    let shade = |fragment: &Fragment<'_>, pixel: &mut u32| {
        *pixel = value(fragment.triangle());
        true
    };
    let mut target = asked.target();
    target.clear(0, DepthTest::Greater);
    let stats = target.triangles(&State::default(), vertices, indices, &shade);
    assert_eq!(stats.drawn + stats.degenerate + stats.outside, indices.len() as u64);
    assert!(asked.color.iter().any(|&pixel| pixel != 0), "an empty picture");
    for mut path in every() {
        let mut picture = Picture::new([WIDTH, HEIGHT]);
        path.draw(&mut picture, Vertices::Clip(vertices), indices, &value);
        assert!(picture.color == asked.color, "{} has other pixels", path.name());
        assert!(!path.writes_depth() || picture.depth == asked.depth, "{} has other depths", path.name());
    }
}

/// All ways to draw: one thread and two, at every level.
fn every() -> Vec<Path> {
    let mut all = Path::all(1);
    all.extend(Path::all(2));
    all.push(Path::without_depth());
    all.extend(Path::levels());
    all
}

fn quoted(c: &mut Criterion) {
    let mut group = c.benchmark_group("quoted");
    let mut picture = Picture::new([WIDTH, HEIGHT]);
    let mut time = |name: String, paths: Vec<Path>, vertices: Vertices<'_>, soup: &Soup| {
        group.throughput(Throughput::Elements(soup.indices.len() as u64));
        for mut path in paths {
            group.bench_function(BenchmarkId::new(&name, path.name()), |b| {
                b.iter(|| path.draw(&mut picture, black_box(vertices), &soup.indices, &value));
            });
        }
    };
    for size in SIZES {
        let soup = Soup::of(size);
        let (flat, perspective) = (soup.flat(), soup.perspective());
        check(&flat, &soup.indices);
        check(&perspective, &soup.indices);
        time(format!("{}, clip space", size.name), every(), Vertices::Clip(&flat), &soup);
        time(format!("{}, perspective", size.name), Path::all(1), Vertices::Clip(&perspective), &soup);
    }
    let soup = Soup::of(TINY);
    let (matrix, positions) = (soup.matrix(), soup.positions());
    let vertices = Vertices::Model { matrix: &matrix, positions: &positions };
    let mut paths = Path::all(1);
    paths.extend(Path::all(2));
    time("tiny, with transform".to_owned(), paths, vertices, &soup);
    group.finish();
}

fn soups(c: &mut Criterion) {
    let mut group = c.benchmark_group("soup");
    let mut picture = Picture::new([WIDTH, HEIGHT]);
    for (area, count) in AREAS {
        let soup = Soup::of_area(area, count);
        let vertices = soup.flat();
        check(&vertices, &soup.indices);
        group.throughput(Throughput::Elements(u64::from(count)));
        for mut path in Path::all(1) {
            group.bench_function(BenchmarkId::new(format!("{area} px"), path.name()), |b| {
                b.iter(|| {
                    path.draw(&mut picture, Vertices::Clip(black_box(&vertices)), &soup.indices, &value)
                });
            });
        }
    }
    group.finish();
}

fn whole_screen(c: &mut Criterion) {
    let mut picture = Picture::new([WIDTH, HEIGHT]);
    let pixels = picture.color.len() as u64;

    let mut group = c.benchmark_group("no depth");
    group.throughput(Throughput::Bytes(4 * pixels));
    let corners = [[-1.0, 1.0], [-1.0, -1.0], [1.0, -1.0], [1.0, 1.0]].map(|[x, y]| [x, y, 0.5, 1.0]);
    let off = State { test: DepthTest::Off, write: false, ..State::default() };
    let size = [WIDTH, HEIGHT];
    let mut target =
        Target::new(&mut picture.color, Depth::None, size[0], size[1], size[0] as usize).expect("sizes fit");
    // Once in any case: the check below holds when a filter leaves this out, too.
    target.triangles(&off, &corners, &[[0, 1, 2], [0, 2, 3]], &Flat(7));
    group.bench_function("a triangle pair", |b| {
        b.iter(|| target.triangles(&off, black_box(&corners), &[[0, 1, 2], [0, 2, 3]], &Flat(7)));
    });
    assert!(picture.color.iter().all(|&pixel| pixel == 7), "the pair covers the picture");
    group.finish();

    let mut group = c.benchmark_group("clear");
    group.throughput(Throughput::Bytes(8 * pixels));
    let mut target = picture.target();
    group.bench_function("colour and depth", |b| {
        b.iter(|| target.clear(black_box(7), DepthTest::Greater));
    });
    group.finish();
}

fn memset(c: &mut Criterion) {
    let mut group = c.benchmark_group("memset");
    for kib in [16, 512, 8 << 10, 64 << 10] {
        let mut slice = vec![0_u32; kib << 8];
        group.throughput(Throughput::Bytes((kib as u64) << 10));
        group.bench_function(format!("{kib} KiB"), |b| {
            b.iter(|| black_box(&mut slice[..]).fill(black_box(7)));
        });
    }
    group.finish();
}

fn ceilings(c: &mut Criterion) {
    let mut group = c.benchmark_group("ceiling");
    group.throughput(Throughput::Elements((SIDE * SIDE) as u64));
    let level = Level::new();

    // Alternately in front of what is there and behind it: in the mean half of the pixels change.
    let planes = [Plane::sample(0.2), Plane::sample(0.1)];
    let draw = |by: &dyn Fn(&mut Tile, &Plane, u32)| {
        let mut tile = Tile::default();
        for (id, plane) in (1..).zip(&planes) {
            by(&mut tile, plane, id);
        }
        tile
    };
    let reference = draw(&ceiling::plain);
    assert!(reference == draw(&|tile, plane, id| ceiling::plain_at(level, tile, plane, id)));
    assert!(reference == draw(&|tile, plane, id| ceiling::lanes(level, tile, plane, id)));

    let mut tile = Tile::default();
    let mut id = 0;
    let mut next = move || {
        id += 1;
        (planes[id as usize % 2], id)
    };
    group.bench_function("plain, as the build targets", |b| {
        b.iter(|| {
            let (plane, id) = next();
            ceiling::plain(black_box(&mut tile), &plane, id);
        });
    });
    group.bench_function("plain, for this machine", |b| {
        b.iter(|| {
            let (plane, id) = next();
            ceiling::plain_at(level, black_box(&mut tile), &plane, id);
        });
    });
    group.bench_function("eight lanes, for this machine", |b| {
        b.iter(|| {
            let (plane, id) = next();
            ceiling::lanes(level, black_box(&mut tile), &plane, id);
        });
    });
    group.finish();
}

criterion_group! { name = benches; config = brief(); targets = ceilings, memset, whole_screen, soups, quoted }
criterion_main!(benches);
