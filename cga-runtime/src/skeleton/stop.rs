//! A stop of the wavefront: what touches, and where.
//!
//! Corners that touch become one *meeting place*, with what touches them, and so on; a piece that such a place touches
//! between its ends is divided there. Two pieces of one place that leave it side by side touch as far as the shorter one
//! reaches, so its far end becomes a meeting place too: this is how parallel walls meet all at once.

use glam::DVec2;

use super::event::Meeting;
use super::links::Links;
use super::wavefront::{NONE, Wavefront};
use super::{Failure, join};

/// What touches at one stop.
#[derive(Debug)]
pub(super) struct Contacts {
    /// Where corners are now, by number.
    pub(super) spots: Vec<DVec2>,
    /// For each corner another one of its place, or itself for one of them, or [`NONE`] when nothing is known of it.
    place: Vec<u32>,
    /// Pieces, by the corner they start at, that a corner touches.
    pub(super) touches: Vec<(u32, u32)>,
    /// Corners that are places by themselves: the far end of two pieces that lie on each other.
    pub(super) ends: Vec<u32>,
    queue: Vec<u32>,
}

impl Contacts {
    fn visit(&mut self, corner: u32) {
        if self.place[corner as usize] == NONE {
            self.place[corner as usize] = corner;
            self.queue.push(corner);
        }
    }

    /// The place of a corner that was visited.
    fn root(&self, mut corner: u32) -> u32 {
        while self.place[corner as usize] != corner {
            corner = self.place[corner as usize];
        }
        corner
    }

    fn join(&mut self, a: u32, b: u32) {
        self.visit(a);
        self.visit(b);
        let [a, b] = [a, b].map(|corner| self.root(corner));
        self.place[a.max(b) as usize] = a.min(b);
    }

    /// A corner touches a piece, whether it looks so or not. Whether that is new.
    pub(super) fn touch(&mut self, piece: u32, corner: u32) -> bool {
        self.visit(corner);
        let new = !self.touches.contains(&(piece, corner));
        if new {
            self.touches.push((piece, corner));
        }
        new
    }

    /// A corner is where two pieces end together. Whether that is new.
    pub(super) fn end(&mut self, corner: u32) -> bool {
        self.visit(corner);
        let new = !self.ends.contains(&corner);
        if new {
            self.ends.push(corner);
        }
        new
    }

    /// The place of a corner, by the first corner in it, if something touches there.
    pub(super) fn place(&self, corner: u32) -> Option<u32> {
        (self.place[corner as usize] != NONE).then(|| self.root(corner))
    }
}

impl Wavefront {
    /// Stops for what meets now, and for what touches any of some corners. Gives the corners that are new.
    pub(super) fn stop(&mut self, around: &[u32], meetings: &[Meeting]) -> Result<Vec<u32>, Failure> {
        let mut contacts = Contacts {
            spots: vec![DVec2::ZERO; self.corners.len()],
            place: vec![NONE; self.corners.len()],
            touches: Vec::new(),
            ends: Vec::new(),
            queue: Vec::new(),
        };
        for &corner in &self.alive {
            contacts.spots[corner as usize] = self.at(corner, self.now);
        }
        around.iter().for_each(|&corner| contacts.visit(corner));
        for &meeting in meetings {
            match meeting {
                Meeting::Ends(piece) => contacts.join(piece, self.corners[piece as usize].next),
                Meeting::Piece(corner, piece) => {
                    contacts.touch(piece, corner);
                }
            }
        }
        // Every round finds at least one more contact.
        loop {
            self.patience = self.patience.checked_sub(1).ok_or(Failure::Tangled)?;
            self.spread(&mut contacts);
            let links = Links::of(self, &contacts);
            if !links.lie_together(self, &mut contacts)? {
                return Ok(join::join(self, &contacts, &links));
            }
        }
    }

    /// Finds what touches the corners that touch something.
    fn spread(&self, contacts: &mut Contacts) {
        let near = self.epsilon * self.epsilon;
        while let Some(corner) = contacts.queue.pop() {
            let spot = contacts.spots[corner as usize];
            for &other in &self.alive {
                let start = contacts.spots[other as usize];
                if other != corner && start.distance_squared(spot) <= near {
                    contacts.join(corner, other);
                }
                let next = self.corners[other as usize].next;
                if other == corner || next == corner {
                    continue;
                }
                let end = contacts.spots[next as usize];
                let (low, high) = (start.min(end) - self.epsilon, start.max(end) + self.epsilon);
                if spot.cmpge(low).all() && spot.cmple(high).all() && to_segment(spot, start, end) <= near {
                    contacts.touch(other, corner);
                }
            }
        }
    }
}

/// The square of the distance from a point to a segment.
pub(super) fn to_segment(p: DVec2, a: DVec2, b: DVec2) -> f64 {
    let (to, along) = (p - a, b - a);
    let length = along.length_squared();
    let share = if length == 0.0 { 0.0 } else { (to.dot(along) / length).clamp(0.0, 1.0) };
    (to - along * share).length_squared()
}
