//! The rectangles and boxes that fill a scope, as sinks want them.

use glam::DMat3;

use crate::scope::{Axis, Scope};
use crate::sink::{Cuboid, Quad};

/// The rectangle in the low plane across `axis`, looking along it. The first side is the one that is the front or
/// bottom edge of the face.
#[inline]
pub(crate) fn rect(scope: &Scope, axis: Axis) -> Quad {
    let (x, y, z) =
        (scope.axes.x_axis * scope.size.x, scope.axes.y_axis * scope.size.y, scope.axes.z_axis * scope.size.z);
    match axis {
        Axis::X => Quad { origin: scope.origin + z, u: -z, v: y },
        Axis::Y => Quad { origin: scope.origin + z, u: x, v: -z },
        Axis::Z => Quad { origin: scope.origin, u: x, v: y },
    }
}

/// The box that fills the scope.
#[inline]
pub(crate) fn cuboid(scope: &Scope) -> Cuboid {
    Cuboid {
        origin: scope.origin,
        sides: DMat3::from_cols(
            scope.axes.x_axis * scope.size.x,
            scope.axes.y_axis * scope.size.y,
            scope.axes.z_axis * scope.size.z,
        ),
    }
}
