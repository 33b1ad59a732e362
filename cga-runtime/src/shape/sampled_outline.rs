//! The outline of the initial shape, and the edge at which a part of a shape samples it.
//!
//! A part is projected on the outline, in the plane of the outline and in the direction in which the part faces. The edge that
//! is covered most wins, and of equal ones the first. An edge behind another one is not covered. Edges that face the other way
//! never count, and edges behind the part only where none is ahead. A part that faces nowhere in the plane samples the nearest
//! edge.

use std::collections::BTreeMap;

use glam::{DVec2, DVec3};

use crate::geometry::each::Each;
use crate::geometry::mesh::{Mesh, unit};
use crate::geometry::segment::nearest_share;
use crate::geometry::small_sort::SmallSort;
use crate::geometry::tol::{ANGLE_EPSILON, TIE_EPSILON};

/// The limit on edges of an outline, because each sample compares all of them.
const MOST_EDGES: usize = 5_000;

/// The outline of a mesh.
#[derive(Debug)]
pub(crate) struct SampledOutline {
    /// The axes of the plane of the outline.
    axes: [DVec3; 2],
    edges: Vec<OutlineEdge>,
    /// The largest extent of the outline.
    extent: f64,
}

/// An edge of the outline in its plane.
#[derive(Clone, Copy, Debug)]
struct OutlineEdge {
    ends: [DVec2; 2],
    /// The direction out of its face, of length 1.
    out: DVec2,
    /// The number of the edge among the edges of all faces.
    number: usize,
}

impl SampledOutline {
    /// The outline of the faces of a mesh: their edges without a neighbour. `None` if it has more than [`MOST_EDGES`] edges, or
    /// none.
    pub(crate) fn of(mesh: &Mesh, to_world: impl Fn(DVec3) -> DVec3) -> Option<Self> {
        let at = |corner: usize| to_world(mesh.points()[mesh.corners()[corner] as usize]);
        let normal_of = |corners: std::ops::Range<usize>| {
            let from = at(corners.start);
            corners.clone().skip(1).map(|c| (at(c - 1) - from).cross(at(c) - from)).sum::<DVec3>()
        };
        let normals: Vec<DVec3> = mesh.faces().map(|face| face.loop_ranges().map(normal_of).sum::<DVec3>()).collect();
        let up = unit(normals.iter().copied().sum());
        // The faces of a closed shape have no common plane.
        let up = if up == DVec3::ZERO || mesh.is_closed() { DVec3::Y } else { up };
        let (x, z) = up.any_orthonormal_pair();
        let axes = [x, z];
        let flat = |p: DVec3| DVec2::new(p.dot(axes[0]), p.dot(axes[1]));
        let adjacency = mesh.adjacency();
        let is_closed = mesh.is_closed();
        let mut edges = Vec::new();
        for face in mesh.faces() {
            for [from, to] in face.edges() {
                let [a, b] = [from, to].each(at);
                let out = flat(unit((b - a).cross(normals[face.index()]))).normalize_or_zero();
                let is_outline = is_closed || adjacency.is_border(adjacency.edge(from as u32));
                if is_outline && out != DVec2::ZERO && flat(a) != flat(b) {
                    edges.push(OutlineEdge { ends: [a, b].each(flat), out, number: from });
                }
            }
        }
        let points = || edges.iter().flat_map(|edge| edge.ends);
        let low = points().fold(DVec2::INFINITY, DVec2::min);
        let high = points().fold(DVec2::NEG_INFINITY, DVec2::max);
        let extent = (high - low).max_element();
        let is_usable = !edges.is_empty() && edges.len() <= MOST_EDGES && extent.is_finite();
        is_usable.then_some(SampledOutline { axes, edges, extent })
    }

