//! The end of layouts that take too long.

use cga_geometry::long_sort::long_sort_by;
use cga_geometry::work;

use super::StreetError;

/// The units of work of an edge or a corner in a step.
pub(super) const EDGE: usize = 16;

/// Counts units of work. An error if the layout is to end.
pub(super) fn spend(units: usize) -> Result<(), StreetError> {
    if work::spend(units) { Ok(()) } else { Err(StreetError::Stopped) }
}

/// Sorts a list and removes repeated elements. An error if the layout is to end.
pub(super) fn sort_and_dedup<T: Copy + Ord>(list: &mut Vec<T>) -> Result<(), StreetError> {
    if !long_sort_by(list, Ord::cmp) {
        return Err(StreetError::Stopped);
    }
    list.dedup();
    Ok(())
}
