//! The parts of a mesh, for code outside of geometry.

use glam::DVec3;

use super::{Derived, FaceTag, Materials, Mesh, SubcomponentTags};
use crate::trace::Trace;

impl Mesh {
    /// The tags of edges and vertices.
    #[inline]
    pub fn subcomponent_tags(&self) -> &SubcomponentTags {
        &self.subcomponent_tags
    }

    /// The origins of points, in operands.
    #[inline]
    pub fn trace(&self) -> &Trace {
        &self.trace
    }

    /// Sets the origins of points. Each layer has one origin for each point, in the order of [`Mesh::points`]. Points that a
    /// shorter layer lacks count as points without an origin, and further origins are ignored.
    pub fn set_trace(&mut self, trace: Trace) {
        self.derived.forget_variants();
        self.trace = trace;
    }

    /// Changes the origins of points; see [`Mesh::set_trace`].
    pub fn change_trace(&mut self, change: impl FnOnce(&mut Trace)) {
        self.derived.forget_variants();
        change(&mut self.trace);
    }

    /// Returns true if corners have texture coordinates or normals.
    #[inline]
    pub fn has_corner_values(&self) -> bool {
        !self.uvs.is_empty() || !self.normals.is_empty()
    }

    /// The mesh without normals at its corners, so that the normals of faces count.
    pub fn without_normals(&self) -> Mesh {
        Mesh { normals: Vec::new(), ..self.clone() }
    }

    /// The attributes of faces, once for each run of faces with the same ones.
    pub fn face_attributes(&self) -> impl Iterator<Item = FaceTag> + '_ {
        self.tags.runs().iter().map(|(_, tag)| *tag)
    }

    /// The mesh with all faces in one group. Its other groups are dropped.
    pub fn in_group(self, name: &str) -> Mesh {
        let tags = self.tags.mapped(|tag| FaceTag { group: 0, ..tag });
        Mesh { groups: vec![name.to_owned()].into(), tags, derived: self.derived.of_changed(), ..self }
    }

    /// The materials as a list that others may keep.
    #[inline]
    pub fn material_list(&self) -> &Materials {
        &self.materials
    }

    /// The mesh with other materials; `number` gives the new number of each old one, [`FaceTag::NONE`] included. A number that
    /// the new list does not have becomes [`FaceTag::NONE`].
    pub fn with_materials(&self, materials: impl Into<Materials>, number: impl Fn(u32) -> u32) -> Mesh {
        let materials = materials.into();
        let known = |number: u32| if (number as usize) < materials.len() { number } else { FaceTag::NONE };
        let tags = self.tags.mapped(|tag| FaceTag { material: known(number(tag.material)), ..tag });
        Mesh { tags, materials, ..self.clone() }
    }

    /// Changes the positions of all points, in their order. Values of corners stay.
    ///
    /// The caller keeps faces planar and coordinates finite; [`Mesh::check`] lists what is not.
    #[inline]
    pub fn change_points(&mut self, change: impl FnMut(&mut DVec3)) {
        self.derived.forget_moved();
        self.points.iter_mut().for_each(change);
    }

    /// The mesh with other points, and with its corners at other ones of them: `points` has one position for each point, and
    /// `corners` one index of a point for each corner. Faces and the values of corners stay. The caller uses every point, and no
    /// point twice in a row in a loop.
    ///
    /// # Panics
    /// Panics if the number of points or corners differs, or if a corner has an index out of range.
    pub fn with_corners_at(&self, points: Vec<DVec3>, corners: Vec<u32>) -> Mesh {
        assert_eq!(corners.len(), self.corners.len(), "one index for each corner of the mesh");
        let count = points.len();
        assert!(corners.iter().all(|&corner| (corner as usize) < count), "a corner has no point among {count} points");
        let moved = self.with_points(points);
        // Other corners have other edges.
        let derived = if corners == self.corners { moved.derived.clone() } else { Derived::default() };
        Mesh { corners, derived, ..moved }.checked()
    }
}
