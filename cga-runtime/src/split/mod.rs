//! The split operation on a shape: which slots get room is arithmetic and found in `cga-split`; here pieces become shapes.

mod area;
pub(crate) mod divide;
pub(crate) mod division;
mod parts;
pub(crate) mod row;
pub(crate) mod texture;

pub use cga_split::{Item, Piece, Prefix, Size, Solution, solve, solve_any};

/// Whether parts shrink to what is in them (*split operation*, adjustSelector).
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Adjust {
    /// `adjust`, the default: the scope is the bounding box of the part's geometry.
    Adjust,
    /// `noAdjust`: the scope fills its slot.
    NoAdjust,
}
