//! The shape that rules hand on.
//!
//! A split changes the origin, the size, the seed and the counters of a shape. These are copied; the rest is borrowed from
//! the last [`Base`] above: the start of a run, a component, the result of an operation, a piece of a mesh. So a part of a
//! split costs a few machine words and has nothing to drop.

use std::cell::Cell;

use glam::DVec3;

use super::axes::Axes;
use super::base::{Base, Form};
use super::{Counter, Geometry, Shape};
use crate::material::ids::MaterialId;
use crate::scope::{Axis, Scope};
use crate::seed::{self, Seed, Tag};
use crate::unit::UnitMesh;

/// A shape while rules run: the fields that splits change, and a reference to the rest.
#[derive(Clone, Debug)]
pub struct ShapeRef<'a> {
    pub(crate) origin: DVec3,
    pub(crate) size: DVec3,
    /// The axes of the base, or those of the base when it has grown.
    pub(crate) axes: &'a Axes,
    pub(crate) base: &'a Base,
    /// The mesh of a box or a rectangle; unused in other forms.
    pub(crate) unit: UnitMesh,
    /// Random numbers are drawn, and the material is painted, in place: a whole split has one shape for its parts.
    pub(crate) seed: Cell<Seed>,
    pub(crate) split: Counter,
    pub(crate) form: Form,
    pub(crate) material: Cell<MaterialId>,
}

impl<'a> ShapeRef<'a> {
    /// The place of the shape and its size, in the world.
    #[inline]
    pub fn scope(&self) -> Scope {
        Scope { origin: self.origin, axes: self.axes.matrix, size: self.size }
    }

    /// The geometry.
    pub(crate) fn geometry(&self) -> Geometry {
        match self.form {
            Form::Rect(axis) => Geometry::Rect(axis, self.unit),
            Form::Box => Geometry::Box(self.unit),
            Form::Empty => Geometry::Empty,
            Form::Other => self.base.shape.geometry.clone(),
        }
    }

    /// Takes over the random numbers that the whole of this shape has drawn.
    pub fn drawn(&self, whole: &Shape) {
        self.seed.set(whole.seed);
    }

    /// A copy with the seed of a child.
    #[inline]
    pub(crate) fn child(&self, key: u64) -> ShapeRef<'a> {
        ShapeRef { seed: Cell::new(Seed::new(seed::step(self.seed.get().value(), key))), ..self.clone() }
    }

    /// True if a split along an axis makes parts that simply fill their scopes.
    #[inline]
    pub(crate) fn is_simple_along(&self, axis: Axis) -> bool {
        match self.form {
            Form::Rect(across) => across != axis,
            Form::Box | Form::Empty => true,
            Form::Other => false,
        }
    }
}

/// A copy of the current shape for a successor. `number` counts the children that the rule makes.
#[inline]
pub fn successor<'a>(shape: &ShapeRef<'a>, number: u32) -> ShapeRef<'a> {
    shape.child(seed::key(Tag::Successor, number))
}

/// A copy of the current shape for `[ … ]`.
#[inline]
pub fn push<'a>(shape: &ShapeRef<'a>, number: u32) -> ShapeRef<'a> {
    shape.child(seed::key(Tag::Push, number))
}

/// A part that goes straight to a rule is the successor itself: `~1 : A` and `~1 : color(c) A` have the same seed in `A`.
#[inline]
pub fn hand_on(part: &ShapeRef<'_>) {
    part.seed.set(part.seed.get().child(Tag::Successor, 0));
}
