//! `offset`: moves the outlines of faces inwards or outwards.

use crate::fault::FaultKind;
use crate::geometry::offset::OffsetFaces;
use crate::geometry::offset::{OffsetError, offset as offset_mesh};
use crate::run::env::Env;
use crate::shape::body::Body;
use crate::shape::scope::Scope;
use crate::shape::unit::UnitMesh;
use crate::shape::{Geometry, Shape};

/// `offset(distance)`: replaces each face by the inside of its outline, moved inwards (a
/// negative distance) or outwards with mitred corners, and by border faces for the difference, one for each edge
/// (*offset operation*). The scope is fitted to the result; its axes and the pivot stay. If `inside` leaves nothing,
/// because the distance is too large, the geometry stays (*CGA changelog 2022.1*).
///
/// Each face is moved separately. Neighbours no longer share an edge, so `inside` and `border` are defined face by
/// face. Texture coordinates and normals of new corners continue the values of the face. A face that is not planar is
/// moved across its normal and keeps its bend: its corners keep their places, and new points are as high above its
/// plane as its edges beside them.
///
/// A face that cannot be moved stays, with a fault that names it: a face without a normal, one that touches itself,
/// one with more than 5000 corners. The time grows with the square of a face's corners, to a second at most for 5000.
pub fn offset(env: &mut Env, shape: &mut Shape, distance: f64) {
    apply(env, shape, distance, OffsetFaces::All);
}

/// `offset(distance, all | inside | border)`: [`offset`] that keeps some faces. The shape before it occludes (*offset operation*).
pub fn offset_selected(env: &mut Env, shape: &mut Shape, distance: f64, keep: OffsetFaces) {
    env.collect_divided(|| Body::from(&*shape));
    apply(env, shape, distance, keep);
}

fn apply(env: &mut Env, shape: &mut Shape, distance: f64, keep: OffsetFaces) {
    let distance = env.finite(distance, "the distance of `offset`");
    if distance == 0.0 || !shape.geometry.has_surface() {
        return;
    }
    let before = shape.scope;
    if keep == OffsetFaces::Inside && rectangle(shape, distance) {
        crate::op::settle(env, shape, &before, "`offset`");
        return;
    }
    let (mesh, refused) = offset_mesh(&shape.to_mesh(), distance, keep);
    report(env, &refused);
    if mesh.face_count() == refused.len() {
        return;
    }
    if env.count_corners(mesh.corners().len() as u64).is_break() {
        return;
    }
    shape.set_mesh(mesh);
}

/// Reports the faces that stay, and the reasons.
fn report(env: &mut Env, refused: &[(usize, OffsetError)]) {
    /// The number of faces that are named.
    const NAMED: usize = 8;
    for (why, one, more) in [
        (OffsetError::NoNormal, "has no normal", "have no normal"),
        (OffsetError::TooMany, "has too many corners", "have too many corners"),
        (OffsetError::Tangled, "touches itself or leads too far", "touch themselves or lead too far"),
    ] {
        let faces: Vec<String> =
            refused.iter().filter(|refused| refused.1 == why).map(|refused| refused.0.to_string()).collect();
        let message = match &faces[..] {
            [] => continue,
            [face] => format!("`offset`: face {face} {one}; it stays as it is"),
            [first @ .., last] if first.len() < NAMED => {
                format!("`offset`: faces {} and {last} {more}; they stay as they are", first.join(", "))
            }
            _ => {
                let (named, others) = faces.split_at(NAMED);
                let count = others.len();
                format!("`offset`: faces {} and {count} more {more}; they stay as they are", named.join(", "))
            }
        };
        env.fault(FaultKind::Geometry, message);
    }
}

/// Offsets a rectangle that stays a rectangle, without a mesh. Returns true if it did, or if nothing is to be done.
fn rectangle(shape: &mut Shape, distance: f64) -> bool {
    let Geometry::Rect(across, unit) = shape.geometry else { return false };
    let mut to = Scope { ..shape.scope };
    for axis in (0..3).filter(|&axis| axis != across.index()) {
        if shape.scope.size[axis] <= 0.0 {
            return false;
        }
        to.origin -= to.axes.col(axis) * distance;
        to.size[axis] += 2.0 * distance;
        if to.size[axis] <= 0.0 {
            return true;
        }
    }
    to.size[across.index()] = 0.0;
    shape.scope = to;
    // The corners are new and in order.
    shape.geometry = Geometry::Rect(across, UnitMesh::face(across, unit.sides()[0].provenance));
    true
}

#[cfg(test)]
mod tests;
