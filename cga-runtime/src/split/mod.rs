//! The split operation on a shape. `cga-split` computes the pieces; here they become shapes.

mod area;
pub(crate) mod divide;
pub(crate) mod division;
mod parts;
pub(crate) mod row;
mod texture;
pub(crate) mod walk;

pub use cga_split::{Item, Piece, Prefix, Size, Solution, solve, solve_any};

/// The scopes of parts (*split operation*, adjustSelector).
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Adjust {
    /// `adjust`, the default: the scope is the bounding box of the part's geometry.
    Adjust,
    /// `noAdjust`: the scope fills its slot.
    NoAdjust,
}
