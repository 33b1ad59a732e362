//! The geometry of a shape in its scope, without what rules have set on it.

use std::sync::Arc;

use glam::DVec3;

use super::{Geometry, Placed, Shape, ShapeRef};
use crate::geometry::mesh::{Bounds, Mesh};
use crate::shape::filled_scope;
use crate::shape::scope::Scope;

/// The scope of a shape with the geometry in it. It is what other shapes can ask about.
#[derive(Clone, Debug)]
pub struct Body {
    pub(crate) scope: Scope,
    pub(crate) geometry: Geometry,
}

impl From<&Shape> for Body {
    fn from(shape: &Shape) -> Self {
        Body { scope: shape.scope, geometry: shape.geometry.clone() }
    }
}

impl From<&ShapeRef<'_>> for Body {
    #[inline]
    fn from(shape: &ShapeRef<'_>) -> Self {
        Body { scope: shape.scope(), geometry: shape.geometry() }
    }
}

impl Body {
    /// A mesh in the world.
    pub(crate) fn in_world(mesh: Mesh) -> Self {
        let placed = Placed::fitted(mesh);
        let scope = Scope { origin: placed.low, ..Scope::new(placed.size) };
        Body { scope, geometry: Geometry::Mesh(Arc::new(placed)) }
    }

    /// The box around the geometry, in the world; for a shape without geometry, the box around its scope.
    pub(crate) fn bounds(&self) -> Bounds {
        let Body { scope, geometry } = self;
        let in_world = |points: &[DVec3], stretch: DVec3, offset: DVec3| {
            Bounds::of(points.iter().map(|point| scope.origin + scope.axes * (*point * stretch + offset)))
        };
        match geometry {
            Geometry::Rect(axis, unit) => Bounds::of(filled_scope::rectangle(scope, *axis, *unit).corners()),
            Geometry::Empty | Geometry::Box(_) => Bounds::of(scope.corners()),
            Geometry::Mesh(placed) => {
                let stretch = placed.stretch(scope.size);
                in_world(placed.mesh.points(), stretch, -placed.low * stretch)
            }
            Geometry::Vertex => Bounds::of([scope.origin]),
            Geometry::Edge => Bounds::of([scope.origin, scope.origin + scope.axes.x_axis * scope.size.x]),
            Geometry::Wire(wire) => in_world(&wire.in_scope(scope.size).points, DVec3::ONE, DVec3::ZERO),
        }
    }

    /// The area of all faces, in square metres.
    pub(crate) fn area(&self) -> f64 {
        let size = self.scope.size.abs();
        match &self.geometry {
            Geometry::Rect(axis, _) => (0..3).filter(|at| *at != axis.index()).map(|at| size[at]).product(),
            Geometry::Box(_) => 2.0 * (size.x * size.y + size.y * size.z + size.z * size.x),
            Geometry::Mesh(placed) => {
                let stretch = placed.stretch(self.scope.size);
                if stretch == DVec3::ONE {
                    placed.mesh.area()
                } else {
                    self.world_mesh().map_or(0.0, |mesh| mesh.area())
                }
            }
            Geometry::Empty | Geometry::Vertex | Geometry::Edge | Geometry::Wire(_) => 0.0,
        }
    }

    /// Returns true if the geometry is a closed surface with a volume (*occlusion queries*). A flattened solid has none.
    pub(crate) fn is_closed(&self) -> bool {
        let is_flat = self.scope.size.cmpeq(DVec3::ZERO).any();
        match &self.geometry {
            Geometry::Box(_) => !is_flat,
            Geometry::Mesh(placed) => !is_flat && is_closed_surface(&placed.mesh),
            _ => false,
        }
    }

    /// The geometry as a mesh in the world. `None` without faces.
    pub(crate) fn world_mesh(&self) -> Option<Arc<Mesh>> {
        let Body { scope, geometry } = self;
        match geometry {
            Geometry::Rect(axis, unit) => Some(Arc::new(filled_scope::rectangle(scope, *axis, *unit).to_mesh())),
            Geometry::Box(unit) => Some(Arc::new(filled_scope::cuboid(scope, *unit).to_mesh())),
            Geometry::Mesh(placed) => {
                Some(Arc::new(placed.mesh.map(&(scope.placement() * placed.to_scope(scope.size)))))
            }
            Geometry::Empty | Geometry::Vertex | Geometry::Edge | Geometry::Wire(_) => None,
        }
    }
}

/// Returns true if there are faces, and every edge has two of them (*geometry.isClosedSurface function*).
pub(crate) fn is_closed_surface(mesh: &Mesh) -> bool {
    let adjacency = mesh.adjacency();
    !mesh.is_empty() && (0..adjacency.edge_count()).all(|edge| adjacency.faces_at(edge).count() == 2)
}
