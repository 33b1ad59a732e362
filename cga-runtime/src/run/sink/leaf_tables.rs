//! The names and looks of leaves, by number.

use crate::shape::look_id::LookIds;

/// The names and looks of a run's leaves, by number.
#[derive(Clone, Debug, Default)]
pub(crate) struct LeafTables {
    pub(crate) names: &'static [&'static str],
    pub(crate) looks: LookIds,
}
