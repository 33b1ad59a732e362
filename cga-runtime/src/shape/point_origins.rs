//! The points of shapes and their origins, in operands that are recomposed.

use std::sync::Arc;

use glam::DVec3;

use super::{Geometry, PlacedWire, Shape};
use crate::geometry::mesh::Mesh;
use crate::geometry::trace::Trace;

impl Shape {
    /// Turns geometry without a list of points into a mesh or a wire.
    pub(crate) fn hold_as_points(&mut self) {
        self.hold_as_mesh();
        if let Geometry::Vertex | Geometry::Edge = self.geometry
            && let Some(wire) = self.to_wire()
        {
            let size = if wire.edges.is_empty() { DVec3::ZERO } else { DVec3::X * self.scope.size.x };
            self.geometry = Geometry::Wire(Arc::new(PlacedWire { wire, low: DVec3::ZERO, size }));
        }
    }

    /// The points of a mesh or a wire, in its own coordinates.
    pub(crate) fn points(&self) -> Option<&[DVec3]> {
        match &self.geometry {
            Geometry::Mesh(placed) => Some(placed.mesh.points()),
            Geometry::Wire(placed) => Some(&placed.wire.points),
            _ => None,
        }
    }

    /// The points of a mesh or a wire, in the world.
    pub(crate) fn world_points(&self) -> Vec<DVec3> {
        let scope = self.scope;
        match &self.geometry {
            Geometry::Mesh(placed) => {
                let map = scope.placement() * placed.to_scope(scope.size);
                placed.mesh.points().iter().map(|point| map.transform_point3(*point)).collect()
            }
            Geometry::Wire(placed) => {
                let frame = scope.frame();
                placed.in_scope(scope.size).points.into_iter().map(|point| frame.to_world(point)).collect()
            }
            _ => Vec::new(),
        }
    }

    /// The trace of a mesh or a wire.
    pub(crate) fn trace(&self) -> Option<&Trace> {
        match &self.geometry {
            Geometry::Mesh(placed) => Some(placed.mesh.trace()),
            Geometry::Wire(placed) => Some(&placed.wire.trace),
            _ => None,
        }
    }

    /// Gives the origins of points to a mesh in scope coordinates that an operation has made of the geometry: to the points that
    /// it has kept.
    pub(crate) fn hand_trace_to(&self, made: &mut Mesh) {
        let Some(trace) = self.trace().filter(|trace| !trace.is_empty() && made.trace().is_empty()) else { return };
        let found = match self.to_wire() {
            Some(wire) => trace.at_places(&wire.points, made.points()),
            None => trace.at_places(self.to_mesh().points(), made.points()),
        };
        made.set_trace(found);
    }

    /// Changes the trace of a mesh or a wire.
    pub(crate) fn change_trace(&mut self, change: impl FnOnce(&mut Trace)) {
        match &mut self.geometry {
            Geometry::Mesh(placed) => Arc::make_mut(&mut Arc::make_mut(placed).mesh).change_trace(change),
            Geometry::Wire(placed) => change(&mut Arc::make_mut(placed).wire.trace),
            _ => {}
        }
    }
}
