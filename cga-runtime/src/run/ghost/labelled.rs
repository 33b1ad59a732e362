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

impl ContextComparison {
    /// All comparisons, in their order.
    pub(crate) const ALL: [ContextComparison; 8] = [
        ContextComparison::WorldNorthernmost,
        ContextComparison::WorldSouthernmost,
        ContextComparison::WorldEasternmost,
        ContextComparison::WorldWesternmost,
        ContextComparison::WorldHighest,
        ContextComparison::WorldLowest,
        ContextComparison::AreaLargest,
        ContextComparison::AreaSmallest,
    ];
}

impl LabelledShape {
    /// A copy of a shape.
    pub(crate) fn of(body: &Body) -> Self {
        LabelledShape { scope: body.scope, bounds: body.bounds(), area: body.area() }
    }

    /// The distance from its scope to another scope, in metres. If it is not less than `least`, the result is not less either.
    pub(crate) fn distance_to(&self, scope: &Scope, least: f64) -> f64 {
        scope_distance::distance(&self.scope, scope, least)
    }

    /// The box around its scope, along the axes of the world.
    pub(super) fn around(&self) -> Bounds {
        Bounds::of(self.scope.corners())
    }

    /// The value by which shapes are ranked: larger is better.
    pub(super) fn value(&self, by: ContextComparison) -> f64 {
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

    /// Returns true if it is better than another shape.
    pub(crate) fn is_better(&self, other: &LabelledShape, by: ContextComparison) -> bool {
        is_better(self.value(by), other.value(by))
    }
}

/// Returns true if a value is better than another one by more than rounding: shapes with equal values have one rank. Of values in ascending
/// order, the better ones are the last ones.
pub(super) fn is_better(value: f64, other: f64) -> bool {
    TIE_EPSILON * value.abs().max(other.abs()).max(1.0) < value - other
}
