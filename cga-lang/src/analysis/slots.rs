//! The abstract sizes of a split or of sections, and the solution where all sizes are known.

use super::facts::AbstractState;
use super::interval::Interval;
use crate::span::Span;
use crate::syntax::ast::{Arg, Block, Expr, Op, Prefix, Section, SplitItem};
use cga_split::{Item, Piece, Solution, solve};

/// The largest number of pieces that are laid out.
const MOST_PIECES: u64 = 10_000;

/// The relative error of sums. Claims keep this margin.
pub(crate) const MARGIN: f64 = 1e-9;

/// A sum this close to the whole fills it: the solver makes no piece of the rest.
const FULL: f64 = 1e-13;

/// A share of the extent that always makes a piece.
const PIECE: f64 = 1e-11;

/// The smallest extent that every run divides, for any size of the initial shape.
const LEAST: f64 = 1e-3;

/// A slot as written.
pub(crate) struct Slot<'a> {
    pub(crate) size: &'a Arg,
    pub(crate) ops: &'a [Op],
    /// The number after the prefix, as a run takes it.
    pub(crate) value: Interval,
    /// The innermost group with `*` around it, by number; 0 is the whole split.
    pub(crate) group: Option<usize>,
    /// The depth of a section, and its value as a run takes it.
    pub(crate) depth: Option<(&'a Expr, Interval)>,
}

/// A group with `*`.
pub(crate) struct Repeated {
    /// Its slots, nested ones included.
    pub(crate) slots: std::ops::Range<usize>,
    /// The group around it, by number.
    around: Option<usize>,
    /// True if none of its slots ever makes a piece, in any extent.
    makes_nothing: bool,
    /// From its first to its last slot, as written.
    pub(crate) span: Span,
}

/// The slots of a split along an axis, or the sections of a boundary, in writing order.
pub(crate) struct Slots<'a> {
    pub(crate) split: &'a Block,
    /// The axis of a split. Sections have none.
    pub(crate) axis: Option<usize>,
    pub(crate) extent: Interval,
    pub(crate) list: Vec<Slot<'a>>,
    pub(crate) groups: Vec<Repeated>,
    pattern: Vec<Item>,
    /// By slot: a lower bound of the space before it, whenever it is made.
    before: Vec<SizeSum>,
    /// By slot: an upper bound, in metres, of its end.
    most: Vec<f64>,
    /// A lower bound of the space of all slots that neither float nor repeat.
    fixed: SizeSum,
    /// True if no slot floats or repeats.
    all_fixed: bool,
    /// By slot, if everything is known: the lengths of its pieces.
    pieces: Option<Vec<Option<Interval>>>,
}

/// A sum of sizes: a share of the extent, and metres.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(crate) struct SizeSum {
    pub(crate) share: f64,
    pub(crate) metres: f64,
}

impl SizeSum {
    fn plus(self, other: SizeSum) -> SizeSum {
        SizeSum { share: self.share + other.share, metres: self.metres + other.metres }
    }
}

impl Slot<'_> {
    pub(crate) fn floats(&self) -> bool {
        matches!(self.size.prefix, Some((Prefix::Floating, _)))
    }

    pub(crate) fn is_relative(&self) -> bool {
        matches!(self.size.prefix, Some((Prefix::Relative, _)))
    }

    /// A lower bound of its space in an extent: zero for a floating slot.
    fn least(&self, extent: Interval) -> SizeSum {
        let least = self.value.lo.max(0.0);
        match () {
            () if self.floats() => SizeSum::default(),
            () if self.is_relative() => SizeSum { share: if PIECE < least { least } else { 0.0 }, metres: 0.0 },
            // A tiny share of the extent makes no piece.
            () => SizeSum { share: 0.0, metres: if extent.hi * PIECE < least { least } else { 0.0 } },
        }
    }

    /// Returns true if it never makes a piece, in any extent.
    pub(crate) fn is_nothing(&self) -> bool {
        self.value.hi <= 0.0
    }

    /// Returns true for a section that is never set back. It takes space all the same.
    pub(crate) fn has_no_depth(&self) -> bool {
        self.depth.is_some_and(|(_, depth)| depth.hi <= 0.0)
    }
}

/// The pieces of a solution, unless they are too many to be laid out.
fn few_pieces(solution: &Solution) -> Option<Vec<Piece>> {
    (solution.at_most() <= MOST_PIECES).then(|| solution.pieces())
}

