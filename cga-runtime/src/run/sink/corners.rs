//! The positions of rectangles and boxes, and their rounded corners.

use glam::{DVec3, DVec4, Vec4};

use super::{Cuboid, Quad};
use crate::geometry::Axis;
use crate::geometry::each::Each;
use crate::shape::ShapeRef;

/// The position of a rectangle or a box: its first corner and the sides from there. A rectangle has the first two
/// sides.
///
/// All vectors have a fourth coordinate of 0: processors compute with two halves, and store and load them as such.
#[derive(Clone, Copy, Debug)]
pub(crate) struct PlacedBox {
    pub(crate) origin: DVec4,
    pub(crate) sides: [DVec4; 3],
}

impl PlacedBox {
    /// The position of a shape that fills its scope.
    #[inline(always)]
    pub(crate) fn of(shape: &ShapeRef<'_>) -> Self {
        let side = |axis| shape.axes.along(axis) * shape.size.along(axis);
        PlacedBox { origin: shape.origin.get(), sides: [Axis::X, Axis::Y, Axis::Z].each(side) }
    }

    /// The position moved by a vector.
    #[inline(always)]
    pub(crate) fn moved(self, by: DVec4) -> Self {
        PlacedBox { origin: self.origin + by, ..self }
    }

    /// The eight corners of a box; the corner (x, y, z) has the index x + 2y + 4z. Each is rounded once, so the three
    /// faces at a corner agree.
    #[inline(always)]
    pub(crate) fn box_corners(&self) -> [Vec4; 8] {
        let (o, [x, y, z]) = (self.origin, self.sides);
        let (p, q) = (o + y, o + z);
        let r = p + z;
        // Not with `map`, which is a call of its own in some programs.
        let [a, b, c, d] = [o, o + x, p, p + x].each(|corner| corner.as_vec4());
        let [e, f, g, h] = [q, q + x, r, r + x].each(|corner| corner.as_vec4());
        [a, b, c, d, e, f, g, h]
    }

    /// The four corners of a rectangle, counter-clockwise. All have the fourth coordinate of the origin.
    #[inline(always)]
    pub(crate) fn quad_corners(&self) -> [Vec4; 4] {
        let (a, [u, v, _]) = (self.origin, self.sides);
        let b = a + u;
        [a, b, b + v, a + v].each(|corner| corner.as_vec4())
    }
}

impl From<&Quad> for PlacedBox {
    #[inline]
    fn from(quad: &Quad) -> Self {
        PlacedBox { origin: four(quad.origin), sides: [quad.u, quad.v, DVec3::ZERO].each(four) }
    }
}

impl From<&Cuboid> for PlacedBox {
    #[inline]
    fn from(cuboid: &Cuboid) -> Self {
        let sides = [cuboid.sides.x_axis, cuboid.sides.y_axis, cuboid.sides.z_axis];
        PlacedBox { origin: four(cuboid.origin), sides: sides.each(four) }
    }
}

/// The vector with a fourth coordinate of 0.
#[inline(always)]
pub(crate) fn four(v: DVec3) -> DVec4 {
    v.extend(0.0)
}
