//! Rows of pieces from all sources: solved in the run, solved by the macro, measured by area.

use std::ops::ControlFlow;

use cga_split::{Item, Size, solve_any};

use super::{Piece, Solution};

/// A row of pieces from any source. Rows are passed by value: a value whose address is passed on is kept in memory by
/// the compiler.
pub trait Row: Copy {
    /// An upper bound of the number of pieces.
    fn at_most(&self) -> u64;

    /// Calls `visit` for each piece, from the low end to the high end, until it breaks.
    fn each<B>(&self, visit: impl FnMut(Piece) -> ControlFlow<B>) -> ControlFlow<B>;

    /// The number of pieces.
    fn total(&self) -> u64 {
        let mut total = 0;
        let _ = self.each(|_| {
            total += 1;
            ControlFlow::<()>::Continue(())
        });
        total
    }
}

/// A split with constant sizes. Rare code solves it again, so that the first solution need not be in memory.
#[derive(Clone, Copy, Debug)]
pub struct Pattern {
    /// Slots and groups.
    pub items: &'static [Item],
    /// The sizes of the slots.
    pub sizes: &'static [Size],
    /// The length to divide, in metres.
    pub extent: f64,
}

impl Pattern {
    fn solved<T>(&self, ask: impl FnOnce(&Solution<'_>) -> T) -> T {
        ask(&solve_any(self.items, self.sizes, &mut vec![0.0; self.sizes.len()], self.extent))
    }
}

impl Row for Pattern {
    fn at_most(&self) -> u64 {
        self.solved(|solution| solution.at_most())
    }

    fn each<B>(&self, visit: impl FnMut(Piece) -> ControlFlow<B>) -> ControlFlow<B> {
        self.solved(|solution| solution.each(visit))
    }
}

impl Row for &Solution<'_> {
    #[inline]
    fn at_most(&self) -> u64 {
        Solution::at_most(self)
    }

    #[inline]
    fn each<B>(&self, visit: impl FnMut(Piece) -> ControlFlow<B>) -> ControlFlow<B> {
        Solution::each(self, visit)
    }
}

impl Row for &[Piece] {
    #[inline]
    fn at_most(&self) -> u64 {
        self.len() as u64
    }

    #[inline]
    fn each<B>(&self, visit: impl FnMut(Piece) -> ControlFlow<B>) -> ControlFlow<B> {
        self.iter().copied().try_for_each(visit)
    }
}
