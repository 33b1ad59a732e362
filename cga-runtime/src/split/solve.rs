//! Sizes and an extent → pieces. Pure: no geometry, no allocation for up to [`INLINE`] repeat groups.
//!
//! What the reference leaves open is decided here, each choice in one named function: [`usable`] (which sizes count),
//! [`nearer`] (which of two repetition counts is better), [`Groups::deal`] (how parallel and nested groups share
//! repetitions) and [`SLIVER`] (how short a cut remainder may be).

use std::ops::ControlFlow;

use super::{Item, Piece, Prefix, Size};

/// Groups that need no allocation.
const INLINE: usize = 4;

/// A remainder shorter than this share of the extent is rounding, not a piece.
const SLIVER: f64 = 1e-12;

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

/// Whether `b`, the larger count, is as good as `a`: its stretch is at least as near to 1. On a tie in f64 the larger
/// count wins, as `{ 2 }* | ~1` in 10 does (*Subdivision split*: five pieces of 2 and no room for the float).
fn nearer(a: f64, b: f64) -> bool {
    (b - 1.0).abs() <= (a - 1.0).abs()
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

/// Absolute and floating sums.
#[derive(Clone, Copy, Debug, Default)]
struct Sum {
    absolute: f64,
    floating: f64,
}

impl Sum {
    fn nominal(self) -> f64 {
        self.absolute + self.floating
    }

    /// The common factor of all floats.
    fn stretch(self, extent: f64) -> f64 {
        if self.floating == 0.0 { 0.0 } else { (extent - self.absolute) / self.floating }
    }

    fn plus(self, other: Sum, times: f64) -> Sum {
        Sum { absolute: self.absolute + times * other.absolute, floating: self.floating + times * other.floating }
    }
}

/// A repeat group: what it holds itself, and the group around it.
#[derive(Clone, Copy, Debug, Default)]
struct Group {
    own: Sum,
    /// Index of the enclosing group, or `usize::MAX` at the top.
    parent: usize,
}

/// The groups of a pattern in the order in which they open, and what stands outside all of them.
struct Groups {
    outside: Sum,
    list: Inline<Group>,
    /// Those that can repeat: the others hold nothing and are never made.
    live: Inline<usize>,
}

impl Groups {
    fn new(pattern: &[Item], sizes: &[Size]) -> Self {
        fn add(items: &[Item], sizes: &[Size], parent: usize, slot: &mut usize, groups: &mut Groups) {
            let mut at = 0;
            while at < items.len() {
                match items[at] {
                    Item::Slot => {
                        let size = sizes[*slot];
                        *slot += 1;
                        let sum = match groups.list.get_mut(parent) {
                            Some(group) => &mut group.own,
                            None => &mut groups.outside,
                        };
                        match size.prefix {
                            Prefix::Floating => sum.floating += size.value,
                            Prefix::Absolute | Prefix::Relative => sum.absolute += size.value,
                        }
                    }
                    Item::Repeat(len) => {
                        let index = groups.list.len();
                        groups.list.push(Group { own: Sum::default(), parent });
                        add(&items[at + 1..at + 1 + len as usize], sizes, index, slot, groups);
                        at += len as usize;
                    }
                }
                at += 1;
            }
        }
        let mut groups = Groups { outside: Sum::default(), list: Inline::default(), live: Inline::default() };
        add(pattern, sizes, usize::MAX, &mut 0, &mut groups);
        for index in 0..groups.list.len() {
            if groups.holds_something(index) {
                groups.live.push(index);
            }
        }
        groups
    }

    fn is_empty(&self) -> bool {
        self.live.len() == 0
    }

    fn holds_something(&self, index: usize) -> bool {
        (index..self.list.len()).any(|inner| {
            let mut at = inner;
            while at != index && at != usize::MAX {
                at = self.list[at].parent;
            }
            at == index && 0.0 < self.list[inner].own.nominal()
        })
    }

    /// The counts after dealing out `turns` repetitions one by one, group after group in writing order, and over again:
    /// groups beside each other get the same number, the first ones the odd one; so do nested ones. The reference shows
    /// parallel groups sharing the space evenly (*Subdivision split*, "Repeat split—Parallel") and gives no numbers.
    fn deal(&self, turns: u64) -> Counts {
        let each = turns / self.live.len() as u64;
        let odd = (turns % self.live.len() as u64) as usize;
        let mut counts = Counts::zero(self.list.len());
        for turn in 0..self.live.len() {
            counts.set(self.live[turn], each + u64::from(turn < odd));
        }
        counts
    }

    /// All sums with the groups expanded.
    fn total(&self, counts: &Counts) -> Sum {
        let mut sum = self.outside;
        for index in 0..self.list.len() {
            let mut times = 1.0;
            let mut at = index;
            while at != usize::MAX {
                times *= counts.get(at) as f64;
                at = self.list[at].parent;
            }
            sum = sum.plus(self.list[index].own, times);
        }
        sum
    }

    /// The largest number of turns whose nominal sizes fit into `extent`, but at least `least`. The sum grows with the
    /// turns, nearly evenly where no group is nested, so the search starts where that would put it.
    fn last(&self, least: u64, extent: f64) -> u64 {
        let fits = |turns: u64| self.total(&self.deal(turns)).nominal() <= extent;
        let round = self.total(&self.deal(self.live.len() as u64)).nominal() - self.outside.nominal();
        let guess = (extent - self.outside.nominal()) / round * self.live.len() as f64;
        let mut good = if guess.is_finite() { (guess as u64).clamp(least, MOST - 1) } else { least };
        // Down to one that fits, in growing steps, then up again.
        let mut step = 1;
        while least < good && !fits(good) {
            good = good.saturating_sub(step).max(least);
            step *= 2;
        }
        let mut step = 1;
        while good + step < MOST && fits(good + step) {
            good += step;
            step *= 2;
        }
        while 1 < step {
            step /= 2;
            if good + step < MOST && fits(good + step) {
                good += step;
            }
        }
        good
    }

    /// With floats somewhere: the counts whose common stretch is nearest to 1. It falls as counts grow, so only the
    /// last one with a stretch of 1 or more and the one after it can win.
    fn least_stretch(&self, extent: f64) -> Counts {
        let least = if 0.0 < self.outside.floating { 0 } else { self.live.len() as u64 };
        let low = self.last(least, extent);
        let stretch = |turns| self.total(&self.deal(turns)).stretch(extent);
        let high = low + 1;
        let fits = self.total(&self.deal(high)).absolute <= extent;
        self.deal(if fits && nearer(stretch(low), stretch(high)) { high } else { low })
    }

    /// Without floats: repetitions until the room that the sizes outside leave is full; the last one is cut.
    fn fill(&self, extent: f64) -> (Counts, Option<(usize, f64)>) {
        let room = extent - self.outside.absolute;
        let sliver = extent * SLIVER;
        if room <= sliver {
            return (Counts::zero(self.list.len()), None);
        }
        let used = |turns: u64| self.total(&self.deal(turns)).absolute - self.outside.absolute;
        let full = self.last(0, extent + sliver);
        if room - used(full) <= sliver {
            return (self.deal(full), None);
        }
        // The repetition that crosses the border: the group that gets it has room for what is left besides its own.
        let mut turns = full + 1;
        while used(turns) <= used(full) {
            turns += 1;
        }
        let counts = self.deal(turns);
        let mut top = self.live[((turns - 1) % self.live.len() as u64) as usize];
        while self.list[top].parent != usize::MAX {
            top = self.list[top].parent;
        }
        let mut without = counts.clone();
        without.set(top, 0);
        let others = self.total(&without).absolute - self.outside.absolute;
        (counts, Some((top, room - others)))
    }
}

/// No pattern is repeated more often; every caller has a lower limit of its own.
const MOST: u64 = 1 << 48;

/// A list that lives on the stack while it is short.
#[derive(Clone, Debug)]
struct Inline<T> {
    short: [T; INLINE],
    len: usize,
    long: Vec<T>,
}

impl<T: Copy + Default> Default for Inline<T> {
    fn default() -> Self {
        Inline { short: [T::default(); INLINE], len: 0, long: Vec::new() }
    }
}

impl<T: Copy + Default> Inline<T> {
    fn push(&mut self, value: T) {
        if self.len < INLINE {
            self.short[self.len] = value;
        } else {
            self.long.push(value);
        }
        self.len += 1;
    }

    fn len(&self) -> usize {
        self.len
    }

    fn get_mut(&mut self, index: usize) -> Option<&mut T> {
        if self.len <= index {
            None
        } else if index < INLINE {
            Some(&mut self.short[index])
        } else {
            self.long.get_mut(index - INLINE)
        }
    }
}

impl<T> std::ops::Index<usize> for Inline<T> {
    type Output = T;
    fn index(&self, index: usize) -> &T {
        if index < INLINE { &self.short[index] } else { &self.long[index - INLINE] }
    }
}

/// Repetitions by group.
#[derive(Clone, Debug, Default)]
struct Counts(Inline<u64>);

impl Counts {
    fn zero(len: usize) -> Self {
        let mut counts = Counts::default();
        for _ in 0..len {
            counts.0.push(0);
        }
        counts
    }

    fn get(&self, group: usize) -> u64 {
        if group < self.0.len() { self.0[group] } else { 0 }
    }

    fn set(&mut self, group: usize, count: u64) {
        if let Some(slot) = self.0.get_mut(group) {
            *slot = count;
        }
    }
}
