//! How a mesh hangs together: open edges, closed surfaces, which triangles meet at a vertex.
//!
//! ```text
//!            c                    an edge is one place where sides of triangles meet:
//!          ╱ ▲ ╲
//!        ╱  │ │  ╲                1 side         open: the surface has a border there
//!      ╱ ↺  │ │ ↺  ╲              2, opposite    closed and wound consistently
//!     d ──▶ │ ▼ ──▶ b             2, same way    one of the two triangles is inside out
//!        ╲    a   ╱               3 and more     not a manifold: surfaces touch there
//! ```
//!
//! Vertices at the very same place count as one here, 0 and −0 being the same: files repeat them where normals,
//! colours or texture coordinates differ, and the picture shows no gap there.

use std::collections::HashMap;

use crate::Mesh;

/// What a mesh's triangles are to each other.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
#[non_exhaustive]
pub struct Topology {
    /// Places that vertices stand at: equal ones are counted once.
    pub places: usize,
    /// Edges between the places, each counted once.
    pub edges: usize,
    /// Edges with one triangle.
    pub open_edges: usize,
    /// Edges with more than two triangles.
    pub non_manifold_edges: usize,
    /// Edges with two triangles that run along it the same way, so that one of them is inside out.
    pub inconsistent_edges: usize,
    /// Triangles with two corners at one place, or with no area as computed in `f64`.
    pub degenerate: usize,
    /// Triangles with a coordinate that is infinite or NaN.
    pub non_finite: usize,
    /// Pieces that hang together by edges.
    pub pieces: usize,
    /// Every edge has exactly two triangles; there is one, and all coordinates are finite.
    pub watertight: bool,
    /// No two neighbours are wound against each other, and no edge has more than two triangles.
    pub consistent: bool,
    /// Watertight, consistent, and the signed volume of every piece is positive: the triangles are
    /// counter-clockwise seen from outside. (Surfaces that pass through themselves are not detected. A hollow in a
    /// solid is a piece of negative volume and makes this false.)
    pub outward: bool,
}

impl Topology {
    /// Looks at a mesh; time and memory grow with its triangles. Triangles with two corners at one place count as
    /// degenerate and take part in nothing else; flat ones with three corners do, for they close the surface.
    #[must_use]
    pub fn of(mesh: &Mesh) -> Self {
        let places = Places::of(mesh);
        let mut topology = Self { places: places.points.len(), ..Self::default() };
        let triangles = topology.sound_triangles(mesh, &places);
        let mut pieces = Pieces::of(triangles.len());
        topology.count_edges(&triangles, &mut pieces);
        topology.watertight = topology.non_finite == 0
            && !triangles.is_empty()
            && topology.open_edges == 0
            && topology.non_manifold_edges == 0;
        topology.consistent = topology.inconsistent_edges == 0 && topology.non_manifold_edges == 0;
        let all_positive = pieces.count_and_check(&triangles, &places.points, &mut topology.pieces);
        topology.outward = topology.watertight && topology.consistent && all_positive;
        topology
    }

    /// Whether back faces can be left out without changing the picture, seen from outside.
    #[must_use]
    pub const fn closed_outward(&self) -> bool {
        self.watertight && self.consistent && self.outward
    }

    /// The triangles with three different corners, as triples of places.
    fn sound_triangles(&mut self, mesh: &Mesh, places: &Places) -> Vec<[u32; 3]> {
        let mut sound = Vec::with_capacity(mesh.triangles().len());
        for triangle in mesh.triangles() {
            let [a, b, c] = triangle.map(|vertex| places.of[vertex as usize]);
            let corners = [a, b, c].map(|place| places.points[place as usize].map(f64::from));
            if !corners.as_flattened().iter().all(|c| c.is_finite()) {
                self.non_finite += 1;
            }
            let repeats = a == b || b == c || c == a;
            if repeats || cross(corners) == [0.0; 3] {
                self.degenerate += 1;
            }
            if !repeats {
                sound.push([a, b, c]);
            }
        }
        sound
    }

