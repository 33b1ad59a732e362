//! Removes edges that one face has in both directions: bridges to holes, borders between holes, and spikes.

use super::regions::{Removal, joined};
use crate::geometry::mesh::Mesh;

/// The mesh without the edges without tags that one face has in both directions. `None` if no face has one.
pub(super) fn without_slits(mesh: &Mesh) -> Option<Mesh> {
    let adjacency = mesh.adjacency();
    let mut removal = Removal::none(mesh);
    let mut is_any = false;
    for edge in 0..adjacency.edge_count() {
        let uses = adjacency.uses(edge);
        // The uses are in the order of faces.
        for here in uses.chunk_by(|&a, &b| adjacency.face(a) == adjacency.face(b)) {
            if here.len() < 2 || mesh.edge_tags(ends(mesh, here[0])).is_some() {
                continue;
            }
            let start = mesh.corners[here[0] as usize];
            let (ahead, back): (Vec<u32>, Vec<u32>) =
                here.iter().partition(|&&corner| mesh.corners[corner as usize] == start);
            for (&one, &other) in ahead.iter().zip(&back) {
                removal.remove(one, other);
                is_any = true;
            }
        }
    }
    is_any.then(|| joined(mesh, &removal)).flatten()
}

fn ends(mesh: &Mesh, corner: u32) -> [u32; 2] {
    [corner, mesh.adjacency().next(corner)].map(|corner| mesh.corners[corner as usize])
}
