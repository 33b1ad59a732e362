//! Ranges of triangles with one rule and one material.

use std::ops::Range;

/// Consecutive triangles with one rule and one material.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Submesh {
    /// The index of the rule in [`Buffers::rules`](super::Buffers::rules).
    pub rule: u32,
    /// The index of the material in [`Buffers::materials`](super::Buffers::materials).
    pub material: u32,
    /// The range of its indices.
    pub indices: Range<usize>,
    /// The range of its vertices, which only these indices use.
    pub vertices: Range<usize>,
}

/// The start of a submesh, which ends at the start of the next.
#[derive(Clone, Copy, Debug)]
pub(super) struct SubmeshStart {
    pub(super) rule: u32,
    pub(super) material: u32,
    /// The number of triangles before it.
    pub(super) triangle: u32,
    pub(super) vertex: u32,
}

impl SubmeshStart {
    /// Returns true for a submesh with the same rule and the same material.
    #[inline]
    pub(super) fn is_like(&self, other: &SubmeshStart) -> bool {
        (self.rule, self.material) == (other.rule, other.material)
    }

    /// The start after further triangles and vertices.
    #[inline]
    pub(super) fn moved(&self, triangles: u32, vertices: u32) -> SubmeshStart {
        SubmeshStart { triangle: self.triangle + triangles, vertex: self.vertex + vertices, ..*self }
    }

    /// The number of indices before it.
    pub(super) fn index(&self) -> usize {
        3 * self.triangle as usize
    }
}

#[cfg(test)]
mod tests {
    use super::SubmeshStart;

    #[test]
    fn a_run_takes_sixteen_bytes() {
        assert_eq!(size_of::<SubmeshStart>(), 16);
    }
}
