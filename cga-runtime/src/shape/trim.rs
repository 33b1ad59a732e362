//! Trim planes: the ends of geometry that is inserted at a face, so that it meets the geometry of the neighbouring
//! faces in a clean mitre (*comp operation*, trim planes; *trim attribute*).
//!
//! Each edge that a face shares with another face has a trim plane. It contains the edge and bisects the angle
//! between the two faces. Only planes with the whole face on their near side count: planes at reflex corners and at
//! holes would cut geometry above the face itself. (The planes of the reference have a limited extent instead, which
//! it does not specify.)
//!
//! A shape keeps its planes through all divisions, and `trim.vertical` and `trim.horizontal` switch them by the angle of
//! their edges with its pivot of that moment. So a plane that was upright for a face can be level for a part of it that lies
//! flat.
//!
//! Roofs of operations have planes between faces of one part alone: between two roof planes, or two upright sides.

use std::f64::consts::{FRAC_PI_2, TAU};
use std::sync::{Arc, OnceLock};

use glam::{DVec2, DVec3};

use crate::geometry::Frame;
use crate::geometry::each::Each;
use crate::geometry::hull::hull;
use crate::geometry::mesh::{Mesh, unit};
use crate::geometry::tol::{ANGLE_EPSILON, PLANAR_EPSILON};
use crate::geometry::triangulate::PlaneProjection;

/// A trim plane in the world.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct TrimPlane {
    /// A point of the plane.
    pub(crate) point: DVec3,
    /// The unit normal, towards the side that is kept.
    pub(crate) normal: DVec3,
    /// The unit direction of the edge that made the plane.
    pub(crate) along: DVec3,
}

/// The sine of 40 degrees. The planes of edges less steep than this above the pivot's xz plane are horizontal (*trim
/// attribute*).
const STEEP: f64 = 0.642_787_609_686_539_3;

impl TrimPlane {
    /// Returns true if `trim.horizontal` switches the plane for a shape with that pivot, and false if `trim.vertical` does.
    pub(crate) fn is_horizontal(&self, pivot: &Frame) -> bool {
        self.along.dot(pivot.axes.y_axis).abs() < STEEP - ANGLE_EPSILON
    }
}

/// The trim planes of a shape, made when they are needed.
#[derive(Clone, Debug, Default)]
pub(crate) enum Trims {
    #[default]
    None,
    /// The planes of a side of a box: a rectangle of that size at the pivot, with neighbours at right angles on its
    /// back.
    Side(DVec2),
    /// The planes of a face of a mesh.
    Face(Arc<Surface>, u32),
    /// The planes of a shape and the planes of a part of it.
    Joined(Arc<JoinedTrims>),
}

impl Trims {
    /// The planes for a shape with that pivot.
    pub(crate) fn planes(&self, pivot: &Frame) -> Arc<[TrimPlane]> {
        match self {
            Trims::None => Arc::default(),
            Trims::Side(size) => side(*size, pivot).into(),
            Trims::Face(surface, face) => surface.planes(*face),
            Trims::Joined(joined) => joined.planes.get_or_init(|| joined.find()).clone(),
        }
    }

    /// Joins these planes, of a shape with `pivot`, with `other`, of a shape with `other_pivot`.
    #[inline]
    pub(crate) fn with(&self, pivot: &Frame, other: Trims, other_pivot: &Frame) -> Trims {
        // A copy, so that the pivot of a shape without planes need not be in memory.
        if matches!(self, Trims::None) { other } else { self.joined(pivot, other, *other_pivot) }
    }

    #[cold]
    #[inline(never)]
    fn joined(&self, pivot: &Frame, other: Trims, other_pivot: Frame) -> Trims {
        if matches!(other, Trims::None) && (*pivot == other_pivot || !matches!(self, Trims::Side(_))) {
            // Only the planes of a side depend on the pivot.
            return self.clone();
        }
        let (whole, part) = ((self.clone(), *pivot), (other, other_pivot));
        Trims::Joined(Arc::new(JoinedTrims { whole, part, planes: OnceLock::new() }))
    }
}

/// The planes of a shape and the planes of a part of it. Parts of parts share the planes of the shape, so a recursive rule that divides
/// what is left adds no more than its own planes.
#[derive(Debug)]
pub(crate) struct JoinedTrims {
    /// The planes of the shape, with its pivot.
    whole: (Trims, Frame),
    /// The planes of the part, with its pivot.
    part: (Trims, Frame),
    /// All planes, made on first use.
    planes: OnceLock<Arc<[TrimPlane]>>,
}

impl JoinedTrims {
    /// The planes, with the planes of the outermost shape first. Rules may be nested so deeply that recursion would overflow the stack.
    fn find(&self) -> Arc<[TrimPlane]> {
        let (mut parts, mut joined) = (vec![&self.part], self);
        while let Trims::Joined(whole) = &joined.whole.0 {
            joined = whole;
            parts.push(&joined.part);
        }
        parts.push(&joined.whole);
        parts.iter().rev().flat_map(|(trims, pivot)| trims.planes(pivot).to_vec()).collect()
    }
}

impl Drop for JoinedTrims {
    fn drop(&mut self) {
        let mut next = std::mem::take(&mut self.whole.0);
        // Without recursion, as in `find`.
        while let Trims::Joined(joined) = next {
            let Some(mut last) = Arc::into_inner(joined) else { break };
            next = std::mem::take(&mut last.whole.0);
        }
    }
}