    fn count_edges(&mut self, triangles: &[[u32; 3]], pieces: &mut Pieces) {
        let rows = side_rows(triangles, self.places);
        // Whether a triangle goes along the edge from its lower to its higher end.
        let rises = |low: u32, high: u32, triangle: u32| {
            let [a, b, c] = triangles[triangle as usize];
            [[a, b], [b, c], [c, a]].contains(&[low, high])
        };
        for (low, row) in (0_u32..).zip(rows.iter()) {
            for edge in row.chunk_by(|p, q| p >> 32 == q >> 32) {
                self.edges += 1;
                match *edge {
                    [_] => self.open_edges += 1,
                    [p, q] => {
                        let (high, _) = unpack(p);
                        let [p, q] = [p, q].map(|side| unpack(side).1);
                        self.inconsistent_edges += usize::from(rises(low, high, p) == rises(low, high, q));
                        pieces.join(p, q);
                    }
                    _ => {
                        self.non_manifold_edges += 1;
                        edge.windows(2).for_each(|pair| pieces.join(unpack(pair[0]).1, unpack(pair[1]).1));
                    }
                }
            }
        }
    }
}

/// Places: positions without their repetitions.
struct Places {
    /// Each vertex's place.
    of: Vec<u32>,
    points: Vec<[f32; 3]>,
}

impl Places {
    /// A NaN is the same place as one of the same bits. The standard library's hash is seeded: no file can make
    /// it collide; the places' numbers depend on the order of the vertices only.
    fn of(mesh: &Mesh) -> Self {
        let mut known: HashMap<[u32; 3], u32> = HashMap::with_capacity(mesh.positions().len());
        let mut points = Vec::with_capacity(mesh.positions().len());
        let mut next = 0;
        let of = mesh.positions().iter().map(|position| {
            // −0 + 0 is 0.
            let index = *known.entry(position.map(|c| (c + 0.0).to_bits())).or_insert(next);
            if index == next {
                points.push(*position);
                next += 1;
            }
            index
        });
        Self { of: of.collect(), points }
    }
}

/// Triangles joined into pieces (union–find; a piece is known by its lowest triangle).
struct Pieces {
    parent: Vec<u32>,
}

impl Pieces {
    fn of(triangles: usize) -> Self {
        // A mesh has at most 2³² − 1 triangles.
        Self { parent: (0..).take(triangles).collect() }
    }

    fn root(&mut self, mut triangle: u32) -> u32 {
        while self.parent[triangle as usize] != triangle {
            let above = self.parent[self.parent[triangle as usize] as usize];
            self.parent[triangle as usize] = above;
            triangle = above;
        }
        triangle
    }

    fn join(&mut self, p: u32, q: u32) {
        let (p, q) = (self.root(p), self.root(q));
        self.parent[p.max(q) as usize] = p.min(q);
    }

    /// Counts the pieces; whether all have positive volume. Each volume is the sum of the tetrahedra from a corner
    /// of the piece, so that a small piece far away keeps its digits.
    fn count_and_check(&mut self, triangles: &[[u32; 3]], points: &[[f32; 3]], count: &mut usize) -> bool {
        let mut volumes = vec![0.0; triangles.len()];
        for (number, &triangle) in (0_u32..).zip(triangles) {
            let root = self.root(number) as usize;
            let apex = points[triangles[root][0] as usize].map(f64::from);
            let corners = triangle.map(|v| points[v as usize].map(f64::from));
            let normal = cross(corners);
            let arm = [corners[0][0] - apex[0], corners[0][1] - apex[1], corners[0][2] - apex[2]];
            volumes[root] += arm[0] * normal[0] + arm[1] * normal[1] + arm[2] * normal[2];
        }
        let roots = (0_u32..).zip(&self.parent).filter(|(number, parent)| number == *parent);
        let mut all_positive = true;
        for (root, _) in roots {
            *count += 1;
            all_positive &= volumes[root as usize] > 0.0;
        }
        all_positive
    }
}

