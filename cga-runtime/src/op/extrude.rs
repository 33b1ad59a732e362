//! `extrude`: faces become volumes.

use std::sync::Arc;

use glam::{DAffine3, DMat3, DVec3};

use super::Length;
use super::insert::raise;
use crate::env::Env;
use crate::mesh::extrude::{Extrude, extrude as extrude_mesh};
use crate::scope::{Axis, Scope};
use crate::shape::{Geometry, Placed, ShapeRef};

/// The direction of an extrusion.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ExtrudeAlong {
    /// Each face along its own normal.
    FaceNormal,
    /// Along the world's y axis.
    WorldUp,
}

/// `extrude(distance)`, along the face normals (*extrude operation*).
pub fn extrude(env: &mut Env, shape: &mut ShapeRef<'_>, distance: Length) {
    extrude_along(env, shape, ExtrudeAlong::FaceNormal, distance);
}

/// `extrude(face.normal | world.up, distance)` (*extrude operation*). The new scope's y axis points along the extrusion,
/// its x axis stays as near to the old one as it can, and the pivot stays. A distance of 0 changes nothing.
pub fn extrude_along(env: &mut Env, shape: &mut ShapeRef<'_>, along: ExtrudeAlong, distance: Length) {
    // Relative to the height: the direction in which a shape grows is its y axis afterwards.
    let distance = distance.of(shape.scope.size.y, env, "the distance of `extrude`");
    if distance == 0.0 {
        return;
    }
    match &shape.geometry {
        Geometry::Empty | Geometry::Vertex | Geometry::Edge | Geometry::Wire(_) => {}
        Geometry::Rect(axis) if shape.scope.size[axis.index()] == 0.0 && straight(&shape.scope, *axis, along) => {
            shape.scope = raised(&shape.scope, *axis, distance);
            shape.geometry = Geometry::Box;
        }
        _ => extrude_any(env, shape, along, distance),
    }
}

/// Whether a rectangle across `axis` grows along that axis, and is not mirrored.
fn straight(scope: &Scope, axis: Axis, along: ExtrudeAlong) -> bool {
    0.0 <= scope.size.min_element() && (along == ExtrudeAlong::FaceNormal || scope.axes.col(axis.index()) == DVec3::Y)
}

/// The scope of a rectangle across `axis` that has grown along it.
fn raised(scope: &Scope, axis: Axis, distance: f64) -> Scope {
    let (o, s, [x, y, z]) = (scope.origin, scope.size, [scope.axes.x_axis, scope.axes.y_axis, scope.axes.z_axis]);
    match axis {
        Axis::Y => Scope { size: DVec3::new(s.x, distance, s.z), ..*scope },
        Axis::Z => {
            Scope { origin: o + y * s.y, axes: DMat3::from_cols(x, z, -y), size: DVec3::new(s.x, distance, s.y) }
        }
        Axis::X => {
            Scope { origin: o + y * s.y, axes: DMat3::from_cols(-y, x, z), size: DVec3::new(s.y, distance, s.z) }
        }
    }
}

fn extrude_any(env: &mut Env, shape: &mut ShapeRef<'_>, along: ExtrudeAlong, distance: f64) {
    let mesh = shape.to_mesh();
    let axes = shape.scope.axes;
    let (how, up) = match along {
        ExtrudeAlong::WorldUp => {
            let up = axes.transpose() * DVec3::Y;
            (Extrude::Vector(up), up)
        }
        ExtrudeAlong::FaceNormal => {
            let normal = mesh.faces().map(|face| face.normal()).find(|normal| *normal != DVec3::ZERO);
            (Extrude::FaceNormal, normal.unwrap_or(DVec3::Y))
        }
    };
    // Every edge gets a wall of four corners, and each face a top and a bottom.
    if env.count_corners(6 * mesh.corners().len() as u64).is_break() {
        return;
    }
    let grown = extrude_mesh(&mesh, how, distance);
    // In scope coordinates: turn them so that y is up.
    let turn = raise(&DMat3::IDENTITY, up);
    let local = grown.map(&DAffine3 { matrix3: turn.transpose(), translation: DVec3::ZERO });
    let mut placed = Placed::fitted(local);
    let axes = axes * turn;
    let mut size = placed.size;
    let mut origin = shape.scope.origin + axes * placed.low;
    if distance < 0.0 && size.y != 0.0 {
        // *extrude operation*: a negative distance gives a negative height, and the faces look inwards.
        let flip = DAffine3::from_scale(DVec3::new(1.0, -1.0, 1.0));
        placed = Placed::fitted(placed.mesh.map(&flip));
        origin += axes.y_axis * size.y;
        size.y = -size.y;
    }
    shape.scope = Scope { origin, axes, size };
    shape.geometry = Geometry::Mesh(Arc::new(placed));
}
