//! The repeat groups of a pattern, beside or inside each other, and their numbers of repetitions.

use std::ops::Range;

use crate::choices::{last_group, least_turns, room_for_groups, share};
use crate::search::{CountSearch, LengthSum};
use crate::turns::Turns;
use crate::{Item, Prefix, Size};

/// The slots of the only group in a pattern with `slots` slots.
#[inline(always)]
pub(crate) fn slots_of_one(pattern: &[Item], slots: usize) -> Range<usize> {
    let group = pattern.iter().enumerate().find_map(|(at, item)| match item {
        Item::Repeat(len) => Some(at..at.saturating_add(*len as usize).min(slots)),
        Item::Slot => None,
    });
    group.unwrap_or_default()
}

/// The sums outside the only group and inside it. `lengths` are the lengths of the slots, with floats not yet
/// stretched.
#[inline(always)]
pub(crate) fn sums_of_one(own: &Range<usize>, sizes: &[Size], lengths: &[f64]) -> (LengthSum, LengthSum) {
    let (mut outside, mut inside) = (LengthSum::default(), LengthSum::default());
    for (slot, (size, length)) in sizes.iter().zip(lengths).enumerate() {
        let sum = if own.contains(&slot) { &mut inside } else { &mut outside };
        sum.add(size, *length);
    }
    (outside, inside)
}

/// The approximate number of repetitions per metre, where the search for the count starts. It uses the written sizes,
/// so it is a constant when they are constants.
#[inline(always)]
pub(crate) fn density_of_one(own: &Range<usize>, sizes: &[Size], extent: f64) -> f64 {
    let mut length = 0.0;
    for (slot, size) in sizes.iter().enumerate() {
        let value = if size.prefix == Prefix::Relative { size.value * extent } else { size.value };
        length += if own.contains(&slot) { value } else { 0.0 };
    }
    length.recip()
}

/// Solves a pattern with one group, as in nearly all splits with repeats. Also returns the stretch of the floats.
#[inline(always)]
pub(crate) fn one(outside: LengthSum, own: LengthSum, density: f64, extent: f64) -> (f64, Turns) {
    if own.nominal() <= 0.0 {
        return (outside.stretch(extent), Turns::NONE);
    }
    if 0.0 < outside.floating || 0.0 < own.floating {
        let (count, stretch) = one_with_floats(outside, own, density, extent);
        (stretch, Turns { count, length: own.absolute + stretch * own.floating, room: f64::INFINITY })
    } else {
        let room = room_for_groups(extent, outside.absolute);
        let (count, cut) = one_without_floats(outside, own, density, extent, room);
        (0.0, Turns { count, length: own.absolute, room: if cut { room } else { f64::INFINITY } })
    }
}

/// The count and the stretch.
#[inline(never)]
fn one_with_floats(outside: LengthSum, own: LengthSum, density: f64, extent: f64) -> (f64, f64) {
    let total = |turns: f64| outside.plus(own, turns);
    let mut search = CountSearch { extent, outside, density, total };
    search.least_stretch(least_turns(0.0 < outside.floating, 1) as f64)
}

/// The count, and whether the last repetition is cut.
#[inline(never)]
fn one_without_floats(outside: LengthSum, own: LengthSum, density: f64, extent: f64, room: f64) -> (f64, bool) {
    let total = |turns: f64| outside.plus(own, turns);
    CountSearch { extent, outside, density, total }.fill(room)
}

/// A repeat group.
#[derive(Clone, Copy, Debug)]
struct GroupState {
    /// The sums of its own slots, without the slots of nested groups.
    own: LengthSum,
    /// The group around it.
    parent: Option<usize>,
    /// The outermost group around it, or the group itself.
    top: usize,
    /// The end of its items in the pattern.
    end: usize,
    /// True if it, or a group inside, has a slot with a length. Otherwise the group is never made.
    live: bool,
    /// The number of live groups before it.
    number: u64,
    /// The number of its repetitions in the whole split.
    times: f64,
}

/// The groups of a pattern in the order in which they open, and the sums outside all of them.
struct RepeatGroups {
    outside: LengthSum,
    list: Vec<GroupState>,
    turns: Vec<Turns>,
    /// The number of groups that can repeat.
    live: u64,
}

/// The same as [`one`] for any pattern. The list has all groups in the order in which they open.
pub(crate) fn several(pattern: &[Item], sizes: &[Size], lengths: &[f64], extent: f64) -> (f64, Vec<Turns>) {
    let mut groups = RepeatGroups::new(pattern, sizes, lengths);
    let stretch = groups.choose(extent);
    (stretch, groups.turns)
}

