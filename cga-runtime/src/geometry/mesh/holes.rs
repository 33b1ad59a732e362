//! Faces without their holes (*deleteHoles operation*).

use super::Mesh;

impl Mesh {
    /// The mesh with the outline of each face alone. Points of holes that no outline has are dropped. `None` if no face has a
    /// hole.
    pub(crate) fn without_holes(&self) -> Option<Mesh> {
        if self.faces().all(|face| face.holes().len() == 0) {
            return None;
        }
        let mut filled = self.alike(0);
        for face in self.faces() {
            let outline = face.loop_ranges().next().unwrap_or_default();
            filled.corners.extend_from_slice(&self.corners[outline.clone()]);
            filled.copy_values(self, outline);
            filled.end_loop();
            filled.end_face(face.tag());
        }
        filled.take_points(self);
        Some(filled)
    }
}
