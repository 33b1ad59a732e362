//! Splits by the pattern: the pieces become shapes, and each shape goes to the successor of its slot.

use std::ops::{ControlFlow, Range};

use cga_split::{Cursor, Group, List, Solution};

use super::divide::{areas, check, extent, solved};
use super::division::{Division, Made, Slot};
use super::texture::{TextureAxis, texture};
use super::{Adjust, Item, Piece, Size};
use crate::geometry::Axis;
use crate::geometry::mesh::TaggedComponents;
use crate::run::context::Cx;
use crate::run::env::Env;
use crate::run::sink::Flow;
use crate::shape::ShapeRef;
use crate::shape::base::Base;

/// A split, as known to the code generator.
#[derive(Clone, Copy, Debug)]
pub struct Split<'p> {
    /// The axis of the split.
    pub axis: Axis,
    /// The scopes of the parts.
    pub adjust: Adjust,
    /// The number of children that the rule has before this step.
    pub number: u32,
    /// Slots and groups.
    pub pattern: &'p [Item],
    /// The successor of each slot.
    pub successors: &'p [Successor],
    /// True if a rule of a part reads `split.total`.
    pub has_total: bool,
}

/// The successor of a slot.
#[derive(Clone, Copy, Debug)]
pub enum Successor {
    /// No shape.
    Nil,
    /// A leaf with the number of its name.
    Leaf(u32),
    /// A rule.
    Rule {
        /// True if the rules of the part draw random numbers. Otherwise the part has no seed of its own.
        draws: bool,
        /// True if the rules of the part read `split.index` or `split.total`.
        counts: bool,
    },
}

/// Calls the rule of a slot, by number, with a part.
pub(crate) type VisitPiece<'v, C> = dyn FnMut(&mut Cx<'_, C>, u32, &ShapeRef<'_>) -> Flow + 'v;

/// Splits a shape along an axis (*split operation*). Returns true if there was a piece. `sizes` and `lengths` have one entry
/// for each slot; the lengths are overwritten. `Break` when the run ends.
pub fn split<'s, C>(
    cx: &mut Cx<'_, C>,
    shape: &ShapeRef<'_>,
    split: &Split<'s>,
    sizes: &mut [Size],
    lengths: &'s mut [f64],
    visit: &mut VisitPiece<'_, C>,
) -> ControlFlow<(), bool> {
    let (solution, made, total) = solve(cx.env, shape, split, sizes, lengths)?;
    let pieces = Solved { solution: &solution, cursor: solution.cursor() };
    walk(cx, shape, split, &made, total, pieces, visit)
}

/// As [`split`], with the pieces that the macro has found for an extent.
pub fn split_solved<C>(
    cx: &mut Cx<'_, C>,
    shape: &ShapeRef<'_>,
    split: &Split<'_>,
    known: f64,
    pieces: &[Piece],
    visit: &mut VisitPiece<'_, C>,
) -> ControlFlow<(), bool> {
    let pieces = solved(cx.env, shape, split.axis, known, pieces);
    let made = made(cx.env, shape, split, pieces)?;
    walk(cx, shape, split, &made, pieces.len() as u64, List::new(pieces), visit)
}

/// Splits a shape into parts of given areas (*splitArea operation*), as [`split`].
pub fn split_area<C>(
    cx: &mut Cx<'_, C>,
    shape: &ShapeRef<'_>,
    split: &Split<'_>,
    sizes: &mut [Size],
    lengths: &mut [f64],
    visit: &mut VisitPiece<'_, C>,
) -> ControlFlow<(), bool> {
    // *Geometry tagging*: the parts have no tags.
    let bare = without_tags(cx.env, shape);
    let bare = bare.as_ref().map(Base::shape);
    let shape = bare.as_ref().unwrap_or(shape);
    let pieces = areas(cx.env, shape, split.axis, split.pattern, sizes, lengths);
    // *Shape recomposition*: the parts are not connected again.
    let made = if cx.env.recomposed_depth() == 0 {
        made(cx.env, shape, split, &pieces)
    } else {
        let whole = cx.env.whole(shape);
        cx.env.without_origins(whole, |env, whole| {
            let whole = env.base(whole);
            made(env, &whole.shape(), split, &pieces)
        })
    }?;
    walk(cx, shape, split, &made, pieces.len() as u64, List::new(&pieces), visit)
}

/// The shape without its tags; `None` if it has none.
fn without_tags(env: &mut Env, shape: &ShapeRef<'_>) -> Option<Base> {
    let mut whole = env.whole(shape);
    whole.found_tags(None, TaggedComponents::All).next()?;
    whole.remove_tags(None, TaggedComponents::All);
    Some(env.base(whole))
}

/// Splits a shape in texture space (*split operation*), as [`split`].
pub fn split_texture<C>(
    cx: &mut Cx<'_, C>,
    shape: &ShapeRef<'_>,
    split: &Split<'_>,
    axis: TextureAxis,
    sizes: &mut [Size],
    lengths: &mut [f64],
    visit: &mut VisitPiece<'_, C>,
) -> ControlFlow<(), bool> {
    let (pieces, made) = texture(cx.env, shape, axis, split.pattern, sizes, lengths)?;
    walk(cx, shape, split, &made, pieces.len() as u64, List::new(&pieces), visit)
}

/// Solves a split. Returns the shapes of the pieces, too, and `split.total` if a rule reads it.
#[inline(never)]
fn solve<'s>(
    env: &mut Env,
    shape: &ShapeRef<'_>,
    split: &Split<'s>,
    sizes: &mut [Size],
    lengths: &'s mut [f64],
) -> ControlFlow<(), (Solution<'s>, Made, u64)> {
    check(env, sizes, "a size of `split`");
    let solution = cga_split::solve(split.pattern, sizes, lengths, extent(env, shape, split.axis));
    let made = Made::new(env, shape, split.axis, split.adjust, solution.at_most(), &solution)?;
    let total = if split.has_total { solution.total() } else { 0 };
    ControlFlow::Continue((solution, made, total))
}

