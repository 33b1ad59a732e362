//! A slot of the rules that repeats.

use crate::value::read::Read;

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
