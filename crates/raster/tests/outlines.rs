//! Claim: lines that outline faces are never lost to them, and no hidden line shows through.
//!
//! Convex solids, so that it is known which edges are visible: those with a face towards the eye.

mod support;

use polosa_raster::{Clip, Flat, PerTriangle, State};
use support::picture::Picture;
use support::rng::Rng;

const SIDE: usize = 160;

/// A face with less than this, twice its area in clip units, may be turned over by the snap of its corners:
/// √2/512 px times a perimeter of at most 400 px.
const EDGE_ON: f64 = 2e-4;

/// The first face's colour.
const FIRST: u32 = 10;

struct Solid {
    name: &'static str,
    vertices: Vec<[f64; 3]>,
    /// Polygons, counter-clockwise from outside.
    faces: Vec<Vec<u32>>,
}

fn solids() -> Vec<Solid> {
    let cube = (0..8_u32).map(|k| [0, 1, 2].map(|c| f64::from(k >> c & 1) * 2.0 - 1.0)).collect();
    let axes = (0..6_usize).map(|k| {
        let mut p = [0.0; 3];
        p[k / 2] = if k % 2 == 0 { 1.5 } else { -1.5 };
        p
    });
    let quads = [[0, 4, 6, 2], [1, 3, 7, 5], [0, 1, 5, 4], [2, 6, 7, 3], [0, 2, 3, 1], [4, 5, 7, 6]];
    let octants = (0..8_u32).map(|k| {
        let [x, y, z] = [0, 1, 2].map(|c| 2 * c + (k >> c & 1));
        if k.count_ones() % 2 == 0 { vec![x, y, z] } else { vec![x, z, y] }
    });
    let needle: Vec<[f64; 3]> =
        vec![[1.5, 0.0, 0.0], [-1.5, 0.02, 0.0], [-1.5, -0.02, 0.02], [-1.5, -0.02, -0.02]];
    vec![
        Solid { name: "cube", vertices: cube, faces: quads.map(|q| q.to_vec()).to_vec() },
        Solid { name: "octahedron", vertices: axes.collect(), faces: octants.collect() },
        Solid {
            name: "needle",
            vertices: needle,
            faces: vec![vec![0, 1, 2], vec![0, 2, 3], vec![0, 3, 1], vec![1, 3, 2]],
        },
    ]
}

impl Solid {
    fn triangles(&self) -> Vec<[u32; 3]> {
        let fan = |f: &Vec<u32>| (1..f.len() - 1).map(|k| [f[0], f[k], f[k + 1]]).collect::<Vec<_>>();
        self.faces.iter().flat_map(fan).collect()
    }

    /// Edges, each with its two faces.
    fn edges(&self) -> Vec<([u32; 2], [usize; 2])> {
        let mut edges: Vec<([u32; 2], Vec<usize>)> = Vec::new();
        for (number, face) in self.faces.iter().enumerate() {
            for (k, &a) in face.iter().enumerate() {
                let b = face[(k + 1) % face.len()];
                match edges.iter_mut().find(|(e, _)| *e == [b, a]) {
                    Some((_, faces)) => faces.push(number),
                    None => edges.push(([a, b], vec![number])),
                }
            }
        }
        edges.into_iter().map(|(e, f)| (e, [f[0], f[1]])).collect()
    }

    /// The vertices turned at random, four units before an eye with a near plane at 1/10.
    fn seen(&self, r: &mut Rng) -> Vec<Clip> {
        let mut q = [(); 4].map(|()| r.real(-1.0, 1.0));
        let length = q.iter().map(|c| c * c).sum::<f64>().sqrt();
        q.iter_mut().for_each(|c| *c /= length);
        let [x, y, z, w] = q;
        let turn = [
            [1.0 - 2.0 * (y * y + z * z), 2.0 * (x * y - w * z), 2.0 * (x * z + w * y)],
            [2.0 * (x * y + w * z), 1.0 - 2.0 * (x * x + z * z), 2.0 * (y * z - w * x)],
            [2.0 * (x * z - w * y), 2.0 * (y * z + w * x), 1.0 - 2.0 * (x * x + y * y)],
        ];
        let clip = |p: &[f64; 3]| {
            let [x, y, z] = turn.map(|row| (0..3).map(|k| row[k] * p[k]).sum::<f64>());
            [(x * 2.0) as f32, (y * 2.0) as f32, 0.1, (4.0 - z) as f32]
        };
        self.vertices.iter().map(clip).collect()
    }
}