/// Whether a mesh's triangles close as a whole: every edge is run along as often one way as the other, so that each
/// point off the surface has a winding number. Less than [`Topology::watertight`] and consistent: surfaces may touch
/// along edges. `false` for no triangles, and when a coordinate is not finite.
pub(crate) fn closes(mesh: &Mesh) -> bool {
    if mesh.triangles().is_empty() || !mesh.positions().as_flattened().iter().all(|c| c.is_finite()) {
        return false;
    }
    let places = Places::of(mesh);
    let sides = mesh.triangles().iter().flat_map(|triangle| {
        let [a, b, c] = triangle.map(|vertex| places.of[vertex as usize]);
        [[a, b], [b, c], [c, a]].map(|[p, q]| (p.min(q), p.max(q), p < q)).into_iter()
    });
    // A side from a place to itself is no edge.
    let sides = sides.filter(|(low, high, _)| low != high);
    let sides = sides.map(|(low, high, rises)| (low, u64::from(high) << 1 | u64::from(rises)));
    Rows::of(places.points.len(), sides).iter().all(|row| {
        row.chunk_by(|p, q| p >> 1 == q >> 1)
            .all(|edge| 2 * edge.iter().filter(|&side| side & 1 == 1).count() == edge.len())
    })
}

/// All sides, each in the row of its lower end, as (higher end, triangle) in one number.
fn side_rows(triangles: &[[u32; 3]], ends: usize) -> Rows<u64> {
    Rows::of(
        ends,
        (0_u32..).zip(triangles).flat_map(|(number, &[a, b, c])| {
            [[a, b], [b, c], [c, a]].map(|[p, q]| (p.min(q), u64::from(p.max(q)) << 32 | u64::from(number)))
        }),
    )
}

/// (higher end, triangle).
const fn unpack(side: u64) -> (u32, u32) {
    ((side >> 32) as u32, side as u32)
}

/// For each vertex of a mesh, the triangles that hold it.
#[derive(Clone, Debug)]
pub struct VertexFaces {
    rows: Rows<u32>,
}

impl VertexFaces {
    /// The triangles around the vertices of `mesh`: by index, not by place.
    #[must_use]
    pub fn of(mesh: &Mesh) -> Self {
        let corners = (0_u32..).zip(mesh.triangles()).flat_map(|(number, &[a, b, c])| {
            // A triangle that names a vertex twice is around it once.
            let b = (b != a).then_some(b);
            let c = (c != a && Some(c) != b).then_some(c);
            [Some(a), b, c].into_iter().flatten().map(move |vertex| (vertex, number))
        });
        Self { rows: Rows::of(mesh.positions().len(), corners) }
    }

    /// The triangles that hold a vertex, in order.
    ///
    /// # Panics
    ///
    /// When the mesh has no such vertex.
    #[must_use]
    pub fn around(&self, vertex: u32) -> &[u32] {
        &self.rows.values[self.rows.range(vertex as usize)]
    }
}

/// For each edge of a mesh, the triangles on it.
#[derive(Clone, Debug)]
pub struct EdgeFaces {
    rows: Rows<u64>,
}

impl EdgeFaces {
    /// The sides of all triangles of `mesh`, by index, not by place; a side from a vertex to itself is no edge.
    #[must_use]
    pub fn of(mesh: &Mesh) -> Self {
        Self { rows: side_rows(mesh.triangles(), mesh.positions().len()) }
    }

    /// The triangles on an edge, in order; none if it is no side of a triangle.
    ///
    /// # Panics
    ///
    /// When the mesh has no vertex of the lesser number.
    pub fn on(&self, [a, b]: [u32; 2]) -> impl Iterator<Item = u32> {
        let (low, high) = (a.min(b), a.max(b));
        let row = &self.rows.values[self.rows.range(low as usize)];
        let from = row.partition_point(|&side| unpack(side).0 < high);
        row[from..]
            .iter()
            .map(|&side| unpack(side))
            .take_while(move |&(end, _)| end == high)
            .map(|(_, face)| face)
    }

