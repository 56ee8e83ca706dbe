//! Edges over surfaces, from a hundred directions, on all shapes: none is lost to its own faces, none that is
//! hidden shows.
//!
//! The judge is not the renderer: it knows from the numbers of the nearest faces (drawn without edges) and from
//! the true planes, in `f64`, what must be seen.

use polosa_math::glam::{DVec3, DVec4};
use polosa_math::{Placement, Viewport};
use polosa_raster::{Clip, Depth, DepthTest, PerTriangle, State, Target, transform};
use polosa_scene::topology::VertexFaces;
use polosa_scene::{Camera, Mesh, Projection, Shape};

const WIDTH: u32 = 120;
const HEIGHT: u32 = 90;
const SIZE: usize = (WIDTH * HEIGHT) as usize;

/// Every kind of shape, coarse, so that faces are larger than pixels; and a cone with more faces at its tip than are
/// looked at for an edge.
const SHAPES: [&str; 17] = [
    "tetrahedron",
    "cube",
    "octahedron",
    "icosahedron",
    "sphere:tetrahedron:2",
    "sphere:cube:2",
    "sphere:octahedron:2",
    "sphere:icosahedron:1",
    "uv-sphere:12:8",
    "plane",
    "cylinder:16",
    "cone:16",
    "cone:40",
    "torus:16:8",
    "teapot:2",
    "pyramid",
    "seed-tetrahedron",
];

/// Directions that are spread evenly over the sphere (a Fibonacci lattice), none along an axis.
fn directions(count: u32) -> impl Iterator<Item = DVec3> {
    (0..count).map(move |k| {
        let y = 1.0 - (2.0 * f64::from(k) + 1.0) / f64::from(count);
        let around = f64::from(k) * 2.399_963_229_728_653;
        let radius = (1.0 - y * y).sqrt();
        DVec3::new(radius * around.cos(), y, radius * around.sin())
    })
}

/// A view of a mesh, and what is nearest at each pixel.
struct View {
    mesh: Mesh,
    faces: VertexFaces,
    clip: Vec<Clip>,
    depth: Vec<f32>,
    /// Number of the nearest face plus one.
    nearest: Vec<u32>,
}

impl View {
    fn new(mesh: &Mesh, camera: &Camera) -> Self {
        let mut clip = vec![[0.0; 4]; mesh.positions().len()];
        transform(&camera.clip_from_model(&Placement::IDENTITY), mesh.positions(), &mut clip);
        let (mut nearest, mut depth) = (vec![0; SIZE], vec![0.0; SIZE]);
        let mut target = target(&mut nearest, &mut depth);
        let numbers = PerTriangle(|index: usize| u32::try_from(index).unwrap() + 1);
        let stats = target.triangles(&State::default(), &clip, mesh.triangles(), &numbers);
        assert_eq!(stats.drawn + stats.degenerate, stats.submitted);
        assert_eq!(stats.clipped, 0, "the judge knows whole faces only");
        Self { mesh: mesh.clone(), faces: VertexFaces::of(mesh), clip, depth, nearest }
    }

    fn around(&self, edge: [u32; 2]) -> impl Iterator<Item = usize> {
        edge.into_iter().flat_map(|end| self.faces.around(end)).map(|&k| k as usize)
    }

    fn is_own(&self, edge: [u32; 2], face: usize) -> bool {
        edge.iter().all(|end| self.mesh.triangles()[face].contains(end))
    }

    /// Draws one edge over `depth`, which holds these faces around it; the pixels that show it are not 0.
    fn draw(&self, edge: [u32; 2], faces: &[usize], test: DepthTest, buffers: (&mut [f32], &mut [u32])) {
        let around = |_| faces.iter().map(|&k| self.mesh.triangles()[k]);
        let state = State { test, write: false, ..State::default() };
        target(buffers.1, buffers.0).edges(&state, &self.clip, &[edge], around, 1);
    }

    /// A vertex in pixels, and its depth, in `f64`.
    fn place(&self, vertex: u32) -> DVec3 {
        let clip = DVec4::from_array(self.clip[vertex as usize].map(f64::from));
        let [x, y] = Viewport::new(WIDTH, HEIGHT).to_pixels(clip.x, clip.y, clip.w);
        DVec3::new(x, y, clip.z / clip.w)
    }

    /// The point of an edge that belongs to a pixel: where it crosses the pixel's column, or row if it is steep.
    fn point(&self, edge: [u32; 2], pixel: [f64; 2]) -> DVec3 {
        let [a, b] = edge.map(|vertex| self.place(vertex));
        let along = if (b.x - a.x).abs() >= (b.y - a.y).abs() {
            (pixel[0] - a.x) / (b.x - a.x)
        } else {
            (pixel[1] - a.y) / (b.y - a.y)
        };
        a + (b - a) * along.clamp(0.0, 1.0)
    }

