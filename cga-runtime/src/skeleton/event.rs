//! When things meet: a piece's ends each other, a corner that is not convex a piece.

use glam::DVec2;

use super::Failure;
use super::wavefront::{NONE, Wavefront};

/// The first piece that a corner reaches, by the corner it starts at, and when.
#[derive(Clone, Copy, Debug)]
pub(super) struct Hit {
    pub(super) time: f64,
    pub(super) piece: u32,
}

impl Hit {
    pub(super) const NEVER: Hit = Hit { time: f64::INFINITY, piece: NONE };
}

/// Two that meet now, wherever rounding puts them.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Meeting {
    /// The ends of the piece after this corner.
    Ends(u32),
    /// A corner and the piece after another.
    Piece(u32, u32),
}

/// Things that come nearer more slowly than this do not.
const SLOWEST: f64 = 1e-12;

impl Wavefront {
    /// When the next event is; never, if nothing meets any more.
    pub(super) fn next_event(&self) -> f64 {
        self.alive.iter().fold(f64::INFINITY, |time, &corner| {
            let corner = &self.corners[corner as usize];
            time.min(corner.collapse).min(corner.hit.time)
        })
    }

    /// What meets now, or is so near that it touches.
    pub(super) fn due(&self) -> Vec<Meeting> {
        let mut due = Vec::new();
        for &number in &self.alive {
            let corner = &self.corners[number as usize];
            if corner.collapse <= self.now || (corner.collapse.is_finite() && self.gap(number) <= self.epsilon) {
                due.push(Meeting::Ends(number));
            }
            let hit = corner.hit;
            if hit.time <= self.now
                || (hit.time.is_finite() && self.height(number, hit.piece, self.now) <= self.epsilon)
            {
                due.push(Meeting::Piece(number, hit.piece));
            }
        }
        due
    }

    /// Looks ahead from here, where these corners are new. None of them may be unable to move.
    pub(super) fn foresee(&mut self, made: &[u32]) -> Result<(), Failure> {
        if made.iter().any(|&corner| self.corners[corner as usize].speed == DVec2::ZERO) {
            return Err(Failure::Tangled);
        }
        let mut pieces: Vec<u32> = made.iter().flat_map(|&c| [c, self.corners[c as usize].last]).collect();
        pieces.sort_unstable();
        pieces.dedup();
        for &piece in &pieces {
            self.corners[piece as usize].collapse = self.collapse(piece);
        }
        for index in 0..self.alive.len() {
            let number = self.alive[index];
            let corner = self.corners[number as usize];
            if !corner.reaches {
                continue;
            }
            let gone = |hit: Hit| {
                hit.piece != NONE
                    && (!self.corners[hit.piece as usize].alive || pieces.binary_search(&hit.piece).is_ok())
            };
            let anew = corner.born == self.now || gone(corner.hit);
            let (mut hit, among) = if anew { (Hit::NEVER, &self.alive) } else { (corner.hit, &pieces) };
            for &piece in among {
                if let Some(time) = self.reach(number, piece, hit.time) {
                    hit = Hit { time, piece };
                }
            }
            self.corners[number as usize].hit = hit;
        }
        Ok(())
    }

    /// How long a piece is now, along its edge.
    fn gap(&self, piece: u32) -> f64 {
        let corner = &self.corners[piece as usize];
        let along = self.lines[corner.after as usize].along;
        along.dot(self.at(corner.next, self.now) - self.at(piece, self.now))
    }

    fn collapse(&self, piece: u32) -> f64 {
        let corner = &self.corners[piece as usize];
        let along = self.lines[corner.after as usize].along;
        let closing = along.dot(corner.speed - self.corners[corner.next as usize].speed);
        if closing <= SLOWEST {
            return f64::INFINITY;
        }
        self.now + self.gap(piece).max(0.0) / closing
    }

    /// How far a corner is in front of the line of a piece.
    fn height(&self, corner: u32, piece: u32, time: f64) -> f64 {
        let line = &self.lines[self.corners[piece as usize].after as usize];
        line.normal().dot(self.at(corner, time)) - (line.at + time)
    }

    /// When a corner reaches a piece, if that is before some time.
    fn reach(&self, number: u32, piece: u32, before: f64) -> Option<f64> {
        let (corner, start) = (&self.corners[number as usize], &self.corners[piece as usize]);
        if piece == number || start.next == number {
            return None;
        }
        let line = &self.lines[start.after as usize];
        let closing = 1.0 - line.normal().dot(corner.speed);
        if closing <= SLOWEST {
            return None;
        }
        let height = self.height(number, piece, self.now);
        let time = self.now + height.max(0.0) / closing;
        // Just beyond the end there may be something that touches.
        let sooner = time < before && time <= self.until + self.epsilon;
        if !sooner || height < -self.epsilon {
            return None;
        }
        let end = &self.corners[start.next as usize];
        if height <= self.epsilon && (start.node == corner.node || end.node == corner.node) {
            // They came apart there.
            return None;
        }
        let at = self.at(number, time);
        let behind = line.along.dot(at - self.at(piece, time));
        let ahead = line.along.dot(self.at(start.next, time) - at);
        (-self.epsilon <= behind && -self.epsilon <= ahead).then_some(time)
    }
}
