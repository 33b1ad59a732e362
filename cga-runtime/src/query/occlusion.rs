//! Occlusion queries (*inside*, *overlaps* and *touches function*).
//!
//! They ask the ghosts of the run (`run/ghost`) for closed shapes: leaves, shapes before a `comp` or before an `offset` with a selector,
//! and labelled shapes. With a label, only shapes with that label count. Ancestors and descendants of the shape do not count, nor do
//! copies that its rule has made of it.

use crate::geometry::relation::Relation;
use crate::run::env::Env;
use crate::run::surroundings::QueryTarget;
use crate::shape::view::View;
use crate::value::text::Text;

/// `inside(target, label)`: true if the shape is completely inside one closed shape, or on its surface.
pub fn inside(env: &mut Env, shape: &impl View, target: QueryTarget, label: Text) -> bool {
    env.relation(shape, target, &label, Relation::INSIDE).inside
}

/// `overlaps(target, label)`: true if the shape is partly or completely inside one closed shape, or the other way round.
pub fn overlaps(env: &mut Env, shape: &impl View, target: QueryTarget, label: Text) -> bool {
    env.relation(shape, target, &label, Relation::OVERLAPS).overlaps
}

/// `touches(target, label)`: true if the shape overlaps one closed shape, or has contact with its surface along an area.
pub fn touches(env: &mut Env, shape: &impl View, target: QueryTarget, label: Text) -> bool {
    env.relation(shape, target, &label, Relation::TOUCHES).touches
}