/// Twice the area on the screen, positive for a front face: counter-clockwise with y up.
fn front(v: &[Clip], face: &[u32]) -> f64 {
    let p = |k: usize| v[face[k] as usize].map(f64::from);
    let [a, b, c] = [p(0), p(1), p(2)].map(|[x, y, _, w]| [x / w, y / w]);
    (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])
}

#[test]
fn visible_edges_are_whole_and_hidden_ones_gone() {
    let mut r = Rng::new(90);
    for solid in solids() {
        let (triangles, edges) = (solid.triangles(), solid.edges());
        let (mut whole, mut others, mut hidden) = (0, 0, 0);
        for _ in 0..100 {
            let v = solid.seen(&mut r);
            let mut faces = Picture::new(SIDE, SIDE);
            let shade = PerTriangle(|k: usize| FIRST + k as u32);
            faces.target().triangles(&State::default(), &v, &triangles, &shade);
            for (edge, sides) in &edges {
                let touches = |t: &[u32; 3]| edge.iter().any(|e| t.contains(e));
                let around = |_| triangles.iter().copied().filter(touches);
                let mut picture = faces.clone();
                picture.target().edges(&State::default(), &v, &[*edge], around, 2);
                let mut alone = Picture::new(SIDE, SIDE);
                alone.target().lines(&State::default(), &v, &[*edge], 2);
                let facing = sides.map(|s| front(&v, &solid.faces[s]));
                if facing.iter().any(|&f| f > EDGE_ON) {
                    for (x, y) in alone.painted() {
                        // A face that does not touch the line is really in front, if only by half a pixel.
                        let face = faces.at(x, y).checked_sub(FIRST).map(|k| &triangles[k as usize]);
                        let lost = picture.at(x, y) != 2 && face.is_none_or(touches);
                        assert!(!lost, "{}: edge {edge:?} of {v:?} lost at ({x}, {y})", solid.name);
                        whole += usize::from(picture.at(x, y) == 2);
                        others += usize::from(picture.at(x, y) != 2);
                    }
                } else if facing.iter().all(|&f| f < -EDGE_ON) {
                    // The line itself may show only beside the outline, where it is not behind a face.
                    for (x, y) in picture.painted().into_iter().filter(|&(x, y)| picture.at(x, y) == 2) {
                        let beside = (y - 1..=y + 1).any(|j| (x - 1..=x + 1).any(|i| faces.at(i, j) == 0));
                        assert!(beside, "{}: hidden edge {edge:?} of {v:?} shows at ({x}, {y})", solid.name);
                    }
                    hidden += alone.painted().len();
                }
            }
        }
        assert!(
            others * 500 < whole,
            "{}: {others} of {whole} px behind faces that do not touch the line",
            solid.name
        );
        assert!(whole > 10_000 && hidden > 2_000, "{}: {whole} px visible, {hidden} hidden", solid.name);
    }
}

#[test]
fn a_face_in_front_hides_lines_all_the_same() {
    let square = |z: f32, s: f32| [[-s, -s, z, 1.0], [s, -s, z, 1.0], [s, s, z, 1.0], [-s, s, z, 1.0]];
    let v: Vec<Clip> = [square(0.3, 0.6), square(0.5, 0.8)].concat();
    let mut picture = Picture::new(64, 64);
    let triangles = [[0, 1, 2], [0, 2, 3], [4, 5, 6], [4, 6, 7]];
    picture.target().triangles(&State::default(), &v, &triangles, &Flat(1));
    let own = |_| [[0, 1, 2], [0, 2, 3]];
    picture.target().edges(&State::default(), &v, &[[0, 1], [1, 2], [2, 3], [3, 0], [0, 2]], own, 2);
    assert!(!picture.color.contains(&2), "{:?}", picture.rows());
}
