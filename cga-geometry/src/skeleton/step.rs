//! The steps of a wavefront: simultaneous events are processed together.

use super::arrangement::{Arrangement, Segment};
use super::contact::Contacts;
use super::event::Event;
use super::rejoin::rejoin;
use super::wavefront::Wavefront;
use super::{SkeletonError, Swept};
use crate::work;

/// The lists of a step. They keep their memory, because a usual step has a single event.
#[derive(Debug, Default)]
pub(super) struct Workspace {
    contacts: Contacts,
    arrangement: Arrangement,
    /// The segments of the round before.
    before: Vec<Segment>,
}

impl Wavefront {
    /// Moves the wavefront until its final time.
    pub(super) fn run(self) -> Result<Swept, SkeletonError> {
        self.run_by(Wavefront::handle_lone)
    }

    /// The same, with a way to process usual events.
    pub(super) fn run_by(
        mut self,
        usual: impl Fn(&mut Wavefront, &[Event]) -> Option<Vec<u32>>,
    ) -> Result<Swept, SkeletonError> {
        let mut workspace = Workspace::default();
        // Contacts at the start: pinches, bridges to holes.
        let everything: Vec<u32> = self.alive.clone();
        self.place();
        self.handle(&[], &everything, &mut workspace)?;
        self.part_speeds(&self.alive.clone());
        self.overtake(&mut self.alive.clone());
        self.foresee(&self.alive.clone())?;
        loop {
            // An event scans the wavefront a few times.
            if !work::spend(4 * self.alive.len()) {
                return Err(SkeletonError::Tangled);
            }
            let next = self.next_event();
            self.now = next.clamp(self.now, self.until);
            self.place();
            let due = self.due();
            if due.is_empty() {
                return if self.now == self.until { self.finish() } else { Err(SkeletonError::Tangled) };
            }
            let mut made = match usual(&mut self, &due) {
                Some(made) => made,
                None => self.handle(&due, &[], &mut workspace)?,
            };
            made.extend(self.part_speeds(&made));
            self.overtake(&mut made);
            self.limits.make(made.len())?;
            self.foresee(&made)?;
        }
    }

    /// Processes simultaneous events, with everything in contact with their participants or with the vertices `around`.
    /// Returns the new vertices.
    fn handle(
        &mut self,
        events: &[Event],
        around: &[u32],
        workspace: &mut Workspace,
    ) -> Result<Vec<u32>, SkeletonError> {
        let Workspace { contacts, arrangement, before } = workspace;
        contacts.clear(self.vertices.len());
        around.iter().for_each(|&vertex| contacts.reach(vertex));
        for &event in events {
            match event {
                Event::Edge(edge) => contacts.coincide(edge, self.vertices[edge as usize].next),
                Event::Split(vertex, edge) => {
                    contacts.touch(edge, vertex);
                }
            }
        }
        before.clear();
        // Every round finds at least one more contact.
        loop {
            self.compare(contacts)?;
            self.limits.round(self.alive.len(), contacts.touched())?;
            arrangement.divide(self, contacts);
            if !arrangement.find_overlaps(self, contacts, before)? {
                return Ok(rejoin(self, contacts, arrangement));
            }
            std::mem::swap(before, &mut arrangement.segments);
        }
    }
}