/// Why a group repeats once.
pub(crate) enum Once {
    /// Its relative sizes add up to that share of the scope, 1 or more.
    Shares(f64),
    /// Its sizes add up to more metres than the scope has at most.
    Metres {
        /// The sum of the sizes.
        sum: f64,
        /// The largest extent of the scope.
        most: f64,
    },
    /// The solver repeats it once in a scope of that extent.
    Extent(f64),
}

impl<'a> Slots<'a> {
    /// Reads the slots of a split. `value` evaluates a size.
    pub(super) fn new(
        split: &'a Block,
        (items, repeat): (&'a [SplitItem], bool),
        axis: usize,
        facts: &AbstractState,
        value: impl Fn(&Arg) -> Interval,
    ) -> Slots<'a> {
        let mut slots = Slots::empty(split, Some(axis), facts.shape.extent(axis));
        slots.items(items, repeat, None, &value);
        slots.add_up();
        slots
    }

    /// Reads the sections of a boundary, whose length is unknown. `value` evaluates a length, `depth` a depth.
    pub(super) fn of_sections(
        split: &'a Block,
        (sections, repeat): (&'a [Section], bool),
        value: impl Fn(&Arg) -> Interval,
        depth: impl Fn(&Expr) -> Interval,
    ) -> Slots<'a> {
        let mut slots = Slots::empty(split, None, Interval::EXTENT);
        let group = repeat.then(|| slots.begin_group(None));
        for Section { length, depth: own, ops } in sections {
            slots.slot(length, ops, group, &value);
            slots.list.last_mut().expect("a section").depth = Some((own, depth(own).taken()));
        }
        if let Some(group) = group {
            slots.end_group(group, 0);
        }
        slots.add_up();
        slots
    }

