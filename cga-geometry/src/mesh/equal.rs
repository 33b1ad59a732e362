//! Equality of meshes.

use super::Mesh;
use super::uv::UvSets;

impl PartialEq for Mesh {
    /// Compares points, faces and all attributes, in their order. A mesh that lists the same faces in another order is another mesh.
    fn eq(&self, other: &Mesh) -> bool {
        // The trace belongs to the operand that is derived, and derived properties follow from the others.
        let Mesh {
            points,
            corners,
            loop_ends,
            face_ends,
            tags,
            uvs,
            normals,
            groups,
            materials,
            tag_sets,
            subcomponent_tags,
            bent,
            trace: _,
            derived: _,
        } = self;
        *points == other.points
            && *corners == other.corners
            && *loop_ends == other.loop_ends
            && *face_ends == other.face_ends
            && *tags == other.tags
            && *uvs == other.uvs
            && *normals == other.normals
            && *groups == other.groups
            && *materials == other.materials
            && *tag_sets == other.tag_sets
            && *subcomponent_tags == other.subcomponent_tags
            && *bent == other.bent
    }
}

impl PartialEq for UvSets {
    /// Sets without coordinates are equal to sets that are not listed.
    fn eq(&self, other: &UvSets) -> bool {
        (0..UvSets::MOST).all(|set| self.get(set) == other.get(set))
    }
}

#[cfg(test)]
mod tests {
    use glam::DVec2;

    use crate::mesh::{FaceTag, Mesh, MeshBuilder};

    fn square(tag: FaceTag, turned: u32) -> Mesh {
        let mut builder = MeshBuilder::new();
        let points = [[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [1.0, 1.0, 0.0], [0.0, 1.0, 0.0]];
        let mut ring = points.map(|point| builder.point(point));
        ring.rotate_left(turned as usize);
        builder.face(&ring, &[], tag);
        builder.groups(["wall", "roof"].map(String::from));
        builder.build().expect("a square")
    }

    #[test]
    fn meshes_are_equal_if_all_that_they_store_is() {
        let (mesh, tag) = (square(FaceTag::PLAIN, 0), FaceTag { group: 1, ..FaceTag::PLAIN });
        // Values that are computed on demand are not compared.
        assert!(!mesh.is_closed());
        assert_eq!(mesh, square(FaceTag::PLAIN, 0));
        assert_ne!(mesh, square(tag, 0));
        assert_ne!(mesh, square(FaceTag::PLAIN, 1));
        assert_ne!(mesh, Mesh::default());
        let mapped = mesh.with_uv_set(3, vec![DVec2::ONE; 4]);
        assert_ne!(mesh, mapped);
        assert_eq!(mesh, mapped.with_uv_set(3, Vec::new()));
    }
}
