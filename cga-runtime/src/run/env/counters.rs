//! The counters of a run, and their restoration.

use super::Env;
use super::mesh_counts::MeshCounts;

/// The counters of a run at one time.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Counters {
    pub(crate) shapes: u64,
    filled: u64,
    pub(crate) leaves: u64,
    pub(crate) meshes: MeshCounts,
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
            meshes: self.meshes,
            calls: self.calls.made,
            faults: self.faults.list.len(),
            faults_left_out: self.faults.left_out,
            said_once: self.faults.said_once.len(),
            said_again: self.faults.said_again,
            trail: self.trail.len(),
            has_ended: self.error.is_some() || self.ended(),
        }
    }

    /// Restores the counters. Returns true if the run has since made shapes, meshes and leaves alone.
    pub(crate) fn restore(&mut self, before: Counters) -> bool {
        let now = self.state();
        let Counters { shapes, filled, leaves, meshes, trail, .. } = now;
        let is_quiet = now == Counters { shapes, filled, leaves, meshes, trail, ..before };
        if now.has_ended && !before.has_ended {
            self.error = None;
            self.checkpoint.stopped_at = None;
        }
        (self.shapes, self.filled, self.leaves) = (before.shapes, before.filled, before.leaves);
        (self.meshes, self.calls.made) = (before.meshes, before.calls);
        self.faults.list.truncate(before.faults);
        self.faults.of_files.retain(|_, at| *at < before.faults);
        self.faults.left_out = before.faults_left_out;
        self.faults.said_once.truncate(before.said_once);
        self.trail.truncate(before.trail);
        is_quiet
    }
}