    fn empty(split: &'a Block, axis: Option<usize>, extent: Interval) -> Slots<'a> {
        let (list, groups, pattern) = (Vec::new(), Vec::new(), Vec::new());
        let (before, most, fixed) = (Vec::new(), Vec::new(), SizeSum::default());
        Slots { split, axis, extent, list, groups, pattern, before, most, fixed, all_fixed: false, pieces: None }
    }

    /// Adds up the space of the slots in order, and solves the pattern. Slots of a group count for slots of the same group alone, as a group may have
    /// no repetition. Floating slots count as zero.
    fn add_up(&mut self) {
        let (mut outer, mut inner) = (SizeSum::default(), vec![SizeSum::default(); self.groups.len()]);
        let mut most = 0.0;
        for slot in &self.list {
            let of_group = slot.group.map_or(SizeSum::default(), |group| inner[group]);
            self.before.push(outer.plus(of_group));
            let own = slot.group.map_or(&mut outer, |group| &mut inner[group]);
            *own = own.plus(slot.least(self.extent));
            let value = if slot.is_relative() { slot.value.mul(self.extent) } else { slot.value };
            most += value.hi.max(0.0);
            self.most.push(most);
        }
        self.fixed = outer;
        self.all_fixed = self.list.iter().all(|slot| !slot.floats() && slot.group.is_none());
        self.pieces = self.solved();
    }

    fn items(
        &mut self,
        items: &'a [SplitItem],
        repeat: bool,
        around: Option<usize>,
        value: &impl Fn(&Arg) -> Interval,
    ) {
        let start = self.pattern.len();
        let own = repeat.then(|| self.begin_group(around));
        let group = own.or(around);
        for item in items {
            match item {
                SplitItem::Slot(size, ops) => self.slot(size, ops, group, value),
                SplitItem::Group(items, repeat) => self.items(items, *repeat, group, value),
            }
        }
        if let Some(own) = own {
            self.end_group(own, start);
        }
    }

    fn slot(&mut self, size: &'a Arg, ops: &'a [Op], group: Option<usize>, value: &impl Fn(&Arg) -> Interval) {
        self.pattern.push(Item::Slot);
        self.list.push(Slot { size, ops, value: value(size).taken(), group, depth: None });
    }

    /// Begins a group with `*`. Returns its number.
    fn begin_group(&mut self, around: Option<usize>) -> usize {
        self.pattern.push(Item::Repeat(0));
        let first = self.list.len();
        self.groups.push(Repeated { slots: first..first, around, makes_nothing: false, span: self.split.name.span });
        self.groups.len() - 1
    }

    /// Ends a group that began at `start` in the pattern.
    fn end_group(&mut self, group: usize, start: usize) {
        self.pattern[start] = Item::Repeat((self.pattern.len() - start - 1) as u32);
        let slots = self.groups[group].slots.start..self.list.len();
        if let [first, .., last] | [first @ last] = &self.list[slots.clone()] {
            self.groups[group].span = first.size.span.to(last.ops.last().map_or(last.size.span, |op| op.span));
        }
        self.groups[group].makes_nothing = self.list[slots.clone()].iter().all(Slot::is_nothing);
        self.groups[group].slots = slots;
    }

    /// The pieces, if the extent and all sizes are known.
    fn solved(&self) -> Option<Vec<Option<Interval>>> {
        let extent = self.extent.known().filter(|extent| 0.0 < *extent)?;
        let mut made: Vec<Option<Interval>> = vec![None; self.list.len()];
        for piece in self.solve(extent, few_pieces)?? {
            let (own, length) = (&mut made[piece.slot as usize], Interval::point(piece.length));
            *own = Some(own.map_or(length, |own| own.or(length)));
        }
        Some(made)
    }

    /// The pieces of a split of known relative sizes, in an extent of 1: they are the same shares of any extent.
    pub(crate) fn shares(&self) -> Option<Vec<Piece>> {
        let are_relative = self.list.iter().all(Slot::is_relative);
        are_relative.then(|| self.solve(1.0, few_pieces))??
    }

    /// The number of repetitions of a group in an extent.
    pub(crate) fn count(&self, group: usize, extent: f64) -> Option<u64> {
        self.solve(extent, |solution| solution.count(group))
    }

    /// The value that `of` takes from the solution in an extent, if all sizes are known.
    fn solve<T>(&self, extent: f64, of: impl FnOnce(&Solution) -> T) -> Option<T> {
        let sizes: Vec<cga_split::Size> = self.list.iter().map(Slot::exact).collect::<Option<_>>()?;
        Some(of(&solve(&self.pattern, &sizes, &mut vec![0.0; sizes.len()], extent)))
    }

    /// A lower bound of the space before a slot whenever it is made; with `itself` the slot counts too.
    pub(crate) fn before(&self, index: usize, itself: bool) -> SizeSum {
        let before = self.before[index];
        if itself { before.plus(self.list[index].least(self.extent)) } else { before }
    }

    /// A lower bound of the space of all slots that neither float nor repeat.
    pub(crate) fn fixed(&self) -> SizeSum {
        self.fixed
    }

    /// Returns true if a sum fills the scope for any extent.
    pub(crate) fn fills(&self, sum: SizeSum) -> bool {
        1.0 - FULL <= sum.share || 0.0 < sum.metres && (1.0 - FULL - sum.share) * self.extent.hi <= sum.metres
    }

    /// Returns true if a sum exceeds the scope for any extent.
    pub(crate) fn exceeds(&self, sum: SizeSum) -> bool {
        let whole = 1.0 + MARGIN;
        whole <= sum.share || 0.0 < sum.metres && (whole - sum.share) * self.extent.hi <= sum.metres
    }

    /// The possible lengths of a slot's pieces.
    pub(super) fn length(&self, index: usize) -> Interval {
        if let Some(pieces) = &self.pieces {
            return pieces[index].unwrap_or(Interval::EXTENT);
        }
        let slot = &self.list[index];
        let up_to = |most: f64| Interval::finite(0.0, most.max(0.0));
        if slot.floats() {
            return up_to(self.extent.hi);
        }
        let own = if slot.is_relative() { slot.value.mul(self.extent) } else { slot.value };
        let hi = own.hi.min(self.extent.hi);
        // Whole, if the slots before it always leave enough room.
        let most = self.most[index];
        if self.all_fixed && most * (1.0 + MARGIN) <= self.extent.lo && 0.0 < own.lo {
            return Interval::finite(own.lo, hi);
        }
        up_to(hi)
    }

    /// Returns true if a slot never makes a piece.
    pub(crate) fn is_never(&self, index: usize) -> bool {
        if let Some(pieces) = &self.pieces {
            return pieces[index].is_none();
        }
        let slot = &self.list[index];
        slot.is_nothing()
            || if slot.floats() {
                slot.group.is_none() && self.fills(self.fixed())
            } else {
                self.fills(self.before(index, false))
            }
    }
}

impl Slot<'_> {
    fn exact(&self) -> Option<cga_split::Size> {
        let prefix = match self.size.prefix {
            None => cga_split::Prefix::Absolute,
            Some((Prefix::Relative, _)) => cga_split::Prefix::Relative,
            Some((Prefix::Floating, _)) => cga_split::Prefix::Floating,
        };
        Some(cga_split::Size { prefix, value: self.value.known()? })
    }
}

