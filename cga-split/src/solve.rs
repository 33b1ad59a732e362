//! Sizes and an extent → a solution.

use std::ops::ControlFlow;

use crate::choices::{is_size, smallest_piece};
use crate::groups;
use crate::runs::{AnyGroups, OneGroup, Run, Turns};
use crate::search::Sum;
use crate::{Item, Piece, Prefix, Size};

/// The final length of each slot, and how often each group of the pattern repeats.
#[derive(Clone, Debug)]
pub struct Solution<'a> {
    pattern: &'a [Item],
    lengths: &'a [f64],
    extent: f64,
    /// How the group of a pattern with one group repeats.
    one: Turns,
    /// How the groups of a pattern with several repeat, in the order in which they open.
    several: Vec<Turns>,
}

/// How many groups a pattern has. Known while compiling where the pattern is, so that only one way is left in the code.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Grouping {
    None,
    One,
    Several,
}

impl Grouping {
    #[inline(always)]
    fn of(pattern: &[Item], slots: usize) -> Self {
        // An item that is no slot is a group.
        match pattern.len() - slots {
            0 => Grouping::None,
            1 => Grouping::One,
            _ => Grouping::Several,
        }
    }
}

/// Solves a split over `extent` metres. There is one size a slot of the pattern, and one place in `lengths`, which becomes
/// its final length: zero for a slot that is never made.
///
/// *split operation*, *Subdivision split*: absolute and relative sizes are taken as they are, floating ones share what is
/// left; repetitions are chosen for the least stretch; what does not fit is cut or not made. An extent that is no
/// positive, finite number has no pieces. Nothing is allocated for patterns with one group or none.
///
/// # Panics
/// When there is not one length a size, or an item less than sizes.
#[inline(always)]
pub fn solve<'a>(pattern: &'a [Item], sizes: &[Size], lengths: &'a mut [f64], extent: f64) -> Solution<'a> {
    assert!(sizes.len() == lengths.len() && sizes.len() <= pattern.len(), "one size and one length a slot");
    let extent = if is_size(extent) { extent } else { 0.0 };
    let (mut one, mut several) = (Turns::NONE, Vec::new());
    match Grouping::of(pattern, sizes.len()) {
        Grouping::None => {
            let sum = measure(sizes, lengths, extent);
            stretch(sizes, lengths, sum.stretch(extent));
        }
        Grouping::One => {
            measure(sizes, lengths, extent);
            let own = groups::slots_of_one(pattern, sizes.len());
            let (outside, inside) = groups::sums_of_one(&own, sizes, lengths);
            let by;
            (by, one) = groups::one(outside, inside, extent);
            stretch(sizes, lengths, by);
        }
        Grouping::Several => several = solve_several(pattern, sizes, lengths, extent),
    }
    Solution { pattern, lengths, extent, one, several }
}

#[inline(never)]
fn solve_several(pattern: &[Item], sizes: &[Size], lengths: &mut [f64], extent: f64) -> Vec<Turns> {
    measure(sizes, lengths, extent);
    let (by, turns) = groups::several(pattern, sizes, lengths, extent);
    stretch(sizes, lengths, by);
    turns
}

/// Sets lengths, floats not yet stretched; gives their sum.
#[inline(always)]
fn measure(sizes: &[Size], lengths: &mut [f64], extent: f64) -> Sum {
    let mut sum = Sum::default();
    for (length, size) in lengths.iter_mut().zip(sizes) {
        let metres = if size.prefix == Prefix::Relative { size.value * extent } else { size.value };
        *length = if is_size(metres) { metres } else { 0.0 };
        sum.add(size, *length);
    }
    if sum.floating == f64::INFINITY {
        sum = weigh_less(sizes, lengths);
    }
    sum
}

#[inline(always)]
fn stretch(sizes: &[Size], lengths: &mut [f64], by: f64) {
    for (length, size) in lengths.iter_mut().zip(sizes) {
        if size.prefix == Prefix::Floating {
            *length *= by;
        }
    }
}

/// Makes any sum of weights finite, and no weight that counts beside the others zero: a power of two.
const LIGHTER: f64 = 1.0 / (1u128 << 100) as f64;

/// Weights whose sum is too large for a number keep their ratios.
#[cold]
fn weigh_less(sizes: &[Size], lengths: &mut [f64]) -> Sum {
    let mut sum = Sum::default();
    for (length, size) in lengths.iter_mut().zip(sizes) {
        if size.prefix == Prefix::Floating {
            *length *= LIGHTER;
        }
        sum.add(size, *length);
    }
    sum
}

