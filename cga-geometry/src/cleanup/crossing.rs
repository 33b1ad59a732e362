//! Faces that would cross themselves if points are merged.

use glam::{DVec2, DVec3};

use crate::each::Each;
use crate::exact::orient;
use crate::mesh::{Mesh, unit};
use crate::nesting::extent::Extent;
use crate::small_sort::SmallSort;
use crate::tol::TOUCH_EPSILON;
use crate::triangulate::{PlaneProjection, filling, is_filled};
use crate::work;

/// The limit on pairs of edges of a face that are compared. Further edges of larger faces count as apart.
const MOST_PAIRS: usize = 1 << 22;

/// Points to which more loops lead are not compared.
const MOST_PASSAGES: usize = 16;

/// Returns true if a face turns over, crosses itself, or leaves a hole outside when its points are at their targets, and does not
/// yet.
pub(super) fn will_break(mesh: &Mesh, face: usize, targets: &[u32]) -> bool {
    if mesh.corners[mesh.face_corners(face)].iter().all(|&point| targets[point as usize] == point) {
        return false;
    }
    let (before, after) = (mesh.face(face).area_vector(), area_after(mesh, face, targets));
    before.dot(after) < 0.0
        || (before != DVec3::ZERO
            && after != DVec3::ZERO
            && will_cross(mesh, face, targets, [before, after].each(unit)))
}

/// The area vector of a face whose points are at the places of their targets.
fn area_after(mesh: &Mesh, face: usize, targets: &[u32]) -> DVec3 {
    let at = |corner: usize| mesh.points[targets[mesh.corners[corner] as usize] as usize];
    let face = mesh.face(face);
    let from = at(face.corner_range().start);
    face.edges().map(|[a, b]| (at(a) - from).cross(at(b) - from)).sum()
}

/// Returns true if two edges of a face cross or touch each other elsewhere than at a common point when its points are at their
/// targets, and do not yet, or if its holes are not inside of it then. The normals are those before and then: the face may be bent.
fn will_cross(mesh: &Mesh, face: usize, targets: &[u32], normals: [DVec3; 2]) -> bool {
    let face = mesh.face(face);
    let target = |point: u32| targets[point as usize];
    let planes = normals.each(PlaneProjection::along);
    let cross = |plane: &PlaneProjection, [a, b]: [u32; 2], [c, d]: [u32; 2]| {
        if a == c || a == d || b == c || b == d {
            return false;
        }
        let [a, b, c, d] = [a, b, c, d].each(|point| plane.apply(mesh.points[point as usize]));
        let overlap = a.min(b).cmple(c.max(d)).all() && c.min(d).cmple(a.max(b)).all();
        overlap && orient(a, b, c) * orient(a, b, d) <= 0 && orient(c, d, a) * orient(c, d, b) <= 0
    };
    let edges: Vec<[u32; 2]> = face.edges().map(|edge| edge.each(|corner| mesh.corners[corner])).collect();
    let most = MOST_PAIRS / edges.len();
    let mut moved = edges.iter().copied().filter(|edge| edge.each(target) != *edge).take(most);
    let crosses = |edge: [u32; 2]| {
        let now = edge.each(target);
        let crosses = |other: [u32; 2]| cross(&planes[1], now, other.each(target)) && !cross(&planes[0], edge, other);
        now[0] != now[1] && edges.iter().any(|&other| crosses(other))
    };
    // If work is to end, no edge may move.
    moved.any(|edge| !work::spend(edges.len()) || crosses(edge))
        || will_cross_at_points(face.loops(), target, |point| planes[1].apply(mesh.points[point as usize]))
        || (face.holes().len() != 0
            && is_filled(&flat(mesh, face.loops(), planes[0]))
            && !is_filled(&flat(
                mesh,
                face.loops().map(|ring| ring.iter().map(|&point| target(point)).collect::<Vec<_>>()),
                planes[1],
            )))
}

/// The loops of points in a plane.
fn flat<R: AsRef<[u32]>>(mesh: &Mesh, loops: impl Iterator<Item = R>, plane: PlaneProjection) -> Vec<Vec<DVec2>> {
    let flat = |ring: R| ring.as_ref().iter().map(|&point| plane.apply(mesh.points[point as usize])).collect();
    loops.map(flat).collect()
}