    /// Whether a face lies before a point at the point's own place: by more than `margin` pixels inside its sides,
    /// and by more than `nearer` of the depth.
    fn hides(&self, face: usize, point: DVec3, margin: f64, nearer: f64) -> bool {
        let corners = self.mesh.triangles()[face].map(|vertex| self.place(vertex));
        let cross = |a: DVec3, b: DVec3, p: DVec3| (b.x - a.x) * (p.y - a.y) - (b.y - a.y) * (p.x - a.x);
        let [a, b, c] = corners;
        let area = cross(a, b, c);
        let sides = [(b, c), (c, a), (a, b)];
        let weights = sides.map(|(p, q)| cross(p, q, point) / area);
        let inside = sides.iter().zip(weights).all(|((p, q), weight)| {
            let distance = weight * area.abs() / (*q - *p).truncate().length();
            distance > margin
        });
        let depth: f64 = weights.iter().zip(corners).map(|(weight, corner)| weight * corner.z).sum();
        inside && depth > point.z * (1.0 + nearer)
    }
}

fn target<'a>(color: &'a mut [u32], depth: &'a mut [f32]) -> Target<'a, u32> {
    Target::new(color, Depth::F32(depth), WIDTH, HEIGHT, WIDTH as usize).unwrap()
}

#[derive(Default)]
struct Seen {
    must: u64,
    must_not: u64,
}

fn judge(mesh: &Mesh, camera: &Camera, what: &str, seen: &mut Seen) {
    let mut view = View::new(mesh, camera);
    let mut depth = std::mem::take(&mut view.depth);
    let (mut whole, mut shown, mut alone) = (vec![0; SIZE], vec![0; SIZE], vec![0; SIZE]);
    let mut own_depth = vec![0.0; SIZE];
    for &edge in mesh.edges().iter() {
        let mut around: Vec<_> = view.around(edge).collect();
        around.sort_by_key(|&face| !view.is_own(edge, face)); // its own ones first
        around.dedup();
        view.draw(edge, &around, DepthTest::Off, (&mut depth, &mut whole));
        view.draw(edge, &around, DepthTest::Greater, (&mut depth, &mut shown));
        // The same edge where there is nothing but its own faces.
        let own: Vec<_> = around.iter().copied().filter(|&face| view.is_own(edge, face)).collect();
        let own_faces: Vec<_> = own.iter().map(|&face| mesh.triangles()[face]).collect();
        let paint = PerTriangle(|_| 0);
        target(&mut alone, &mut own_depth).triangles(&State::default(), &view.clip, &own_faces, &paint);
        view.draw(edge, &own, DepthTest::Greater, (&mut own_depth, &mut alone));
        for at in 0..SIZE {
            if whole[at] == 0 {
                continue;
            }
            let pixel = [at % WIDTH as usize, at / WIDTH as usize].map(|v| v as f64 + 0.5);
            let place = || format!("{what}, edge {edge:?} at {pixel:?}");
            assert_eq!(alone[at], 1, "lost to its own faces: {}", place());
            let point = view.point(edge, pixel);
            match (view.nearest[at] as usize).checked_sub(1) {
                Some(face) if !own.contains(&face) => {
                    let is_behind = f64::from(depth[at]) > point.z * 1.001;
                    if is_behind && view.hides(face, point, 1.0 / 16.0, 1e-3) {
                        assert_eq!(shown[at], 0, "hidden by face {face}, but seen: {}", place());
                        seen.must_not += 1;
                    }
                }
                _ => {
                    // Its own face is seen here, but the edge itself may run behind another, beside the pixel.
                    if !around
                        .iter()
                        .any(|&face| !own.contains(&face) && view.hides(face, point, -1.0 / 16.0, 0.0))
                    {
                        assert_eq!(
                            shown[at],
                            1,
                            "nothing but its own faces is nearer, but lost: {}",
                            place()
                        );
                        seen.must += 1;
                    }
                }
            }
        }
        for buffer in [&mut whole, &mut shown, &mut alone] {
            buffer.fill(0);
        }
        own_depth.fill(0.0);
    }
}

#[test]
fn no_visible_edge_is_lost_to_its_faces_and_no_hidden_one_shows() {
    for name in SHAPES {
        let mesh = name.parse::<Shape>().unwrap().mesh().unwrap();
        let points: Vec<_> = mesh.positions().iter().map(|p| DVec3::from_array(p.map(f64::from))).collect();
        let mut seen = Seen::default();
        for (number, direction) in directions(100).enumerate() {
            let mut camera = Camera::new();
            if number % 4 == 3 {
                let parallel = Projection::Orthographic { height: 1.0, near: 0.1, far: 10.0 };
                camera.set_projection(parallel).unwrap();
            }
            camera.frame_points(points.iter().copied(), direction, DVec3::Y, 0.05).unwrap();
            judge(&mesh, &camera, &format!("{name} from {direction}"), &mut seen);
        }
        assert!(seen.must > 5_000, "{name}: only {} visible pixels were judged", seen.must);
        let flat = ["plane"].contains(&name);
        assert!(flat || seen.must_not > 1_000, "{name}: only {} hidden pixels were judged", seen.must_not);
    }
}

/// The judge's own list of shapes is the program's.
#[test]
fn every_shape_is_judged() {
    for info in Shape::all() {
        let judged = SHAPES.iter().any(|name| name.split(':').next() == Some(info.name));
        assert!(judged, "{}", info.name);
    }
}
