//! Solves a pattern of sizes in an extent.

use std::ops::ControlFlow;

use crate::choices::{is_extent, is_size, smallest_piece};
use crate::groups;
use crate::search::LengthSum;
use crate::turns::Turns;
use crate::{Group, Item, Piece, Prefix, Size};

/// The final length of each slot and the number of repetitions of each group.
#[derive(Clone, Debug)]
pub struct Solution<'a> {
    pattern: &'a [Item],
    pub(crate) lengths: &'a [f64],
    pub(crate) extent: f64,
    repeats: Repetitions,
}

/// The repetitions of the groups. The pattern decides which field is used.
#[derive(Clone, Debug)]
struct Repetitions {
    /// The group of a pattern with one group.
    one: Turns,
    /// The groups of a pattern with several groups, in the order in which they open.
    several: Vec<Turns>,
}

/// The number of groups in a pattern. When the pattern is a constant and calls are inlined, the compiler keeps one case
/// only.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Grouping {
    None,
    One,
    Several,
}

impl Grouping {
    #[inline(always)]
    fn of(pattern: &[Item], slots: usize) -> Self {
        // An item that is not a slot is a group.
        match pattern.len() - slots {
            0 => Grouping::None,
            1 => Grouping::One,
            _ => Grouping::Several,
        }
    }
}

/// Solves a split over `extent` metres. `sizes` has one size per slot of the pattern. `lengths` has one entry per slot
/// and receives its final length: zero for a slot that gets no piece.
///
/// *split operation*, *Subdivision split*: absolute and relative sizes are taken as they are, and floating sizes share
/// the rest. Repetitions are chosen for the least stretch. Slots that do not fit are cut or dropped. The extent must be
/// positive and at most 1e150; any other extent gives no pieces. Patterns with at most one group need no allocation.
///
/// # Panics
/// Panics when `sizes` and `lengths` differ in length or have more entries than the pattern has items. Other
/// inconsistent lists give some solution or none.
#[inline(always)]
pub fn solve<'a>(pattern: &'a [Item], sizes: &[Size], lengths: &'a mut [f64], extent: f64) -> Solution<'a> {
    assert!(sizes.len() == lengths.len() && sizes.len() <= pattern.len(), "one size and one length a slot");
    let extent = if is_extent(extent) { extent } else { 0.0 };
    let sum = measure(sizes, lengths, extent);
    let (mut by, mut repeats) = choose(pattern, sizes, lengths, sum, extent);
    if has_slivers(sizes, lengths, by, extent) {
        let others;
        (by, repeats, others) = without_slivers(pattern, sizes, extent);
        // Copied by value: lengths whose address is not taken stay in registers.
        lengths.iter_mut().zip(others).for_each(|(length, other)| *length = other);
    }
    for (size, length) in sizes.iter().zip(lengths.iter_mut()) {
        *length *= if size.prefix == Prefix::Floating { by } else { 1.0 };
    }
    Solution { pattern, lengths, extent, repeats }
}

/// The same as [`solve`], compiled once: for splits with many sizes or with sizes that are not constants.
///
/// # Panics
/// The same as [`solve`].
#[inline(never)]
pub fn solve_any<'a>(pattern: &'a [Item], sizes: &[Size], lengths: &'a mut [f64], extent: f64) -> Solution<'a> {
    solve(pattern, sizes, lengths, extent)
}

/// Sets the lengths, with floats not yet stretched, and returns their sum.
#[inline(always)]
fn measure(sizes: &[Size], lengths: &mut [f64], extent: f64) -> LengthSum {
    let mut sum = LengthSum::default();
    for (length, size) in lengths.iter_mut().zip(sizes) {
        *length = own_length(size, extent);
        sum.add(size, *length);
    }
    if sum.floating == f64::INFINITY { weigh_less(sizes, lengths) } else { sum }
}

/// The length of a slot before floats are stretched.
#[inline(always)]
fn own_length(size: &Size, extent: f64) -> f64 {
    let value = size.value;
    match size.prefix {
        // A size longer than any extent is cut anyway; the limit keeps the sums finite.
        Prefix::Absolute if is_size(value) && smallest_piece(extent) < value => value.min(LONGEST),
        // Both sides of the comparison are shares of the extent.
        Prefix::Relative if is_extent(value) && smallest_piece(1.0) < value => value * extent,
        Prefix::Floating if is_size(value) => value,
        _ => 0.0,
    }
}

