//! Shapes as solids that occlude, and as geometries that are compared with solids.

use glam::{DAffine3, DMat3};

use crate::geometry::relation::{Occluder, OrientedBox, QueryGeometry, Relation};
use crate::shape::Geometry;
use crate::shape::body::Body;
use crate::shape::scope::Scope;

/// The box of a scope, as a map of the unit box.
fn cuboid(scope: &Scope) -> DAffine3 {
    DAffine3 { matrix3: scope.axes * DMat3::from_diagonal(scope.size), translation: scope.origin }
}

/// A closed shape as a solid; `None` for geometry that is not a solid.
pub(super) fn occluder(body: &Body) -> Option<Occluder> {
    match &body.geometry {
        Geometry::Box(_) => Some(Occluder::cuboid(cuboid(&body.scope))),
        Geometry::Mesh(placed) => {
            let placement = body.scope.placement() * placed.to_scope(body.scope.size);
            Some(Occluder::mesh(placed.mesh.clone(), placement))
        }
        _ => None,
    }
}

/// The relation that `ask` finds for the geometry of a shape. A shape of several edges or points is inside if each of them is; it overlaps
/// or touches if one of them does. A shape without geometry has none.
pub(crate) fn relation(body: &Body, mut ask: impl FnMut(&QueryGeometry<'_>) -> Relation) -> Relation {
    let scope = &body.scope;
    match &body.geometry {
        Geometry::Empty => Relation::NONE,
        Geometry::Box(_) => ask(&OrientedBox::new(scope.origin, &scope.axes, scope.size).to_query()),
        Geometry::Rect(axis, _) => {
            ask(&OrientedBox::rectangle(scope.origin, &scope.axes, scope.size, *axis).to_query())
        }
        Geometry::Mesh(placed) => {
            ask(&QueryGeometry::mesh(&placed.mesh, scope.placement() * placed.to_scope(scope.size)))
        }
        Geometry::Vertex => ask(&QueryGeometry::point(scope.origin)),
        Geometry::Edge => ask(&QueryGeometry::segment([scope.origin, scope.origin + scope.axes.x_axis * scope.size.x])),
        Geometry::Wire(placed) => {
            let (wire, placement) = (placed.in_scope(scope.size), scope.placement());
            let points: Vec<_> = wire.points.iter().map(|point| placement.transform_point3(*point)).collect();
            let edges = &wire.edges;
            let asked: Vec<Relation> = if edges.is_empty() {
                points.iter().map(|point| ask(&QueryGeometry::point(*point))).collect()
            } else {
                let segment = |[from, to]: [u32; 2]| [points[from as usize], points[to as usize]];
                edges.iter().map(|edge| ask(&QueryGeometry::segment(segment(*edge)))).collect()
            };
            let inside = !asked.is_empty() && asked.iter().all(|relation| relation.inside);
            Relation { inside, ..asked.into_iter().fold(Relation::NONE, Relation::or) }
        }
    }
}
