//! The split solver: sizes and an extent in, pieces out. Pure arithmetic on `f64`, with the same bits on every platform
//! and without dependencies: the compiler solves rules with the same code as a run. For the same reason this crate has
//! [`files`], the places where files are looked up, [`suggest`], the names that may be meant, and [`tags`], the queries for
//! component tags.
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
mod search;
mod solve;
pub mod suggest;
pub mod tags;
mod turns;

pub use choices::is_size;
pub use cursor::{Cursor, Group, List};
pub use solve::{Solution, solve, solve_any};

/// The meaning of a size's value (*split operation*).
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Prefix {
    /// No prefix: metres.
    Absolute,
    /// `'`: a share of the whole scope, inside groups too.
    Relative,
    /// `~`: a weight in the remaining space.
    Floating,
}

/// The size of a slot as the rule gives it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Size {
    /// The meaning of the value.
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

/// A node of a split's pattern, flattened. Slots are numbered through the pattern in writing order.
///
/// `{ 1 | { ~2 | 3 }* | 4 }` is `[Slot, Repeat(2), Slot, Slot, Slot]`.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Item {
    /// The next written slot.
    Slot,
    /// `{ … }*`: the group contains this many of the following items, nested items included.
    Repeat(u32),
}

/// The part of the extent that a slot gets.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Piece {
    /// The number of the written slot.
    pub slot: u32,
    /// The distance of its low end from the scope's low end.
    pub start: f64,
    /// The distance of its high end; the next piece starts there.
    pub end: f64,
    /// Its length: the given size, bit for bit, unless it was stretched or cut.
    pub length: f64,
}
