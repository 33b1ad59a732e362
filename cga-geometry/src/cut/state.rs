//! The state that all steps of a cut share, and the faces that are not cut.

use super::class::ClassRange;
use super::points::{CutPoints, Location, NONE};
use crate::cut::caps::rim::{PlaneSide, Rim};
use crate::cut::caps::sheets::Sheets;
use crate::cut::slab::Slab;
use crate::each::Each;
use crate::exact::orient;
use crate::mesh::{FaceTag, Mesh};

/// A cut in progress.
#[derive(Default)]
pub(super) struct CutState {
    pub(super) points: CutPoints,
    pub(super) parts: Vec<Slab>,
    pub(super) rim: Rim,
    pub(super) sheets: Sheets,
    room: Vec<SlabRoom>,
    /// True if the mesh is inside out, computed on demand.
    pub(super) inverted: Option<bool>,
    /// The largest number of corners that the parts may have, without caps, and whether they would have more.
    pub(super) most_corners: usize,
    pub(super) is_too_large: bool,
}

/// The number of slabs from which on faces are counted before they are cut.
const MANY_SLABS: usize = 8;

/// The approximate number of faces that are counted: the larger of a total and a number per slab. In a large mesh this
/// is a sample.
const SAMPLE: usize = 1 << 14;
const SAMPLE_A_SLAB: usize = 1 << 9;

/// The expected contents of a slab.
#[derive(Clone, Copy, Default)]
struct SlabRoom {
    points: usize,
    /// The corners of faces inside the slab or on its upper plane.
    corners: usize,
    /// The loops of faces that are not cut.
    loops: usize,
    /// The numbers of faces to be cut whose lowest part is in this slab, and whose highest part is in the slab below.
    begin: usize,
    end: usize,
}

impl CutState {
    /// Returns true if its buffers are too large to be kept for the next cut.
    pub(super) fn is_large(&self) -> bool {
        const KEPT: usize = 1 << 20;
        KEPT < self.points.places.capacity() + self.rim.capacity()
    }

    /// Classifies the points and numbers those inside slabs. Returns false if the parts would be too large.
    pub(super) fn start(&mut self, mesh: &Mesh) -> bool {
        self.points.start(mesh);
        self.rim.reset();
        self.parts.clear();
        // An edge crosses each plane once at most, so most cuts are within the limit whatever they cross.
        let planes = self.points.planes.len();
        let can_be_more = self.most_corners < mesh.corners.len().saturating_mul(1 + 2 * planes);
        if can_be_more && MANY_SLABS <= planes && self.has_more_corners(mesh, self.most_corners) {
            self.is_too_large = true;
            return false;
        }
        self.make_room(mesh);
        let CutState { points, parts, .. } = self;
        for (index, &p) in mesh.points.iter().enumerate() {
            let class = points.places[index].class;
            points.places[index].number = if class.is_on_plane() {
                points.add(class.plane(), p, 0.0, [NONE; 2])
            } else {
                parts[class.slab() as usize].mesh.add_point(p)
            };
        }
        true
    }

    /// Returns true if the parts have more corners than `most`, without caps: each crossing of an edge is a corner on both sides.
    fn has_more_corners(&self, mesh: &Mesh, most: usize) -> bool {
        let class = |corner: usize| self.points.places[mesh.corners[corner] as usize].class;
        let crossings = |[a, b]: [usize; 2]| ClassRange::between(class(a), class(b)).planes().len();
        let mut corners = mesh.corners.len();
        most < corners
            || mesh.faces().flat_map(|face| face.edges()).any(|edge| {
                corners = corners.saturating_add(2 * crossings(edge));
                most < corners
            })
    }

