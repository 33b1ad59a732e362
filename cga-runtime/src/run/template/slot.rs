//! A slot of the rules that repeats.

use super::read::Read;
use crate::run::context::Cx;
use crate::run::sink::Flow;
use crate::shape::ShapeRef;

/// The call of a rule on a part that repeats.
pub(super) type PartFn<'f, C> = &'f mut dyn FnMut(&mut Cx<'_, C>, &ShapeRef<'_>) -> Flow;

/// A slot of the rules that repeats.
#[derive(Clone, Copy, Debug)]
pub struct RepeatedSlot<'a> {
    /// The number of the slot in the rules.
    pub place: u32,
    /// True if its rule reads or makes more than rectangles and boxes.
    pub is_whole: bool,
    /// True if the rule reads the orientation of its shape in the world.
    pub reads_axes: bool,
    /// The values that the rule reads.
    pub reads: &'a [Read<'a>],
}
