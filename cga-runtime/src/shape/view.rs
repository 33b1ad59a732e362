//! The part of a shape that expressions of rules read without the whole shape.

use glam::DVec3;

use super::{Geometry, Shape, ShapeRef};
use crate::geometry::relation::OrientedBox;
use crate::shape::base::Form;
use crate::shape::body::Body;
use crate::shape::scope::Scope;
use crate::value::Value;

/// A shape, slim or whole, for the expressions of rules.
pub trait View {
    /// The origin of the scope, in the world.
    fn origin(&self) -> DVec3;

    /// The size of the scope, in metres; negative where it is mirrored.
    fn size(&self) -> DVec3;

    /// `split.index`; -1 before any split.
    fn split_index(&self) -> i32;

    /// `split.total`.
    fn split_total(&self) -> u32;

    /// The seed.
    fn seed_value(&self) -> u64;

    /// The next random number in 0..1.
    fn draw(&mut self) -> f64;

    /// The value that rules set for an attribute of the grammar on this shape, if any.
    fn own_attribute(&self, number: u32) -> Option<&Value>;

    /// The geometry in its scope.
    fn body(&self) -> Body;

    /// The geometry, if it is a box or a rectangle.
    fn cuboid(&self) -> Option<OrientedBox<'_>>;
}

impl View for Shape {
    fn origin(&self) -> DVec3 {
        self.scope.origin
    }

    fn size(&self) -> DVec3 {
        self.scope.size
    }

    fn split_index(&self) -> i32 {
        self.split.index()
    }

    fn split_total(&self) -> u32 {
        self.split.total()
    }

    fn seed_value(&self) -> u64 {
        self.seed.value()
    }

    fn draw(&mut self) -> f64 {
        self.seed.draw()
    }

    fn own_attribute(&self, number: u32) -> Option<&Value> {
        let state = self.state.get()?;
        let at = state.attributes.binary_search_by_key(&number, |(id, _)| *id).ok()?;
        Some(&state.attributes[at].1)
    }

    fn body(&self) -> Body {
        Body::from(self)
    }

    fn cuboid(&self) -> Option<OrientedBox<'_>> {
        let Scope { origin, axes, size } = &self.scope;
        match self.geometry {
            Geometry::Rect(axis, _) => Some(OrientedBox::rectangle(*origin, axes, *size, axis)),
            Geometry::Box(_) => Some(OrientedBox::new(*origin, axes, *size)),
            _ => None,
        }
    }
}

impl View for &ShapeRef<'_> {
    #[inline]
    fn origin(&self) -> DVec3 {
        ShapeRef::origin(self)
    }

    #[inline]
    fn size(&self) -> DVec3 {
        self.size.get()
    }

    #[inline]
    fn split_index(&self) -> i32 {
        self.split.get().index()
    }

    #[inline]
    fn split_total(&self) -> u32 {
        self.split.get().total()
    }

    #[inline]
    fn seed_value(&self) -> u64 {
        self.seed.get().value()
    }

    #[inline]
    fn draw(&mut self) -> f64 {
        let mut seed = self.seed.get();
        let number = seed.draw();
        self.seed.set(seed);
        number
    }

    #[inline]
    fn own_attribute(&self, number: u32) -> Option<&Value> {
        self.base.shape.own_attribute(number)
    }

    fn body(&self) -> Body {
        Body::from(*self)
    }

    #[inline]
    fn cuboid(&self) -> Option<OrientedBox<'_>> {
        let (origin, axes, size) = (ShapeRef::origin(self), &self.axes.matrix, self.size.get());
        match self.form {
            Form::Rect(axis) => Some(OrientedBox::rectangle(origin, axes, size, axis)),
            Form::Box => Some(OrientedBox::new(origin, axes, size)),
            Form::Empty | Form::Other => None,
        }
    }
}
