//! A split under way: pieces become shapes, one after the other.

use std::ops::ControlFlow;

use glam::DVec3;

use super::parts::{Parts, within_limit};
use super::row::Row;
use super::{Adjust, Piece};
use crate::derive::{Cx, filled};
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
    /// The pieces, where they do not simply fill their scopes.
    made: &'s Made,
    /// The shape of the current piece. Rules change no more of it than seed and material, so that only the rest that differs is
    /// written.
    part: ShapeRef<'s>,
    /// The axis, as a direction in the world.
    along: DVec3,
    /// The seed of the step.
    seed: u64,
    /// Repetitions begun, of all groups.
    turns: u64,
    index: usize,
    total: usize,
    /// True if the parts have other unit meshes than the shape.
    has_bands: bool,
}

/// The pieces of a shape that does not simply fill its scope, made at once; none of one that does.
#[derive(Debug, Default)]
pub struct Made(Option<Vec<Base>>);

impl Made {
    /// Counts the pieces and cuts the geometry. `Break` when a limit was reached.
    #[inline(always)]
    pub fn new(
        env: &mut Env,
        whole: &ShapeRef<'_>,
        axis: Axis,
        adjust: Adjust,
        row: &(impl Row + ?Sized),
    ) -> ControlFlow<(), Self> {
        if !env.has_room(row.at_most()) {
            within_limit(env, row)?;
        }
        if whole.is_simple_along(axis) {
            ControlFlow::Continue(Made(None))
        } else {
            Made::cut(env, whole.clone(), axis, adjust, row)
        }
    }

    #[cold]
    #[inline(never)]
    fn cut(
        env: &mut Env,
        whole: ShapeRef<'_>,
        axis: Axis,
        adjust: Adjust,
        row: &(impl Row + ?Sized),
    ) -> ControlFlow<(), Self> {
        let whole = env.whole(&whole);
        let mut parts = Parts::new(env, &whole, axis, adjust, row)?;
        let mut pieces = Vec::with_capacity(parts.total());
        let _ = row.each(|piece| {
            pieces.push(env.base(parts.next(piece)));
            Flow::Continue(())
        });
        ControlFlow::Continue(Made(Some(pieces)))
    }
}

impl<'s> Division<'s> {
    /// Before the first piece. `number` counts the children that the rule makes; `total` is `split.total`, if a rule reads it.
    #[inline(always)]
    pub fn new(whole: &'s ShapeRef<'s>, made: &'s Made, axis: Axis, adjust: Adjust, number: u32, total: u64) -> Self {
        let matrix = &whole.axes.matrix;
        let along = match axis {
            Axis::X => matrix.x_axis,
            Axis::Y => matrix.y_axis,
            Axis::Z => matrix.z_axis,
        };
        // Not a plain copy: fields that were written one by one and are read together are waited for.
        let mut part = ShapeRef { origin: DVec3::ZERO, split: Counter::NONE, ..whole.clone() };
        // What is flat across another axis has no thickness.
        if adjust == Adjust::Adjust
            && let Form::Rect(across) = whole.form
        {
            set(&mut part.size, across, 0.0);
        }
        let seed = seed::step(whole.seed.get().value(), seed::key(Tag::Split, number));
        let (total, has_bands) = (total as usize, whole.unit.has_bands(axis));
        Division { whole, made, part, along, seed, turns: 0, index: 0, total, has_bands }
    }

    /// Returns true after the first piece.
    #[inline(always)]
    pub fn has_parts(&self) -> bool {
        0 < self.index
    }

    /// Begins a repetition of a group. A split of many leaves may be stopped here.
    #[inline(always)]
    pub fn turn(&mut self, env: &mut Env) -> Flow {
        self.turns += 1;
        if env.has_room(0) { Flow::Continue(()) } else { env.make_room(0) }
    }

    /// Leaves a piece out.
    #[inline(always)]
    pub fn skip(&mut self) {
        self.index += 1;
    }

    /// The shape of the next piece. `in_group` says that its slot is in a group that repeats, `draws` that random numbers are drawn
    /// below: without, the part has no seed of its own.
    #[inline(always)]
    pub fn part(&mut self, axis: Axis, piece: Piece, slot: u32, in_group: bool, draws: bool) -> &ShapeRef<'s> {
        self.place(axis, piece);
        if draws {
            let turn = if in_group { self.turns } else { 0 };
            self.part.seed.set(Seed::new(seed::part(self.seed, slot, turn)));
        }
        self.part.split = Counter::new(self.index - 1, self.total);
        &self.part
    }

    /// As [`Division::part`], compiled once.
    #[inline(never)]
    pub fn any_part(&mut self, axis: Axis, piece: Piece, slot: u32, in_group: bool, draws: bool) -> &ShapeRef<'s> {
        self.part(axis, piece, slot, in_group, draws)
    }

    /// Hands the next piece on as a leaf.
    #[inline]
    pub fn leaf<C>(&mut self, cx: &mut Cx<'_, C>, axis: Axis, piece: Piece, rule: u32) -> Flow {
        self.hand_out(cx.env, cx.sink, axis, piece, rule)
    }

    #[inline(never)]
    fn hand_out(&mut self, env: &mut Env, sink: &mut dyn Sink, axis: Axis, piece: Piece, rule: u32) -> Flow {
        self.place(axis, piece);
        filled(env, sink, &self.part, rule)
    }

    /// Gives the part its place.
    #[inline(always)]
    fn place(&mut self, axis: Axis, piece: Piece) {
        let index = self.index;
        self.index += 1;
        if let Made(Some(pieces)) = self.made {
            return self.take(&pieces[index]);
        }
        // The part before it may have been painted.
        self.part.material.set(self.whole.material.get());
        self.part.origin = self.whole.origin + self.along * piece.start;
        set(&mut self.part.size, axis, piece.length);
        if self.has_bands {
            self.part.unit = self.whole.unit.part(axis, band(self.whole, axis, piece));
        }
    }

    #[cold]
    #[inline(never)]
    fn take(&mut self, piece: &'s Base) {
        self.part = ShapeRef { seed: self.part.seed.clone(), split: self.part.split, ..piece.shape() };
    }
}

/// Sets the extent along an axis. Not by index: that would go through memory and stall there.
#[inline(always)]
fn set(size: &mut DVec3, axis: Axis, extent: f64) {
    match axis {
        Axis::X => size.x = extent,
        Axis::Y => size.y = extent,
        Axis::Z => size.z = extent,
    }
}

/// Where a piece is in a box or a rectangle. A piece that follows another is longer than the rounding.
#[inline]
fn band(whole: &ShapeRef<'_>, axis: Axis, piece: Piece) -> Band {
    let extent = match axis {
        Axis::X => whole.size.x,
        Axis::Y => whole.size.y,
        Axis::Z => whole.size.z,
    };
    let is_last = extent - (piece.start + piece.length) <= PLANAR_EPSILON * extent;
    Band::of(piece.start == 0.0, is_last)
}