    /// The edges in the order of [`Mesh::edges`] of a mesh without edges of its own: lower end first; each with
    /// its triangles in order.
    pub fn iter(&self) -> impl Iterator<Item = ([u32; 2], impl Iterator<Item = u32>)> {
        (0_u32..).zip(self.rows.iter()).flat_map(|(low, row)| {
            row.chunk_by(|p, q| p >> 32 == q >> 32)
                .map(move |edge| ([low, unpack(edge[0]).0], edge.iter().map(|&side| unpack(side).1)))
                .filter(|([low, high], _)| low != high)
        })
    }
}

/// Values in rows, each row sorted: counted, placed, sorted, so that no row owns an allocation.
#[derive(Clone, Debug)]
struct Rows<T> {
    starts: Vec<usize>,
    values: Vec<T>,
}

impl<T: Copy + Default + Ord> Rows<T> {
    fn of(rows: usize, items: impl Iterator<Item = (u32, T)> + Clone) -> Self {
        let mut starts = vec![0; rows + 1];
        for (row, _) in items.clone() {
            starts[row as usize] += 1;
        }
        // From counts to ends; placing from the back of each row turns ends into starts.
        let mut total = 0;
        for count in &mut starts {
            total += *count;
            *count = total;
        }
        let mut values = vec![T::default(); total];
        for (row, value) in items {
            let slot = &mut starts[row as usize];
            *slot -= 1;
            values[*slot] = value;
        }
        let mut rows = Self { starts, values };
        for row in 0..rows.len() {
            let range = rows.range(row);
            rows.values[range].sort_unstable();
        }
        rows
    }

    const fn len(&self) -> usize {
        self.starts.len() - 1
    }

    fn range(&self, row: usize) -> core::ops::Range<usize> {
        self.starts[row]..self.starts[row + 1]
    }

    fn iter(&self) -> impl Iterator<Item = &[T]> {
        (0..self.len()).map(|row| &self.values[self.range(row)])
    }
}

/// (b − a) × (c − a).
fn cross([a, b, c]: [[f64; 3]; 3]) -> [f64; 3] {
    let (p, q) = ([b[0] - a[0], b[1] - a[1], b[2] - a[2]], [c[0] - a[0], c[1] - a[1], c[2] - a[2]]);
    [p[1] * q[2] - p[2] * q[1], p[2] * q[0] - p[0] * q[2], p[0] * q[1] - p[1] * q[0]]
}

#[cfg(test)]
mod tests {
    use super::{EdgeFaces, Topology, VertexFaces};
    use crate::Mesh;

    const TETRAHEDRON: [[u32; 3]; 4] = [[0, 2, 1], [0, 1, 3], [1, 2, 3], [2, 0, 3]];

    fn corners(at: f32, size: f32) -> Vec<[f32; 3]> {
        vec![[at, 0.0, 0.0], [at + size, 0.0, 0.0], [at, size, 0.0], [at, 0.0, size]]
    }

    fn of(positions: &[[f32; 3]], triangles: &[[u32; 3]]) -> Topology {
        Topology::of(&Mesh::new(positions.to_vec(), triangles.to_vec()).unwrap())
    }

    #[test]
    fn a_tetrahedron_is_closed_and_outward() {
        let t = of(&corners(0.0, 1.0), &TETRAHEDRON);
        assert_eq!((t.places, t.edges, t.open_edges, t.pieces), (4, 6, 0, 1));
        assert!(t.watertight && t.consistent && t.outward && t.closed_outward());
        assert_eq!((t.degenerate, t.non_finite, t.non_manifold_edges), (0, 0, 0));
    }

    #[test]
    fn turned_inside_out_it_is_closed_but_not_outward() {
        let t = of(&corners(0.0, 1.0), &TETRAHEDRON.map(|[a, b, c]| [a, c, b]));
        assert!(t.watertight && t.consistent && !t.outward && !t.closed_outward());
    }

    #[test]
    fn one_turned_triangle_makes_three_inconsistent_edges() {
        let mut triangles = TETRAHEDRON;
        triangles[2].swap(0, 1);
        let t = of(&corners(0.0, 1.0), &triangles);
        assert_eq!(t.inconsistent_edges, 3);
        assert!(t.watertight && !t.consistent && !t.closed_outward());
    }

