//! A split in progress: pieces become shapes, one after the other.

use std::ops::ControlFlow;

use glam::DVec4;

use super::parts::{SplitParts, within_limit};
use super::row::Row;
use super::{Adjust, Piece};
use crate::geometry::Axis;
use crate::geometry::tol::PLANAR_EPSILON;
use crate::run::context::{Cx, filled, recorded_symbol};
use crate::run::env::Env;
use crate::run::sink::Flow;
use crate::shape::base::{Base, Form};
use crate::shape::look_id::LookId;
use crate::shape::seed::{self, Seed, Tag};
use crate::shape::unit::{Band, UnitMesh};
use crate::shape::{Counter, ShapeRef};

/// The work of a piece, besides its cut, in the units of [`work`](crate::geometry::work).
const PIECE: usize = 64;

/// A shape that is divided along an axis. Generated code takes the shape of each piece, or passes a leaf on.
///
/// The functions are inlined: into the rule, for splits of few slots and constant sizes in rules that reach themselves,
/// and into the walk through a pattern (`split/walk.rs`) for all others.
///
/// The parts have no shape of their own: during a division, its shape is the current part. [`Division::end`] restores
/// the whole.
#[derive(Debug)]
pub struct Division<'s> {
    shape: &'s ShapeRef<'s>,
    /// The pieces, if they do not simply fill their scopes.
    made: Option<Box<[ShapeRef<'s>]>>,
    whole: Undivided,
    /// The seed of the step.
    seed: Seed,
    /// The repetitions begun so far, in all groups.
    turns: u64,
    index: usize,
    total: usize,
    /// True if the parts have other unit meshes than the shape.
    has_bands: bool,
}

/// The properties of a shape that differ in its parts.
#[derive(Debug)]
struct Undivided {
    origin: DVec4,
    /// The extent along the axis of the split.
    extent: f64,
    /// The thickness of a rectangle's scope across the rectangle, which parts do not have.
    thickness: f64,
    unit: UnitMesh,
    seed: Seed,
    split: Counter,
    look: LookId,
}

/// The pieces of a shape that does not simply fill its scope, made at once. Empty for other shapes.
#[derive(Debug, Default)]
pub struct Made(Option<Vec<Base>>);

impl Made {
    /// No pieces.
    pub(super) fn nothing() -> Self {
        Made(Some(Vec::new()))
    }

    /// Pieces made elsewhere.
    pub(super) fn of(pieces: Vec<Base>) -> Self {
        Made(Some(pieces))
    }

    /// Counts the pieces and cuts the geometry. `at_most` is at least the number of pieces. `Break` when a limit is
    /// reached.
    #[inline(always)]
    pub fn new(
        env: &mut Env,
        whole: &ShapeRef<'_>,
        axis: Axis,
        adjust: Adjust,
        at_most: u64,
        row: impl Row,
    ) -> ControlFlow<(), Self> {
        if !env.has_room(at_most) {
            within_limit(env, row)?;
        }
        if whole.is_simple_along(axis) {
            ControlFlow::Continue(Made(None))
        } else {
            Made::cut(env, whole, axis, adjust, row)
        }
    }

    #[cold]
    #[inline(never)]
    fn cut(env: &mut Env, whole: &ShapeRef<'_>, axis: Axis, adjust: Adjust, row: impl Row) -> ControlFlow<(), Self> {
        env.ask()?;
        let mut whole = env.whole(whole);
        env.divide_trace(&mut whole);
        let mut parts = SplitParts::new(env, &whole, axis, adjust, row)?;
        let mut pieces = Vec::with_capacity(parts.total());
        row.each(|piece| {
            let part = parts.next(env, piece);
            pieces.push(env.base(part));
            env.spend(PIECE)
        })?;
        ControlFlow::Continue(Made(Some(pieces)))
    }
}

/// A slot of a split, as known to the code generator.
#[derive(Clone, Copy, Debug)]
pub struct Slot {
    /// The index in the pattern.
    pub number: u32,
    /// True if it is in a group that repeats.
    pub in_group: bool,
    /// True if the rules of the part draw random numbers. Otherwise the part has no seed of its own.
    pub draws: bool,
    /// True if the rules of the part read `split.index` or `split.total`.
    pub counts: bool,
}

impl<'s> Division<'s> {
    /// A division before the first piece. `number` counts the children of the rule; `total` is `split.total`, if a
    /// rule reads it.
    #[inline(always)]
    pub fn new(shape: &'s ShapeRef<'s>, made: &'s Made, axis: Axis, adjust: Adjust, number: u32, total: u64) -> Self {
        let whole = Undivided::of(shape, axis, adjust);
        let made = made.0.as_ref().map(|pieces| shapes(pieces));
        let seed = whole.seed.step(seed::key(Tag::Split, number));
        let (total, has_bands) = (total as usize, whole.unit.has_bands(axis));
        Division { shape, made, whole, seed, turns: 0, index: 0, total, has_bands }
    }

