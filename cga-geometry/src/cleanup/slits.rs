//! Removes edges that one face has in both directions: bridges to holes, borders between holes, and spikes.

use super::regions::{Removal, joined};
use super::spend;
use crate::each::Each;
use crate::mesh::{Mesh, in_order};
use crate::small_sort::SmallSort;

/// The edges with tags that one face has in both directions, as pairs of points in order.
pub(super) fn tagged_slits(mesh: &Mesh) -> Vec<[u32; 2]> {
    if mesh.subcomponent_tags.edges().len() == 0 {
        return Vec::new();
    }
    let adjacency = mesh.adjacency();
    let is_slit = |edge: &usize| {
        let uses = adjacency.uses(*edge);
        uses.windows(2).any(|pair| adjacency.face(pair[0]) == adjacency.face(pair[1]))
    };
    let slits = (0..adjacency.edge_count()).filter(is_slit).map(|edge| ends(mesh, adjacency.uses(edge)[0]));
    let mut found: Vec<[u32; 2]> = slits.filter(|&ends| mesh.edge_tags(ends).is_some()).map(in_order).collect();
    found.small_sort();
    found
}

/// The mesh without the edges that one face has in both directions, except for some, which are sorted. `None` if no face has one.
pub(super) fn without_slits(mesh: &Mesh, kept: &[[u32; 2]]) -> Option<Mesh> {
    let adjacency = mesh.adjacency_in_time()?;
    let mut removal = Removal::none(mesh);
    let mut is_any = false;
    for edge in 0..adjacency.edge_count() {
        let uses = adjacency.uses(edge);
        spend(uses.len())?;
        // The uses are in the order of faces.
        for here in uses.chunk_by(|&a, &b| adjacency.face(a) == adjacency.face(b)) {
            if here.len() < 2 || kept.binary_search(&in_order(ends(mesh, here[0]))).is_ok() {
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
    [corner, mesh.adjacency().next(corner)].each(|corner| mesh.corners[corner as usize])
}
