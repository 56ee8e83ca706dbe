//! Where inside a mesh there may be room for a ball: a coarse grid's opinion.
//!
//! ```text
//!     · · · · · · · ·        #  cells that a triangle touches (or may touch)
//!     · · # # # # · ·        ·  cells reached from outside
//!     · # # 2 2 # # ·        2  free cells enclosed by #: candidates, those farthest from # first
//!     · # 2 2 2 2 # ·
//!     · # # # # # # ·
//!     · · · · · · · ·
//! ```
//!
//! Nothing rests on it: a cell that is taken wrongly for inside, or for free, is found out by the triangles
//! themselves.

use polosa_math::Bounds;
use polosa_math::glam::DVec3;

use crate::Mesh;

/// Cells along the longest side: odd, so that one has the middle of the box for its centre.
const CELLS: usize = 31;

/// Looking at so many cells costs about a millisecond. A mesh whose triangles touch more for their number, such as
/// many large ones through each other, is given up.
const MOST_LOOKS: usize = 1 << 20;

/// A place for a ball.
#[derive(Clone, Copy, Debug)]
pub(super) struct Candidate {
    pub(super) center: DVec3,
    /// Candidates of the same room are connected: the surface winds around all of them alike.
    pub(super) room: usize,
}

const FREE: u32 = 0;
const TAKEN: u32 = 1;
const OUTSIDE: u32 = 2;

struct Grid {
    /// One layer around the mesh is always outside.
    size: [usize; 3],
    origin: DVec3,
    side: f64,
    cells: Vec<u32>,
}

/// Places for balls, the roomiest first.
pub(super) fn candidates(mesh: &Mesh) -> Vec<Candidate> {
    let (bounds, _) = Bounds::from_points(mesh.positions().iter().copied());
    let Some(mut grid) = Grid::around(&bounds) else { return Vec::new() };
    if !grid.take(mesh) {
        return Vec::new();
    }
    grid.flood(0, OUTSIDE);
    let mut room = OUTSIDE;
    for cell in 0..grid.cells.len() {
        if grid.cells[cell] == FREE {
            room += 1;
            grid.flood(cell, room);
        }
    }
    let clear = grid.clearances();
    let mut inside: Vec<usize> = (0..grid.cells.len()).filter(|&cell| grid.cells[cell] > OUTSIDE).collect();
    // Equally roomy ones in the grid's order.
    inside.sort_by(|&a, &b| clear[b].cmp(&clear[a]));
    let place = |cell: usize| Candidate { center: grid.center(cell), room: grid.cells[cell] as usize };
    inside.into_iter().map(place).collect()
}

impl Grid {
    fn around(bounds: &Bounds) -> Option<Self> {
        let center = bounds.center()?;
        let side = bounds.size().max_element() / (CELLS as f64 - 0.5);
        if !(side > 0.0 && side.is_finite()) {
            return None;
        }
        let size = bounds.size().to_array().map(|length| (length / side).ceil() as usize / 2 * 2 + 3);
        let half = DVec3::from_array(size.map(|cells| cells as f64)) * 0.5;
        let cells = vec![FREE; size.iter().product()];
        Some(Self { size, origin: center - half * side, side, cells })
    }

    const fn index(&self, [x, y, z]: [usize; 3]) -> usize {
        (z * self.size[1] + y) * self.size[0] + x
    }

    const fn place(&self, index: usize) -> [usize; 3] {
        let row = index / self.size[0];
        [index % self.size[0], row % self.size[1], row / self.size[1]]
    }

    fn center(&self, index: usize) -> DVec3 {
        self.origin + (DVec3::from_array(self.place(index).map(|k| k as f64)) + 0.5) * self.side
    }

    /// Takes the cells that triangles touch; `false` when that would be too many looks.
    fn take(&mut self, mesh: &Mesh) -> bool {
        let most = MOST_LOOKS + 16 * mesh.triangles().len();
        let mut looks = 0;
        let scaled: Vec<DVec3> = mesh
            .positions()
            .iter()
            .map(|position| (DVec3::from_array(position.map(f64::from)) - self.origin) / self.side)
            .collect();
        for triangle in mesh.triangles() {
            let [a, b, c] = triangle.map(|vertex| scaled[vertex as usize]);
            // Conversions to whole numbers stop at 0.
            let low = a.min(b).min(c).to_array().map(|k| (k - 1e-6) as usize);
            let high = a.max(b).max(c).to_array().map(|k| (k + 1e-6) as usize);
            let high = [0, 1, 2].map(|k| high[k].min(self.size[k] - 1));
            looks += (0..3).map(|k| high[k].saturating_sub(low[k]) + 1).product::<usize>();
            if looks > most {
                return false;
            }
            let normal = (b - a).cross(c - a);
            let reach = 0.5 * normal.abs().element_sum() * (1.0 + 1e-6);
            for z in low[2]..=high[2] {
                for y in low[1]..=high[1] {
                    for x in low[0]..=high[0] {
                        let middle = DVec3::new(x as f64, y as f64, z as f64) + 0.5;
                        if (middle - a).dot(normal).abs() <= reach {
                            let index = self.index([x, y, z]);
                            self.cells[index] = TAKEN;
                        }
                    }
                }
            }
        }
        true
    }

    /// Gives all free cells connected with one a number.
    fn flood(&mut self, from: usize, number: u32) {
        let mut edge = vec![from];
        self.cells[from] = number;
        while let Some(cell) = edge.pop() {
            let place = self.place(cell);
            for axis in 0..3 {
                for step in [usize::MAX, 1] {
                    let mut next = place;
                    next[axis] = next[axis].wrapping_add(step);
                    if next[axis] < self.size[axis] {
                        let index = self.index(next);
                        if self.cells[index] == FREE {
                            self.cells[index] = number;
                            edge.push(index);
                        }
                    }
                }
            }
        }
    }

    /// For each cell the distance from its centre to the nearest taken one, in half cells, squared: the minimum
    /// along x, of those along y, of those along z (the distance transform, axis by axis).
    fn clearances(&self) -> Vec<u32> {
        const FAR: u32 = 1 << 30;
        let mut clear: Vec<u32> =
            self.cells.iter().map(|&cell| if cell == TAKEN { 0 } else { FAR }).collect();
        let strides = [1, self.size[0], self.size[0] * self.size[1]];
        let mut row = Vec::new();
        for (axis, stride) in strides.into_iter().enumerate() {
            for start in (0..clear.len()).filter(|&cell| self.place(cell)[axis] == 0) {
                row.clear();
                row.extend((0..self.size[axis]).map(|k| clear[start + k * stride]));
                for k in 0..row.len() {
                    let gap = |other: usize| (2 * k.abs_diff(other)).saturating_sub(1) as u32;
                    let all = row.iter().enumerate().map(|(other, &clear)| clear + gap(other) * gap(other));
                    clear[start + k * stride] = all.min().unwrap_or(FAR).min(FAR);
                }
            }
        }
        clear
    }
}