    /// Restores the whole shape. It is not needed if the run ends within the division.
    #[inline(always)]
    pub fn end(&self, axis: Axis) {
        self.whole.put_back(self.shape, axis);
    }

    /// Returns true after the first piece.
    #[inline(always)]
    pub fn has_parts(&self) -> bool {
        0 < self.index
    }

    /// Begins a repetition of a group. A split with many leaves may be stopped here.
    #[inline(always)]
    pub fn turn(&mut self, env: &mut Env) -> Flow {
        self.turns += 1;
        if env.has_room(0) { Flow::Continue(()) } else { env.make_room(0) }
    }

    /// Skips a piece.
    #[inline(always)]
    pub fn skip(&mut self, piece: Option<Piece>) {
        self.index += usize::from(piece.is_some());
    }

    /// The shape of the piece of a slot, if it gets one.
    #[inline(always)]
    pub fn part(&mut self, piece: Option<Piece>, axis: Axis, slot: Slot) -> Option<&ShapeRef<'s>> {
        let piece = piece?;
        let (seed, split) = (self.seed, Counter::new(self.index, self.total));
        let turn = if slot.in_group { self.turns } else { 0 };
        let part = self.place(axis, piece);
        if slot.draws {
            part.seed.set(seed.part(slot.number, turn));
        }
        if slot.counts {
            part.split.set(split);
        }
        Some(part)
    }

    /// Passes a piece on as a leaf.
    #[inline(always)]
    pub fn leaf<C>(&mut self, cx: &mut Cx<'_, C>, piece: Option<Piece>, axis: Axis, rule: u32) -> Flow {
        let Some(piece) = piece else { return Flow::Continue(()) };
        let part = self.place(axis, piece);
        if cx.env.tree.is_none() {
            filled(cx.env, cx.sink, part, rule)
        } else {
            recorded_symbol(cx.env, cx.sink, part, rule)
        }
    }

    /// Moves the shape to the place of the next piece.
    #[inline(always)]
    fn place(&mut self, axis: Axis, piece: Piece) -> &ShapeRef<'s> {
        let index = self.index;
        self.index += 1;
        if let Some(made) = &self.made {
            return &made[index];
        }
        let (shape, whole) = (self.shape, &self.whole);
        // An operation may have changed the material of the previous part.
        shape.look.set(whole.look);
        shape.origin.set(whole.origin + shape.axes.along(axis) * piece.start);
        shape.size.set_along(axis, piece.length);
        if self.has_bands {
            shape.unit.set(whole.unit.part(axis, whole.band(piece)));
        }
        shape
    }
}

/// The shapes of pieces that were made at once.
#[cold]
#[inline(never)]
fn shapes(pieces: &[Base]) -> Box<[ShapeRef<'_>]> {
    pieces.iter().map(Base::shape).collect()
}

impl Undivided {
    /// The properties of a shape before its division. Removes its thickness, which parts do not have.
    #[inline(always)]
    fn of(shape: &ShapeRef<'_>, axis: Axis, adjust: Adjust) -> Self {
        let mut whole = Undivided {
            origin: shape.origin.get(),
            extent: shape.size.along(axis),
            thickness: 0.0,
            unit: shape.unit.get(),
            seed: shape.seed.get(),
            split: shape.split.get(),
            look: shape.look.get(),
        };
        if adjust == Adjust::Adjust
            && let Form::Rect(across) = shape.form
        {
            whole.thickness = shape.size.along(across);
            if whole.thickness != 0.0 {
                shape.size.set_along(across, 0.0);
            }
        }
        whole
    }

    /// Restores the properties.
    #[inline(always)]
    fn put_back(&self, shape: &ShapeRef<'_>, axis: Axis) {
        shape.origin.set(self.origin);
        shape.size.set_along(axis, self.extent);
        shape.unit.set(self.unit);
        shape.seed.set(self.seed);
        shape.split.set(self.split);
        shape.look.set(self.look);
        if self.thickness != 0.0
            && let Form::Rect(across) = shape.form
        {
            shape.size.set_along(across, self.thickness);
        }
    }

    /// The position of a piece in the shape. A piece after the first one is longer than the rounding.
    #[inline]
    fn band(&self, piece: Piece) -> Band {
        let is_last = self.extent - (piece.start + piece.length) <= PLANAR_EPSILON * self.extent;
        Band::of(piece.start == 0.0, is_last)
    }
}