    /// The number of the edge that a part samples: its points and the direction in which it faces, in the world.
    pub(crate) fn edge(&self, points: impl Iterator<Item = DVec3>, facing: DVec3) -> Option<usize> {
        let flat = |p: DVec3| DVec2::new(p.dot(self.axes[0]), p.dot(self.axes[1]));
        let points: Vec<DVec2> = points.map(flat).filter(|p| p.is_finite()).collect();
        if points.is_empty() {
            return None;
        }
        let middle = points.iter().sum::<DVec2>() / points.len() as f64;
        let ahead = flat(unit(facing));
        if ahead.length() <= TIE_EPSILON {
            return self.nearest(self.edges.iter(), middle);
        }
        let ahead = ahead.normalize();
        let across = ahead.perp();
        let places = points.iter().map(|p| p.dot(across));
        let (low, high) = places.fold((f64::INFINITY, f64::NEG_INFINITY), |(l, h), at| (l.min(at), h.max(at)));
        let facing: Vec<OutlineEdge> =
            self.edges.iter().filter(|edge| ANGLE_EPSILON < edge.out.dot(ahead)).copied().collect();
        let rays = Rays { edges: &facing, ahead, across, start: middle.dot(ahead), near: TIE_EPSILON * self.extent };
        let found = if high - low <= rays.near { rays.first(0.5 * (low + high)) } else { rays.most(low, high) };
        found.or_else(|| self.nearest(facing.iter(), middle)).or_else(|| self.nearest(self.edges.iter(), middle))
    }

    /// The number of the edge that is nearest to a place.
    fn nearest<'e>(&self, edges: impl Iterator<Item = &'e OutlineEdge>, place: DVec2) -> Option<usize> {
        let away = |edge: &OutlineEdge| {
            let [a, b] = edge.ends;
            a.lerp(b, nearest_share(place, edge.ends)).distance(place)
        };
        let mut best: Option<(f64, usize)> = None;
        for edge in edges {
            let away = away(edge);
            if best.is_none_or(|(least, _)| away < least - TIE_EPSILON * self.extent) {
                best = Some((away, edge.number));
            }
        }
        best.map(|(_, number)| number)
    }
}

/// Parallel rays that start on a line.
struct Rays<'e> {
    edges: &'e [OutlineEdge],
    ahead: DVec2,
    across: DVec2,
    /// The place along `ahead` where the rays start.
    start: f64,
    /// The distance below which places are equal.
    near: f64,
}

