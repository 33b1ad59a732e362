//! The triangles of faces.

use super::Mesh;
use crate::each::Each;
use crate::triangulate::{Triangulator, is_surely_convex};

impl Triangulator {
    /// Appends the triangles of a face as indices into [`Mesh::corners`], and so into its texture coordinates and
    /// normals.
    ///
    /// The caps on both sides of a cut have the same triangles, reversed.
    ///
    /// # Panics
    /// Panics if the face does not exist.
    pub fn face(&mut self, mesh: &Mesh, face: usize, out: &mut Vec<[u32; 3]>) {
        let face = mesh.face(face);
        let range = face.corner_range();
        if range.len() == 3 {
            let start = range.start as u32;
            out.push([start, start + 1, start + 2]);
            return;
        }
        if let Some(unbent) = face.unbent() {
            out.extend(unbent);
            return;
        }
        if range.len() == 4
            && !face.tag().cap
            && is_surely_convex([0, 1, 2, 3].each(|at| face.position(range.start + at)))
        {
            let [a, b, c, d] = [0, 1, 2, 3].each(|at| range.start as u32 + at);
            out.extend([[a, b, c], [a, c, d]]);
            return;
        }
        let from = out.len();
        let normal = (!face.tag().cap).then(|| face.normal());
        self.polygon_in_space(face.loop_ranges(), |corner| face.position(corner), normal, out);
        if range.len() > 4 {
            // If loops touch, triangles without area join corners that are the same point.
            let point = |c: u32| mesh.corners[c as usize];
            let mut kept = from;
            for i in from..out.len() {
                let [a, b, c] = out[i].each(point);
                if a != b && b != c && c != a {
                    out[kept] = out[i];
                    kept += 1;
                }
            }
            out.truncate(kept);
        }
    }
}
