//! One step of a wavefront: events at one time happen together.

use super::Failure;
use super::arrangement::Arrangement;
use super::contact::Contacts;
use super::event::Event;
use super::rejoin::rejoin;
use super::wavefront::Wavefront;

impl Wavefront {
    /// Lets events happen, at once, with all that is in contact with what takes part in them or with some vertices. Gives the
    /// vertices that are new.
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
