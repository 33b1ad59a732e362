//! Normals of rectangles and boxes, rounded.
//!
//! A leaf that fills its scope has the normals of its axes, whether it comes from a run or from a model.

use glam::{DMat3, Vec4};

use super::flatten::unit;
use crate::geometry::Axis;
use crate::run::sink::{Cuboid, Leaf, Quad};
use crate::shape::axes::{self, Axes};
use crate::shape::filled_scope;

/// The normal of a rectangle.
#[inline]
pub(super) fn of_quad(leaf: &Leaf<'_>, quad: &Quad) -> Vec4 {
    let scope = &leaf.scope();
    let normal = match 0.0 <= scope.size.min_element() && *quad == filled_scope::rectangle(scope, Axis::Z, quad.unit) {
        true => scope.axes.z_axis,
        false => unit(quad.u.cross(quad.v)),
    };
    axes::normal(normal)
}

/// The normals of a box, by side.
#[inline]
pub(super) fn of_cuboid(leaf: &Leaf<'_>, cuboid: &Cuboid) -> [Vec4; 6] {
    let scope = &leaf.scope();
    if 0.0 <= scope.size.min_element() && *cuboid == filled_scope::cuboid(scope, cuboid.unit) {
        return Axes::new(scope.axes).normals;
    }
    let [x, y, z] = [cuboid.sides.x_axis, cuboid.sides.y_axis, cuboid.sides.z_axis];
    // From cross products, as they follow the winding when a side is negative.
    Axes::new(DMat3::from_cols(unit(y.cross(z)), unit(z.cross(x)), unit(x.cross(y)))).normals
}
