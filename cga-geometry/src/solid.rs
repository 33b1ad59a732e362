//! Boxes and rectangles with sides of length 1, as meshes.

use glam::DVec3;

use crate::Axis;
use crate::each::Each;
use crate::mesh::{FaceTag, Mesh};
use crate::provenance::{Provenance, tag_sets};

/// A closed box: front, right, back, left (counter-clockwise as seen from above), top, bottom. Vertices are
/// numbered x + 2y + 4z.
pub fn cuboid() -> Mesh {
    let points = [0, 1, 2, 3, 4, 5, 6, 7].map(corner);
    unit_box(points, [[4, 5, 7, 6], [5, 1, 3, 7], [1, 0, 2, 3], [0, 4, 6, 2], [6, 7, 3, 2], [0, 1, 5, 4]])
}

/// A closed box with the given faces.
pub(crate) fn unit_box(points: [DVec3; 8], faces: [[u32; 4]; 6]) -> Mesh {
    let mut mesh = Mesh { points: points.to_vec(), ..Mesh::default() };
    for face in faces {
        mesh.corners.extend(face);
        mesh.end_loop();
        mesh.end_face(FaceTag::PLAIN);
    }
    mesh.known_closed(true)
}

/// The corner of the unit box with the number x + 2y + 4z.
pub fn corner(number: u8) -> DVec3 {
    DVec3::new(f64::from(number & 1), f64::from(number >> 1 & 1), f64::from(number >> 2 & 1))
}

/// A square at 0 across an axis, with its normal along the axis. Its first edge is the lowest one, or the front one for
/// a square on the ground.
pub fn square(across: Axis, provenance: Provenance) -> Mesh {
    let corners: [u8; 4] = match across {
        Axis::X => [4, 0, 2, 6],
        Axis::Y => [4, 5, 1, 0],
        Axis::Z => [0, 1, 3, 2],
    };
    let sets = if let Provenance::Extruded(_) = provenance { tag_sets() } else { Vec::new() };
    let mut mesh = Mesh { points: corners.each(corner).to_vec(), tag_sets: sets.into(), ..Mesh::default() };
    mesh.corners.extend([0, 1, 2, 3]);
    mesh.end_loop();
    mesh.end_face(provenance.face_tag());
    mesh.known_closed(false)
}