impl RepeatGroups {
    fn new(pattern: &[Item], sizes: &[Size], lengths: &[f64]) -> Self {
        let mut groups = RepeatGroups { outside: LengthSum::default(), list: Vec::new(), turns: Vec::new(), live: 0 };
        let mut slots = sizes.iter().zip(lengths);
        let mut inside = None;
        for (at, item) in pattern.iter().enumerate() {
            while let Some(group) = inside.filter(|&group: &usize| groups.list[group].end <= at) {
                inside = groups.list[group].parent;
            }
            match item {
                Item::Repeat(len) => {
                    let limit = inside.map_or(pattern.len(), |group| groups.list[group].end);
                    let index = groups.list.len();
                    groups.list.push(GroupState {
                        own: LengthSum::default(),
                        parent: inside,
                        top: inside.map_or(index, |group| groups.list[group].top),
                        end: (at + 1).saturating_add(*len as usize).min(limit),
                        live: false,
                        number: 0,
                        times: 0.0,
                    });
                    inside = Some(index);
                }
                Item::Slot => {
                    let own = inside.map(|group| &mut groups.list[group].own);
                    let sum = own.unwrap_or(&mut groups.outside);
                    if let Some((size, length)) = slots.next() {
                        sum.add(size, *length);
                    }
                }
            }
        }
        groups.turns = vec![Turns::NONE; groups.list.len()];
        groups.number();
        groups
    }

    /// Finds the groups with content and numbers them. A group comes before the groups inside it.
    fn number(&mut self) {
        for index in (0..self.list.len()).rev() {
            let group = &mut self.list[index];
            group.live |= 0.0 < group.own.nominal();
            if let GroupState { live: true, parent: Some(parent), .. } = *group {
                self.list[parent].live = true;
            }
        }
        for group in self.list.iter_mut().filter(|group| group.live) {
            group.number = self.live;
            self.live += 1;
        }
    }

    /// Chooses the counts for `extent` and returns the stretch of the floats.
    fn choose(&mut self, extent: f64) -> f64 {
        if self.live == 0 {
            return self.outside.stretch(extent);
        }
        let (outside, groups) = (self.outside, self.live);
        let one_each = self.deal(groups);
        let floats = 0.0 < one_each.floating;
        let density = groups as f64 / (one_each.nominal() - outside.nominal());
        let total = |turns: f64| self.deal(turns as u64);
        let mut search = CountSearch { extent, outside, density, total };
        let (turns, stretch) = if floats {
            search.least_stretch(least_turns(0.0 < outside.floating, groups) as f64)
        } else {
            let room = room_for_groups(extent, outside.absolute);
            let (turns, cut) = search.fill(room);
            if cut {
                self.cut_last(turns as u64, room);
            }
            (turns, 0.0)
        };
        self.deal(turns as u64);
        self.measure(stretch);
        stretch
    }

    /// Deals out `turns` repetitions and returns the sums with the groups expanded.
    fn deal(&mut self, turns: u64) -> LengthSum {
        let mut sum = self.outside;
        for index in 0..self.list.len() {
            let around = self.list[index].parent.map_or(1.0, |parent| self.list[parent].times);
            let group = &mut self.list[index];
            let count = if group.live { share(turns, self.live, group.number) } else { 0 };
            group.times = around * count as f64;
            self.turns[index].count = count as f64;
            sum = sum.plus(group.own, group.times);
        }
        sum
    }

    /// Gives the group with the last of `turns` repetitions the room that the other groups leave.
    fn cut_last(&mut self, turns: u64, room: f64) {
        self.deal(turns);
        let last = last_group(turns, self.live);
        let Some(group) = self.list.iter().find(|group| group.live && group.number == last) else { return };
        let top = group.top;
        let others = self.list.iter().filter(|group| group.top != top);
        self.turns[top].room = room - others.map(|group| group.times * group.own.absolute).sum::<f64>();
    }

    /// Computes the final length of one repetition of each group.
    fn measure(&mut self, stretch: f64) {
        for (index, group) in self.list.iter().enumerate().rev() {
            let turns = &mut self.turns[index];
            turns.length += group.own.absolute + stretch * group.own.floating;
            let all = turns.length * turns.count;
            if let Some(parent) = group.parent {
                self.turns[parent].length += all;
            }
        }
    }
}
