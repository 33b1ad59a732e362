//! Colours of repetitions.
//!
//! Rules of a template of rectangles and boxes never read the colour of their shape. So the colour is *open* while such a template is
//! recorded, and each repetition paints it: walls of random colours share a template.

use std::sync::atomic::{AtomicU64, Ordering};

use crate::shape::look_id::LookId;
use crate::shape::look_table::LookTable;

/// The number of the next paint. Numbers distinguish what all sessions replay, and are in no output.
static NUMBER: AtomicU64 = AtomicU64::new(1);

/// The looks of a template for parts with one look.
#[derive(Debug)]
pub(super) struct Paint {
    /// The number of the painted template in the process.
    pub(super) number: u64,
    /// The look of the shape that was recorded, and of the part.
    part: (LookId, LookId),
    /// Other looks with an open colour, each with the look that it becomes.
    others: Vec<(LookId, LookId)>,
    /// False if some looks have temporary numbers.
    pub(super) is_lasting: bool,
}

impl Paint {
    /// The paint of a template for a part with the look `own`. `open` are the looks of the template with an open colour, `recorded` is the
    /// look of the recorded shape.
    pub(super) fn new(open: &[LookId], recorded: LookId, own: LookId, ids: &mut LookTable) -> Self {
        let others = open.iter().filter(|look| **look != recorded);
        let others: Vec<(LookId, LookId)> = others.map(|look| (*look, ids.painted(*look, own))).collect();
        let is_lasting = own.is_lasting() && others.iter().all(|(_, painted)| painted.is_lasting());
        Paint { number: NUMBER.fetch_add(1, Ordering::Relaxed), part: (recorded, own), others, is_lasting }
    }

    /// The look of a repetition in place of a recorded one.
    #[inline]
    pub(super) fn of(&self, recorded: LookId) -> LookId {
        if recorded == self.part.0 {
            return self.part.1;
        }
        let painted = self.others.iter().find(|(open, _)| *open == recorded);
        painted.map_or(recorded, |(_, painted)| *painted)
    }
}