/// Chooses the stretch of the floats and the repetitions of the groups.
#[inline(always)]
fn choose(pattern: &[Item], sizes: &[Size], lengths: &[f64], sum: LengthSum, extent: f64) -> (f64, Repetitions) {
    match Grouping::of(pattern, sizes.len()) {
        Grouping::None => (sum.stretch(extent), Repetitions { one: Turns::NONE, several: Vec::new() }),
        Grouping::One => {
            let own = groups::slots_of_one(pattern, sizes.len());
            let (outside, inside) = groups::sums_of_one(&own, sizes, lengths);
            let density = groups::density_of_one(&own, sizes, extent);
            let (by, one) = groups::one(outside, inside, density, extent);
            (by, Repetitions { one, several: Vec::new() })
        }
        Grouping::Several => {
            let (by, several) = groups::several(pattern, sizes, lengths, extent);
            (by, Repetitions { one: Turns::NONE, several })
        }
    }
}

#[inline(always)]
fn floats<'l>(sizes: &[Size], lengths: &'l mut [f64]) -> impl Iterator<Item = &'l mut f64> {
    lengths.iter_mut().zip(sizes).filter(|(_, size)| size.prefix == Prefix::Floating).map(|(length, _)| length)
}

/// Returns true if this stretch leaves some floats too short for a piece while other floats are long enough.
#[inline(always)]
fn has_slivers(sizes: &[Size], lengths: &[f64], by: f64, extent: f64) -> bool {
    let smallest = smallest_piece(extent);
    // A constant when the sizes are constants. A plain loop, because compilers do not unroll filtered loops.
    let (mut least, mut most) = (f64::MAX, 0.0);
    for (size, weight) in sizes.iter().zip(lengths) {
        if size.prefix == Prefix::Floating && 0.0 < *weight {
            least = if *weight < least { *weight } else { least };
            most = if most < *weight { *weight } else { most };
        }
    }
    least * by <= smallest && smallest < most * by
}

/// Solves without the floats that get too little room. The other floats get that room, and another count may be better.
/// Also returns the lengths, with floats not yet stretched.
#[cold]
#[inline(never)]
fn without_slivers(pattern: &[Item], sizes: &[Size], extent: f64) -> (f64, Repetitions, Vec<f64>) {
    let smallest = smallest_piece(extent);
    let mut lengths = vec![0.0; sizes.len()];
    let mut sum = measure(sizes, &mut lengths, extent);
    loop {
        let (by, repeats) = choose(pattern, sizes, &lengths, sum, extent);
        if !has_slivers(sizes, &lengths, by, extent) {
            return (by, repeats, lengths);
        }
        floats(sizes, &mut lengths).filter(|length| **length * by <= smallest).for_each(|length| *length = 0.0);
        sum = total(sizes, &lengths);
    }
}

fn total(sizes: &[Size], lengths: &[f64]) -> LengthSum {
    let mut sum = LengthSum::default();
    sizes.iter().zip(lengths).for_each(|(size, length)| sum.add(size, *length));
    sum
}

/// Longer than any extent that is split.
const LONGEST: f64 = 1e160;

/// A power of two. It makes any sum of weights finite and keeps every weight that matters beside the others above zero.
const LIGHTER: f64 = 1.0 / (1u128 << 100) as f64;

/// Scales weights whose sum overflows. Their ratios stay.
#[cold]
fn weigh_less(sizes: &[Size], lengths: &mut [f64]) -> LengthSum {
    floats(sizes, lengths).for_each(|length| *length *= LIGHTER);
    total(sizes, lengths)
}

/// A position in a pattern: the numbers of items, slots and groups before it.
#[derive(Clone, Copy, Debug, Default)]
struct PatternPosition {
    item: usize,
    slot: usize,
    group: usize,
}

