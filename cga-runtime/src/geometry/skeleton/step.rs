//! One step of a wavefront: simultaneous events are processed together.

use super::Failure;
use super::arrangement::Arrangement;
use super::contact::Contacts;
use super::event::Event;
use super::rejoin::rejoin;
use super::wavefront::Wavefront;

impl Wavefront {
    /// Processes simultaneous events, with everything in contact with their participants or with the vertices `around`.
    /// Returns the new vertices.
    pub(super) fn handle(&mut self, events: &[Event], around: &[u32]) -> Result<Vec<u32>, Failure> {
        for &vertex in &self.alive {
            self.positions[vertex as usize] = self.at(vertex, self.now);
        }
        let mut contacts = Contacts::new(self.vertices.len());
        around.iter().for_each(|&vertex| contacts.reach(vertex));
        for &event in events {
            match event {
                Event::Edge(edge) => contacts.coincide(edge, self.vertices[edge as usize].next),
                Event::Split(vertex, edge) => {
                    contacts.touch(edge, vertex);
                }
            }
        }
        let mut before = Vec::new();
        // Every round finds at least one more contact.
        loop {
            self.compare(&mut contacts);
            self.limits.round(self.alive.len(), contacts.touched())?;
            let arrangement = Arrangement::of(self, &contacts);
            if !arrangement.find_overlaps(self, &mut contacts, &before)? {
                return Ok(rejoin(self, &contacts, &arrangement));
            }
            before = arrangement.segments;
        }
    }
}
