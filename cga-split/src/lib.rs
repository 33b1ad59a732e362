//! The split solver: sizes and an extent in, pieces out. Pure arithmetic on `f64`, the same bits on every platform, without
//! dependencies, so that rules can be solved while they are compiled by what solves them while they run. For the same reason
//! [`files`] is here: the places at which files are looked for.
//!
//! ```
//! use cga_split::{Item, Size, solve};
//!
//! // split(x) { 1 | { ~2.5 }* | 1 } in 10 metres
//! let pattern = [Item::Slot, Item::Repeat(1), Item::Slot, Item::Slot];
//! let sizes = [Size::absolute(1.0), Size::floating(2.5), Size::absolute(1.0)];
//! let mut lengths = [0.0; 3];
//! let pieces = solve(&pattern, &sizes, &mut lengths, 10.0).pieces();
//! assert_eq!(pieces.len(), 5);
//! assert_eq!(pieces[1].length, 8.0 / 3.0);
//! ```

#![forbid(unsafe_code)]

mod choices;
mod cursor;
pub mod files;
mod groups;
mod runs;
mod search;
mod solve;

pub use choices::is_size;
pub use cursor::{Cursor, Group, List, ListGroup};
pub use solve::{Solution, solve, solve_any};

/// How a size is to be read (*split operation*).
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Prefix {
    /// No prefix: metres.
    Absolute,
    /// `'`: a share of the whole scope, inside groups too.
    Relative,
    /// `~`: a weight in the space that is left over.
    Floating,
}

/// The size of a slot as the rule gives it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Size {
    /// How to read the value.
    pub prefix: Prefix,
    /// The number.
    pub value: f64,
}

impl Size {
    /// Metres.
    pub const fn absolute(value: f64) -> Self {
        Size { prefix: Prefix::Absolute, value }
    }

    /// A share of the scope.
    pub const fn relative(value: f64) -> Self {
        Size { prefix: Prefix::Relative, value }
    }

    /// A weight.
    pub const fn floating(value: f64) -> Self {
        Size { prefix: Prefix::Floating, value }
    }
}

/// A node of a split's pattern, flattened: slots count through the pattern in writing order.
///
/// `{ 1 | { ~2 | 3 }* | 4 }` is `[Slot, Repeat(2), Slot, Slot, Slot]`.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Item {
    /// The next written slot.
    Slot,
    /// `{ … }*`: the group holds this many of the following items, nested ones included.
    Repeat(u32),
}

/// A slot that gets room, and where.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Piece {
    /// Which written slot.
    pub slot: u32,
    /// Distance of its low end from the scope's low end.
    pub start: f64,
    /// Distance of its high end; the next piece starts there.
    pub end: f64,
    /// Its length: the size asked for, bit for bit, where it was neither stretched nor cut.
    pub length: f64,
}
