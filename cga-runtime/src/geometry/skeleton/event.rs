//! The times of events: an edge shrinks to a point, or a reflex vertex reaches an edge.

use super::Failure;
use super::wavefront::{NONE, SplitEvent, Wavefront};

/// An event at the current time, up to rounding.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Event {
    /// An edge has shrunk to a point.
    Edge(u32),
    /// A vertex has reached an edge.
    Split(u32, u32),
}

/// The speed below which two objects count as not approaching.
const SLOWEST: f64 = 1e-12;

impl Wavefront {
    /// The time of the next event; infinity if there is none.
    pub(super) fn next_event(&mut self) -> f64 {
        let time = |front: &Self, vertex: u32| {
            let vertex = &front.vertices[vertex as usize];
            vertex.collapse.min(vertex.split.time)
        };
        loop {
            let next = self.alive.iter().fold(f64::INFINITY, |next, &vertex| next.min(time(self, vertex)));
            let soon = next + self.epsilon;
            let is_due = |vertex: &u32| {
                let split = &self.vertices[*vertex as usize].split;
                split.is_open() && split.time <= soon
            };
            let open: Vec<u32> = self.alive.iter().copied().filter(is_due).collect();
            if open.is_empty() {
                return next;
            }
            for vertex in open {
                self.vertices[vertex as usize].split = self.first_split(vertex, SplitEvent::NEVER, &self.alive);
            }
        }
    }

    /// The events at the current time, including those so close that they count as contacts.
    pub(super) fn due(&self) -> Vec<Event> {
        let mut due = Vec::new();
        for &number in &self.alive {
            let vertex = &self.vertices[number as usize];
            if vertex.collapse <= self.now || (vertex.collapse.is_finite() && self.length(number) <= self.epsilon) {
                due.push(Event::Edge(number));
            }
            let split = vertex.split;
            if split.edge != NONE
                && (split.time <= self.now || self.height(number, split.edge, self.now) <= self.epsilon)
            {
                due.push(Event::Split(number, split.edge));
            }
        }
        due
    }

    /// Computes the next events after the given vertices were made. An error if one of them cannot move.
    pub(super) fn foresee(&mut self, made: &[u32]) -> Result<(), Failure> {
        if made.iter().any(|&vertex| self.vertices[vertex as usize].stuck) {
            return Err(Failure::Tangled);
        }
        let mut changed: Vec<u32> = made.iter().flat_map(|&v| [v, self.vertices[v as usize].last]).collect();
        changed.sort_unstable();
        changed.dedup();
        for &edge in &changed {
            self.vertices[edge as usize].collapse = self.collapse(edge);
        }
        let mut is_changed = vec![false; self.vertices.len()];
        changed.iter().for_each(|&edge| is_changed[edge as usize] = true);
        for index in 0..self.alive.len() {
            let number = self.alive[index];
            let vertex = &self.vertices[number as usize];
            if !vertex.reflex {
                continue;
            }
            let mut split = vertex.split;
            self.vertices[number as usize].split = if vertex.born == self.now {
                self.first_split(number, SplitEvent::NEVER, &self.alive)
            } else {
                let edge = split.edge as usize;
                if split.edge != NONE && (!self.vertices[edge].alive || is_changed[edge]) {
                    // Other edges are not reached before the time of that edge.
                    split.edge = NONE;
                }
                self.first_split(number, split, &changed)
            };
        }
        Ok(())
    }

    /// The current length of an edge along its line.
    fn length(&self, edge: u32) -> f64 {
        let start = &self.vertices[edge as usize];
        let along = self.lines[start.after as usize].along;
        along.dot(self.at(start.next, self.now) - self.at(edge, self.now))
    }

    fn collapse(&self, edge: u32) -> f64 {
        let start = &self.vertices[edge as usize];
        let along = self.lines[start.after as usize].along;
        let closing = along.dot(start.velocity - self.vertices[start.next as usize].velocity);
        if closing <= SLOWEST {
            return f64::INFINITY;
        }
        self.now + self.length(edge).max(0.0) / closing
    }

    /// The distance of a vertex in front of the line of an edge.
    fn height(&self, vertex: u32, edge: u32, time: f64) -> f64 {
        self.lines[self.vertices[edge as usize].after as usize].height(self.at(vertex, time), time)
    }

    /// The first of some edges that a vertex reaches, if that is before the known split. If the known split is open,
    /// equal times count too, because the edge may be another part of the known one.
    fn first_split(&self, vertex: u32, known: SplitEvent, edges: &[u32]) -> SplitEvent {
        let mut split = known;
        for &edge in edges {
            if let Some(time) = self.reach(vertex, edge, split) {
                split = SplitEvent { time, edge };
            }
        }
        split
    }

    /// The time when a vertex reaches an edge, if that is before another split.
    fn reach(&self, number: u32, edge: u32, other: SplitEvent) -> Option<f64> {
        let (vertex, start) = (&self.vertices[number as usize], &self.vertices[edge as usize]);
        if edge == number || start.next == number {
            return None;
        }
        let line = &self.lines[start.after as usize];
        let closing = line.speed - line.normal().dot(vertex.velocity);
        if closing <= SLOWEST {
            return None;
        }
        // Computed from the birth of the vertex, so that parts of an edge are reached at the same time, bit for bit.
        let time = (vertex.born + self.height(number, edge, vertex.born) / closing).max(self.now);
        let sooner = time < other.time || (time == other.time && other.is_open());
        // Just after the end there may be contacts within the tolerance.
        if !sooner || self.until + self.epsilon < time {
            return None;
        }
        let height = self.height(number, edge, self.now);
        if height < -self.epsilon {
            return None;
        }
        let end = &self.vertices[start.next as usize];
        if height <= self.epsilon && (start.node == vertex.node || end.node == vertex.node) {
            // They have just separated there.
            return None;
        }
        let at = self.at(number, time);
        let behind = line.along.dot(at - self.at(edge, time));
        let ahead = line.along.dot(self.at(start.next, time) - at);
        (-self.epsilon <= behind && -self.epsilon <= ahead).then_some(time)
    }
}