impl Solution<'_> {
    #[inline(always)]
    fn grouping(&self) -> Grouping {
        Grouping::of(self.pattern, self.lengths.len())
    }

    /// How often the group repeats in each repetition of the group around it; groups count in the order in which they open.
    pub fn count(&self, group: usize) -> u64 {
        match self.grouping() {
            Grouping::One if group == 0 => self.one.count,
            Grouping::Several => self.several.get(group).map_or(0, |turns| turns.count),
            Grouping::None | Grouping::One => 0,
        }
    }

    /// An upper bound of the number of pieces, in constant time an item.
    #[inline]
    pub fn at_most(&self) -> u64 {
        let slots = self.lengths.len();
        match self.grouping() {
            Grouping::None => slots as u64,
            Grouping::One => {
                let inside = groups::slots_of_one(self.pattern, slots).len();
                (slots - inside) as u64 + self.one.count.saturating_mul(inside as u64)
            }
            Grouping::Several => self.slots_made(),
        }
    }

    /// Slots with the groups expanded.
    fn slots_made(&self) -> u64 {
        // How often what is inside the groups that are open is made, and where they end.
        let mut open: Vec<(u64, usize)> = Vec::new();
        let (mut sum, mut times, mut group) = (0u64, 1u64, 0);
        for (at, item) in self.pattern.iter().enumerate() {
            while let Some((outer, _)) = open.pop_if(|(_, end)| *end <= at) {
                times = outer;
            }
            match item {
                Item::Slot => sum = sum.saturating_add(times),
                Item::Repeat(len) => {
                    open.push((times, (at + 1).saturating_add(*len as usize)));
                    times = times.saturating_mul(self.count(group));
                    group += 1;
                }
            }
        }
        sum
    }

    /// Calls `visit` for every piece, from the low end to the high end, until it says stop.
    #[inline]
    pub fn each<B>(&self, visit: impl FnMut(Piece) -> ControlFlow<B>) -> ControlFlow<B> {
        let (slots, extent) = (self.lengths.len(), self.extent);
        match self.grouping() {
            Grouping::None => {
                let mut all = Some(Run { slots: 0..slots, start: 0.0, limit: extent });
                self.lay(|_| all.take(), visit)
            }
            Grouping::One => {
                let own = groups::slots_of_one(self.pattern, slots);
                let mut runs = OneGroup::new(own, slots, self.one, extent);
                self.lay(|end| runs.next(end), visit)
            }
            Grouping::Several => {
                let mut runs = AnyGroups::new(self.pattern, &self.several, extent);
                self.lay(|end| runs.next(end), visit)
            }
        }
    }

    /// Lays out run after run; `next` gives the next one when it is told where the last one ended.
    #[inline]
    fn lay<B>(
        &self,
        mut next: impl FnMut(f64) -> Option<Run>,
        mut visit: impl FnMut(Piece) -> ControlFlow<B>,
    ) -> ControlFlow<B> {
        let smallest = smallest_piece(self.extent);
        let mut from = 0.0;
        while let Some(run) = next(from) {
            from = run.start;
            let lengths = self.lengths.get(run.slots.clone()).unwrap_or_default();
            for (slot, length) in run.slots.zip(lengths) {
                if let Some(piece) = piece(slot, *length, from, run.limit, smallest) {
                    from = piece.end;
                    visit(piece)?;
                }
            }
        }
        ControlFlow::Continue(())
    }

    /// The number of pieces.
    #[inline]
    pub fn total(&self) -> u64 {
        let mut total = 0;
        let _ = self.each(|_| {
            total += 1;
            ControlFlow::<()>::Continue(())
        });
        total
    }

    /// The pieces, collected.
    pub fn pieces(&self) -> Vec<Piece> {
        let mut list = Vec::new();
        let _ = self.each(|piece| {
            list.push(piece);
            ControlFlow::<()>::Continue(())
        });
        list
    }
}

/// The piece that a slot of that length gets at `from`, if it gets one: what would cross `limit` is cut there.
#[inline]
fn piece(slot: usize, length: f64, from: f64, limit: f64, smallest: f64) -> Option<Piece> {
    let near = limit - smallest;
    if length <= 0.0 || near <= from {
        return None;
    }
    let to = from + length;
    // The last bits of a sum are noise: what ends there ends at the border.
    let (end, length) = if to < near {
        (to, length)
    } else if to <= limit + smallest {
        (limit, length)
    } else {
        (limit, limit - from)
    };
    Some(Piece { slot: slot as u32, start: from, end, length })
}
