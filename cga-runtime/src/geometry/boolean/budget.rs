//! The limit on the work of an arrangement.

use super::BooleanError;

/// The number of comparisons that are left.
pub(super) struct Budget(usize);

impl Budget {
    /// About two seconds.
    const MOST: usize = 200_000_000;

    pub(super) fn new() -> Self {
        Budget(Self::MOST)
    }

    /// Takes some comparisons; an error if none are left.
    pub(super) fn spend(&mut self, count: usize) -> Result<(), BooleanError> {
        self.0 = self.0.checked_sub(count).ok_or(BooleanError::TooMany)?;
        Ok(())
    }
}
