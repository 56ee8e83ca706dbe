//! Midpoint subdivision: every triangle becomes four.
//!
//! ```text
//!            c                      c
//!           / \                    / \
//!          /   \                  /   \
//!         /     \      --->     ca --- bc
//!        /       \              / \   / \
//!       /         \            /   \ /   \
//!      a --------- b          a --- ab -- b
//! ```
//!
//! A midpoint belongs to its edge, not to a triangle: both neighbours get the same vertex, so that what was
//! watertight stays so. Positions stay in `f64` through all levels and are rounded to `f32` once at the end.

use std::collections::HashMap;

use crate::{Color, Colors, Corners, Mesh, MeshError};

/// The most triangles that a subdivision or a shape makes.
///
/// With positions, normals and edges such a mesh and its making take between one and two GiB; a larger limit
/// would let a short text such as `sphere:14` exhaust the machine.
pub const MOST_TRIANGLES: u64 = 20_000_000;

/// Where subdivision puts its vertices.
#[derive(Clone, Copy, Debug, PartialEq, Default)]
#[non_exhaustive]
pub enum Onto {
    /// The midpoints of the edges: the surface stays as it is, in smaller triangles.
    #[default]
    Flat,
    /// A sphere: every vertex, also the mesh's own, is moved along its ray from the centre, after every level.
    /// A vertex at the centre itself, or one that is not finite, stays where it is.
    Sphere {
        /// The centre, in the mesh's units.
        center: [f64; 3],
        /// The radius, in the mesh's units.
        radius: f64,
    },
}

/// Why a mesh was not subdivided.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[non_exhaustive]
pub enum SubdivideError {
    /// More triangles or edges than [`MOST_TRIANGLES`] allows.
    #[error(
        "{triangles} triangles subdivided {level} times are more than {MOST_TRIANGLES}: use at most {most} levels"
    )]
    TooLarge {
        /// How many triangles the mesh has.
        triangles: usize,
        /// How many levels were asked for.
        level: u32,
        /// How many levels the mesh can have.
        most: u32,
    },
    /// The parts make no mesh: more vertices than indices can name.
    #[error(transparent)]
    Mesh(#[from] MeshError),
}

/// The mesh with every triangle cut into four, `level` times.
///
/// Triangles keep their winding and their order: the four parts of triangle `t` are 4`t` … 4`t` + 3. The mesh's
/// own edges are cut into halves; colours of faces go to all parts; colours of vertices, normals and texture
/// coordinates are interpolated linearly (colours as their sRGB codes), whether shared or with their own indices.
///
/// ```
/// use polosa_scene::{shape, subdivide::{Onto, subdivide}};
///
/// let sphere = subdivide(&shape::octahedron(), 5, Onto::Sphere { center: [0.0; 3], radius: 1.0 })?;
/// assert_eq!(sphere.triangles().len(), 8 * 4_usize.pow(5));
/// # Ok::<(), polosa_scene::subdivide::SubdivideError>(())
/// ```
///
/// # Errors
///
/// When the result would have more than [`MOST_TRIANGLES`] triangles.
pub fn subdivide(mesh: &Mesh, level: u32, onto: Onto) -> Result<Mesh, SubdivideError> {
    check_size(mesh, level)?;
    let mut positions: Vec<[f64; 3]> = mesh.positions().iter().map(|p| p.map(f64::from)).collect();
    let mut triangles = mesh.triangles().to_vec();
    let mut edges = if mesh.has_own_edges() { mesh.edges().into_owned() } else { Vec::new() };
    let mut colors: Vec<[f64; 3]> = match mesh.colors() {
        Colors::Vertex(colors) => colors.iter().map(|c| [c.r, c.g, c.b].map(f64::from)).collect(),
        Colors::Face(_) | Colors::None => Vec::new(),
    };
    let mut normals = mesh.normals().map(Attribute::new);
    let mut uvs = mesh.uvs().map(Attribute::new);

    project(&mut positions, onto);
    for _ in 0..level {
        let old = positions.len();
        let cut = Cut::new(&triangles, &edges, old)?;
        cut.extend(&mut positions);
        project(&mut positions[old..], onto);
        if matches!(mesh.colors(), Colors::Vertex(_)) {
            cut.extend(&mut colors);
        }
        if let Some(normals) = &mut normals {
            normals.cut(&cut)?;
        }
        if let Some(uvs) = &mut uvs {
            uvs.cut(&cut)?;
        }
        (triangles, edges) = (cut.triangles, cut.edges);
    }

    let colors = match mesh.colors() {
        Colors::None => Colors::None,
        Colors::Vertex(_) => Colors::Vertex(colors.into_iter().map(to_color).collect()),
        Colors::Face(faces) => {
            let parts = if faces.is_empty() { 1 } else { triangles.len() / faces.len() };
            Colors::Face(faces.iter().flat_map(|&color| std::iter::repeat_n(color, parts)).collect())
        }
    };
    let mut result =
        Mesh::new(positions.into_iter().map(to_f32).collect(), triangles)?.with_colors(colors)?;
    if mesh.has_own_edges() {
        result = result.with_edges(edges)?;
    }
    if let Some(normals) = normals {
        result = result.with_normals(normals.finish())?;
    }
    if let Some(uvs) = uvs {
        result = result.with_uvs(uvs.finish())?;
    }
    Ok(result)
}

