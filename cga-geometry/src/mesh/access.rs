//! The parts of a mesh, for code outside of geometry.

use std::sync::{Arc, OnceLock};

use glam::DVec3;

use super::{FaceTag, Materials, Mesh, SubcomponentTags};
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

    /// Sets the origins of points.
    pub fn set_trace(&mut self, trace: Trace) {
        self.trace = trace;
    }

    /// Changes the origins of points.
    pub fn change_trace(&mut self, change: impl FnOnce(&mut Trace)) {
        change(&mut self.trace);
    }

    /// Returns true if corners have texture coordinates or normals.
    #[inline]
    pub fn has_corner_values(&self) -> bool {
        !self.uvs.is_empty() || !self.normals.is_empty()
    }

    /// The mesh without normals at its corners.
    pub fn without_normals(&self) -> Mesh {
        Mesh { normals: Vec::new(), ..self.clone() }
    }

    /// The attributes of faces, once for each run of faces with the same ones.
    pub fn face_attributes(&self) -> impl Iterator<Item = FaceTag> + '_ {
        self.tags.runs().iter().map(|(_, tag)| *tag)
    }

    /// The mesh with all faces in one group.
    pub fn in_group(self, name: &str) -> Mesh {
        let tags = self.tags.mapped(|tag| FaceTag { group: 0, ..tag });
        Mesh { groups: Arc::new([name.to_owned()]), tags, ..self }
    }

    /// The materials as a list that others may keep.
    #[inline]
    pub fn material_list(&self) -> &Materials {
        &self.materials
    }

    /// The mesh with other materials; `number` gives the new number of each old one, [`FaceTag::NONE`] included.
    pub fn with_materials(&self, materials: impl Into<Materials>, number: impl Fn(u32) -> u32) -> Mesh {
        let tags = self.tags.mapped(|tag| FaceTag { material: number(tag.material), ..tag });
        Mesh { tags, materials: materials.into(), ..self.clone() }
    }

    /// Changes the points.
    #[inline]
    pub fn change_points(&mut self, change: impl FnMut(&mut DVec3)) {
        self.derived.bounds = OnceLock::new();
        self.points.iter_mut().for_each(change);
    }

    /// The mesh with other points, and with corners at other ones of them.
    pub fn with_corners_at(&self, points: Vec<DVec3>, corners: Vec<u32>) -> Mesh {
        Mesh { corners, ..self.with_points(points) }.checked()
    }
}
