//! `primitiveCube`, `primitiveCylinder` and `primitiveQuad`.
//!
//! Without sizes they fill the scope, zero sizes following the rules of `i`; with sizes they stand in the middle of the
//! scope's xz plane on y = 0 (*primitiveCube*, *primitiveCylinder*, *primitiveQuad*).

use std::sync::Arc;

use glam::DVec3;

use super::insert::fit;
use super::settle;
use crate::env::Env;
use crate::fault::FaultKind;
use crate::scope::Axis;
use crate::shape::{Geometry, Placed, ShapeRef};

/// Sides of a cylinder when none are given.
const SIDES: u32 = 16;
/// More sides than this are cut down, with a fault.
const MOST_SIDES: u32 = 100_000;

/// `primitiveCube()`.
pub fn cube(env: &mut Env, shape: &mut ShapeRef<'_>) {
    fit(shape, DVec3::ZERO, DVec3::ONE);
    shape.geometry = Geometry::Box;
    super::trim(env, shape);
}

/// `primitiveCube(width, height, depth)`.
pub fn cube_sized(env: &mut Env, shape: &mut ShapeRef<'_>, width: f64, height: f64, depth: f64) {
    stand(env, shape, DVec3::new(width, height, depth));
    shape.geometry = Geometry::Box;
    super::trim(env, shape);
}

/// `primitiveCylinder()`, with 16 sides, along y.
pub fn cylinder(env: &mut Env, shape: &mut ShapeRef<'_>) {
    cylinder_sides(env, shape, f64::from(SIDES));
}

/// `primitiveCylinder(sides)`.
pub fn cylinder_sides(env: &mut Env, shape: &mut ShapeRef<'_>, sides: f64) {
    fit(shape, DVec3::ZERO, DVec3::ONE);
    fill_with_cylinder(env, shape, sides);
}

/// `primitiveCylinder(sides, radius, height)`.
pub fn cylinder_sized(env: &mut Env, shape: &mut ShapeRef<'_>, sides: f64, radius: f64, height: f64) {
    stand(env, shape, DVec3::new(2.0 * radius, height, 2.0 * radius));
    fill_with_cylinder(env, shape, sides);
}

fn fill_with_cylinder(env: &mut Env, shape: &mut ShapeRef<'_>, sides: f64) {
    let wanted = env.finite(sides, "the number of sides");
    let count = wanted.clamp(3.0, f64::from(MOST_SIDES)) as u32;
    if f64::from(count) != wanted {
        env.fault(FaultKind::Value, format!("a cylinder cannot have {wanted} sides; it gets {count}"));
    }
    let mesh = env.cylinder(count);
    shape.geometry = Geometry::Mesh(Arc::new(Placed { mesh, low: DVec3::ZERO, size: DVec3::ONE, whole: true }));
    // A size of zero flattens it.
    shape.resize(shape.scope.size);
    super::trim(env, shape);
}

/// `primitiveQuad()`: across y; where exactly one size of the scope is zero, across that axis.
pub fn quad(env: &mut Env, shape: &mut ShapeRef<'_>) {
    let size = shape.scope.size;
    let flat: [bool; 3] = size.cmpeq(DVec3::ZERO).into();
    let axis = match flat {
        [true, false, false] => Axis::X,
        [false, false, true] => Axis::Z,
        _ => Axis::Y,
    };
    if axis == Axis::Y {
        fit(shape, DVec3::ZERO, DVec3::new(1.0, 0.0, 1.0));
    }
    shape.scope.size[axis.index()] = 0.0;
    shape.geometry = Geometry::Rect(axis);
    super::trim(env, shape);
}

/// `primitiveQuad(width, length)`.
pub fn quad_sized(env: &mut Env, shape: &mut ShapeRef<'_>, width: f64, length: f64) {
    stand(env, shape, DVec3::new(width, 0.0, length));
    shape.geometry = Geometry::Rect(Axis::Y);
    super::trim(env, shape);
}

/// Gives the scope a size, in the middle of its old xz plane and on its floor.
fn stand(env: &mut Env, shape: &mut ShapeRef<'_>, size: DVec3) {
    let size =
        DVec3::new(env.finite(size.x, "the width"), env.finite(size.y, "the height"), env.finite(size.z, "the depth"));
    let before = shape.scope;
    let room = (shape.scope.size - size) * DVec3::new(0.5, 0.0, 0.5);
    shape.scope.origin += shape.scope.axes * room;
    shape.scope.size = size;
    settle(env, shape, &before, "the size of the primitive");
}
