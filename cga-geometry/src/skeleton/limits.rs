//! Limits on the work of a wavefront. With false contacts a wavefront could divide endlessly, so it is given up when it
//! exceeds the work of any regular wavefront.

use super::SkeletonError;

/// The remaining work. In brackets: the largest value of many kinds of wavefronts with a correct result.
#[derive(Debug)]
pub(super) struct WorkLimits {
    /// Rounds of the search for contacts (1.5 per corner of the polygon).
    rounds: usize,
    /// Vertices in total (3 per corner).
    vertices: usize,
    /// Vertices at one time (1.5 per corner).
    alive: usize,
}

impl WorkLimits {
    /// The limits for a polygon.
    pub(super) fn of(corners: usize) -> Self {
        WorkLimits { rounds: 4 * corners + 64, vertices: 8 * corners + 64, alive: 2 * corners + 64 }
    }

    /// Counts a round with `alive` vertices, of which `touching` touch edges (usually at most as many as are alive).
    pub(super) fn round(&mut self, alive: usize, touching: usize) -> Result<(), SkeletonError> {
        self.rounds = self.rounds.checked_sub(1).ok_or(SkeletonError::Tangled)?;
        if self.alive < alive || 4 * alive + 64 < touching { Err(SkeletonError::Tangled) } else { Ok(()) }
    }

    /// Counts new vertices.
    pub(super) fn make(&mut self, vertices: usize) -> Result<(), SkeletonError> {
        self.vertices = self.vertices.checked_sub(vertices).ok_or(SkeletonError::Tangled)?;
        Ok(())
    }
}
