//! Axes and frames. Right-handed, y up; lengths in metres.

use glam::{DMat3, DVec3};

/// One of the three axes of a scope.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Axis {
    /// Along the width.
    X,
    /// Up.
    Y,
    /// To the front.
    Z,
}

impl Axis {
    /// 0, 1 or 2.
    pub const fn index(self) -> usize {
        self as usize
    }
}

/// A right-handed coordinate system in the world.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Frame {
    /// Where it starts.
    pub origin: DVec3,
    /// Its orthonormal axes, as columns.
    pub axes: DMat3,
}

impl Frame {
    /// The world itself.
    pub const WORLD: Frame = Frame { origin: DVec3::ZERO, axes: DMat3::IDENTITY };

    /// From local coordinates to the world.
    pub fn to_world(&self, local: DVec3) -> DVec3 {
        self.origin + self.axes * local
    }

    /// From the world to local coordinates.
    pub fn to_local(&self, world: DVec3) -> DVec3 {
        self.axes.transpose() * (world - self.origin)
    }
}
