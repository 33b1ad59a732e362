//! Faces that would cross themselves if points are merged.

use glam::{DVec2, DVec3};

use crate::geometry::exact::orient;
use crate::geometry::mesh::Mesh;
use crate::geometry::triangulate::PlaneProjection;

/// The limit on pairs of edges of a face that are compared. Further edges of larger faces count as apart.
const MOST_PAIRS: usize = 1 << 22;

/// Points to which more loops lead are not compared.
const MOST_PASSAGES: usize = 16;

/// Returns true if two edges of a face cross or touch each other elsewhere than at a common point when its points are at their
/// targets, and do not yet. `after` is the direction of the face then, which may be bent.
pub(super) fn will_cross(mesh: &Mesh, face: usize, targets: &[u32], after: DVec3) -> bool {
    let face = mesh.face(face);
    let target = |point: u32| targets[point as usize];
    let corners = &mesh.corners[face.corner_range()];
    if face.normal() == DVec3::ZERO || after == DVec3::ZERO || corners.iter().all(|&point| target(point) == point) {
        return false;
    }
    let planes = [face.normal(), after].map(PlaneProjection::along);
    let cross = |plane: &PlaneProjection, [a, b]: [u32; 2], [c, d]: [u32; 2]| {
        if a == c || a == d || b == c || b == d {
            return false;
        }
        let [a, b, c, d] = [a, b, c, d].map(|point| plane.apply(mesh.points[point as usize]));
        let overlap = a.min(b).cmple(c.max(d)).all() && c.min(d).cmple(a.max(b)).all();
        overlap && orient(a, b, c) * orient(a, b, d) <= 0 && orient(c, d, a) * orient(c, d, b) <= 0
    };
    let edges: Vec<[u32; 2]> = face.edges().map(|edge| edge.map(|corner| mesh.corners[corner])).collect();
    let most = MOST_PAIRS / edges.len();
    let mut moved = edges.iter().copied().filter(|edge| edge.map(target) != *edge).take(most);
    let crosses = |edge: [u32; 2]| {
        let now = edge.map(target);
        let crosses = |other: [u32; 2]| cross(&planes[1], now, other.map(target)) && !cross(&planes[0], edge, other);
        now[0] != now[1] && edges.iter().any(|&other| crosses(other))
    };
    moved.any(crosses)
        || will_cross_at_points(face.loops(), target, |point| planes[1].apply(mesh.points[point as usize]))
}

/// A way of a loop through a point.
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
    passages.sort_by_key(|passage| passage.at);
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
