//! The edges of a mesh, each once.

use crate::mesh::Mesh;

/// Calls with the two points of every edge and the number of faces that have it, sorted by points.
pub(super) fn each(mesh: &Mesh, mut call: impl FnMut([u32; 2], usize)) {
    let mut uses: Vec<([u32; 2], u32)> = Vec::with_capacity(mesh.corners().len());
    for face in mesh.faces() {
        for ring in face.loops() {
            let mut last = ring[ring.len() - 1];
            for &here in ring {
                uses.push(([last.min(here), last.max(here)], face.index() as u32));
                last = here;
            }
        }
    }
    uses.sort_unstable();
    // A face may have an edge twice, where it touches itself.
    uses.dedup();
    uses.chunk_by(|a, b| a.0 == b.0).for_each(|same| call(same[0].0, same.len()));
}
