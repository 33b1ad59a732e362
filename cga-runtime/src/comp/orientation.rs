//! The directions of components, in the axes of a selector word.

use std::sync::Arc;

use glam::{DMat3, DVec3};

use super::select::Axes;
use crate::run::env::Env;
use crate::shape::Shape;
use crate::shape::direction::Direction;
use crate::shape::scope::Scope;
use crate::shape::street::Streets;

/// The orientation of a shape.
#[derive(Clone, Debug)]
pub(crate) struct Looks {
    pub(crate) scope: Scope,
    /// The axes of the initial shape.
    object: DMat3,
    /// True if the normals of faces point inwards.
    pub(crate) inwards: bool,
    streets: Option<Arc<Streets>>,
}

impl Looks {
    pub(crate) fn of(env: &Env, shape: &Shape) -> Self {
        Looks {
            scope: shape.scope,
            object: env.initial.object.axes,
            inwards: shape.looks_inwards(),
            streets: env.initial.streets.clone(),
        }
    }

    /// The outward direction for a normal of the faces.
    #[inline]
    pub(crate) fn outwards(&self, normal: DVec3) -> DVec3 {
        if self.inwards { -normal } else { normal }
    }

    /// Returns true if a component with a unit normal, in scope axes, has a direction. Its place, in scope
    /// coordinates, is computed only for streets.
    #[inline]
    pub(crate) fn takes(&self, axes: Axes, direction: Direction, normal: DVec3, at: impl FnOnce() -> DVec3) -> bool {
        self.takes_at(axes, direction, normal, || self.scope.frame().to_world(at()))
    }

    /// Returns true if a component with a unit normal, in scope axes, has a direction. `at` is its place in the
    /// world.
    #[inline]
    pub(crate) fn takes_at(&self, axes: Axes, direction: Direction, normal: DVec3, at: impl FnOnce() -> DVec3) -> bool {
        match (axes, &self.streets) {
            (Axes::Scope, _) => direction.takes(normal),
            (Axes::World, _) => direction.takes(self.scope.axes * normal),
            (Axes::Street, Some(streets)) => streets.takes(direction, self.scope.axes * normal, at()),
            (Axes::Object | Axes::Street, _) => direction.takes(self.object.transpose() * (self.scope.axes * normal)),
        }
    }
}
