//! The pairs of runs that must give the same.

use cga::Shape;

/// Two runs of one grammar that must give the same.
pub(crate) struct Pair {
    /// The names of the two runs.
    pub(crate) names: [&'static str; 2],
    /// The initial shapes of the two runs.
    pub(crate) shapes: fn(&Shape) -> [Shape; 2],
}

/// Every pair.
pub(crate) const PAIRS: &[Pair] =
    &[Pair { names: ["boxes", "meshes"], shapes: |shape| [shape.clone(), shape.clone().held_as_meshes()] }];
