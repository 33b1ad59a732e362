//! The edges of a mesh whose points are known.

use std::collections::HashMap;
use std::ops::Range;

use crate::fixed_hash::FixedState;

/// The number of edges up to which they are compared one by one.
const FEW: usize = 16;

/// The points of some edges. It is only for look-ups, never iterated.
#[derive(Debug, Default)]
pub(super) struct KnownEdges {
    /// The first edges.
    few: Vec<([u32; 2], Range<usize>)>,
    /// The edges after them.
    many: HashMap<[u32; 2], Range<usize>, FixedState>,
}

impl KnownEdges {
    /// Removes all edges.
    pub(super) fn clear(&mut self) {
        self.few.clear();
        // A large table would take long to clear.
        if !self.many.is_empty() {
            self.many = HashMap::default();
        }
    }

    /// The points of the edge between two points, the lower number first.
    pub(super) fn get(&self, ends: [u32; 2]) -> Option<Range<usize>> {
        let known = self.few.iter().find(|edge| edge.0 == ends).map(|edge| &edge.1);
        known.or_else(|| self.many.get(&ends)).cloned()
    }

    /// Adds an edge.
    pub(super) fn add(&mut self, ends: [u32; 2], points: Range<usize>) {
        if self.few.len() < FEW {
            self.few.push((ends, points));
        } else {
            self.many.insert(ends, points);
        }
    }
}
