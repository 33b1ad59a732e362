//! Identities of repeated parts.

/// The identity of a repeated part within a run. Parts with equal identities are equal. Equal parts may have
/// different identities, as a run keeps few of them.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub struct PartId {
    pub(super) template: u64,
    pub(super) segment: usize,
}