    #[test]
    fn a_missing_triangle_leaves_three_open_edges() {
        let t = of(&corners(0.0, 1.0), &TETRAHEDRON[..3]);
        assert_eq!((t.edges, t.open_edges), (6, 3));
        assert!(!t.watertight && t.consistent);
    }

    #[test]
    fn repeated_vertices_and_both_zeros_are_one_place() {
        let soup: Vec<[f32; 3]> = TETRAHEDRON
            .iter()
            .enumerate()
            .flat_map(|(i, t)| {
                t.map(|v| corners(0.0, 1.0)[v as usize].map(|c| if i == 0 && c == 0.0 { -0.0 } else { c }))
            })
            .collect();
        let triangles: Vec<[u32; 3]> = (0..4).map(|i| [3 * i, 3 * i + 1, 3 * i + 2]).collect();
        let t = of(&soup, &triangles);
        assert_eq!(t.places, 4);
        assert!(t.closed_outward());
    }

    #[test]
    fn one_piece_inside_out_is_found_even_when_the_whole_volume_is_positive() {
        let mut positions = corners(0.0, 10.0);
        positions.extend(corners(50.0, 1.0));
        let mut triangles = TETRAHEDRON.to_vec();
        triangles.extend(TETRAHEDRON.map(|[a, b, c]| [a + 4, c + 4, b + 4]));
        let t = of(&positions, &triangles);
        assert_eq!(t.pieces, 2);
        assert!(t.watertight && t.consistent && !t.outward);
    }

    #[test]
    fn a_third_triangle_on_an_edge_is_not_a_manifold() {
        let mut positions = corners(0.0, 1.0);
        positions.push([1.0, 1.0, 1.0]);
        let mut triangles = TETRAHEDRON.to_vec();
        triangles.push([0, 1, 4]);
        let t = of(&positions, &triangles);
        assert_eq!((t.non_manifold_edges, t.open_edges), (1, 2));
        assert!(!t.watertight && !t.consistent);
    }

    #[test]
    fn degenerate_triangles_do_not_open_a_closed_surface() {
        let mut triangles = TETRAHEDRON.to_vec();
        triangles.extend([[1, 1, 2], [3, 3, 3]]);
        let t = of(&corners(0.0, 1.0), &triangles);
        assert_eq!(t.degenerate, 2);
        assert!(t.closed_outward());
    }

    #[test]
    fn nan_makes_a_surface_unusable_for_culling() {
        let mut positions = corners(0.0, 1.0);
        positions[3][1] = f32::NAN;
        let t = of(&positions, &TETRAHEDRON);
        assert_eq!(t.non_finite, 3);
        assert!(!t.watertight);
    }

    #[test]
    fn nothing_is_not_watertight() {
        let t = of(&[], &[]);
        assert_eq!(t, Topology { consistent: true, ..Topology::default() });
    }

    #[test]
    fn faces_around_vertices_and_edges_are_listed_in_order() {
        let mut triangles = TETRAHEDRON.to_vec();
        triangles.push([1, 1, 2]);
        let mesh = Mesh::new(corners(0.0, 1.0), triangles).unwrap();
        let around = VertexFaces::of(&mesh);
        assert_eq!(around.around(0), [0, 1, 3]);
        assert_eq!(around.around(1), [0, 1, 2, 4]);
        let edges = EdgeFaces::of(&mesh);
        let listed: Vec<_> = edges.iter().map(|(edge, faces)| (edge, faces.collect::<Vec<_>>())).collect();
        assert_eq!(listed[0], ([0, 1], vec![0, 1]));
        assert_eq!(listed.iter().map(|(edge, _)| *edge).collect::<Vec<_>>(), *mesh.edges());
        assert_eq!(listed.iter().find(|(edge, _)| *edge == [1, 2]).unwrap().1, [0, 2, 4, 4]);
    }
}
