//! The lots whose grammars a session keeps.

use crate::shape::lot::Lot;

/// The number of lots that a session keeps.
const MOST: usize = 16;

/// The last lots with data of their own, each with the index of its grammar. The last one is first.
#[derive(Debug, Default)]
pub(super) struct KeptLots(Vec<(Lot, usize)>);

impl KeptLots {
    /// The index of the grammar of a lot with the same data.
    pub(super) fn find(&mut self, lot: &Lot) -> Option<usize> {
        let at = self.0.iter().position(|(known, _)| known.is_same(lot))?;
        self.0[..=at].rotate_right(1);
        Some(self.0[0].1)
    }

    /// Adds a lot. Returns the index of its grammar, which is the next one, or the index of the lot that was used least recently.
    pub(super) fn add(&mut self, lot: &Lot) -> usize {
        let oldest = if self.0.len() < MOST { None } else { self.0.pop() };
        let index = oldest.map_or(self.0.len(), |(_, index)| index);
        self.0.insert(0, (lot.clone(), index));
        index
    }
}

#[cfg(test)]
mod tests {
    use super::{KeptLots, MOST};
    use crate::shape::lot::Lot;
    use crate::value::text::Text;

    #[test]
    fn the_lot_that_was_used_least_recently_is_replaced() {
        let lot = |name: &str| Lot { start: Some(Text::from(name)), ..Lot::default() };
        let mut kept = KeptLots::default();
        for number in 0..MOST {
            assert_eq!(kept.find(&lot(&number.to_string())), None);
            assert_eq!(kept.add(&lot(&number.to_string())), number);
        }
        assert_eq!(kept.find(&lot("0")), Some(0));
        assert_eq!(kept.add(&lot("new")), 1, "0 was used after 1");
        assert_eq!((kept.find(&lot("1")), kept.find(&lot("0")), kept.find(&lot("new"))), (None, Some(0), Some(1)));
    }
}
