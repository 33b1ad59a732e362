//! The shapes of components: scope, pivot and geometry.

use std::sync::Arc;

use glam::DVec3;

use super::mesh_parts::MeshParts;
use super::source::ComponentSource;
use super::{Align, Components};
use crate::geometry::mesh::{Bounds, Mesh};
use crate::geometry::tol::PLANAR_EPSILON;
use crate::geometry::wire::Wire;
use crate::geometry::{Axis, Frame};
use crate::shape::PlacedWire;
use crate::shape::scope::Scope;
use crate::shape::unit::UnitMesh;
use crate::shape::{Geometry, Placed, Shape};

/// The scope, pivot and geometry of a component, or of several together.
pub(super) struct ComponentPart {
    pub(super) scope: Scope,
    pub(super) pivot: Frame,
    pub(super) geometry: Geometry,
}

impl ComponentSource {
    /// The part of the components with those numbers, aligned to the first. Edges may be edges of a roof (*comp
    /// operation*).
    #[inline]
    pub(super) fn part(&self, parent: &Shape, align: Align, numbers: &[u32], as_roof: bool) -> ComponentPart {
        let first = numbers[0] as usize;
        if align == Align::Keep {
            return self.kept(parent, numbers, as_roof);
        }
        match self {
            // These are used unchanged, unless a condition needs their shapes.
            ComponentSource::Quads(_) => self.kept(parent, numbers, as_roof),
            ComponentSource::Mesh(parts) => {
                let face = parts.face_frame(first);
                if let ([_], Some(found)) = (numbers, face.as_ref().filter(|found| found.rectangle))
                    && let Some(provenance) = parts.provenance(first)
                {
                    let pivot = in_world(&parent.scope, &found.frame);
                    let size = (found.high - found.low).extend(0.0);
                    let scope = Scope { origin: pivot.origin, axes: pivot.axes, size };
                    return ComponentPart {
                        scope,
                        pivot,
                        geometry: Geometry::Rect(Axis::Z, UnitMesh::face(Axis::Z, provenance)),
                    };
                }
                match face.map(|found| found.frame).or_else(|| parts.frame(first, as_roof)) {
                    None => self.kept(parent, numbers, as_roof),
                    Some(frame) => match parts.surface(numbers, &frame) {
                        Some(mesh) => surface(in_world(&parent.scope, &frame), Placed::fitted(levelled(mesh))),
                        None => wire(in_world(&parent.scope, &frame), parts.wire(numbers, as_roof).seen_from(&frame)),
                    },
                }
            }
            ComponentSource::Wire(parts) => {
                let frame = parts.frame(first);
                wire(in_world(&parent.scope, &frame), parts.wire(numbers).seen_from(&frame))
            }
        }
    }

    /// The part with the pivot and the axes of the shape (*comp operation*, noAlign).
    pub(super) fn kept(&self, parent: &Shape, numbers: &[u32], as_roof: bool) -> ComponentPart {
        let here = parent.scope.frame();
        let part = match self {
            // The mesh of a box has its sides in the same order.
            ComponentSource::Quads(_) => {
                let parts = MeshParts::new(parent.own_mesh(), Components::Faces, false);
                return ComponentSource::Mesh(Box::new(parts)).kept(parent, numbers, as_roof);
            }
            ComponentSource::Mesh(parts) => match parts.surface(numbers, &Frame::WORLD) {
                Some(mesh) => surface(here, Placed::fitted(mesh)),
                None => wire(here, parts.wire(numbers, as_roof)),
            },
            ComponentSource::Wire(parts) => wire(here, parts.wire(numbers)),
        };
        ComponentPart { pivot: parent.pivot, ..part }
    }
}

/// Moves a mesh that is in the xy plane except for rounding, as a triangle always is, into it: a face has a z size of
/// zero.
fn levelled(mut mesh: Mesh) -> Mesh {
    let is_level = || {
        let size = Bounds::of(mesh.points().iter().copied()).size();
        size.z <= PLANAR_EPSILON * size.max_element()
    };
    if mesh.corners().len() == 3 || is_level() {
        mesh.change_points(|point| point.z = 0.0);
    }
    mesh
}

/// A mesh in the coordinates of a pivot.
fn surface(pivot: Frame, placed: Placed) -> ComponentPart {
    let scope = Scope { origin: pivot.to_world(placed.low), axes: pivot.axes, size: placed.size };
    ComponentPart { scope, pivot, geometry: Geometry::Mesh(Arc::new(placed)) }
}

/// Edges or points in the coordinates of a pivot.
fn wire(pivot: Frame, wire: Wire) -> ComponentPart {
    let placed = PlacedWire::fitted(wire);
    let mut scope = Scope { origin: pivot.to_world(placed.low), axes: pivot.axes, size: placed.size };
    let geometry = match (&placed.wire.edges[..], placed.wire.points.len()) {
        ([], 0) => Geometry::Empty,
        ([], 1) if placed.wire.is_plain() => Geometry::Vertex,
        // Along x except for rounding.
        ([[0, 1]], 2) if placed.wire.points[0] == DVec3::ZERO && is_along_x(placed.wire.points[1]) => {
            let size = placed.wire.points[1].length() * DVec3::X;
            scope = Scope { origin: pivot.origin, axes: pivot.axes, size };
            if placed.wire.is_plain() {
                Geometry::Edge
            } else {
                let points = vec![DVec3::ZERO, size];
                Geometry::Wire(Arc::new(PlacedWire { wire: Wire { points, ..placed.wire }, low: DVec3::ZERO, size }))
            }
        }
        _ => Geometry::Wire(Arc::new(placed)),
    };
    ComponentPart { scope, pivot, geometry }
}

fn is_along_x(end: DVec3) -> bool {
    let near = PLANAR_EPSILON * end.x;
    end.y.abs() <= near && end.z.abs() <= near
}

fn in_world(scope: &Scope, local: &Frame) -> Frame {
    Frame { origin: scope.frame().to_world(local.origin), axes: scope.axes * local.axes }
}