/// Refuses a result that memory may not hold, before any of it is made.
fn check_size(mesh: &Mesh, level: u32) -> Result<(), SubdivideError> {
    let own_edges = if mesh.has_own_edges() { mesh.edges().len() } else { 0 };
    let fits = |level: u32| {
        let parts = 4_u64.checked_pow(level)?;
        let triangles = parts.checked_mul(mesh.triangles().len() as u64)?;
        let edges = (1_u64 << level).checked_mul(own_edges as u64)?;
        (triangles <= MOST_TRIANGLES && edges <= 3 * MOST_TRIANGLES).then_some(())
    };
    // Level 0 makes nothing new.
    if level == 0 || fits(level).is_some() {
        return Ok(());
    }
    // From level 32 on 4 to its power is no `u64`: nothing above fits.
    let most = (0..level.min(32)).rev().find(|&level| fits(level).is_some()).unwrap_or(0);
    Err(SubdivideError::TooLarge { triangles: mesh.triangles().len(), level, most })
}

/// One level: the new triangles and edges, and which old vertices each new one lies between.
struct Cut {
    triangles: Vec<[u32; 3]>,
    edges: Vec<[u32; 2]>,
    /// Vertex `old + i` is the midpoint of `pairs[i]`.
    pairs: Vec<[u32; 2]>,
}

impl Cut {
    fn new(triangles: &[[u32; 3]], edges: &[[u32; 2]], old: usize) -> Result<Self, MeshError> {
        // At most three new vertices a triangle and one an edge, so that every index below fits.
        let most = old + 3 * triangles.len() + edges.len();
        let old = u32::try_from(old).ok().filter(|_| u32::try_from(most).is_ok());
        let Some(old) = old else { return Err(MeshError::TooLarge(most, "vertices")) };

        let mut pairs = Vec::with_capacity(triangles.len() * 3 / 2 + edges.len());
        let mut known = HashMap::with_capacity(pairs.capacity());
        let mut next = old;
        // Numbered in the order of meeting them; the map is only asked, never iterated.
        let mut midpoint = |a: u32, b: u32| {
            let pair = [a.min(b), a.max(b)];
            *known.entry(pair).or_insert_with(|| {
                pairs.push(pair);
                next += 1;
                next - 1
            })
        };
        let triangles = triangles
            .iter()
            .flat_map(|&[a, b, c]| {
                let (ab, bc, ca) = (midpoint(a, b), midpoint(b, c), midpoint(c, a));
                [[a, ab, ca], [b, bc, ab], [c, ca, bc], [ab, bc, ca]]
            })
            .collect();
        let edges = edges
            .iter()
            .flat_map(|&[a, b]| {
                let ab = midpoint(a, b);
                [[a, ab], [ab, b]]
            })
            .collect();
        Ok(Self { triangles, edges, pairs })
    }

    /// Adds the midpoints of `values`. A sum of two is the same in both orders, so the pair's order is no matter.
    fn extend<const N: usize>(&self, values: &mut Vec<[f64; N]>) {
        values.reserve(self.pairs.len());
        for &[a, b] in &self.pairs {
            let (a, b) = (values[a as usize], values[b as usize]);
            values.push(std::array::from_fn(|i| (a[i] + b[i]) * 0.5));
        }
    }
}

/// Values at corners on their way through the levels.
struct Attribute<const N: usize> {
    values: Vec<[f64; N]>,
    indices: Option<Vec<[u32; 3]>>,
}

impl<const N: usize> Attribute<N> {
    fn new(corners: &Corners<[f32; N]>) -> Self {
        Self {
            values: corners.values().iter().map(|v| v.map(f64::from)).collect(),
            indices: corners.indices().map(<[_]>::to_vec),
        }
    }

    fn cut(&mut self, positions: &Cut) -> Result<(), MeshError> {
        match &mut self.indices {
            None => positions.extend(&mut self.values),
            Some(indices) => {
                let own = Cut::new(indices, &[], self.values.len())?;
                own.extend(&mut self.values);
                *indices = own.triangles;
            }
        }
        Ok(())
    }

    fn finish(self) -> Corners<[f32; N]> {
        let values = self.values.into_iter().map(to_f32).collect();
        match self.indices {
            None => Corners::per_vertex(values),
            Some(indices) => Corners::indexed(values, indices),
        }
    }
}

fn project(positions: &mut [[f64; 3]], onto: Onto) {
    let Onto::Sphere { center, radius } = onto else { return };
    for p in positions {
        let [x, y, z] = [p[0] - center[0], p[1] - center[1], p[2] - center[2]];
        let length = (x * x + y * y + z * z).sqrt();
        if length > 0.0 && length.is_finite() {
            let scale = radius / length;
            *p = [center[0] + x * scale, center[1] + y * scale, center[2] + z * scale];
        }
    }
}

/// The one rounding.
pub(crate) fn to_f32<const N: usize>(v: [f64; N]) -> [f32; N] {
    v.map(|x| x as f32)
}

fn to_color(code: [f64; 3]) -> Color {
    // Means of codes lie in 0…255; a float to integer cast saturates.
    let [r, g, b] = code.map(|x| (x + 0.5) as u8);
    Color::new(r, g, b)
}
