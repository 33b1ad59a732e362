//! How often the repeat groups of a pattern repeat.

use super::counts::{Counts, Inline};
use super::solve::SLIVER;
use super::{Item, Prefix, Size};

/// Absolute and floating sums.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Sum {
    pub(super) absolute: f64,
    pub(super) floating: f64,
}

impl Sum {
    fn nominal(self) -> f64 {
        self.absolute + self.floating
    }

    /// The common factor of all floats.
    pub(super) fn stretch(self, extent: f64) -> f64 {
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
pub(super) struct Groups {
    outside: Sum,
    list: Inline<Group>,
    /// Those that can repeat: the others hold nothing and are never made.
    live: Inline<usize>,
}

impl Groups {
    pub(super) fn new(pattern: &[Item], sizes: &[Size]) -> Self {
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

    pub(super) fn is_empty(&self) -> bool {
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
    pub(super) fn total(&self, counts: &Counts) -> Sum {
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
    pub(super) fn least_stretch(&self, extent: f64) -> Counts {
        let least = if 0.0 < self.outside.floating { 0 } else { self.live.len() as u64 };
        let low = self.last(least, extent);
        let stretch = |turns| self.total(&self.deal(turns)).stretch(extent);
        let high = low + 1;
        let fits = self.total(&self.deal(high)).absolute <= extent;
        self.deal(if fits && nearer(stretch(low), stretch(high)) { high } else { low })
    }

    /// Without floats: repetitions until the room that the sizes outside leave is full; the last one is cut.
    pub(super) fn fill(&self, extent: f64) -> (Counts, Option<(usize, f64)>) {
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

/// Whether `b`, the larger count, is as good as `a`: its stretch is at least as near to 1. On a tie in f64 the larger
/// count wins, as `{ 2 }* | ~1` in 10 does (*Subdivision split*: five pieces of 2 and no room for the float).
fn nearer(a: f64, b: f64) -> bool {
    (b - 1.0).abs() <= (a - 1.0).abs()
}

/// No pattern is repeated more often; every caller has a lower limit of its own.
const MOST: u64 = 1 << 48;
