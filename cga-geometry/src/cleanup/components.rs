//! Parts of a mesh that are connected.

use super::spend;
use crate::disjoint::DisjointSets;
use crate::long_sort::long_sort_by;
use crate::mesh::Mesh;

/// The parts of a mesh: faces that are connected by edges. Some may be missing if the work is to end.
pub(super) fn components(mesh: &Mesh) -> DisjointSets {
    let adjacency = mesh.adjacency();
    let mut sets = DisjointSets::new(mesh.face_count());
    for edge in 0..adjacency.edge_count() {
        let uses = adjacency.uses(edge);
        if spend(uses.len()).is_none() {
            break;
        }
        uses.windows(2).for_each(|pair| sets.unite(adjacency.face(pair[0]), adjacency.face(pair[1])));
    }
    sets
}

/// Returns true if all edges of the faces without some, which are sorted, are used as often in both directions. False if the work is to
/// end.
pub(super) fn is_closed(mesh: &Mesh, faces: &[u32], without: &[u32]) -> bool {
    let mut uses: Vec<(usize, i64)> = Vec::new();
    for &face in faces.iter().filter(|face| without.binary_search(face).is_err()) {
        if spend(mesh.face_corners(face as usize).len()).is_none() {
            return false;
        }
        for [a, b] in mesh.face(face as usize).edges() {
            let step = if mesh.corners[a] < mesh.corners[b] { 1 } else { -1 };
            uses.push((mesh.adjacency().edge(a as u32), step));
        }
    }
    long_sort_by(&mut uses, Ord::cmp)
        && uses.chunk_by(|a, b| a.0 == b.0).all(|uses| uses.iter().map(|one| one.1).sum::<i64>() == 0)
}
