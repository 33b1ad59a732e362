//! Sizes and an extent → pieces. Pure: no geometry, no allocation for a handful of repeat groups.
//!
//! What the reference leaves open is decided in one named place each: `usable` (which sizes count), `SLIVER` (how
//! short a cut remainder may be) and, in `groups.rs`, which repetition count is better and how groups share repetitions.

use std::ops::ControlFlow;

use super::counts::Counts;
use super::groups::{Groups, Sum};
use super::{Item, Piece, Prefix, Size};

/// A remainder shorter than this share of the extent is rounding, not a piece.
pub(super) const SLIVER: f64 = 1e-12;

/// The final length of each slot, and how often each group of the pattern repeats.
#[derive(Clone, Debug)]
pub struct Solution<'a> {
    pattern: &'a [Item],
    lengths: &'a [Size],
    extent: f64,
    /// `None` for a pattern without groups.
    repeats: Option<Repeats>,
}

/// What repeat groups add to a solution.
#[derive(Clone, Debug, Default)]
struct Repeats {
    counts: Counts,
    /// Without floats: the top-level group whose last repetition is cut, and the room that group has.
    cut: Option<(usize, f64)>,
}

/// Solves a split over `extent` (not negative). `sizes` holds one entry a written slot; their values become final
/// lengths in metres, zero for a slot that is not made.
///
/// *split operation*, *Subdivision split*: absolute and relative sizes are taken as they are, floating ones share what
/// is left; repetitions are chosen for the least stretch; what does not fit is cut or not made.
#[inline]
pub fn solve<'a>(pattern: &'a [Item], sizes: &'a mut [Size], extent: f64) -> Solution<'a> {
    let mut sum = Sum::default();
    for size in sizes.iter_mut() {
        if size.prefix == Prefix::Relative {
            *size = Size::absolute(size.value * extent);
        }
        size.value = usable(size.value);
        match size.prefix {
            Prefix::Floating => sum.floating += size.value,
            Prefix::Absolute | Prefix::Relative => sum.absolute += size.value,
        }
    }
    // An item that is no slot is a group.
    let repeats = if pattern.len() == sizes.len() { None } else { Some(repeat(pattern, sizes, extent, &mut sum)) };
    if 0.0 < sum.floating {
        let stretch = sum.stretch(extent).max(0.0);
        for size in sizes.iter_mut().filter(|size| size.prefix == Prefix::Floating) {
            size.value *= stretch;
        }
    }
    Solution { pattern, lengths: sizes, extent, repeats }
}

/// Chooses counts for the groups; `sum` becomes the sum with the groups expanded.
fn repeat(pattern: &[Item], sizes: &[Size], extent: f64, sum: &mut Sum) -> Repeats {
    let groups = Groups::new(pattern, sizes);
    if groups.is_empty() {
        return Repeats::default();
    }
    if 0.0 < sum.floating {
        let counts = groups.least_stretch(extent);
        *sum = groups.total(&counts);
        Repeats { counts, cut: None }
    } else {
        let (counts, cut) = groups.fill(extent);
        Repeats { counts, cut }
    }
}

/// Sizes that make a piece: positive and finite. Everything else makes none (*Subdivision split*: negative and zero sizes).
fn usable(value: f64) -> f64 {
    if value.is_finite() && 0.0 < value { value } else { 0.0 }
}

