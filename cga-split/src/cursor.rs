//! Pieces one by one, for code that goes through the pattern and asks for the next slot or group.
//!
//! ```
//! use cga_split::{Item, Size, solve};
//!
//! // split(x) { 1 | { ~2.5 }* | 1 } in 10 metres
//! let pattern = [Item::Slot, Item::Repeat(1), Item::Slot, Item::Slot];
//! let sizes = [Size::absolute(1.0), Size::floating(2.5), Size::absolute(1.0)];
//! let mut lengths = [0.0; 3];
//! let solution = solve(&pattern, &sizes, &mut lengths, 10.0);
//! let (mut cursor, mut ends) = (solution.cursor(), Vec::new());
//! ends.extend(cursor.slot(0).map(|piece| piece.end));
//! let mut group = cursor.open(&solution, 0);
//! while cursor.turn(&mut group) {
//!     ends.extend(cursor.slot(1).map(|piece| piece.end));
//! }
//! ends.extend(cursor.slot(2).map(|piece| piece.end));
//! assert_eq!(ends, solution.pieces().iter().map(|piece| piece.end).collect::<Vec<_>>());
//! ```

use std::ops::Range;

use crate::choices::smallest_piece;
use crate::solve::piece;
use crate::turns::Turns;
use crate::{Piece, Solution};

/// A position in a split, between two pieces.
#[derive(Clone, Debug)]
pub struct Cursor<'s> {
    lengths: &'s [f64],
    smallest: f64,
    /// The end of the last piece.
    from: f64,
    /// The border that pieces do not cross.
    limit: f64,
}

/// A group while it repeats.
#[derive(Clone, Debug)]
pub struct Group {
    turns: Turns,
    /// The number of repetitions begun.
    number: f64,
    start: f64,
    /// The end of the group's room.
    room: f64,
    /// The border of the group around it.
    outer: f64,
}

impl<'s> Cursor<'s> {
    #[inline(always)]
    pub(crate) fn new(lengths: &'s [f64], extent: f64) -> Self {
        Cursor { lengths, smallest: smallest_piece(extent), from: 0.0, limit: extent }
    }

    /// The piece of the next slot, if it gets one.
    #[inline(always)]
    pub fn slot(&mut self, slot: usize) -> Option<Piece> {
        let piece = piece(slot, self.lengths[slot], self.from, self.limit, self.smallest)?;
        self.from = piece.end;
        Some(piece)
    }

    /// Enters the next group. Groups are numbered in the order in which they open.
    #[inline(always)]
    pub fn open(&mut self, solution: &Solution<'_>, group: usize) -> Group {
        let mut turns = solution.turns(group);
        let (start, outer) = (self.from, self.limit);
        let room = turns.limit(start, outer, self.smallest);
        if room - start <= self.smallest {
            turns.count = 0.0;
        }
        Group { turns, number: 0.0, start, room, outer }
    }

    /// Begins the next repetition of a group. Returns false after the last one.
    #[inline(always)]
    pub fn turn(&mut self, group: &mut Group) -> bool {
        if 0.0 < group.number {
            // A repetition fills its room exactly, without rounding errors.
            self.from = self.limit;
        }
        let more = group.number < group.turns.count && self.from < group.room;
        if more {
            group.number += 1.0;
            self.limit = group.turns.border(group.number, group.start, group.room, self.smallest);
        } else {
            self.limit = group.outer;
        }
        more
    }
}

/// A position in a list of pieces. The pattern has no nested groups.
#[derive(Clone, Debug)]
pub struct List<'s> {
    pieces: &'s [Piece],
}

impl<'s> List<'s> {
    /// A position before the first piece.
    #[inline(always)]
    pub fn new(pieces: &'s [Piece]) -> Self {
        List { pieces }
    }

    /// The piece of the next slot, if it has one.
    #[inline(always)]
    pub fn slot(&mut self, slot: u32) -> Option<Piece> {
        let (first, rest) = self.pieces.split_first()?;
        if first.slot != slot {
            return None;
        }
        self.pieces = rest;
        Some(*first)
    }

    /// Enters a group with the given slots.
    #[inline(always)]
    pub fn open(&mut self, slots: Range<u32>) -> Range<u32> {
        slots
    }

    /// Begins the next repetition of a group. Returns false after the last one.
    #[inline(always)]
    pub fn turn(&mut self, slots: &mut Range<u32>) -> bool {
        self.pieces.first().is_some_and(|piece| slots.contains(&piece.slot))
    }
}

impl Solution<'_> {
    /// A cursor at the low end, for code that knows the pattern and requests one slot after the other.
    #[inline(always)]
    pub fn cursor(&self) -> Cursor<'_> {
        Cursor::new(self.lengths, self.extent)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{Item, Size, solve};

    /// Collects the pieces of a part of a pattern in the order in which generated code requests them. Returns the
    /// numbers of the next slot and the next group.
    fn walk(
        pattern: &[Item],
        solution: &Solution<'_>,
        cursor: &mut Cursor<'_>,
        [mut slot, mut group]: [usize; 2],
        out: &mut Vec<Piece>,
    ) -> [usize; 2] {
        let mut at = 0;
        while at < pattern.len() {
            match pattern[at] {
                Item::Slot => {
                    out.extend(cursor.slot(slot));
                    slot += 1;
                    at += 1;
                }
                Item::Repeat(len) => {
                    let end = (at + 1 + len as usize).min(pattern.len());
                    let items = &pattern[at + 1..end];
                    let mut open = cursor.open(solution, group);
                    let mut next = [slot, group + 1];
                    while cursor.turn(&mut open) {
                        next = walk(items, solution, cursor, [slot, group + 1], out);
                    }
                    let slots = items.iter().filter(|item| matches!(item, Item::Slot)).count();
                    next = [slot + slots, group + 1 + items.len() - slots].max(next);
                    [slot, group] = next;
                    at = end;
                }
            }
        }
        [slot, group]
    }

    #[test]
    fn a_cursor_meets_the_same_pieces_to_the_bit() {
        let mut state = 1u64;
        let mut random = |below: u64| {
            state ^= state << 13;
            state ^= state >> 7;
            state ^= state << 17;
            state % below
        };
        for _ in 0..50_000 {
            let (mut pattern, mut sizes) = (Vec::new(), Vec::new());
            for _ in 0..1 + random(6) {
                if random(3) == 0 {
                    pattern.push(Item::Repeat(1 + random(3) as u32));
                }
                pattern.push(Item::Slot);
                let value = [0.0, 0.1, 0.3, 1.0, 2.5, -1.0, 1e-13, 7.0][random(8) as usize];
                sizes.push(match random(3) {
                    0 => Size::absolute(value),
                    1 => Size::relative(value / 10.0),
                    _ => Size::floating(value),
                });
            }
            let mut lengths = vec![0.0; sizes.len()];
            let extent = [0.0, 1.0, 10.0, 0.3, 33.3, 1e-3][random(6) as usize];
            let solution = solve(&pattern, &sizes, &mut lengths, extent);
            if 100_000 < solution.at_most() {
                continue;
            }
            let mut found = Vec::new();
            walk(&pattern, &solution, &mut solution.cursor(), [0, 0], &mut found);
            assert_eq!(found, solution.pieces(), "{pattern:?} {sizes:?} in {extent}");
        }
    }
}
