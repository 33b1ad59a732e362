//! A slot of the rules that repeats.

use super::key::Read;
use crate::run::context::Cx;
use crate::run::sink::Flow;
use crate::shape::ShapeRef;

/// The call of a rule on a part that repeats.
pub(super) type PartFn<'f, C> = &'f mut dyn FnMut(&mut Cx<'_, C>, &ShapeRef<'_>) -> Flow;

/// A slot of the rules that repeats.
#[derive(Clone, Copy)]
pub(super) struct RepeatedSlot<'a> {
    /// The number of the slot in the rules.
    pub(super) place: u32,
    /// The values that its rule reads.
    pub(super) reads: &'a [Read<'a>],
    /// True if the rule reads or makes more than rectangles and boxes.
    pub(super) is_whole: bool,
}
