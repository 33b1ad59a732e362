//! Queries of labelled shapes (*contextCount*, *contextCompare* and *minimumDistance function*).
//!
//! They ask the ghosts of the run (`run/ghost`). An empty label, a label that no shape has and shapes that are not known give the
//! default: 0, and an infinite distance. A query of other initial shapes outside of a scene leaves a fault. All labelled shapes count, also ancestors of the shape and copies of it.

use crate::run::env::Env;
use crate::run::ghost::LabelledShape;
use crate::shape::view::View;
use crate::value::text::Text;

pub use crate::run::ghost::ContextComparison;
pub use crate::run::surroundings::QueryTarget;

/// `minimumDistance(target, label)`: the distance from the scope of the shape to the nearest scope of a shape with that label, in metres.
pub fn minimum_distance(env: &mut Env, shape: &impl View, target: QueryTarget, label: Text) -> f64 {
    env.expect_scene(target);
    env.scene.around.least_distance(target, &label, &shape.body().scope)
}

/// `contextCount(target, label)`: the number of shapes with that label.
pub fn context_count(env: &mut Env, _: &impl View, target: QueryTarget, label: Text) -> f64 {
    env.expect_scene(target);
    env.scene.around.count(target, &label) as f64
}

/// `contextCompare(target, label, comparisonType)`: the rank of the shape among the shapes with that label, from 0: the number of them that
/// are better. Shapes that are equal up to rounding have one rank. The shape itself need not have the label.
pub fn context_compare(
    env: &mut Env,
    shape: &impl View,
    target: QueryTarget,
    label: Text,
    comparison: ContextComparison,
) -> f64 {
    env.expect_scene(target);
    let own = LabelledShape::of(&shape.body());
    env.scene.around.rank(target, &label, &own, comparison) as f64
}