    /// Makes the slabs with about the capacity that they will need. With many slabs, growing would take much of the
    /// time.
    fn make_room(&mut self, mesh: &Mesh) {
        let CutState { points, parts, room, .. } = self;
        let slabs = points.planes.len() + 1;
        room.clear();
        room.resize(slabs + 1, SlabRoom::default());
        points.places.iter().for_each(|place| room[place.class.slab() as usize].points += 1);
        if slabs < MANY_SLABS {
            // With few slabs: the share of faces follows from the share of points, and small meshes get enough room for
            // any cut.
            const SMALL: usize = 256;
            parts.extend(room[..slabs].iter().map(|room| {
                let share = room.points as f64 / mesh.points.len() as f64 * 1.02;
                let of = |all: usize| (all as f64 * share) as usize + all.min(SMALL);
                let points = room.points + room.points / 32 + mesh.points.len().min(SMALL);
                Slab::new(mesh, points, of(mesh.corners.len()), of(mesh.loop_ends.len()))
            }));
            return;
        }
        let faces = mesh.face_count();
        // An odd step, because meshes are often made of rows and pairs.
        let each = (faces / SAMPLE.max(slabs * SAMPLE_A_SLAB) + 1) | 1;
        let each = if faces / each < slabs { 1 } else { each };
        for face in (0..faces).step_by(each) {
            let corners = mesh.face_corners(face);
            let count = corners.len();
            let classes = mesh.corners[corners].iter().map(|&point| points.places[point as usize].class);
            let span = ClassRange::of(classes.clone());
            let (bottom, top) = (span.bottom() as usize, span.top() as usize);
            if bottom < top {
                // A face that reaches far is not representative.
                let many = if top - bottom < MANY_SLABS { each } else { 1 };
                classes.for_each(|class| room[class.slab() as usize].corners += many);
                room[bottom].begin += many;
                room[top + 1].end += many;
            } else {
                room[top].corners += each * count;
                room[top].loops += each * mesh.face_loops(face).len();
            }
        }
        // A margin for faces that were not counted, and for meshes that are open or have faces that are not convex.
        let spare = |count: usize| match count {
            0 => 0,
            _ => count + count / if each == 1 { 32 } else { 12 } + 4,
        };
        let mut pieces = 0;
        parts.extend((0..slabs).map(|slab| {
            let SlabRoom { points, corners, loops, begin, end } = room[slab];
            // A face that is cut by a plane has pieces on both sides of it. Each piece has two new corners at the
            // plane, and the cap has one. Two faces share each of these points.
            let crossings = pieces - end;
            pieces = crossings + begin;
            let crossings = crossings + pieces - room[slab + 1].end;
            Slab::new(mesh, spare(points + crossings), spare(corners + 3 * crossings), spare(loops + pieces))
        }));
    }

    /// Adds a face that is in one slab.
    pub(super) fn keep(&mut self, mesh: &Mesh, face: usize, tag: FaceTag, slab: u32, touches_plane: bool) {
        let CutState { parts, points, .. } = self;
        let part = &mut parts[slab as usize];
        part.whole += 1;
        let loops = mesh.face_loops(face);
        for &point in &mesh.corners[mesh.corners_of(&loops)] {
            let number = part.number(points, points.places[point as usize], slab);
            part.mesh.corners.push(number);
        }
        part.mesh.end_copy(mesh, loops, tag);
        if touches_plane {
            self.edges_on_planes(mesh, face, slab);
        }
    }

    fn edges_on_planes(&mut self, mesh: &Mesh, face: usize, slab: u32) {
        for ring in mesh.face(face).loops() {
            let mut last = ring[ring.len() - 1];
            for &here in ring {
                let [a, b] = [last, here].each(|point| self.points.places[point as usize]);
                if b.class.is_on_plane() && a.class == b.class {
                    let plane = b.class.plane();
                    self.rim.edge(plane, a.number, b.number, PlaneSide::of(slab, plane));
                }
                last = here;
            }
        }
    }

    /// Adds a face in a plane to the side behind it, because it closes that side. In a mesh that is inside out this is the side
    /// before it. If that tears a sheet apart, [`Sheets`] decide.
    pub(super) fn keep_flat(&mut self, mesh: &Mesh, face: usize, tag: FaceTag, plane: u32) {
        let by_rule = self.is_above_by_rule(mesh, face, plane);
        let is_above = self.sheets.place(face, plane, by_rule);
        self.keep(mesh, face, tag, plane + u32::from(is_above), true);
    }

    /// The slab of a face in a plane.
    pub(super) fn slab_of_flat(&mut self, mesh: &Mesh, face: usize, plane: u32) -> u32 {
        let by_rule = self.is_above_by_rule(mesh, face, plane);
        plane + u32::from(self.sheets.is_above(face, by_rule))
    }

    fn is_above_by_rule(&mut self, mesh: &Mesh, face: usize, plane: u32) -> bool {
        let view = mesh.face(face);
        if let [a, b, c] = mesh.corners[view.corner_range()] {
            let corners = [a, b, c].each(|point| self.points.places[point as usize]);
            return self.is_triangle_above(mesh, corners, plane);
        }
        self.is_facing_above(mesh, view.normal()[self.points.axis])
    }

