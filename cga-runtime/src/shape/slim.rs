//! The shape that is passed between rules.
//!
//! A split changes the origin, one extent, the seed and the counters of a shape. A
//! [`Division`](crate::split::division) changes them in place, for one part after the other, and restores them at the
//! end. The rest is borrowed from the last [`Base`] above: the start of a run, a component, the result of an
//! operation, a piece of a mesh. So a part of a split costs a few machine words, is never copied, and needs no drop.

use std::cell::Cell;

use glam::{DVec3, DVec4};

use super::axes::Axes;
use super::base::{Base, Form};
use super::{Counter, Geometry, Shape};
use crate::geometry::Axis;
use crate::geometry::each::Each;
use crate::shape::look_id::LookId;
use crate::shape::scope::Scope;
use crate::shape::seed::{self, Seed, Tag};
use crate::shape::unit::UnitMesh;

/// A shape while rules run: the fields that splits change, and a reference to the rest.
///
/// A rule may change the seed and the look of the shape that it gets.
#[derive(Clone, Debug)]
pub struct ShapeRef<'a> {
    /// The fourth coordinate is 0, so it is stored and loaded in the same two halves. With three numbers, a store of
    /// the first two and a load of the last two overlap, and the load waits until both stores are in the cache.
    pub(crate) origin: Cell<DVec4>,
    pub(crate) size: Extents,
    /// The axes of the base, before or after it has grown.
    pub(crate) axes: &'a Axes,
    pub(crate) base: &'a Base,
    /// The mesh of a box or a rectangle; unused in other forms.
    pub(crate) unit: Cell<UnitMesh>,
    pub(crate) seed: Cell<Seed>,
    pub(crate) split: Cell<Counter>,
    pub(crate) form: Form,
    pub(crate) look: Cell<LookId>,
}

/// The size of a slim shape, in metres. Each extent is read and written alone, so none waits for the others.
#[derive(Clone, Debug)]
pub(crate) struct Extents([Cell<f64>; 3]);

impl Extents {
    /// The extents along all axes.
    #[inline]
    pub(crate) fn get(&self) -> DVec3 {
        DVec3::new(self.0[0].get(), self.0[1].get(), self.0[2].get())
    }

    /// Sets all extents.
    #[inline]
    pub(crate) fn set(&self, size: DVec3) {
        self.0.iter().zip(size.to_array()).for_each(|(extent, value)| extent.set(value));
    }

    /// The extent along an axis.
    #[inline(always)]
    pub(crate) fn along(&self, axis: Axis) -> f64 {
        self.0[axis.index()].get()
    }

    /// Sets the extent along an axis.
    #[inline(always)]
    pub(crate) fn set_along(&self, axis: Axis, extent: f64) {
        self.0[axis.index()].set(extent);
    }
}

impl From<DVec3> for Extents {
    #[inline]
    fn from(size: DVec3) -> Self {
        Extents(size.to_array().each(Cell::new))
    }
}

impl<'a> ShapeRef<'a> {
    /// The shape of a base.
    #[inline]
    pub(crate) fn of(base: &'a Base, (form, unit): (Form, UnitMesh), look: LookId) -> Self {
        let shape = &base.shape;
        ShapeRef {
            origin: Cell::new(shape.scope.origin.extend(0.0)),
            size: shape.scope.size.into(),
            axes: base.axes(),
            base,
            unit: Cell::new(unit),
            seed: Cell::new(shape.seed),
            split: Cell::new(shape.split),
            form,
            look: Cell::new(look),
        }
    }

    /// The corner of the scope, in the world.
    #[inline(always)]
    pub(crate) fn origin(&self) -> DVec3 {
        self.origin.get().truncate()
    }

    /// The place and the size of the shape, in the world.
    #[inline]
    pub fn scope(&self) -> Scope {
        Scope { origin: self.origin(), axes: self.axes.matrix, size: self.size.get() }
    }

    /// Returns true if the geometry is at most one face, so that it has no volume, nor have parts of it.
    pub(crate) fn is_flat_face(&self) -> bool {
        match self.form {
            Form::Rect(_) | Form::Empty => true,
            Form::Box => false,
            Form::Other => match &self.base.shape.geometry {
                Geometry::Mesh(placed) => placed.mesh.face_count() <= 1,
                Geometry::Box(_) => false,
                _ => true,
            },
        }
    }