impl Solution<'_> {
    /// How often the group repeats, counting groups in the order in which they open.
    pub fn count(&self, group: usize) -> u64 {
        self.repeats.as_ref().map_or(0, |repeats| repeats.counts.get(group))
    }

    /// An upper bound of the number of pieces, in constant time a written slot.
    #[inline]
    pub fn at_most(&self) -> u64 {
        match &self.repeats {
            None => self.lengths.len() as u64,
            Some(repeats) => at_most(self.pattern, &repeats.counts, &mut 0),
        }
    }

    /// Calls `visit` for every piece, from the low end to the high end, until it says stop.
    #[inline]
    pub fn each<B>(&self, mut visit: impl FnMut(Piece) -> ControlFlow<B>) -> ControlFlow<B> {
        match &self.repeats {
            None => {
                let mut from = 0.0;
                for (slot, size) in self.lengths.iter().enumerate() {
                    if let Some(piece) = piece(slot, size.value, from, self.extent, self.extent * SLIVER) {
                        from = piece.end;
                        visit(piece)?;
                    }
                }
            }
            Some(repeats) => {
                let mut walk = Walk { solution: self, repeats, visit: &mut visit, slot: 0, group: 0 };
                walk.items(self.pattern, 0.0, self.extent, true)?;
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

    /// Lengths of consecutive items, groups expanded.
    fn length(&self, repeats: &Repeats, items: &[Item], mut slot: usize, mut group: usize) -> f64 {
        let mut sum = 0.0;
        let mut at = 0;
        while at < items.len() {
            match items[at] {
                Item::Slot => {
                    sum += self.lengths[slot].value;
                    slot += 1;
                    at += 1;
                }
                Item::Repeat(len) => {
                    let inner = &items[at + 1..at + 1 + len as usize];
                    sum += repeats.counts.get(group) as f64 * self.length(repeats, inner, slot, group + 1);
                    slot += slots_in(inner);
                    group += 1 + groups_in(inner);
                    at += 1 + inner.len();
                }
            }
        }
        sum
    }
}

/// The piece that a slot of that length gets at `from`, if it gets one: what would cross `limit` is cut there.
#[inline]
fn piece(slot: usize, length: f64, from: f64, limit: f64, sliver: f64) -> Option<Piece> {
    if length <= 0.0 || limit - from <= sliver {
        return None;
    }
    let to = from + length;
    // The last bits of a sum are noise: what ends there ends at the border.
    let end = if limit - sliver <= to { limit } else { to };
    let length = if to <= limit + sliver { length } else { limit - from };
    Some(Piece { slot: slot as u32, start: from, end, length })
}

fn at_most(pattern: &[Item], counts: &Counts, group: &mut usize) -> u64 {
    let mut sum = 0u64;
    let mut at = 0;
    while at < pattern.len() {
        match pattern[at] {
            Item::Slot => sum = sum.saturating_add(1),
            Item::Repeat(len) => {
                let count = counts.get(*group);
                *group += 1;
                let inner = at_most(&pattern[at + 1..at + 1 + len as usize], counts, group);
                sum = sum.saturating_add(inner.saturating_mul(count));
                at += len as usize;
            }
        }
        at += 1;
    }
    sum
}

/// Walks a pattern with groups and hands out pieces.
struct Walk<'s, 'a, F> {
    solution: &'s Solution<'a>,
    repeats: &'s Repeats,
    visit: &'s mut F,
    slot: usize,
    group: usize,
}

impl<F> Walk<'_, '_, F> {
    /// Lays out items from `start`, nothing beyond `limit`; gives the end.
    fn items<B>(&mut self, items: &[Item], start: f64, limit: f64, top: bool) -> ControlFlow<B, f64>
    where
        F: FnMut(Piece) -> ControlFlow<B>,
    {
        let sliver = self.solution.extent * SLIVER;
        let mut from = start;
        let mut at = 0;
        while at < items.len() {
            match items[at] {
                Item::Slot => {
                    let (slot, length) = (self.slot, self.solution.lengths[self.slot].value);
                    self.slot += 1;
                    at += 1;
                    if let Some(piece) = piece(slot, length, from, limit, sliver) {
                        from = piece.end;
                        (self.visit)(piece)?;
                    }
                }
                Item::Repeat(len) => {
                    let inner = &items[at + 1..at + 1 + len as usize];
                    from = self.group(inner, from, limit, top)?;
                    at += 1 + inner.len();
                }
            }
        }
        ControlFlow::Continue(from)
    }

    fn group<B>(&mut self, inner: &[Item], start: f64, limit: f64, top: bool) -> ControlFlow<B, f64>
    where
        F: FnMut(Piece) -> ControlFlow<B>,
    {
        let (slot, group) = (self.slot, self.group);
        let count = self.repeats.counts.get(group);
        let length = self.solution.length(self.repeats, inner, slot, group + 1);
        let limit = match self.repeats.cut {
            Some((cut, room)) if top && cut == group => limit.min(start + room),
            _ => limit,
        };
        let sliver = self.solution.extent * SLIVER;
        let mut end = start;
        for turn in 0..count {
            if limit <= end {
                break;
            }
            // The border of a repetition is measured from the group's start, so that a million of them don't drift, and
            // the last piece snaps to it, so that the next one starts on the same bits.
            let border = start + (turn + 1) as f64 * length;
            let border = if limit - sliver <= border { limit } else { border };
            (self.slot, self.group) = (slot, group + 1);
            end = self.items(inner, end, border, false)?;
        }
        (self.slot, self.group) = (slot + slots_in(inner), group + 1 + groups_in(inner));
        ControlFlow::Continue(end)
    }
}

fn slots_in(items: &[Item]) -> usize {
    items.iter().filter(|item| matches!(item, Item::Slot)).count()
}

fn groups_in(items: &[Item]) -> usize {
    items.len() - slots_in(items)
}
