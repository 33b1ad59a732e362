//! The plane projection of a face.

use glam::{DVec2, DVec3};

use super::net::Net;
use super::turn::is_convex;
use crate::tol::FLAT_EPSILON;
use crate::triangulate::PlaneProjection;
use crate::vector::{area_vector, unit};

/// A projection that drops a coordinate, with a scale. Both are exact.
#[derive(Clone, Copy)]
pub(super) struct Plane {
    projection: PlaneProjection,
    /// A power of two that scales coordinates to about 1.
    pub(super) scale: f64,
    /// True if the points are not in one plane, so that parts have other planes.
    pub(super) is_bent: bool,
}

impl Plane {
    /// The plane of a face with that normal and these points.
    pub(super) fn of(normal: DVec3, points: impl Iterator<Item = DVec3> + Clone) -> Self {
        let projection = PlaneProjection::along(normal);
        let most = points.clone().fold(0.0, |most: f64, point| most.max(projection.apply(point).abs().max_element()));
        let scale = if most == 0.0 { 1.0 } else { libm::scalbn(1.0, -libm::ilogb(most)) };
        let is_bent = points.clone().next().is_some_and(|from| {
            let near = FLAT_EPSILON * points.clone().fold(0.0, |most: f64, point| most.max((point - from).length()));
            points.clone().any(|point| near < (point - from).dot(normal).abs())
        });
        Plane { projection, scale, is_bent }
    }

    /// The plane of a loop.
    fn of_ring(net: &Net, ring: &[u32]) -> Self {
        let points = ring.iter().map(|&corner| net.position(corner));
        Plane::of(unit(area_vector(std::iter::once(points.clone()))), points)
    }

    pub(super) fn place(&self, point: DVec3) -> DVec2 {
        self.projection.apply(point) * self.scale
    }

    /// The place of a corner.
    pub(super) fn flat(&self, net: &Net, corner: u32) -> DVec2 {
        self.place(net.position(corner))
    }

    /// Returns true if a loop of a part of the face is convex in its own plane, too.
    pub(super) fn is_convex_part(&self, net: &Net, ring: &[u32]) -> bool {
        !self.is_bent || {
            let own = Plane::of_ring(net, ring);
            is_convex(&ring.iter().map(|&corner| own.flat(net, corner)).collect::<Vec<_>>())
        }
    }
}