    /// The geometry.
    pub(crate) fn geometry(&self) -> Geometry {
        match self.form {
            Form::Rect(axis) => Geometry::Rect(axis, self.unit.get()),
            Form::Box => Geometry::Box(self.unit.get()),
            Form::Empty => Geometry::Empty,
            Form::Other => self.base.shape.geometry.clone(),
        }
    }

    /// Takes over the draws of random numbers from the whole form of this shape.
    pub fn drawn(&self, whole: &Shape) {
        self.seed.set(whole.seed);
    }

    /// A copy with the seed of a child.
    #[inline]
    pub(crate) fn child(&self, key: u64) -> ShapeRef<'a> {
        ShapeRef { seed: Cell::new(self.seed.get().step(key)), ..self.clone() }
    }

    /// Returns true if there are implicit texture coordinates.
    #[inline]
    pub(crate) fn has_coordinates(&self) -> bool {
        let look = self.look.get();
        look.may_have_coordinates() && (look != LookId::OF_BASE || !self.base.shape.state.coordinates().is_empty())
    }

    /// Returns true if a point that moves by `by` along the axes keeps its implicit coordinates.
    #[cold]
    #[inline(never)]
    pub(crate) fn keeps_coordinates(&self, by: DVec3) -> bool {
        let [x, y, z] = self.base.constant();
        // The axes of a base that has grown are its x, z and -y.
        let constant = if std::ptr::eq(self.axes, self.base.raised()) { [x, z, y] } else { [x, y, z] };
        by.to_array().into_iter().zip(constant).all(|(by, constant)| constant || by == 0.0)
    }

    /// Returns true if the sides of a box may have different texture coordinates.
    #[inline]
    pub(crate) fn has_sides(&self) -> bool {
        self.has_coordinates() && self.has_different_sides()
    }

    /// The same for a shape with coordinates. A look with a number never has the coordinates of a cube.
    #[cold]
    #[inline(never)]
    fn has_different_sides(&self) -> bool {
        let is_cube = self.look.get() == LookId::OF_BASE && self.base.shape.state.coordinates().has_cube();
        is_cube || self.has_unmapped_caps()
    }

    /// Returns true if a face closes a cut, and no operation on texture coordinates has reached it.
    pub(crate) fn has_unmapped_caps(&self) -> bool {
        match self.form {
            Form::Rect(_) | Form::Box => self.unit.get().has_unmapped_caps(),
            Form::Empty => false,
            Form::Other => self.base.shape.has_unmapped_caps(),
        }
    }

    /// Returns true if the parts of a split along an axis fill their scopes.
    #[inline]
    pub(crate) fn is_simple_along(&self, axis: Axis) -> bool {
        match self.form {
            Form::Rect(across) => across != axis,
            Form::Box | Form::Empty => true,
            Form::Other => false,
        }
    }
}

/// A copy of the current shape for a successor. `number` counts the children of the rule.
#[inline]
pub fn successor<'a>(shape: &ShapeRef<'a>, number: u32) -> ShapeRef<'a> {
    shape.child(seed::key(Tag::Successor, number))
}

/// Turns the current shape into its last successor in a rule, after which nothing reads the shape.
#[inline]
pub fn become_successor(shape: &ShapeRef<'_>, number: u32) {
    shape.seed.set(shape.seed.get().step(seed::key(Tag::Successor, number)));
}

/// A copy of the current shape for `[ … ]`.
#[inline]
pub fn push<'a>(shape: &ShapeRef<'a>, number: u32) -> ShapeRef<'a> {
    shape.child(seed::key(Tag::Push, number))
}

/// Makes a part that is passed straight to a rule the successor itself: `~1 : A` and `~1 : color(c) A` give `A` the
/// same seed. Compiled once: rules have many parts.
#[inline(never)]
pub fn hand_on(part: &ShapeRef<'_>) {
    part.seed.set(part.seed.get().child(Tag::Successor, 0));
}
