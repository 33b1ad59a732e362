//! Parts of a mesh that are connected.

use std::collections::BTreeMap;

use crate::disjoint::DisjointSets;
use crate::mesh::Mesh;

/// The parts of a mesh: faces that are connected by edges.
pub(super) fn components(mesh: &Mesh) -> DisjointSets {
    let adjacency = mesh.adjacency();
    let mut sets = DisjointSets::new(mesh.face_count());
    for edge in 0..adjacency.edge_count() {
        let uses = adjacency.uses(edge);
        uses.windows(2).for_each(|pair| sets.unite(adjacency.face(pair[0]), adjacency.face(pair[1])));
    }
    sets
}

/// Returns true if all edges of the faces without some, which are sorted, are used as often in both directions.
pub(super) fn is_closed(mesh: &Mesh, faces: &[u32], without: &[u32]) -> bool {
    let mut counts: BTreeMap<usize, i64> = BTreeMap::new();
    for &face in faces.iter().filter(|face| without.binary_search(face).is_err()) {
        for [a, b] in mesh.face(face as usize).edges() {
            let step = if mesh.corners[a] < mesh.corners[b] { 1 } else { -1 };
            *counts.entry(mesh.adjacency().edge(a as u32)).or_default() += step;
        }
    }
    counts.values().all(|&count| count == 0)
}
