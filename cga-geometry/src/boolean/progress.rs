//! Counts work that no budget limits.

use super::operation::BooleanError;
use crate::long_sort::long_sort_by;
use crate::work;

/// The units of work of dividing an edge or reading a corner.
const STEP: usize = 8;

/// Counts divided edges and corners that are read, which no budget limits. An error if the work is to end.
pub(super) fn goes_on(steps: usize) -> Result<(), BooleanError> {
    if work::spend(STEP * steps) { Ok(()) } else { Err(BooleanError::TooMany) }
}

/// Asks whether the work goes on: before and after long steps that count no work themselves.
pub(super) fn ask() -> Result<(), BooleanError> {
    if work::ask() { Ok(()) } else { Err(BooleanError::TooMany) }
}

/// Sorts a list that may be long. An error if the work is to end.
pub(super) fn sort<T: Copy + Ord>(list: &mut [T]) -> Result<(), BooleanError> {
    if long_sort_by(list, Ord::cmp) { Ok(()) } else { Err(BooleanError::TooMany) }
}
