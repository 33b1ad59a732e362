//! The coordinate system of a face: the origin at the first vertex of the
//! first edge, x along that edge, z along the face normal, and y across both.

use glam::{DMat3, DVec2, DVec3};

use crate::Frame;
use crate::each::Each;
use crate::mesh::{Mesh, unit};
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

/// The same for a face whose [normal](crate::mesh::FaceRef::normal) is known.
///
/// # Panics
/// Panics if the face does not exist.
pub fn face_frame_along(mesh: &Mesh, face: usize, z: DVec3) -> Option<FaceFrame> {
    let axes = face_axes(mesh, face, z)?;
    let outer = mesh.face(face).outer();
    if let Some(size) = axes.rectangle(mesh, face) {
        return Some(FaceFrame { frame: axes.frame, low: DVec2::ZERO, high: size, rectangle: true });
    }
    let [low, high] = spread(outer.iter().map(|&point| axes.frame.to_local(mesh.points()[point as usize])));
    Some(FaceFrame { frame: axes.frame, low, high, rectangle: false })
}

/// The coordinate system of a face, without its bounding box.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct FaceAxes {
    /// The origin is the start of the first edge with a length, x is along that edge, and z points outwards.
    pub frame: Frame,
    /// True for four corners without a hole of which the first two are at different places.
    may_be_box: bool,
}

/// The coordinate system of a face whose [normal](crate::mesh::FaceRef::normal) is known; `None` for a face without area.
///
/// # Panics
/// Panics if the face does not exist.
#[inline(always)]
pub fn face_axes(mesh: &Mesh, face: usize, z: DVec3) -> Option<FaceAxes> {
    let loops = mesh.face_loops(face);
    let outer = &mesh.corners[mesh.loop_range(loops.start)];
    if z == DVec3::ZERO {
        return None;
    }
    let at = |point: u32| mesh.points()[point as usize];
    let (mut first, mut start) = (0, at(outer[0]));
    let along = loop {
        let next = first + 1;
        let end = at(outer[if next == outer.len() { 0 } else { next }]);
        let edge = end - start;
        if edge != DVec3::ZERO {
            break edge;
        }
        if next == outer.len() {
            return None;
        }
        (first, start) = (next, end);
    };
    // The edge is in the face except for rounding. Its component along the normal is removed, so that the axes are
    // orthonormal.
    let along = unit(along);
    let x = unit(along - z * along.dot(z));
    if x == DVec3::ZERO {
        return None;
    }
    let frame = Frame { origin: start, axes: DMat3::from_cols(x, z.cross(x), z) };
    Some(FaceAxes { frame, may_be_box: first == 0 && outer.len() == 4 && loops.len() == 1 })
}

impl FaceAxes {
    /// The size of a face that equals its box: four corners from (0, 0) on, right angles, no holes. `None` for other faces.
    ///
    /// # Panics
    /// Panics if the face does not exist.
    #[inline]
    pub fn rectangle(&self, mesh: &Mesh, face: usize) -> Option<DVec2> {
        if !self.may_be_box {
            return None;
        }
        let [a, b, c, d] = mesh.corners[mesh.face_corners(face)] else { return None };
        let corners = [a, b, c, d].each(|point| mesh.points()[point as usize]);
        if is_far_from_parallelogram(&corners) {
            return None;
        }
        let corners = corners.each(|corner| self.frame.to_local(corner));
        let [low, high] = spread(corners.into_iter());
        // Coordinates below zero are rounding errors.
        let size = high - low;
        let near = ANGLE_EPSILON * size.max_element();
        let expected = [DVec2::ZERO, DVec2::new(size.x, 0.0), size, DVec2::new(0.0, size.y)];
        let is_near = |(point, expected): (DVec3, DVec2)| {
            (point.truncate() - expected).abs().max_element() <= near && point.z.abs() <= near
        };
        corners.into_iter().zip(expected).all(is_near).then_some(size)
    }
}

/// Returns true if four corners differ from a parallelogram by far more than the tolerance for rectangles.
#[inline]
fn is_far_from_parallelogram([a, b, c, d]: &[DVec3; 4]) -> bool {
    let open = (*a - *b) + (*c - *d);
    1e-6 * (*a - *c).length_squared() < open.length_squared()
}

/// The smallest and the largest coordinates of points and of the origin.
fn spread(points: impl Iterator<Item = DVec3>) -> [DVec2; 2] {
    points.map(DVec3::truncate).fold([DVec2::ZERO; 2], |[low, high], point| [low.min(point), high.max(point)])
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
