//! Pieces in a row, however they are known: solved in the run, solved by the macro, measured by area.

use std::ops::ControlFlow;

use super::{Piece, Solution};

/// Pieces in a row, however they are known.
pub trait Row {
    /// No fewer than there are.
    fn at_most(&self) -> u64;
    /// How many there are.
    fn total(&self) -> u64;
    /// Calls `visit` for each, from the low end to the high end, until it says stop.
    fn each<B>(&self, visit: impl FnMut(Piece) -> ControlFlow<B>) -> ControlFlow<B>;
}

/// The number of pieces.
pub fn total(row: &(impl Row + ?Sized)) -> u64 {
    row.total()
}

impl Row for Solution<'_> {
    #[inline]
    fn at_most(&self) -> u64 {
        Solution::at_most(self)
    }

    #[inline]
    fn total(&self) -> u64 {
        Solution::total(self)
    }

    #[inline]
    fn each<B>(&self, visit: impl FnMut(Piece) -> ControlFlow<B>) -> ControlFlow<B> {
        Solution::each(self, visit)
    }
}

impl Row for [Piece] {
    #[inline]
    fn at_most(&self) -> u64 {
        self.len() as u64
    }

    #[inline]
    fn total(&self) -> u64 {
        self.len() as u64
    }

    #[inline]
    fn each<B>(&self, visit: impl FnMut(Piece) -> ControlFlow<B>) -> ControlFlow<B> {
        self.iter().copied().try_for_each(visit)
    }
}
