//! The edges of roofs: eaves, hips, valleys and ridges.
//!
//! A roof is what looks up. Of its edges, level ones that only one of its faces has are eaves, and those that two have are
//! valleys where the faces slope towards each other, hips where they touch an eave, else ridges. What looks down or
//! sideways below or beside the roof does not count, so it is the same for a roof that is a closed volume.

use glam::DVec3;

use super::select::RoofEdge;
use crate::mesh::{Mesh, unit};
use crate::tol::UP_EPSILON;

/// What an edge is of a roof; the normals are those of the mesh's faces.
pub(super) fn roof_edge(mesh: &Mesh, normals: &[DVec3], edge: usize) -> Option<RoofEdge> {
    match roof_faces(mesh, normals, edge) {
        (Some(_), None) => is_level(mesh, edge).then_some(RoofEdge::Eave),
        (Some(one), Some(other)) => {
            let touches_eave = || {
                let corner = mesh.adjacency().uses(edge)[0];
                [corner, mesh.adjacency().next(corner)]
                    .iter()
                    .any(|&corner| eaves_at(mesh, normals, mesh.corners()[corner as usize] as usize))
            };
            Some(match () {
                () if is_concave(mesh, normals, edge, one, other) => RoofEdge::Valley,
                () if touches_eave() => RoofEdge::Hip,
                () => RoofEdge::Ridge,
            })
        }
        _ => None,
    }
}

/// The first two faces at an edge that look up.
fn roof_faces(mesh: &Mesh, normals: &[DVec3], edge: usize) -> (Option<u32>, Option<u32>) {
    let mut faces = mesh.adjacency().faces_at(edge).filter(|&face| UP_EPSILON < normals[face as usize].y);
    (faces.next(), faces.next())
}

fn is_level(mesh: &Mesh, edge: usize) -> bool {
    let [a, b] = mesh.edge_ends(edge);
    a != b && unit(b - a).y.abs() <= UP_EPSILON
}

/// Whether an eave ends at a point.
fn eaves_at(mesh: &Mesh, normals: &[DVec3], point: usize) -> bool {
    let adjacency = mesh.adjacency();
    adjacency.at(point).iter().any(|&corner| {
        let edges = [corner, adjacency.before(corner)].map(|corner| adjacency.edge(corner));
        edges.into_iter().any(|edge| matches!(roof_faces(mesh, normals, edge), (Some(_), None)) && is_level(mesh, edge))
    })
}

/// Whether two faces slope towards each other: the inside of one is in front of the other.
fn is_concave(mesh: &Mesh, normals: &[DVec3], edge: usize, one: u32, other: u32) -> bool {
    let adjacency = mesh.adjacency();
    let uses = adjacency.uses(edge);
    let Some(&corner) = uses.iter().find(|&&corner| adjacency.face(corner) == one) else { return false };
    let at = |corner: u32| mesh.points()[mesh.corners()[corner as usize] as usize];
    let along = unit(at(adjacency.next(corner)) - at(corner));
    let inwards = normals[one as usize].cross(along);
    UP_EPSILON < inwards.dot(normals[other as usize])
}
