//! The abstract texture coordinates of a shape.

use crate::ops::{Operation, UvEffect};

/// The uv sets of the language (*texturing*).
const ALL: u16 = (1 << 10) - 1;

/// The abstract uv sets of a shape.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct UvSets {
    /// A bit for each set that it may have.
    may: u16,
    /// A bit for each set whose projection is defined and not applied yet.
    awaits: u16,
}

impl UvSets {
    /// Unknown uv sets.
    pub(super) const ANY: UvSets = UvSets { may: ALL, awaits: 0 };

    /// The join of two states.
    pub(super) fn or(self, other: UvSets) -> UvSets {
        UvSets { may: self.may | other.may, awaits: self.awaits & other.awaits }
    }

    /// Returns true if the shape never has the set.
    pub(crate) fn lacks(self, set: u32) -> bool {
        set < 10 && self.may & 1 << set == 0
    }

    /// Returns true if the projection of the set is always defined and not applied.
    pub(crate) fn awaits(self, set: u32) -> bool {
        set < 10 && self.awaits & 1 << set != 0
    }

    /// A bit for each set that an operation may make on a shape that has none.
    pub(crate) fn made_by(row: &Operation) -> u16 {
        UvSets { may: 0, awaits: 0 }.after(row, [None; 2]).may
    }

    /// The state after an operation; `sets` are its first two arguments, if they are known numbers of sets.
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
            (UvEffect::Keeps | UvEffect::Drops, _) => self,
            (UvEffect::Changes | UvEffect::Copies | UvEffect::Deletes, _) => self,
            (UvEffect::Any | UvEffect::Follows, _) => UvSets { may: ALL, awaits: 0 },
        }
    }
}
