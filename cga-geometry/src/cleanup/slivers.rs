//! Joins faces without an area to their neighbours.

use super::regions::{KEPT, Removal, joined};
use super::values::have_same_attributes;
use super::{Limits, spend, values};
use crate::each::Each;
use crate::mesh::Mesh;
use crate::tol::FLAT_EPSILON;

/// The mesh without faces that have no area because their corners are on a line, where a neighbour has their longest edge: the
/// neighbour gets their other corners. So a closed mesh stays closed. `None` if no face is removed.
pub(super) fn without_slivers(mesh: &Mesh, limits: &Limits) -> Option<Mesh> {
    let mut removal = Removal::none(mesh);
    let mut is_used = vec![false; mesh.face_count()];
    let mut is_any = false;
    for face in 0..mesh.face_count() as u32 {
        spend(mesh.face_corners(face as usize).len())?;
        let Some(longest) = longest_edge_of_sliver(mesh, face) else { continue };
        let Some(other) = neighbour(mesh, longest) else { continue };
        let into = mesh.adjacency().face(other);
        let fits = !is_used[face as usize]
            && !is_used[into as usize]
            && removal.mates[other as usize] == KEPT
            && have_same_attributes(mesh, face, into)
            && values::continue_over(mesh, longest, other, limits)
            && mesh.edge_tags([longest, other].each(|corner| mesh.corners[corner as usize])).is_none();
        if fits {
            (is_used[face as usize], is_used[into as usize]) = (true, true);
            removal.remove(longest, other);
            let [first, last] = [face.min(into), face.max(into)];
            removal.regions[last as usize] = first;
            is_any = true;
        }
    }
    is_any.then(|| joined(mesh, &removal)).flatten()
}

/// The corner that has the edge in the other direction, if exactly one other face has it.
pub(super) fn neighbour(mesh: &Mesh, corner: u32) -> Option<u32> {
    let adjacency = mesh.adjacency();
    let &[one, two] = adjacency.uses(adjacency.edge(corner)) else { return None };
    let other = if one == corner { two } else { one };
    let is_opposite = mesh.corners[one as usize] != mesh.corners[two as usize];
    (is_opposite && adjacency.face(one) != adjacency.face(two)).then_some(other)
}

/// The corner at which the longest edge of a face without an area starts.
fn longest_edge_of_sliver(mesh: &Mesh, face: u32) -> Option<u32> {
    let face = mesh.face(face as usize);
    if 1 < face.loops().len() || FLAT_EPSILON < face.area() {
        return None;
    }
    let length = |[a, b]: [usize; 2]| face.position(a).distance(face.position(b));
    let longest = face.edges().max_by(|&a, &b| length(a).total_cmp(&length(b)))?;
    let [from, to] = longest.each(|corner| face.position(corner));
    let along = (to - from) / from.distance(to);
    let on_line = |corner: usize| (face.position(corner) - from).cross(along).length() <= FLAT_EPSILON;
    face.corner_range().all(on_line).then_some(longest[0] as u32)
}
