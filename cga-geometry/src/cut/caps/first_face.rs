//! The first face of a part.
//!
//! If a part has no piece of the mesh's first face, the cap towards that face comes first, so that the first edge survives. It begins with the edge where it meets the wall, the face on the other
//! side of the first edge.

use std::ops::Range;

use glam::{DVec2, DVec3};

use crate::cut::class::ClassRange;
use crate::cut::points::PieceCorner;
use crate::cut::state::CutState;
use crate::exact::winding;
use crate::mesh::Mesh;
use crate::small_sort::SmallSort;
use crate::triangulate::PlaneProjection;

/// The slabs of the mesh's first face, and the edges of the wall at its first edge.
#[derive(Default)]
pub(crate) struct Lead {
    slabs: Range<u32>,
    /// The edges of the wall in the planes that do not cut the first face: the plane, and the numbers of the points there, the lower first. Sorted.
    wall: Vec<(u32, [u32; 2])>,
    nodes: Vec<PieceCorner>,
}

impl Lead {
    /// Finds the first face and the wall. Call it after all faces have been cut.
    pub(crate) fn find(&mut self, state: &mut CutState, mesh: &Mesh) {
        self.wall.clear();
        let first = mesh.face(0);
        let span = ClassRange::of(first.loops().flatten().map(|&point| state.points.places[point as usize].class));
        self.slabs = if span.is_flat() {
            let slab = state.slab_of_flat(mesh, 0, span.low.plane());
            slab..slab + 1
        } else {
            span.bottom()..span.top() + 1
        };
        let everywhere = self.slabs == (0..state.points.planes.len() as u32 + 1);
        if everywhere {
            return;
        }
        let Some(wall) = behind_first_edge(mesh) else { return };
        self.nodes.clear();
        for ring in mesh.face(wall).loop_ranges() {
            // These crossings exist already: the wall was cut like all faces.
            state.points.cross_loop(&mut state.parts, mesh, ring, &mut self.nodes);
        }
        let points = &state.points;
        let wall = Wall::of(mesh, wall);
        // Between two pieces of the first face no cap comes first, so none has to begin at the wall.
        let between = self.slabs.start..self.slabs.end - 1;
        self.nodes.retain(|node| node.class().is_on_plane() && !between.contains(&node.class().plane()));
        self.nodes.small_sort_by_key(PieceCorner::class);
        self.nodes.dedup_by_key(|node| node.place);
        let mut left = QUESTIONS;
        for met in self.nodes.chunk_by_mut(|a, b| a.class() == b.class()) {
            let flat =
                |node: &PieceCorner| points.levels[node.class().plane() as usize].flat[node.place.number as usize];
            let from = flat(&met[0]);
            let reach = met.iter().fold(DVec2::ZERO, |reach, node| reach.max((flat(node) - from).abs()));
            let along = usize::from(reach.x < reach.y);
            met.small_sort_by(|a, b| flat(a)[along].total_cmp(&flat(b)[along]));
            // If a plane meets the wall several times, some stretches between two points are outside the wall.
            let questions = met.len() * wall.corners();
            let few = questions <= left;
            if few && met.len() > 2 {
                left -= questions;
            }
            let is_wall = |pair: &&[PieceCorner]| {
                let middle = || pair.iter().map(|node| points.position(mesh, node)).sum::<DVec3>() * 0.5;
                met.len() == 2 || (few && wall.holds(middle()))
            };
            self.wall.extend(met.windows(2).filter(is_wall).map(|pair| {
                let [a, b] = [pair[0].place.number, pair[1].place.number];
                (pair[0].class().plane(), [a.min(b), a.max(b)])
            }));
        }
        self.wall.small_sort();
    }

    /// The position in a ring of points on a plane where an edge of the wall begins.
    pub(crate) fn edge_in(&self, plane: u32, ring: &[u32]) -> Option<usize> {
        let start = self.wall.partition_point(|&(on, _)| on < plane);
        let end = self.wall.partition_point(|&(on, _)| on <= plane);
        let wall = &self.wall[start..end];
        if wall.is_empty() {
            return None;
        }
        let mut edges = ring.iter().zip(ring.iter().cycle().skip(1));
        edges.position(|(&a, &b)| wall.binary_search(&(plane, [a.min(b), a.max(b)])).is_ok())
    }

    /// For a slab without a piece of the mesh's first face: whether its cap in this plane is the one towards that face.
    pub(crate) fn is_nearer(&self, slab: u32, plane: u32) -> Option<bool> {
        // The upper plane of a slab has the slab's number.
        (!self.slabs.contains(&slab)).then_some((plane == slab) == (slab < self.slabs.start))
    }
}

/// The limit on tests whether a point is on the wall, per cut and counted by corners. Beyond it the caps begin with any
/// edge.
const QUESTIONS: usize = 1 << 16;

/// A face seen from outside.
struct Wall {
    projection: PlaneProjection,
    rings: Vec<Vec<DVec2>>,
}

impl Wall {
    fn of(mesh: &Mesh, face: usize) -> Self {
        let face = mesh.face(face);
        let projection = PlaneProjection::along(face.area_vector());
        let ring = |ring: &[u32]| ring.iter().map(|&point| projection.apply(mesh.points[point as usize])).collect();
        Wall { projection, rings: face.loops().map(ring).collect() }
    }

    fn corners(&self) -> usize {
        self.rings.iter().map(Vec::len).sum()
    }

    /// Returns true if a point in the plane of the face is inside it or on its rim.
    fn holds(&self, point: DVec3) -> bool {
        let turns = self.rings.iter().map(|ring| winding(ring, self.projection.apply(point)));
        turns.sum::<Option<i32>>() != Some(0)
    }
}

/// The face that has the first edge of the first face in the opposite direction.
fn behind_first_edge(mesh: &Mesh) -> Option<usize> {
    /// The number of corners that are compared without a branch.
    const BLOCK: usize = 32;
    let [a, b] = mesh.corners.first_chunk().copied()?;
    for (number, block) in mesh.corners.chunks(BLOCK).enumerate() {
        if !block.contains(&a) {
            continue;
        }
        for (at, _) in block.iter().enumerate().filter(|(_, point)| **point == a) {
            let corner = number * BLOCK + at;
            let ring = mesh.loop_ends.partition_point(|&end| end as usize <= corner);
            let range = mesh.loop_range(ring);
            let before = if corner == range.start { range.end - 1 } else { corner - 1 };
            if mesh.corners[before] == b {
                return Some(mesh.face_ends.face_of(ring)).filter(|&face| face != 0);
            }
        }
    }
    None
}
