//! The number of a look: the short form in which slim shapes and sinks have it.

/// The number of a look in the run.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct LookId(pub(crate) u32);

impl LookId {
    /// A look without a number: the look of the base.
    pub(crate) const OF_BASE: LookId = LookId(u32::MAX);

    /// The flag of looks with implicit texture coordinates.
    pub(super) const COORDINATES: u32 = 1 << 31;

    /// The flag of temporary numbers.
    pub(super) const TEMPORARY: u32 = 1 << 30;

    /// The index in the list.
    #[inline]
    pub(crate) fn index(self) -> u32 {
        self.0 & !LookId::COORDINATES
    }

    /// Returns true if the look may have implicit texture coordinates, as every look without a number may.
    #[inline]
    pub(crate) fn may_have_coordinates(self) -> bool {
        self.0 & LookId::COORDINATES != 0
    }

    /// Returns true if the number belongs to the look for the whole run.
    #[inline]
    pub(crate) fn is_lasting(self) -> bool {
        self.0 & LookId::TEMPORARY == 0
    }
}