impl Solution<'_> {
    #[inline(always)]
    fn grouping(&self) -> Grouping {
        Grouping::of(self.pattern, self.lengths.len())
    }

    /// The number of repetitions of a group in each repetition of the group around it. Groups are numbered in the order
    /// in which they open.
    pub fn count(&self, group: usize) -> u64 {
        self.turns(group).count as u64
    }

    /// An upper bound of the number of pieces, in constant time per item.
    #[inline]
    pub fn at_most(&self) -> u64 {
        let slots = self.lengths.len();
        match self.grouping() {
            Grouping::None => slots as u64,
            Grouping::One => {
                let inside = groups::slots_of_one(self.pattern, slots).len();
                (slots - inside) as u64 + (self.repeats.one.count as u64).saturating_mul(inside as u64)
            }
            Grouping::Several => self.slots_made(),
        }
    }

    /// The number of slots with the groups expanded.
    fn slots_made(&self) -> u64 {
        // The open groups: the number of times that the items around a group are made, and the end of the group.
        let mut open: Vec<(u64, usize)> = Vec::new();
        let (mut sum, mut times, mut group) = (0u64, 1u64, 0);
        for (at, item) in self.pattern.iter().enumerate() {
            while let Some((outer, _)) = open.pop_if(|(_, end)| *end <= at) {
                times = outer;
            }
            match item {
                Item::Slot => sum = sum.saturating_add(times),
                Item::Repeat(len) => {
                    let around = open.last().map_or(self.pattern.len(), |(_, end)| *end);
                    open.push((times, (at + 1).saturating_add(*len as usize).min(around)));
                    times = times.saturating_mul(self.count(group));
                    group += 1;
                }
            }
        }
        sum
    }

    /// The repetitions of a group. Groups are numbered in the order in which they open.
    #[inline(always)]
    pub(crate) fn turns(&self, group: usize) -> Turns {
        match self.grouping() {
            Grouping::One if group == 0 => self.repeats.one,
            Grouping::Several => self.repeats.several.get(group).copied().unwrap_or(Turns::NONE),
            Grouping::None | Grouping::One => Turns::NONE,
        }
    }

    /// Calls `visit` for every piece, from the low end to the high end, until it returns a break.
    pub fn each<B>(&self, mut visit: impl FnMut(Piece) -> ControlFlow<B>) -> ControlFlow<B> {
        let (mut cursor, mut next, mut stop) = (self.cursor(), PatternPosition::default(), self.pattern.len());
        // The open groups, each with its first position and the end of the group around it.
        let mut open: Vec<(Group, PatternPosition, usize)> = Vec::new();
        loop {
            if next.item == stop {
                let Some((group, first, outer_stop)) = open.last_mut() else { return ControlFlow::Continue(()) };
                if cursor.turn(group) {
                    next = *first;
                } else {
                    stop = *outer_stop;
                    open.pop();
                }
            } else if let Item::Repeat(len) = self.pattern[next.item] {
                let mut group = cursor.open(self, next.group);
                next = PatternPosition { item: next.item + 1, group: next.group + 1, ..next };
                let end = next.item.saturating_add(len as usize).min(stop);
                if cursor.turn(&mut group) {
                    open.push((group, next, stop));
                    stop = end;
                } else {
                    let items = &self.pattern[next.item..end];
                    let slots = items.iter().filter(|item| matches!(item, Item::Slot)).count();
                    next =
                        PatternPosition { item: end, slot: next.slot + slots, group: next.group + items.len() - slots };
                }
            } else {
                if next.slot < self.lengths.len()
                    && let Some(piece) = cursor.slot(next.slot)
                {
                    visit(piece)?;
                }
                next = PatternPosition { item: next.item + 1, slot: next.slot + 1, ..next };
            }
        }
    }

    /// The number of pieces. The time is linear in this number, as for [`Solution::each`] and [`Solution::pieces`].
    /// Tiny sizes can give more pieces than memory holds, so check [`Solution::at_most`] first.
    #[inline]
    pub fn total(&self) -> u64 {
        let mut total = 0;
        let _ = self.each(|_| {
            total += 1;
            ControlFlow::<()>::Continue(())
        });
        total
    }

    /// All pieces in a list.
    pub fn pieces(&self) -> Vec<Piece> {
        let mut list = Vec::new();
        let _ = self.each(|piece| {
            list.push(piece);
            ControlFlow::<()>::Continue(())
        });
        list
    }
}

/// The piece that a slot of length `length` gets at `from`, if any. A piece that would cross `limit` is cut there.
#[inline(always)]
pub(crate) fn piece(slot: usize, length: f64, from: f64, limit: f64, smallest: f64) -> Option<Piece> {
    let near = limit - smallest;
    if length <= 0.0 || near <= from {
        return None;
    }
    let to = from + length;
    // The last bits of a sum are rounding noise: a piece that ends within the noise ends at the border.
    let (end, length) = if to < near {
        (to, length)
    } else if to <= limit + smallest {
        (limit, length)
    } else {
        (limit, limit - from)
    };
    Some(Piece { slot: slot as u32, start: from, end, length })
}