/// Two level planes and two upright ones, all leaning out by 45 degrees.
fn side(size: DVec2, pivot: &Frame) -> [TrimPlane; 4] {
    let [x, y, z] = [pivot.axes.x_axis, pivot.axes.y_axis, pivot.axes.z_axis];
    let far = pivot.origin + x * size.x + y * size.y;
    let plane = |point, inwards: DVec3, along| {
        // The kept side is inwards of the edge, and extends further inwards at the back of the face.
        TrimPlane { point, normal: (inwards + z).normalize(), along }
    };
    // Around the face from its first edge on.
    [plane(pivot.origin, y, x), plane(far, -x, y), plane(far, -y, x), plane(pivot.origin, x, y)]
}

/// A surface whose faces have become shapes.
#[derive(Debug)]
pub(crate) struct Surface {
    mesh: Arc<Mesh>,
    /// The frame of the mesh's coordinates.
    frame: Frame,
    /// The planes of each face, made on first use.
    planes: OnceLock<Vec<OnceLock<Arc<[TrimPlane]>>>>,
}

impl Surface {
    pub(crate) fn new(mesh: Arc<Mesh>, frame: Frame) -> Self {
        Surface { mesh, frame, planes: OnceLock::new() }
    }

    fn planes(&self, face: u32) -> Arc<[TrimPlane]> {
        let all = self.planes.get_or_init(|| vec![OnceLock::new(); self.mesh.face_count()]);
        all[face as usize].get_or_init(|| self.find(face as usize)).clone()
    }

    fn find(&self, index: usize) -> Arc<[TrimPlane]> {
        let (mesh, adjacency) = (&self.mesh, self.mesh.adjacency());
        let face = mesh.face(index);
        let normal = face.normal();
        if normal == DVec3::ZERO {
            return Arc::default();
        }
        let outline: Vec<DVec3> = face.outline().collect();
        let size = outline.iter().map(|p| (*p - outline[0]).abs().max_element()).fold(0.0, f64::max);
        let hull = Hull::of(outline.clone(), normal);
        let mut planes = Vec::new();
        for corner in face.corner_range() {
            let edge = adjacency.edge(corner as u32);
            let Some(other) = adjacency.faces_at(edge).find(|&other| other as usize != index) else { continue };
            let [part, other_part] = [index, other as usize].each(|face| roof_part(mesh, face));
            if part.is_some() && other_part.is_some() && part != other_part {
                continue;
            }
            let a = face.position(corner);
            let along = unit(face_end(mesh, corner) - a);
            let (out, inwards) = (normal + mesh.face(other as usize).normal(), normal.cross(along));
            let across = unit(along.cross(out));
            // A fold without an angle has no bisector.
            if along == DVec3::ZERO || out.length() <= ANGLE_EPSILON || across == DVec3::ZERO {
                continue;
            }
            let across = if across.dot(inwards) < 0.0 { -across } else { across };
            let flat = unit(inwards);
            if hull.right_of(along).any(|p| flat.dot(p - a) < -PLANAR_EPSILON * size) {
                continue;
            }
            let [normal, along] = [across, along].each(|way| self.frame.axes * way);
            planes.push(TrimPlane { point: self.frame.to_world(a), normal, along });
        }
        planes.into()
    }
}

/// The part of a roof that a face is, from its tag: `top`, `side` or `bottom`.
fn roof_part(mesh: &Mesh, face: usize) -> Option<&str> {
    let tags = mesh.face(face).tags()?;
    tags.names().iter().find_map(|name| name.strip_prefix("roof.")?.split('.').next())
}

fn face_end(mesh: &Mesh, corner: usize) -> DVec3 {
    let next = mesh.adjacency().next(corner as u32);
    mesh.points()[mesh.corners()[next as usize] as usize]
}

/// The convex hull of a polygon. Its corners decide on which side of a line the polygon is.
struct Hull {
    projection: PlaneProjection,
    /// The corners, counter-clockwise from the leftmost one.
    corners: Vec<DVec3>,
    /// The angles of the edges after the corners, in rising order.
    angles: Vec<f64>,
}

impl Hull {
    fn of(mut corners: Vec<DVec3>, normal: DVec3) -> Self {
        let projection = PlaneProjection::along(normal);
        hull(&mut corners, |&point| projection.apply(point));
        let ends = corners.iter().zip(corners.iter().cycle().skip(1));
        let angles = ends.map(|(a, b)| angle(projection.apply(*b) - projection.apply(*a))).collect();
        Hull { projection, corners, angles }
    }

    /// The corner that is farthest to the right of a direction, with its two neighbours, as rounding may swap them.
    fn right_of(&self, along: DVec3) -> impl Iterator<Item = DVec3> {
        let count = self.corners.len();
        let at = self.angles.partition_point(|&own| own < angle(self.projection.apply(along)));
        [at + count - 1, at, at + 1].into_iter().map(move |at| self.corners[at % count])
    }
}

/// The angle of a direction, from downwards (exclusive) to downwards (inclusive).
fn angle(along: DVec2) -> f64 {
    let angle = libm::atan2(along.y, along.x);
    if angle <= -FRAC_PI_2 { angle + TAU } else { angle }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_planes_of_deeply_nested_parts_need_no_stack() {
        let pivot = |depth: u32| Frame { origin: DVec3::X * f64::from(depth), ..Frame::WORLD };
        let mut trims = Trims::Side(DVec2::ONE);
        for depth in 1..100_000 {
            trims = trims.with(&pivot(depth - 1), Trims::Side(DVec2::ONE), &pivot(depth));
        }
        let planes = trims.planes(&pivot(99_999));
        assert_eq!(planes.len(), 400_000);
        // The outermost shape comes first.
        assert!(planes.chunks(4).zip(0..).all(|(side, depth)| side[0].point == pivot(depth).origin));
        assert!(Arc::ptr_eq(&planes, &trims.clone().planes(&pivot(0))));
    }
}
