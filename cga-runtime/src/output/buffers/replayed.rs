//! The rules and materials of parts that repeat, as numbers of the buffers' table.

use super::submesh::SubmeshStart;
use crate::output::leaf_numbers::Numbers;
use crate::run::sink::Replay;

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
        self.part = replay.number();
    }
}
