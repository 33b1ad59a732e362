//! Concave faces cut into convex ones.
//!
//! All faces are loops of linked corners (`net`). A concave face, or one with holes, is cut in its plane projection
//! (`cutter`), where the sides of lines are exact. New points are on edges, which they divide in all faces, so faces stay
//! connected and a closed mesh stays closed. Bent faces keep their bend. Faces with touching loops, which cuts may fail to divide,
//! are divided along diagonals (`triangles`).

mod cutter;
mod net;
mod obstacles;
mod plane;
mod rings;
mod touching;
mod triangles;
mod turn;

#[cfg(test)]
mod hostile_tests;
#[cfg(test)]
mod tests;

use std::borrow::Cow;

use glam::DVec3;

use crate::derive::{CornerValues, Derivation, FaceOrigin, Mix};
use crate::mesh::{FaceRef, Mesh};
use crate::origin::PointOrigin;
use crate::unbent::without_bent_faces;
use crate::work;
use cutter::Cutter;
use net::Net;
use plane::Plane;
use rings::{Part, Rings};
use touching::Relinked;

/// The result of cutting all faces.
pub struct Convexified {
    /// The mesh, and the origins of its points if the old mesh has values, tags or a trace; `None` if no face was cut.
    pub made: Option<(Mesh, Vec<PointOrigin>)>,
    /// The faces that stay concave because they cross or touch themselves.
    pub refused: Vec<usize>,
}

/// Cuts all concave faces and faces with holes into convex ones, with cuts shorter than `longest`. Faces that are convex stay as
/// they are, and bent faces become triangles. Parts of a face come in its place, in the order of its corners, and begin with
/// its edges. They keep its attributes; values at new corners are interpolated along edges.
///
/// `longest` is in metres. With an infinite length all parts are convex; with 0 or less nothing is cut.
///
/// ```
/// use cga_geometry::convexify::convexify;
/// use cga_geometry::mesh::MeshBuilder;
///
/// // An L: two rectangles.
/// let mut builder = MeshBuilder::new();
/// let l = [[0.0, 0.0], [2.0, 0.0], [2.0, 1.0], [1.0, 1.0], [1.0, 2.0], [0.0, 2.0]];
/// let corners = l.map(|[x, y]| builder.point([x, y, 0.0]));
/// builder.polygon(&corners);
/// let (parts, _) = convexify(&builder.build()?, f64::INFINITY).made.unwrap();
/// assert_eq!((parts.face_count(), parts.area()), (2, 3.0));
/// # Ok::<(), cga_geometry::mesh::MeshError>(())
/// ```
pub fn convexify(mesh: &Mesh, longest: f64) -> Convexified {
    if let Cow::Owned(flat) = without_bent_faces(mesh) {
        let cut = convexify(&flat, longest);
        let origins = || (0..flat.points.len() as u32).map(PointOrigin::Old).collect();
        return Convexified { made: cut.made.or_else(|| Some((flat.clone(), origins()))), ..cut };
    }
    let none = || Convexified { made: None, refused: Vec::new() };
    let is_cut = |face: &FaceRef<'_>| work::spend(CORNER * face.corner_count()) && is_concave(face);
    let concave: Vec<usize> = mesh.faces().filter(is_cut).map(|face| face.index()).collect();
    if concave.is_empty() || longest <= 0.0 || mesh.adjacency_in_time().is_none() {
        return none();
    }
    let mut net = Net::of(mesh);
    let mut refused = Vec::new();
    let mut parts: Vec<Vec<Part>> = Vec::with_capacity(concave.len());
    for &number in &concave {
        let face = mesh.face(number);
        if !work::spend(CORNER * face.corner_count()) {
            return none();
        }
        let heads: Vec<u32> = face.loop_ranges().map(|ring| ring.start as u32).collect();
        let plane = Plane::of(face.normal(), face.corner_range().map(|corner| face.position(corner)));
        parts.push(divide(&mut net, &heads, plane, longest).unwrap_or_else(|| {
            refused.push(number);
            vec![heads]
        }));
    }
    let is_cut = parts.iter().any(|parts| 1 < parts.len());
    Convexified { made: is_cut.then(|| assembled(&net, &concave, &parts)), refused }
}

