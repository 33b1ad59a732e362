//! The times of events: an edge shrinks to a point, or a reflex vertex reaches an edge.

use super::wavefront::{CollapseEvent, MovingLine, NextEvent, SplitEvent, Wavefront, WavefrontVertex};
use super::{NONE, SkeletonError};
use crate::small_sort::SmallSort;
use crate::work;

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
        loop {
            let times = self.alive.iter().map(|&number| self.events[number as usize].time);
            let next = times.fold(f64::INFINITY, |next, time| if time < next { time } else { next });
            let soon = next + self.epsilon;
            let mut is_final = true;
            for index in 0..self.reflex.len() {
                let number = self.reflex[index];
                let split = self.vertices[number as usize].split;
                if split.is_open() && split.time <= soon {
                    let split = self.first_split(number, SplitEvent::NEVER, &self.alive);
                    self.set_split(number, split);
                    is_final = false;
                }
            }
            if is_final {
                return next;
            }
        }
    }

    /// The events at the current time, including those so close that they count as contacts.
    pub(super) fn due(&self) -> Vec<Event> {
        let mut due = Vec::new();
        for &number in self.alive.iter().filter(|&&number| self.events[number as usize].near <= self.now) {
            let WavefrontVertex { collapse, split, .. } = &self.vertices[number as usize];
            if collapse.near <= self.now && (collapse.time <= self.now || self.length(number) <= self.epsilon) {
                due.push(Event::Edge(number));
            }
            let is_reached = |edge: u32| {
                let height = self.line(edge).height(self.positions[number as usize], self.now);
                split.time <= self.now || height <= self.epsilon
            };
            if split.near <= self.now && split.edge != NONE && is_reached(split.edge) {
                due.push(Event::Split(number, split.edge));
            }
        }
        due
    }

    /// Computes the next events after the given vertices were made. An error if one of them cannot move.
    pub(super) fn foresee(&mut self, made: &[u32]) -> Result<(), SkeletonError> {
        if made.iter().any(|&vertex| self.vertices[vertex as usize].stuck) {
            return Err(SkeletonError::Tangled);
        }
        let mut changed: Vec<u32> = made.iter().flat_map(|&v| [v, self.vertices[v as usize].last]).collect();
        changed.small_sort();
        changed.dedup();
        for &edge in &changed {
            self.vertices[edge as usize].collapse = self.collapse(edge);
            self.events[edge as usize] = NextEvent::of(&self.vertices[edge as usize]);
        }
        let Wavefront { reflex, vertices, .. } = self;
        reflex.retain(|&vertex| vertices[vertex as usize].alive);
        reflex.extend(made.iter().filter(|&&vertex| vertices[vertex as usize].reflex));
        for index in 0..self.reflex.len() {
            let number = self.reflex[index];
            let WavefrontVertex { born, mut split, .. } = self.vertices[number as usize];
            let compared = if born == self.now { self.alive.len() } else { changed.len() };
            if !work::spend(compared) {
                return Err(SkeletonError::Tangled);
            }
            let split = if born == self.now {
                self.first_split(number, SplitEvent::NEVER, &self.alive)
            } else {
                let edge = split.edge;
                if edge != NONE && (!self.vertices[edge as usize].alive || changed.binary_search(&edge).is_ok()) {
                    // Other edges are not reached before the time of that edge.
                    split.edge = NONE;
                }
                self.first_split(number, split, &changed)
            };
            self.set_split(number, split);
        }
        Ok(())
    }

    fn set_split(&mut self, vertex: u32, split: SplitEvent) {
        self.vertices[vertex as usize].split = split;
        self.events[vertex as usize] = NextEvent::of(&self.vertices[vertex as usize]);
    }

    /// The line of an edge.
    pub(super) fn line(&self, edge: u32) -> &MovingLine {
        &self.lines[self.vertices[edge as usize].after as usize]
    }

    /// The length of an edge along its line, at the last positions.
    fn length(&self, edge: u32) -> f64 {
        let next = self.vertices[edge as usize].next;
        self.line(edge).along.dot(self.positions[next as usize] - self.positions[edge as usize])
    }

    fn collapse(&self, edge: u32) -> CollapseEvent {
        let start = &self.vertices[edge as usize];
        let end = &self.vertices[start.next as usize];
        let along = self.line(edge).along;
        let closing = along.dot(start.velocity - end.velocity);
        if closing <= SLOWEST {
            return CollapseEvent::NEVER;
        }
        let time = self.now + along.dot(end.at(self.now) - start.at(self.now)).max(0.0) / closing;
        CollapseEvent { time, near: self.before(time, closing) }
    }

    /// A time before a contact when the distance is twice the contact distance, if it becomes smaller by `closing` per
    /// time.
    fn before(&self, time: f64, closing: f64) -> f64 {
        time - 2.0 * self.epsilon / closing
    }

    /// The first of some edges that a vertex reaches, if that is before the known split. If the known split is open,
    /// equal times count too, because the edge may be another part of the known one.
    fn first_split(&self, number: u32, known: SplitEvent, edges: &[u32]) -> SplitEvent {
        let vertex = &self.vertices[number as usize];
        let here = vertex.at(self.now);
        // Just after the end there may be contacts within the tolerance.
        let last = self.until + self.epsilon;
        let mut split = known;
        for &edge in edges {
            let start = &self.vertices[edge as usize];
            if edge == number || start.next == number {
                continue;
            }
            let line = &self.lines[start.after as usize];
            let closing = line.speed - line.normal().dot(vertex.velocity);
            let height = line.height(here, self.now);
            if closing <= SLOWEST || height < -self.epsilon {
                continue;
            }
            // Computed from the birth of the vertex, so that parts of an edge are reached at the same time, bit for bit.
            let time = (vertex.born + line.height(vertex.from, vertex.born) / closing).max(self.now);
            let is_sooner = time < split.time || (time == split.time && split.is_open());
            if !is_sooner || last < time {
                continue;
            }
            let end = &self.vertices[start.next as usize];
            if height <= self.epsilon && (start.node == vertex.node || end.node == vertex.node) {
                // They have just separated there.
                continue;
            }
            let at = vertex.at(time);
            let behind = line.along.dot(at - start.at(time));
            let ahead = line.along.dot(end.at(time) - at);
            if -self.epsilon <= behind && -self.epsilon <= ahead {
                split = SplitEvent { time, near: self.before(time, closing), edge };
            }
        }
        split
    }
}
