//! Edges of a polygon that cross.

use robust::{Coord, orient2d};

use crate::outline::Corner;

/// An edge of a ring, with the numbers of the ring and of the edge.
#[derive(Clone, Copy)]
struct Edge {
    ring: usize,
    number: usize,
    from: Corner,
    to: Corner,
}

impl Edge {
    fn low(&self, axis: usize) -> f64 {
        self.from[axis].min(self.to[axis])
    }

    fn high(&self, axis: usize) -> f64 {
        self.from[axis].max(self.to[axis])
    }
}

/// A place where two edges of the rings cross or run along each other. Rings may touch at corners. Signs are exact.
pub(super) fn crossing(rings: &[Vec<Corner>]) -> Option<Corner> {
    let edge = |(ring, number): (usize, usize)| {
        let corners = &rings[ring];
        Edge { ring, number, from: corners[number], to: corners[(number + 1) % corners.len()] }
    };
    let numbers =
        rings.iter().enumerate().flat_map(|(ring, corners)| (0..corners.len()).map(move |number| (ring, number)));
    let mut edges: Vec<Edge> = numbers.map(edge).collect();
    edges.sort_by(|a, b| a.low(0).total_cmp(&b.low(0)));
    for (at, edge) in edges.iter().enumerate() {
        let near = edges[at + 1..].iter().take_while(|other| other.low(0) <= edge.high(0));
        let mut near = near.filter(|other| edge.low(1) <= other.high(1) && other.low(1) <= edge.high(1));
        if let Some(other) = near.find(|other| cross(edge, other, rings[edge.ring].len())) {
            return Some(other.from);
        }
    }
    None
}

fn cross(a: &Edge, b: &Edge, count: usize) -> bool {
    let sides = [side(a, b.from), side(a, b.to), side(b, a.from), side(b, a.to)];
    if sides == [0.0; 4] {
        return overlap(a, b);
    }
    let is_neighbour = a.ring == b.ring && ((a.number + 1) % count == b.number || (b.number + 1) % count == a.number);
    !is_neighbour && sides[0] * sides[1] < 0.0 && sides[2] * sides[3] < 0.0
}

/// The sign of the side of an edge on which a point is.
fn side(edge: &Edge, point: Corner) -> f64 {
    let coord = |[x, y]: Corner| Coord { x, y };
    let turn = orient2d(coord(edge.from), coord(edge.to), coord(point));
    if turn == 0.0 { 0.0 } else { turn.signum() }
}

/// Returns true if two edges on one line have more than a point in common.
fn overlap(a: &Edge, b: &Edge) -> bool {
    let axis = usize::from((a.high(0) - a.low(0)) < (a.high(1) - a.low(1)));
    a.low(axis).max(b.low(axis)) < a.high(axis).min(b.high(axis))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn crossing_edges_are_found() {
        let bow: Vec<Corner> = vec![[0.0, 0.0], [2.0, 2.0], [2.0, 0.0], [0.0, 1.0]];
        assert!(crossing(&[bow]).is_some());
        let spike: Vec<Corner> = vec![[0.0, 0.0], [4.0, 0.0], [2.0, 0.0], [2.0, 2.0]];
        assert!(crossing(&[spike]).is_some());
        let square = |low: f64, high: f64| vec![[low, low], [high, low], [high, high], [low, high]];
        assert!(crossing(&[square(0.0, 4.0), square(3.0, 5.0)]).is_some());
    }

    #[test]
    fn simple_polygons_have_no_crossing() {
        let square = |low: f64, high: f64| vec![[low, low], [high, low], [high, high], [low, high]];
        assert_eq!(crossing(&[square(0.0, 4.0)]), None);
        assert_eq!(crossing(&[square(0.0, 4.0), square(1.0, 2.0), square(2.0, 3.0)]), None);
        let ell: Vec<Corner> = vec![[0.0, 0.0], [4.0, 0.0], [4.0, 1.0], [1.0, 1.0], [1.0, 3.0], [0.0, 3.0]];
        assert_eq!(crossing(&[ell]), None);
    }
}
