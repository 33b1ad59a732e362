//! Equality of meshes.

use std::sync::Arc;

use super::uv::UvSets;
use super::{FaceTag, Mesh};
use crate::each::Each;

impl PartialEq for Mesh {
    /// Compares points, faces and all attributes, in their order. A mesh that lists the same faces in another order is another mesh.
    /// Tags of faces are compared by their names.
    fn eq(&self, other: &Mesh) -> bool {
        // The trace belongs to the operand that is derived, and derived properties follow from the others.
        let Mesh {
            points,
            corners,
            loop_ends,
            face_ends,
            tags: _,
            uvs,
            normals,
            groups,
            materials,
            tag_sets: _,
            subcomponent_tags,
            bent,
            trace: _,
            derived: _,
        } = self;
        *points == other.points
            && *corners == other.corners
            && *loop_ends == other.loop_ends
            && *face_ends == other.face_ends
            && self.has_same_tags(other)
            && *uvs == other.uvs
            && *normals == other.normals
            && *groups == other.groups
            && *materials == other.materials
            && *subcomponent_tags == other.subcomponent_tags
            && *bent == other.bent
    }
}

impl Mesh {
    /// Returns true if all faces have the same attributes, wherever their tags are in the lists of sets.
    fn has_same_tags(&self, other: &Mesh) -> bool {
        if self.tags == other.tags && self.tag_sets == other.tag_sets {
            return true;
        }
        let (mut own, mut its) = (self.tags.runs().iter().peekable(), other.tags.runs().iter().peekable());
        while let (Some(&&(end, tag)), Some(&&(its_end, its_tag))) = (own.peek(), its.peek()) {
            let [plain, its_plain] = [tag, its_tag].each(|tag| FaceTag { tags: FaceTag::NONE, ..tag });
            if plain != its_plain || self.names_of(tag) != other.names_of(its_tag) {
                return false;
            }
            // Runs end at different faces where equal sets have several numbers.
            if end <= its_end {
                own.next();
            }
            if its_end <= end {
                its.next();
            }
        }
        own.next().is_none() && its.next().is_none()
    }

    /// The names of the tags of a face with these attributes.
    fn names_of(&self, tag: FaceTag) -> &[Arc<str>] {
        self.tag_sets.get(tag.tags as usize).map_or(&[], |set| set.names())
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

    use crate::mesh::{FaceTag, Mesh, MeshBuilder, TagSet};

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

    #[test]
    fn tags_are_equal_by_their_names() {
        let strip = |sets: &[&[&str]], tags: [u32; 2]| {
            let mut builder = MeshBuilder::new();
            let place = |i: u32| [f64::from(i / 2), f64::from(i % 2), 0.0];
            let points: Vec<u32> = (0..6).map(|i| builder.point(place(i))).collect();
            for (at, tags) in [0, 2].into_iter().zip(tags) {
                let ring = [0, 2, 3, 1].map(|i| points[at + i]);
                builder.face(&ring, &[], FaceTag { tags, ..FaceTag::PLAIN });
            }
            let sets: Vec<TagSet> = sets.iter().map(|names| TagSet::new(names.iter().copied())).collect();
            builder.tag_sets(sets);
            builder.build().expect("a strip")
        };
        let mesh = strip(&[&["a"]], [0, 0]);
        assert_eq!(mesh, strip(&[&["b"], &["a"]], [1, 1]));
        // Two numbers of one set.
        assert_eq!(mesh, strip(&[&["a"], &["a"]], [0, 1]));
        assert_eq!(strip(&[&["a"], &["b"]], [0, 1]), strip(&[&["b"], &["a"]], [1, 0]));
        assert_ne!(mesh, strip(&[&["a"], &["b"]], [0, 1]));
        assert_ne!(mesh, strip(&[&["b"]], [0, 0]));
        assert_ne!(mesh, strip(&[&["a"]], [0, FaceTag::NONE]));
    }
}