/// Claims about the whole split.
impl Slots<'_> {
    /// Returns true if no slot of a group ever makes a piece, in any extent.
    pub(crate) fn makes_nothing(&self, group: usize) -> bool {
        self.groups[group].makes_nothing
    }

    /// Returns true if a group is a part of one that never makes a piece.
    pub(crate) fn is_within_nothing(&self, group: usize) -> bool {
        let outer = std::iter::successors(self.groups[group].around, |&outer| self.groups[outer].around);
        outer.into_iter().any(|outer| self.makes_nothing(outer))
    }

    /// Returns true if a slot always reaches beyond the end of the scope.
    pub(crate) fn is_cut(&self, index: usize) -> bool {
        let plain = self.groups.is_empty() && !self.list[index].floats();
        plain && !self.list[index].is_nothing() && self.exceeds(self.before(index, true))
    }

    /// The gap that is always left at the end: a share for relative sizes, metres for absolute ones.
    pub(crate) fn rest(&self) -> Option<f64> {
        if !self.groups.is_empty() || self.list.iter().any(Slot::floats) {
            return None;
        }
        let mut sum = 0.0;
        for slot in &self.list {
            sum += slot.value.known()?.max(0.0);
        }
        let relative = self.list.iter().filter(|slot| slot.is_relative()).count();
        let whole = match relative {
            0 => self.extent.known()?,
            all if all == self.list.len() => 1.0,
            _ => return None,
        };
        (sum < whole * (1.0 - MARGIN)).then_some(whole - sum)
    }

    /// A lower bound of the pieces of a repeat that is the whole split.
    pub(crate) fn at_least(&self, group: usize) -> Option<f64> {
        if self.groups.len() != 1 || self.groups[group].slots.len() != self.list.len() {
            return None;
        }
        let (mut share, mut metres, mut made) = (0.0, 0.0, 0.0);
        for slot in &self.list {
            let most = slot.value.hi.max(0.0);
            let least = if slot.is_relative() { PIECE } else { PIECE * self.extent.hi };
            if slot.is_relative() {
                share += most
            } else {
                metres += most
            }
            made += if least < slot.value.lo { 1.0 } else { 0.0 };
        }
        let room = if metres == 0.0 { 1.0 / share } else { self.extent.lo / (metres + share * self.extent.lo) };
        // The solver takes the neighbouring count of least stretch.
        let count = (room * (1.0 - MARGIN) - 1.0) * made;
        (0.0 < count && count.is_finite()).then_some(count)
    }

    /// The reason why a group always repeats once.
    pub(crate) fn once(&self, group: usize) -> Option<Once> {
        let mut within = self.groups[group].slots.clone();
        let own = &self.list[within.clone()];
        // A group may have no repetition.
        if self.groups.len() != 1 || within.any(|index| self.list[index].is_nothing() || self.is_never(index)) {
            return None;
        }
        let shares: f64 = own.iter().map(|slot| slot.value.lo.max(0.0)).sum();
        let alone = own.len() == self.list.len();
        if alone && own.iter().all(Slot::is_relative) && self.fills(SizeSum { share: shares, metres: 0.0 }) {
            return Some(Once::Shares(shares));
        }
        let metres: f64 = own.iter().map(|slot| slot.value.lo.max(0.0)).sum();
        let are_metres = !own.iter().any(Slot::is_relative);
        let is_range = self.extent.known().is_none() && LEAST < self.extent.hi;
        if alone && are_metres && is_range && self.extent.hi * (1.0 + MARGIN) <= metres {
            return Some(Once::Metres { sum: metres, most: self.extent.hi });
        }
        let extent = self.extent.known().filter(|extent| LEAST < *extent)?;
        let once = self.count(group, extent)? == 1;
        once.then_some(Once::Extent(extent))
    }
}
