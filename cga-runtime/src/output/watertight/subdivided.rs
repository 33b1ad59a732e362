//! Meshes with more points in their edges.

use std::collections::HashMap;

use glam::DAffine3;

use super::edge_points::EdgePoints;
use crate::fixed_hash::FixedState;
use crate::geometry::derive::{CornerValues, Derivation, FaceOrigin};
use crate::geometry::each::Each;
use crate::geometry::mesh::Mesh;
use crate::geometry::origin::PointOrigin;

/// The mesh with all points inside of its edges as corners. `placement` maps it to the world, where the points are.
pub(super) fn subdivided(mesh: &Mesh, placement: &DAffine3, edges: &EdgePoints) -> Mesh {
    let back = placement.inverse();
    let place = |point: u32| placement.transform_point3(mesh.points()[point as usize]);
    let is_placed = *placement != DAffine3::IDENTITY;
    let mut made = Derivation::new(mesh, CornerValues::All, mesh.corners().len()).with_old_points();
    // The new points of each edge, from its lower point to its higher one. Only for look-ups, never iterated.
    let mut known: HashMap<[u32; 2], Vec<u32>, FixedState> = HashMap::default();
    for face in mesh.faces() {
        let mut loops: Vec<Vec<u32>> = Vec::new();
        for ring in face.loops() {
            let mut corners = Vec::with_capacity(ring.len());
            for (&from, &to) in ring.iter().zip(ring.iter().cycle().skip(1)) {
                corners.push(from);
                let ends = [from.min(to), from.max(to)];
                let points = known.entry(ends).or_insert_with(|| {
                    let [low, high] = ends.each(place);
                    let length = (high - low).length();
                    let added = edges.inside([low, high]).map(|point| {
                        let share = ((point - low).length() / length).clamp(0.0, 1.0);
                        let local = if is_placed { back.transform_point3(point) } else { point };
                        made.point(local, PointOrigin::Between { ends, share })
                    });
                    added.collect()
                });
                if from == ends[0] {
                    corners.extend_from_slice(points);
                } else {
                    corners.extend(points.iter().rev());
                }
            }
            loops.push(corners);
        }
        made.face(loops, FaceOrigin::piece(&face));
    }
    made.finish()
}
