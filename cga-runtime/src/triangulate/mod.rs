//! Polygons with holes into triangles.
//!
//! Triangles use the corners of the polygon and nothing else, run the same way round, and together have its outline as
//! their rim: each edge of each loop belongs to exactly one triangle, collinear corners included, so a closed mesh gives
//! closed triangles. Of `n` corners and `h` holes there are `n + 2h − 2`, unless loops touch.
//!
//! Convex polygons are fans. The rest goes through ear cutting, whose answer is checked by count and by area, then
//! through a constrained Delaunay triangulation, and when the loops cross each other, through a plain ear cutter that
//! keeps the rim whatever the geometry. Nothing here panics; the same input gives the same triangles.

mod convex;
mod delaunay;
mod ears;

use earcut::Earcut;
use glam::{DVec2, DVec3};

use crate::mesh::Mesh;
use crate::tol::AREA_EPSILON;

/// Which two coordinates to keep to lay a face flat, so that counter-clockwise stays so. Dropping a coordinate moves
/// nothing, so points that are exactly on a line stay on it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Projection {
    u: usize,
    v: usize,
}

impl Projection {
    /// Drops the coordinate in which the normal is longest.
    pub(crate) fn along(normal: DVec3) -> Self {
        let size = normal.abs();
        let axis = if size.x >= size.y && size.x >= size.z {
            0
        } else if size.y >= size.z {
            1
        } else {
            2
        };
        let (u, v) = ((axis + 1) % 3, (axis + 2) % 3);
        if normal[axis] < 0.0 { Projection { u: v, v: u } } else { Projection { u, v } }
    }

    #[inline]
    pub(crate) fn apply(self, p: DVec3) -> DVec2 {
        DVec2::new(p[self.u], p[self.v])
    }
}

/// Triangulates faces; keeps its buffers from one to the next.
#[derive(Default)]
pub struct Triangulator {
    flat: Vec<DVec2>,
    ends: Vec<u32>,
    found: Vec<[u32; 3]>,
    local: Vec<[f64; 2]>,
    indices: Vec<u32>,
    holes: Vec<u32>,
    earcut: Option<Earcut<f64>>,
}

impl std::fmt::Debug for Triangulator {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.debug_struct("Triangulator").finish_non_exhaustive()
    }
}

impl Triangulator {
    /// With empty buffers.
    pub fn new() -> Self {
        Self::default()
    }

    /// Appends the triangles of a face as positions in [`Mesh::corners`] (and so in its texture coordinates and normals).
    pub fn face(&mut self, mesh: &Mesh, face: usize, out: &mut Vec<[u32; 3]>) {
        let face = mesh.face(face);
        let range = face.corner_range();
        let start = range.start as u32;
        if range.len() == 3 {
            out.push([start, start + 1, start + 2]);
            return;
        }
        let projection = Projection::along(face.area_vector());
        let mut flat = std::mem::take(&mut self.flat);
        let mut ends = std::mem::take(&mut self.ends);
        flat.clear();
        ends.clear();
        flat.extend(range.clone().map(|c| projection.apply(face.position(c))));
        ends.extend(face.loop_ranges().map(|l| (l.end - range.start) as u32));
        let from = out.len();
        self.polygon(&flat, &ends, out);
        out[from..].iter_mut().flatten().for_each(|c| *c += start);
        (self.flat, self.ends) = (flat, ends);
    }

    /// Appends the triangles of a polygon as indices of its points: loop after loop, the outline counter-clockwise, holes
    /// clockwise; `loop_ends` says where each loop ends.
    pub fn polygon(&mut self, points: &[DVec2], loop_ends: &[u32], out: &mut Vec<[u32; 3]>) {
        let count = points.len();
        if loop_ends.last().copied() != Some(count as u32) || count < 3 {
            return;
        }
        if loop_ends.len() == 1 && convex::fan(points, out) {
            return;
        }
        let area = Measure::of(points, loop_ends);
        let mut found = std::mem::take(&mut self.found);
        found.clear();
        self.cut_ears(points, loop_ends, &mut found);
        let complete = found.len() == count + 2 * loop_ends.len() - 4 && area.agrees(points, &found);
        if !complete {
            found.clear();
            delaunay::triangulate(points, loop_ends, &mut found);
            if found.is_empty() || !area.agrees(points, &found) {
                found.clear();
                ears::triangulate(points, loop_ends, &mut found);
            }
        }
        out.extend_from_slice(&found);
        self.found = found;
    }

    fn cut_ears(&mut self, points: &[DVec2], loop_ends: &[u32], found: &mut Vec<[u32; 3]>) {
        // Local coordinates: ear cutting rounds, and far from the origin it would round more.
        self.local.clear();
        self.local.extend(points.iter().map(|p| (p - points[0]).to_array()));
        self.holes.clear();
        self.holes.extend_from_slice(&loop_ends[..loop_ends.len() - 1]);
        if !self.local.iter().flatten().all(|c| c.is_finite()) {
            return;
        }
        let earcut = self.earcut.get_or_insert_with(Earcut::new);
        earcut.earcut(self.local.iter().copied(), &self.holes, &mut self.indices);
        let local = &self.local;
        found.extend(self.indices.chunks_exact(3).map(|t| {
            // The ear cutter's triangles run one way whatever that of the outline: turn them to run ours.
            let [a, b, c] = [t[0], t[1], t[2]].map(|i| DVec2::from(local[i as usize]));
            let turn = (b - a).perp_dot(c - a);
            if turn < 0.0 { [t[0], t[2], t[1]] } else { [t[0], t[1], t[2]] }
        }));
    }
}

/// The signed area of a polygon, and the scale to compare it at.
struct Measure {
    signed: f64,
    scale: f64,
}

impl Measure {
    fn of(points: &[DVec2], loop_ends: &[u32]) -> Self {
        let from = points[0];
        let (mut signed, mut scale, mut start) = (0.0, 0.0, 0);
        for &end in loop_ends {
            let ring = &points[start..end as usize];
            start = end as usize;
            let Some(&last) = ring.last() else { continue };
            let mut a = last - from;
            let mut area = 0.0;
            for &p in ring {
                let b = p - from;
                area += a.perp_dot(b);
                a = b;
            }
            signed += area;
            scale += area.abs();
        }
        Measure { signed, scale }
    }

    /// Whether triangles cover this area, none of them turned over.
    fn agrees(&self, points: &[DVec2], triangles: &[[u32; 3]]) -> bool {
        let mut sum = 0.0;
        for t in triangles {
            let [a, b, c] = t.map(|i| points[i as usize]);
            sum += (b - a).perp_dot(c - a).abs();
        }
        (sum - self.signed).abs() <= AREA_EPSILON * self.scale
    }
}

#[cfg(test)]
mod tests;
