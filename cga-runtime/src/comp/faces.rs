//! The faces that an operation makes of a shape, and the shapes of them.

use super::Mode;
use crate::geometry::Frame;
use crate::geometry::buckets::Buckets;
use crate::geometry::extract::extract;
use crate::geometry::mesh::Mesh;
use crate::shape::Shape;
use crate::shape::seed::Seed;

/// The faces that an operation makes, in the scope of the shape that it divides.
#[derive(Debug, Default)]
pub struct Faces {
    /// All faces.
    pub mesh: Mesh,
    /// The arm of each face, by number. Faces without an arm are dropped.
    pub arms: Vec<Option<u32>>,
}

impl Faces {
    /// The numbers of the faces of each arm, for a number of arms.
    pub(super) fn by_arm(&self, count: usize) -> Buckets {
        debug_assert_eq!(self.arms.len(), self.mesh.face_count());
        // Faces without an arm have the number after the last one.
        Buckets::by(count + 1, self.arms.iter().map(|arm| arm.unwrap_or(count as u32)))
    }

    /// The shape of some faces, which were made of the shape `whole`.
    pub(super) fn shape(&self, whole: &Shape, faces: &[u32], seed: Seed) -> Shape {
        let mut part = whole.clone();
        part.seed = seed;
        part.set_mesh(extract(&self.mesh, faces, &Frame::WORLD));
        part
    }
}

/// The faces of each shape that an arm makes.
pub(super) fn by_shape(faces: &[u32], mode: Mode) -> impl Iterator<Item = &[u32]> {
    faces.chunks(if mode == Mode::Each { 1 } else { faces.len().max(1) })
}
