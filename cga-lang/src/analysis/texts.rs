//! The abstract domain of texts: subsets of the texts that the program compares with.

use crate::syntax::token::{Sym, Tok};
use std::collections::HashMap;

/// The last bit represents all texts that the program never compares with.
const OTHER: u128 = 1 << 127;

/// The largest set that messages list.
const MOST_TOLD: usize = 4;

/// A set of the texts that the program compares with, and possibly others.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct TextSet(u128);

impl TextSet {
    /// Any text.
    pub(super) const ANY: TextSet = TextSet(u128::MAX);

    pub(super) fn or(self, other: TextSet) -> TextSet {
        TextSet(self.0 | other.0)
    }

    /// The intersection; `None` if it is empty.
    pub(super) fn and(self, other: TextSet) -> Option<TextSet> {
        (self.0 & other.0 != 0).then_some(TextSet(self.0 & other.0))
    }

    /// The set without the other's text, if the other has exactly one.
    pub(super) fn without(self, other: TextSet) -> Option<TextSet> {
        if !other.is_one() {
            return Some(self);
        }
        let left = self.0 & !other.0;
        (left != 0).then_some(TextSet(left))
    }

    /// Returns true if the set is one known text.
    fn is_one(self) -> bool {
        self.0.count_ones() == 1 && self.0 != OTHER
    }

    /// The result of `==`, if it is certain.
    pub(super) fn same(self, other: TextSet) -> Option<bool> {
        match () {
            () if self.0 & other.0 == 0 => Some(false),
            () if self.is_one() && self == other => Some(true),
            () => None,
        }
    }
}

/// The texts that the program compares with, each with a bit while bits last.
#[derive(Default)]
pub(super) struct Texts {
    bits: HashMap<String, u32>,
}

impl Texts {
    pub(super) fn new(tokens: &[Tok]) -> Texts {
        let mut texts = Texts::default();
        for pair in tokens.windows(2) {
            if let [Tok::Str(text), Tok::Sym(Sym::EqEq | Sym::NotEq)]
            | [Tok::Sym(Sym::EqEq | Sym::NotEq), Tok::Str(text)] = pair
                && !texts.bits.contains_key(text)
            {
                let bit = texts.bits.len() as u32;
                texts.bits.insert(text.clone(), bit);
            }
        }
        texts
    }

    /// The set of one text.
    pub(super) fn set(&self, text: &str) -> TextSet {
        TextSet(match self.bits.get(text) {
            Some(bit) if *bit < 127 => 1 << bit,
            _ => OTHER,
        })
    }
}

impl Texts {
    /// A set for messages: a few texts, or all except a few.
    pub(super) fn told(&self, set: TextSet) -> Option<String> {
        let is_listed = set.0 & OTHER == 0;
        let bits = if is_listed { set.0 } else { !set.0 };
        let mut list: Vec<(u32, String)> = Vec::new();
        for (text, &bit) in &self.bits {
            if bit < 127 && bits & 1 << bit != 0 {
                list.push((bit, format!("\"{text}\"")));
            }
        }
        list.sort_unstable();
        let list: Vec<String> = list.into_iter().map(|(_, text)| text).collect();
        match (list.len(), is_listed) {
            (1..=MOST_TOLD, true) => Some(list.join(" or ")),
            (1..=MOST_TOLD, false) => Some(format!("not {}", list.join(" and not "))),
            _ => None,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn texts(count: usize) -> Texts {
        let tokens = (0..count).flat_map(|number| [Tok::Sym(Sym::EqEq), Tok::Str(number.to_string())]);
        Texts::new(&tokens.collect::<Vec<_>>())
    }

    #[test]
    fn texts_that_are_compared_are_told_apart_from_all_others() {
        let texts = texts(3);
        let [zero, one, nine, ten] = ["0", "1", "9", "10"].map(|text| texts.set(text));
        assert_eq!((zero.same(zero), zero.same(one), zero.same(nine)), (Some(true), Some(false), Some(false)));
        assert_eq!((nine.same(ten), nine.same(nine), TextSet::ANY.same(zero)), (None, None, None));
        assert_eq!(zero.or(one).without(one), Some(zero));
        assert_eq!((zero.without(zero), zero.and(one)), (None, None));
        assert_eq!(nine.without(ten), Some(nine));
    }

    #[test]
    fn sets_are_told_by_what_is_in_them_or_by_what_is_not() {
        let texts = texts(9);
        let [one, two] = ["1", "2"].map(|text| texts.set(text));
        assert_eq!(texts.told(two.or(one)).as_deref(), Some("\"1\" or \"2\""));
        assert_eq!(texts.told(TextSet::ANY.without(two).unwrap()).as_deref(), Some("not \"2\""));
        assert_eq!((texts.told(TextSet::ANY), texts.told(texts.set("none"))), (None, None));
    }

    #[test]
    fn beyond_the_last_bit_nothing_is_known() {
        let texts = texts(200);
        assert_eq!(texts.set("3").same(texts.set("126")), Some(false));
        assert_eq!(texts.set("127").same(texts.set("199")), None);
        assert_eq!(texts.set("3").same(texts.set("199")), Some(false));
    }
}
