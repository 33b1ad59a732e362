//! The directions of components as seen from the streets at the initial shape (*comp operation*, street selectors).
//!
//! Edges with a street are the front. The other edges are sorted by their outward direction, compared with the front
//! as a whole: back within 45 degrees, otherwise left or right. A component gets the class of the edge with the most
//! similar direction; of equal edges, the nearest. The reference only shows pictures of lots.

use glam::DVec3;

use crate::geometry::mesh::{FaceRef, unit};
use crate::geometry::tol::ANGLE_EPSILON;
use crate::shape::direction::Direction;

/// The edges of a lot with their classes, in the world.
#[derive(Clone, Debug)]
pub(crate) struct Streets {
    up: DVec3,
    edges: Vec<LotEdge>,
}

#[derive(Clone, Debug)]
struct LotEdge {
    middle: DVec3,
    /// The outward direction.
    out: DVec3,
    class: Direction,
}

impl Streets {
    /// The streets of the outline of a face. `widths` has the width of the street at each edge, 0 for none. `None` if
    /// no edge has a street.
    pub(crate) fn of(face: &FaceRef<'_>, widths: &[f64], to_world: impl Fn(DVec3) -> DVec3) -> Option<Self> {
        let ring: Vec<DVec3> = face.outline().map(to_world).collect();
        let from = ring[0];
        let area = (1..ring.len()).map(|i| (ring[i - 1] - from).cross(ring[i] - from)).sum();
        let up = unit(area);
        let edge = |i: usize| {
            let (a, b) = (ring[i], ring[(i + 1) % ring.len()]);
            let out = unit((b - a).cross(up));
            (out != DVec3::ZERO).then_some((i, (a + b) * 0.5, out, (b - a).length()))
        };
        let edges: Vec<_> = (0..ring.len()).filter_map(edge).collect();
        let is_street = |i: usize| widths.get(i).is_some_and(|&width| 0.0 < width);
        let streets = || edges.iter().filter(|(i, ..)| is_street(*i));
        let first = streets().next()?.2;
        let sum: DVec3 = streets().map(|(_, _, out, length)| *out * *length).sum();
        // Streets on opposite sides have no common front; the first street decides.
        let whole: f64 = streets().map(|(.., length)| length).sum();
        let front = if sum.length() <= ANGLE_EPSILON * whole { first } else { unit(sum) };
        let right = up.cross(front);
        let class = |i: usize, out: DVec3| {
            let (ahead, aside) = (out.dot(front), out.dot(right));
            match () {
                () if is_street(i) => Direction::Front,
                () if aside.abs() <= -ahead => Direction::Back,
                () if 0.0 < aside => Direction::Right,
                () => Direction::Left,
            }
        };
        let edges = edges.iter().map(|&(i, middle, out, _)| LotEdge { middle, out, class: class(i, out) });
        Some(Streets { up, edges: edges.collect() })
    }

    /// Returns true if a component at `at` with the unit normal `normal` is in a class.
    pub(crate) fn takes(&self, direction: Direction, normal: DVec3, at: DVec3) -> bool {
        let level = unit(normal - self.up * normal.dot(self.up));
        // A component with an upright normal faces no street.
        if normal.cross(self.up).length() <= ANGLE_EPSILON {
            return false;
        }
        let best = self.edges.iter().map(|edge| edge.out.dot(level)).fold(f64::NEG_INFINITY, f64::max);
        let alike = self.edges.iter().filter(|edge| best - ANGLE_EPSILON <= edge.out.dot(level));
        let nearest = alike.min_by(|a, b| a.middle.distance_squared(at).total_cmp(&b.middle.distance_squared(at)));
        nearest.is_some_and(|edge| match direction {
            Direction::Side => matches!(edge.class, Direction::Left | Direction::Right),
            _ => edge.class == direction,
        })
    }
}
