//! A split under way: pieces become shapes, one after the other.

use std::ops::ControlFlow;

use super::parts::{Parts, within_limit};
use super::row::Row;
use super::{Adjust, Piece};
use crate::derive::Cx;
use crate::env::Env;
use crate::scope::Axis;
use crate::seed::{self, Seed, Tag};
use crate::shape::base::{Base, Form};
use crate::shape::{Counter, ShapeRef};
use crate::sink::{Flow, Sink};
use crate::tol::PLANAR_EPSILON;
use crate::unit::Band;

/// A shape that is divided along an axis. Generated code asks for the shape of each piece, or hands a leaf on.
#[derive(Debug)]
pub struct Division<'s> {
    whole: &'s ShapeRef<'s>,
    /// The seed of the step.
    seed: u64,
    /// Repetitions begun, of all groups.
    turns: u64,
    index: usize,
    total: usize,
    adjust: Adjust,
    /// True if the parts have other unit meshes than the shape.
    has_bands: bool,
    /// The pieces, where they do not simply fill their scopes.
    made: Option<Box<Made>>,
}

/// Pieces that were made at once.
#[derive(Debug)]
struct Made {
    pieces: Vec<Base>,
    next: usize,
}

impl<'s> Division<'s> {
    /// Counts the pieces and cuts the geometry. `number` counts the children that the rule makes; `is_counted` says that a rule
    /// reads `split.total`. `Break` when a limit was reached.
    #[inline(always)]
    pub fn new(
        env: &mut Env,
        whole: &'s ShapeRef<'s>,
        (axis, adjust): (Axis, Adjust),
        number: u32,
        row: &(impl Row + ?Sized),
        is_counted: bool,
    ) -> ControlFlow<(), Self> {
        if !env.has_room(row.at_most()) {
            within_limit(env, row)?;
        }
        let made = if whole.is_simple_along(axis) { None } else { Made::of(env, *whole, (axis, adjust), row)? };
        let total = if is_counted { row.total() as usize } else { 0 };
        let seed = seed::step(whole.seed.value(), seed::key(Tag::Split, number));
        let has_bands = whole.unit.has_bands(axis);
        ControlFlow::Continue(Division { whole, seed, turns: 0, index: 0, total, adjust, has_bands, made })
    }

    /// Returns true after the first piece.
    #[inline(always)]
    pub fn has_parts(&self) -> bool {
        0 < self.index
    }

    /// Begins a repetition of a group.
    #[inline(always)]
    pub fn turn(&mut self) {
        self.turns += 1;
    }

    /// Leaves a piece out.
    #[inline(always)]
    pub fn skip(&mut self) {
        self.index += 1;
        if let Some(made) = &mut self.made {
            made.next += 1;
        }
    }

    /// The shape of the next piece. `in_group` says that its slot is in a group that repeats, `draws` that random numbers are drawn
    /// below: without, the part has no seed of its own.
    #[inline(always)]
    pub fn part(&mut self, axis: Axis, piece: Piece, slot: u32, in_group: bool, draws: bool) -> ShapeRef<'_> {
        let turn = if in_group { self.turns } else { 0 };
        let seed = if draws { Seed::new(seed::part(self.seed, slot, turn)) } else { self.whole.seed };
        let split = Counter::new(self.index, self.total);
        self.index += 1;
        if self.made.is_none() {
            return ShapeRef { seed, split, ..self.place(axis, piece) };
        }
        match &mut self.made {
            Some(made) => ShapeRef { seed, split, ..made.next() },
            None => *self.whole,
        }
    }

    /// Hands the next piece on as a leaf.
    #[inline(always)]
    pub fn leaf<S: Sink + ?Sized, C>(&mut self, cx: &mut Cx<'_, S, C>, axis: Axis, piece: Piece, rule: u32) -> Flow {
        self.index += 1;
        match &mut self.made {
            None => cx.filled(&self.place(axis, piece), rule),
            Some(made) => cx.symbol(&made.next(), rule),
        }
    }

    /// Where a piece that fills its scope is.
    #[inline(always)]
    fn place(&self, axis: Axis, piece: Piece) -> ShapeRef<'s> {
        let whole = self.whole;
        let matrix = &whole.axes.matrix;
        let (along, mut size) = match axis {
            Axis::X => (matrix.x_axis, whole.size.with_x(piece.length)),
            Axis::Y => (matrix.y_axis, whole.size.with_y(piece.length)),
            Axis::Z => (matrix.z_axis, whole.size.with_z(piece.length)),
        };
        let mut unit = whole.unit;
        if self.has_bands {
            unit = unit.part(axis, band(whole, axis, piece));
        }
        // What is flat across another axis has no thickness.
        if self.adjust == Adjust::Adjust {
            match whole.form {
                Form::Rect(Axis::X) => size.x = 0.0,
                Form::Rect(Axis::Y) => size.y = 0.0,
                Form::Rect(Axis::Z) => size.z = 0.0,
                _ => {}
            }
        }
        ShapeRef { origin: whole.origin + along * piece.start, size, unit, ..*whole }
    }
}

/// Where a piece is in a box or a rectangle. A piece that follows another is longer than the rounding.
#[inline]
fn band(whole: &ShapeRef<'_>, axis: Axis, piece: Piece) -> Band {
    let extent = whole.size[axis.index()];
    let is_last = extent - (piece.start + piece.length) <= PLANAR_EPSILON * extent;
    Band::of(piece.start == 0.0, is_last)
}

impl Made {
    /// Cuts a shape that does not simply fill its scope. Nothing when there is none.
    #[cold]
    #[inline(never)]
    fn of(
        env: &mut Env,
        whole: ShapeRef<'_>,
        (axis, adjust): (Axis, Adjust),
        row: &(impl Row + ?Sized),
    ) -> ControlFlow<(), Option<Box<Made>>> {
        let whole = env.whole(&whole);
        let mut parts = Parts::new(env, &whole, axis, adjust, row)?;
        let mut pieces = Vec::with_capacity(parts.total());
        let _ = row.each(|piece| {
            pieces.push(env.base(parts.next(piece)));
            Flow::Continue(())
        });
        ControlFlow::Continue(Some(Box::new(Made { pieces, next: 0 })))
    }

    #[cold]
    #[inline(never)]
    fn next(&mut self) -> ShapeRef<'_> {
        self.next += 1;
        self.pieces[self.next - 1].shape()
    }
}
