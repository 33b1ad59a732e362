//! Labelled shapes and how they compare (*contextCompare*, *minimumDistance function*).

use crate::geometry::mesh::Bounds;
use crate::geometry::tol::TIE_EPSILON;
use crate::shape::body::Body;
use crate::shape::scope::Scope;
use crate::shape::scope_distance;

/// A labelled copy of a shape: what context queries read of it.
#[derive(Clone, Debug)]
pub(crate) struct LabelledShape {
    scope: Scope,
    bounds: Bounds,
    area: f64,
}

/// The comparison of `contextCompare`. North is -z, and east is +x.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ContextComparison {
    /// The smallest z of the geometry.
    WorldNorthernmost,
    /// The largest z.
    WorldSouthernmost,
    /// The largest x.
    WorldEasternmost,
    /// The smallest x.
    WorldWesternmost,
    /// The largest y.
    WorldHighest,
    /// The smallest y.
    WorldLowest,
    /// The largest area.
    AreaLargest,
    /// The smallest area.
    AreaSmallest,
}

impl LabelledShape {
    /// A copy of a shape.
    pub(crate) fn of(body: &Body) -> Self {
        LabelledShape { scope: body.scope, bounds: body.bounds(), area: body.area() }
    }

    /// The distance from its scope to another scope, in metres.
    pub(crate) fn distance_to(&self, scope: &Scope) -> f64 {
        scope_distance::distance(&self.scope, scope)
    }

    /// The value by which shapes are ranked: larger is better.
    fn value(&self, by: ContextComparison) -> f64 {
        let Bounds { low, high } = self.bounds;
        match by {
            ContextComparison::WorldNorthernmost => -low.z,
            ContextComparison::WorldSouthernmost => high.z,
            ContextComparison::WorldEasternmost => high.x,
            ContextComparison::WorldWesternmost => -low.x,
            ContextComparison::WorldHighest => high.y,
            ContextComparison::WorldLowest => -low.y,
            ContextComparison::AreaLargest => self.area,
            ContextComparison::AreaSmallest => -self.area,
        }
    }

    /// Returns true if it is better than another shape by more than rounding: equal shapes have one rank.
    pub(crate) fn is_better(&self, other: &LabelledShape, by: ContextComparison) -> bool {
        let (own, its) = (self.value(by), other.value(by));
        TIE_EPSILON * own.abs().max(its.abs()).max(1.0) < own - its
    }
}
