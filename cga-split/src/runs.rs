//! A pattern with groups, unrolled: runs of slots beside each other, from the low end to the high end.

use std::ops::Range;

use crate::Item;
use crate::choices::smallest_piece;

/// The repetitions of a group.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Turns {
    /// The number of repetitions in each repetition of the group around it: a whole number.
    pub(crate) count: f64,
    /// The final length of one repetition.
    pub(crate) length: f64,
    /// The room for all repetitions. The last one may be cut.
    pub(crate) room: f64,
}

impl Turns {
    pub(crate) const NONE: Turns = Turns { count: 0.0, length: 0.0, room: f64::INFINITY };

    /// The end of the room of a group that begins at `start`.
    #[inline]
    pub(crate) fn limit(&self, start: f64, limit: f64, smallest: f64) -> f64 {
        let end = start + self.room;
        if limit - smallest <= end { limit } else { end }
    }

    /// The end of repetition `number`, counted from 1, of a group that begins at `start`.
    ///
    /// Borders are measured from the group's start. So a million repetitions do not drift, and the computation of one
    /// does not wait for the one before it.
    #[inline]
    pub(crate) fn border(&self, number: f64, start: f64, limit: f64, smallest: f64) -> f64 {
        let border = start + number * self.length;
        if limit - smallest <= border { limit } else { border }
    }
}

/// Consecutive slots to lay out.
#[derive(Clone, Debug)]
pub(crate) struct Run {
    pub(crate) slots: Range<usize>,
    pub(crate) start: f64,
    /// The border that pieces do not cross.
    pub(crate) limit: f64,
}

/// The runs of a pattern with one group: the slots before it, its own slots once per repetition, the slots after it.
#[derive(Clone, Debug)]
pub(crate) struct OneGroup {
    own: Range<usize>,
    slots: usize,
    turns: Turns,
    extent: f64,
    smallest: f64,
    at: At,
    /// The number of repetitions begun.
    number: f64,
    /// The start of the group, the end of its room and the end of its last repetition.
    start: f64,
    limit: f64,
    border: f64,
    /// True if there is no room for the group.
    is_empty: bool,
}

/// The next run.
#[derive(Clone, Copy, Debug, PartialEq)]
enum At {
    Before,
    First,
    Other,
    End,
}

impl OneGroup {
    #[inline(always)]
    pub(crate) fn new(own: Range<usize>, slots: usize, turns: Turns, extent: f64) -> Self {
        let smallest = smallest_piece(extent);
        let at = if own.start == 0 { At::First } else { At::Before };
        OneGroup {
            own,
            slots,
            turns,
            extent,
            smallest,
            at,
            number: 0.0,
            start: 0.0,
            limit: 0.0,
            border: 0.0,
            is_empty: false,
        }
    }

    /// The next run. `end` is the end of the last one.
    #[inline(always)]
    pub(crate) fn next(&mut self, end: f64) -> Option<Run> {
        match self.at {
            At::Before => {
                self.at = At::First;
                return Some(Run { slots: 0..self.own.start, start: 0.0, limit: self.extent });
            }
            At::First => {
                self.at = At::Other;
                (self.start, self.border) = (end, end);
                self.limit = self.turns.limit(end, self.extent, self.smallest);
                self.is_empty = self.limit - end <= self.smallest;
            }
            At::Other => {}
            At::End => return None,
        }
        // A repetition fills its room exactly, without rounding errors.
        let start = self.border;
        if self.number < self.turns.count && start < self.limit && !self.is_empty {
            self.number += 1.0;
            self.border = self.turns.border(self.number, self.start, self.limit, self.smallest);
            return Some(Run { slots: self.own.clone(), start, limit: self.border });
        }
        self.at = At::End;
        (self.own.end < self.slots).then_some(Run { slots: self.own.end..self.slots, start, limit: self.extent })
    }
}

/// The runs of any pattern.
#[derive(Debug)]
pub(crate) struct AnyGroups<'s> {
    pattern: &'s [Item],
    turns: &'s [Turns],
    smallest: f64,
    /// The next position, and the ends of the current group's items and room.
    next: Counts,
    stop: usize,
    limit: f64,
    /// The groups whose repetitions are under way.
    open: Vec<Open>,
}

/// A position in a pattern: the numbers of items, slots and groups before it.
#[derive(Clone, Copy, Debug, Default)]
struct Counts {
    item: usize,
    slot: usize,
    group: usize,
}

/// A group while its repetitions are laid out.
#[derive(Clone, Copy, Debug)]
struct Open {
    first: Counts,
    turns: Turns,
    /// The number of repetitions begun.
    number: f64,
    start: f64,
    /// The end of its room.
    limit: f64,
    /// The values of `stop` and `limit` before it opened.
    outer_stop: usize,
    outer_limit: f64,
}

impl<'s> AnyGroups<'s> {
    pub(crate) fn new(pattern: &'s [Item], turns: &'s [Turns], extent: f64) -> Self {
        let smallest = smallest_piece(extent);
        AnyGroups {
            pattern,
            turns,
            smallest,
            next: Counts::default(),
            stop: pattern.len(),
            limit: extent,
            open: Vec::new(),
        }
    }

    /// The next run. `end` is the end of the last one.
    pub(crate) fn next(&mut self, mut end: f64) -> Option<Run> {
        loop {
            if self.next.item == self.stop {
                let open = self.open.last_mut()?;
                // A repetition fills its room exactly, without rounding errors.
                end = self.limit;
                if open.number < open.turns.count && end < open.limit {
                    self.next = open.first;
                    open.number += 1.0;
                    self.limit = open.turns.border(open.number, open.start, open.limit, self.smallest);
                } else {
                    (self.stop, self.limit) = (open.outer_stop, open.outer_limit);
                    self.open.pop();
                }
            } else if let Item::Repeat(len) = self.pattern[self.next.item] {
                self.open(len, end);
            } else {
                let items = &self.pattern[self.next.item..self.stop];
                let slot = self.next.slot;
                let slots = items.iter().take_while(|item| matches!(item, Item::Slot)).count();
                self.next.item += slots;
                self.next.slot += slots;
                return Some(Run { slots: slot..slot + slots, start: end, limit: self.limit });
            }
        }
    }

    /// Enters the group of `len` items whose `Repeat` is next, at `start`.
    fn open(&mut self, len: u32, start: f64) {
        let item = self.next.item + 1;
        let stop = item.saturating_add(len as usize).min(self.stop);
        let turns = self.turns.get(self.next.group).copied().unwrap_or(Turns::NONE);
        let limit = turns.limit(start, self.limit, self.smallest);
        if turns.count == 0.0 || limit - start <= self.smallest {
            let items = &self.pattern[item..stop];
            let slots = items.iter().filter(|item| matches!(item, Item::Slot)).count();
            let groups = 1 + items.len() - slots;
            self.next = Counts { item: stop, slot: self.next.slot + slots, group: self.next.group + groups };
            return;
        }
        let first = Counts { item, slot: self.next.slot, group: self.next.group + 1 };
        let (outer_stop, outer_limit) = (self.stop, self.limit);
        self.open.push(Open { first, turns, number: 1.0, start, limit, outer_stop, outer_limit });
        self.next = first;
        self.stop = stop;
        self.limit = turns.border(1.0, start, limit, self.smallest);
    }
}
