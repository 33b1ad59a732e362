//! The construction of a mesh corner by corner, for code that keeps the invariants itself.

use std::ops::Range;

use glam::DVec3;

use super::{FaceTag, Mesh};

impl Mesh {
    /// Adds a point and returns its number.
    #[inline]
    pub(crate) fn add_point(&mut self, point: DVec3) -> u32 {
        self.points.push(point);
        self.points.len() as u32 - 1
    }

    /// Adds the values of corners of another mesh, which has the same texture sets.
    #[inline(always)]
    pub(crate) fn add_values(&mut self, source: &Mesh, corners: Range<usize>) {
        self.uvs.copy_from(&source.uvs, corners.clone());
        if !source.normals.is_empty() {
            self.normals.extend_from_slice(&source.normals[corners]);
        }
    }

    /// Ends a loop with the last corner that was added.
    #[inline]
    pub(crate) fn end_loop(&mut self) {
        self.loop_ends.push(self.corners.len() as u32);
    }

    /// Ends a face with the last loop that was ended.
    #[inline]
    pub(crate) fn end_face(&mut self, tag: FaceTag) {
        self.face_ends.push(self.loop_ends.len());
        self.tags.push(tag);
    }

    /// Ends a face whose corners come from the given loops of another mesh: adds the loops and the values of corners.
    #[inline(always)]
    pub(crate) fn end_copy(&mut self, source: &Mesh, loops: Range<usize>, tag: FaceTag) {
        let corners = source.corners_of(&loops);
        let (from, to) = (corners.end as u32, self.corners.len() as u32);
        self.loop_ends.extend(source.loop_ends[loops].iter().map(|end| to + end - from));
        self.end_face(tag);
        self.add_values(source, corners);
    }
}
