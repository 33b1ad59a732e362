//! The usual events: an edge or a triangle shrinks to a point, or a vertex reaches an edge, with nothing else near. They
//! change the wavefront without lists of contacts, and in the same way as [`step`](super::step) does.

use glam::DVec2;

use super::event::Event;
use super::meeting::Meeting;
use super::overlap::short_end;
use super::wavefront::{Wavefront, turn_back};
use crate::each::Each;
use crate::nesting::extent::Extent;
use crate::small_sort::SmallSort;

/// The least sine of an angle between edges at a lone event.
const CLEAR: f64 = 1e-6;

impl Wavefront {
    /// Processes events at one place. Returns the new vertices; `None` if anything else may be in contact, or if edges of
    /// the place may touch each other. Then nothing has changed.
    pub(super) fn handle_lone(&mut self, events: &[Event]) -> Option<Vec<u32>> {
        // Where an edge shrinks to a point, a reflex end of it reaches the edge beyond its other end.
        let is_implied = |event: &Event| match *event {
            Event::Edge(_) => false,
            Event::Split(vertex, other) => events.iter().any(|event| {
                matches!(*event, Event::Edge(edge)
                    if [edge, self.next(edge)].contains(&vertex) && [self.last(edge), self.next(edge)].contains(&other))
            }),
        };
        let mut own = events.iter().filter(|event| !is_implied(event));
        match (*own.next()?, own.next()) {
            (Event::Edge(edge), None) => self.collapse_edge(edge),
            (Event::Edge(edge), Some(_)) => self.collapse_triangle(edge, events),
            (Event::Split(vertex, edge), None) => self.split_edge(vertex, edge),
            (Event::Split(..), Some(_)) => None,
        }
    }

    fn collapse_edge(&mut self, edge: u32) -> Option<Vec<u32>> {
        let next = self.next(edge);
        let (before, after) = (self.last(edge), self.next(next));
        if after == before || after == edge {
            return None;
        }
        let place = self.place_of(&[edge, next]);
        self.is_alone(&place, &[before, edge, next], &[before, after]).then_some(())?;
        self.is_apart(before, edge.min(next), after, [before, next]).then_some(())?;
        let node = self.end(&[edge.min(next), edge.max(next)]);
        let made = self.join(before, node, next, after);
        self.renew(&[made]);
        Some(vec![made])
    }

    fn collapse_triangle(&mut self, edge: u32, events: &[Event]) -> Option<Vec<u32>> {
        let mut corners = [edge, self.next(edge), self.next(self.next(edge))];
        let is_own = |event: &Event| match event {
            Event::Edge(edge) => corners.contains(edge),
            Event::Split(vertex, edge) => corners.contains(vertex) && corners.contains(edge),
        };
        if self.next(corners[2]) != edge || !events.iter().all(is_own) {
            return None;
        }
        self.is_alone(&self.place_of(&corners), &corners, &[]).then_some(())?;
        corners.small_sort();
        self.end(&corners);
        self.renew(&[]);
        Some(Vec::new())
    }

    fn split_edge(&mut self, vertex: u32, edge: u32) -> Option<Vec<u32>> {
        let (before, after, end) = (self.last(vertex), self.next(vertex), self.next(edge));
        if after == edge || before == end {
            return None;
        }
        self.is_alone(&self.place_of(&[vertex]), &[before, vertex, edge], &[before, after, edge, end]).then_some(())?;
        // From the edge to the left, the edges at the vertex leave in this order, so the region is between each of them and
        // the edge.
        let [along, back, on] = [self.line(edge).along, -self.line(before).along, self.line(vertex).along];
        let is_left = |a: DVec2, b: DVec2| CLEAR < a.perp_dot(b);
        let is_clear = is_left(along, back) && is_left(back, on) && is_left(on, -along);
        let is_apart = self.is_apart(before, vertex, after, [before, vertex])
            && self.is_apart(before, vertex, end, [before, edge])
            && self.is_apart(edge, vertex, after, [edge, vertex]);
        (is_clear && is_apart).then_some(())?;
        let node = self.end(&[vertex]);
        let made = if before < edge {
            let first = self.join(before, node, edge, end);
            [first, self.join(edge, node, vertex, after)]
        } else {
            let first = self.join(edge, node, vertex, after);
            [first, self.join(before, node, edge, end)]
        };
        self.renew(&made);
        Some(made.to_vec())
    }

    fn next(&self, vertex: u32) -> u32 {
        self.vertices[vertex as usize].next
    }

    fn last(&self, vertex: u32) -> u32 {
        self.vertices[vertex as usize].last
    }

    /// A box around everything that may be in contact with some vertices.
    fn place_of(&self, vertices: &[u32]) -> Extent {
        let Extent { low, high } = Extent::of(vertices.iter().map(|&vertex| self.positions[vertex as usize]));
        let margin = DVec2::splat(2.0 * self.epsilon);
        Extent { low: low - margin, high: high + margin }
    }

    /// Returns true if a place contains no edges except `own`, and none of the vertices `away`.
    fn is_alone(&self, place: &Extent, own: &[u32], away: &[u32]) -> bool {
        let is_off = |edge: u32| {
            let [a, b] = [edge, self.next(edge)].each(|vertex| self.positions[vertex as usize]);
            !(Extent { low: a.min(b), high: a.max(b) }).meets(place)
        };
        away.iter().all(|&vertex| !place.holds(self.positions[vertex as usize]))
            && self.alive.iter().all(|&edge| is_off(edge) || own.contains(&edge))
    }

    /// Returns true if the edges to a vertex from another one and from it to a third one do not touch each other. `edges` are
    /// their numbers.
    fn is_apart(&self, from: u32, here: u32, to: u32, edges: [u32; 2]) -> bool {
        let [far, here, end] = [from, here, to].each(|vertex| self.positions[vertex as usize]);
        let [a, b] = edges.each(|edge| self.line(edge));
        !turn_back(a, b) && short_end(far, here, end).is_none_or(|end| self.epsilon * self.epsilon < end.squared)
    }

    /// Ends vertices at a place where they meet, in their order. Returns its node.
    fn end(&mut self, vertices: &[u32]) -> u32 {
        let mut meeting = Meeting::default();
        vertices.iter().for_each(|&vertex| meeting.add(self, vertex));
        let node = meeting.node(self);
        vertices.iter().for_each(|&vertex| self.end_at(vertex, node));
        node
    }
}
