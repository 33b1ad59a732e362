//! How much a wavefront takes. One with contacts that are none may divide without end; it is given up when it has taken more
//! than any other does.

use super::Failure;

/// What is left to be taken. In brackets: the most that wavefronts of many kinds took that came out well.
#[derive(Debug)]
pub(super) struct Limits {
    /// Rounds of looking for contacts (1.5 for each corner of the polygon).
    rounds: usize,
    /// Vertices in all (3 for each corner).
    vertices: usize,
    /// Vertices at one time (1.5 for each corner).
    alive: usize,
}

impl Limits {
    /// Of a polygon.
    pub(super) fn of(corners: usize) -> Self {
        Limits { rounds: 4 * corners + 64, vertices: 8 * corners + 64, alive: 2 * corners + 64 }
    }

    /// Takes a round in which some vertices are alive, and so many of them touch edges (as many as are alive).
    pub(super) fn round(&mut self, alive: usize, touching: usize) -> Result<(), Failure> {
        self.rounds = self.rounds.checked_sub(1).ok_or(Failure::Tangled)?;
        if self.alive < alive || 4 * alive + 64 < touching { Err(Failure::Tangled) } else { Ok(()) }
    }

    /// Takes vertices.
    pub(super) fn make(&mut self, vertices: usize) -> Result<(), Failure> {
        self.vertices = self.vertices.checked_sub(vertices).ok_or(Failure::Tangled)?;
        Ok(())
    }
}
