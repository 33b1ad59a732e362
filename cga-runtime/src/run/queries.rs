//! The queries of other shapes that a run can reach, as the compiler knows them (`cga-lang/src/ir/facts/queries.rs`).

use std::ops::BitOr;

/// A set of queries of other shapes.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Queries(u8);

impl Queries {
    /// Occlusion queries of shapes of the same initial shape.
    pub(crate) const INTRA_OCCLUSION: Queries = Queries(1);
    /// Occlusion queries of shapes of other initial shapes.
    pub(crate) const INTER_OCCLUSION: Queries = Queries(1 << 1);
    /// Queries of labelled shapes of the same initial shape.
    pub(crate) const INTRA_CONTEXT: Queries = Queries(1 << 2);
    /// Queries of labelled shapes of other initial shapes.
    pub(crate) const INTER_CONTEXT: Queries = Queries(1 << 3);
    /// Queries of the place in the tree of shapes.
    pub(crate) const TREE_KEY: Queries = Queries(1 << 4);
    /// Labels, which queries find.
    pub(crate) const LABELS: Queries = Queries(1 << 5);

    /// The set that generated code has as a number.
    pub(crate) fn from_bits(bits: u8) -> Self {
        Queries(bits)
    }

    /// Returns true if it has a query of `others`.
    pub(crate) fn has_any(self, others: Queries) -> bool {
        self.0 & others.0 != 0
    }
}

impl BitOr for Queries {
    type Output = Queries;

    fn bitor(self, other: Queries) -> Queries {
        Queries(self.0 | other.0)
    }
}
