//! Axes and frames. Right-handed, y up; lengths in metres.

use glam::{DMat3, DVec3};

/// One of the three axes.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Axis {
    /// The axis along the width.
    X,
    /// The axis that points up.
    Y,
    /// The axis that points to the front.
    Z,
}

impl Axis {
    /// The index of the axis: 0, 1 or 2.
    pub const fn index(self) -> usize {
        self as usize
    }
}

/// A right-handed coordinate system in the world.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Frame {
    /// The origin.
    pub origin: DVec3,
    /// Its orthonormal axes, as columns.
    pub axes: DMat3,
}

impl Frame {
    /// The frame of the world.
    pub const WORLD: Frame = Frame { origin: DVec3::ZERO, axes: DMat3::IDENTITY };

    /// Converts local coordinates to world coordinates.
    #[inline]
    pub fn to_world(&self, local: DVec3) -> DVec3 {
        self.origin + self.axes * local
    }

    /// Converts world coordinates to local coordinates.
    #[inline]
    pub fn to_local(&self, world: DVec3) -> DVec3 {
        self.axes.transpose() * (world - self.origin)
    }
}
