//! New axes around geometry that stays in the world.

use std::sync::Arc;

use glam::{DAffine3, DMat3, DVec3};

use crate::fault::FaultKind;
use crate::geometry::mesh::Bounds;
use crate::geometry::solid;
use crate::geometry::tol::ANGLE_EPSILON;
use crate::geometry::wire::Wire;
use crate::geometry::{Axis, Frame};
use crate::run::env::Env;
use crate::shape::PlacedWire;
use crate::shape::filled_scope;
use crate::shape::scope::Scope;
use crate::shape::unit::UnitMesh;
use crate::shape::{Geometry, Placed, Shape};

/// Gives the scope other axes and makes it the box of the geometry along them. Returns false if it did not, because
/// of a fault or a limit. A box whose axes stay is still a box. A rectangle whose edges follow the new axes stays a
/// rectangle.
pub(in crate::op) fn refit(env: &mut Env, shape: &mut Shape, axes: DMat3, what: &str) -> bool {
    let scope = shape.scope;
    // The new axes in the coordinates of the old scope.
    let turn = scope.axes.transpose() * axes;
    let stays = turn.abs_diff_eq(DMat3::IDENTITY, ANGLE_EPSILON);
    let found = match &shape.geometry {
        _ if stays && keeps_box(&shape.geometry, scope.size) => Some((Scope { axes, ..scope }, shape.geometry.clone())),
        Geometry::Rect(axis, unit) if 0.0 <= scope.size.min_element() => rectangle(&scope, *axis, *unit, axes),
        Geometry::Edge if stays && 0.0 <= scope.size.x => {
            Some((Scope { axes, size: DVec3::X * scope.size.x, ..scope }, Geometry::Edge))
        }
        Geometry::Edge | Geometry::Wire(_) => shape.to_wire().map(|edges| wire(&scope, &turn, axes, edges)),
        Geometry::Vertex => Some((Scope { axes, size: DVec3::ZERO, ..scope }, Geometry::Vertex)),
        Geometry::Empty => Some((around(&scope, &turn, axes), Geometry::Empty)),
        Geometry::Box(_) | Geometry::Rect(..) | Geometry::Mesh(_) => None,
    };
    let found = match found {
        Some(found) => found,
        None => {
            let mesh = shape.own_mesh();
            if env.count_vertices(&mesh).is_break() {
                return false;
            }
            let turned = DAffine3 { matrix3: turn.transpose(), translation: DVec3::ZERO };
            let mesh = mesh.map(&turned);
            let placed = Placed::flattened(mesh);
            let inserted = shape.geometry.inserted();
            let new = Scope { origin: scope.origin + axes * placed.low, axes, size: placed.size };
            (new, Geometry::Mesh(Arc::new(Placed { inserted, mirrored: shape.looks_inwards(), ..placed })))
        }
    };
    if !(found.0.is_bounded() && axes.is_finite()) {
        env.fault(FaultKind::Value, format!("{what} overflows; the shape stays as it is"));
        return false;
    }
    (shape.scope, shape.geometry) = found;
    true
}

/// The corners of a box that fills a scope of that size.
pub(in crate::op) fn corners(size: DVec3) -> impl Iterator<Item = DVec3> {
    (0..8).map(move |number| size * solid::corner(number))
}

/// Returns true if a scope of that size is the box of the geometry. The scope of a mesh is not after a split with `noAdjust`,
/// nor for a flat mesh in a thick scope.
fn keeps_box(geometry: &Geometry, size: DVec3) -> bool {
    match geometry {
        Geometry::Empty => true,
        Geometry::Box(_) => 0.0 < size.min_element(),
        Geometry::Mesh(placed) => {
            let bounds = placed.mesh.bounds();
            let thick = placed.size.cmpeq(DVec3::ZERO) & size.cmpne(DVec3::ZERO);
            let is_own = placed.low == bounds.low && placed.size == bounds.size() && !thick.any();
            !placed.mesh.is_empty() && is_own && 0.0 <= size.min_element()
        }
        Geometry::Rect(..) | Geometry::Vertex | Geometry::Edge | Geometry::Wire(_) => false,
    }
}

/// The box along other axes around the scope.
fn around(scope: &Scope, turn: &DMat3, axes: DMat3) -> Scope {
    let bounds = Bounds::of(corners(scope.size).map(|corner| turn.transpose() * corner));
    Scope { origin: scope.origin + axes * bounds.low, axes, size: bounds.size() }
}

/// Edges and points along other axes.
fn wire(scope: &Scope, turn: &DMat3, axes: DMat3, wire: Wire) -> (Scope, Geometry) {
    let placed = PlacedWire::flattened(wire.seen_from(&Frame { origin: DVec3::ZERO, axes: *turn }));
    let new = Scope { origin: scope.origin + axes * placed.low, axes, size: placed.size };
    (new, Geometry::Wire(Arc::new(placed)))
}

/// The rectangle along other axes, if it is one there, with the same first edge and the same normal.
pub(in crate::op) fn rectangle(scope: &Scope, axis: Axis, unit: UnitMesh, axes: DMat3) -> Option<(Scope, Geometry)> {
    let quad = filled_scope::rectangle(scope, axis, unit);
    let (across, up) = (quad.u.length(), quad.v.length());
    // The directions of the first two edges.
    let directions = |axes: DMat3, axis: Axis| {
        let quad = filled_scope::rectangle(&Scope { axes, ..Scope::new(DVec3::ONE) }, axis, unit);
        [quad.u, quad.v]
    };
    let old = directions(scope.axes, axis);
    [Axis::X, Axis::Y, Axis::Z].into_iter().find_map(|new| {
        let near = directions(axes, new).iter().zip(old).all(|(a, b)| a.abs_diff_eq(b, ANGLE_EPSILON));
        let (origin, size) = match new {
            Axis::X => (quad.origin + quad.u, DVec3::new(0.0, up, across)),
            Axis::Y => (quad.origin + quad.v, DVec3::new(across, 0.0, up)),
            Axis::Z => (quad.origin, DVec3::new(across, up, 0.0)),
        };
        near.then_some((Scope { origin, axes, size }, Geometry::Rect(new, unit.across(new))))
    })
}
