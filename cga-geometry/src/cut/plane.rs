//! Cuts by an arbitrary plane, with the code that cuts across an axis.
//!
//! The mesh is cut in a frame whose x axis is the plane's normal and whose origin is in the plane. The side of a point
//! is the sign of its height in this frame, computed once. The parts take the points of the mesh bit for bit, and
//! crossings are recomputed between the ends of their edges, once for both sides. So the parts contain no rounding
//! errors of the frame.

use std::sync::Arc;

use glam::{DMat3, DVec3};

use super::points::NONE;
use super::{Cutter, OpenChain, Slabs};
use crate::Frame;
use crate::each::Each;
use crate::mesh::{Mesh, unit};

/// An oriented plane.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Plane {
    /// A point of the plane.
    pub point: DVec3,
    /// The direction of the upper side, with any length except zero.
    pub normal: DVec3,
}

/// Cuts a mesh by a plane into the parts below and above it. Points at most `tolerance` from the plane, in the mesh's
/// own unit, count as points in it; no point moves. Caps are like the caps of [`slabs`](super::slabs()).
///
/// If both ends of an edge have equal coordinates along some axis, the crossing has the same coordinate, bit for bit.
/// Crossings are in the plane except for rounding. With a tolerance of 0, a second cut at the same plane may find
/// points on the wrong side and remove thin pieces. With a tolerance of at least 1e-15 times the largest coordinate (of
/// the mesh or of the plane's point) it changes nothing.
///
/// An invalid plane (a normal of zero length, numbers that are not finite) cuts nothing: the whole mesh is below it.
///
/// ```
/// use std::sync::Arc;
/// use cga_geometry::{cut, primitive};
/// use cga_geometry::glam::DVec3;
///
/// // A cube of 1, cut across a corner.
/// let cube = Arc::new(primitive::cube());
/// let plane = cut::Plane { point: DVec3::new(0.5, 0.0, 0.0), normal: DVec3::splat(1.0) };
/// let halves = cut::halves(&cube, &plane, 0.0);
/// let [below, above] = [0, 1].map(|side| halves.parts[side].as_ref().unwrap());
/// assert!((below.volume() - 0.125 / 6.0).abs() < 1e-15);
/// assert!(below.is_closed() && above.is_closed());
/// ```
pub fn halves(mesh: &Arc<Mesh>, plane: &Plane, tolerance: f64) -> Slabs {
    Cutter::with(|cutter| cutter.halves(mesh, plane, tolerance, true))
}

/// The part above a plane, without caps. `None` if the whole mesh is below, as with an invalid plane. The tolerance is as in
/// [`halves`].
pub fn above(mesh: &Arc<Mesh>, plane: &Plane, tolerance: f64) -> Option<Arc<Mesh>> {
    Cutter::with(|cutter| cutter.halves(mesh, plane, tolerance, false)).parts.pop().flatten()
}

/// A frame in which the plane is x = 0. `None` for an invalid plane.
fn frame_of(plane: &Plane) -> Option<Frame> {
    let x = unit(plane.normal);
    let (y, z) = x.any_orthonormal_pair();
    let is_valid = x != DVec3::ZERO && plane.point.is_finite();
    is_valid.then(|| Frame { origin: plane.point, axes: DMat3::from_cols(x, y, z) })
}

impl Cutter {
    fn halves(&mut self, mesh: &Arc<Mesh>, plane: &Plane, tolerance: f64, close: bool) -> Slabs {
        let whole = |side: usize| {
            let mut slabs = Slabs { parts: vec![None, None], ..Slabs::default() };
            slabs.parts[side] = (!mesh.is_empty()).then(|| mesh.clone());
            slabs
        };
        let Some(frame) = frame_of(plane) else { return whole(0) };
        let place = |point: &DVec3| {
            let local = frame.to_local(*point);
            if local.x.abs() <= tolerance { local.with_x(0.0) } else { local }
        };
        let points: Vec<DVec3> = mesh.points.iter().map(place).collect();
        let span = points.iter().fold((f64::INFINITY, f64::NEG_INFINITY), |(l, h), p| (l.min(p.x), h.max(p.x)));
        // As in a cut across an axis: if the mesh only touches the plane, all of it is on one side.
        let flat = span.0 == span.1 && !mesh.is_closed();
        if span.1 < 0.0 || (span.1 == 0.0 && !flat) || !points.iter().all(|point| point.is_finite()) {
            return whole(0);
        }
        if 0.0 < span.0 || (span.0 == 0.0 && !flat) {
            return whole(1);
        }
        // The other values of corners do not change.
        let local = Mesh { bent: frame.axes.transpose() * mesh.bent, ..mesh.with_points(points) };
        self.state.points.axis = 0;
        self.state.points.planes.clear();
        self.state.points.planes.push(0.0);
        self.cut_faces(&local);
        let without_caps = [0, 1].each(|side: usize| self.state.parts[side].mesh.corners.len());
        let mut slabs = Slabs::default();
        let mut open = Vec::new();
        if close {
            self.caps.close(&mut self.state, &local, |_, _, chain| open.push(chain));
        }
        let met = self.state.points.on_plane_of(&mesh.points, &local.points);
        for chain in open {
            let points = chain.into_iter().map(|point| met[point as usize]).collect();
            slabs.open.push(OpenChain { plane: 0, points });
        }
        self.restore(mesh, &met, without_caps, frame.axes.x_axis);
        let closed = close && mesh.derived.closed.get() == Some(&true) && slabs.open.is_empty();
        let mut origins = self.state.needed_origins(&local);
        let parts = self.state.parts.drain(..);
        slabs.parts = parts.map(|part| part.finish(mesh, closed, &origins.next().unwrap_or_default())).collect();
        slabs
    }

    /// Converts the parts back from the frame, with the given points on the plane. `caps` are the numbers of the first
    /// corners of caps.
    fn restore(&mut self, mesh: &Mesh, met: &[DVec3], caps: [usize; 2], normal: DVec3) {
        let (parts, points) = (&mut self.state.parts, &self.state.points);
        let inside = points.places.iter().zip(&mesh.points).filter(|(place, _)| !place.class.is_on_plane());
        for (place, point) in inside {
            parts[place.class.slab() as usize].mesh.points[place.number as usize] = *point;
        }
        for (numbers, point) in points.levels[0].numbers.iter().zip(met) {
            for (part, number) in parts.iter_mut().zip(numbers) {
                // A part may lack some points on the plane.
                if *number != NONE {
                    part.mesh.points[*number as usize] = *point;
                }
            }
        }
        parts.iter_mut().for_each(|part| part.mesh.bent = mesh.bent);
        for ((part, caps), normal) in parts.iter_mut().zip(caps).zip([normal, -normal]) {
            part.mesh.normals.iter_mut().skip(caps).for_each(|own| *own = normal);
        }
    }
}
