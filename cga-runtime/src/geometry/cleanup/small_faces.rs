//! Removes small faces.

use super::doubles::is_closed;
use super::{Limits, add_face, without_faces};
use crate::geometry::disjoint::DisjointSets;
use crate::geometry::mesh::Mesh;

/// The parts of a mesh: faces that are connected by edges.
pub(super) fn components(mesh: &Mesh) -> DisjointSets {
    let adjacency = mesh.adjacency();
    let mut sets = DisjointSets::new(mesh.face_count());
    for edge in 0..adjacency.edge_count() {
        let uses = adjacency.uses(edge);
        uses.windows(2).for_each(|pair| sets.unite(adjacency.face(pair[0]), adjacency.face(pair[1])));
    }
    sets.flatten();
    sets
}

/// The mesh without faces whose area is below the limit. A closed part is removed as a whole, if all of it is that small; else it
/// stays. `None` if no face is removed.
pub(super) fn without_small_faces(mesh: &Mesh, limits: &Limits) -> Option<Mesh> {
    let areas: Vec<f64> = mesh.faces().map(|face| face.area()).collect();
    if areas.iter().all(|&area| limits.area < area) {
        return None;
    }
    let mut made = without_faces(mesh);
    let mut is_kept: Vec<bool> = areas.iter().map(|&area| limits.area < area).collect();
    for part in components(mesh).sets() {
        let area: f64 = part.iter().map(|&face| areas[face as usize]).sum();
        if limits.area < area && is_closed(mesh, &part, &[]) {
            part.iter().for_each(|&face| is_kept[face as usize] = true);
        }
    }
    if is_kept.iter().all(|&kept| kept) {
        return None;
    }
    (0..mesh.face_count()).filter(|&face| is_kept[face]).for_each(|face| add_face(&mut made, mesh, face));
    Some(made)
}
