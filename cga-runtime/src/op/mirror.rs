//! `mirror` and `reverseNormals`: the geometry changes inside its scope.

use std::sync::Arc;

use glam::DVec3;

use super::pivot::rearranged;
use super::refit::as_placed;
use crate::env::Env;
use crate::scope::Axis;
use crate::shape::{Geometry, Placed, ShapeRef};
use crate::wire::PlacedWire;

/// `mirror(x, y, z)`: mirrors the geometry about the middle of its scope, which stays (*mirror operation*). What looked
/// outwards does so afterwards; texture coordinates stay with their corners. A box or a rectangle that begins with the same
/// edge as before stays one, the sides of the box being numbered from the front as always.
pub fn mirror(env: &mut Env, shape: &mut ShapeRef<'_>, x: bool, y: bool, z: bool) {
    let flips = [x, y, z];
    if let Geometry::Wire(placed) = &shape.geometry {
        let size = shape.scope.size;
        let mut wire = placed.in_scope(size);
        let turned =
            |p: DVec3, size: DVec3| DVec3::from_array([0, 1, 2].map(|i| if flips[i] { size[i] - p[i] } else { p[i] }));
        wire.points.iter_mut().for_each(|point| *point = turned(*point, size));
        wire.normals.iter_mut().for_each(|normal| *normal = turned(*normal, DVec3::ZERO));
        shape.geometry = Geometry::Wire(Arc::new(PlacedWire { wire, low: DVec3::ZERO, size }));
        return;
    }
    let same = match &shape.geometry {
        Geometry::Empty | Geometry::Vertex | Geometry::Edge | Geometry::Wire(_) => true,
        Geometry::Rect(Axis::X, _) => !x && !y,
        Geometry::Rect(Axis::Y | Axis::Z, _) | Geometry::Box(_) => !y && !z,
        Geometry::Mesh(_) => flips == [false; 3],
    };
    let Some(placed) = as_placed(shape).filter(|_| !same) else { return };
    if env.count_vertices(&placed.mesh).is_break() {
        return;
    }
    let mut new = rearranged(&placed, shape.scope.size, [0, 1, 2], flips);
    if flips.iter().filter(|flip| **flip).count() % 2 == 1 {
        new.mesh = Arc::new(new.mesh.reversed());
    }
    shape.geometry = Geometry::Mesh(Arc::new(Placed { whole: false, ..new }));
}

/// `reverseNormals()`: turns every face over. The first edge of each stays, its ends changing places (*reverseNormals
/// operation*).
pub fn reverse_normals(env: &mut Env, shape: &mut ShapeRef<'_>) {
    let Some(placed) = as_placed(shape) else { return };
    if env.count_vertices(&placed.mesh).is_break() {
        return;
    }
    let mesh = Arc::new(placed.mesh.reversed());
    shape.geometry = Geometry::Mesh(Arc::new(Placed { mesh, whole: false, ..placed }));
}
