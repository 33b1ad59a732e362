//! `offset`: outlines of faces moved in or out.

use crate::env::Env;
use crate::fault::FaultKind;
use crate::mesh::OffsetFaces;
use crate::mesh::offset::{OffsetError, offset as offset_mesh};
use crate::scope::Scope;
use crate::shape::{Geometry, ShapeRef};

/// `offset(distance, all | inside | border)`: each face becomes what is inside its outline moved inwards (a negative
/// distance) or outwards, with mitred corners, and border faces for the difference, one an edge (*offset operation*). The
/// scope is fitted to what there is then, its axes and the pivot stay. Where `inside` finds nothing, because the distance
/// is too large, the geometry stays (*CGA changelog 2022.1*).
///
/// Each face is moved on its own: neighbours that shared an edge no longer do, so what is `inside` and what `border` can be
/// told face by face. Texture coordinates and normals of new corners continue those of the face. The time grows with the
/// square of a face's corners, to a second at most for 5000; of more it is a fault, and the shape stays.
pub fn offset(env: &mut Env, shape: &mut ShapeRef<'_>, distance: f64, keep: OffsetFaces) {
    let distance = env.finite(distance, "the distance of `offset`");
    if distance == 0.0 || !shape.geometry.has_surface() {
        return;
    }
    let before = shape.scope;
    if keep == OffsetFaces::Inside && rectangle(shape, distance) {
        super::settle(env, shape, &before, "`offset`");
        return;
    }
    let mesh = match offset_mesh(&shape.to_mesh(), distance, keep) {
        Ok(mesh) if mesh.is_empty() => return,
        Ok(mesh) => mesh,
        Err(why) => {
            let why = match why {
                OffsetError::NotPlanar => "a face is not planar",
                OffsetError::TooMany => "a face has too many corners",
                OffsetError::Tangled => "the outline of a face touches itself or leads too far",
            };
            env.fault(FaultKind::Geometry, format!("`offset`: {why}; the shape stays as it is"));
            return;
        }
    };
    if env.count_corners(mesh.corners().len() as u64).is_break() {
        return;
    }
    shape.set_mesh(mesh);
}

/// A rectangle stays one: no mesh is needed. Whether that was so, or there is nothing to be done.
fn rectangle(shape: &mut ShapeRef<'_>, distance: f64) -> bool {
    let Geometry::Rect(across, _) = shape.geometry else { return false };
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
    true
}

#[cfg(test)]
mod tests;