/// The units of work of a corner.
const CORNER: usize = 8;

/// The mesh with the parts of its concave faces, and the origins of its points. Empty if the work is to end.
fn assembled(net: &Net, concave: &[usize], parts: &[Vec<Part>]) -> (Mesh, Vec<PointOrigin>) {
    let mesh = &net.pool;
    let mut made = Derivation::new(mesh, CornerValues::All, net.corner_count()).without_trace();
    for (point, &at) in (0..).zip(mesh.points()) {
        made.point(at, net.origin(point));
    }
    let mut cut = concave.iter().zip(parts).peekable();
    for face in mesh.faces() {
        if !work::spend(CORNER * face.corner_count()) {
            break;
        }
        let whole = || vec![face.loop_ranges().map(|ring| ring.start as u32).collect()];
        let parts = cut.next_if(|(number, _)| **number == face.index());
        for part in parts.map_or_else(whole, |(_, parts)| parts.clone()) {
            for head in part {
                net.ring(head).for_each(|corner| made.corner(net.point(corner), &Mix::One(corner), false));
                made.end_loop();
            }
            made.end_face(FaceOrigin::piece(&face));
        }
    }
    made.finish_with_origins()
}

/// Returns true for a face with an area that has holes or is not convex, where corners that are straight except for rounding
/// count as convex.
fn is_concave(face: &FaceRef<'_>) -> bool {
    let normal = face.normal();
    if normal == DVec3::ZERO || face.corner_count() == 3 {
        return false;
    }
    if face.holes().len() != 0 {
        return true;
    }
    let plane = Plane::of(normal, face.outline());
    !face.is_convex() && !turn::is_convex(&face.outline().map(|point| plane.place(point)).collect::<Vec<_>>())
}

fn is_convex_part(net: &Net, heads: &[u32], plane: &Plane) -> bool {
    heads.iter().all(|&head| plane.is_convex_part(net, &net.ring(head).collect::<Vec<_>>()))
}

/// Divides a face. `None`, and the face is as it was, if that is not possible.
fn divide(net: &mut Net, heads: &[u32], plane: Plane, longest: f64) -> Option<Vec<Part>> {
    // Parts that may stay concave do not show that the face crosses itself; convex ones do.
    let is_limited = longest != f64::INFINITY;
    if is_limited && !triangles::fill(net, heads, &plane) {
        return None;
    }
    let own: Vec<u32> = heads.iter().flat_map(|&head| net.ring(head)).collect();
    let flat = |net: &Net, corner: u32| plane.flat(net, corner);
    net.mark();
    let relinked = Relinked::at_points(net, &own, flat);
    let mut cutter = Cutter::new(net, &own, plane, longest);
    let is_done = cutter.cut();
    let corners = std::mem::take(&mut cutter.corners);
    let parts = is_done
        .then(|| Rings::of(net, &corners, flat))
        .and_then(|rings| if is_limited { rings.parts() } else { rings.convex_parts() })
        .filter(|parts| parts.iter().all(|heads| heads.len() == 1 || triangles::fill(net, heads, &plane)))
        .filter(|parts| is_limited || parts.iter().all(|heads| is_convex_part(net, heads, &plane)));
    match parts {
        Some(parts) if 1 < parts.len() => return Some(parts),
        Some(_) => {}
        None => {
            let halves = corners.iter().copied().filter(|&half| net.is_cut(half) && half < net.mate(half));
            let cuts: Vec<u32> = halves.filter(|&half| net.is_alive(half)).collect();
            cuts.into_iter().for_each(|half| net.remove(half));
            net.join_divided();
        }
    }
    relinked.undo(net);
    match parts {
        Some(_) => Some(vec![heads.to_vec()]),
        None if is_limited => None,
        None => triangles::divide(net, heads, &plane),
    }
}
