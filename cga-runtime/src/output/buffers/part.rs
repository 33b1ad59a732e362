//! Stretches of triangles with one rule and one material.

use std::ops::Range;

/// Consecutive triangles with one rule and one material.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Part {
    /// Counts in [`Buffers::rules`](super::Buffers::rules).
    pub rule: u32,
    /// Counts in [`Buffers::materials`](super::Buffers::materials).
    pub material: u32,
    /// Its indices.
    pub indices: Range<usize>,
    /// The vertices those name, and no others do.
    pub vertices: Range<usize>,
}

/// Where a part starts; it ends where the next one does.
#[derive(Clone, Copy, Debug)]
pub(super) struct Run {
    pub(super) rule: u32,
    pub(super) material: u32,
    /// The number of triangles before it.
    pub(super) triangle: u32,
    pub(super) vertex: u32,
}

impl Run {
    /// True for one with the same rule and the same material.
    #[inline]
    pub(super) fn is_like(&self, other: &Run) -> bool {
        (self.rule, self.material) == (other.rule, other.material)
    }

    /// The same after so many triangles and vertices more.
    #[inline]
    pub(super) fn moved(&self, triangles: u32, vertices: u32) -> Run {
        Run { triangle: self.triangle + triangles, vertex: self.vertex + vertices, ..*self }
    }

    /// The number of indices before it.
    pub(super) fn index(&self) -> usize {
        3 * self.triangle as usize
    }
}

#[cfg(test)]
mod tests {
    use super::Run;

    #[test]
    fn a_run_takes_sixteen_bytes() {
        assert_eq!(size_of::<Run>(), 16);
    }
}
