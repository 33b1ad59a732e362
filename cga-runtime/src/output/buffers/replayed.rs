//! The rules and materials of parts that repeat, as numbers of the buffers' table.

use super::submesh::SubmeshStart;
use crate::output::leaf_numbers::Numbers;
use crate::run::sink::Replay;
use crate::shape::look_id::LookId;

/// The number of parts whose marks are kept.
const KNOWN: usize = 32;

/// The marks of replayed parts, at an index that follows from the part's number.
#[derive(Clone, Debug, Default)]
pub(super) struct Replayed([Marks; KNOWN]);

/// The marks of a part that repeats.
#[derive(Clone, Debug, Default)]
pub(super) struct Marks {
    part: (u64, usize),
    /// True if no two consecutive marks are equal.
    pub(super) is_distinct: bool,
    /// The marks as starts of submeshes, relative to the first.
    pub(super) runs: Vec<SubmeshStart>,
}

impl Replayed {
    /// The marks of a part.
    #[inline]
    pub(super) fn of(&mut self, replay: &Replay<'_>, numbers: &mut Numbers) -> &Marks {
        let part = replay.number();
        let known = &mut self.0[(part.0 as usize ^ part.1) % KNOWN];
        if known.part != part {
            known.find(replay, numbers);
        }
        known
    }
}

impl Marks {
    #[cold]
    #[inline(never)]
    fn find(&mut self, replay: &Replay<'_>, numbers: &mut Numbers) {
        self.runs.clear();
        self.runs.extend(replay.marks().map(|(leaf, mark)| {
            let (rule, material) = numbers.with_look(&leaf, mark.look);
            SubmeshStart { rule, material, triangle: mark.before / 2, vertex: mark.before }
        }));
        self.is_distinct = self.runs.windows(2).all(|pair| !pair[0].is_like(&pair[1]));
        // The next base may have another material.
        let is_known = replay.mark_list().iter().all(|mark| mark.look != LookId::OF_BASE);
        self.part = if is_known { replay.number() } else { (0, 0) };
    }
}
