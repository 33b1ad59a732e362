//! The plane projection of a face.

use glam::{DVec2, DVec3};

use super::net::Net;
use crate::geometry::triangulate::PlaneProjection;

/// A projection that drops a coordinate, with a scale. Both are exact.
#[derive(Clone, Copy)]
pub(super) struct Plane {
    projection: PlaneProjection,
    /// A power of two that scales coordinates to about 1.
    pub(super) scale: f64,
}

impl Plane {
    /// The plane of a face with that normal and these points.
    pub(super) fn of(normal: DVec3, points: impl Iterator<Item = DVec3>) -> Self {
        let projection = PlaneProjection::along(normal);
        let most = points.fold(0.0, |most: f64, point| most.max(projection.apply(point).abs().max_element()));
        let scale = if most == 0.0 { 1.0 } else { libm::scalbn(1.0, -libm::ilogb(most)) };
        Plane { projection, scale }
    }

    pub(super) fn place(&self, point: DVec3) -> DVec2 {
        self.projection.apply(point) * self.scale
    }

    /// The place of a corner.
    pub(super) fn flat(&self, net: &Net, corner: u32) -> DVec2 {
        self.place(net.position(corner))
    }
}
