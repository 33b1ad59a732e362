//! Boxes and rectangles that borrow their axes.

use glam::{DMat3, DVec3};

use super::cuboid::{CORNER, far};
use super::query_geometry::{LARGEST, QueryGeometry};
use crate::Axis;
use crate::bounds::Bounds;

/// A box or a rectangle in the world, for [`query_box_near`](super::Occluders::query_box_near).
#[derive(Clone, Copy, Debug)]
pub struct OrientedBox<'s> {
    pub(super) centre: DVec3,
    /// Orthogonal axes of length 1.
    pub(super) axes: &'s DMat3,
    /// Half of each side.
    pub(super) half: DVec3,
}

impl<'s> OrientedBox<'s> {
    /// The box with a corner and sides along orthogonal axes of length 1.
    #[inline]
    pub fn new(corner: DVec3, axes: &'s DMat3, size: DVec3) -> Self {
        let half = size * 0.5;
        OrientedBox { centre: corner + *axes * half, axes, half }
    }

    /// The rectangle at the corner of a box, across an axis.
    #[inline]
    pub fn rectangle(corner: DVec3, axes: &'s DMat3, mut size: DVec3, across: Axis) -> Self {
        size[across.index()] = 0.0;
        Self::new(corner, axes, size)
    }

    /// A box along the axes of the world with all corners in it.
    #[inline]
    pub fn around(&self) -> Bounds {
        let distance = CORNER * self.half.abs().max_element();
        Bounds { low: self.centre - distance, high: self.centre + distance }
    }

    /// The centre.
    #[inline]
    pub fn centre(&self) -> DVec3 {
        self.centre
    }

    /// A number that is not less than the distance of its corners from its centre.
    #[inline]
    pub fn radius(&self) -> f64 {
        let DVec3 { x, y, z } = self.half.abs();
        x + y + z
    }

    /// It as a geometry of any kind.
    pub fn to_query(&self) -> QueryGeometry<'static> {
        QueryGeometry::oriented(self.centre, *self.axes, self.half)
    }

    /// A number that is not less than the largest coordinate.
    #[inline]
    pub(super) fn far(&self) -> f64 {
        far(self.centre, self.half)
    }

    /// Returns true if at most one extent is 0.
    #[inline]
    pub(super) fn is_solid_or_rectangle(&self) -> bool {
        let DVec3 { x, y, z } = self.half.abs();
        // The second largest extent.
        0.0 < x.max(y).min(y.max(z)).min(z.max(x))
    }

    /// Returns true if all coordinates are finite and not too large. `far` is its own.
    #[inline]
    pub(super) fn is_in_range(&self, far: f64) -> bool {
        let sum = self.centre + self.half;
        (sum.x + sum.y + sum.z).is_finite() && far <= LARGEST
    }
}
