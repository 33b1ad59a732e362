//! The counters of a run, and their restoration.

use super::Env;

/// The counters of a run at one time.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Counters {
    pub(crate) shapes: u64,
    filled: u64,
    leaves: u64,
    vertices: u64,
    mesh_bytes: u64,
    calls: u64,
    faults: usize,
    faults_left_out: u64,
    said_once: usize,
    said_again: u64,
    trail: usize,
    has_ended: bool,
}

impl Env {
    /// The counters of the run, for [`Env::restore`].
    pub(crate) fn state(&self) -> Counters {
        Counters {
            shapes: self.shapes,
            filled: self.filled,
            leaves: self.leaves,
            vertices: self.vertices,
            mesh_bytes: self.mesh_bytes,
            calls: self.calls_made,
            faults: self.faults.len(),
            faults_left_out: self.faults_left_out,
            said_once: self.said_once.len(),
            said_again: self.said_again,
            trail: self.trail.len(),
            has_ended: self.error.is_some() || self.ended(),
        }
    }

    /// Restores the counters. Returns true if the run has since made only shapes and leaves that fill their scopes.
    pub(crate) fn restore(&mut self, before: Counters) -> bool {
        let now = self.state();
        let is_quiet = now == Counters { shapes: now.shapes, filled: now.filled, trail: now.trail, ..before };
        if now.has_ended && !before.has_ended {
            self.error = None;
            self.checkpoint.stopped_at = None;
        }
        (self.shapes, self.filled, self.leaves) = (before.shapes, before.filled, before.leaves);
        (self.vertices, self.mesh_bytes, self.calls_made) = (before.vertices, before.mesh_bytes, before.calls);
        self.faults.truncate(before.faults);
        self.asset_faults.retain(|_, at| *at < before.faults);
        self.faults_left_out = before.faults_left_out;
        self.said_once.truncate(before.said_once);
        self.trail.truncate(before.trail);
        is_quiet
    }
}
