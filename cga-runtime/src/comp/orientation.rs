//! The directions of components, in the axes of a selector word.

use std::sync::Arc;

use glam::{DMat3, DVec3};

use super::select::AxesOf;
use crate::run::env::Env;
use crate::shape::Shape;
use crate::shape::direction::Direction;
use crate::shape::scope::Scope;
use crate::shape::street::Streets;

/// The orientation of a shape.
#[derive(Clone, Debug)]
pub(crate) struct Orientation {
    pub(crate) scope: Scope,
    /// The axes of the initial shape.
    object: DMat3,
    /// True if the normals of faces point inwards.
    pub(crate) inwards: bool,
    streets: Option<Arc<Streets>>,
}

impl Orientation {
    pub(crate) fn of(env: &Env, shape: &Shape) -> Self {
        Orientation {
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
    pub(crate) fn takes(&self, axes: AxesOf, direction: Direction, normal: DVec3, at: impl FnOnce() -> DVec3) -> bool {
        if axes == AxesOf::Scope {
            return direction.takes(normal);
        }
        self.takes_at(axes, direction, normal, || self.scope.frame().to_world(at()))
    }

    /// Returns true if a component with a unit normal, in scope axes, has a direction. `at` is its place in the
    /// world.
    #[inline]
    pub(crate) fn takes_at(
        &self,
        axes: AxesOf,
        direction: Direction,
        normal: DVec3,
        at: impl FnOnce() -> DVec3,
    ) -> bool {
        match (axes, &self.streets) {
            (AxesOf::Scope, _) => direction.takes(normal),
            (AxesOf::World, _) => direction.takes(self.scope.axes * normal),
            (AxesOf::Street, Some(streets)) => streets.takes(direction, self.scope.axes * normal, at()),
            (AxesOf::Object | AxesOf::Street, _) => {
                direction.takes(self.object.transpose() * (self.scope.axes * normal))
            }
        }
    }
}
