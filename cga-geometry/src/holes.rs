//! Faces without their holes.

use crate::derive::{CornerValues, Derivation, FaceOrigin};
use crate::mesh::Mesh;

/// The mesh with the outline of each face alone. Points of holes that no outline has are dropped. `None` if no face has a hole.
/// Tags and the values of corners stay.
pub fn without_holes(mesh: &Mesh) -> Option<Mesh> {
    if mesh.faces().all(|face| face.holes().len() == 0) {
        return None;
    }
    let mut filled = Derivation::new(mesh, CornerValues::All, mesh.corners().len()).with_old_points();
    for face in mesh.faces() {
        filled.keep(face.loop_ranges().take(1), FaceOrigin::piece(&face));
    }
    Some(filled.finish_used())
}
