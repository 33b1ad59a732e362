//! Faces without their holes.

use crate::derive::{CornerValues, Derivation, FaceOrigin};
use crate::mesh::Mesh;
use crate::work;

/// The units of work of a corner.
const CORNER: usize = 8;

/// The mesh with the outline of each face alone. Points of holes that no outline has are dropped. `None` if no face has a hole.
/// Tags and the values of corners stay. Also `None` if the work of a [`Supervisor`](crate::work::Supervisor) ends meanwhile.
pub fn without_holes(mesh: &Mesh) -> Option<Mesh> {
    if mesh.faces().all(|face| !work::spend(1) || face.holes().len() == 0) {
        return None;
    }
    let mut filled = Derivation::new(mesh, CornerValues::All, mesh.corners().len()).with_old_points();
    for face in mesh.faces() {
        if !work::spend(CORNER * face.corner_count()) {
            return None;
        }
        filled.keep(face.loop_ranges().take(1), FaceOrigin::piece(&face));
    }
    Some(filled.finish_used()).filter(|_| work::spend(0))
}
