//! Identities of repeated parts.

/// The identity of a repeated part within a run: equal identities are equal parts. Parts with other identities may be equal as
/// well, as a run keeps few of them.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub struct PartId {
    pub(super) template: u64,
    pub(super) segment: usize,
    /// The number of the base whose material some leaves have, if they have no other.
    pub(super) base: u64,
}
