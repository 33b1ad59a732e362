//! Where components look, in the axes that a word asks for.

use std::sync::Arc;

use glam::{DMat3, DVec3};

use super::select::Axes;
use crate::run::env::Env;
use crate::shape::Shape;
use crate::shape::direction::Direction;
use crate::shape::scope::Scope;
use crate::shape::street::Streets;

/// How a shape stands.
#[derive(Clone, Debug)]
pub(crate) struct Looks {
    pub(crate) scope: Scope,
    /// The axes of the initial shape.
    object: DMat3,
    /// Whether the normals of faces point inwards.
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

    /// Outwards, of the normal of a face or of several.
    #[inline]
    pub(crate) fn outwards(&self, normal: DVec3) -> DVec3 {
        if self.inwards { -normal } else { normal }
    }

    /// Whether what has a unit normal, in scope axes, looks in a direction. Where it is, in scope coordinates, is asked for
    /// only of streets.
    #[inline]
    pub(crate) fn takes(&self, axes: Axes, direction: Direction, normal: DVec3, at: impl FnOnce() -> DVec3) -> bool {
        self.takes_at(axes, direction, normal, || self.scope.frame().to_world(at()))
    }

    /// The same of what is somewhere in the world.
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
