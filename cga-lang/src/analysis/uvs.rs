//! Which texture coordinates a shape may have.

use crate::ops::{Operation, UvEffect};

/// The uv sets of the language (*texturing*).
const ALL: u16 = (1 << 10) - 1;

/// What is known of the uv sets of a shape.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct UvSets {
    /// A bit for each that it may have.
    may: u16,
    /// A bit for each with a projection that is set up and not made yet.
    awaits: u16,
}

impl UvSets {
    /// Nothing is known.
    pub(super) const ANY: UvSets = UvSets { may: ALL, awaits: 0 };

    /// What holds for both.
    pub(super) fn or(self, other: UvSets) -> UvSets {
        UvSets { may: self.may | other.may, awaits: self.awaits & other.awaits }
    }

    /// Whether there certainly is no such set.
    pub(crate) fn lacks(self, set: u32) -> bool {
        set < 10 && self.may & 1 << set == 0
    }

    /// Whether its projection is certainly set up and not made.
    pub(crate) fn awaits(self, set: u32) -> bool {
        set < 10 && self.awaits & 1 << set != 0
    }

    /// A bit for each set that an operation may make on a shape that has none.
    pub(crate) fn made_by(row: &Operation) -> u16 {
        UvSets { may: 0, awaits: 0 }.after(row, [None; 2]).may
    }

    /// After an operation; `sets` are its first two arguments where these are numbers of sets that are known.
    pub(super) fn after(self, row: &Operation, sets: [Option<u32>; 2]) -> UvSets {
        let [bit, second] = sets.map(|set| set.filter(|set| *set < 10).map(|set| 1u16 << set));
        let UvSets { may, awaits } = self;
        match (row.uvs, bit) {
            (UvEffect::SetsUp, bit) => UvSets { may, awaits: awaits | bit.unwrap_or(0) },
            (UvEffect::Projects, Some(bit)) => UvSets { may: may | bit, awaits: awaits & !bit },
            (UvEffect::Projects, None) => UvSets::ANY,
            // A set that is missing makes the other one missing (*copyUV operation*).
            (UvEffect::Copies, Some(from)) if may & from == 0 => UvSets { may: may & !second.unwrap_or(0), awaits },
            (UvEffect::Copies, _) if may != 0 => match second {
                Some(to) => UvSets { may: may | to, awaits: awaits & !to },
                None => UvSets { may: ALL, awaits: 0 },
            },
            (UvEffect::Deletes, Some(bit)) => UvSets { may: may & !bit, awaits },
            (UvEffect::First, _) => UvSets { may: 1, awaits: awaits & !1 },
            (UvEffect::Keeps | UvEffect::Changes | UvEffect::Copies | UvEffect::Deletes, _) => self,
            (UvEffect::Any | UvEffect::Follows, _) => UvSets { may: ALL, awaits: 0 },
        }
    }
}
