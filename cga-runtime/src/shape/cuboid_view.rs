//! Boxes and rectangles in the world, as occlusion queries read them.

use glam::{DMat3, DVec3};

use crate::geometry::Axis;
use crate::geometry::mesh::Bounds;
use crate::geometry::relation::QueryGeometry;

/// A box or a rectangle in the world. The axes stay with the shape.
#[derive(Clone, Copy, Debug)]
pub struct CuboidView<'s> {
    centre: DVec3,
    axes: &'s DMat3,
    /// Half of each side.
    half: DVec3,
}

impl<'s> CuboidView<'s> {
    /// The box that fills a scope.
    #[inline]
    pub(crate) fn new(origin: DVec3, axes: &'s DMat3, size: DVec3) -> Self {
        let half = size * 0.5;
        CuboidView { centre: origin + *axes * half, axes, half }
    }

    /// The rectangle across an axis. It is on the low side of its scope.
    #[inline]
    pub(crate) fn rectangle(origin: DVec3, axes: &'s DMat3, mut size: DVec3, across: Axis) -> Self {
        size[across.index()] = 0.0;
        Self::new(origin, axes, size)
    }

    /// The box around it, along the axes of the world.
    #[inline]
    pub(crate) fn bounds(&self) -> Bounds {
        let DMat3 { x_axis, y_axis, z_axis } = self.axes;
        let half = self.half.abs();
        let reach = x_axis.abs() * half.x + y_axis.abs() * half.y + z_axis.abs() * half.z;
        Bounds { low: self.centre - reach, high: self.centre + reach }
    }

    /// It as the geometry of a query.
    #[inline]
    pub(crate) fn geometry(&self) -> QueryGeometry<'static> {
        QueryGeometry::oriented(self.centre, *self.axes, self.half)
    }
}