/// The shapes of the pieces of a list.
#[inline(never)]
fn made(env: &mut Env, shape: &ShapeRef<'_>, split: &Split<'_>, pieces: &[Piece]) -> ControlFlow<(), Made> {
    Made::new(env, shape, split.axis, split.adjust, pieces.len() as u64, pieces)
}

/// The pieces of a pattern in order, with its groups.
trait PieceSource {
    /// A group while it repeats.
    type Group;
    /// The piece of the next slot, if it gets one.
    fn slot(&mut self, slot: usize) -> Option<Piece>;
    /// Enters the next group, by number, with its slots.
    fn open(&mut self, group: usize, slots: Range<usize>) -> Self::Group;
    /// Begins the next repetition of a group. Returns false after the last one.
    fn turn(&mut self, group: &mut Self::Group) -> bool;
}

/// The pieces of a solution.
struct Solved<'s> {
    solution: &'s Solution<'s>,
    cursor: Cursor<'s>,
}

impl PieceSource for Solved<'_> {
    type Group = Group;

    fn slot(&mut self, slot: usize) -> Option<Piece> {
        self.cursor.slot(slot)
    }

    fn open(&mut self, group: usize, _: Range<usize>) -> Group {
        self.cursor.open(self.solution, group)
    }

    fn turn(&mut self, group: &mut Group) -> bool {
        self.cursor.turn(group)
    }
}

impl PieceSource for List<'_> {
    type Group = Range<u32>;

    fn slot(&mut self, slot: usize) -> Option<Piece> {
        List::slot(self, slot as u32)
    }

    fn open(&mut self, _: usize, slots: Range<usize>) -> Range<u32> {
        List::open(self, slots.start as u32..slots.end as u32)
    }

    fn turn(&mut self, group: &mut Range<u32>) -> bool {
        List::turn(self, group)
    }
}

/// A walk through a pattern.
struct SplitWalk<'w, 's, P, C> {
    split: &'w Split<'w>,
    division: Division<'s>,
    pieces: P,
    visit: &'w mut VisitPiece<'w, C>,
}

/// The position of the next item of a pattern: the numbers of slots and groups before it.
#[derive(Clone, Copy, Default)]
struct At {
    slot: usize,
    group: usize,
}

/// Passes all parts to their successors. Returns true if there was a piece.
#[inline(never)]
fn walk<'w, C>(
    cx: &mut Cx<'_, C>,
    shape: &'w ShapeRef<'w>,
    split: &'w Split<'w>,
    made: &'w Made,
    total: u64,
    pieces: impl PieceSource,
    visit: &'w mut VisitPiece<'w, C>,
) -> ControlFlow<(), bool> {
    let division = Division::new(shape, made, split.axis, split.adjust, split.number, total);
    let mut walk = SplitWalk { split, division, pieces, visit };
    walk.items(cx, split.pattern, At::default(), false)?;
    walk.division.end(split.axis);
    ControlFlow::Continue(walk.division.has_parts())
}

impl<P: PieceSource, C> SplitWalk<'_, '_, P, C> {
    /// Passes on the parts of some items of the pattern.
    fn items(&mut self, cx: &mut Cx<'_, C>, items: &[Item], mut at: At, in_group: bool) -> Flow {
        let mut rest = items;
        while let Some((item, behind)) = rest.split_first() {
            rest = behind;
            let Item::Repeat(len) = *item else {
                self.slot(cx, at.slot, in_group)?;
                at.slot += 1;
                continue;
            };
            let (inside, behind) = rest.split_at((len as usize).min(rest.len()));
            rest = behind;
            at = self.repeat(cx, inside, at)?;
        }
        Flow::Continue(())
    }

    /// Passes on the parts of a group, in all repetitions. Returns the position behind it.
    #[inline(always)]
    fn repeat(&mut self, cx: &mut Cx<'_, C>, inside: &[Item], at: At) -> ControlFlow<(), At> {
        let slots = inside.iter().filter(|item| matches!(item, Item::Slot)).count();
        let has_groups = slots < inside.len();
        let mut group = self.pieces.open(at.group, at.slot..at.slot + slots);
        while self.pieces.turn(&mut group) {
            self.division.turn(cx.env)?;
            if has_groups {
                self.items(cx, inside, At { group: at.group + 1, ..at }, true)?;
            } else {
                (at.slot..at.slot + slots).try_for_each(|slot| self.slot(cx, slot, true))?;
            }
        }
        ControlFlow::Continue(At { slot: at.slot + slots, group: at.group + 1 + inside.len() - slots })
    }

    /// Passes on the part of a slot.
    #[inline(always)]
    fn slot(&mut self, cx: &mut Cx<'_, C>, slot: usize, in_group: bool) -> Flow {
        let (axis, piece) = (self.split.axis, self.pieces.slot(slot));
        match self.split.successors[slot] {
            Successor::Nil => {
                self.division.skip(piece);
                Flow::Continue(())
            }
            Successor::Leaf(name) => self.division.leaf(cx, piece, axis, name),
            Successor::Rule { draws, counts } => {
                let number = slot as u32;
                match self.division.part(piece, axis, Slot { number, in_group, draws, counts }) {
                    Some(part) => (self.visit)(cx, number, part),
                    None => Flow::Continue(()),
                }
            }
        }
    }
}
