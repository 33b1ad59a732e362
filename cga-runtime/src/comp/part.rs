//! The shapes of components: scope, pivot and geometry.

use std::sync::Arc;

use glam::DVec3;

use super::mesh_parts::MeshParts;
use super::source::ComponentSource;
use super::{Align, Components};
use crate::geometry::face_frame::FaceAxes;
use crate::geometry::level_face::{LevelFaces, levelled};
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

impl ComponentPart {
    /// Replaces the scope, the pivot and the geometry of a shape.
    #[inline(always)]
    pub(super) fn put_into(self, shape: &mut Shape) {
        shape.scope = self.scope;
        shape.pivot = self.pivot;
        shape.geometry = self.geometry;
    }
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
                let axes = parts.face_axes(first);
                if let ([_], Some(axes)) = (numbers, axes) {
                    return parts.face_part(&LevelFaces::of(&parts.mesh), &parent.scope, first, &axes, &mut None);
                }
                match axes.map(|found| found.frame).or_else(|| parts.frame(first, as_roof)) {
                    None => self.kept(parent, numbers, as_roof),
                    Some(frame) => match parts.surface(numbers, &frame) {
                        Some(mesh) => surface(in_world(&parent.scope, &frame), Placed::fitted(levelled(mesh)).into()),
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
                Some(mesh) => surface(here, Placed::fitted(mesh).into()),
                None => wire(here, parts.wire(numbers, as_roof)),
            },
            ComponentSource::Wire(parts) => wire(here, parts.wire(numbers)),
        };
        ComponentPart { pivot: parent.pivot, ..part }
    }
}

impl MeshParts {
    /// The part of a single face with an area, in the scope of the shape. The mesh of another face may be replaced, if nothing else has it.
    #[inline(always)]
    pub(super) fn face_part(
        &self,
        faces: &LevelFaces<'_>,
        scope: &Scope,
        face: usize,
        axes: &FaceAxes,
        last: &mut Option<Arc<Placed>>,
    ) -> ComponentPart {
        let pivot = in_world(scope, &axes.frame);
        if let Some(size) = axes.rectangle(&self.mesh, face)
            && let Some(provenance) = self.provenance(face)
        {
            let scope = Scope { origin: pivot.origin, axes: pivot.axes, size: size.extend(0.0) };
            let geometry = Geometry::Rect(Axis::Z, UnitMesh::face(Axis::Z, provenance));
            return ComponentPart { scope, pivot, geometry };
        }
        surface(pivot, placed_face(faces, face, &axes.frame, last.take()))
    }
}

/// The mesh of a face, in the place of another one if nothing else has that.
#[inline(always)]
fn placed_face(faces: &LevelFaces<'_>, face: usize, frame: &Frame, last: Option<Arc<Placed>>) -> Arc<Placed> {
    if let Some(mut last) = last
        && let Some(placed) = Arc::get_mut(&mut last)
        && let Some(mesh) = Arc::get_mut(&mut placed.mesh)
        && let Some(bounds) = faces.put(mesh, face, frame)
    {
        placed.fit(bounds);
        return last;
    }
    Arc::new(Placed::fitted(faces.make(face, frame)))
}

/// A mesh in the coordinates of a pivot.
#[inline(always)]
fn surface(pivot: Frame, placed: Arc<Placed>) -> ComponentPart {
    let scope = Scope { origin: pivot.to_world(placed.low), axes: pivot.axes, size: placed.size };
    ComponentPart { scope, pivot, geometry: Geometry::Mesh(placed) }
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

#[inline(always)]
fn in_world(scope: &Scope, local: &Frame) -> Frame {
    Frame { origin: scope.frame().to_world(local.origin), axes: scope.axes * local.axes }
}
