//! Where components look, in the axes that a word asks for.

use std::sync::Arc;

use glam::{DMat3, DVec3};

use super::select::{Axes, Direction};
use super::street::Streets;
use crate::env::Env;
use crate::scope::Scope;

/// How a shape stands.
#[derive(Clone, Debug)]
pub(crate) struct Looks {
    scope: Scope,
    /// The axes of the initial shape.
    object: DMat3,
    /// Makes selectors see a shape as if it were not mirrored: a negative size turns its faces inside out, and what a
    /// selector means is where they are, not where they look (*CGA changelog 2010.3*).
    outwards: f64,
    streets: Option<Arc<Streets>>,
}

impl Looks {
    pub(crate) fn of(env: &Env, scope: &Scope) -> Self {
        let mirrored = (0..3).filter(|&axis| scope.size[axis] < 0.0).count() % 2 == 1;
        Looks {
            scope: *scope,
            object: env.initial.object.axes,
            outwards: if mirrored { -1.0 } else { 1.0 },
            streets: env.initial.streets.clone(),
        }
    }

    /// Whether what has a unit normal, in scope axes, looks in a direction. Where it is, in scope coordinates, is asked for
    /// only of streets.
    #[inline]
    pub(crate) fn takes(&self, axes: Axes, direction: Direction, normal: DVec3, at: impl FnOnce() -> DVec3) -> bool {
        self.takes_at(axes, direction, normal, || self.scope.frame().to_world(at()))
    }

    /// The same of what is somewhere in the world.
    #[inline]
    pub(super) fn takes_at(&self, axes: Axes, direction: Direction, normal: DVec3, at: impl FnOnce() -> DVec3) -> bool {
        let normal = normal * self.outwards;
        match (axes, &self.streets) {
            (Axes::Scope, _) => direction.takes(normal),
            (Axes::World, _) => direction.takes(self.scope.axes * normal),
            (Axes::Street, Some(streets)) => streets.takes(direction, self.scope.axes * normal, at()),
            (Axes::Object | Axes::Street, _) => direction.takes(self.object.transpose() * (self.scope.axes * normal)),
        }
    }
}