    /// Returns true if a triangle in a plane goes above it. The test is exact, because the triangle may be the
    /// narrowest piece of a face.
    pub(super) fn is_triangle_above(&mut self, mesh: &Mesh, corners: [Location; 3], plane: u32) -> bool {
        let flat = &self.points.levels[plane as usize].flat;
        let [a, b, c] = corners.each(|corner| flat[corner.number as usize]);
        self.is_facing_above(mesh, f64::from(orient(a, b, c)))
    }

    /// Returns true if a part in a plane goes above it, given the upward component of its normal.
    fn is_facing_above(&mut self, mesh: &Mesh, up: f64) -> bool {
        if self.is_inverted(mesh) { up > 0.0 } else { up < 0.0 }
    }

    /// Returns true if the mesh is inside out.
    pub(super) fn is_inverted(&mut self, mesh: &Mesh) -> bool {
        *self.inverted.get_or_insert_with(|| mesh.is_inside_out())
    }
}

#[cfg(test)]
mod tests {
    use std::sync::Arc;

    use glam::DVec2;

    use super::*;
    use crate::Axis;
    use crate::cut::slabs;
    use crate::mesh::MeshBuilder;

    #[test]
    fn slabs_without_anything_get_no_room() {
        // More triangles than the sample of a large mesh, and still fewer than the slabs.
        let mut builder = MeshBuilder::new();
        let triangles = u32::try_from(SAMPLE).unwrap() + 1;
        for i in 0..triangles {
            let x = f64::from(i) * 4.0;
            let corners = [[x, 0.0, 0.0], [x + 1.0, 0.0, 0.0], [x, 1.0, 0.0]].map(|point| builder.point(point));
            builder.face(&corners, &[], FaceTag::PLAIN);
        }
        let mesh = builder.build().unwrap();
        let mut state = CutState { most_corners: usize::MAX, ..CutState::default() };
        state.points.planes.extend((0..8 * triangles).map(|i| f64::from(i) * 0.5 + 0.25));
        assert!(state.start(&mesh));
        let corners: usize = state.parts.iter().map(|part| part.mesh.corners.capacity()).sum();
        assert!(corners <= 10 * mesh.corners.len(), "{corners}");
    }

    /// A torus around z in triangles, with texture coordinates.
    fn torus(around: u32, across: u32) -> Mesh {
        let mut builder = MeshBuilder::new();
        for u in 0..around {
            for v in 0..across {
                let [a, b] =
                    [(u, around), (v, across)].map(|(i, of)| f64::from(i) / f64::from(of) * std::f64::consts::TAU);
                let r = 1.0 + 0.4 * libm::cos(b);
                builder.point([r * libm::cos(a), r * libm::sin(a), 0.4 * libm::sin(b)]);
            }
        }
        let at = |u: u32, v: u32| u % around * across + v % across;
        for (u, v) in (0..around).flat_map(|u| (0..across).map(move |v| (u, v))) {
            let [a, b, c, d] = [at(u, v), at(u + 1, v), at(u + 1, v + 1), at(u, v + 1)];
            for corners in [[a, b, c], [a, c, d]] {
                builder.face(&corners, &[], FaceTag::PLAIN).uvs(&[DVec2::ZERO, DVec2::X, DVec2::ONE]);
            }
        }
        builder.build().unwrap()
    }

    #[test]
    fn parts_keep_little_more_memory_than_they_need() {
        for (around, across) in [(256, 128), (64, 500)] {
            let mesh = Arc::new(torus(around, across));
            for pieces in [2, 9, 300] {
                for (axis, reach) in [(Axis::X, 1.4), (Axis::Z, 0.4)] {
                    let offsets: Vec<f64> =
                        (1..pieces).map(|i| reach * (2.0 * f64::from(i) / f64::from(pieces) - 1.0)).collect();
                    let parts = slabs(&mesh, axis, &offsets).parts;
                    let bytes = parts.iter().flatten().map(|part| part.bytes());
                    let [used, kept] = bytes.fold([0; 2], |sum, next| [sum[0] + next[0], sum[1] + next[1]]);
                    let share = kept as f64 / used as f64;
                    assert!(share <= 1.1, "{around} x {across} in {pieces} across {axis:?}: {share}");
                }
            }
        }
    }
}
