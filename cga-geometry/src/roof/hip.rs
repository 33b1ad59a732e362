//! Hip roofs: a plane rises at each edge.

use super::plan::Plan;
use super::{Outline, Rise, Roof};
use crate::skeleton::SkeletonError;

/// A hip roof with one face for each edge. An overhang continues the faces below the outline, and a
/// negative one takes them back.
pub(super) fn hip(outline: &Outline<'_>, rise: Rise, overhang: f64, even: bool) -> Result<Roof, SkeletonError> {
    let count = outline.edges().len();
    let mut plan = Plan::of(outline, &vec![1.0; count])?;
    if even {
        plan.level_ridges(outline);
    }
    let slope = rise.slope(plan.top());
    if 0.0 < overhang {
        let distance = overhang_in_plan(overhang, slope);
        let outside = plan.outside(outline, &vec![distance; count], distance)?;
        let fronts = outside.fronts(|_| true);
        let regions = outside.strips.into_iter().map(|strip| (strip.edge, strip.ring)).collect();
        plan.join(regions, &fronts);
        plan.drop_straight(&|_| true);
    } else {
        plan.take_back(outline, &vec![false; count], [overhang_in_plan(-overhang, slope), 0.0])?;
    }
    Ok(plan.roof(slope, &|_| false))
}

/// The distance outside the outline of an overhang measured on a plane.
pub(super) fn overhang_in_plan(overhang: f64, slope: f64) -> f64 {
    overhang / libm::sqrt(1.0 + slope * slope)
}