/// Returns true if loops of points are a face with this normal that does not cross itself, is not above itself, and has its holes
/// inside of it, except for rounding.
pub(super) fn is_simple(mesh: &Mesh, loops: &[Vec<u32>], normal: DVec3) -> bool {
    let loops = flat(mesh, loops.iter(), PlaneProjection::along(normal));
    let edges: Vec<[DVec2; 2]> =
        loops.iter().flat_map(|ring| (0..ring.len()).map(|k| [ring[k], ring[(k + 1) % ring.len()]])).collect();
    let Extent { low, high } = Extent::of(edges.iter().map(|edge| edge[0]));
    let near = TOUCH_EPSILON * (high - low).max_element();
    // The ends of an edge are on both sides of a line, and not near it.
    let is_across = |[a, b]: [DVec2; 2], ends: [DVec2; 2]| {
        let [from, to] = ends.each(|end| (b - a).perp_dot(end - a) / (b - a).length());
        from < -near && near < to || to < -near && near < from
    };
    let crosses = |one: [DVec2; 2], other: [DVec2; 2]| {
        let [[a, b], [c, d]] = [one, other];
        let overlap = a.min(b).cmple(c.max(d)).all() && c.min(d).cmple(a.max(b)).all();
        overlap && is_across(one, other) && is_across(other, one)
    };
    // The number of times that the loops wind around a point.
    let winding = |point: DVec2| -> i32 {
        let steps = edges.iter().map(|&[a, b]| match (a.y <= point.y, b.y <= point.y) {
            (true, false) => i32::from(0 < orient(a, b, point)),
            (false, true) => -i32::from(orient(a, b, point) < 0),
            _ => 0,
        });
        steps.sum()
    };
    let most = MOST_PAIRS / edges.len();
    let is_single = |triangle: &[DVec2; 3]| winding(triangle.iter().sum::<DVec2>() / 3.0) <= 1;
    !edges.iter().take(most).any(|&one| edges.iter().any(|&other| crosses(one, other)))
        && filling(&loops).is_some_and(|triangles| triangles.iter().take(most).all(is_single))
}

/// A way of a loop through a point.
#[derive(Clone, Copy)]
struct Passage {
    /// The point, and the one that it was.
    at: u32,
    was: u32,
    before: u32,
    after: u32,
}

/// Returns true if loops cross at a point that two points have become.
fn will_cross_at_points<'m>(
    loops: impl Iterator<Item = &'m [u32]>,
    target: impl Fn(u32) -> u32,
    flat: impl Fn(u32) -> DVec2,
) -> bool {
    let mut passages = Vec::new();
    for ring in loops {
        let mut ring: Vec<u32> = ring.to_vec();
        ring.dedup_by_key(|point| target(*point));
        while 1 < ring.len() && target(ring[0]) == target(ring[ring.len() - 1]) {
            ring.pop();
        }
        let count = ring.len();
        let near = |place: usize| target(ring[place % count]);
        passages.extend((0..count).map(|k| Passage {
            at: near(k),
            was: ring[k],
            before: near(k + count - 1),
            after: near(k + 1),
        }));
    }
    passages.small_sort_by_key(|passage| passage.at);
    let cross = |one: &Passage, other: &Passage| {
        let [centre, a, b, c, d] = [one.at, one.before, one.after, other.before, other.after].map(&flat);
        one.was != other.was && do_cross(centre, [a, b], [c, d])
    };
    let mut groups = passages.chunk_by(|a, b| a.at == b.at).filter(|group| group.len() <= MOST_PASSAGES);
    groups.any(|group| (1..group.len()).any(|k| group[..k].iter().any(|one| cross(one, &group[k]))))
}

/// Returns true if two ways through a point cross there: the ends of one are on both sides of the other.
fn do_cross(centre: DVec2, [a, b]: [DVec2; 2], other: [DVec2; 2]) -> bool {
    let is_along = |end: DVec2, way: DVec2| orient(centre, way, end) == 0 && 0.0 < (end - centre).dot(way - centre);
    if [a, b].into_iter().any(|way| other.iter().any(|&end| is_along(end, way))) {
        return false;
    }
    let is_wide = orient(centre, a, b) < 0;
    let is_left = |end: DVec2| {
        let (from, to) = (0 < orient(centre, a, end), 0 < orient(centre, end, b));
        if is_wide { from || to } else { from && to }
    };
    is_left(other[0]) != is_left(other[1])
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn ways_through_a_point_cross_or_touch() {
        let at = |degrees: f64| {
            let (sin, cos) = libm::sincos(degrees.to_radians());
            DVec2::new(cos, sin)
        };
        let crosses = |angles: [f64; 4]| {
            let [a, b, c, d] = angles.map(at);
            do_cross(DVec2::ZERO, [a, b], [c, d])
        };
        assert!(crosses([180.0, 0.0, 90.0, 270.0]) && crosses([0.0, 90.0, 45.0, 200.0]));
        assert!(crosses([90.0, 0.0, 45.0, 200.0]) && !crosses([0.0, 90.0, 30.0, 60.0]));
        assert!(!crosses([90.0, 0.0, 100.0, 350.0]) && !crosses([0.0, 90.0, 90.0, 200.0]));
    }
}
