//! Counts work that no budget limits.

use super::operation::BooleanError;
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
