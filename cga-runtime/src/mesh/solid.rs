//! Rectangles and boxes as meshes.

use super::{Derived, FaceEnds, FaceTag, Mesh, Tags};
use crate::side::{Extruded, Sides, tag_sets};
use crate::sink::{Cuboid, Quad};

/// Points of a box are numbered x + 2y + 4z; faces as [`Cuboid::faces`] has them, corners as [`Quad::corners`].
const CUBOID_CORNERS: [u32; 24] = [
    4, 5, 7, 6, // front
    5, 1, 3, 7, // right
    1, 0, 2, 3, // back
    0, 4, 6, 2, // left
    6, 7, 3, 2, // top
    0, 1, 5, 4, // bottom
];

impl Mesh {
    /// A rectangle as a mesh of one face.
    pub fn from_quad(quad: &Quad) -> Mesh {
        let derived = Derived::default();
        let _ = derived.closed.set(false);
        Mesh {
            points: quad.corners().to_vec(),
            corners: vec![0, 1, 2, 3],
            loop_ends: vec![4],
            face_ends: FaceEnds::single(1),
            tags: Tags::uniform(1, FaceTag::PLAIN),
            derived,
            ..Mesh::default()
        }
    }

    /// A rectangle with the tag of the side that it was.
    pub(crate) fn with_side(mut self, side: Option<Extruded>) -> Mesh {
        if let Some(tag) = side {
            self.tag_sets = tag_sets().into();
            self.tags = Tags::uniform(1, FaceTag { tags: tag as u32, ..FaceTag::PLAIN });
        }
        self
    }

    /// A box with the tags of its sides, in the order of its faces.
    pub(crate) fn with_sides(mut self, sides: Sides) -> Mesh {
        if !sides.is_plain() {
            let order = [0, 1, 2, 3, 4, 5].map(|face| sides.side_of(face));
            self.corners = order.iter().flat_map(|side| &CUBOID_CORNERS[4 * side..4 * side + 4]).copied().collect();
            self.tag_sets = tag_sets().into();
            self.tags = Tags::default();
            for side in order {
                let tags = sides.tag(side).map_or(FaceTag::NONE, |tag| tag as u32);
                self.tags.push(FaceTag { tags, ..FaceTag::PLAIN });
            }
        }
        self
    }

    /// A box as a closed mesh of eight points and six faces.
    pub fn from_cuboid(cuboid: &Cuboid) -> Mesh {
        let [x, y, z] = [cuboid.sides.x_axis, cuboid.sides.y_axis, cuboid.sides.z_axis];
        let pick = |i: u32, bit: u32| f64::from(i >> bit & 1);
        let derived = Derived::default();
        let _ = derived.closed.set(true);
        Mesh {
            points: (0..8).map(|i| cuboid.origin + x * pick(i, 0) + y * pick(i, 1) + z * pick(i, 2)).collect(),
            corners: CUBOID_CORNERS.to_vec(),
            loop_ends: (1..=6).map(|i| 4 * i).collect(),
            face_ends: FaceEnds::single(6),
            tags: Tags::uniform(6, FaceTag::PLAIN),
            derived,
            ..Mesh::default()
        }
    }
}