impl Rays<'_> {
    /// The places across the rays where an edge begins and ends.
    fn span(&self, edge: &OutlineEdge) -> [f64; 2] {
        let [a, b] = edge.ends.each(|end| end.dot(self.across));
        [a.min(b), a.max(b)]
    }

    /// The distance at which the ray at a place meets an edge; negative behind its start.
    fn distance(&self, edge: &OutlineEdge, at: f64) -> f64 {
        let [a, b] = edge.ends;
        let [s, t] = [a, b].each(|end| end.dot(self.across));
        let share = if s == t { 0.5 } else { ((at - s) / (t - s)).clamp(0.0, 1.0) };
        a.lerp(b, share).dot(self.ahead) - self.start
    }

    /// The number of the edge that the ray at a place meets first.
    fn first(&self, at: f64) -> Option<usize> {
        let met = self.edges.iter().filter(|edge| {
            let [low, high] = self.span(edge);
            low - self.near <= at && at <= high + self.near
        });
        self.first_of(met, at)
    }

    /// The number of the first of some edges that the ray at a place meets. Edges ahead come before those behind.
    fn first_of<'e>(&self, edges: impl Iterator<Item = &'e OutlineEdge>, at: f64) -> Option<usize> {
        let rank = |edge: &OutlineEdge| {
            let distance = self.distance(edge, at);
            if -self.near <= distance { (false, distance.max(0.0)) } else { (true, -distance) }
        };
        let mut best: Option<((bool, f64), usize)> = None;
        for edge in edges {
            let (is_behind, distance) = rank(edge);
            let is_better = best.is_none_or(|((was_behind, least), _)| {
                (is_behind, was_behind) == (false, true) || (is_behind == was_behind && distance < least - self.near)
            });
            if is_better {
                best = Some(((is_behind, distance), edge.number));
            }
        }
        best.map(|(_, number)| number)
    }

    /// The number of the edge that most rays between two places meet first.
    fn most(&self, low: f64, high: f64) -> Option<usize> {
        let mut met: Vec<(&OutlineEdge, [f64; 2])> = self
            .edges
            .iter()
            .map(|edge| (edge, self.span(edge)))
            .filter(|(_, [from, to])| *from < high && low < *to)
            .collect();
        met.small_sort_by(|a, b| a.1[0].total_cmp(&b.1[0]).then(a.0.number.cmp(&b.0.number)));
        let inside = |at: &f64| low < *at && *at < high;
        let mut stops: Vec<f64> = met.iter().flat_map(|(_, span)| *span).filter(inside).chain([low, high]).collect();
        stops.small_sort_by(f64::total_cmp);
        let mut covered: BTreeMap<usize, f64> = BTreeMap::new();
        let (mut next, mut active): (usize, Vec<(&OutlineEdge, [f64; 2])>) = (0, Vec::new());
        for pair in stops.windows(2) {
            let at = 0.5 * (pair[0] + pair[1]);
            while let Some(edge) = met.get(next).filter(|(_, span)| span[0] <= at) {
                active.push(*edge);
                next += 1;
            }
            active.retain(|(_, span)| at <= span[1]);
            if let Some(number) = self.first_of(active.iter().map(|(edge, _)| *edge), at) {
                *covered.entry(number).or_default() += pair[1] - pair[0];
            }
        }
        let mut best: Option<(f64, usize)> = None;
        for (number, length) in covered {
            if best.is_none_or(|(most, _)| most + self.near < length) {
                best = Some((length, number));
            }
        }
        best.map(|(_, number)| number)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn outline(corners: &[(f64, f64)], holes: &[Vec<(f64, f64)>]) -> SampledOutline {
        let ring = |ring: &[(f64, f64)]| ring.iter().map(|(x, z)| DVec3::new(*x, 0.0, -z)).collect::<Vec<_>>();
        let holes: Vec<Vec<DVec3>> = holes.iter().map(|hole| ring(hole)).collect();
        let mesh = Mesh::from_polygon(&ring(corners), &holes).unwrap();
        SampledOutline::of(&mesh, |p| p).unwrap()
    }

    fn at(outline: &SampledOutline, points: &[(f64, f64)], facing: (f64, f64)) -> Option<usize> {
        let place = |&(x, z): &(f64, f64)| DVec3::new(x, 1.0, -z);
        outline.edge(points.iter().map(place), DVec3::new(facing.0, 0.0, -facing.1))
    }

    #[test]
    fn a_part_samples_the_edge_that_it_faces() {
        let square = outline(&[(0.0, 0.0), (10.0, 0.0), (10.0, 10.0), (0.0, 10.0)], &[]);
        for (facing, edge) in [((0.0, -1.0), 0), ((1.0, 0.0), 1), ((0.0, 1.0), 2), ((-1.0, 0.0), 3)] {
            // A wall, a point, the edge itself, and a wall outside.
            let side = (facing.1, -facing.0);
            let wall =
                |far: f64| [-2.0, 2.0].map(|k| (5.0 + far * facing.0 + k * side.0, 5.0 + far * facing.1 + k * side.1));
            for far in [0.0, 3.0, 5.0, 7.0] {
                assert_eq!(at(&square, &wall(far), facing), Some(edge));
            }
            assert_eq!(at(&square, &[(5.0, 6.0)], facing), Some(edge));
        }
        // Askew: most of the wall faces edge 1.
        assert_eq!(at(&square, &[(8.0, 2.0), (9.0, 4.0)], (2.0, -1.0)), Some(1));
        // Upwards: the nearest edge.
        assert_eq!(square.edge([DVec3::new(9.0, 4.0, -5.0)].into_iter(), DVec3::Y), Some(1));
        assert_eq!(at(&square, &[], (1.0, 0.0)), None);
        assert_eq!(at(&square, &[(f64::NAN, 0.0)], (1.0, 0.0)), None);
        // A corner belongs to the first of both edges.
        assert_eq!(at(&square, &[(5.0, 5.0)], (1.0, -1.0)), Some(0));
    }

    #[test]
    fn nearer_edges_hide_farther_ones() {
        // A U that is open above, between x = 4 and 6.
        let u = [(0.0, 0.0), (10.0, 0.0), (10.0, 9.0), (6.0, 9.0), (6.0, 3.0), (4.0, 3.0), (4.0, 9.0), (0.0, 9.0)];
        let u = outline(&u, &[]);
        // In the left arm, to the right: its inner edge, not the outer one of the other arm.
        assert_eq!(at(&u, &[(2.0, 5.0), (2.0, 7.0)], (1.0, 0.0)), Some(5));
        // In the right arm: the outer edge, although an edge that faces there is behind.
        assert_eq!(at(&u, &[(7.0, 5.0), (7.0, 7.0)], (1.0, 0.0)), Some(1));
        // Most of it is over the base of the U.
        assert_eq!(at(&u, &[(2.0, 0.5), (2.0, 5.0)], (1.0, 0.0)), Some(1));
        assert_eq!(at(&u, &[(2.0, 1.5), (2.0, 5.0)], (1.0, 0.0)), Some(5));
    }

    #[test]
    fn holes_have_edges_too_and_outlines_may_stand_upright() {
        let square = [(0.0, 0.0), (10.0, 0.0), (10.0, 10.0), (0.0, 10.0)];
        let hole = vec![(4.0, 4.0), (4.0, 6.0), (6.0, 6.0), (6.0, 4.0)];
        let yard = outline(&square, &[hole]);
        assert_eq!(at(&yard, &[(2.0, 4.5), (2.0, 5.5)], (1.0, 0.0)), Some(4));
        let wall = Mesh::from_polygon(&[DVec3::ZERO, DVec3::X, DVec3::new(1.0, 1.0, 0.0), DVec3::Y], &[]).unwrap();
        let wall = SampledOutline::of(&wall, |p| p).unwrap();
        assert_eq!(wall.edge([DVec3::new(0.5, 0.5, 0.0)].into_iter(), DVec3::Y), Some(2));
    }

    #[test]
    fn a_closed_shape_is_seen_from_above() {
        let cube = crate::geometry::primitive::cube();
        let cube = SampledOutline::of(&cube, |p| p).unwrap();
        assert!(cube.edge([DVec3::splat(0.5)].into_iter(), DVec3::X).is_some());
        assert!(SampledOutline::of(&Mesh::default(), |p| p).is_none());
    }

    #[test]
    fn turning_everything_changes_nothing() {
        let corners = [(0.0, 0.0), (9.0, -1.0), (11.0, 6.0), (5.0, 4.0), (1.0, 8.0)];
        let parts: Vec<((f64, f64), (f64, f64))> = (0..40)
            .map(|k| {
                let (k, angle) = (f64::from(k), f64::from(k) * 0.7);
                ((2.0 + (k * 0.37) % 5.0, 1.0 + (k * 0.61) % 2.0), (libm::cos(angle), libm::sin(angle)))
            })
            .collect();
        let found = |turn: f64| -> Vec<Option<usize>> {
            let (sin, cos) = libm::sincos(turn);
            let turned = |(x, z): (f64, f64)| (x * cos - z * sin + 3.0 * turn, x * sin + z * cos);
            let corners: Vec<_> = corners.iter().map(|corner| turned(*corner)).collect();
            let outline = outline(&corners, &[]);
            let part = |&(p, facing): &((f64, f64), (f64, f64))| {
                let side = (-facing.1, facing.0);
                let ends = [-0.6, 0.4].map(|k| turned((p.0 + k * side.0, p.1 + k * side.1)));
                let zero = turned((0.0, 0.0));
                let way = turned(facing);
                at(&outline, &ends, (way.0 - zero.0, way.1 - zero.1))
            };
            parts.iter().map(part).collect()
        };
        let first = found(0.0);
        assert!(first.iter().all(Option::is_some));
        for turn in [0.3, 1.1, 2.5, 4.0] {
            assert_eq!(found(turn), first);
        }
    }
}
