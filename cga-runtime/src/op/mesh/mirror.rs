//! `mirror` and `reverseNormals`: the geometry changes inside its scope.

use std::sync::Arc;

use glam::DVec3;

use crate::geometry::each::Each;
use crate::op::scope::pivot::rearranged;
use crate::run::env::Env;
use crate::shape::PlacedWire;
use crate::shape::{Geometry, Inserted, Placed, Shape};

/// `mirror(x, y, z)`: mirrors the geometry about the middle of its scope, which stays (*mirror operation*). Faces
/// still look outwards, and texture coordinates stay with their corners.
pub fn mirror(env: &mut Env, shape: &mut Shape, x: bool, y: bool, z: bool) {
    let flips = [x, y, z];
    if let Geometry::Wire(placed) = &shape.geometry {
        let size = shape.scope.size;
        let far = DVec3::from_array(flips.each(f64::from));
        let wire = placed.in_scope(size).stretched(DVec3::ONE - 2.0 * far, size * far);
        shape.geometry = Geometry::Wire(Arc::new(PlacedWire { wire, low: DVec3::ZERO, size }));
        return;
    }
    if flips == [false; 3] {
        return;
    }
    if let Some(geometry) = unit_mirrored(&shape.geometry, flips) {
        shape.geometry = geometry;
        return;
    }
    let Some(placed) = shape.geometry.placed() else { return };
    if env.count_vertices(&placed.mesh).is_break() {
        return;
    }
    let mut new = rearranged(&placed, shape.scope.size, [0, 1, 2], flips);
    if flips.iter().filter(|flip| **flip).count() % 2 == 1 {
        new.mesh = Arc::new(new.mesh.reversed());
    }
    shape.geometry = Geometry::Mesh(Arc::new(Placed { inserted: Inserted::No, ..new }));
}

/// A mirrored box or rectangle. `None` if it becomes a mesh: a rectangle must begin with its lowest edge and stay at
/// the low end.
fn unit_mirrored(geometry: &Geometry, flips: [bool; 3]) -> Option<Geometry> {
    match *geometry {
        Geometry::Box(unit) => Some(Geometry::Box(unit.mirrored(flips))),
        Geometry::Rect(across, unit) if !flips[across.index()] => {
            let mirrored = unit.mirrored(flips);
            let begins_alike = mirrored.sides()[0].corners == unit.sides()[0].corners;
            begins_alike.then_some(Geometry::Rect(across, mirrored))
        }
        _ => None,
    }
}

/// `reverseNormals()`: reverses every face. The first edge of each stays, with its ends swapped (*reverseNormals
/// operation*).
pub fn reverse_normals(env: &mut Env, shape: &mut Shape) {
    let Some(placed) = shape.geometry.placed() else { return };
    if env.count_vertices(&placed.mesh).is_break() {
        return;
    }
    let mesh = Arc::new(placed.mesh.reversed());
    shape.geometry = Geometry::Mesh(Arc::new(Placed { mesh, inserted: Inserted::No, ..placed }));
}
