//! Transformations and reversal of whole meshes.

use std::sync::OnceLock;

use glam::{DAffine3, DMat3, DVec3};

use super::{Derived, FaceTag, Materials, Mesh};
use crate::vector::unit;
use crate::work;

/// The units of work of a corner of a loop that is turned over.
const TURNING: usize = 2;

/// The map of normals that matches the winding: it maps `a × b` to `(m·a) × (m·b)`, also if `m` mirrors. Unlike the
/// inverse it exists for flat maps too.
pub fn normal_map(m: &DMat3) -> DMat3 {
    DMat3::from_cols(m.y_axis.cross(m.z_axis), m.z_axis.cross(m.x_axis), m.x_axis.cross(m.y_axis))
}

impl Mesh {
    /// The mesh transformed by a map. The order of corners stays, so a mirroring map turns the faces and the corner
    /// normals inside out.
    ///
    /// A map with numbers that are not finite, or that are so large that coordinates overflow, gives points that are not finite.
    pub fn map(&self, map: &DAffine3) -> Mesh {
        let normal_map = normal_map(&map.matrix3);
        Mesh {
            points: self.points.iter().map(|&p| map.transform_point3(p)).collect(),
            normals: self.normals.iter().map(|&n| unit(normal_map * n)).collect(),
            bent: map.matrix3 * self.bent,
            derived: self.derived.of_moved(),
            ..self.clone_structure()
        }
    }

    /// The same as [`Mesh::map`], in place.
    pub fn into_mapped(mut self, map: &DAffine3) -> Mesh {
        let normal_map = normal_map(&map.matrix3);
        self.points.iter_mut().for_each(|point| *point = map.transform_point3(*point));
        self.normals.iter_mut().for_each(|normal| *normal = unit(normal_map * *normal));
        self.bent = map.matrix3 * self.bent;
        self.derived.forget_moved();
        self
    }

    /// The mesh rotated so that its z axis points up and its y axis to the back.
    pub fn raised(&self) -> Mesh {
        self.map(&DAffine3 { matrix3: DMat3::from_cols(DVec3::X, DVec3::NEG_Z, DVec3::Y), translation: DVec3::ZERO })
    }

    /// The same faces with other points, one for each. The values of corners do not change, and a closed mesh stays
    /// closed.
    ///
    /// The caller keeps faces planar and coordinates finite; [`Mesh::check`] lists what is not.
    ///
    /// # Panics
    /// Panics if the number of points differs.
    pub fn with_points(&self, points: Vec<DVec3>) -> Mesh {
        assert_eq!(points.len(), self.points.len(), "one position for each point of the mesh");
        Mesh { points, normals: self.normals.clone(), derived: self.derived.of_moved(), ..self.clone_structure() }
    }

    /// The mesh with every face reversed. The first edge stays: its two corners are swapped and come first again. The mesh is empty if
    /// the work of a [`Supervisor`](crate::work::Supervisor) ends meanwhile.
    pub fn reversed(&self) -> Mesh {
        let turned = self.turned(|_| true);
        // A mesh that was ended early has other properties.
        if turned.is_empty() {
            return turned;
        }
        Mesh { derived: Derived { adjacency: OnceLock::new(), ..self.derived.clone() }, ..turned }
    }

    /// The mesh with some faces reversed in that way. `is_turned` is called with the number of each face. The mesh is empty if the work
    /// of a [`Supervisor`](crate::work::Supervisor) ends meanwhile.
    pub fn turned(&self, is_turned: impl Fn(usize) -> bool) -> Mesh {
        let bounds = self.derived.bounds.clone();
        let mut mesh = Mesh { derived: Derived { bounds, ..Derived::default() }, ..self.clone() };
        let rings = self.faces().filter(|face| is_turned(face.index())).flat_map(|face| face.loop_ranges());
        for ring in rings {
            if !work::spend(TURNING * ring.len()) {
                return Mesh::default();
            }
            flip(&mut mesh.corners[ring.clone()]);
            mesh.uvs.change(ring.clone(), flip);
            if !mesh.normals.is_empty() {
                flip(&mut mesh.normals[ring.clone()]);
                mesh.normals[ring].iter_mut().for_each(|n| *n = -*n);
            }
        }
        mesh
    }

    /// The mesh without materials.
    pub fn without_materials(&self) -> Mesh {
        self.with_materials(Materials::default(), |_| FaceTag::NONE)
    }

    /// A copy without points, normals and derived properties.
    fn clone_structure(&self) -> Mesh {
        Mesh {
            corners: self.corners.clone(),
            loop_ends: self.loop_ends.clone(),
            face_ends: self.face_ends.clone(),
            tags: self.tags.clone(),
            uvs: self.uvs.clone(),
            subcomponent_tags: self.subcomponent_tags.clone(),
            trace: self.trace.clone(),
            ..self.alike(0)
        }
    }
}

/// Reverses a ring and keeps its first edge: 0 1 2 3 becomes 1 0 3 2.
pub fn flip<T>(ring: &mut [T]) {
    ring.reverse();
    ring.rotate_right(2.min(ring.len()));
}

#[cfg(test)]
mod tests {
    use super::flip;

    #[test]
    fn a_flipped_loop_starts_with_the_same_edge() {
        let mut ring = [0, 1, 2, 3, 4];
        flip(&mut ring);
        assert_eq!(ring, [1, 0, 4, 3, 2]);
        let mut triangle = [0, 1, 2];
        flip(&mut triangle);
        assert_eq!(triangle, [1, 0, 2]);
    }
}
