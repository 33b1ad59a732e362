//! The coordinate system of a face: the origin at the first vertex of the
//! first edge, x along that edge, z along the face normal, and y across both.

use glam::{DMat3, DVec2, DVec3};

use crate::Frame;
use crate::mesh::{FaceRef, Mesh, unit};
use crate::tol::{ANGLE_EPSILON, COPLANAR_EPSILON};

/// The coordinate system of a face, and its bounding box in it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct FaceFrame {
    /// The origin is the start of the first edge with a length, x is along that edge, and z points outwards.
    pub frame: Frame,
    /// The smallest coordinates of the face in the frame.
    pub low: DVec2,
    /// The largest coordinates.
    pub high: DVec2,
    /// True if the face equals its box: four corners from (0, 0) on, right angles, no holes.
    pub rectangle: bool,
}

/// The frame of a face; `None` for a face without area.
///
/// # Panics
/// Panics if the face does not exist.
pub fn face_frame(mesh: &Mesh, face: usize) -> Option<FaceFrame> {
    face_frame_along(mesh, face, mesh.face(face).normal())
}

/// The same for a face whose [normal](FaceRef::normal) is known.
///
/// # Panics
/// Panics if the face does not exist.
pub fn face_frame_along(mesh: &Mesh, face: usize, z: DVec3) -> Option<FaceFrame> {
    let face = mesh.face(face);
    let outer = face.outer();
    let at = |i: usize| mesh.points()[outer[i % outer.len()] as usize];
    if z == DVec3::ZERO {
        return None;
    }
    let (first, along) = (0..outer.len()).map(|i| (i, at(i + 1) - at(i))).find(|(_, edge)| *edge != DVec3::ZERO)?;
    // The edge is in the face except for rounding. Its component along the normal is removed, so that the axes are
    // orthonormal.
    let along = unit(along);
    let x = unit(along - z * along.dot(z));
    if x == DVec3::ZERO {
        return None;
    }
    let y = z.cross(x);
    let frame = Frame { origin: at(first), axes: DMat3::from_cols(x, y, z) };
    let (mut low, mut high) = (DVec2::ZERO, DVec2::ZERO);
    for &c in outer {
        let p = frame.to_local(mesh.points()[c as usize]).truncate();
        (low, high) = (low.min(p), high.max(p));
    }
    let size = high - low;
    let rectangle = first == 0 && is_rectangle(&face, &frame, size);
    if rectangle {
        // Coordinates below zero are rounding errors.
        low = DVec2::ZERO;
        high = size;
    }
    Some(FaceFrame { frame, low, high, rectangle })
}

/// Object coordinates: the frame of the first face with an area, with x along its first edge with a length and y along
/// its normal. `None` for a mesh without such a face.
pub fn object_of(mesh: &Mesh) -> Option<Frame> {
    (0..mesh.face_count()).find_map(|face| face_frame(mesh, face)).map(|found| object(&found))
}

/// Object coordinates from the frame of a face, with y outwards.
pub fn object(found: &FaceFrame) -> Frame {
    let [x, out] = [found.frame.axes.x_axis, found.frame.axes.z_axis];
    // If the first edge is not exactly in the plane of its face, the two are not exactly perpendicular.
    let y = unit(out - x * out.dot(x));
    Frame { origin: found.frame.origin, axes: DMat3::from_cols(x, y, x.cross(y)) }
}

/// The most upright direction perpendicular to `x`.
pub fn upright(x: DVec3) -> DVec3 {
    across(x, DVec3::Y, DVec3::Z)
}

/// The direction perpendicular to an axis that is closest to `wanted`, or to `otherwise` if `wanted` is along the axis.
fn across(axis: DVec3, wanted: DVec3, otherwise: DVec3) -> DVec3 {
    let closest = |to: DVec3| unit(to - axis * axis.dot(to));
    let found = closest(wanted);
    let is_along = 1.0 - axis.dot(wanted).abs() < ANGLE_EPSILON || found == DVec3::ZERO;
    if is_along { closest(otherwise) } else { found }
}

/// Axes with the given x, and with z as close as possible to the direction `looks`.
pub fn along(x: DVec3, looks: DVec3) -> DMat3 {
    // `looks` may be a mean that is not perpendicular to the edge. A very short perpendicular part is a rounding error.
    let across = looks - x * looks.dot(x);
    let z = if across.length() <= COPLANAR_EPSILON { upright(x) } else { unit(across) };
    let z = unit(z - x * z.dot(x));
    DMat3::from_cols(x, z.cross(x), z)
}

/// The x axis for a given z axis: as close as possible to the x axis of the shape, so that it rotates with the shape.
pub fn beside(z: DVec3) -> DVec3 {
    across(z, DVec3::X, DVec3::NEG_Z)
}

fn is_rectangle(face: &FaceRef<'_>, frame: &Frame, size: DVec2) -> bool {
    let range = face.corner_range();
    if range.len() != 4 {
        return false;
    }
    let near = ANGLE_EPSILON * size.max_element();
    let expected = [DVec2::ZERO, DVec2::new(size.x, 0.0), size, DVec2::new(0.0, size.y)];
    range.zip(expected).all(|(corner, expected)| {
        let p = frame.to_local(face.position(corner));
        (p.truncate() - expected).abs().max_element() <= near && p.z.abs() <= near
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::primitive::cube;

    #[test]
    fn a_wall_has_x_along_its_first_edge_and_z_outwards() {
        let mesh = cube();
        for face in 0..6 {
            let found = face_frame(&mesh, face).unwrap();
            assert!(found.rectangle);
            assert_eq!((found.low, found.high), (DVec2::ZERO, DVec2::ONE));
            assert_eq!(found.frame.axes.z_axis, mesh.face(face).normal());
            assert_eq!(found.frame.origin, mesh.points()[mesh.face(face).outer()[0] as usize]);
        }
        assert_eq!(face_frame(&mesh, 2).unwrap().frame.axes.y_axis, DVec3::Y);
    }

    #[test]
    fn a_face_may_reach_below_its_origin() {
        let points = [(1.0, 0.0), (2.0, 0.0), (2.0, 2.0), (0.0, 2.0)].map(|(x, y)| DVec3::new(x, y, 0.0));
        let found = face_frame(&Mesh::from_polygon(&points, &[]).unwrap(), 0).unwrap();
        assert!(!found.rectangle);
        assert_eq!(found.low, DVec2::new(-1.0, 0.0));
        assert_eq!(found.high, DVec2::new(1.0, 2.0));
    }
}
