//! The construction of a mesh corner by corner, for code that keeps the invariants itself.

use crate::value::each::Each;
use std::ops::Range;

use glam::DVec3;

use super::{FaceRef, FaceTag, Mesh, SubcomponentTagger};

impl Mesh {
    /// Adds a point and returns its number.
    #[inline]
    pub(crate) fn add_point(&mut self, point: DVec3) -> u32 {
        self.points.push(point);
        self.points.len() as u32 - 1
    }

    /// Adds the values of corners of another mesh, which has the same texture sets.
    #[inline(always)]
    pub(crate) fn copy_values(&mut self, source: &Mesh, corners: Range<usize>) {
        self.uvs.copy_from(&source.uvs, corners.clone());
        if !source.normals.is_empty() {
            self.normals.extend_from_slice(&source.normals[corners]);
        }
    }

    /// The points and corners of this mesh, without loops and faces.
    pub(crate) fn corner_pool(&self) -> Mesh {
        Mesh {
            points: self.points.clone(),
            corners: self.corners.clone(),
            uvs: self.uvs.clone(),
            normals: self.normals.clone(),
            trace: self.trace.clone(),
            ..Mesh::default()
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
        self.copy_values(source, corners);
    }

    /// Adds a copy of a face of another mesh, with another tag and with the tags of its edges and vertices, as in
    /// [`Mesh::add_copy`].
    pub(crate) fn add_tagged_copy(&mut self, face: &FaceRef<'_>, tag: FaceTag, tagger: &mut SubcomponentTagger) {
        let first = self.corners.len();
        self.add_copy(face, tag);
        if face.mesh.subcomponent_tags.is_empty() {
            return;
        }
        let number = |corner: usize| self.corners[first + corner - face.corner_range().start];
        for edge in face.edges() {
            let ends = edge.each(|corner| face.mesh.corners[corner]);
            if let Some(set) = face.mesh.edge_tags(ends) {
                tagger.edge(edge.each(number), set);
            }
            if let Some(set) = face.mesh.vertex_tags(ends[0]) {
                tagger.vertex(number(edge[0]), set);
            }
        }
    }

    /// Adds a copy of a face of another mesh, with another tag and without the tags of edges and vertices. The copy has points
    /// of its own.
    pub(crate) fn add_copy(&mut self, face: &FaceRef<'_>, tag: FaceTag) {
        let mut numbers = std::collections::BTreeMap::new();
        for corner in face.corner_range() {
            let point = face.mesh.corners[corner];
            let number = *numbers.entry(point).or_insert_with(|| self.add_point(face.mesh.points[point as usize]));
            self.corners.push(number);
        }
        self.end_copy(face.mesh, face.mesh.face_loops(face.index), tag);
    }
}
